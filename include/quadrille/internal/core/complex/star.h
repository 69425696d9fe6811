#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star_face.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/append_buffer.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The face at one of its vertices, in place i of its corners.
QUADRILLE_ALWAYS_INLINE inline StarFace star_face_at(const TriangleComplex& complex, Index face,
                                                     Index i) {
  const auto& v = complex.vertices(face);
  // From tables in numbers: compilers make jumps of conditions.
  const Index next = 0b00'10'01u >> 2 * i & 3, previous = 0b01'00'10u >> 2 * i & 3;
  return {face, v[next], v[previous]};
}

/// The face at that one of its vertices.
inline StarFace star_face_from(const TriangleComplex& complex, Index face, Index vertex) {
  const auto& v = complex.vertices(face);
  return star_face_at(complex, face, v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2);
}

/// The faces around a pair of vertices: those of one end only, which a contraction changes, and
/// those of both, which it removes.
///
/// ```text
///            l
///          / | \        a, b   the pair; l, r and all other neighbours of the two are its link
///     \ 1 /  |  \ 2 /   1      faces of `first`: at a and not at b
///   1   a  s | s  b  2  2      faces of `second`: at b and not at a
///     / 1 \  |  / 2 \   s      faces of `shared`: at both; here two, (a, b, l) and (b, a, r)
///          \ | /
///            r
/// ```
///
/// If one end is a high-valence vertex, the other end moves to it and the faces of the high-valence
/// vertex do not change. The star then has only the faces next to the other end: those that share a
/// vertex with its link; and at least one face opposite the pair for each further high-valence
/// vertex in the link.
struct PairStar {
  AppendBuffer<StarFace> first, second; // the faces of one end only
  AppendBuffer<StarFace> shared;        // the faces of both, seen from the first end
  Index high_valence = none;            // the end of which faces are left out, if one is
  bool may_meet_high_valence =
      false; // may it be joined to a further high-valence vertex in the link that is not opposite?

  void gather(TriangleComplex& complex, Index a, Index b) {
    clear();
    StarFace* const ours = first.extend(complex.degree_bound(a));
    StarFace* const both = shared.extend(complex.degree_bound(a));
    StarFace* const theirs = second.extend(complex.degree_bound(b));
    std::size_t our_count = 0, both_count = 0, their_count = 0;
    complex.prune_corners(
        a, [&](Index face, Index i) { // without a branch, which would be hard to predict
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

  /// Gathers the star of a pair of which one end is a high-valence vertex, in about as many steps
  /// as the other end and its neighbours have faces.
  void gather_at_high_valence(TriangleComplex& complex, Index a, Index b, Index its_high_valence);

  /// Calls visit(face) for each face that a contraction changes.
  template <class Visit>
  void for_each_changed(Visit visit) const {
    for (const auto* faces : {&first, &second})
      for (const StarFace& f : *faces)
        visit(f);
  }

private:
  void clear() {
    first.clear(), second.clear(), shared.clear();
    high_valence = none;
    may_meet_high_valence = false;
  }

  std::vector<Index> link_; // of the end that is no high-valence vertex
};

/// The faces of a high-valence vertex next to another vertex, found from the neighbours of that
/// vertex. Further high-valence vertices among these are searched only for the faces that are
/// needed.
class FacesAtHighValence {
public:
  /// `link`: the neighbours of the vertex `other` except the high-valence vertex, in order. The
  /// faces are added to `faces`.
  FacesAtHighValence(TriangleComplex& complex, Index high_valence, Index other,
                     const std::vector<Index>& link, AppendBuffer<StarFace>& faces)
      : complex_(complex), high_valence_(high_valence), other_(other), link_(link), faces_(faces) {}

  /// All that have a vertex of the link which is no high-valence vertex.
  void add_at_link() {
    for (Index v : link_)
      if (!complex_.high_valence_vertices().has(v))
        complex_.for_each_corner(v, [&](Index face, Index i) {
          const StarFace f = star_face_at(complex_, face, i);
          if (f.has(high_valence_) && !f.has(other_) &&
              !is_met_before(f.other_than(high_valence_), v))
            add(face);
        });
  }
  bool has_any_at(Index v) const {
    return std::any_of(faces_.begin(), faces_.end(), [v](const StarFace& f) { return f.has(v); });
  }
  /// One that has a further high-valence vertex.
  void add_one_at(Index v) {
    add_first(v, [&](const StarFace& f) { return f.has(v); });
  }
  /// Adds the face between two further high-valence vertices.
  void add_between(Index v, Index w) {
    add_first(fewer(v, w), [&](const StarFace& f) { return f.has(v) && f.has(w); });
  }

private:
  // Was the face of these two vertices met at v before w had its turn?
  bool is_met_before(Index v, Index w) const {
    return v < w && !complex_.high_valence_vertices().has(v) &&
           std::binary_search(link_.begin(), link_.end(), v);
  }

  void add(Index face) { faces_.add_if(true, star_face_from(complex_, face, high_valence_)); }

  // Returns the first face at both v and the high-valence vertex that satisfies is(f), if there is
  // one.
  template <class Is>
  void add_first(Index v, Is is) {
    const Index few = fewer(v, high_valence_);
    complex_.prune_first_corners(few);
    complex_.any_corner(few, [&](Index face, Index) {
      const auto& corners = complex_.vertices(face);
      if (std::find(corners.begin(), corners.end(), high_valence_) == corners.end())
        return false;
      const StarFace f = star_face_from(complex_, face, high_valence_);
      const bool result = is(f) && !f.has(other_);
      if (result)
        add(face);
      return result;
    });
  }

  Index fewer(Index v, Index w) const {
    return complex_.degree_bound(v) < complex_.degree_bound(w) ? v : w;
  }

  TriangleComplex& complex_;
  Index high_valence_, other_;
  const std::vector<Index>& link_;
  AppendBuffer<StarFace>& faces_;
};

QUADRILLE_NOINLINE inline void PairStar::gather_at_high_valence(TriangleComplex& complex, Index a,
                                                                Index b, Index its_high_valence) {
  clear();
  high_valence = its_high_valence;
  const Index other = high_valence == a ? b : a;
  AppendBuffer<StarFace>& of_other = high_valence == a ? second : first;
  link_.clear();
  complex.prune_corners(other, [&](Index face, Index i) {
    const StarFace f = star_face_at(complex, face, i);
    if (f.has(high_valence))
      shared.add_if(true, star_face_from(complex, face, a));
    else
      of_other.add_if(true, f);
    for (Index v : {f.second, f.third})
      if (v != high_valence)
        link_.push_back(v);
  });
  std::sort(link_.begin(), link_.end());
  link_.erase(std::unique(link_.begin(), link_.end()), link_.end());

  FacesAtHighValence faces_at(complex, high_valence, other, link_,
                              high_valence == a ? first : second);
  faces_at.add_at_link();
  const auto is_opposite = [&](Index v) {
    return std::any_of(shared.begin(), shared.end(),
                       [&](const StarFace& f) { return f.other_than(b) == v; });
  };
  for (Index v : link_)
    if (complex.high_valence_vertices().has(v) && !faces_at.has_any_at(v)) {
      if (is_opposite(v))
        faces_at.add_one_at(v);
      else
        may_meet_high_valence = true;
    }
  for (const StarFace& f : of_other)
    if (complex.high_valence_vertices().has(f.second) &&
        complex.high_valence_vertices().has(f.third))
      faces_at.add_between(f.second, f.third);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_STAR_H
