#ifndef QUADRILLE_INTERNAL_VERIFY_TOLERANCE_CHECK_H
#define QUADRILLE_INTERNAL_VERIFY_TOLERANCE_CHECK_H

#include <quadrille/internal/distance/distance_surface.h>
#include <quadrille/internal/verify/allowed_faces.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/greatest_excess.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

/// How far an input and its result are apart beyond tolerances of the input's vertices, of which a
/// face has the least of its corners.
class ToleranceCheck {
public:
  /// Throws std::invalid_argument where a surface has no face, or where tolerances are not as many
  /// as the input has vertices, or no distances.
  ToleranceCheck(const CheckedSurface& input, const std::vector<double>& tolerances,
                 const CheckedSurface& result)
      : frame_(box_of(input, result)), diagonal_(diagonal(box_of(input, result))) {
    require_tolerances(input, tolerances);
    for (const auto& [a, b, c] : input.faces) {
      const double tolerance = (std::min)({tolerances[a], tolerances[b], tolerances[c]});
      input_.push_back({triangle(input, {a, b, c}), frame_.to(tolerance)});
      least_ = (std::min)(least_, tolerance);
    }
    for (const Corners& corners : result.faces)
      result_.push_back({triangle(result, corners), 0});
  }

  double diagonal_of_both() const { return diagonal_; }
  double least_tolerance() const { return least_; }

  /// How far a point of an input face is from the result beyond the face's tolerance, at most. It
  /// tells less than the truth by no more than `error`, and never more; 0 if none is beyond.
  double of_input(double error) const { return excess(input_, result_, error); }

  /// By how much a point of the result is beyond the tolerance of each face of the input. The same.
  double of_result(double error) const { return excess(result_, input_, error); }

private:
  using Faces = std::vector<AllowedFaces::Face>;

  static CGAL::Bbox_3 box_of(const CheckedSurface& a, const CheckedSurface& b) {
    if (a.faces.empty() || b.faces.empty())
      throw std::invalid_argument("quadrille::verify: a surface without faces is at no distance");
    return a.box() + b.box();
  }
  static void require_tolerances(const CheckedSurface& input,
                                 const std::vector<double>& tolerances) {
    if (tolerances.size() != input.points.size())
      throw std::invalid_argument(
          "quadrille::verify: there are not as many tolerances as vertices of the input");
    if (std::any_of(tolerances.begin(), tolerances.end(), [](double t) { return !(t >= 0); }))
      throw std::invalid_argument("quadrille::verify: a tolerance is not a distance");
  }

  DistanceTriangle triangle(const CheckedSurface& surface, const Corners& corners) const {
    const auto point = [&](std::size_t v) {
      const auto& p = surface.points[v];
      return frame_.to(DistancePoint(p.x(), p.y(), p.z()));
    };
    return {point(corners[0]), point(corners[1]), point(corners[2])};
  }

  /// Only one of both allows more than 0: that of the input.
  double excess(const Faces& from, const Faces& to, double error) const {
    const AllowedFaces near(to);
    GreatestExcess greatest(near, (std::max)(frame_.to(error), 0x1p-40));
    for (const AllowedFaces::Face& face : from)
      greatest.look_at(face.triangle, face.allowance);
    return frame_.from(greatest.greatest());
  }

  DistanceFrame frame_;
  double diagonal_, least_ = std::numeric_limits<double>::infinity();
  Faces input_, result_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_TOLERANCE_CHECK_H
