#ifndef QUADRILLE_INTERNAL_GAPS_GAP_JOINS_H
#define QUADRILLE_INTERNAL_GAPS_GAP_JOINS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/gaps/facing_walls.h>
#include <quadrille/internal/gaps/gap_refinement.h>
#include <quadrille/internal/gaps/wall_bridges.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Numbers that are merged into sets.
class MergedSets {
public:
  explicit MergedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index root(Index i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Returns whether they were in different sets. The lower root stays.
  bool merge(Index a, Index b) {
    a = root(a);
    b = root(b);
    parent_[(std::max)(a, b)] = (std::min)(a, b);
    return a != b;
  }

private:
  std::vector<Index> parent_;
};

/// Joins the components of a surface across gaps up to a size. The closest two components come
/// first, and two that hang together already are not joined again: so no handle comes.
class GapJoins {
public:
  std::size_t joined = 0; ///< pairs of components
  std::size_t open =
      0; ///< the components more than if each pair of near components had been joined
  std::vector<std::array<Index, 2>> added; ///< vertices in the middle between two others
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index>
      sources; ///< for each triangle, the input face of which it is a fragment, or at

  /// `is_kept`: empty, or of each vertex whether it keeps its faces.
  GapJoins(const SurfaceView& surface, double size, const std::vector<bool>& is_kept)
      : surface_(surface, is_kept), component_(components_of(surface)) {
    if (has_several_components(surface))
      join_components(size);
    if (joined == 0)
      keep(surface);
  }

  const HalfEdges& surface() const { return surface_; }

private:
  using Pair = std::array<Index, 2>;
  struct Place {
    double distance;
    Index vertex;
    auto operator<=>(const Place&) const = default;
  };
  using Places =
      std::map<Pair, std::vector<Place>>; // where components face each other, closest first

  static std::vector<Index> components_of(const SurfaceView& surface) {
    MergedSets sets(surface.points.size());
    for (const auto& [a, b, c] : surface.triangles) {
      sets.merge(a, b);
      sets.merge(a, c);
    }
    std::vector<Index> components;
    for (Index v = 0; v < surface.points.size(); ++v)
      components.push_back(sets.root(v));
    return components;
  }
  bool has_several_components(const SurfaceView& surface) const {
    return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const auto& t) {
      return component_[t[0]] != component_[surface.triangles.front()[0]];
    });
  }

  void join_components(double size) {
    std::optional<FacingWalls> walls(std::in_place, surface_, component_, size);
    GapRefinement refinement(surface_, component_, *walls);
    if (!refinement.added.empty())
      walls.emplace(surface_, component_, size);
    WallBridges bridges(surface_, component_, *walls);
    join_closest_first(bridges, places_of(bridges), size);
    added = std::move(refinement.added);
    bridges.for_each_face([&](const std::array<Index, 3>& triangle, Index like) {
      triangles.push_back(triangle);
      sources.push_back(refinement.sources[like]);
    });
  }

  Places places_of(const WallBridges& bridges) const {
    Places places;
    for (Index v = 0; v < surface_.vertices(); ++v)
      if (const FacingWall& wall = bridges.wall(v); wall.component != none)
        places[{(std::min)(component_[v], wall.component),
                (std::max)(component_[v], wall.component)}]
            .push_back({wall.distance, v});
    for (auto& [pair, at] : places)
      std::sort(at.begin(), at.end());
    return places;
  }

  void join_closest_first(WallBridges& bridges, const Places& places, double size) {
    std::vector<std::pair<Place, Pair>> order;
    for (const auto& [pair, at] : places)
      order.emplace_back(at.front(), pair);
    std::sort(order.begin(), order.end());
    MergedSets hang_together(surface_.vertices()), are_near(surface_.vertices());
    for (const auto& [place, pair] : order) {
      open += are_near.merge(pair[0], pair[1]);
      if (hang_together.root(pair[0]) == hang_together.root(pair[1]))
        continue;
      const auto wide = [&](Index v) { return bridges.build_wide(v); };
      const auto narrow = [&](Index v) { return bridges.build_narrow(v); };
      if (is_joined(places.at(pair), size, wide) || is_joined(places.at(pair), size, narrow)) {
        hang_together.merge(pair[0], pair[1]);
        ++joined;
      }
    }
    open -= joined;
  }

  // Tries the closest places that are apart from each other. build(v) returns nothing where it does
  // not try.
  template <class Build>
  bool is_joined(const std::vector<Place>& places, double size, Build build) const {
    std::vector<Vector<3>> failed;
    for (const Place& place : places) {
      const Vector<3>& at = surface_.point(place.vertex);
      if (std::any_of(failed.begin(), failed.end(), [&](const Vector<3>& other) {
            return squared_distance(at, other) < size * size;
          }))
        continue;
      const std::optional<bool> is_built = build(place.vertex);
      if (is_built && *is_built)
        return true;
      if (is_built)
        failed.push_back(at);
      if (failed.size() == most_places)
        return false;
    }
    return false;
  }

  void keep(const SurfaceView& surface) {
    added.clear();
    triangles.assign(surface.triangles.begin(), surface.triangles.end());
    sources.resize(triangles.size());
    std::iota(sources.begin(), sources.end(), Index{0});
  }

  static constexpr std::size_t most_places = 8;

  HalfEdges surface_;
  std::vector<Index> component_; // of each vertex, by its lowest one
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_GAP_JOINS_H
