#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_APPEARANCE_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_APPEARANCE_H

#include <quadrille/internal/core/appearance/labels_by_face.h>
#include <quadrille/internal/core/appearance/no_channels.h>
#include <quadrille/internal/core/appearance/seam_graph.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/cost/vertex_states.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>

#include <array>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The data that a surface carries in addition to its shape: the labels of faces, the channels of
/// attributes, and the graph of their seams.
template <class Policies>
class Appearance {
public:
  using Cost = typename Policies::Cost;
  using Channels = ChannelsOf<Policies>;
  using Seams = SeamGraph<typename Channels::Seams>;

  Appearance(const Policies& policies, TriangleComplex& complex,
             Geometry<Cost::dimension>& geometry, VertexStates<Cost>& states)
      : policies_(policies), complex_(complex), geometry_(geometry), states_(states),
        channels_(complex, geometry, states) {}

  const Channels& channels() const { return channels_; }
  Channels& channels() { return channels_; }
  const Seams& seams() const { return seams_; }
  Seams& seams() { return seams_; }

  /// Labels are those of each input face, or none. Vertices at corners of the graph stay where they
  /// are from then on.
  template <class Input>
  void read(Input& input, const Numbering& numbering,
            [[maybe_unused]] const Scale<Cost::dimension>& scale,
            [[maybe_unused]] bool are_pairs_edges) {
    Array<Index> labels = labels_by_face(input.labels, numbering.faces, complex_);
    if constexpr (has_channels)
      channels_.read(std::move(input.channels), numbering, labels, scale, are_pairs_edges);
    seams_ = Seams(complex_, std::move(labels), channels_.seams());
    for (Index v = 0; v < complex_.vertex_capacity() && !seams_.is_empty(); ++v)
      if (seams_.is_corner(v))
        geometry_.fix(v);
    if (channels_.have_seams() || !seams_.is_empty())
      complex_.forget_high_valence(); // whose corners would all have to be looked at
  }

  /// Accumulates its current values in the states of vertices.
  void accumulate([[maybe_unused]] const LinkCondition& link_condition) {
    if constexpr (has_channels)
      channels_.accumulate(seams_.labels(), policies_.threads);
    std::vector<std::array<Index, 2>> edges; // of two faces
    seams_.for_each_seam([&](Index v, Index w, const auto& sides) {
      if (sides.size() == 2)
        edges.push_back({v, w});
    });
    if constexpr (has_channels)
      channels_.constrain_boundaries(link_condition, seams_.labels(), !seams_.is_empty());
    states_.accumulate_creases(policies_.cost, policies_.region_boundary_weight,
                               geometry_.positions(), complex_, edges);
  }

  auto take_channels() { return channels_.take(); }

private:
  static constexpr bool has_channels = Policies::has_channels;

  const Policies& policies_;
  TriangleComplex& complex_;
  Geometry<Cost::dimension>& geometry_;
  VertexStates<Cost>& states_;
  QUADRILLE_NO_UNIQUE_ADDRESS Channels channels_;
  Seams seams_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_APPEARANCE_H
