#ifndef QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_CAPS_H
#define QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_CAPS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/core/surface/polygon_cut.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A loop of edges between faces that stay and faces that are removed, and what closes it.
struct HiddenCap {
  std::vector<Index> sides; ///< half-edges of faces that stay, each begins where the last one ends
  /// Triangles of numbers of sides, which stand for their origins; the number of sides stands for
  /// an added point in the middle. They continue the faces that stay.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Vector<3> middle; ///< the added point
  bool has_middle = false;
};

/// The faces that are removed from a surface, and the loops of edges around them.
///
/// A loop only passes through *simple* vertices: their faces form one closed disc, in which those
/// that are removed are next to each other. At other vertices all faces stay if any does. So loops
/// neither touch themselves nor each other, and where a cap is put into each, a manifold stays one.
class HiddenCaps {
public:
  HiddenCaps(const SurfaceView& surface, std::vector<bool> is_removed)
      : surface_(surface), is_removed_(std::move(is_removed)), kept_at_(surface_.vertices(), 0) {
    list_faces();
    for (Index v = 0; v < surface_.vertices(); ++v)
      to_check_.push_back(v);
    for (Index face = 0; face < surface_.faces(); ++face)
      if (!is_removed_[face])
        for (const Index v : surface_.triangle(face))
          ++kept_at_[v];
    close();
  }

  const HalfEdges& surface() const { return surface_; }
  const std::vector<bool>& is_removed() const { return is_removed_; }
  const std::vector<HiddenCap>& caps() const { return caps_; }
  Vector<3> corner(const HiddenCap& cap, std::uint32_t i) const {
    return i < cap.sides.size() ? surface_.point(surface_.origin(cap.sides[i])) : cap.middle;
  }

  /// Keeps the removed faces at the vertices of some caps, by their numbers, and closes again.
  void retreat(const std::vector<std::size_t>& caps) {
    for (const std::size_t cap : caps)
      keep_around(caps_[cap]);
    close();
  }
  /// Keeps all removed faces that are connected with some caps, and closes again.
  void give_up(const std::vector<std::size_t>& caps) {
    for (const std::size_t cap : caps)
      for (const Index h : caps_[cap].sides)
        keep_connected(HalfEdges::face(surface_.twin(h)));
    close();
  }

private:
  void list_faces() {
    begins_.assign(surface_.vertices() + 1, 0);
    for (Index face = 0; face < surface_.faces(); ++face)
      for (const Index v : surface_.triangle(face))
        ++begins_[v + 1];
    for (std::size_t v = 0; v + 1 < begins_.size(); ++v)
      begins_[v + 1] += begins_[v];
    faces_at_.resize(3 * surface_.faces());
    std::vector<std::size_t> end(begins_.begin(), begins_.end() - 1);
    for (Index face = 0; face < surface_.faces(); ++face)
      for (const Index v : surface_.triangle(face))
        faces_at_[end[v]++] = face;
  }

  // Continues until each loop has a cap.
  void close() {
    do {
      while (!to_check_.empty()) {
        const Index v = to_check_.back();
        to_check_.pop_back();
        if (kept_at_[v] > 0 && kept_at_[v] < begins_[v + 1] - begins_[v])
          make_simple(v);
      }
      trace_loops();
    } while (!close_loops() || !keep_useless());
  }

  void keep(Index face) {
    if (!is_removed_[face])
      return;
    is_removed_[face] = false;
    for (const Index v : surface_.triangle(face)) {
      ++kept_at_[v];
      to_check_.push_back(v);
    }
  }

  // Only the longest run of removed faces around a vertex stays removed.
  void make_simple(Index v) {
    if (!surface_.is_inside(v)) {
      for (std::size_t i = begins_[v]; i < begins_[v + 1]; ++i)
        keep(faces_at_[i]);
      return;
    }
    around_.clear();
    surface_.for_each_out(v, [&](Index h) { around_.push_back(HalfEdges::face(h)); });
    const auto first_kept = std::find_if(around_.begin(), around_.end(),
                                         [&](Index face) { return !is_removed_[face]; });
    std::rotate(around_.begin(), first_kept, around_.end());
    std::size_t begin = 0, end = 0; // the longest run
    for (std::size_t i = 0, j = 0; i < around_.size(); i = j + 1) {
      for (j = i; j < around_.size() && is_removed_[around_[j]];)
        ++j;
      if (j - i > end - begin)
        begin = i, end = j;
    }
    for (std::size_t i = 0; i < around_.size(); ++i)
      if (i < begin || i >= end)
        keep(around_[i]);
  }

  void keep_around(const HiddenCap& cap) {
    for (const Index h : cap.sides)
      for (std::size_t v = surface_.origin(h), i = begins_[v]; i < begins_[v + 1]; ++i)
        keep(faces_at_[i]);
  }

  void keep_connected(Index face) {
    visit_connected(face, [&](Index other) {
      const bool was_removed = is_removed_[other];
      keep(other);
      return was_removed;
    });
  }
  // Calls visit(other) for a face and those connected with it, as long as it returns true.
  template <class Visit>
  void visit_connected(Index face, Visit visit) const {
    std::vector<Index> faces{face};
    while (!faces.empty()) {
      const Index last = faces.back();
      faces.pop_back();
      if (visit(last))
        for (const Index v : surface_.triangle(last))
          faces.insert(faces.end(), faces_at_.begin() + static_cast<std::ptrdiff_t>(begins_[v]),
                       faces_at_.begin() + static_cast<std::ptrdiff_t>(begins_[v + 1]));
    }
  }

