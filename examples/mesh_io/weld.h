#ifndef QUADRILLE_EXAMPLES_MESH_IO_WELD_H
#define QUADRILLE_EXAMPLES_MESH_IO_WELD_H

#include "../mesh_io.h"
#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

template <class Value>
void keep_values(std::vector<Value>& values, const std::vector<bool>& kept) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (kept[i])
      values[count++] = values[i];
  values.resize(count);
}

/// Removes the points that are not `kept`; no triangle uses them.
inline void keep_points(IndexedMesh& mesh, const std::vector<bool>& kept) {
  keep_values(mesh.points, kept);
  keep_values(mesh.colors, kept);
  keep_values(mesh.texture_coordinates, kept);
  for (NamedNumbers& numbers : mesh.vertex_numbers)
    keep_values(numbers.values, kept);
  std::vector<std::uint32_t> new_index(kept.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    new_index[i] = count;
    count += kept[i];
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      corner = new_index[corner];
}

/// Removes the triangles that are not `kept`, with what belongs to them. Returns how many went.
inline std::size_t keep_triangles(IndexedMesh& mesh, const std::vector<bool>& kept) {
  const auto gone = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (gone == 0)
    return 0;
  keep_values(mesh.triangles, kept);
  keep_values(mesh.corner_textures.triples, kept);
  keep_values(mesh.corner_normals.triples, kept);
  keep_values(mesh.parts.of_faces, kept);
  for (NamedNumbers& numbers : mesh.face_numbers)
    keep_values(numbers.values, kept);
  return gone;
}

/// The order of vertices by what they have beside their place.
class AttributeOrder {
public:
  explicit AttributeOrder(const IndexedMesh& mesh) : mesh_(mesh) {}

  bool operator()(std::uint32_t a, std::uint32_t b) const {
    const auto of_a = of(a), of_b = of(b);
    if (of_a != of_b)
      return of_a < of_b;
    for (const NamedNumbers& numbers : mesh_.vertex_numbers)
      if (const auto bits_a = bits_of(numbers.values[a]), bits_b = bits_of(numbers.values[b]);
          bits_a != bits_b)
        return bits_a < bits_b;
    return false;
  }

private:
  /// Unlike numbers these have an order even where one is none.
  static std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }

  std::pair<Color, std::array<double, 2>> of(std::uint32_t v) const {
    return {mesh_.colors.empty() ? Color{} : mesh_.colors[v], mesh_.texture_coordinates.empty()
                                                                  ? std::array<double, 2>{}
                                                                  : mesh_.texture_coordinates[v]};
  }

  const IndexedMesh& mesh_;
};

struct Welded {
  std::size_t vertices = 0; ///< that went
  std::size_t unlike = 0;   ///< of those, with other attributes than the first
};

/// Of the points at one place, the first stays, with its attributes; unless all are to be welded,
/// of those that are alike. CGAL's `merge_duplicate_points_in_polygon_soup` knows of no attributes.
inline Welded weld_points(IndexedMesh& mesh, Weld weld) {
  const std::vector<Point>& points = mesh.points;
  const AttributeOrder attributes_before(mesh);
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    return weld == Weld::always || points[a] != points[b] ? points[a] < points[b]
                                                          : attributes_before(a, b);
  };
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(), is_before);

  std::vector<std::uint32_t> first(points.size()); // of the points that become one
  std::vector<bool> kept(points.size());
  Welded welded;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t v = order[i];
    kept[v] = i == 0 || is_before(order[i - 1], v);
    first[v] = kept[v] ? v : first[order[i - 1]];
    welded.vertices += !kept[v];
    welded.unlike += attributes_before(first[v], v) || attributes_before(v, first[v]);
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      corner = first[corner];
  keep_points(mesh, kept);
  return welded;
}

/// The triangles with their corners in order, but one of two that run against each other on the
/// same vertices: these are the sides of a sheet.
inline std::vector<std::array<std::uint32_t, 3>> sorted_fronts(const IndexedMesh& mesh) {
  struct Side {
    std::array<std::uint32_t, 3> corners;
    bool is_turned;
    bool operator<(const Side& other) const {
      return std::tie(corners, is_turned) < std::tie(other.corners, other.is_turned);
    }
  };
  std::vector<Side> sides;
  for (auto t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    sides.push_back({t, t[2] < t[1]});
    std::sort(sides.back().corners.begin(), sides.back().corners.end());
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<std::uint32_t, 3>> fronts;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool is_back = i > 0 && sides[i].corners == sides[i - 1].corners && sides[i].is_turned &&
                         !sides[i - 1].is_turned;
    if (!is_back)
      fronts.push_back(sides[i].corners);
  }
  return fronts;
}

