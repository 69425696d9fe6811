#ifndef QUADRILLE_INTERNAL_COMPLEX_STAR_H
#define QUADRILLE_INTERNAL_COMPLEX_STAR_H

#include <quadrille/internal/complex/star_face.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/append_buffer.h>

#include <cstddef>

namespace quadrille::internal {

/// The face at one of its vertices, in place i of its corners.
inline StarFace star_face_at(const TriangleComplex& complex, Index face, Index i) {
  const auto& v = complex.vertices(face);
  // From tables in numbers: compilers make jumps of conditions.
  const Index next = 0b00'10'01u >> 2 * i & 3, previous = 0b01'00'10u >> 2 * i & 3;
  return {face, v[next], v[previous]};
}

/// The faces around a pair of vertices: those of one end only, which a contraction changes, and
/// those of both, which it removes.
struct PairStar {
  AppendBuffer<StarFace> first, second; // the faces of one end only
  AppendBuffer<StarFace> shared;        // the faces of both, seen from the first end

  void gather(TriangleComplex& complex, Index a, Index b) {
    first.clear(), second.clear(), shared.clear();
    StarFace* const ours = first.extend(complex.degree_bound(a));
    StarFace* const both = shared.extend(complex.degree_bound(a));
    StarFace* const theirs = second.extend(complex.degree_bound(b));
    std::size_t our_count = 0, both_count = 0, their_count = 0;
    complex.prune_corners(a, [&](Index face, Index i) { // without a branch: it is hard to guess
      const StarFace f = star_face_at(complex, face, i);
      const bool is_shared = (f.second == b) | (f.third == b);
      ours[our_count].set(f);
      both[both_count].set(f);
      both_count += is_shared;
      our_count += !is_shared;
    });
    complex.prune_corners(b, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex, face, i);
      theirs[their_count].set(f);
      their_count += (f.second != a) & (f.third != a);
    });
    first.add(our_count);
    shared.add(both_count);
    second.add(their_count);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COMPLEX_STAR_H
