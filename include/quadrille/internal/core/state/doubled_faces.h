#ifndef QUADRILLE_INTERNAL_CORE_STATE_DOUBLED_FACES_H
#define QUADRILLE_INTERNAL_CORE_STATE_DOUBLED_FACES_H

#include <quadrille/internal/core/appearance/labels_by_face.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/reverse_faces.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/state/counters.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Joins the labels of faces and of their reverses into labels of both sides. There is a label
/// boundary where they change, or where double-sided faces begin. `labels`: of each input face; or
/// empty.
inline void join_labels_of_reverse_faces(const TriangleComplex& complex, const InputIndices& faces,
                                         Array<Index>& labels) {
  const ReverseFaces& reverse_faces = complex.reverse_faces();
  bool is_partial = false; // have some faces a reverse face, and some none?
  for_each_face(complex, [&](Index face) { is_partial |= !reverse_faces.has(face); });
  if (labels.empty() && !is_partial)
    return;
  std::map<std::pair<Index, Index>, Index> numbers;
  const auto label = [&](Index face) { return labels.empty() ? Index{0} : labels[face]; };
  Array<Index> joined(faces.input_count(), Index{0}, complex.arena());
  for_each_face(complex, [&](Index face) {
    const Index forward = faces[face];
    const Index reverse = reverse_faces.has(face) ? label(reverse_faces.input_face(face)) : none;
    joined[forward] =
        numbers.try_emplace({label(forward), reverse}, static_cast<Index>(numbers.size()))
            .first->second;
  });
  labels = std::move(joined);
}

/// Faces on the same three vertices, before the first contraction. One of those with the same
/// orientation is left, the first. Two of opposite orientation are the sides of a double-sided
/// face: both are kept as one face with a reverse.
class DoubledFaces {
public:
  /// `labels`: of each face; or empty.
  DoubledFaces(TriangleComplex& complex, const Array<Index>& labels, Counters& counters,
               Threads threads)
      : complex_(complex), labels_(labels), counters_(counters), threads_(threads),
        partner_(complex.arena()) {}

  /// Removes all but one, whatever their orientation, and counts those that are removed.
  void remove() {
    for_each_group([this](const auto& group) { remove_but_first(group); });
  }

  /// Removes all but one of each way round, and pairs those. `inputs`: of the faces.
  void pair_up(const InputIndices& inputs) {
    for_each_group([this](std::vector<Side>& group) {
      const auto turned = std::stable_partition(
          group.begin(), group.end(),
          [is_turned = group[0].turned](const Side& s) { return s.turned == is_turned; });
      const std::vector<Side> reverse_faces(turned, group.end());
      group.erase(turned, group.end());
      remove_but_first(group);
      remove_but_first(reverse_faces);
      if (!reverse_faces.empty())
        pair(group[0].face, reverse_faces[0].face);
    });
    if (!partner_.empty())
      choose_forward_faces(inputs);
  }

private:
  // A face at its lowest vertex: the other two in order, and were they the other way round?
  struct Side {
    Index second, third, face;
    bool turned;

    bool is_on_same_vertices(const Side& other) const {
      return second == other.second && third == other.third;
    }
    friend bool operator<(const Side& a, const Side& b) {
      return std::tie(a.second, a.third, a.face) < std::tie(b.second, b.third, b.face);
    }
  };

