#ifndef QUADRILLE_FILTERS_H
#define QUADRILLE_FILTERS_H

#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <cmath>
#include <numbers>

namespace quadrille {

/// Refuses a contraction that turns the normal of a face by `degrees` or more. A face without area
/// has no normal and may turn to any.
class NormalFlip {
public:
  static constexpr Rejection cause = Rejection::normal_flip;

  /// degrees lies in (0, 180].
  explicit NormalFlip(double degrees = 90)
      : cosine_(degrees == 90 ? 0 : std::cos(degrees * std::numbers::pi / 180)) {}

  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      if (turns_too_far(double_area_vector(face.before, face.second, face.third),
                        double_area_vector(face.after, face.second, face.third)))
        return false;
    return true;
  }

private:
  bool turns_too_far(const Vector<3>& before, const Vector<3>& after) const {
    const double product = dot(before, after);
    if (cosine_ == 0)
      return product <= 0 && squared_length(before) > 0;
    const double lengths = std::sqrt(squared_length(before) * squared_length(after));
    return product <= cosine_ * lengths && squared_length(before) > 0;
  }

  double cosine_;
};

} // namespace quadrille

#endif // QUADRILLE_FILTERS_H
