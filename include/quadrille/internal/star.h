#ifndef QUADRILLE_INTERNAL_STAR_H
#define QUADRILLE_INTERNAL_STAR_H

#include <quadrille/internal/triangle_complex.h>

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// A face at a vertex: its other two vertices, in the order of the face.
struct StarFace {
  Index face, second, third;

  StarFace() {} // a new one is not written to before it is used
  StarFace(Index f, Index s, Index t) : face(f), second(s), third(t) {}
};

/// The faces around a pair of vertices: those of one end only, which a contraction changes, and
/// those of both, which it removes.
struct PairStar {
  std::vector<StarFace> first, second; // the faces of one end only
  std::vector<StarFace> shared;        // the faces of both, seen from the first end

  void gather(TriangleComplex& complex, Index a, Index b) {
    first.resize(complex.degree_bound(a));
    shared.resize(first.size());
    second.resize(complex.degree_bound(b));
    std::size_t ours = 0, both = 0, theirs = 0;
    complex.for_each_corner(a, [&](Index face, Index i) { // without a branch: it is hard to guess
      const StarFace f = star_face(complex, face, i);
      const bool is_shared = (f.second == b) | (f.third == b);
      first[ours] = shared[both] = f;
      both += is_shared;
      ours += !is_shared;
    });
    complex.for_each_corner(b, [&](Index face, Index i) {
      const StarFace f = second[theirs] = star_face(complex, face, i);
      theirs += (f.second != a) & (f.third != a);
    });
    first.resize(ours);
    shared.resize(both);
    second.resize(theirs);
  }

  static StarFace star_face(const TriangleComplex& complex, Index face, Index i) {
    const auto& v = complex.vertices(face);
    return {face, v[i == 2 ? 0 : i + 1], v[i == 0 ? 2 : i - 1]};
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_STAR_H
