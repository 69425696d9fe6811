// Time against size at hubs, vertices of very many faces, as a table for high_valence.gp:
//   quadrille_high_valence_benchmark LARGEST > high_valence.csv
// Sizes are LARGEST faces and its halves; each time is the least of three.
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace quadrille;

struct Soup {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  void add_point(double turn, double radius, double z) {
    const double angle = 2 * std::numbers::pi * turn;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
};

// Of about n faces: a fan over a rim of teeth; two of them; faces on one edge; faces at one point.
Soup shape(const std::string& name, std::uint32_t n) {
  Soup soup;
  const bool is_crown = name == "crown", is_fins = name == "fins";
  soup.add_point(0, 0, name == "fan" ? 0 : 1);
  if (is_crown || is_fins)
    soup.add_point(0, 0, is_fins ? 0 : -1);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const std::uint32_t m = is_crown ? n / 2 : n;
  for (std::uint32_t i = 0; i < m; ++i) {
    const std::uint32_t next = first + (i + 1) % m;
    if (name == "petals") {
      soup.add_point(double(i) / m, 1, 0.1 * std::sin(i));
      soup.add_point((i + 0.4) / m, 1, 0);
      soup.triangles.push_back({0, first + 2 * i, first + 2 * i + 1});
    } else if (is_fins) {
      soup.add_point(double(i) / m, 1 + 0.1 * std::sin(i), 0.5);
      soup.triangles.push_back({0, 1, first + i});
    } else {
      soup.add_point(double(i) / m, i % 2 == 0 ? 0.6 : 1, is_crown ? 0.3 * (i % 2) : 0);
      soup.triangles.push_back({0, first + i, next});
      if (is_crown)
        soup.triangles.push_back({1, next, first + i});
    }
  }
  return soup;
}

template <class Cost, class... Arguments>
double least_seconds(const Soup& input, const Arguments&... arguments) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    Soup soup = input;
    const auto begin = std::chrono::steady_clock::now();
    simplify<Cost, OptimalPlacement>(soup.points, soup.triangles, arguments...);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    least = std::min(least, time.count());
  }
  return least;
}

} // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "Usage: quadrille_high_valence_benchmark LARGEST\n";
    return 2;
  }
  const auto largest = static_cast<std::uint32_t>(std::atol(arguments[1]));
  std::cout << "shape,call,faces,seconds\n";
  for (const std::string name : {"fan", "crown", "fins", "petals"})
    for (std::uint32_t faces = largest / 32; faces <= largest; faces *= 2) {
      const Soup soup = shape(name, faces);
      const auto tell = [&](const std::string& call, double seconds) {
        std::cout << name << ',' << call << ',' << faces << ',' << seconds << std::endl;
      };
      tell("to 10 %", least_seconds<Quadric>(soup, FaceRatio{0.1}));
      tell("within 0.01", least_seconds<Quadric>(soup, DistanceLimit{0.01}));
      tell("memoryless to 10 %", least_seconds<MemorylessQuadric>(soup, FaceRatio{0.1}));
      tell("relaxed to 10 %", least_seconds<Quadric>(soup, FaceRatio{0.1}, RelaxedOrder{}));
    }
}
