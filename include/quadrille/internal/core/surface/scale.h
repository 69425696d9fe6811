#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_SCALE_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_SCALE_H

#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/power_of_two.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// Between the mesh's units and the engine's. Lengths change by a power of two, which is exact both
/// ways: the engine works on a surface of a fixed size, so that no product of lengths over- or
/// underflows, whatever the mesh's unit. Attributes also change by their weights. A cost that is
/// not scale-free keeps the engine to the mesh's unit.
template <std::size_t N>
class Scale {
public:
  Scale(const Box<N>& box, bool is_scale_free) : diagonal_(box.diagonal()) {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, box.half_extent(i));
    if (extent > 0)
      exponent_ = size_exponent - std::ilogb(extent);
    if (is_scale_free) {
      to_engine_ = PowerOfTwo(exponent_);
      to_mesh_ = PowerOfTwo(-exponent_);
    }
    weights_.coordinates.fill(1);
  }

  /// Sets the weights of the attributes in a box. Throws std::invalid_argument if the attributes,
  /// times their weights, are too large or too small to be compared with the lengths of the
  /// surface.
  void set_attribute_weights(const Vector<N - 3>& weights, const Box<N>& box) {
    weights_ = weights;
    const std::array ends{position_from_mesh(box.low), position_from_mesh(box.high)};
    for (std::size_t i = 3; i < N; ++i) {
      const double range = ends[1][i] - ends[0][i];
      if (!std::isnormal(weights_[i - 3]) || !(std::abs(range) <= greatest_range))
        throw std::invalid_argument(
            "quadrille::simplify: attribute " + std::to_string(i - 3) + ", from " +
            text_of(box.low[i]) + " to " + text_of(box.high[i]) + ", weighs " +
            text_of(weights_[i - 3]) + " on a surface of diagonal " + text_of(diagonal_) +
            ": too large or too small to be compared with lengths of the surface");
    }
  }

  template <class Positions>
  Positions scaled(Positions positions) const {
    for (Vector<N>& p : positions)
      p = position_from_mesh(p);
    return positions;
  }
  Vector<N> position_from_mesh(Vector<N> p) const {
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = to_engine_(p[i]);
    for (std::size_t i = 3; i < N; ++i)
      p[i] = to_engine_(p[i] * weights_[i - 3]);
    return p;
  }

  /// From now on, written values are rounded to floats, as far as as_written() shows.
  void write_floats() { writes_floats_ = true; }
  bool writes_floats() const { return writes_floats_; }

  /// Returns a position as it will be once it has been written to the user's mesh.
  Vector<N> as_written(Vector<N> p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = to_mesh_(p[i]);
      p[i] = to_engine_(writes_floats_ ? static_cast<double>(to_number<float>(x)) : x);
    }
    return p;
  }
  /// By how much that moves a coordinate of such a size at most, and arithmetic does.
  double rounding(double coordinate) const {
    return coordinate * (writes_floats_ ? 0x1p-24 : 0x1p-53);
  }

  double length_from_mesh(double length) const { return to_engine_(length); }
  double length_of_mesh(double length) const { return to_mesh_(length); }

  Vector<N> position_of_mesh(Vector<N> p) const {
    for (std::size_t i = 0; i < N; ++i)
      p[i] = length_of_mesh(p[i]);
    for (std::size_t i = 3; i < N; ++i)
      p[i] /= weights_[i - 3];
    return p;
  }

  /// A quadric about its vertex in the mesh's units, divided by its weight: a plane in N dimensions
  /// adds N − 2 times its own to the trace.
  QuadricForm<N> mean_of_mesh(const QuadricForm<N>& form) const {
    const double weight = form.trace() / (N - 2);
    if (!(weight > 0))
      return {};
    const auto unit = [&](std::size_t i) { return i < 3 ? 1 : weights_[i - 3]; };
    SymmetricMatrix<N> a;
    Vector<N> g;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        a.set(i, j, unit(i) * unit(j) * form.matrix()(i, j) / weight);
      g[i] = unit(i) * length_of_mesh(form.gradient()[i] / weight);
    }
    return QuadricForm<N>(a, g, length_of_mesh(length_of_mesh(form.constant() / weight)));
  }

  /// The diagonal of the bounding box, in the mesh's unit.
  double diagonal() const { return diagonal_; }

  /// By which lengths would be multiplied if the cost were scale-free.
  int exponent() const { return exponent_; }

private:
  // With an extent of about 2^20 a cost, an area times a squared distance, is at most about 2^80,
  // and a float holds costs down to 2^-226 of that.
  static constexpr int size_exponent = 20;
  static constexpr double greatest_range = 0x1p40; // its square times an area, too

  int exponent_ = 0;
  bool writes_floats_ = false;
  PowerOfTwo to_engine_{0}, to_mesh_{0};
  double diagonal_;
  Vector<N - 3> weights_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_SCALE_H
