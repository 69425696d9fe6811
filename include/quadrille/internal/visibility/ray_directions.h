#ifndef QUADRILLE_INTERNAL_VISIBILITY_RAY_DIRECTIONS_H
#define QUADRILLE_INTERNAL_VISIBILITY_RAY_DIRECTIONS_H

#include <quadrille/quadric_form.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// Sets of directions. Each is spread evenly over the sphere, and so are the beginning of a set,
/// and several sets together: neighbouring faces, which take different sets, look into different
/// directions, and so does a face that takes several.
///
/// A set is a spherical Fibonacci lattice. Source: González, Measurement of areas on a sphere using
/// Fibonacci and latitude-longitude lattices, 2010.
class RayDirections {
public:
  static constexpr std::size_t sets = 256;

  /// Makes sets of `size` directions each.
  explicit RayDirections(std::size_t size) : size_(size) {
    const std::size_t step = coprime_step(size);
    for (std::size_t set = 0; set < sets; ++set)
      for (std::size_t i = 0; i < size; ++i)
        directions_.push_back(direction(set, i * step % size));
  }

  std::size_t size() const { return size_; }
  const Vector<3>& operator()(std::size_t set, std::size_t i) const {
    return directions_[set % sets * size_ + i];
  }

private:
  // The golden ratio spreads the beginnings.
  static std::size_t coprime_step(std::size_t size) {
    auto step = static_cast<std::size_t>(static_cast<double>(size) / std::numbers::phi);
    while (std::gcd(step, size) != 1)
      ++step;
    return step;
  }

  static double fraction(double x) { return x - std::floor(x); }

  // No coordinate is 0. Sets are turned, and moved along the axis by fractions of the distance
  // between neighbours. Both follow the sequence of FaceRays::point().
  Vector<3> direction(std::size_t set, std::size_t i) const {
    const double share = fraction(0.5 + static_cast<double>(set) * 0.7548776662466927);
    const double z = 1 - 2 * (static_cast<double>(i) + share) / static_cast<double>(size_);
    const double turn = static_cast<double>(i) / std::numbers::phi +
                        (static_cast<double>(set) + 1) * 0.5698402909980532;
    const double angle = 2 * std::numbers::pi * fraction(turn);
    const double radius = std::sqrt((1 - z) * (1 + z));
    return {{radius * std::cos(angle), radius * std::sin(angle), z}};
  }

  std::size_t size_;
  std::vector<Vector<3>> directions_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_RAY_DIRECTIONS_H
