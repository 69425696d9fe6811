#ifndef QUADRILLE_INTERNAL_DISTANCE_BOUND_H
#define QUADRILLE_INTERNAL_DISTANCE_BOUND_H

#include <quadrille/internal/array.h>
#include <quadrille/internal/packing.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/star_deviation.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// Of each face, how far its points are from the input at most: what each contraction has added.
class DistanceBounds {
public:
  /// `size` is the greatest coordinate of the surface.
  explicit DistanceBounds(std::size_t faces, double size = 0) : of_face_(faces, 0), size_(size) {}

  /// A distance that may be nothing but the sum of many roundings, on a surface of this size.
  double rounding() const { return 0x1p-40 * size_; }

  /// What a contraction would make of the bounds of the faces that it changes, in the order of the
  /// star; and the greatest of these. Once is_too_far(distance) says so nothing else is looked at:
  /// then only the distance that is too far is told. What is too far stays so at any greater one.
  template <std::size_t N, class IsTooFar>
  FaceDeviation after(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
                      const Vector<3>& x, bool may_have_border, StarDeviation& deviation,
                      std::vector<float>& bounds, IsTooFar is_too_far) const {
    deviation.take(star, a, b, positions, x, [this](Index face) { return of_face_[face]; });
    const auto is_beyond = [&](double distance) {
      return is_too_far(rounded_up(distance + deviation.rounding()));
    };
    if (const auto beyond = deviation.compare_each(is_beyond))
      return *beyond;
    if (const auto beyond = deviation.compare_sheets(is_beyond))
      return *beyond;
    if (const auto beyond = deviation.compare_border(may_have_border, is_beyond))
      return *beyond;

    bounds.clear();
    for (std::size_t i = 0; i < deviation.size(); ++i)
      bounds.push_back(deviation.is_unchanged(i)
                           ? static_cast<float>(deviation.bound(i))
                           : rounded_up(deviation[i].from_input + deviation.rounding()));
    FaceDeviation greatest = deviation.greatest();
    greatest.from_input =
        bounds.empty() ? 0 : double{*std::max_element(bounds.begin(), bounds.end())};
    return greatest;
  }

  /// The contraction has been done.
  void set(const PairStar& star, const std::vector<float>& bounds) {
    auto bound = bounds.begin();
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces)
        of_face_[f.face] = *bound++;
  }

  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(of_face_, is_left);
  }

  /// Of the faces that are left.
  double greatest(const TriangleComplex& complex) const {
    float greatest = 0;
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_dead(face))
        greatest = std::max(greatest, of_face_[face]);
    return greatest;
  }

private:
  static float rounded_up(double bound) {
    return std::nextafter(static_cast<float>(bound), std::numeric_limits<float>::infinity());
  }

  Array<float> of_face_;
  double size_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_DISTANCE_BOUND_H
