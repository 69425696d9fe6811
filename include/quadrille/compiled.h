#ifndef QUADRILLE_COMPILED_H
#define QUADRILLE_COMPILED_H

#include <quadrille/channel_options.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric.h>
#include <quadrille/recorded.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// \file
/// Quadrille without templates, for polygon soups of doubles. The code that is slow to compile is
/// compiled once, in the target quadrille::compiled. A program that includes this header links this
/// target.
///
/// ```cpp
/// SoupView soup{points, triangles}; // looks at arrays of the caller's
/// soup.channels.push_back({.values = uvs, .triangles = uv_triangles});
/// SoupResult result = simplified_soup(soup, {.faces = 1000});
/// ```

namespace quadrille {

/// A type-erased recorder of a call: `options.recorder = record_into(levels)`. It receives
/// contractions, but not rejections.
class SoupRecorder {
public:
  /// Refers to a recorder that it does not own.
  template <ContractionRecorder R>
  SoupRecorder(const RecordInto<R>& into) {
    R& recorder = *into.recorder;
    begin_ = [&recorder](RecordedSurface&& surface) { recorder.begin(std::move(surface)); };
    record_ = [&recorder](const RecordedContraction& done) { recorder.record(done); };
    end_ = [&recorder] { recorder.end(); };
    if constexpr (requires(StopReason reason) { recorder.stop(reason); })
      stop_ = [&recorder](StopReason reason) { recorder.stop(reason); };
  }

  /// Passes the surface to the recorder: see ContractionRecorder.
  void begin(RecordedSurface surface) const { begin_(std::move(surface)); }
  /// Passes a contraction to the recorder.
  void record(const RecordedContraction& contraction) const { record_(contraction); }
  /// Passes the reason of the stop to a recorder that wants it.
  void stop(StopReason reason) const {
    if (stop_)
      stop_(reason);
  }
  /// Ends the record: see ContractionRecorder.
  void end() const { end_(); }

private:
  std::function<void(RecordedSurface&&)> begin_;
  std::function<void(const RecordedContraction&)> record_;
  std::function<void()> end_;
  std::function<void(StopReason)> stop_;
};

/// A box in space.
struct SoupBox {
  std::array<double, 3> low;  ///< the least coordinates, finite
  std::array<double, 3> high; ///< the greatest, each at least the least
};

/// A contraction as a filter in the options sees it: see FilterPolicy. Positions are in the unit of
/// the points, and indices are those of the input. With SoupOptions::split_vertices the indices of
/// points are those of distinct positions, in the order of the first point at each.
struct SoupContraction {
  /// A face that changes: its moving corner and its two other corners.
  struct Face {
    std::size_t index;            ///< in the input
    std::array<double, 3> before; ///< the position of its moving corner
    std::array<double, 3> after;  ///< the new position of this corner
    std::array<double, 3> second; ///< the position of its next corner
    std::array<double, 3> third;  ///< the position of its last corner
  };
  std::size_t first;                      ///< an end of the pair
  std::size_t second;                     ///< the other end
  std::array<double, 3> target;           ///< the position of the new vertex
  std::vector<Face> faces;                ///< the faces that stay and change
  std::vector<std::size_t> removed_faces; ///< the indices of the removed faces
  std::size_t highest_degree;             ///< the higher degree of the two ends, in faces
};

/// The options of simplified_soup() and simplify_soup(). Each field has the name of a policy of
/// `simplify`.
struct SoupOptions {
  /// The names of the costs: see Quadric and the others.
  enum class Cost { quadric, memoryless_quadric, thin_feature_quadric, edge_length };
  /// The names of the placements: see OptimalPlacement and the others.
  enum class Placement { optimal, endpoint, midpoint };
  /// The names of the orders: see GreedyOrder and RelaxedOrder.
  enum class Order { greedy, relaxed };
  /// The names of the axes.
  enum class Axis { x, y, z };

  /// The names of the presets: see SoupOptions::preset.
  enum class Preset { generated, scan, voxels, print, cad, terrain, game };

  /// The options of a kind of surface: those that have their default here get that of the preset,
  /// which `compiled/presets.def` lists. Options that do not go with another one of the caller's
  /// are left out.
  std::optional<Preset> preset = {};

