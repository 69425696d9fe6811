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

/// May a face come to lie over its neighbours, like the middle of a letter Z?
enum class Folds { refused, allowed };

/// Refuses a contraction that turns the normal of a face by `degrees` or more (the test of the 1997
/// paper, section 6). Several contractions that each turn a face by less can still fold it over its
/// neighbours: unless folds are allowed, one that would do it is refused too, as far as that is
/// seen where a face turns by more than 20 degrees.
///
/// A *needle* is lower than a ten thousandth of its length: rounding soon decides its normal. A
/// contraction that makes one of another face is refused as well; flat and straight parts would
/// end in faces of three points on a line otherwise. A face of a wall that is narrow by itself,
/// such as the rim of a foil, may become one: it keeps a quarter of its area, and a hundredth of
/// the relative height of the lowest face around.
///
/// On by default, with 90 degrees. A face of three points on a line, up to rounding, has no normal
/// and may turn to any; 180 degrees allows everything.
class NormalFlip {
public:
  using ScaleFree = NormalFlip;                              ///< as well in any unit of length
  static constexpr Rejection cause = Rejection::normal_flip; ///< what refusals count as

  /// degrees lies in (0, 180]; throws std::invalid_argument otherwise.
  explicit NormalFlip(double degrees = 90, Folds folds = Folds::refused)
      : cosine_(degrees == 90 ? 0 : std::cos(degrees * std::numbers::pi / 180)),
        allows_everything_(degrees == 180), allows_folds_(folds == Folds::allowed) {
    if (!(degrees > 0 && degrees <= 180))
      throw std::invalid_argument("quadrille::NormalFlip: " + internal::text_of(degrees) +
                                  " degrees are not in (0, 180]");
  }

  /// False where the contraction is to be refused: see FilterPolicy.
  bool allows(const auto& contraction) const {
    if (allows_everything_)
      return true;
    bool may_fold = false;
    for (const auto& face : contraction.faces()) {
      const Vector<3> before = double_area_vector(face.before, face.second, face.third);
      const Vector<3> after = double_area_vector(face.after, face.second, face.third);
      const double product = dot(before, after);
      const double squared_after = squared_length(after);
      const double squared_lengths = squared_length(before) * squared_after;
      if (turns_too_far(product, squared_lengths) &&
          has_normal(face.before, face.second, face.third))
        return false;
      if (Shape(squared_after, face.after, face).is_needle() &&
          !Shape(squared_length(before), face.before, face).is_needle() &&
          !stays_in_narrow_wall(contraction)) [[unlikely]]
        return false;
      may_fold |= product * product < squared_cosine_of_20_degrees * squared_lengths;
    }
    return allows_folds_ || !may_fold || !contraction.makes_fold();
  }

private:
  static bool has_normal(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    return squared_length(normal_vector(p, q, r)) > 0;
  }

  // Of a face, from its moving corner p.
  struct Shape {
    double squared_area; // of the parallelogram
    double edges;        // |pq|² + |pr|², at least half of the square of the longest edge

    Shape(double squared_doubled_area, const Vector<3>& p, const auto& face)
        : squared_area(squared_doubled_area),
          edges(squared_distance(p, face.second) + squared_distance(p, face.third)) {}
    Shape(const Vector<3>& p, const auto& face)
        : Shape(squared_length(double_area_vector(p, face.second, face.third)), p, face) {}

    // Twice the area is the height times the longest edge.
    bool is_needle() const {
      return squared_area < 4 * least_height * least_height * edges * edges;
    }
    // The square of the height in the longest edge, but for a factor of 4 at most.
    double squared_height() const { return edges > 0 ? squared_area / (edges * edges) : 0; }
  };

  // Are all needles that a contraction makes of better faces parts of a narrow wall? Along such a
  // one faces get longer, but not smaller, and faces around are nearly as narrow. Next to
  // collinear points a face loses its area.
  QUADRILLE_NOINLINE static bool stays_in_narrow_wall(const auto& contraction) { // seldom
    double squared_least = std::numeric_limits<double>::infinity();
    for (const auto& face : contraction.faces())
      squared_least = (std::min)(squared_least, Shape(face.before, face).squared_height());
    for (const auto& face : contraction.faces()) {
      const Shape before(face.before, face), after(face.after, face);
      if (after.is_needle() && !before.is_needle() &&
          (after.squared_area < least_area * least_area * before.squared_area ||
           after.squared_height() < least_part * least_part * squared_least))
        return false;
    }
    return true;
  }

  bool turns_too_far(double product, double squared_lengths) const {
    return product <= (cosine_ == 0 ? 0 : cosine_ * std::sqrt(squared_lengths));
  }

  static constexpr double squared_cosine_of_20_degrees = 0.883;
  static constexpr double least_height = 1e-4; // of a face, in its longest edge
  static constexpr double least_area = 0.25;   // of a needle in a narrow wall, in what it was
  static constexpr double least_part = 0.01;   // of its height, in the least of the faces around

  double cosine_;
  bool allows_everything_, allows_folds_;
};

/// Refuses a contraction that makes a face with a smaller angle than `degrees`, unless that angle
/// is as large as the smallest that the face had before.
class SmallestAngle {
public:
  using ScaleFree = SmallestAngle;                     ///< as well in any unit of length
  static constexpr Rejection cause = Rejection::shape; ///< what refusals count as

  /// degrees lies in [0, 60]; throws std::invalid_argument otherwise.
  explicit SmallestAngle(double degrees) : radians_(degrees * std::numbers::pi / 180) {
    if (!(degrees >= 0 && degrees <= 60))
      throw std::invalid_argument("quadrille::SmallestAngle: " + internal::text_of(degrees) +
                                  " degrees are not in [0, 60]");
  }

