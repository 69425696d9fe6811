// Prints all digits of what two_quadrics.h computes, and of simplifications for which it does;
// every_build.sh compares them with and without vectors of the compiler's.
#include "support/soups.h"

#include <quadrille/internal/core/evaluation/two_quadrics.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

using namespace quadrille;

void print(internal::Lanes lanes) {
  for (std::size_t i = 0; i < 2; ++i)
    if (std::isnan(lanes[i]))
      std::puts("no number"); // of either sign
    else
      std::printf("%a\n", lanes[i]);
}

Vector<3> random_vector(test::Random& random) {
  const double x = random(-1, 1), y = random(-1, 1);
  return {{x, y, random(-1, 1)}};
}

/// One to three planes that miss the origin, so that some sums of forms are singular.
QuadricForm<3> random_form(test::Random& random) {
  QuadricForm<3> form;
  const std::uint32_t planes = 1 + random.below(3);
  for (std::uint32_t i = 0; i < planes; ++i) {
    const Vector<3> p = random_vector(random), q = random_vector(random);
    form += Quadric{}.face(p, q, random_vector(random));
    form.move_origin(random_vector(random));
  }
  return form;
}

void compute_at_random() {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::array<QuadricForm<3>, 4> forms;
    for (QuadricForm<3>& form : forms)
      form = random_form(random);
    std::array<Vector<3>, 2> ways;
    for (Vector<3>& way : ways)
      way = random_vector(random);
    const internal::Lanes reach{2, 4};
    print(internal::least_values({&forms[0], &forms[1]}, {&forms[2], &forms[3]}, ways, reach,
                                 internal::NothingAdded{}));

    const auto current = [](const QuadricForm<3>& form) {
      return MemorylessQuadric::Current{form.matrix(), form.gradient()};
    };
    const MemorylessQuadric::Current shared = current(forms[3]);
    std::array<MemorylessQuadric::Current, 3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      ends[k] = current(forms[k]);
      ends[k] += shared;
    }
    const auto [values, positions] = internal::minima(
        ends[0], {&ends[1], &ends[2]}, {shared, shared}, ways, reach, internal::NothingAdded{});
    print(values);
    print(positions[0]);
    print(internal::growth(forms[0], {&forms[1], &forms[2]}, ways, positions));
  }
}

template <class Cost>
void simplify_sphere() {
  test::Soup soup = test::with_noise(test::sphere(4), 1, 0.03);
  const Report report =
      simplify<Cost, OptimalPlacement>(soup.points, soup.triangles, FaceRatio{0.2});
  for (const Vector<3>& p : soup.points)
    std::printf("%a %a %a\n", p[0], p[1], p[2]);
  for (const auto& [a, b, c] : soup.triangles)
    std::printf("%u %u %u\n", a, b, c);
  std::printf("%zu contractions, error %a\n", report.contractions, report.error);
}

int main() {
  compute_at_random();
  simplify_sphere<Quadric>();
  simplify_sphere<MemorylessQuadric>();
}
