// Holds what guarantees.md promises on models of the caller's: each in doubles, in floats, and far
// from the origin. Prints a line for each promise, and fails if one is broken. Distances are
// measured by CGAL's tree at corners and points between; the rest by <quadrille/verify.h>, of
// tolerances by how much a point is beyond them.
//   promises MODEL.off...
#include "farthest.h"
#include "models.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/verify.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

template <class Number>
using PointOf = typename CGAL::Simple_cartesian<Number>::Point_3;

constexpr std::size_t most_faces = 60'000;

// The points of a surface in one type of numbers.
template <class Number>
std::vector<PointOf<Number>> points_of(const Soup& soup) {
  std::vector<PointOf<Number>> points;
  for (const Position& p : soup.points)
    points.emplace_back(static_cast<Number>(p[0]), static_cast<Number>(p[1]),
                        static_cast<Number>(p[2]));
  return points;
}
template <class Number>
Soup soup_of(const std::vector<PointOf<Number>>& points, std::vector<test::Triangle> triangles) {
  Soup soup;
  for (const auto& p : points)
    soup.points.push_back({{double(p.x()), double(p.y()), double(p.z())}});
  soup.triangles = std::move(triangles);
  return soup;
}

// One model in one type of numbers.
template <class Number>
class Promises {
public:
  Promises(const std::string& name, const Soup& soup)
      : name_(name), input_(soup_of<Number>(::points_of<Number>(soup), soup.triangles)),
        diagonal_(test::diagonal(input_)),
        rounding_(8 * double(std::numeric_limits<Number>::epsilon()) *
                  test::greatest_coordinate(input_)) {}

  // To a part of the diagonal, and to a part of the faces.
  bool check(double part, double ratio) {
    part_ = part;
    const double limit = part * diagonal_;
    both_ways("both ways", limit, HausdorffLimit{limit});
    both_ways("both ways, passes", limit, HausdorffLimit{limit}, RelaxedOrder{});
    both_ways("both ways, free", limit, HausdorffLimit{limit}, Topology::free);
    tolerances("tolerances", ToleranceLimit{});
    tolerances("tolerances, passes", ToleranceLimit{}, RelaxedOrder{});
    claims("no self-intersection", {.no_self_intersection = true}, NoSelfIntersection{},
           FaceRatio{ratio});
    claims("solid", {.no_self_intersection = true, .solid = true}, KeepSolid{}, FaceRatio{ratio});
    return are_all_met_;
  }

private:
  struct Outcome {
    Report report;
    Soup result;
  };

  template <class... Arguments>
  Outcome simplified(const Arguments&... arguments) const {
    std::vector<PointOf<Number>> points = ::points_of<Number>(input_);
    std::vector<test::Triangle> triangles = input_.triangles;
    const Report report =
        simplify<MemorylessQuadric, OptimalPlacement>(points, triangles, arguments...);
    return {report, soup_of<Number>(points, std::move(triangles))};
  }

  template <class... Arguments>
  void both_ways(const char* promise, double limit, const Arguments&... arguments) {
    const Outcome outcome = simplified(arguments...);
    const double measured = std::max(test::farthest(outcome.result, input_, 3),
                                     test::farthest(input_, outcome.result, 3));
    tell(promise, outcome, measured, limit, measured <= limit + rounding_);
  }

  // A tolerance that grows a hundredfold along the longest axis.
  template <class... Arguments>
  void tolerances(const char* promise, const Arguments&... arguments) {
    const std::vector<double> tolerances =
        test::growing_tolerances(input_, 0.1 * part_ * diagonal_);
    const Outcome outcome = simplified(
        arguments..., parameters::vertex_tolerance_map(CGAL::make_property_map(tolerances)));
    const Verdict verdict =
        verify(::points_of<double>(input_), input_.triangles, ::points_of<double>(outcome.result),
               outcome.result.triangles, {.tolerances = tolerances});
    const double beyond = std::max(verdict.findings[0].measured, verdict.findings[1].measured);
    tell(promise, outcome, beyond, 0, verdict.is_met());
  }

  template <class... Arguments>
  void claims(const char* promise, const Claims& claims, const Arguments&... arguments) {
    std::vector<PointOf<Number>> points = ::points_of<Number>(input_);
    std::vector<test::Triangle> triangles = input_.triangles;
    Report report;
    try {
      report = simplify<MemorylessQuadric, OptimalPlacement>(points, triangles, arguments...);
    } catch (const std::invalid_argument& refused) {
      std::printf("%s: %s: refused: %s\n", name_.c_str(), promise, refused.what());
      return;
    }
    const Verdict verdict =
        verify(::points_of<Number>(input_), input_.triangles, points, triangles, claims);
    tell(promise, {report, {}}, verdict.findings.empty() ? 0 : verdict.findings.back().measured, 0,
         verdict.is_met());
  }

  void tell(const char* promise, const Outcome& outcome, double measured, double promised,
            bool holds) {
    std::printf("%s: %s: %zu -> %zu faces, promised %g, measured %g%s\n", name_.c_str(), promise,
                outcome.report.faces_before, outcome.report.faces_after, promised, measured,
                holds ? "" : ": BROKEN");
    std::fflush(stdout);
    are_all_met_ &= holds;
  }

  std::string name_;
  Soup input_;
  double diagonal_, rounding_;
  double part_ = 0;
  bool are_all_met_ = true;
};

bool check(const std::string& name, const Soup& soup) {
  const double far = 1e5 * test::diagonal(soup);
  const Soup moved = test::mapped(soup, [&](const Position& p) {
    return p + Position{{far, -far, far}};
  });
  bool holds = true;
  for (const auto& [part, ratio] : {std::array{0.001, 0.2}, {0.003, 0.05}, {0.01, 0.01}}) {
    holds &= Promises<double>(name, soup).check(part, ratio);
    holds &= Promises<float>(name + " in floats", soup).check(part, ratio);
    holds &= Promises<double>(name + " far away", moved).check(part, ratio);
  }
  return holds;
}

} // namespace

int main(int argc, char** argv) {
  return test::check_models({argv + 1, argv + argc}, most_faces, check);
}