  /// False where the contraction is to be refused: see FilterPolicy.
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces()) {
      const double after = smallest_angle(face.after, face);
      if (after < radians_ && after < smallest_angle(face.before, face))
        return false;
    }
    return true;
  }

private:
  // Of the face with its moving corner at p.
  static double smallest_angle(const Vector<3>& p, const auto& face) {
    const double area = std::sqrt(squared_length(double_area_vector(p, face.second, face.third)));
    const auto angle = [area](const Vector<3>& at, const Vector<3>& to, const Vector<3>& and_to) {
      return std::atan2(area, dot(to - at, and_to - at)); // exact for small ones too
    };
    return (std::min)({angle(p, face.second, face.third), angle(face.second, face.third, p),
                       angle(face.third, p, face.second)});
  }

  double radians_;
};

/// Refuses a contraction that makes an edge longer than `length`, unless the edge was as long
/// before. Edges that are longer in the input may stay as they are or become shorter. Coordinates
/// that are floats may round an edge beyond the limit.
class LongestEdge {
public:
  /// length is in the mesh's units, and above 0; throws std::invalid_argument otherwise.
  explicit LongestEdge(double length) : length_(length) {
    if (!(length > 0))
      throw std::invalid_argument("quadrille::LongestEdge: the length " +
                                  internal::text_of(length) + " is not above 0");
  }

  /// False where the contraction is to be refused: see FilterPolicy.
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
  // In the mesh's units, in which squares may over- or underflow.
  static double distance(const Vector<3>& p, const Vector<3>& q) {
    return internal::safe_length(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  double length_;
};

/// Refuses a contraction after which its vertex would have more than `degree` faces, unless one of
/// the two ends has as many already.
class HighestDegree {
public:
  using ScaleFree = HighestDegree;                      ///< as well in any unit of length
  static constexpr Rejection cause = Rejection::degree; ///< what refusals count as

  /// degree is at least 3; throws std::invalid_argument otherwise.
  explicit HighestDegree(std::size_t degree = 24) : degree_(degree) {
    if (degree < 3)
      throw std::invalid_argument("quadrille::HighestDegree: " + std::to_string(degree) +
                                  " is less than 3");
  }

  /// False where the contraction is to be refused: see FilterPolicy.
  bool allows(const auto& contraction) const {
    const std::size_t after = contraction.faces().size();
    return after <= degree_ || after <= contraction.highest_degree();
  }

private:
  std::size_t degree_;
};

/// Keeps a surface the graph of a height over a plane: refuses a contraction after which a face
/// that shows one side to who looks against `direction` would show the other, or none. So each face
/// of terrain lies over a piece of the map, and together these cover what they did before as long
/// as the border stays.
///
/// A face is *vertical* if twice its area, as seen from there, is less than a ten thousandth of the
/// sum of the squares of two of its edges: then it is steeper than 89.99 degrees, or its outline on
/// the map is a needle. So the result is still a height field where it is written as floats, as
/// long as no face is smaller than a hundredth of the greatest coordinate.
///
/// Faces that are vertical in the input, such as walls, may stay so, but show their back no more
/// than they did, where `direction` is what front sides look to. Those that are turned over in the
/// input stay so until they are contracted; where all are, the surface is a height field as well.
class HeightField {
public:
  using ScaleFree = HeightField;                             ///< as well in any unit of length
  static constexpr Rejection cause = Rejection::normal_flip; ///< what refusals count as

  /// direction is up, of any length; throws std::invalid_argument if it is zero or not finite.
  explicit HeightField(const Vector<3>& direction = {{0, 0, 1}}) : up_(direction) {
    double greatest = 0;
    for (double x : direction.coordinates)
      greatest = (std::max)(greatest, std::abs(x));
    if (!is_finite(direction) || !(greatest > 0))
      throw std::invalid_argument("quadrille::HeightField: the direction is zero or not finite");
    for (double& x : up_.coordinates)
      x /= greatest; // squares of any direction neither over- nor underflow then
    up_ *= 1 / std::sqrt(squared_length(up_));
  }

  /// False where the contraction is to be refused: see FilterPolicy.
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces()) {
      const Outline before(face.before, face, up_), after(face.after, face, up_);
      if (before.is_front()  ? !after.is_front()
          : before.is_back() ? !after.is_back()
                             : after.shows_more_of_back_than(before))
        return false;
    }
    return true;
  }

private:
  static constexpr double least_area = 1e-4; // of a face that is not vertical, in its edges

  // Of a face on the map, its moving corner at p.
  struct Outline {
    double area;     // of the parallelogram, below 0 for one that shows its back
    double edges;    // |pq|² + |pr|², in space
    double rounding; // of the area

    Outline(const Vector<3>& p, const auto& face, const Vector<3>& up)
        : area(dot(double_area_vector(p, face.second, face.third), up)),
          edges(squared_distance(p, face.second) + squared_distance(p, face.third)),
          rounding(0x1p-50 * std::sqrt(edges * (squared_length(p) + squared_length(face.second) +
                                                squared_length(face.third)))) {}

    bool is_front() const { return area > least_area * edges; }
    bool is_back() const { return area < -least_area * edges; }
    bool shows_more_of_back_than(const Outline& other) const {
      const double least = other.area < 0 ? other.area / other.edges * edges : 0;
      return area < least - rounding;
    }
  };

  Vector<3> up_;
};

} // namespace quadrille

#endif // QUADRILLE_FILTERS_H
