#ifndef QUADRILLE_INTERNAL_CORE_STATE_CLEANUP_H
#define QUADRILLE_INTERNAL_CORE_STATE_CLEANUP_H

#include <quadrille/internal/core/complex/reverse_faces.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/state/scratch.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Calls visit(v) for each vertex that no face of the star of the pair (a, b) has but those that
/// vanish with its contraction, and ends when it returns true. Returns whether it did.
template <class Visit>
bool any_cut_off(const PairStar& star, Index b, Visit visit) {
  const auto is_at = [](Index v) { return [v](const StarFace& f) { return f.has(v); }; };
  return std::any_of(star.shared.begin(), star.shared.end(), [&](const StarFace& f) {
    const Index v = f.other_than(b);
    return std::none_of(star.first.begin(), star.first.end(), is_at(v)) &&
           std::none_of(star.second.begin(), star.second.end(), is_at(v)) && visit(v);
  });
}
template <class Visit>
void for_each_cut_off(const PairStar& star, Index b, Visit visit) {
  any_cut_off(star, b, [&](Index v) {
    visit(v);
    return false;
  });
}

/// Does the contraction of a pair take the last face of a vertex that is fixed, where topology is
/// free? The faces that vanish may be the last of the pair, or of their third vertex and its edge
/// to the pair.
template <class IsFixed>
bool takes_a_fixed_vertex_away(const PairStar& star, Index a, Index b, IsFixed is_fixed) {
  return (star.first.empty() && star.second.empty() && (is_fixed(a) || is_fixed(b))) ||
         any_cut_off(star, b, is_fixed);
}

/// How many faces and vertices a contraction takes.
struct Loss {
  std::size_t faces, vertices;
};

/// The most that contracting the star may take where topology is free: duplicate faces go too, and
/// what is isolated then.
inline Loss most_loss(const PairStar& star, const ReverseFaces& reverse_faces) {
  const std::size_t duplicates = (std::min)(star.first.size(), star.second.size());
  return {reverse_faces.count_all(star.shared) + (reverse_faces.is_empty() ? 1 : 2) * duplicates,
          star.shared.size() + 2};
}

/// Removes and counts what contractions leave with free topology: duplicate faces, and vertices
/// without a face.
class Cleanup {
public:
  /// `labels`: of each face; or empty.
  Cleanup(TriangleComplex& complex, Scratch& scratch, const Array<Index>& labels)
      : complex_(complex), scratch_(scratch), labels_(labels) {}

  /// The faces of both ends of the star go.
  void remove_shared_faces() {
    scratch_.duplicates.clear();
    for (const StarFace& f : scratch_.star.shared)
      complex_.remove_face(f.face);
    scratch_.counters.faces += complex_.reverse_faces().count_all(scratch_.star.shared);
    scratch_.counters.non_edge_contractions += scratch_.star.shared.empty();
  }

  /// Removes all but one of the faces with the same three vertices that the contraction of the star
  /// has changed.
  void remove_duplicate_faces() {
    gather_changed();
    remove_duplicates();
  }

  /// A vertex whose last face was removed with the contraction of the star is removed too. If the
  /// list of a vertex that has been contracted is not up to date, none of these may be cut off.
  void remove_isolated_vertices(Index b) {
    const PairStar& star = scratch_.star;
    for_each_cut_off(star, b, [&](Index v) { remove_if_isolated(v); });
    scratch_.counters.vertices += star.first.empty() && star.second.empty();
  }

  /// How many faces and vertices the contraction of the star will take.
  Loss loss(Index b) {
    const PairStar& star = scratch_.star;
    Loss loss{complex_.reverse_faces().count_all(star.shared), 1};
    gather_changed();
    for_each_duplicate(
        [&](Index face, Index) { loss.faces += complex_.reverse_faces().count(face); });
    for_each_cut_off(star, b, [&](Index v) { loss.vertices += !has_others(v); });
    loss.vertices += star.first.empty() && star.second.empty();
    return loss;
  }

private:
  void gather_changed() {
    const PairStar& star = scratch_.star;
    scratch_.faces.assign(star.first.begin(), star.first.end());
    scratch_.faces.insert(scratch_.faces.end(), star.second.begin(), star.second.end());
  }

  void remove_duplicates() {
    for_each_duplicate([this](Index face, Index left) {
      complex_.remove_face(face);
      scratch_.duplicates.push_back(face);
      scratch_.counters.faces += complex_.reverse_faces().count(face);
      scratch_.counters.doubled_labels += !labels_.empty() && labels_[face] != labels_[left];
    });
  }

  // Visits the gathered faces, at one vertex, that have the same other two vertices, all but the
  // first, which is left: visit(face, left).
  template <class Visit>
  void for_each_duplicate(Visit visit) {
    std::vector<StarFace>& faces = scratch_.faces;
    for (StarFace& f : faces)
      if (f.third < f.second)
        std::swap(f.second, f.third);
    std::sort(faces.begin(), faces.end(), [](const StarFace& a, const StarFace& b) {
      return std::tie(a.second, a.third, a.face) < std::tie(b.second, b.third, b.face);
    });
    for (std::size_t i = 1, first = 0; i < faces.size(); ++i)
      if (faces[first].second == faces[i].second && faces[first].third == faces[i].third)
        visit(faces[i].face, faces[first].face);
      else
        first = i;
  }

  void prune(Index v) {
    if (complex_.high_valence_vertices().has(v))
      complex_.prune_first_corners(v);
    else
      complex_.prune_corners(v);
  }

  // Has a vertex other faces than those that vanish?
  bool has_others(Index v) {
    prune(v);
    return complex_.any_corner(v, [&](Index face, Index) {
      const auto is_it = [face](const StarFace& f) { return f.face == face; };
      const auto& vanishing = scratch_.star.shared;
      return std::none_of(vanishing.begin(), vanishing.end(), is_it);
    });
  }

  void remove_if_isolated(Index v) {
    if (!complex_.has_faces(v))
      return;
    prune(v);
    scratch_.counters.vertices += !complex_.has_faces(v);
  }

  TriangleComplex& complex_;
  Scratch& scratch_;
  const Array<Index>& labels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_CLEANUP_H
