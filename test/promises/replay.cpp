// Carries 100,000 points of each model along by the record of a simplification, and holds them
// against what was promised: each ends on the result, no further from where it began than the limit
// (or its tolerance), and no face that it lies on has a normal further than the angle. Prints a
// line for each run, and fails if a promise is broken.
//   replay MODEL.off...
#include "farthest.h"
#include "models.h"
#include "point_replay.h"

#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/verify.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::CarriedPoint;
using test::Position;
using test::Soup;

constexpr std::size_t most_faces = 150'000;
constexpr std::size_t point_count = 100'000;

class ReplayedModel {
public:
  ReplayedModel(const std::string& name, const Soup& soup) : name_(name), input_(soup) {}

  bool check() {
    const double diagonal = test::diagonal(input_), limit = 0.003 * diagonal;
    within("both ways", limit, HausdorffLimit{limit});
    within("both ways, passes", limit, HausdorffLimit{limit}, RelaxedOrder{});
    within("both ways, free", limit, HausdorffLimit{limit}, Topology::free);
    const std::vector<double> tolerances = test::growing_tolerances(input_, 0.0003 * diagonal);
    const auto map = parameters::vertex_tolerance_map(CGAL::make_property_map(tolerances));
    tolerances_ = &tolerances;
    within("tolerances", 1, ToleranceLimit{}, map);
    within("tolerances, passes", 1, ToleranceLimit{}, RelaxedOrder{}, map);
    tolerances_ = nullptr;
    normals("normals", 45, FaceRatio{0.1}, NormalDeviation{45});
    normals("normals, passes", 45, FaceRatio{0.1}, NormalDeviation{45}, RelaxedOrder{});
    normals("normals, free", 45, FaceRatio{0.1}, NormalDeviation{45}, Topology::free);
    return are_all_met_;
  }

private:
  template <class... Arguments>
  Soup record(test::Log& log, const Arguments&... arguments) const {
    test::PointSoup soup(input_);
    simplify<MemorylessQuadric, OptimalPlacement>(soup.points, soup.triangles, record_into(log),
                                                  arguments...);
    return test::to_soup(soup);
  }

  // In parts of the tolerance, if there is one.
  template <class... Arguments>
  void within(const char* promise, double limit, const Arguments&... arguments) {
    test::Log log;
    const Soup result = record(log, arguments...);
    test::PointReplay replay(log, point_count, 1);
    replay.run();
    const test::Nearest of_result(result);
    double farthest = 0, off = 0;
    for (const CarriedPoint& p : replay.points()) {
      const double moved = std::sqrt(squared_distance(p.begin, p.now));
      farthest = std::max(farthest, moved / (tolerances_ ? tolerance(p.begin_face) : 1));
      off = std::max(off, of_result.distance(p.now));
    }
    tell(promise, result, replay.points().size(), farthest, limit,
         farthest <= limit * (1 + 1e-12) + (tolerances_ ? 0 : 4 * rounding()) && off <= rounding());
  }
  double tolerance(std::uint32_t face) const {
    const auto& [a, b, c] = input_.triangles[face];
    return std::min({(*tolerances_)[a], (*tolerances_)[b], (*tolerances_)[c]}) + 4 * rounding();
  }
  double rounding() const { return 1e-12 * test::greatest_coordinate(input_); }

  // Of the faces that points lie on by the map of the vertices, in which faces at a pair become an
  // edge: which is that of all faces.
  template <class... Arguments>
  void normals(const char* promise, double degrees, const Arguments&... arguments) {
    test::Log log;
    const Soup result = record(log, arguments...);
    test::PointReplay replay(log, 0, 1);
    replay.run();
    const Soup replayed = replay.surface();
    const Verdict verdict =
        verify(test::points_of(input_), input_.triangles, test::points_of(replayed),
               replayed.triangles, {.normal_deviation = degrees, .vertex_map = replay.images()});
    const double off = test::farthest(replayed, result, 1); // of roundings of the measure
    if (off > rounding())
      std::printf("%s: the surface of the record is off by %g\n", name_.c_str(), off);
    tell(promise, result, input_.triangles.size(), verdict.findings[0].measured, degrees,
         verdict.is_met() && off <= rounding());
  }

  void tell(const char* promise, const Soup& result, std::size_t points, double measured,
            double promised, bool holds) {
    std::printf("%s: %s: %zu -> %zu faces, %zu carried, promised %g, measured %g%s\n",
                name_.c_str(), promise, input_.triangles.size(), result.triangles.size(), points,
                promised, measured, holds ? "" : ": BROKEN");
    std::fflush(stdout);
    are_all_met_ &= holds;
  }

  std::string name_;
  const Soup& input_;
  const std::vector<double>* tolerances_ = nullptr;
  bool are_all_met_ = true;
};

} // namespace

int main(int argc, char** argv) {
  return test::check_models(
      {argv + 1, argv + argc}, most_faces,
      [](const std::string& name, const Soup& soup) { return ReplayedModel(name, soup).check(); });
}
