#ifndef QUADRILLE_COST_LIMIT_H
#define QUADRILLE_COST_LIMIT_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/needs.h>
#include <quadrille/report.h>

#include <stdexcept>

namespace quadrille {

/// Takes no contraction that costs more than a limit, and stops when all others are done: greedy
/// order ends when the next pair in the order costs more, with what tells equal costs apart;
/// passes leave out what costs more, and end when nothing that costs less can be contracted.
///
/// The limit is in the units in which the cost policy computes its values in the mesh's units: of
/// Quadric an area times a squared distance, the fourth power of a length (of plain weights the
/// square of one); of MemorylessQuadric the power 4.5; of EdgeLength the square. A stop policy of
/// one's own learns such numbers from Status::next_cost.
///
/// Pieces of a surface that are simplified apart and up to the same limit, in the scale of the same
/// box, have about the density of one that is simplified whole, whatever their sizes: see
/// vertex_is_shared_map and bounding_box in parameters.h. A target of faces can't do that: what a
/// piece can't reach beside vertices that stay, it would destroy.
///
/// Not checked: the limit of a cost of lengths beyond about 10^±60 is no double any more.
class CostLimit {
public:
  /// `cost` is at least 0; infinity: no limit.
  explicit CostLimit(double cost) : cost_(cost) {}

  /// Looks at Status::next_cost: see StopPolicy.
  static constexpr Needs needs = {.cost = true};

  /// Is it enough?
  bool operator()(const Status& status) const { return status.next_cost > cost_; }

  double cost() const { return cost_; } ///< the limit

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const {
    if (!(cost_ >= 0))
      throw std::invalid_argument("quadrille::CostLimit: the limit " + internal::text_of(cost_) +
                                  " is not a cost");
  }

private:
  double cost_;
};

} // namespace quadrille

#endif // QUADRILLE_COST_LIMIT_H
