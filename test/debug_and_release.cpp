// Simplifies a model in several ways and prints all digits of the results, which
// every_build.sh compares.
//   debug_and_release MODEL.off
// COST is the name of the cost: one for each unit, so that they are compiled at the same time.
#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <quadrille/channels.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <type_traits>
#include <vector>

using namespace quadrille;
using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

void print(const std::vector<Point>& points) {
  for (const Point& p : points)
    std::printf("%a %a %a\n", p.x(), p.y(), p.z());
}

template <class Cost, class... Policies>
void run(Soup soup, const Policies&... policies) {
  std::vector<Point> colors = soup.points;
  const auto simplified = [&](const auto&... named) {
    return simplify<Cost, OptimalPlacement>(soup.points, soup.triangles, FaceRatio{0.2},
                                            policies..., named...);
  };
  Report report;
  if constexpr (Cost::dimension > 3)
    report = simplified(CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)));
  else
    report = simplified();
  colors.resize(soup.points.size());
  print(soup.points);
  print(colors);
  for (const auto& [a, b, c] : soup.triangles)
    std::printf("%zu %zu %zu\n", a, b, c);
  std::printf("%zu contractions, error %a\n", report.contractions, report.error);
}

template <class Cost>
void run_in_both_orders(const Soup& soup) {
  run<Cost>(soup, Topology::kept);
  run<Cost>(soup, Topology::kept, RelaxedOrder{});
  run<Cost>(soup, Topology::free, RelaxedOrder{.refresh = true});
}

int main(int argc, char* argv[]) {
  Soup soup;
  if (argc != 2 || !CGAL::IO::read_OFF(argv[1], soup.points, soup.triangles)) {
    std::fprintf(stderr, "usage: debug_and_release MODEL.off\n");
    return 2;
  }
  run_in_both_orders<COST>(soup);
  if constexpr (std::is_same_v<COST, Quadric>)
    run<Quadric>(soup, ThresholdPairs::relative(0.02));
}
