#ifndef QUADRILLE_LEVELS_H
#define QUADRILLE_LEVELS_H

#include <quadrille/internal/core/adapter/face_linker.h>
#include <quadrille/internal/core/adapter/umbrellas.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/recording/record_list.h>
#include <quadrille/internal/levels/level_builder.h>
#include <quadrille/internal/levels/level_track.h>
#include <quadrille/quadric_form.h>
#include <quadrille/record.h>
#include <quadrille/recorded.h>
#include <quadrille/stop.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ranges>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace quadrille {

/// The coarsest level whose error is at most a distance in the mesh's units: see Report::error.
struct ErrorAtMost {
  double error; ///< at least 0
};
/// The coarsest level whose points are all known to be within a distance of the input, in the
/// mesh's units: see Report::distance_bound. It is for recordings with a stop policy that needs
/// distances, as DistanceLimit.
struct DistanceAtMost {
  double distance; ///< at least 0
};
/// The level after the given number of contractions.
struct AfterContractions {
  std::size_t contractions; ///< 0: the input
};

/// The known figures of a level.
struct LevelInfo {
  std::size_t faces = 0;        ///< the faces of the level
  std::size_t vertices = 0;     ///< the vertices of the level
  std::size_t contractions = 0; ///< the contractions that lead to it
  double error = 0;             ///< as Report::error; rounded up to a float
  /// A bound as Report::distance_bound, or a greater one: it never falls from a level to a coarser
  /// one.
  double distance_bound = std::numeric_limits<double>::infinity();
  /// A bound as Report::hausdorff_bound; distance_bound is then no less. It is known for recordings
  /// with a stop policy that needs both directions, as HausdorffLimit; otherwise it is infinite,
  /// except for the input.
  double hausdorff_bound = std::numeric_limits<double>::infinity();
};

/// The values of a channel at a level.
struct LevelChannel {
  std::size_t components = 0; ///< the number of components of a value
  std::vector<double> values; ///< consecutive values
  /// For each triangle, the values of its corners; if empty, a value has the index of its point.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A surface at a level of detail, as a soup. For two levels of one recording, the faces and
/// vertices of the coarser one are the first ones of the finer one, by input indices.
struct Level : LevelInfo {
  std::vector<std::array<double, 3>> points;           ///< in the mesh's units
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  /// The attributes that the cost reads, if any, followed by the channels, in the order of the
  /// call. Values are in the user's unit, not yet rounded to the user's type.
  std::vector<LevelChannel> channels;
  /// For each point, its index in the input; for a mesh in the order of vertices(mesh).
  std::vector<std::uint32_t> input_vertices;
  /// For each triangle, its face of the input; for a mesh in the order of faces(mesh). It serves to
  /// find a label or a colour of the face.
  std::vector<std::uint32_t> input_faces;
};

/// Returns the same level with its points and triangles in the order of the input, as `simplify`
/// leaves them, and also channels whose values have the index of their point. It takes O(n log n)
/// time.
inline Level in_input_order(const Level& level) {
  const auto ordered = [](const std::vector<std::uint32_t>& inputs) {
    std::vector<std::uint32_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return inputs[i] < inputs[j]; });
    return order;
  };
  Level sorted = level;
  const std::vector<std::uint32_t> vertices = ordered(level.input_vertices);
  std::vector<std::uint32_t> place(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    place[vertices[i]] = i;
    sorted.points[i] = level.points[vertices[i]];
    sorted.input_vertices[i] = level.input_vertices[vertices[i]];
  }
  const std::vector<std::uint32_t> faces = ordered(level.input_faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      sorted.triangles[i][k] = place[level.triangles[faces[i]][k]];
    sorted.input_faces[i] = level.input_faces[faces[i]];
  }
  for (std::size_t c = 0; c < sorted.channels.size(); ++c) {
    LevelChannel& channel = sorted.channels[c];
    const LevelChannel& old = level.channels[c];
    for (std::size_t i = 0; i < channel.triangles.size(); ++i)
      channel.triangles[i] = old.triangles[faces[i]];
    for (std::size_t i = 0; i < vertices.size() && channel.triangles.empty(); ++i)
      std::copy_n(&old.values[vertices[i] * channel.components], channel.components,
                  &channel.values[i * channel.components]);
  }
  return sorted;
}

