#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_RESULT_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_RESULT_H

#include <quadrille/internal/core/appearance/no_channels.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/finished_surface.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// The vertices and faces of a finished surface that are left, counted off in the engine's order,
/// in which neighbours lie near each other; after all faces come the reverse faces of those that
/// have one. Input indices are those under which an adapter has read them.
template <class Cost, class ChannelsLeft>
class Result {
public:
  using Finished = FinishedSurface<Cost, ChannelsLeft>;
  static constexpr bool has_channels = !std::same_as<ChannelsLeft, NoChannelsLeft>;

  explicit Result(Finished surface)
      : surface_(with_less_memory(std::move(surface))), vertices_(complex().left_vertices()),
        faces_(complex().left_faces()), forward_count_(faces_.size()),
        numbers_(places(vertices_, complex().vertex_capacity())) {
    for (std::size_t forward = 0; forward < forward_count_ && !complex().reverse_faces().is_empty();
         ++forward)
      if (complex().reverse_faces().has(faces_[forward]))
        faces_.push_back(faces_[forward]);
  }

  /// How many an adapter has read.
  std::size_t input_vertex_count() const { return surface_.numbering.vertices.input_count(); }
  std::size_t input_face_count() const { return surface_.numbering.faces.input_count(); }

  /// The input indices of those that are left.
  Array<Index> input_vertices() const { return surface_.numbering.vertices.of(vertices_); }
  Array<Index> input_faces() const {
    Array<Index> inputs = surface_.numbering.faces.of(faces_);
    for (std::size_t reverse = forward_count_; reverse < faces_.size(); ++reverse)
      inputs[reverse] = complex().reverse_faces().input_face(faces_[reverse]);
    return inputs;
  }
  /// Returns the input index of the vertex into which a vertex of the input was merged.
  Index merged_vertex(Index input) const { return surface_.numbering.merged_vertex(input); }

  TriangleComplex::Triangle corners(Index face) const {
    const auto& corners = complex().vertices(faces_[face]);
    const auto number = [&](std::size_t i) {
      return numbers_[corners[corner_of_forward(face, i)]];
    };
    return {number(0), number(1), number(2)};
  }
  bool is_closed() const { return surface_.is_closed; }
  bool is_moved(Index v) const { return surface_.is_moved[vertices_[v]] != 0; }
  /// With attributes, in the units of the mesh.
  auto position(Index v) const {
    return surface_.scale.position_of_mesh(surface_.positions[vertices_[v]]);
  }

  /// Returns the wedge of a corner of a face, in a channel. Those of reverse faces come after all
  /// others.
  Index wedge(std::size_t c, Index face, std::size_t corner) const {
    const Index f = faces_[face], v = complex().vertices(f)[corner_of_forward(face, corner)];
    return surface_.channels.wedge(complex(), c, f, v, is_reverse(face));
  }
  /// The first one of a vertex, in any channel.
  Index first_wedge(Index v) const { return vertices_[v]; }
  /// How many numbers of wedges a channel may use.
  std::size_t wedge_count(std::size_t c) const {
    return surface_.channels.wedge_count(complex(), c);
  }
  std::size_t components(std::size_t c) const requires has_channels {
    return surface_.channels.components(c);
  }
  /// A component of a wedge of a channel.
  double value(std::size_t c, Index wedge, std::size_t component) const {
    return surface_.channels.value(complex(), c, wedge, component);
  }
  /// See WedgeRecords.
  Index origin(std::size_t c, Index wedge) const {
    return surface_.channels.origin(complex(), c, wedge);
  }

  /// Returns the state of a vertex, in the engine's units, about the vertex; if states are kept.
  const typename Cost::State& state(Index v) const { return surface_.states[vertices_[v]]; }

  /// Returns the quadric that vertex_quadric_map reports.
  auto mean_quadric(Index v) const {
    static_assert(std::same_as<typename Cost::State, QuadricForm<Cost::dimension>>,
                  "vertex_quadric_map needs a cost whose State is a QuadricForm: use Quadric or an "
                  "AttributeQuadric.");
    return surface_.scale.mean_of_mesh(surface_.states[vertices_[v]]);
  }

private:
  // Gives back what only contractions needed.
  static Finished with_less_memory(Finished surface) {
    surface.complex.release();
    surface.positions.shrink_to_fit();
    surface.numbering.use_input_indices();
    surface.numbering.vertices.shrink_to_fit();
    return surface;
  }

  const TriangleComplex& complex() const { return surface_.complex; }

  bool is_reverse(Index face) const { return face >= forward_count_; }
  // Returns the place of a corner of a face in the face of the engine.
  std::size_t corner_of_forward(Index face, std::size_t corner) const {
    return is_reverse(face) ? complex().reverse_faces().opposite(faces_[face], corner) : corner;
  }

  Finished surface_;
  Array<Index> vertices_, faces_; // in the engine's numbers
  std::size_t forward_count_;     // from there on they are those of reverse faces
  Array<Index> numbers_;          // of each vertex of the engine, as it is counted off here
};

/// The surface that is left at the end of a call.
template <class Policies>
using ResultOf = Result<typename Policies::Cost, ChannelsLeftOf<Policies>>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_RESULT_H
