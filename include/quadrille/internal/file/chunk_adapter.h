#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_ADAPTER_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_ADAPTER_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/adapter/label_numbers.h>
#include <quadrille/internal/core/adapter/soup_base.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/cost/vertex_states.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A chunk of a surface, which meets other chunks at vertices that are shared: see SharedVertices.
/// Vertices are identified by their indices in `positions`.
template <class Cost>
struct Chunk {
  static constexpr std::size_t dimension = Cost::dimension;
  using State = typename Cost::State;

  std::vector<Vector<dimension>> positions; ///< in the mesh's units, followed by the attributes of
                                            ///< the cost
  std::vector<std::array<Index, 3>> triangles; ///< indices of positions
  std::vector<bool> is_shared = {};            ///< for each position; if empty, none is
  std::vector<bool> is_fixed = {};             ///< for each position, whether it stays for another
                                               ///< reason
  /// Edges of one face between shared vertices that are boundaries of the whole surface.
  std::vector<std::array<Index, 2>> boundaries = {};
  /// The box of the whole surface, or a larger one: it determines the units, and the weights of
  /// attributes.
  Box<dimension> box = {};
  /// The state of each position, as ChunkResult returns it, summed up over the chunks. If it is
  /// empty, all states are made from the faces of this chunk. For a cost without states it is
  /// empty.
  std::vector<State> states = {};
  /// For each position, whether its state is given. If it is empty, all states are given, or none.
  std::vector<bool> has_state = {};
  /// The bound of each triangle, as ChunkResult returns it, if the stop policy requires distances;
  /// if it is empty, all triangles are of the input.
  std::vector<FaceBound> bounds = {};
  /// For each position, a distance in the mesh's units, if the stop policy requires tolerances and
  /// triangles have no bounds, which include them: see ToleranceLimit.
  std::vector<double> tolerances = {};
  /// The greatest tolerance, in the mesh's units, of the triangles of the input of all chunks, if
  /// bounds include tolerances: it affects Report::distance_bound and nothing else.
  double greatest_tolerance = 0;
  /// Any number for each triangle; the regions of equal numbers are kept as by `Labels`. If it is
  /// empty, there are none.
  std::vector<Index> labels = {};
};

/// A channel of a chunk, with one value per vertex: see Attributes.
struct ChunkChannel {
  std::size_t components = 0; ///< at least 1
  std::vector<double> values; ///< for each position, one component after another, finite
  /// The weights of the channel. `weights` are given, so that the channel counts equally in all
  /// chunks: the default weights depend on the values in the chunk.
  ChannelOptions options = {};
};

/// The channels of a chunk, as an argument of simplify_chunk(); for costs in space.
struct ChunkChannels {
  std::vector<ChunkChannel> channels;

  void validate() const {
    for (const ChunkChannel& channel : channels)
      channel.options.validate();
  }
};
/// The simplified chunk. Points and triangles keep their order.
template <class Cost>
struct ChunkResult {
  std::vector<Vector<Cost::dimension>> positions; ///< in the mesh's units; fixed ones keep their
                                                  ///< bits
  std::vector<Index> vertices;                    ///< the vertex of the chunk that each position
                                                  ///< was
  std::vector<std::array<Index, 3>> triangles;    ///< indices of `positions`
  std::vector<Index> faces;                       ///< the triangle of the chunk that each triangle
                                                  ///< was
  /// The bounds of `triangles`; empty if the stop policy requires no distances.
  std::vector<FaceBound> bounds;
  /// The state of each position, in the engine's units, relative to the position. For a shared
  /// vertex that had been given a state, it is the amount that was added to that state. So the new
  /// state of a shared vertex is the given state, plus the sum over all chunks. It is empty if the
  /// cost has no states.
  std::vector<typename Cost::State> states;
  /// The values of each channel, by position; fixed vertices keep the bits of their values.
  std::vector<std::vector<double>> channels;
  CostHistogram costs; ///< the costs of the contractions, by keys in the engine's unit
  Report report;       ///< the report of the chunk
};

/// Reads a chunk, and writes its result, in linear time.
template <class Cost, bool has_channels>
class ChunkAdapter {
public:
  static constexpr std::size_t dimension = Cost::dimension;
  using Input = InputOf<dimension, has_channels>;
  using State = typename Cost::State;

  /// `given` are the states of the chunk, `channels` are its channels; null if it has none.
  ChunkAdapter(Chunk<Cost>& chunk, const GivenStates<State>& given, const ChunkChannels* channels,
               ChunkResult<Cost>& result, Arena& arena)
      : arena_(&arena), chunk_(chunk), given_(given), channels_(channels), result_(result) {}

  /// Throws std::invalid_argument as a soup does, and for lists of the wrong length. Most of the
  /// data is no longer in the chunk then.
  Input read() {
    TriangleComplex::check_size(chunk_.positions.size(), chunk_.triangles.size());
    require_lengths();
    Input input(arena_);
    input.has_duplicate_faces = input.may_have_reverse_faces = true;
    input.reserve(chunk_.positions.size(), chunk_.triangles.size());
    const std::size_t count = chunk_.positions.size();
    for (std::size_t v = 0; v < count; ++v) {
      input.positions.push_back(chunk_.positions[v]);
      require_finite(input.positions.back(), v);
    }
    if constexpr (dimension == 3)
      chunk_.positions = {};
    for (std::size_t face = 0; face < chunk_.triangles.size(); ++face)
      input.triangles.push_back(
          read_triangle("quadrille::simplify", chunk_.triangles[face], face, count));
    chunk_.triangles = {};
    input.is_fixed = std::move(chunk_.is_fixed);
    for (Index v = 0; v < chunk_.is_shared.size(); ++v)
      if (chunk_.is_shared[v])
        input.share(v);
    input.boundaries = std::move(chunk_.boundaries);
    input.given_box = chunk_.box;
    input.writes_floats = are_floats(input);
    for (Index v = 0; v < chunk_.tolerances.size(); ++v)
      input.limit(v, chunk_.tolerances[v], v);
    chunk_.tolerances = {};
    if (!chunk_.labels.empty())
      number_labels(input);
    if constexpr (has_channels)
      read_channels(count, input);
    return input;
  }

