#ifndef QUADRILLE_INTERNAL_INTERSECTION_INTERSECTION_CHECK_H
#define QUADRILLE_INTERNAL_INTERSECTION_INTERSECTION_CHECK_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <span>

namespace quadrille::internal {

/// What knows where the faces of a surface are, so that it can tell whether they meet. It is
/// compiled for calls with NoSelfIntersection only: see FaceIntersections.
class IntersectionCheck {
public:
  virtual ~IntersectionCheck() = default;

  /// The surface is as it is before the first contraction.
  virtual void begin() = 0;
  /// Would faces intersect that do not, if this pair came together at a target?
  virtual bool makes_intersection(const PairStar& star, Index first, Index second,
                                  const Vector<3>& target) = 0;
  /// A face that it would meet or pass over, if the last answer was yes; none if faces of the star
  /// would meet each other.
  virtual Index face_in_the_way() const = 0;
  /// That has been done: the vertex that is left has its place.
  virtual void follow(const PairStar& star, Index first) = 0;
  /// Faces that are gone.
  virtual void forget(std::span<const Index> faces) = 0;
  /// How many pairs of faces intersect, now.
  virtual std::size_t count() = 0;
  /// One of these, of which there is at least one: the first in an order of its own.
  virtual std::array<Index, 2> first_pair() = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_INTERSECTION_INTERSECTION_CHECK_H
