#ifndef QUADRILLE_INTERNAL_CORE_STATE_SETUP_H
#define QUADRILLE_INTERNAL_CORE_STATE_SETUP_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/joined_vector.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/topology.h>
#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file
/// What a working surface is made of.

namespace quadrille::internal {

/// Edges that the user has named as creases, by the input indices of their ends.
class NamedCreases {
public:
  using Edge = std::array<Index, 2>;

  explicit NamedCreases(std::vector<Edge> edges) : edges_(std::move(edges)) {}

  /// Their ends have become parts of other vertices.
  void follow(const Numbering& numbering) {
    for (auto& [v, w] : edges_)
      v = numbering.image(v), w = numbering.image(w);
    std::erase_if(edges_, [](const Edge& edge) { return edge[0] == edge[1]; });
  }

  /// By the engine's numbers; without those that have lost their faces.
  std::vector<Edge> left(const Numbering& numbering) const {
    std::vector<Edge> left;
    if (edges_.empty())
      return left;
    const InputIndices numbers = numbering.vertices.inverse();
    for (const auto& [v, w] : edges_)
      if (const Index p = numbers[v], q = numbers[w]; p != none && q != none)
        left.push_back({p, q});
    return left;
  }

private:
  std::vector<Edge> edges_;
};

/// The units of a surface in a box, with the weights that the cost gives its attributes. Floats are
/// written where something is promised that their rounding could break.
template <class Policies, std::size_t N>
Scale<N> scale_of(const SurfaceInput<N>& input, const Box<N>& box, const Policies& policies) {
  using Cost = typename Policies::Cost;
  const Cost& cost = policies.cost;
  Scale<N> scale(box, is_scale_free<Cost>);
  if (input.writes_floats && (needs_closed_surface<typename Policies::Placement> ||
                              !policies.guards.empty() || policies.stop.needs().distance))
    scale.write_floats();
  if constexpr (requires {
                  cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), 1.0);
                })
    scale.set_attribute_weights(
        cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), box.diagonal()),
        box);
  return scale;
}

/// The triangles of an input. A pair policy of the user's wants to see them once more.
template <std::size_t N>
Array<TriangleComplex::Triangle> take_triangles(const PairSource& pairs, SurfaceInput<N>& input) {
  if (pairs.selects())
    return input.triangles;
  return std::move(input.triangles);
}

/// Is topology kept? Unless the user says, it is free if there are pairs that are not edges.
inline bool keeps_topology(std::optional<Topology> topology, bool has_other_pairs) {
  return topology.value_or(has_other_pairs ? Topology::free : Topology::kept) != Topology::free;
}

/// One for each thread.
inline std::vector<Scratch> scratches_for(unsigned threads, const TriangleComplex& complex) {
  std::vector<Scratch> scratches;
  scratches.reserve(threads);
  for (unsigned i = 0; i < threads; ++i)
    scratches.emplace_back(complex.vertex_capacity(), complex.workspace()).number = i;
  return scratches;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_SETUP_H
