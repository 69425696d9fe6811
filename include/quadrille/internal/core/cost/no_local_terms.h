#ifndef QUADRILLE_INTERNAL_CORE_COST_NO_LOCAL_TERMS_H
#define QUADRILLE_INTERNAL_CORE_COST_NO_LOCAL_TERMS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/shared_vertices.h>

#include <tuple>

namespace quadrille::internal {

/// For a cost that does not look at the surface as it is.
struct NoLocalTerms {
  template <class Cost, class Geometry>
  NoLocalTerms(const Cost&, const Geometry&, const TriangleComplex&, const LinkCondition&,
               const SharedVertices&) {}
  double unevenness(Index) const { return 0; }
  void sum_up(VertexLabels&) {}
  void sum_up(Index, VertexLabels&) {}
  static auto vertex_arrays(auto&) { return std::tuple<>(); }
};

/// The local terms of a cost that has none: see local_terms.h, which costs with local terms
/// include.
template <class Cost>
struct LocalTermsOf {
  static_assert(
      !has_local_terms<Cost>,
      "The cost has local terms (Current): include <quadrille/memoryless_quadric.h>, which "
      "sums them up.");
  using type = NoLocalTerms;
};

template <class Cost>
class LocalStar; // is in local_star.h

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COST_NO_LOCAL_TERMS_H