  // The faces of which a vertex is the lowest, in order.
  void gather(Index v, std::vector<Side>& sides) const {
    sides.clear();
    complex_.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex_, face, i);
      const bool is_turned = f.third < f.second;
      if (v < (is_turned ? f.third : f.second))
        sides.push_back(is_turned ? Side{f.third, f.second, face, true}
                                  : Side{f.second, f.third, face, false});
    });
    std::sort(sides.begin(), sides.end());
  }

  // The vertices that are the lowest of two faces on the same vertices: as a rule there are none.
  std::vector<Index> lowest_vertices() const {
    std::vector<std::vector<Index>> found(unsigned{threads_});
    for_each_range(threads_, complex_.vertex_capacity(),
                   [&](const auto& range, std::size_t worker) {
                     std::vector<Side> sides;
                     for (Index v = range.begin; v < range.end; ++v) {
                       gather(v, sides);
                       const auto is_same = [](const Side& s, const Side& t) {
                         return s.is_on_same_vertices(t);
                       };
                       if (std::adjacent_find(sides.begin(), sides.end(), is_same) != sides.end())
                         found[worker].push_back(v);
                     }
                   });
    std::vector<Index> all;
    for (const std::vector<Index>& some : found)
      all.insert(all.end(), some.begin(), some.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  // Calls visit(group) for all faces of the same vertices, if there are two or more, in the order
  // of their numbers.
  template <class Visit>
  void for_each_group(Visit visit) {
    std::vector<Side> sides, group;
    for (Index v : lowest_vertices()) {
      gather(v, sides);
      for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end = std::find_if(
            begin, sides.end(), [&](const Side& s) { return !s.is_on_same_vertices(*begin); });
        if (end - begin > 1) {
          group.assign(begin, end);
          visit(group);
        }
        begin = end;
      }
    }
  }

  void remove_but_first(const std::vector<Side>& group) {
    for (std::size_t i = 1; i < group.size(); ++i) {
      complex_.remove_face(group[i].face);
      ++counters_.doubled_faces;
      counters_.doubled_labels +=
          !labels_.empty() && labels_[group[i].face] != labels_[group[0].face];
    }
  }

  void pair(Index face, Index other) {
    if (partner_.empty())
      partner_.resize(complex_.face_capacity(), none);
    partner_[face] = other;
    partner_[other] = face;
  }

  // Forward faces are oriented like their neighbours, as far as possible: first like those without
  // a reverse, which have no choice, then like the first double-sided face.
  void choose_forward_faces(const InputIndices& inputs) {
    Array<Index> reverse(complex_.face_capacity(), none, complex_.arena());
    is_chosen_.assign(complex_.face_capacity(), false);
    for (const bool has_partner : {false, true})
      for (Index face = 0; face < complex_.face_capacity(); ++face)
        if (!complex_.is_removed(face) && (partner_[face] != none) == has_partner)
          spread_from(face);
    for (Index face = 0; face < complex_.face_capacity(); ++face)
      if (is_chosen_[face] && partner_[face] != none) {
        reverse[face] = 4 * inputs[partner_[face]] + place_of_first(face, partner_[face]);
        complex_.remove_face(partner_[face]);
      }
    for (Index v = 0; v < complex_.vertex_capacity(); ++v)
      complex_.prune_corners(v);
    complex_.set_reverse_faces(ReverseFaces(std::move(reverse)));
  }

  bool is_decided(Index face) const {
    return is_chosen_[face] || (partner_[face] != none && is_chosen_[partner_[face]]);
  }

  // Over edges at which just two double-sided faces meet.
  void spread_from(Index face) {
    if (is_decided(face))
      return;
    std::vector<Index> chosen{face};
    is_chosen_[face] = true;
    while (!chosen.empty()) {
      const auto corners = complex_.vertices(chosen.back());
      chosen.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Index next = face_beyond(corners[i], corners[(i + 1) % 3]);
        if (next == none || is_decided(next))
          continue;
        is_chosen_[next] = true;
        chosen.push_back(next);
      }
    }
  }

  // The side of the other double-sided face at an edge that runs against vw, if it has two sides
  // and is the only one.
  Index face_beyond(Index v, Index w) const {
    const bool is_v_smaller = complex_.degree_bound(v) < complex_.degree_bound(w);
    const Index end = is_v_smaller ? v : w, other = is_v_smaller ? w : v;
    Index beyond = none;
    std::size_t halves = 0; // a face without a reverse face counts as two
    complex_.for_each_corner(end, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex_, face, i);
      if (!f.has(other))
        return;
      halves += partner_[face] == none ? 2 : 1;
      const bool runs_from_end = f.second == other;
      if (partner_[face] != none && runs_from_end == (end == w) && !is_decided(face))
        beyond = face;
    });
    return halves == 4 ? beyond : none;
  }

  // Returns the corner of a forward face that is at the first vertex of its reverse.
  Index place_of_first(Index forward, Index reverse) const {
    const auto& corners = complex_.vertices(forward);
    return static_cast<Index>(
        std::find(corners.begin(), corners.end(), complex_.vertices(reverse)[0]) - corners.begin());
  }

  TriangleComplex& complex_;
  const Array<Index>& labels_;
  Counters& counters_;
  Threads threads_;
  Array<Index> partner_; // of each face, the one on its other side; empty if there is none
  std::vector<bool> is_chosen_;
};

/// Joins faces on the same vertices before the first contraction: one is left, or one with a
/// reverse if the input may have them; labels then describe both sides.
template <std::size_t N>
void resolve_doubled_faces(TriangleComplex& complex, const InputIndices& faces,
                           SurfaceInput<N>& input, Counters& counters, Threads threads) {
  const Array<Index> labels = labels_by_face(input.labels, faces, complex);
  DoubledFaces doubled(complex, labels, counters, threads);
  if (!input.may_have_reverse_faces)
    return doubled.remove();
  doubled.pair_up(faces);
  if (!complex.reverse_faces().is_empty())
    join_labels_of_reverse_faces(complex, faces, input.labels);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_DOUBLED_FACES_H
