#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_AFFINE_MAPS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_AFFINE_MAPS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// \file
/// Attributes as affine maps from space. A face of weight a, on which an attribute is the map s(x),
/// costs a |s − s(x)|² where the attribute is s at x. Summed over faces,
///
///     Σ a |s − s(x)|² = w |s − L(x)|² + R(x)    with w = Σ a and L = Σ a s(x) / w:
///
/// the attribute of least cost is L(x), and R is a quadric in space, a sum of squares. Two such
/// sums are joined by w = w₁ + w₂, L = (w₁L₁ + w₂L₂) / w and R = R₁ + R₂ + (w₁w₂ / w)(L₁ − L₂)².
/// Source: Hoppe, New Quadric Metric, 1999, and Hoppe and Marschner, Efficient Minimization of New
/// Quadric Metric, 2000, with the attributes eliminated.

/// One attribute about a vertex: its gradient, and its value there.
struct AffineMap {
  Vector<3> gradient;
  double value = 0;

  double at(const Vector<3>& x) const { return value + dot(gradient, x); }
};

/// Twice the area of a triangle in the texture, negative if it is turned over.
inline double doubled_area(const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// A symmetric 2 × 2 matrix, of two attributes: xx, xy, yy.
using Matrix2 = std::array<double, 3>;

/// The attributes of a wedge: weight, maps, and the boundary constraint of a chart: a weight of two
/// attributes together, 0 elsewhere.
struct WedgeMap {
  double weight = 0;
  Matrix2 boundary{};
  boost::container::small_vector<AffineMap, 4> maps;

  void move_origin(const Vector<3>& d) {
    for (AffineMap& map : maps)
      map.value = map.at(d);
  }
};

/// weight · (normal · x + offset)².
template <class Scalar>
QUADRILLE_ALWAYS_INLINE inline QuadricForm<3, Scalar>
squared_plane(const Vector<3, Scalar>& normal, std::type_identity_t<Scalar> offset,
              std::type_identity_t<Scalar> weight) {
  const Vector<3, Scalar> weighted = weight * normal;
  return QuadricForm<3, Scalar>(SymmetricMatrix<3, Scalar>::outer_product(normal, weight),
                                offset * weighted, weight * offset * offset);
}

/// Joins the maps of wedges, in weights of a channel.
class MapJoiner {
public:
  /// The squares of the lengths that a step of 1 in each component counts as.
  explicit MapJoiner(std::vector<double> squared_weights)
      : squared_weights_(std::move(squared_weights)) {}

  const std::vector<double>& squared_weights() const { return squared_weights_; }

  /// Adds what the two disagree about, and makes the first the map of both. `second` is seen at
  /// `displacement` from its own origin.
  void join(WedgeMap& first, const WedgeMap& second, const Vector<3>& displacement,
            QuadricForm<3>& form) const {
    const bool has_boundary = is_boundary(first) || is_boundary(second);
    if (has_boundary && first.maps.size() == 2)
      join_boundaries(first, second, displacement, form);
    else
      join_weights(first, second, displacement, form);
  }

  /// Returns the weight of what two wedges disagree about, by theirs.
  static double parallel(double first, double second) {
    const double sum = first + second;
    return sum > 0 ? first * second / sum : 0;
  }

  /// Adds what two wedges of texture coordinates disagree about, which is `off`.
  void add_boundary_difference(double first_weight, const Matrix2& first_boundary,
                               double second_weight, const Matrix2& second_boundary,
                               const std::array<AffineMap, 2>& off, QuadricForm<3>& form) const {
    const Matrix2 w1 = matrix(first_weight, first_boundary);
    if (const auto t = share(w1, matrix(second_weight, second_boundary))) {
      add_parallel(w1, *t, off, form);
      return;
    }
    const double weight = parallel(first_weight, second_weight);
    for (std::size_t c = 0; c < 2; ++c)
      form += squared_plane(off[c].gradient, off[c].value, weight * squared_weights_[c]);
  }

  /// Adds what it costs that the wedge has other values than its map at its origin.
  void constrain(const WedgeMap& wedge, const double* values, QuadricForm<3>& form) const {
    double cost = 0;
    for (std::size_t c = 0; c < squared_weights_.size(); ++c) {
      const double off = values[c] - wedge.maps[c].value;
      cost += wedge.weight * squared_weights_[c] * off * off;
    }
    if (is_boundary(wedge) && wedge.maps.size() == 2) {
      const double u = values[0] - wedge.maps[0].value, v = values[1] - wedge.maps[1].value;
      cost += wedge.boundary[0] * u * u + 2 * wedge.boundary[1] * u * v + wedge.boundary[2] * v * v;
    }
    form += QuadricForm<3>({}, {}, cost);
  }

  static bool is_boundary(const WedgeMap& wedge) {
    return wedge.boundary[0] + wedge.boundary[2] > 0;
  }

private:
  void join_weights(WedgeMap& first, const WedgeMap& second, const Vector<3>& displacement,
                    QuadricForm<3>& form) const {
    const double weight = parallel(first.weight, second.weight);
    for (std::size_t c = 0; c < first.maps.size(); ++c)
      form += squared_plane(second.maps[c].gradient - first.maps[c].gradient,
                            second.maps[c].at(displacement) - first.maps[c].value,
                            weight * squared_weights_[c]);
    const double sum = first.weight + second.weight;
    const double fraction = sum > 0 ? second.weight / sum : 0;
    for (std::size_t c = 0; c < first.maps.size(); ++c) {
      AffineMap& map = first.maps[c];
      map.value += fraction *
                   (second.maps[c].at(displacement) - map.value); // equal values stay what they are
      map.gradient += fraction * (second.maps[c].gradient - map.gradient);
    }
    first.weight = sum;
  }

  // With matrices W₁ and W₂ for weights: T = (W₁ + W₂)⁻¹ W₂ takes the first map towards the second,
  // and the difference costs W₁ T.
  void join_boundaries(WedgeMap& first, const WedgeMap& second, const Vector<3>& displacement,
                       QuadricForm<3>& form) const {
    const Matrix2 w1 = matrix(first.weight, first.boundary);
    if (const auto t = share(w1, matrix(second.weight, second.boundary))) {
      std::array<AffineMap, 2> off;
      for (std::size_t c = 0; c < 2; ++c)
        off[c] = {second.maps[c].gradient - first.maps[c].gradient,
                  second.maps[c].at(displacement) - first.maps[c].value};
      add_parallel(w1, *t, off, form);
      for (std::size_t c = 0; c < 2; ++c) {
        first.maps[c].gradient += (*t)[2 * c] * off[0].gradient + (*t)[2 * c + 1] * off[1].gradient;
        first.maps[c].value += (*t)[2 * c] * off[0].value + (*t)[2 * c + 1] * off[1].value;
      }
      first.weight += second.weight;
    } else {
      join_weights(first, second, displacement, form);
    }
    for (std::size_t i = 0; i < 3; ++i)
      first.boundary[i] += second.boundary[i];
  }

  // Returns T = adj(W₁ + W₂) W₂ / det; nothing if W₁ + W₂ is singular.
  static std::optional<std::array<double, 4>> share(const Matrix2& w1, const Matrix2& w2) {
    const Matrix2 sum{w1[0] + w2[0], w1[1] + w2[1], w1[2] + w2[2]};
    const double determinant = sum[0] * sum[2] - sum[1] * sum[1];
    if (!(determinant > 1e-14 * sum[0] * sum[2]))
      return std::nullopt;
    return std::array{(sum[2] * w2[0] - sum[1] * w2[1]) / determinant,
                      (sum[2] * w2[1] - sum[1] * w2[2]) / determinant,
                      (sum[0] * w2[1] - sum[1] * w2[0]) / determinant,
                      (sum[0] * w2[2] - sum[1] * w2[1]) / determinant};
  }

  // The form offᵀ W₁T off as two squares: W₁T is symmetric and positive semidefinite.
  static void add_parallel(const Matrix2& w1, const std::array<double, 4>& t,
                           const std::array<AffineMap, 2>& off, QuadricForm<3>& form) {
    const double xx = w1[0] * t[0] + w1[1] * t[2];
    const double xy = w1[0] * t[1] + w1[1] * t[3];
    const double yy = w1[1] * t[1] + w1[2] * t[3];
    if (!(xx > 0)) {
      form += squared_plane(off[1].gradient, off[1].value, (std::max)(0.0, yy));
      return;
    }
    const double l = xy / xx;
    form +=
        squared_plane(off[0].gradient + l * off[1].gradient, off[0].value + l * off[1].value, xx);
    form += squared_plane(off[1].gradient, off[1].value, (std::max)(0.0, yy - l * xy));
  }

  Matrix2 matrix(double weight, const Matrix2& boundary) const {
    return {weight * squared_weights_[0] + boundary[0], boundary[1],
            weight * squared_weights_[1] + boundary[2]};
  }

  std::vector<double> squared_weights_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_AFFINE_MAPS_H
