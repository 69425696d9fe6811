#ifndef QUADRILLE_EXAMPLES_GLTF_MEETINGS_H
#define QUADRILLE_EXAMPLES_GLTF_MEETINGS_H

#include "placement.h"
#include "surface.h"
#include "transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// A point of one of several surfaces.
struct SurfacePoint {
  std::size_t surface;
  std::uint32_t point;

  friend auto operator<=>(const SurfacePoint&, const SurfacePoint&) = default;
};

/// Where borders of surfaces meet in a scene.
struct GltfMeetings {
  std::vector<std::vector<SurfacePoint>> joined; ///< points of different surfaces that are one
  std::vector<SurfacePoint> held; ///< those that meet others in a way that no move keeps
};

/// Finds points of borders that are at one place in the scene, up to rounding.
///
/// Surfaces that are shown once move there together. A surface that is shown more than once may
/// meet a different one at each of its places, or itself: it is held there, as are those it meets.
class GltfMeetingFinder {
public:
  static GltfMeetings find(const std::vector<GltfSurface>& surfaces,
                           const std::vector<const GltfPlacement*>& placements) {
    GltfMeetingFinder finder(surfaces, placements);
    finder.collect();
    finder.unite();
    return finder.meetings();
  }

private:
  /// A point of a border at one of its places.
  struct Entry {
    SurfacePoint source;
    std::size_t instance; ///< a number of its own for each of each surface
    Vector place;
    double rounding;
  };
  using Cell = std::array<std::int64_t, 3>;

  GltfMeetingFinder(const std::vector<GltfSurface>& surfaces,
                    const std::vector<const GltfPlacement*>& placements)
      : surfaces_(surfaces), placements_(placements) {}

  void collect() {
    std::size_t instance = 0;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const std::vector<std::uint32_t> border = boundary_of(surfaces_[s]);
      for (const Transform& transform : placements_[s]->instances) {
        for (const std::uint32_t point : border) {
          const Vector local = surfaces_[s].place(point);
          entries_.push_back({{s, point},
                              instance,
                              transform(local),
                              transform == Transform() ? 0 : transform.rounding(local)});
          widest_ = std::max(widest_, entries_.back().rounding);
        }
        ++instance;
      }
    }
  }

  /// The points of edges that one triangle has.
  static std::vector<std::uint32_t> boundary_of(const GltfSurface& surface) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& triangle : surface.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        edges.push_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    std::set<std::uint32_t> points;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if ((i == 0 || edges[i - 1] != edges[i]) &&
          (i + 1 == edges.size() || edges[i + 1] != edges[i])) {
        points.insert(edges[i].first);
        points.insert(edges[i].second);
      }
    return {points.begin(), points.end()};
  }

  std::size_t root(std::size_t entry) {
    while (roots_[entry] != entry)
      entry = roots_[entry] = roots_[roots_[entry]];
    return entry;
  }

  /// Entries are looked up by cells of a grid that are wider than what rounding can do.
  void unite() {
    roots_.resize(entries_.size());
    std::iota(roots_.begin(), roots_.end(), std::size_t{0});
    if (widest_ == 0)
      return unite_equal();
    std::vector<std::pair<Cell, std::size_t>> cells;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      cells.emplace_back(cell_of(entries_[i].place), i);
    std::sort(cells.begin(), cells.end());
    for (const auto& [cell, i] : cells)
      for (int k = 0; k < 9; ++k) { // rows of three cells
        const Cell first{cell[0] + k % 3 - 1, cell[1] + k / 3 - 1, cell[2] - 1};
        auto other = std::lower_bound(cells.begin(), cells.end(), std::pair(first, std::size_t{0}));
        for (; other != cells.end() && other->first[0] == first[0] && other->first[1] == first[1] &&
               other->first[2] <= first[2] + 2;
             ++other)
          if (other->second < i && are_one(entries_[i], entries_[other->second]))
            roots_[std::max(root(i), root(other->second))] = std::min(root(i), root(other->second));
      }
  }

  void unite_equal() {
    std::map<Vector, std::size_t> firsts;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      roots_[i] = firsts.try_emplace(entries_[i].place, i).first->second;
  }

  Cell cell_of(const Vector& place) const {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i)
      cell[i] =
          static_cast<std::int64_t>(std::clamp(std::floor(place[i] / (2 * widest_)), -1e15, 1e15));
    return cell;
  }

  static bool are_one(const Entry& a, const Entry& b) {
    const double most = a.rounding + b.rounding;
    return std::abs(a.place[0] - b.place[0]) <= most && std::abs(a.place[1] - b.place[1]) <= most &&
           std::abs(a.place[2] - b.place[2]) <= most;
  }

  GltfMeetings meetings() {
    std::map<std::size_t, std::vector<const Entry*>> groups;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      groups[root(i)].push_back(&entries_[i]);
    std::set<SurfacePoint> held;
    for (const auto& [root, group] : groups)
      if (meets_another(group))
        (can_join(group) ? joined_ : held_).push_back(points_of(group));
    hold_doubled();
    for (const auto& group : held_)
      held.insert(group.begin(), group.end());
    return {std::move(joined_), {held.begin(), held.end()}};
  }

  static bool meets_another(const std::vector<const Entry*>& group) {
    return std::any_of(group.begin(), group.end(), [&](const Entry* entry) {
      return entry->instance != group.front()->instance;
    });
  }
  bool can_join(const std::vector<const Entry*>& group) const {
    std::set<std::size_t> instances;
    for (const Entry* entry : group)
      instances.insert(entry->instance);
    return instances.size() == group.size() &&
           std::all_of(group.begin(), group.end(), [&](const Entry* entry) {
             return placements_[entry->source.surface]->is_single();
           });
  }
  static std::vector<SurfacePoint> points_of(const std::vector<const Entry*>& group) {
    std::vector<SurfacePoint> points;
    for (const Entry* entry : group)
      points.push_back(entry->source);
    return points;
  }

  /// Triangles of two surfaces that would have the same corners stay two: these are held.
  void hold_doubled() {
    std::map<SurfacePoint, std::size_t> group_of;
    for (std::size_t g = 0; g < joined_.size(); ++g)
      for (const SurfacePoint& point : joined_[g])
        group_of.emplace(point, g);
    std::set<std::size_t> doubled;
    std::set<std::array<std::size_t, 3>> known;
    for (std::size_t s = 0; s < surfaces_.size() && !group_of.empty(); ++s)
      for (const auto& triangle : surfaces_[s].triangles) {
        std::array<std::size_t, 3> groups{};
        bool is_joined = true;
        for (std::size_t i = 0; i < 3 && is_joined; ++i) {
          const auto found = group_of.find({s, triangle[i]});
          is_joined = found != group_of.end();
          groups[i] = is_joined ? found->second : 0;
        }
        std::sort(groups.begin(), groups.end());
        if (is_joined && !known.insert(groups).second)
          doubled.insert(groups.begin(), groups.end());
      }
    std::vector<std::vector<SurfacePoint>> joined;
    for (std::size_t g = 0; g < joined_.size(); ++g)
      (doubled.contains(g) ? held_ : joined).push_back(std::move(joined_[g]));
    joined_ = std::move(joined);
  }

  const std::vector<GltfSurface>& surfaces_;
  const std::vector<const GltfPlacement*>& placements_;
  std::vector<Entry> entries_;
  double widest_ = 0;              // of what rounding can do to the entries
  std::vector<std::size_t> roots_; // of groups of entries
  std::vector<std::vector<SurfacePoint>> joined_, held_;
};

} // namespace quadrille_examples

#endif
