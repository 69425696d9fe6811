#ifndef QUADRILLE_FILTERS_H
#define QUADRILLE_FILTERS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/safe_length.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace quadrille {

/// Decides whether a face may fold over its neighbours, like the middle of a letter Z.
enum class FoldOvers { rejected, allowed };

/// Rejects a contraction that turns the normal of a face by `degrees` or more (the test of the 1997
/// paper, section 6). Several contractions that each turn a face by less can still fold it over its
/// neighbours. Unless fold-overs are allowed, a contraction that would do this is rejected too; the
/// test applies to faces that turn by more than 20 degrees.
///
/// A *sliver* has a height below a ten thousandth of its length, so that rounding decides its
/// normal. A contraction that turns another face into a sliver is rejected as well; otherwise flat
/// and straight regions would end in faces of three collinear points. A face of a wall that is
/// narrow itself, such as the edge of a foil, may become a sliver if it keeps a quarter of its
/// area, and a hundredth of the relative height of the lowest face around it.
///
/// On by default, with 90 degrees. A face of three collinear points, up to rounding, has no normal
/// and may get any normal; 180 degrees allows everything.
class NormalFlip {
public:
  /// scale-invariant
  using ScaleFree = NormalFlip;
  static constexpr Rejection cause = Rejection::normal_flip; ///< counts its rejections

  /// degrees lies in (0, 180]; throws std::invalid_argument otherwise.
  explicit NormalFlip(double degrees = 90, FoldOvers folds = FoldOvers::rejected)
      : cosine_(degrees == 90 ? 0 : std::cos(degrees * std::numbers::pi / 180)),
        allows_everything_(degrees == 180), allows_fold_overs_(folds == FoldOvers::allowed) {
    if (!(degrees > 0 && degrees <= 180))
      throw std::invalid_argument("quadrille::NormalFlip: " + internal::text_of(degrees) +
                                  " degrees are not in (0, 180]");
  }

  /// Returns false if the contraction is rejected: see FilterPolicy.
  bool allows(const auto& contraction) const {
    if (allows_everything_)
      return true;
    bool may_fold_over = false;
    for (const auto& face : contraction.faces()) {
      const Vector<3> before = double_area_vector(face.before, face.second, face.third);
      const Vector<3> after = double_area_vector(face.after, face.second, face.third);
      const double product = dot(before, after);
      const double squared_after = squared_length(after);
      const double squared_lengths = squared_length(before) * squared_after;
      if (turns_too_far(product, squared_lengths) &&
          has_normal(face.before, face.second, face.third))
        return false;
      if (Shape(squared_after, face.after, face).is_sliver() &&
          !Shape(squared_length(before), face.before, face).is_sliver() &&
          !stays_in_narrow_wall(contraction)) [[unlikely]]
        return false;
      may_fold_over |= product * product < squared_cosine_of_20_degrees * squared_lengths;
    }
    return allows_fold_overs_ || !may_fold_over || !contraction.makes_fold_over();
  }

private:
  static bool has_normal(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    return squared_length(normal_vector(p, q, r)) > 0;
  }

  // The shape of a face, from its moving corner p.
  struct Shape {
    double squared_area; // of the parallelogram
    double edges;        // |pq|² + |pr|², at least half of the square of the longest edge

    Shape(double squared_doubled_area, const Vector<3>& p, const auto& face)
        : squared_area(squared_doubled_area),
          edges(squared_distance(p, face.second) + squared_distance(p, face.third)) {}
    Shape(const Vector<3>& p, const auto& face)
        : Shape(squared_length(double_area_vector(p, face.second, face.third)), p, face) {}

    // Twice the area is the height times the longest edge.
    bool is_sliver() const {
      return squared_area < 4 * least_height * least_height * edges * edges;
    }
    // Returns the square of the height over the longest edge, up to a factor of 4.
    double squared_height() const { return edges > 0 ? squared_area / (edges * edges) : 0; }
  };

