#ifndef QUADRILLE_EXAMPLES_GLTF_TRANSFORM_H
#define QUADRILLE_EXAMPLES_GLTF_TRANSFORM_H

#include "json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>

namespace quadrille_examples {

using Vector = std::array<double, 3>;

/// An affine map of space: three columns, and where the origin goes.
class Transform {
public:
  Transform() = default; ///< changes nothing

  /// Of a matrix of glTF: 16 numbers, column by column.
  template <class Numbers>
  static Transform of_matrix(const Numbers& numbers) {
    Transform result;
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t row = 0; row < 3; ++row)
        result.columns_[column][row] = numbers[4 * column + row];
    return result;
  }

  /// Of a quaternion (x, y, z, w).
  static Transform of_components(const Vector& translation, const std::array<double, 4>& rotation,
                                 const Vector& scale) {
    const auto [x, y, z, w] = rotation;
    Transform result;
    result.columns_ = {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                        {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                        {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
                        translation}};
    for (std::size_t column = 0; column < 3; ++column)
      for (double& number : result.columns_[column])
        number *= scale[column];
    return result;
  }

  /// A turn about an axis of space, around a point that stays.
  static Transform turn(std::size_t axis, double radians, const Vector& point) {
    std::array<double, 4> rotation{0, 0, 0, std::cos(radians / 2)};
    rotation[axis] = std::sin(radians / 2);
    Transform result = of_components({}, rotation, {1, 1, 1});
    const Vector moved = result(point);
    for (std::size_t i = 0; i < 3; ++i)
      result.columns_[3][i] = point[i] - moved[i];
    return result;
  }

  static Transform uniform(double scale) {
    return of_components({}, {0, 0, 0, 1}, {scale, scale, scale});
  }

  Vector operator()(const Vector& point) const {
    Vector result = columns_[3];
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t row = 0; row < 3; ++row)
        result[row] += columns_[column][row] * point[column];
    return result;
  }

  /// First `b`, then `a`.
  friend Transform operator*(const Transform& a, const Transform& b) {
    Transform result;
    result.columns_[3] = a(b.columns_[3]);
    for (std::size_t column = 0; column < 3; ++column) {
      const Vector image = a(b.columns_[column]);
      for (std::size_t row = 0; row < 3; ++row)
        result.columns_[column][row] = image[row] - a.columns_[3][row];
    }
    return result;
  }

  friend bool operator==(const Transform&, const Transform&) = default;

  double determinant() const {
    const auto& [a, b, c, origin] = columns_;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  }

  /// The greatest length of a column: a bound of how it stretches along the axes.
  double stretch() const {
    double result = 0;
    for (std::size_t column = 0; column < 3; ++column)
      result = std::max(result,
                        std::hypot(columns_[column][0], columns_[column][1], columns_[column][2]));
    return result;
  }

  /// How far a point can be off by the rounding of numbers in single precision.
  double rounding(const Vector& point) const {
    double greatest = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = std::abs(columns_[3][row]);
      for (std::size_t column = 0; column < 3; ++column)
        sum += std::abs(columns_[column][row] * point[column]);
      greatest = std::max(greatest, sum);
    }
    return 4 * double{std::numeric_limits<float>::epsilon()} * greatest;
  }

  /// Nothing for one that makes space flat, or nearly so.
  std::optional<Transform> inverse() const {
    const double det = determinant(), size = stretch();
    if (!std::isfinite(det) || !(std::abs(det) > 1e-9 * size * size * size))
      return std::nullopt;
    const auto cross = [](const Vector& a, const Vector& b) {
      return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]};
    };
    const auto& [a, b, c, origin] = columns_;
    const std::array<Vector, 3> rows{cross(b, c), cross(c, a), cross(a, b)};
    Transform result;
    for (std::size_t row = 0; row < 3; ++row) {
      result.columns_[3][row] = 0;
      for (std::size_t column = 0; column < 3; ++column) {
        result.columns_[column][row] = rows[row][column] / det;
        result.columns_[3][row] -= rows[row][column] / det * origin[column];
      }
    }
    return result;
  }

private:
  std::array<Vector, 4> columns_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
};

/// The numbers of a member; `otherwise` if it is not there.
template <std::size_t n>
std::array<double, n> numbers_of(const Json& object, const char* key,
                                 const std::array<double, n>& otherwise) {
  const Json* const values = member(object, key);
  if (!values)
    return otherwise;
  std::array<double, n> result{};
  const bool is_right = values->is_array() && values->size() == n &&
                        std::all_of(values->begin(), values->end(),
                                    [](const Json& value) { return value.is_number(); });
  if (!is_right)
    throw std::runtime_error("'" + std::string(key) + "' is not of " + std::to_string(n) +
                             " numbers");
  for (std::size_t i = 0; i < n; ++i)
    result[i] = (*values)[i].template get<double>();
  return result;
}

/// What a node says of its place below its parent.
inline Transform transform_of_node(const Json& node) {
  if (member(node, "matrix"))
    return Transform::of_matrix(numbers_of<16>(node, "matrix", {}));
  return Transform::of_components(numbers_of<3>(node, "translation", {}),
                                  numbers_of<4>(node, "rotation", {0, 0, 0, 1}),
                                  numbers_of<3>(node, "scale", {1, 1, 1}));
}

} // namespace quadrille_examples

#endif