  // --- Targets: the simplification stops at the first one that is met; without any it stops at
  // FaceRatio{0.5}.
  std::optional<std::size_t> faces = {};    ///< see FaceCount
  std::optional<double> ratio = {};         ///< see FaceRatio, in [0, 1]
  std::optional<std::size_t> vertices = {}; ///< see VertexCount
  std::optional<double> error = {};         ///< see DistanceLimit: a distance, at least 0
  /// See DistanceLimit::relative: a fraction of the diagonal.
  std::optional<double> relative_error = {};
  bool both_ways = false; ///< these limits apply in both directions: see HausdorffLimit
  /// Replaces the limits above with a distance for each point that it may move: empty, or one value
  /// per point. See ToleranceLimit.
  std::vector<double> tolerance = {};
  std::optional<double> cost_limit = {}; ///< see CostLimit: at least 0
  /// A stop policy in addition to these; the run stops once it returns true. See StopPolicy.
  std::function<bool(const Status&)> stop = {};

  Cost cost = Cost::quadric;                          ///< the cost of a contraction
  double boundary_weight = Quadric{}.boundary_weight; ///< for costs that have one; at least 0
  std::optional<Placement> placement = std::nullopt;  ///< by default the best one for the cost
  Order order = Order::greedy;                        ///< the order in which pairs are contracted
  std::optional<double> pairs_closer_than = {};       ///< see ThresholdPairs; without it the pairs
                                                      ///< are the edges
  std::optional<Topology> topology = std::nullopt;    ///< kept, or by default free with pairs
  /// The soup is cut into manifold sheets first: see make_manifold().
  bool manifold = false;
  /// Components are joined across gaps up to a size, once the soup is manifold: see join_gaps().
  /// Limits and guards hold for the surface after that.
  std::optional<double> join_gaps = {};
  /// Tunnels and handles up to a size are cut first: see cut_handles(). Limits and guards hold for
  /// the surface after the cuts: see Report::cut_distance.
  std::optional<double> simplified_topology = {};
  std::optional<double> keep_planes = {};    ///< an area, see KeepPlanes
  std::optional<double> plane_flatness = {}; ///< see KeepPlanes, which it needs
  std::optional<double> plane_outline = {};  ///< the same; by default `error`, if there is one
  std::optional<double> voxel_size = {};     ///< see VoxelSize
  /// See HeightField: the input is a height field along this axis, and the result is.
  std::optional<Axis> height_field = {};
  double normal_flip = 90;                ///< degrees, see NormalFlip
  std::optional<double> normal_deviation; ///< degrees, see NormalDeviation
  bool no_self_intersection = false;      ///< see NoSelfIntersection
  bool keep_solid = false;                ///< see KeepSolid
  /// A filter in addition to these: may this contraction be done? See FilterPolicy; with several
  /// threads it is called concurrently.
  std::function<bool(const SoupContraction&)> allows = {};
  /// Points that must not move: empty, or a value for each point.
  std::vector<bool> fixed = {};
  /// The importance of each point, at least 0: empty, or a value for each point. See
  /// vertex_importance_map.
  std::vector<double> importance = {};
  /// Triangles that may be changed and that count for the targets: empty, or a value for each. See
  /// face_is_selected_map.
  std::vector<bool> selected = {};
  /// Points that other tiles of the surface have too: empty, or a value for each point. See
  /// vertex_is_shared_map; relative limits and the scale are those of bounding_box.
  std::vector<bool> shared = {};
  /// Edges of one triangle between shared points that are on the boundary of the whole surface: see
  /// boundary_edges.
  std::vector<std::array<std::uint32_t, 2>> boundaries = {};
  /// The box that sets the scale of the simplification: see parameters::bounding_box.
  std::optional<SoupBox> bounding_box = {};
  /// True if the points of the result will be rounded to floats: see
  /// parameters::coordinates_are_floats.
  bool coordinates_are_floats = false;
  /// Called from time to time; the simplification ends early when it returns false. See Visitor.
  std::function<bool(const Status&)> proceed = {};

