#ifndef QUADRILLE_EDGE_LENGTH_H
#define QUADRILLE_EDGE_LENGTH_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille {

/// Contracts the shortest pair first: the baseline that quadrics are compared with. Vertices have
/// no state, and every position costs the squared distance of the two ends. So there is no position
/// of least cost, and the cost is used with MidpointPlacement or EndpointPlacement.
struct EdgeLength {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = EdgeLength;               ///< scale-invariant: see CostPolicy

  /// Returns the power of lengths with which the cost grows.
  double degree() const { return 2; }

  /// The empty state of a vertex.
  struct State {
    State& operator+=(const State&) { return *this; } ///< adds nothing
  };

  /// Returns the empty state.
  State face(const Vector<3>&, const Vector<3>&, const Vector<3>&) const { return {}; }

  /// Returns the squared distance between the ends of the pair, for any target.
  double operator()(const auto& pair, const Vector<3>& /*x*/) const {
    return squared_distance(pair.first, pair.second);
  }
};

/// Stops, with the cost EdgeLength, when each pair that may be contracted is longer than `length`,
/// in the mesh's units: `simplify<EdgeLength, MidpointPlacement>(mesh, ShortestEdge{0.5})`. A
/// shorter edge is only left if its contraction is rejected: by the link condition, as in narrow
/// necks, or by filters. With Topology::free and NormalFlip{180} there is none.
///
/// For other costs the length is a limit on Status::next_error.
struct ShortestEdge {
  double length; ///< at least 0

  /// Returns true once the next pair is longer than the limit. The queue keeps costs as floats, so
  /// a pair may come before one that is shorter by less than a fraction of 2^-24. A pair that is
  /// longer than the limit by up to a fraction of 2^-22 is therefore contracted, so that none is
  /// left below the limit.
  bool operator()(const Status& status) const { return status.next_error > length * (1 + 0x1p-22); }

  /// Throws std::invalid_argument for a length that is negative or not a number.
  void validate() const {
    if (!(length >= 0))
      throw std::invalid_argument("quadrille::ShortestEdge: the length " +
                                  internal::text_of(length) + " is negative or not a number");
  }
};

} // namespace quadrille

#ifdef QUADRILLE_WITH_COMPILED
#include <quadrille/internal/core/call/compiled_engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(extern template, EdgeLength);
} // namespace quadrille::internal
#endif

#endif // QUADRILLE_EDGE_LENGTH_H
