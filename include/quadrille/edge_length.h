#ifndef QUADRILLE_EDGE_LENGTH_H
#define QUADRILLE_EDGE_LENGTH_H

#include <quadrille/vector.h>

#include <cstddef>

namespace quadrille {

/// The shortest pair first: the scheme that quadrics are always compared with. A vertex remembers
/// nothing, and every position costs the squared distance of the two ends, so there is none of
/// least cost: it goes with MidpointPlacement or EndpointPlacement.
struct EdgeLength {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = EdgeLength;               ///< as well in any unit: see CostPolicy

  /// Nothing.
  struct Memory {
    Memory& operator+=(const Memory&) { return *this; } ///< nothing and nothing is nothing
  };

  /// Leaves nothing.
  Memory face(const Vector<3>&, const Vector<3>&, const Vector<3>&) const { return {}; }

  /// The squared distance between the ends of the pair, wherever it goes.
  double operator()(const auto& pair, const Vector<3>& /*x*/) const {
    return squared_distance(pair.first, pair.second);
  }
};

} // namespace quadrille

#endif // QUADRILLE_EDGE_LENGTH_H