  // Returns whether all slivers that a contraction makes of better faces belong to a narrow wall.
  // Along such a wall faces get longer, but not smaller, and the faces around are nearly as narrow.
  // Next to collinear points a face loses its area.
  QUADRILLE_NOINLINE static bool stays_in_narrow_wall(const auto& contraction) { // called rarely
    double squared_least = std::numeric_limits<double>::infinity();
    for (const auto& face : contraction.faces())
      squared_least = (std::min)(squared_least, Shape(face.before, face).squared_height());
    for (const auto& face : contraction.faces()) {
      const Shape before(face.before, face), after(face.after, face);
      if (after.is_sliver() && !before.is_sliver() &&
          (after.squared_area < least_area * least_area * before.squared_area ||
           after.squared_height() < least_fraction * least_fraction * squared_least))
        return false;
    }
    return true;
  }

  bool turns_too_far(double product, double squared_lengths) const {
    return product <= (cosine_ == 0 ? 0 : cosine_ * std::sqrt(squared_lengths));
  }

  static constexpr double squared_cosine_of_20_degrees = 0.883;
  static constexpr double least_height = 1e-4; // height of a face, relative to its longest edge
  static constexpr double least_area = 0.25;   // area of a sliver in a narrow wall, relative to its
                                               // former area
  static constexpr double least_fraction = 0.01; // its height, relative to the lowest of the faces
                                                 // around

  double cosine_;
  bool allows_everything_, allows_fold_overs_;
};

/// Rejects a contraction after which a face has an angle below `degrees`, unless this angle is at
/// least as large as the smallest angle of the face before.
class SmallestAngle {
public:
  using ScaleFree = SmallestAngle;                     ///< scale-invariant
  static constexpr Rejection cause = Rejection::shape; ///< counts its rejections

  /// degrees lies in [0, 60]; throws std::invalid_argument otherwise.
  explicit SmallestAngle(double degrees) : radians_(degrees * std::numbers::pi / 180) {
    if (!(degrees >= 0 && degrees <= 60))
      throw std::invalid_argument("quadrille::SmallestAngle: " + internal::text_of(degrees) +
                                  " degrees are not in [0, 60]");
  }

  /// Returns false if the contraction is rejected: see FilterPolicy.
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces()) {
      const double after = smallest_angle(face.after, face);
      if (after < radians_ && after < smallest_angle(face.before, face))
        return false;
    }
    return true;
  }

private:
  // Returns the smallest angle of the face with its moving corner at p.
  static double smallest_angle(const Vector<3>& p, const auto& face) {
    const double area = std::sqrt(squared_length(double_area_vector(p, face.second, face.third)));
    const auto angle = [area](const Vector<3>& at, const Vector<3>& to, const Vector<3>& and_to) {
      return std::atan2(area, dot(to - at, and_to - at)); // accurate for small angles too
    };
    return (std::min)({angle(p, face.second, face.third), angle(face.second, face.third, p),
                       angle(face.third, p, face.second)});
  }

  double radians_;
};

/// Rejects a contraction that makes an edge longer than `length`, unless the edge was at least as
/// long before. Edges that are longer in the input may stay or become shorter. If the coordinates
/// are floats, rounding may bring an edge over the limit.
class LongestEdge {
public:
  /// length is in the mesh's units, and above 0; throws std::invalid_argument otherwise.
  explicit LongestEdge(double length) : length_(length) {
    if (!(length > 0))
      throw std::invalid_argument("quadrille::LongestEdge: the length " +
                                  internal::text_of(length) + " is not above 0");
  }

  /// Returns false if the contraction is rejected: see FilterPolicy.
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      for (const Vector<3>& end : {face.second, face.third}) {
        const double after = distance(face.after, end);
        if (after > length_ && after > distance(face.before, end))
          return false;
      }
    return true;
  }