/// The vertices of the input that are merged at a level: members[i] are those that have become its
/// vertex i, in ascending order.
class LevelMembers {
public:
  /// Inverts the result of Levels::vertex_map for a level with this number of vertices, in linear
  /// time.
  LevelMembers(const std::vector<std::uint32_t>& vertex_map, std::size_t vertices)
      : begin_(vertices + 1, 0) {
    for (std::uint32_t vertex : vertex_map)
      if (vertex != not_recorded)
        ++begin_[vertex + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    members_.resize(begin_.back());
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t v = 0; v < vertex_map.size(); ++v)
      if (vertex_map[v] != not_recorded)
        members_[end[vertex_map[v]]++] = v;
  }
  std::size_t size() const { return begin_.size() - 1; } ///< the number of vertices of the level
  /// Returns the vertices of the input, by number, that have become vertex i.
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(members_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> members_;
};

} // namespace quadrille

namespace quadrille::internal {

/// Makes the figures of a level; its bound is only known if distances have been recorded.
inline LevelInfo level_info(std::size_t faces, std::size_t vertices, std::size_t contractions,
                            double error, bool knows_bounds, bool are_both_ways, double bound) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const double known = contractions == 0 ? 0 : knows_bounds ? bound : unknown;
  return {faces, vertices, contractions,
          error, known,    contractions == 0 || are_both_ways ? known : unknown};
}

/// A position in a segment, by its number of contractions.
struct LevelPlace {
  std::size_t segment, contractions;
};

/// Finds levels in segments by binary search. There must be at least one segment.
class LevelSearch {
public:
  /// `before` is the number of contractions before the first segment.
  LevelSearch(const std::vector<LevelSegment>& segments, std::size_t before)
      : segments_(segments), before_(before) {}

  LevelPlace find(const FaceCount& stop) const {
    return first([&](const LevelSegment& segment, std::size_t i) {
      return segment.faces_at(i) <= stop.faces;
    });
  }
  LevelPlace find(const VertexCount& stop) const {
    return first([&](const LevelSegment& segment, std::size_t i) {
      return segment.tracks.front().items_at(i) <= stop.vertices;
    });
  }
  LevelPlace find(const ErrorAtMost& stop) const {
    return last([&](const LevelSegment& segment, std::size_t i) {
      return segment.error_at(i) <= stop.error;
    });
  }
  LevelPlace find(const DistanceAtMost& stop) const {
    const LevelSegment& segment = segments_.front();
    if (segment.contractions() > 0 && segment.bounds.empty())
      throw std::logic_error(
          "quadrille::Levels: distances have not been recorded: simplify with a stop policy "
          "that needs them, such as DistanceLimit");
    return last(
        [&](const LevelSegment& s, std::size_t i) { return s.bound_at(i) <= stop.distance; });
  }
  LevelPlace find(const AfterContractions& stop) const {
    std::size_t s = 0, left = stop.contractions - (std::min)(stop.contractions, before_);
    for (; s + 1 < segments_.size() && left > segments_[s].contractions(); ++s)
      left -= segments_[s].contractions();
    return {s, (std::min)(left, segments_[s].contractions())};
  }

private:
  // Returns the first level for which is_enough(segment, contractions) is true, or the coarsest
  // one. It must then be true for all coarser levels.
  template <class IsEnough>
  LevelPlace first(IsEnough is_enough) const {
    std::size_t s = 0;
    while (s + 1 < segments_.size() && !is_enough(segments_[s], segments_[s].contractions()))
      ++s;
    std::size_t low = 0, high = segments_[s].contractions();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (is_enough(segments_[s], middle))
        high = middle;
      else
        low = middle + 1;
    }
    return {s, low};
  }
  // Returns the last level for which is_within(segment, contractions) is true, or the finest one.
  // It must then be true for all finer levels.
  template <class IsWithin>
  LevelPlace last(IsWithin is_within) const {
    const LevelPlace place = first([&](const LevelSegment& segment, std::size_t contractions) {
      return !is_within(segment, contractions);
    });
    if (place.contractions == 0 || is_within(segments_[place.segment], place.contractions))
      return place; // the first of the first segment, or the last of all
    return {place.segment, place.contractions - 1};
  }

  const std::vector<LevelSegment>& segments_;
  std::size_t before_;
};

} // namespace quadrille::internal

