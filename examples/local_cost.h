#ifndef QUADRILLE_EXAMPLES_LOCAL_COST_H
#define QUADRILLE_EXAMPLES_LOCAL_COST_H

#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/thin_feature_quadric.h>
#include <quadrille/vector.h>

namespace quadrille_examples {

/// The costs that look at the surface as it is, one of them chosen at run time, so that the engine
/// is compiled once for all three. Edge lengths go with a placement that asks for no minimizer.
struct LocalCost : quadrille::ThinFeatureQuadric {
  using ScaleFree = LocalCost;
  using Position = quadrille::Vector<3>;

  enum Kind { memoryless, thin_features, length };
  Kind kind = memoryless;

  Memory face(const Position& p, const Position& q, const Position& r) const {
    return kind == thin_features ? ThinFeatureQuadric::face(p, q, r) : Memory{};
  }
  Current current_face(const Position& p, const Position& q, const Position& r) const {
    return kind == thin_features ? ThinFeatureQuadric::current_face(p, q, r)
                                 : MemorylessQuadric::current_face(p, q, r);
  }
  Current current_boundary(const Position& p, const Position& q, const Position& r) const {
    return kind == thin_features ? ThinFeatureQuadric::current_boundary(p, q, r)
                                 : MemorylessQuadric::current_boundary(p, q, r);
  }

  double operator()(const auto& pair, const Position& x) const {
    return kind == length          ? quadrille::EdgeLength{}(pair, x)
           : kind == thin_features ? ThinFeatureQuadric::operator()(pair, x)
                                   : MemorylessQuadric::operator()(pair, x);
  }
  double tie_break(const auto& pair, const Position& x) const {
    return kind == length ? 0 : MemorylessQuadric::tie_break(pair, x);
  }
  double squared_error(const auto& pair, double cost) const {
    return kind == length ? cost : MemorylessQuadric::squared_error(pair, cost);
  }
};

} // namespace quadrille_examples

#endif
