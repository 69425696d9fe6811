#ifndef QUADRILLE_HEIGHT_FIELD_H
#define QUADRILLE_HEIGHT_FIELD_H

#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace quadrille {

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

#endif // QUADRILLE_HEIGHT_FIELD_H
