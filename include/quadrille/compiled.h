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
/// Quadrille without templates, for polygon soups of doubles: what takes its time to compile is
/// compiled once, in the target quadrille::compiled, which a program that includes this header
/// links.
///
/// ```cpp
/// SoupView soup{points, triangles}; // looks at arrays of the caller's
/// soup.channels.push_back({.values = uvs, .triangles = uv_triangles});
/// SoupResult result = simplified_soup(soup, {.faces = 1000});
/// ```

namespace quadrille {

/// The recorder of a call, of any type: `options.recorder = record_into(levels)`. It is told of
/// contractions, and not of refusals.
class SoupRecorder {
public:
  /// One that is not owned.
  template <ContractionRecorder R>
  SoupRecorder(const RecordInto<R>& into) {
    R& recorder = *into.recorder;
    begin_ = [&recorder](RecordedSurface&& surface) { recorder.begin(std::move(surface)); };
    record_ = [&recorder](const RecordedContraction& done) { recorder.record(done); };
    end_ = [&recorder] { recorder.end(); };
    if constexpr (requires(StopReason reason) { recorder.stop(reason); })
      stop_ = [&recorder](StopReason reason) { recorder.stop(reason); };
  }

  /// Tells it, as ContractionRecorder has it.
  void begin(RecordedSurface surface) const { begin_(std::move(surface)); }
  /// Tells it of a contraction.
  void record(const RecordedContraction& contraction) const { record_(contraction); }
  /// Tells it if it wants to know.
  void stop(StopReason reason) const {
    if (stop_)
      stop_(reason);
  }
  /// As begin().
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

/// A contraction as a filter of the options sees it, see FilterPolicy: places are in the unit of
/// the points, indices those of the input; with SoupOptions::split_vertices those of points are of
/// places, in the order of the first point at each.
struct SoupContraction {
  /// A face that changes: its moving corner and its two others.
  struct Face {
    std::size_t index;            ///< in the input
    std::array<double, 3> before; ///< where its moving corner is
    std::array<double, 3> after;  ///< where that will be
    std::array<double, 3> second; ///< where its next corner is
    std::array<double, 3> third;  ///< where its last corner is
  };
  std::size_t first;                      ///< an end of the pair
  std::size_t second;                     ///< the other one
  std::array<double, 3> target;           ///< where the vertex goes that both become
  std::vector<Face> faces;                ///< those that stay and change
  std::vector<std::size_t> removed_faces; ///< the indices of those that go
  std::size_t highest_degree;             ///< of the ends, in faces
};

/// What simplified_soup() and simplify_soup() are asked for. Each field is a policy of `simplify`,
/// by its name.
struct SoupOptions {
  /// The costs by their names: see Quadric and the others.
  enum class Cost { quadric, memoryless_quadric, thin_feature_quadric, edge_length };
  /// The placements: see OptimalPlacement and the others.
  enum class Placement { optimal, endpoint, midpoint };
  /// The orders: see GreedyOrder and RelaxedOrder.
  enum class Order { greedy, relaxed };

  // --- Targets: it stops at the first that is met; FaceRatio{0.5} where there is none.
  std::optional<std::size_t> faces = {};    ///< see FaceCount
  std::optional<double> ratio = {};         ///< see FaceRatio, in [0, 1]
  std::optional<std::size_t> vertices = {}; ///< see VertexCount
  std::optional<double> error = {};         ///< see DistanceLimit: a distance, at least 0
  std::optional<double> relative_error =
      {};                 ///< see DistanceLimit::relative: a part of the diagonal
  bool both_ways = false; ///< these limits hold both ways: see HausdorffLimit
  /// Instead of these, how far each point may move: empty, or a distance for each. See
  /// ToleranceLimit.
  std::vector<double> tolerance = {};
  std::optional<double> cost_limit = {}; ///< see CostLimit: at least 0
  /// A stop policy beside these: true is enough. See StopPolicy.
  std::function<bool(const Status&)> stop = {};

