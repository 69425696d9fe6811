#ifndef QUADRILLE_INTERNAL_GAPS_BRIDGE_H
#define QUADRILLE_INTERNAL_GAPS_BRIDGE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A strip of triangles between two loops that lie opposite to each other, as the walls of a tube.
///
/// It has a triangle for each edge of the loops. Among all strips that begin where the loops are
/// closest, it is the one of which the edges across have the least sum of squares. Source: Fuchs,
/// Kedem and Uselton, Optimal surface reconstruction from planar contours, 1977.
class Bridge {
public:
  struct Face {
    std::array<Index, 3> vertices;
    Index side; ///< the half-edge of a loop from which it goes to the other loop
  };

  /// Faces run along the half-edges of both loops as these do. In time and memory that are
  /// proportional to the product of the sizes of the loops.
  Bridge(const HalfEdges& surface, std::vector<Index> first, std::vector<Index> second)
      : surface_(surface), first_(std::move(first)), second_(std::move(second)) {
    std::reverse(second_.begin(), second_.end()); // the loops run against each other
    begin_where_closest();
    choose_steps();
    add_faces();
  }

  const std::vector<Face>& faces() const { return faces_; }

private:
  // The i-th vertex of a loop. A half-edge of the second one ends there.
  Index a(std::size_t i) const { return surface_.origin(first_[i % first_.size()]); }
  Index b(std::size_t k) const { return surface_.target(second_[k % second_.size()]); }
  double across(std::size_t i, std::size_t k) const {
    return squared_distance(surface_.point(a(i)), surface_.point(b(k)));
  }

  void begin_where_closest() {
    std::size_t best_i = 0, best_k = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < first_.size(); ++i)
      for (std::size_t k = 0; k < second_.size(); ++k)
        if (const double squared = across(i, k); squared < least) {
          least = squared;
          best_i = i;
          best_k = k;
        }
    std::rotate(first_.begin(), first_.begin() + static_cast<std::ptrdiff_t>(best_i), first_.end());
    std::rotate(second_.begin(), second_.begin() + static_cast<std::ptrdiff_t>(best_k),
                second_.end());
  }

  // The best way to each edge across, of which the last step goes along one loop. The first step
  // goes along the first loop and the last one along the second, and neither loop is done before
  // the other one begins: so no edge across comes twice.
  void choose_steps() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t m = first_.size(), n = second_.size();
    is_along_first_.assign((m + 1) * (n + 1), false);
    std::vector<double> sum(n + 1, infinity);
    sum[0] = 0;
    for (std::size_t i = 1; i <= m; ++i)
      for (std::size_t k = 0; k <= n; ++k) {
        const double along_first = i == m && (k == 0 || k == n) ? infinity : sum[k],
                     along_second = k == 0 ? infinity : sum[k - 1];
        is_along_first_[i * (n + 1) + k] = along_first <= along_second;
        sum[k] = (std::min)(along_first, along_second) + across(i, k);
      }
  }

  void add_faces() {
    const std::size_t m = first_.size(), n = second_.size();
    for (std::size_t i = m, k = n; i > 0 || k > 0;) {
      if (is_along_first_[i * (n + 1) + k]) {
        --i;
        faces_.push_back({{a(i), a(i + 1), b(k)}, first_[i]});
      } else {
        --k;
        faces_.push_back({{b(k + 1), b(k), a(i)}, second_[(k + 1) % n]});
      }
    }
  }

  const HalfEdges& surface_;
  std::vector<Index> first_, second_;
  std::vector<bool> is_along_first_;
  std::vector<Face> faces_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_BRIDGE_H
