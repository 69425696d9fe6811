#ifndef QUADRILLE_EDGE_LENGTH_H
#define QUADRILLE_EDGE_LENGTH_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille {

/// The shortest pair first: the scheme that quadrics are always compared with. A vertex remembers
/// nothing, and every position costs the squared distance of the two ends, so there is none of
/// least cost: it goes with MidpointPlacement or EndpointPlacement.
struct EdgeLength {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = EdgeLength;               ///< as well in any unit: see CostPolicy

  /// Values grow with that power of lengths.
  double degree() const { return 2; }

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

/// Stops, with the cost EdgeLength, when each pair that may be contracted is longer than `length`,
/// in the mesh's units: `simplify<EdgeLength, MidpointPlacement>(mesh, ShortestEdge{0.5})`. Edges
/// that are left and not longer are those of which the contraction is refused: by the link
/// condition, so in narrow necks, and by filters. With Topology::free and NormalFlip{180} there are
/// none.
///
/// To other costs the length is a limit of Status::next_error.
struct ShortestEdge {
  double length; ///< at least 0

  /// Is it enough? The queue keeps costs as floats, so a pair may have its turn before one that is
  /// shorter by less than a part in 2^24: one that is longer than the limit by up to a part in 2^22
  /// is contracted, so that none is left below.
  bool operator()(const Status& status) const { return status.next_error > length * (1 + 0x1p-22); }

  /// Throws std::invalid_argument for a length that is negative or not a number.
  void validate() const {
    if (!(length >= 0))
      throw std::invalid_argument("quadrille::ShortestEdge: the length " +
                                  internal::text_of(length) + " is not a length");
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