namespace quadrille {

namespace internal {
class LevelsFileWriter;
}

/// All levels of detail of a simplification, from one run:
///
/// ```cpp
/// Levels levels;
/// simplify<Quadric, OptimalPlacement>(mesh, FaceCount{64}, record_into(levels));
/// Level level = levels.at(FaceCount{994});
/// ```
///
/// A level has the faces and positions that `simplify` with that stop would have left, bit for bit
/// in GreedyOrder with the same policies, for any number of faces that the order reaches without
/// choosing another pair: for a closed surface, any even number. (Attributes of a cost in more
/// dimensions are rounded when they are weighted.) The removal of a component counts as a
/// contraction. Coordinates are doubles, even for meshes with exact numbers. Channels are included,
/// except NewValues::recomputed: see RecordedChannel.
///
/// Contractions only remove faces. So if faces are sorted by removal, the last removed first, each
/// level is a prefix of them, and the same holds for vertices. The surface is stored at each
/// halving of the faces, with the contractions until the next one: finding, reading and writing a
/// level takes time linear in its size. It takes about 76 bytes for each face of the input, without
/// channels; during the recording, about 24 for the surface and 24 for the contractions.
///
/// Source: Hoppe, Progressive Meshes, 1996, for the idea; the order by removal is the reverse of
/// that of Popović and Hoppe, Progressive Simplicial Complexes, 1997.
class Levels {
public:
  /// Returns whether nothing has been recorded.
  bool empty() const { return segments_.empty(); }

  /// Returns the figures of the input, the finest level.
  LevelInfo finest() const { return info(begin_of(0)); }
  /// Returns the figures of the coarsest level.
  LevelInfo coarsest() const { return info(end_of(segments_.size() - 1)); }

  /// Returns the number of vertices of the input, with those that have no face.
  std::size_t input_vertex_count() const { return input_vertex_count_; }

  /// Returns a level: the finest with at most the given number of faces or vertices, or the
  /// coarsest within the given error or distance; the coarsest of all if no level is that coarse.
  /// `stop` is a FaceCount, VertexCount, ErrorAtMost, DistanceAtMost or AfterContractions. Takes
  /// linear time.
  ///
  /// Throws std::logic_error if nothing has been recorded, and for a DistanceAtMost if distances
  /// have not been.
  template <class Stop>
  Level at(const Stop& stop) const;
  /// Returns the figures of a level without its surface, in logarithmic time.
  template <class Stop>
  LevelInfo info(const Stop& stop) const {
    return info(find(stop));
  }
  /// Extracts a level as a soup of the user's types, as for `simplify`. It allocates no memory if
  /// the containers are large enough.
  template <class Stop, class Points, class Triangles>
  LevelInfo extract(const Stop& stop, Points& points, Triangles& triangles) const;

  /// Returns, for each vertex of the input, its vertex at a level; not_recorded if it has vanished.
  /// It takes time linear in the size of the input.
  std::vector<std::uint32_t> vertex_map(const LevelInfo& level) const;
  /// Returns the inverse of vertex_map().
  LevelMembers members(const LevelInfo& level) const { return {vertex_map(level), level.vertices}; }

  /// Returns, for each vertex of a level, its vertex at a coarser one; not_recorded if it has
  /// vanished. To morph the level into the coarser one, move each point to that of its vertex there
  /// (a geomorph). It takes time linear in the size of the finer level.
  std::vector<std::uint32_t> vertex_map(const LevelInfo& fine, const LevelInfo& coarse) const;

  // The events of a recorder: see record.h.
  void begin(RecordedSurface surface); ///< called by `simplify`: see ContractionRecorder
  /// Called by `simplify` for each contraction.
  void record(const RecordedContraction& contraction) { records_.add(contraction); }
  void end(); ///< called by `simplify` after the last one

private:
  using Index = internal::Index;
  using Segment = internal::LevelSegment;
  using Track = internal::LevelTrack;
  using Place = internal::LevelPlace;
  // The place of a channel's values: in a track, after other values.
  struct ChannelPlace {
    std::size_t track, offset, components;
  };
  friend class LevelSteps;
  friend class LevelsFile;
  friend class internal::LevelsFileWriter;

  Place begin_of(std::size_t segment) const { return {segment, 0}; }
  Place end_of(std::size_t segment) const {
    require_any();
    return {segment, segments_[segment].contractions()};
  }
  void require_any() const {
    if (empty())
      throw std::logic_error("quadrille::Levels: nothing has been recorded");
  }

  template <class Stop>
  Place find(const Stop& stop) const {
    require_any();
    return internal::LevelSearch(segments_, begins_.front()).find(stop);
  }

  LevelInfo info(const Place& place) const;
  LevelChannel channel_at(const ChannelPlace& channel, const Place& place, std::size_t faces,
                          const std::vector<double>& vertices) const;
  void name_channels(const RecordedSurface& surface);