/// How many edges of more than two faces there are, and faces with the vertices of another one. The
/// two sides of a sheet are one face.
inline std::size_t count_overfull(const IndexedMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  const std::vector<std::array<std::uint32_t, 3>> faces = sorted_fronts(mesh);
  for (const auto& t : faces) {
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
  }
  std::sort(edges.begin(), edges.end());
  std::size_t count = 0;
  for (std::size_t i = 2; i < edges.size(); ++i)
    count += edges[i] == edges[i - 2];
  for (std::size_t i = 1; i < faces.size(); ++i)
    count += faces[i] == faces[i - 1];
  return count;
}

/// Makes vertices one that are alike in all that is kept, as programs split them where normals
/// differ; but not if sheets that only touch would grow together. Returns how many went.
inline std::size_t weld_split_normals(IndexedMesh& mesh) {
  IndexedMesh welded = mesh;
  const std::size_t count = weld_points(welded, Weld::loose_faces).vertices;
  if (count == 0 || count_overfull(welded) > count_overfull(mesh))
    return 0;
  mesh = std::move(welded);
  return count;
}

/// Finds seams along which a surface is cut: see count_open_seams().
class OpenSeams {
public:
  static std::size_t count(const IndexedMesh& mesh) {
    OpenSeams seams(mesh);
    seams.find_places();
    return seams.places_.empty() ? 0 : seams.count_edges();
  }

private:
  using Edge = std::array<std::uint32_t, 2>;

  explicit OpenSeams(const IndexedMesh& mesh) : mesh_(mesh) {}

  /// The vertices that may lie on a boundary. Around others the edges that faces enter and leave by
  /// are the same, and so are the sums of their scrambled ends.
  std::vector<std::uint32_t> candidates() const {
    const auto scrambled = [](std::uint64_t v) {
      v = (v + 1) * 0x9E3779B97F4A7C15U;
      return v ^ (v >> 29);
    };
    std::vector<std::uint64_t> sums(mesh_.points.size());
    for (const auto& [a, b, c] : mesh_.triangles) {
      sums[a] += scrambled(b) - scrambled(c);
      sums[b] += scrambled(c) - scrambled(a);
      sums[c] += scrambled(a) - scrambled(b);
    }
    std::vector<std::uint32_t> found;
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (sums[v] != 0)
        found.push_back(static_cast<std::uint32_t>(v));
    return found;
  }

  /// Gives the candidates that lie where another does the number of their place.
  void find_places() {
    std::vector<std::uint32_t> order = candidates();
    const auto& points = mesh_.points;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (points[order[i - 1]] != points[order[i]])
        continue;
      places_.resize(points.size(), nowhere);
      if (places_[order[i - 1]] == nowhere)
        places_[order[i - 1]] = order[i - 1];
      places_[order[i]] = places_[order[i - 1]];
    }
  }

  std::size_t count_edges() const {
    const std::vector<Edge> edges = boundary_edges();
    std::vector<Edge> places;
    for (const auto& [a, b] : edges)
      places.push_back({std::min(places_[a], places_[b]), std::max(places_[a], places_[b])});
    std::sort(places.begin(), places.end());
    std::size_t count = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      count += (i > 0 && places[i] == places[i - 1]) ||
               (i + 1 < places.size() && places[i] == places[i + 1]);
    return count;
  }

  /// Those of one face, of which both ends have a number.
  std::vector<Edge> boundary_edges() const {
    std::vector<Edge> edges, single;
    for (const auto& t : mesh_.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto a = t[i], b = t[(i + 1) % 3];
            places_[a] != nowhere && places_[b] != nowhere && places_[a] != places_[b])
          edges.push_back({std::min(a, b), std::max(a, b)});
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i)
      if ((i == 0 || edges[i] != edges[i - 1]) &&
          (i + 1 == edges.size() || edges[i] != edges[i + 1]))
        single.push_back(edges[i]);
    return single;
  }

  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};

  const IndexedMesh& mesh_;
  std::vector<std::uint32_t> places_; // of each vertex, or empty if no two share a place
};

} // namespace quadrille_examples

#endif