  double share = 0.5;          ///< see RelaxedOrder
  bool refresh = false;        ///< see RelaxedOrder
  unsigned threads = 1;        ///< more than one need oneTBB when the library is compiled
  double crease_weight = 100;  ///< see Quadric, as for the next one
  double crease_degrees = 180; ///< other costs have no crease terms
  Weighting weighting = Weighting::by_area; ///< for Cost::quadric, as the next three: see Quadric
  double line_weight = 0;                   ///< the weight of lines along the vertex normals
  double normal_noise = 0;                  ///< the standard deviation of unit normals
  double position_noise = 0;                ///< the standard deviation of positions, in the unit of
                                            ///< the points
  double region_boundary_weight = 1;        ///< see Labels::region_boundary_weight
  /// See SplitVertices: points at exactly the same place are one vertex. The result then has no
  /// vertex map.
  bool split_vertices = false;
  /// Receives all contractions, as Levels does: see record_into. With preparations the record
  /// begins with the prepared surface, and has its indices.
  std::optional<SoupRecorder> recorder = {};
};

using SoupPoints = std::vector<std::array<double, 3>>;           ///< coordinates, finite
using SoupTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points

/// A view of a channel of attributes in arrays of the caller.
struct SoupChannelView {
  /// The kinds of channels: see Texture, Normals, Colors and Attributes.
  enum class Kind { texture, normals, colors, attributes };
  Kind kind = Kind::texture;  ///< the kind of its attributes
  std::size_t components = 2; ///< 2 for a texture, 3 for normals, 3 or 4 for colours, otherwise at
                              ///< least 1
  std::span<const double> values; ///< consecutive values, each with that many components
  /// For each triangle, the values of its corners; if empty, a value has the index of its point.
  std::span<const std::array<std::uint32_t, 3>> triangles = {};
  ChannelOptions options = {}; ///< options that say how it counts
};

/// A view of a polygon soup of triangles with its attributes, in arrays of the caller that are not
/// changed.
struct SoupView {
  std::span<const std::array<double, 3>> points;           ///< coordinates, finite
  std::span<const std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::span<const std::uint32_t> labels = {}; ///< see Labels: empty, or one per triangle
  std::vector<SoupChannelView> channels = {}; ///< any number, of any kinds
};

/// The values of a channel of a result: see SoupChannelView.
struct SoupChannel {
  std::size_t components = 0; ///< the number of components of each value
  std::vector<double> values; ///< consecutive values
  SoupTriangles triangles;    ///< for each triangle, the values of its corners; or empty
};

/// The surface that SoupOptions::manifold, join_gaps and simplified_topology make of a soup. Its
/// points come first, and added points behind them; triangles of bridges, and then those that close
/// cuts, come behind the others.
struct PreparedSurface {
  SoupPoints points;       ///< empty if there was no preparation
  SoupTriangles triangles; ///< the triangles with which the run begins
  /// For each added point, the point of the input from which it comes; the first one, if it lies in
  /// the middle of several.
  std::vector<std::uint32_t> origins;
  /// For each point, added ones included, what SoupResult::vertex_map is.
  std::vector<std::size_t> vertex_map;
};

/// The simplified soup. The remaining points and triangles keep their order.
struct SoupResult {
  SoupPoints points;                      ///< the remaining points
  SoupTriangles triangles;                ///< the remaining triangles, with indices of these points
  std::vector<std::uint32_t> labels;      ///< the labels of the triangles, if the soup had any
  std::vector<SoupChannel> channels;      ///< as many channels as the soup had, in their order
  std::vector<std::uint32_t> input_faces; ///< for each triangle, its index in the input
  /// For each point of the input, the point into which it was merged, or parameters::vanished.
  /// Empty with SoupOptions::split_vertices.
  std::vector<std::size_t> vertex_map;
  Report report;            ///< the report of the simplification
  PreparedSurface prepared; ///< the surface that was simplified, if preparations have made it
};

/// Simplifies a polygon soup as `simplify(points, triangles, …)` does with the same policies, to
/// the same bits. No array of the input is copied or changed. The result of a soup without
/// triangles is empty: it has neither points nor values.
///
/// Throws std::invalid_argument for invalid options, labels or channels, and whatever `simplify`
/// throws.
SoupResult simplified_soup(const SoupView& soup, const SoupOptions& options = {});

/// Simplifies a soup without labels and channels in place. `vertex_map`, if it is not null,
/// receives for each point of the input its index in the result, or parameters::vanished.
///
/// Throws as simplified_soup() does; the soup is then unchanged.
Report simplify_soup(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options = {},
                     std::vector<std::size_t>* vertex_map = nullptr);

} // namespace quadrille

#endif // QUADRILLE_COMPILED_H
