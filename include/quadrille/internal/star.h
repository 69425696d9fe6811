#ifndef QUADRILLE_INTERNAL_STAR_H
#define QUADRILLE_INTERNAL_STAR_H

#include <quadrille/internal/room.h>
#include <quadrille/internal/triangle_complex.h>

#include <cstddef>

namespace quadrille::internal {

/// A face at a vertex: its other two vertices, in the order of the face.
struct StarFace {
  Index face, second, third;

  StarFace() {} // a new one is not written to before it is used
  StarFace(Index f, Index s, Index t) : face(f), second(s), third(t) {}

  // Part by part: see PairQueue::append.
  void set(Index f, Index s, Index t) { face = f, second = s, third = t; }
};

/// The faces around a pair of vertices: those of one end only, which a contraction changes, and
/// those of both, which it removes.
struct PairStar {
  Room<StarFace> first, second; // the faces of one end only
  Room<StarFace> shared;        // the faces of both, seen from the first end

  void gather(TriangleComplex& complex, Index a, Index b) {
    first.clear(), second.clear(), shared.clear();
    StarFace* const ours = first.extend(complex.degree_bound(a));
    StarFace* const both = shared.extend(complex.degree_bound(a));
    StarFace* const theirs = second.extend(complex.degree_bound(b));
    std::size_t our_count = 0, both_count = 0, their_count = 0;
    complex.for_each_corner(a, [&](Index face, Index i) { // without a branch: it is hard to guess
      const auto [v, w] = others(complex, face, i);
      const bool is_shared = (v == b) | (w == b);
      ours[our_count].set(face, v, w);
      both[both_count].set(face, v, w);
      both_count += is_shared;
      our_count += !is_shared;
    });
    complex.for_each_corner(b, [&](Index face, Index i) {
      const auto [v, w] = others(complex, face, i);
      theirs[their_count].set(face, v, w);
      their_count += (v != a) & (w != a);
    });
    first.add(our_count);
    shared.add(both_count);
    second.add(their_count);
  }

  static StarFace star_face(const TriangleComplex& complex, Index face, Index i) {
    const auto [v, w] = others(complex, face, i);
    return {face, v, w};
  }

private:
  struct Two {
    Index second, third;
  };
  static Two others(const TriangleComplex& complex, Index face, Index i) {
    const auto& v = complex.vertices(face);
    return {v[next_place(i)], v[previous_place(i)]};
  }
  // From a table in a number: compilers make jumps of conditions.
  static Index next_place(Index i) { return 0b00'10'01u >> 2 * i & 3; }
  static Index previous_place(Index i) { return 0b01'00'10u >> 2 * i & 3; }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_STAR_H
