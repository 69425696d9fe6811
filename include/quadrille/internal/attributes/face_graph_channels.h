#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_FACE_GRAPH_CHANNELS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_FACE_GRAPH_CHANNELS_H

#include <quadrille/internal/attributes/channel_map.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/memory/array.h>

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The channels of a mesh, in maps over its vertices or its halfedges: a halfedge stands for the
/// corner of its face at the vertex that it points to.
template <class Mesh, class Maps>
class FaceGraphChannels {
public:
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;

  explicit FaceGraphChannels(Maps maps) : maps_(std::move(maps)) {}

  /// `vertices` are those of the mesh, in the order in which they were read.
  template <class Vertices>
  void read(const Mesh& mesh, const Vertices& vertices, Arena& arena, InputWithChannels& surface) {
    for_each_channel(maps_, [&](auto& map, std::size_t) {
      using Key = typename std::remove_cvref_t<decltype(map)>::Key;
      ChannelInput input = map.input(arena);
      if constexpr (std::same_as<Key, Vertex>)
        for (std::size_t v = 0; v < vertices.size(); ++v)
          map.read(vertices[v], input);
      else
        read_corners(mesh, map, input);
      map.end_of_reading(input, surface.triangles);
      surface.channels.push_back(std::move(input));
    });
  }

  /// Writes what has changed at vertices and at the halfedges of the faces that are left, three a
  /// face. If anything throws, undo() puts back what there was.
  template <class Result, class VertexOf, class Halfedges>
  void write(const Result& result, std::size_t vertices, VertexOf vertex_of,
             const Halfedges& halfedges) {
    for_each_channel(maps_, [&](auto& map, std::size_t c) {
      using Key = typename std::remove_cvref_t<decltype(map)>::Key;
      if constexpr (std::same_as<Key, Vertex>)
        for (Index v = 0; v < vertices; ++v)
          write_value(result, c, result.first_wedge(v), vertex_of(v), map);
      else
        for (Index side = 0; side < halfedges.size(); ++side)
          write_value(result, c, result.wedge(c, side / 3, side % 3), halfedges[side], map);
    });
  }
  void undo() { undo_channels(maps_); }

  /// A vertex that is written twice has the same values twice.
  void copy(Vertex from, Vertex to) {
    for_each_channel(maps_, [&](auto& map, std::size_t) {
      using Key = typename std::remove_cvref_t<decltype(map)>::Key;
      if constexpr (std::same_as<Key, Vertex>)
        map.put_raw(to, map.raw(from));
    });
  }

private:
  template <class Map>
  static void read_corners(const Mesh& mesh, const Map& map, ChannelInput& input) {
    Index value = 0;
    for (auto f : faces(mesh)) {
      Halfedge h = halfedge(f, mesh);
      std::array<Index, 3> corners;
      for (Index& corner : corners) {
        map.read(h, input);
        corner = value++;
        h = next(h, mesh);
      }
      input.corners.push_back(corners);
    }
  }

  template <class Result, class Key, class Map>
  static void write_value(const Result& result, std::size_t c, Index wedge, const Key& key,
                          Map& map) {
    if (const auto value = map.changed(result, c, wedge, map.raw(key)))
      map.overwrite(key, *value);
  }

  Maps maps_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_FACE_GRAPH_CHANNELS_H
