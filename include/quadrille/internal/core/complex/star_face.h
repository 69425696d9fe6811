#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_FACE_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_FACE_H

#include <quadrille/internal/core/base/index.h>

namespace quadrille::internal {

/// A face at a vertex: its other two vertices, in the order of the face.
struct StarFace {
  Index face, second, third;

  StarFace() {} // a new one is not written to before it is used
  StarFace(Index f, Index s, Index t) : face(f), second(s), third(t) {}

  bool has(Index v) const { return second == v || third == v; }
  /// Returns the one of the other two vertices that is not v.
  Index other_than(Index v) const { return second == v ? third : second; }

  // Assigns member by member: see PairQueue::append.
  void set(const StarFace& f) { face = f.face, second = f.second, third = f.third; }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_FACE_H
