#ifndef QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_GROUPS_H
#define QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_GROUPS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A face that is connected to others by edges, all of them hidden, and what these enclose.
struct FaceGroup {
  std::vector<std::size_t> faces;
  double area = 0;
  double volume = 0; ///< signed; by a surface that is not closed, as seen from its first vertex
  double diagonal = 0;
  bool is_closed = true;
};

/// The groups into which the chosen faces of a surface fall.
class FaceGroups {
public:
  /// Faces are connected if they have two points in common.
  FaceGroups(const SurfaceView& surface, const std::vector<bool>& is_chosen)
      : surface_(surface), is_chosen_(is_chosen), parent_(surface.triangles.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
    list_sides();
    join();
    gather();
    for (FaceGroup& group : groups_)
      measure(group);
    std::stable_sort(groups_.begin(), groups_.end(),
                     [](const FaceGroup& a, const FaceGroup& b) { return a.area > b.area; });
  }

  /// Returns the groups, those of a large area first.
  std::vector<FaceGroup> take() { return std::move(groups_); }
  /// Returns the number of edges that chosen faces share with others.
  std::size_t cut_edges() const { return cut_edges_; }

  static double area(const SurfaceView& surface, std::size_t face) {
    const auto [a, b, c] = surface.triangles[face];
    const auto& at = surface.points;
    return 0.5 * std::sqrt(squared_length(cross(at[b] - at[a], at[c] - at[a])));
  }

private:
  struct Side {
    Index low, high, face;
    bool is_up; // does the face run along the edge from `low` to `high`?
  };

  void list_sides() {
    for (Index face = 0; face < surface_.triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = surface_.triangles[face][i], b = surface_.triangles[face][(i + 1) % 3];
        if (a != b)
          sides_.push_back({(std::min)(a, b), (std::max)(a, b), face, a < b});
      }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.face, a.is_up) < std::tie(b.low, b.high, b.face, b.is_up);
    });
  }

  // A group is open at an edge along which its faces run more often one way than the other.
  void join() {
    std::vector<Index> open;
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      Index first = none;
      int up = 0;
      bool has_other = false;
      for (; end < sides_.size() && are_equal(sides_[begin], sides_[end]); ++end) {
        const Side& side = sides_[end];
        if (!is_chosen_[side.face]) {
          has_other = true;
          continue;
        }
        up += side.is_up ? 1 : -1;
        if (first == none)
          first = side.face;
        parent_[root(side.face)] = root(first);
      }
      cut_edges_ += up != 0 && has_other ? 1 : 0;
      if (up != 0)
        open.push_back(first);
    }
    sides_ = {};
    is_open_.assign(parent_.size(), false);
    for (const Index face : open)
      is_open_[root(face)] = true;
  }

  static bool are_equal(const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; }

  Index root(Index face) {
    while (parent_[face] != face)
      face = parent_[face] = parent_[parent_[face]];
    return face;
  }

  void gather() {
    std::vector<Index> number(parent_.size(), none);
    for (Index face = 0; face < parent_.size(); ++face) {
      if (!is_chosen_[face])
        continue;
      const Index top = root(face);
      if (number[top] == none) {
        number[top] = static_cast<Index>(groups_.size());
        groups_.emplace_back().is_closed = !is_open_[top];
      }
      groups_[number[top]].faces.push_back(face);
    }
  }

  void measure(FaceGroup& group) const {
    const auto& at = surface_.points;
    const Vector<3> place = at[surface_.triangles[group.faces.front()][0]];
    Box<3> box = Box<3>::none();
    for (const std::size_t face : group.faces) {
      const auto [a, b, c] = surface_.triangles[face];
      group.area += area(surface_, face);
      group.volume += dot(at[a] - place, cross(at[b] - place, at[c] - place)) / 6;
      for (const Index v : {a, b, c})
        box.add(at[v]);
    }
    group.diagonal = box.diagonal();
  }

  SurfaceView surface_;
  const std::vector<bool>& is_chosen_;
  std::vector<Side> sides_;
  std::vector<Index> parent_;
  std::vector<bool> is_open_;
  std::vector<FaceGroup> groups_;
  std::size_t cut_edges_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_GROUPS_H
