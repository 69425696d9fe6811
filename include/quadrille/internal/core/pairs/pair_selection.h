#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_SELECTION_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_SELECTION_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/pairs/pair_lists.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/pairs.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// The pairs that a policy emits, each once with the lower index first, in order.
inline std::vector<std::array<Index, 2>> emitted_pairs(const PairSource& policy,
                                                       const SurfaceView& surface) {
  if (!policy.selects())
    return {};
  std::vector<std::array<Index, 2>> pairs;
  const EmitPair emit = [&](std::size_t i, std::size_t j) {
    if (i >= surface.points.size() || j >= surface.points.size())
      throw std::out_of_range("quadrille::simplify: the pair policy selected vertices " +
                              std::to_string(i) + " and " + std::to_string(j) + " of " +
                              std::to_string(surface.points.size()));
    if (i != j)
      pairs.push_back({static_cast<Index>((std::min)(i, j)), static_cast<Index>((std::max)(i, j))});
  };
  policy(surface, emit);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

template <std::size_t N>
std::vector<std::array<Index, 2>> emitted_pairs(const PairSource& policy,
                                                const SurfaceInput<N>& input) {
  std::vector<Vector<3>> points;
  points.reserve(input.positions.size());
  for (const Vector<N>& p : input.positions)
    points.push_back(space(p));
  std::vector<Index> constrained;
  for (std::size_t v = 0; v < input.is_fixed.size(); ++v)
    if (input.is_fixed[v])
      constrained.push_back(static_cast<Index>(v));
  return emitted_pairs(policy, SurfaceView{points, input.triangles, constrained});
}

/// The lists of the pairs that a policy selects; where it includes all edges, of the others only.
template <std::size_t N>
PairLists select_pairs(const PairSource& policy, const SurfaceInput<N>& input,
                       TriangleComplex& complex, VertexLabels& labels) {
  if (!policy.selects())
    return {};
  PairLists lists(input.positions.size());
  Index last = none;
  for (const auto& [v, w] : emitted_pairs(policy, input)) {
    if (!complex.has_faces(v) || !complex.has_faces(w))
      continue;
    if (policy.includes_edges() && v != last) {
      labels.clear();
      complex.prune_corners(v, [&](Index face, Index) {
        for (Index neighbour : complex.vertices(face))
          labels.set(neighbour);
      });
      last = v;
    }
    if (!policy.includes_edges() || !labels.is_labelled(w))
      lists.add(v, w);
  }
  return lists;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_SELECTION_H
