#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_TOLERANCES_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_TOLERANCES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// The tolerances of the faces around a pair: the least of them applies to all. A bound is then the
/// fraction of it that is used; without tolerances it is a distance, and all of this does nothing.
struct StarTolerance {
  bool is_given = false;
  double least = 1;    // in the engine's unit
  float used = 0;      // the greatest fraction that a face of the star has used
  double rounding = 0; // what uses nothing
  double greatest =
      1; // of all faces at the beginning: a fraction of it is no less than that of any

  /// A bound as a length that what a contraction adds can be added to.
  double length_of(float bound) const { return static_cast<double>(bound) * least; }
  /// As a distance that no point has gone beyond.
  double distance_of(double bound) const { return bound * greatest; }
  /// Converts back, rounded up to a float. A length that may be rounding uses nothing more.
  double bound_of(double length) const {
    if (!is_given)
      return length;
    if (length <= rounding)
      return static_cast<double>(used);
    const double ratio = length / least;
    const auto near = static_cast<float>(ratio);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return static_cast<double>(near) < ratio ? static_cast<double>(std::nextafter(near, infinity))
                                             : static_cast<double>(near);
  }
};

/// The tolerance of each face: the least one of all input points that have come to lie in it or to
/// which its points have gone. Each contraction spreads the least one of its star over the star.
class Tolerances {
public:
  Tolerances() = default; ///< none
  /// Takes tolerances of vertices; each face has the least one of its corners. A tolerance above
  /// `most`, which no distance of the surface reaches, is reduced to it. In the engine's unit.
  Tolerances(const TriangleComplex& complex, const std::vector<double>& of_vertex, double most)
      : of_face_(complex.face_capacity(), 0) {
    for (Index face = 0; face < of_face_.size(); ++face) {
      if (complex.is_removed(face))
        continue;
      double least = most;
      for (Index v : complex.vertices(face))
        least = (std::min)(least, of_vertex[v]);
      of_face_[face] = rounded_down(least);
      greatest_ = (std::max)(greatest_, static_cast<double>(of_face_[face]));
    }
  }

  /// Takes tolerances of faces, which limit() sets one by one. `greatest` is that of the input.
  Tolerances(std::size_t faces, double greatest)
      : of_face_(faces, std::numeric_limits<float>::infinity()), greatest_(greatest) {}

  void limit(Index face, float tolerance) {
    of_face_[face] = (std::min)(of_face_[face], tolerance);
  }

  bool are_given() const { return of_face_.size() > 0; }
  /// The greatest tolerance of all faces of the input.
  double greatest() const { return greatest_; }
  double operator[](Index face) const { return static_cast<double>(of_face_[face]); }

  double least(const PairStar& star) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        least = (std::min)(least, (*this)[f.face]);
    return least;
  }

  /// The faces of a star that a contraction has changed.
  void set(const PairStar& star, double tolerance) {
    star.for_each_changed(
        [&](const StarFace& f) { of_face_[f.face] = static_cast<float>(tolerance); });
  }

  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(of_face_, is_left);
  }

private:
  static float rounded_down(double tolerance) {
    const auto near = static_cast<float>(tolerance);
    return static_cast<double>(near) > tolerance ? std::nextafter(near, 0.0F) : near;
  }

  Array<float> of_face_;
  double greatest_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_TOLERANCES_H