  Cost cost = Cost::quadric;                          ///< what a contraction costs
  double boundary_weight = Quadric{}.boundary_weight; ///< of costs that have one; at least 0
  std::optional<Placement> placement = std::nullopt;  ///< the best that the cost has by default
  Order order = Order::greedy;                        ///< which pair is next
  std::optional<double> pairs_closer_than = {};       ///< see ThresholdPairs; only edges without
  std::optional<Topology> topology = std::nullopt;    ///< kept, or free with pairs by default
  double normal_flip = 90;                            ///< degrees, see NormalFlip
  std::optional<double> normal_deviation;             ///< degrees, see NormalDeviation
  bool no_self_intersection = false;                  ///< see NoSelfIntersection
  bool keep_solid = false;                            ///< see KeepSolid{}
  /// A filter beside these: may this contraction be done? See FilterPolicy; with several threads it
  /// is asked by several at a time.
  std::function<bool(const SoupContraction&)> allows = {};
  /// Points that stay where they are: empty, or a value for each point.
  std::vector<bool> fixed = {};
  /// How much what happens at points counts, at least 0: empty, or a value for each point. See
  /// vertex_importance_map.
  std::vector<double> importance = {};
  /// Triangles that may be changed, and count for the targets: empty, or a value for each. See
  /// face_is_selected_map.
  std::vector<bool> selected = {};
  /// Points that other pieces of the surface have as well: empty, or a value for each point. See
  /// vertex_is_shared_map; relative limits, and the scale, are those of bounding_box.
  std::vector<bool> shared = {};
  /// Edges of one triangle between shared points that are borders of the whole surface: see
  /// border_edges.
  std::vector<std::array<std::uint32_t, 2>> borders = {};
  /// In the scale of which the surface is simplified: see parameters::bounding_box.
  std::optional<SoupBox> bounding_box = {};
  /// Will the points of the result become floats? See parameters::coordinates_are_floats.
  bool coordinates_are_floats = false;
  /// Asked now and then; the simplification ends early when it returns false. See Visitor.
  std::function<bool(const Status&)> proceed = {};

  bool eager = false;          ///< see GreedyOrder
  double share = 0.5;          ///< see RelaxedOrder
  bool refresh = false;        ///< see RelaxedOrder
  unsigned threads = 1;        ///< more than one need oneTBB where the library is compiled
  double crease_weight = 100;  ///< see Quadric, as the next
  double crease_degrees = 180; ///< other costs know no creases
  Weighting weighting = Weighting::by_area; ///< of Cost::quadric, as the next three: see Quadric
  double line_weight = 0;                   ///< how firmly vertices keep to lines along normals
  double normal_noise = 0;                  ///< of unit normals
  double position_noise = 0;                ///< of places, in the unit of the points
  double label_border_weight = 1;           ///< see Labels::border_weight
  /// See SplitVertices: points at exactly one place are one vertex. There is no image then.
  bool split_vertices = false;
  /// Is told of all contractions, as Levels: see record_into.
  std::optional<SoupRecorder> recorder = {};
};

using SoupPoints = std::vector<std::array<double, 3>>;           ///< coordinates, finite
using SoupTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points

/// A channel of attributes, in arrays of the caller's.
struct SoupChannelView {
  /// What a channel holds: see Texture, Normals, Colors and Attributes.
  enum class Kind { texture, normals, colors, attributes };
  Kind kind = Kind::texture;  ///< what it holds
  std::size_t components = 2; ///< 2 of a texture, 3 of normals, 3 or 4 of colours, else at least 1
  std::span<const double> values; ///< one value after the other, each of that many components
  /// Of each triangle, the values of its corners; empty: a value has the index of its point.
  std::span<const std::array<std::uint32_t, 3>> triangles = {};
  ChannelOptions options = {}; ///< how it counts
};

/// A polygon soup of triangles with what it carries, in arrays of the caller's, which are not
/// changed.
struct SoupView {
  std::span<const std::array<double, 3>> points;           ///< coordinates, finite
  std::span<const std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::span<const std::uint32_t> labels = {}; ///< see Labels: empty, or one for each triangle
  std::vector<SoupChannelView> channels = {}; ///< any number, of any kinds
};

/// Values of a channel of a result, as SoupChannelView has them.
struct SoupChannel {
  std::size_t components = 0; ///< of each value
  std::vector<double> values; ///< one value after the other
  SoupTriangles triangles;    ///< of each triangle, the values of its corners; or empty
};

/// What becomes of a soup. What is left keeps its order.
struct SoupResult {
  SoupPoints points;                      ///< those that are left
  SoupTriangles triangles;                ///< the same, of these points
  std::vector<std::uint32_t> labels;      ///< of the triangles, if the soup had any
  std::vector<SoupChannel> channels;      ///< as many as the soup had, in their order
  std::vector<std::uint32_t> input_faces; ///< of each triangle, which one of the input it is
  /// Of each point of the input, which one it has become, or parameters::vanished. Empty with
  /// SoupOptions::split_vertices.
  std::vector<std::size_t> image;
  Report report; ///< what was done
};

/// Simplifies a polygon soup as `simplify(points, triangles, …)` does with the same policies, to
/// the same bits. No array of the input is copied or changed. Of a soup without triangles nothing
/// is left, neither points nor values.
///
/// Throws std::invalid_argument for options, labels or channels that make no sense, and what
/// `simplify` throws.
SoupResult simplified_soup(const SoupView& soup, const SoupOptions& options = {});

/// The same in place, of a soup that carries nothing. `image`, if there is one, becomes a list of
/// what became of each point of the input: an index of the result, or parameters::vanished.
///
/// Throws as simplified_soup() does; the soup is then as it was.
Report simplify_soup(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options = {},
                     std::vector<std::size_t>* image = nullptr);

} // namespace quadrille

#endif // QUADRILLE_COMPILED_H