  // Removed faces stay if their caps would not have fewer faces. Returns false if any do.
  bool keep_useless() {
    struct Group {
      Index first;
      std::size_t faces = 0, triangles = 0;
    };
    std::vector<Group> groups;
    std::vector<Index> group_of(surface_.faces(), none);
    for (const HiddenCap& cap : caps_) {
      const Index behind = HalfEdges::face(surface_.twin(cap.sides.front()));
      if (group_of[behind] == none) {
        groups.push_back({behind});
        visit_connected(behind, [&](Index face) {
          if (!is_removed_[face] || group_of[face] != none)
            return false;
          group_of[face] = static_cast<Index>(groups.size() - 1);
          ++groups.back().faces;
          return true;
        });
      }
      groups[group_of[behind]].triangles += cap.triangles.size();
    }
    for (const Group& group : groups)
      if (group.faces <= group.triangles)
        keep_connected(group.first);
    return to_check_.empty();
  }

  bool is_cut(Index h) const {
    const Index twin = surface_.twin(h);
    return twin != none && !is_removed_[HalfEdges::face(h)] && is_removed_[HalfEdges::face(twin)];
  }
  // The next half-edge of a loop: the kept faces at its end are next to each other.
  Index next_of_loop(Index h) const {
    for (h = HalfEdges::next(h); !is_cut(h);)
      h = HalfEdges::next(surface_.twin(h));
    return h;
  }
  void trace_loops() {
    caps_.clear();
    std::vector<bool> is_traced(3 * surface_.faces(), false);
    for (Index first = 0; first < is_traced.size(); ++first)
      if (!is_traced[first] && is_cut(first)) {
        HiddenCap& cap = caps_.emplace_back();
        Index h = first;
        do {
          is_traced[h] = true;
          cap.sides.push_back(h);
        } while ((h = next_of_loop(h)) != first);
      }
  }

  // Returns false if faces have been kept since there is no cap.
  bool close_loops() {
    for (HiddenCap& cap : caps_)
      if (!close_by_triangles(cap) && !close_by_fan(cap))
        keep_around(cap);
    return to_check_.empty();
  }

  bool close_by_triangles(HiddenCap& cap) const {
    const auto n = static_cast<std::uint32_t>(cap.sides.size());
    std::vector<Vector<3>> corners; // as the cap runs
    for (std::uint32_t i = n; i-- > 0;)
      corners.push_back(corner(cap, i));
    std::uint64_t fans = 0;
    cap.triangles = PolygonCut::triangles(corners, &fans);
    for (auto& triangle : cap.triangles)
      for (std::uint32_t& i : triangle)
        i = n - 1 - i;
    return fans == 0 && cap.triangles.size() == n - 2 && !is_lone(cap) && is_new(cap) &&
           has_areas(cap);
  }
  bool close_by_fan(HiddenCap& cap) const {
    const auto n = static_cast<std::uint32_t>(cap.sides.size());
    cap.has_middle = true;
    cap.middle = {};
    cap.triangles.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
      cap.middle = cap.middle + 1.0 / n * corner(cap, i);
      cap.triangles.push_back({(i + 1) % n, i, n});
    }
    return has_areas(cap);
  }

  // Is it the loop around a single face that stays?
  bool is_lone(const HiddenCap& cap) const {
    return cap.sides.size() == 3 && HalfEdges::face(cap.sides[0]) == HalfEdges::face(cap.sides[1]);
  }
  // No edge across the loop is one of the surface already.
  bool is_new(const HiddenCap& cap) const {
    const auto n = static_cast<std::uint32_t>(cap.sides.size());
    for (const auto& triangle : cap.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = triangle[k], j = triangle[(k + 1) % 3];
        if ((i + 1) % n == j || (j + 1) % n == i)
          continue;
        if (has_edge(surface_.origin(cap.sides[i]), surface_.origin(cap.sides[j])))
          return false;
      }
    return true;
  }
  bool has_edge(Index v, Index w) const {
    bool found = false;
    surface_.for_each_out(v, [&](Index h) {
      found |= surface_.target(h) == w &&
               !(is_removed_[HalfEdges::face(h)] && is_removed_[HalfEdges::face(surface_.twin(h))]);
    });
    return found;
  }
  bool has_areas(const HiddenCap& cap) const {
    constexpr double least = 1e-6; // of the area over the square of the longest side
    return std::all_of(cap.triangles.begin(), cap.triangles.end(), [&](const auto& triangle) {
      const Vector<3> p = corner(cap, triangle[0]), q = corner(cap, triangle[1]),
                      r = corner(cap, triangle[2]);
      const double longest =
          (std::max)({squared_length(q - p), squared_length(r - q), squared_length(p - r)});
      return squared_length(cross(q - p, r - p)) > least * least * longest * longest;
    });
  }

  HalfEdges surface_;
  std::vector<bool> is_removed_;
  std::vector<std::size_t> kept_at_, begins_; // of vertices
  std::vector<Index> faces_at_, to_check_, around_;
  std::vector<HiddenCap> caps_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_CAPS_H