  std::vector<internal::RecordedItems> items_; // while contractions are recorded
  internal::RecordList records_;
  std::vector<ChannelPlace> recorded_channels_;

  std::vector<Segment> segments_;
  std::vector<std::size_t> begins_; // for each segment, the number of contractions before it
  std::vector<Index> input_vertices_, input_faces_; // by number
  std::size_t input_vertex_count_ = 0;
  std::vector<ChannelPlace> channels_;
};

// --- Definitions
// -----------------------------------------------------------------------------------

inline void Levels::name_channels(const RecordedSurface& surface) {
  recorded_channels_.clear();
  if (surface.dimension > 3)
    recorded_channels_.push_back({0, 3, surface.dimension - 3});
  std::size_t offset = surface.dimension, track = 1;
  for (const RecordedChannel& channel : surface.channels)
    if (channel.corners.empty()) {
      recorded_channels_.push_back({0, offset, channel.components});
      offset += channel.components;
    } else {
      recorded_channels_.push_back({track++, 0, channel.components});
    }
}

inline void Levels::begin(RecordedSurface surface) {
  name_channels(surface);
  records_ = internal::RecordList(surface.width, surface.knows_distances, surface.knows_both_ways);
  records_.reserve(surface.values.size() / surface.width, surface.triangles.size());
  items_.clear();
  items_.push_back({surface.width, std::move(surface.triangles), std::move(surface.values)});
  for (RecordedChannel& channel : surface.channels)
    if (!channel.corners.empty())
      items_.push_back({channel.components, std::move(channel.corners), std::move(channel.values)});
}

inline void Levels::end() {
  const std::size_t vertices = items_.front().values.size() / items_.front().width;
  internal::LevelBuilder builder(std::move(items_), records_);
  builder.build();
  std::vector<Segment> segments = builder.take_segments();
  std::vector<std::size_t> begins(1, 0);
  for (const Segment& segment : segments)
    begins.push_back(begins.back() + segment.contractions());
  segments_ = std::move(segments); // nothing throws from here on
  begins_ = std::move(begins);
  input_faces_ = builder.take_faces();
  input_vertices_ = builder.take_vertices();
  input_vertex_count_ = vertices;
  channels_ = std::move(recorded_channels_);
  records_ = {};
}

inline LevelInfo Levels::info(const Place& place) const {
  require_any();
  const Segment& segment = segments_[place.segment];
  const bool knows_bounds = !segments_.front().bounds.empty();
  return internal::level_info(
      segment.faces_at(place.contractions), segment.tracks.front().items_at(place.contractions),
      begins_[place.segment] + place.contractions, segment.error_at(place.contractions),
      knows_bounds, segment.are_bounds_both_ways,
      knows_bounds ? segment.bound_at(place.contractions) : 0);
}

inline LevelChannel Levels::channel_at(const ChannelPlace& channel, const Place& place,
                                       std::size_t faces,
                                       const std::vector<double>& vertices) const {
  const Track& track = segments_[place.segment].tracks[channel.track];
  LevelChannel left;
  left.components = channel.components;
  if (channel.track > 0) {
    left.values = track.values_at(place.contractions);
    left.triangles = track.corners_at(place.contractions, faces);
    return left;
  }
  left.values.reserve(vertices.size() / track.width * channel.components);
  for (std::size_t v = channel.offset; v < vertices.size(); v += track.width)
    left.values.insert(left.values.end(), vertices.begin() + static_cast<std::ptrdiff_t>(v),
                       vertices.begin() + static_cast<std::ptrdiff_t>(v + channel.components));
  return left;
}

template <class Stop>
Level Levels::at(const Stop& stop) const {
  const Place place = find(stop);
  Level level{info(place), {}, {}, {}, {}, {}};
  const Track& track = segments_[place.segment].tracks.front();
  const std::vector<double> values = track.values_at(place.contractions);
  level.points.resize(level.vertices);
  for (std::size_t v = 0; v < level.vertices; ++v)
    std::copy_n(values.data() + v * track.width, 3, level.points[v].data());
  level.triangles = track.corners_at(place.contractions, level.faces);
  for (const ChannelPlace& channel : channels_)
    level.channels.push_back(channel_at(channel, place, level.faces, values));
  level.input_vertices.assign(input_vertices_.begin(),
                              input_vertices_.begin() +
                                  static_cast<std::ptrdiff_t>(level.vertices));
  level.input_faces.assign(input_faces_.begin(),
                           input_faces_.begin() + static_cast<std::ptrdiff_t>(level.faces));
  return level;
}

template <class Stop, class Points, class Triangles>
LevelInfo Levels::extract(const Stop& stop, Points& points, Triangles& triangles) const {
  using Point = std::ranges::range_value_t<Points>;
  const Place place = find(stop);
  const LevelInfo level = info(place);
  const Track& track = segments_[place.segment].tracks.front();
  const auto point = [](const double* p) {
    return internal::point_at<Point>(Vector<3>{{p[0], p[1], p[2]}});
  };
  points.resize(level.vertices, point(std::array<double, 3>{}.data()));
  for (std::size_t v = 0; v < level.vertices; ++v)
    points[v] = point(track.values.data() + v * track.width);
  track.for_each_change(place.contractions,
                        [&](Index item, const double* numbers) { points[item] = point(numbers); });
  const std::vector<Index> vertex_map = track.item_map(place.contractions);
  using Triangle = std::ranges::range_value_t<Triangles>;
  using Number = std::ranges::range_value_t<Triangle>;
  triangles.resize(level.faces);
  for (std::size_t face = 0; face < level.faces; ++face) {
    Triangle& triangle = triangles[face];
    if constexpr (requires { triangle.resize(3); })
      triangle.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<Number>(vertex_map[track.corners[face][i]]);
  }
  return level;
}

inline std::vector<std::uint32_t> Levels::vertex_map(const LevelInfo& fine,
                                                     const LevelInfo& coarse) const {
  require_any();
  std::vector<std::uint32_t> vertex_map(fine.vertices);
  const auto left = (std::min)(coarse.vertices, fine.vertices);
  std::iota(vertex_map.begin(), vertex_map.begin() + static_cast<std::ptrdiff_t>(left),
            std::uint32_t{0});
  for (auto segment = segments_.rbegin(); segment != segments_.rend(); ++segment)
    segment->tracks.front().find_map(left, fine.vertices, vertex_map);
  return vertex_map;
}

inline std::vector<std::uint32_t> Levels::vertex_map(const LevelInfo& level) const {
  const std::vector<std::uint32_t> by_number = vertex_map(finest(), level);
  std::vector<std::uint32_t> vertex_map(input_vertex_count_, not_recorded);
  for (std::size_t v = 0; v < by_number.size(); ++v)
    vertex_map[input_vertices_[v]] = by_number[v];
  return vertex_map;
}

/// Converts a level to a mesh, whose former contents are removed. `mesh` models CGAL's
/// MutableFaceGraph. Its vertices and faces are in the order of the level's points and triangles;
/// where the level is not manifold, vertices are duplicated and follow after these. Returns the
/// level's point for each vertex of the mesh, in this order. It takes linear time.
template <class Mesh>
std::vector<std::uint32_t> to_mesh(const Level& level, Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using internal::Index;
  internal::Array<internal::Side> sides;
  for (const auto& [a, b, c] : level.triangles)
    for (const internal::Side& side : {internal::Side{c, a}, {a, b}, {b, c}})
      sides.push_back(side);
  internal::Umbrellas umbrellas;
  umbrellas.build(sides, level.points.size(), [](Index, Index) { return true; });

  std::vector<std::uint32_t> points_of_vertices(level.points.size());
  for (std::uint32_t v = 0; v < points_of_vertices.size(); ++v)
    points_of_vertices[v] = v;
  for (Index duplicated : umbrellas.duplicates())
    points_of_vertices.push_back(duplicated);

  CGAL::clear(mesh);
  auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  std::vector<typename Traits::vertex_descriptor> vertices;
  for (std::uint32_t v : points_of_vertices) {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), internal::point_at<Point>(Vector<3>{level.points[v]}));
  }
  internal::Array<typename Traits::face_descriptor> faces;
  for (std::size_t f = 0; f < level.triangles.size(); ++f)
    faces.push_back(add_face(mesh));
  internal::Array<Halfedge> halfedges;
  for (Index side = 0; side < sides.size(); ++side) {
    const Index mate = umbrellas.mate(side);
    halfedges.push_back(mate != internal::none && mate < side ? opposite(halfedges[mate], mesh)
                                                              : halfedge(add_edge(mesh), mesh));
  }
  internal::Array<typename Traits::edge_descriptor> others(num_edges(mesh));
  internal::FaceLinker<Mesh>(mesh, umbrellas, faces, halfedges)
      .link([&](Index corner) { return vertices[umbrellas.vertex(corner)]; }, others);
  return points_of_vertices;
}

} // namespace quadrille

#endif // QUADRILLE_LEVELS_H
