#ifndef QUADRILLE_INTERNAL_CONTRACTION_NAMED_CREASES_H
#define QUADRILLE_INTERNAL_CONTRACTION_NAMED_CREASES_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/surface/numbering.h>

#include <array>
#include <utility>
#include <vector>

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

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_NAMED_CREASES_H