  template <class Result, class AnyReporter>
  std::size_t write(const Result& result, const AnyReporter&) {
    const Array<Index> inputs = result.input_vertices();
    const Array<Index> vertices = in_order(inputs, result.input_vertex_count());
    const Array<Index> new_index = places(vertices, vertices.size());
    for (Index v : vertices) {
      result_.positions.push_back(position(result, v, inputs[v]));
      result_.vertices.push_back(inputs[v]);
      if constexpr (AnyReporter::asks_for_states)
        result_.states.push_back(gained(result.state(v), inputs[v]));
    }
    if constexpr (has_channels)
      write_channels(result, vertices);
    const Array<Index> input_faces = result.input_faces();
    for (Index face : in_order(input_faces, result.input_face_count())) {
      const auto [p, q, r] = result.corners(face);
      result_.triangles.push_back({new_index[p], new_index[q], new_index[r]});
      result_.faces.push_back(input_faces[face]);
    }
    return 0;
  }

private:
  void require_lengths() const {
    const std::size_t points = chunk_.positions.size();
    const auto require = [](const char* name, const auto& list, std::size_t wanted) {
      if (!list.empty() && list.size() != wanted)
        throw std::invalid_argument("quadrille: a tile has " + std::to_string(list.size()) + " " +
                                    name + ", not " + std::to_string(wanted));
    };
    require("values of is_shared", chunk_.is_shared, points);
    require("values of is_fixed", chunk_.is_fixed, points);
    require("values of has_state", given_.is_given, points);
    require("states", given_.states, points);
    require("tolerances", chunk_.tolerances, points);
    require("labels", chunk_.labels, chunk_.triangles.size());
    for (const auto& edge : chunk_.boundaries)
      for (Index v : edge)
        if (v >= points)
          throw std::invalid_argument("quadrille: a border of a tile refers to point " +
                                      std::to_string(v) + " of " + std::to_string(points));
  }

  // A position that has not moved keeps its bits: the weights of attributes would round the
  // numbers.
  template <class Result>
  Vector<dimension> position(const Result& result, Index v, [[maybe_unused]] Index input) const {
    if constexpr (dimension > 3)
      if (!result.is_moved(v))
        return chunk_.positions[input];
    return result.position(v);
  }

  // The numbers of a file of floats are all floats.
  static bool are_floats(const SurfaceInput<dimension>& input) {
    const auto is_float = [](double x) { return static_cast<double>(to_number<float>(x)) == x; };
    return std::all_of(input.positions.begin(), input.positions.end(), [&](const auto& p) {
      return is_float(p[0]) && is_float(p[1]) && is_float(p[2]);
    });
  }

  void read_channels(std::size_t points, Input& input) {
    for (const ChunkChannel& channel : channels_->channels) {
      if (channel.components == 0 || channel.values.size() != points * channel.components)
        throw std::invalid_argument("quadrille: a channel of a tile has " +
                                    std::to_string(channel.values.size()) + " numbers for " +
                                    std::to_string(points) + " values of " +
                                    std::to_string(channel.components));
      ChannelInput read(channel.options, channel.components, Attribute::any, *arena_);
      read.values.assign(channel.values.begin(), channel.values.end());
      read.require_finite();
      read.as_written = [](std::span<double>, bool) { return true; };
      input.channels.push_back(std::move(read));
    }
  }

  // A value that no contraction has changed is the value of an input vertex.
  template <class Result>
  void write_channels(const Result& result, const Array<Index>& vertices) {
    for (std::size_t c = 0; c < channels_->channels.size(); ++c) {
      const ChunkChannel& channel = channels_->channels[c];
      std::vector<double>& values = result_.channels.emplace_back();
      for (Index v : vertices) {
        const Index wedge = result.first_wedge(v), origin = result.origin(c, wedge);
        for (std::size_t k = 0; k < channel.components; ++k)
          values.push_back(origin == none ? result.value(c, wedge, k)
                                          : channel.values[origin * channel.components + k]);
      }
    }
  }

  void number_labels(SurfaceInput<dimension>& input) {
    std::vector<Index> faces(chunk_.labels.size());
    std::iota(faces.begin(), faces.end(), Index{0});
    input.labels = numbers_of_labels(
        boost::make_iterator_property_map(chunk_.labels.begin(), boost::identity_property_map()),
        faces, *arena_);
    chunk_.labels = {};
  }

  State gained(State state, Index vertex) const {
    if (given_.has(vertex) && !chunk_.is_shared.empty() && chunk_.is_shared[vertex])
      state -= given_.states[vertex];
    return state;
  }

  Arena* arena_;
  Chunk<Cost>& chunk_;
  const GivenStates<State>& given_;
  const ChunkChannels* channels_;
  ChunkResult<Cost>& result_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_ADAPTER_H
