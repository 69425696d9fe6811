#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_BOX_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_BOX_H

#include <quadrille/internal/core/base/safe_length.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace quadrille::internal {

/// The least and the greatest of each coordinate.
template <std::size_t N>
struct Box {
  Vector<N> low, high;

  Box() = default;
  Box(const Vector<N>& least, const Vector<N>& greatest) : low(least), high(greatest) {}

  template <class Positions>
  explicit Box(const Positions& positions) : Box(positions, [](std::size_t) { return true; }) {}

  /// Returns the box of the positions v for which counts(v) is true.
  template <class Positions, class Counts>
  Box(const Positions& positions, Counts counts) {
    Vector<N> least, greatest; // no members, which would be written each time
    least.coordinates.fill((std::numeric_limits<double>::max)());
    greatest.coordinates.fill(std::numeric_limits<double>::lowest());
    bool is_empty = true;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (!counts(v))
        continue;
      is_empty = false;
      for (std::size_t i = 0; i < N; ++i) {
        least[i] = (std::min)(least[i], positions[v][i]);
        greatest[i] = (std::max)(greatest[i], positions[v][i]);
      }
    }
    if (!is_empty)
      low = least, high = greatest;
  }

  /// A box of nothing, to which positions are added.
  static Box none() {
    Box box;
    box.low.coordinates.fill((std::numeric_limits<double>::max)());
    box.high.coordinates.fill(std::numeric_limits<double>::lowest());
    return box;
  }
  void add(const Vector<N>& position) {
    for (std::size_t i = 0; i < N; ++i) {
      low[i] = (std::min)(low[i], position[i]);
      high[i] = (std::max)(high[i], position[i]);
    }
  }

  /// Half of the extent: the difference of the halves can't overflow.
  double half_extent(std::size_t i) const { return 0.5 * high[i] - 0.5 * low[i]; }
  /// At most the greatest double.
  double diagonal() const {
    const double half = safe_length(half_extent(0), half_extent(1), half_extent(2));
    return 2 * (std::min)(half, (std::numeric_limits<double>::max)() / 2);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_BOX_H