private:
  // Returns a distance in the mesh's units, in which squares may over- or underflow.
  static double distance(const Vector<3>& p, const Vector<3>& q) {
    return internal::safe_length(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  double length_;
};

/// Rejects a contraction after which its vertex has more than `degree` faces, unless one of the two
/// ends has at least as many already.
class HighestDegree {
public:
  using ScaleFree = HighestDegree;                      ///< scale-invariant
  static constexpr Rejection cause = Rejection::degree; ///< counts its rejections

  /// degree is at least 3; throws std::invalid_argument otherwise.
  explicit HighestDegree(std::size_t degree = 24) : degree_(degree) {
    if (degree < 3)
      throw std::invalid_argument("quadrille::HighestDegree: " + std::to_string(degree) +
                                  " is less than 3");
  }

  /// Returns false if the contraction is rejected: see FilterPolicy.
  bool allows(const auto& contraction) const {
    const std::size_t after = contraction.faces().size();
    return after <= degree_ || after <= contraction.highest_degree();
  }

private:
  std::size_t degree_;
};

/// Keeps a surface the graph of a height function over a plane. It rejects a contraction after
/// which a face that shows one side to a viewer who looks against `direction` would show the other
/// side, or none. So each face of a terrain covers a region of the map, and together the faces
/// cover the same area as before if the boundary stays.
///
/// A face is *vertical* if twice its projected area is less than a ten thousandth of the sum of the
/// squares of two of its edges: it is steeper than 89.99 degrees, or its projection is a sliver. So
/// the result remains a height field when it is written as floats, if no face is smaller than a
/// hundredth of the greatest coordinate.
///
/// Faces that are vertical in the input, such as walls, may stay vertical, but their reverse sides
/// do not become more visible (front sides face `direction`). Faces that are flipped in the input
/// stay flipped until they are contracted; if all faces are flipped, the surface is a height field
/// as well.
class HeightField {
public:
  /// scale-invariant
  using ScaleFree = HeightField;
  static constexpr Rejection cause = Rejection::normal_flip; ///< counts its rejections

  /// `direction` points up and may have any length; throws std::invalid_argument if it is zero or
  /// not finite.
  explicit HeightField(const Vector<3>& direction = {{0, 0, 1}}) : up_(direction) {
    double greatest = 0;
    for (double x : direction.coordinates)
      greatest = (std::max)(greatest, std::abs(x));
    if (!is_finite(direction) || !(greatest > 0))
      throw std::invalid_argument("quadrille::HeightField: the direction is zero or not finite");
    for (double& x : up_.coordinates)
      x /= greatest; // so that squares of any direction neither over- nor underflow
    up_ *= 1 / std::sqrt(squared_length(up_));
  }

  /// Returns false if the contraction is rejected: see FilterPolicy.
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces()) {
      const Outline before(face.before, face, up_), after(face.after, face, up_);
      if (before.faces_viewer() ? !after.faces_viewer()
          : before.faces_away() ? !after.faces_away()
                                : after.is_turned_further_away_than(before))
        return false;
    }
    return true;
  }

private:
  static constexpr double least_area = 1e-4; // area of a face that is not vertical, relative to its
                                             // edges

  // The projection of a face, with its moving corner at p.
  struct Outline {
    double area;     // of the parallelogram; negative for a face that shows its reverse
    double edges;    // |pq|² + |pr|², in space
    double rounding; // of the area

    Outline(const Vector<3>& p, const auto& face, const Vector<3>& up)
        : area(dot(double_area_vector(p, face.second, face.third), up)),
          edges(squared_distance(p, face.second) + squared_distance(p, face.third)),
          rounding(0x1p-50 * std::sqrt(edges * (squared_length(p) + squared_length(face.second) +
                                                squared_length(face.third)))) {}

    bool faces_viewer() const { return area > least_area * edges; }
    bool faces_away() const { return area < -least_area * edges; }
    bool is_turned_further_away_than(const Outline& other) const {
      const double least = other.area < 0 ? other.area / other.edges * edges : 0;
      return area < least - rounding;
    }
  };

  Vector<3> up_;
};

} // namespace quadrille

#endif // QUADRILLE_FILTERS_H
