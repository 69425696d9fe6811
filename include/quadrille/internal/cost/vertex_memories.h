#ifndef QUADRILLE_INTERNAL_COST_VERTEX_MEMORIES_H
#define QUADRILLE_INTERNAL_COST_VERTEX_MEMORIES_H

#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/cost/initial_memories.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/policy/given_memories.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/vector.h>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What each vertex remembers of the surface: for a quadric, the sum over its planes.
template <class Cost>
class VertexMemories {
public:
  using Memory = typename Cost::Memory;
  using Positions = Array<Vector<Cost::dimension>>;

  explicit VertexMemories(Workspace* workspace) : memories_(workspace) {}

  const Memory& operator[](Index v) const { return memories_[v]; }
  Memory& operator[](Index v) { return memories_[v]; }

  /// Vertices remember the surface as it is now. is_interior(v) tells of vertices that have no
  /// boundary edge for certain.
  template <class IsInterior>
  void remember(const Cost& cost, const Positions& positions, TriangleComplex& complex,
                VertexLabels& labels, const std::vector<std::array<Index, 2>>& creases,
                const SharedVertices& shared, IsInterior is_interior, Threads threads) {
    InitialMemories<Cost>::compute(memories_, cost, positions, complex, labels, creases, shared,
                                   is_interior, threads);
  }

  /// Adds what vertices of the input leave that the cost knows by their indices, for a cost that
  /// does: of all that a vertex stands for.
  void remember_input([[maybe_unused]] const Cost& cost,
                      [[maybe_unused]] const Numbering& numbering) {
    if constexpr (RemembersByIndex<Cost>) {
      const InputIndices numbers = numbering.vertices.inverse();
      for (Index input = 0; input < numbering.vertices.input_count(); ++input)
        if (const Index v = numbers[numbering.image(input)]; v != none)
          memories_[v] += cost.input_vertex(input);
    }
  }

  /// Adds what further creases leave, with a weight of their own.
  void remember_creases(Cost cost, double weight, const Positions& positions,
                        TriangleComplex& complex,
                        const std::vector<std::array<Index, 2>>& creases) {
    if constexpr (requires { cost.crease_weight; })
      cost.crease_weight = weight;
    InitialMemories<Cost>::add_creases(memories_, cost, positions, complex, creases);
  }

  /// Those vertices to which memories are given remember these and nothing else.
  void take_given(const GivenMemories<Memory>& given, const InputIndices& input_vertices) {
    for (Index v = 0; v < memories_.size(); ++v)
      if (const Index input = input_vertices[v]; given.has(input))
        memories_[v] = given.memories[input];
  }

  static auto vertex_columns(auto& self) { return std::tie(self.memories_); }

  /// The vertex that a contraction has left remembers what both of its ends did.
  template <class Event>
  void after(const Event& event) {
    const auto& pair = event.contraction.pair();
    Memory& memory = memories_[event.kept];
    memory = pair.memory;
    move_origin(memory, event.contraction.target() - pair.first);
  }

  /// All of it, which is no longer here then.
  UninitializedArray<Memory> take() { return std::move(memories_); }

private:
  UninitializedArray<Memory> memories_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COST_VERTEX_MEMORIES_H
