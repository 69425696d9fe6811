#ifndef QUADRILLE_INTERNAL_CONTRACTION_DISPLACEMENT_H
#define QUADRILLE_INTERNAL_CONTRACTION_DISPLACEMENT_H

#include <algorithm>
#include <cstdint>

namespace quadrille::internal {

/// How much of a surface a contraction moves, times the square of how far, as a part of the fourth
/// power of the diagonal: its error² · reach², or its cost where that is less, as it is of narrow
/// faces. (Lines along boundaries weigh much in a cost, so it is no measure by itself.) A whole
/// number, so that the sum of many does not depend on their order, and threads may add them up in
/// any.
class Displacement {
public:
  /// `diagonal` of the surface in the mesh's unit, `length` the same in the engine's.
  Displacement(double diagonal, double length)
      : to_engine_(diagonal > 0 ? length / diagonal : 0),
        factor_(length > 0 ? one / length / length / length / length : 0) {}

  /// `error` in the mesh's unit, the others in the engine's.
  std::uint64_t operator()(double error, double squared_reach, double cost) const {
    const double way = to_engine_ * error;
    const double part = factor_ * (std::min)(cost, way * way * squared_reach);
    return part > 0 && part < most ? static_cast<std::uint64_t>(part) : 0; // else it is no distance
  }

  /// A sum of them as a part of the fourth power of the diagonal.
  static double part(std::uint64_t sum) { return static_cast<double>(sum) / one; }

private:
  static constexpr double one = 0x1p52, most = 4 * one;

  double to_engine_, factor_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_DISPLACEMENT_H
