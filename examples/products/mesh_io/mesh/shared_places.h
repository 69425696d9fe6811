#ifndef QUADRILLE_EXAMPLES_MESH_IO_SHARED_PLACES_H
#define QUADRILLE_EXAMPLES_MESH_IO_SHARED_PLACES_H

#include "indexed_mesh.h"

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The places at which there are several vertices, one of which may lie on an edge of one face.
class SharedPlaces {
public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// The first vertex at the place of each, or none; empty if there is no such place. A closed
  /// surface is done in O(n).
  static std::vector<std::uint32_t> of(const std::vector<Point>& points,
                                       const Triangles& triangles) {
    SharedPlaces places(points);
    places.find_boundary(triangles);
    if (places.has_boundary_)
      places.find();
    return std::move(places.places_);
  }

private:
  explicit SharedPlaces(const std::vector<Point>& points) : points_(points) {}

  /// Around the other vertices the edges that faces enter and leave by are the same, and so are the
  /// sums of their scrambled ends.
  void find_boundary(const Triangles& triangles) {
    const auto scrambled = [](std::uint64_t v) {
      v = (v + 1) * 0x9E3779B97F4A7C15U;
      return v ^ (v >> 29);
    };
    std::vector<std::uint64_t> sums(points_.size());
    for (const auto& [a, b, c] : triangles) {
      sums[a] += scrambled(b) - scrambled(c);
      sums[b] += scrambled(c) - scrambled(a);
      sums[c] += scrambled(a) - scrambled(b);
    }
    for (const std::uint64_t sum : sums) {
      is_boundary_.push_back(sum != 0);
      has_boundary_ = has_boundary_ || sum != 0;
    }
  }

  static std::size_t hash(const Point& p) {
    std::size_t seed = 0;
    for (int i = 0; i < 3; ++i) // 0 and -0 are equal
      boost::hash_combine(seed, std::bit_cast<std::uint64_t>(p[i] + 0.));
    return seed;
  }

  /// The vertices that may be at the place of one of the border, in the order of places.
  std::vector<std::uint32_t> candidates() const {
    const auto count =
        static_cast<std::size_t>(std::count(is_boundary_.begin(), is_boundary_.end(), true));
    const std::size_t size = std::bit_ceil(16 * count);
    std::vector<bool> has_boundary(size);
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (is_boundary_[v])
        has_boundary[hash(points_[v]) % size] = true;
    std::vector<std::uint32_t> found;
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (is_boundary_[v] || has_boundary[hash(points_[v]) % size])
        found.push_back(static_cast<std::uint32_t>(v));
    std::sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a] != points_[b] ? points_[a] < points_[b] : a < b;
    });
    return found;
  }

  void find() {
    const std::vector<std::uint32_t> order = candidates();
    for (auto begin = order.begin(); begin != order.end();) {
      const auto end = std::find_if(begin, order.end(),
                                    [&](std::uint32_t v) { return points_[v] != points_[*begin]; });
      if (end - begin > 1 &&
          std::any_of(begin, end, [&](std::uint32_t v) { return is_boundary_[v]; })) {
        places_.resize(points_.size(), none);
        std::for_each(begin, end, [&](std::uint32_t v) { places_[v] = *begin; });
      }
      begin = end;
    }
  }

  const std::vector<Point>& points_;
  std::vector<bool> is_boundary_;
  bool has_boundary_ = false;
  std::vector<std::uint32_t> places_;
};

} // namespace quadrille_examples

#endif
