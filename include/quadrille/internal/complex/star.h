#ifndef QUADRILLE_INTERNAL_COMPLEX_STAR_H
#define QUADRILLE_INTERNAL_COMPLEX_STAR_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/append_buffer.h>

#include <cstddef>

namespace quadrille::internal {

/// A face at a vertex: its other two vertices, in the order of the face.
struct StarFace {
  Index face, second, third;

  StarFace() {} // a new one is not written to before it is used
  StarFace(Index f, Index s, Index t) : face(f), second(s), third(t) {}

  // Part by part: see PairQueue::append.
  void set(const StarFace& f) { face = f.face, second = f.second, third = f.third; }
};

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
      const StarFace f = star_face(complex, face, i);
      const bool is_shared = (f.second == b) | (f.third == b);
      ours[our_count].set(f);
      both[both_count].set(f);
      both_count += is_shared;
      our_count += !is_shared;
    });
    complex.prune_corners(b, [&](Index face, Index i) {
      const StarFace f = star_face(complex, face, i);
      theirs[their_count].set(f);
      their_count += (f.second != a) & (f.third != a);
    });
    first.add(our_count);
    shared.add(both_count);
    second.add(their_count);
  }

  static StarFace star_face(const TriangleComplex& complex, Index face, Index i) {
    const auto& v = complex.vertices(face);
    return {face, v[next_place(i)], v[previous_place(i)]};
  }

private:
  // From a table in a number: compilers make jumps of conditions.
  static Index next_place(Index i) { return 0b00'10'01u >> 2 * i & 3; }
  static Index previous_place(Index i) { return 0b01'00'10u >> 2 * i & 3; }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COMPLEX_STAR_H
