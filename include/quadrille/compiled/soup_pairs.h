#ifndef QUADRILLE_COMPILED_SOUP_PAIRS_H
#define QUADRILLE_COMPILED_SOUP_PAIRS_H

#include <quadrille/internal/core/pairs/close_points.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>

#if __has_include(<nanoflann.hpp>)
// nanoflann prints a line before it throws std::bad_alloc. The library prints nothing, and modules
// of WebAssembly have no standard streams. Headers of the standard that name fprintf come first.
#include <cstdio>
#include <istream>
#include <ostream>
#define fprintf(...) static_cast<void>(0)
#include <nanoflann.hpp>
#undef fprintf
#define QUADRILLE_HAS_NANOFLANN
#endif

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// Pairs closer than a threshold in the compiled library, which contains no code under the GPL:
/// they are found by nanoflann, which is under the BSD licence.

namespace quadrille::internal {

#ifdef QUADRILLE_HAS_NANOFLANN

/// nanoflann's kd-tree over points, for ClosePoints.
class SoupPointTree {
public:
  explicit SoupPointTree(std::vector<Vector<3>> points)
      : points_{std::move(points)}, tree_(3, points_) {} // which builds it
  SoupPointTree(const SoupPointTree&) = delete;
  SoupPointTree& operator=(const SoupPointTree&) = delete;

  /// Visits all points that are closer to p than the radius, up to rounding.
  template <class Visit>
  void for_each_within(const Vector<3>& p, double radius, Visit visit) const {
    Hits<Visit> hits{radius * radius, visit};
    tree_.radiusSearchCustomCallback(p.coordinates.data(), hits);
  }

private:
  /// The points as nanoflann reads them.
  struct Points {
    std::vector<Vector<3>> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::uint32_t i, std::size_t axis) const { return points[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false; // nanoflann computes it
    }
  };
  using Metric = nanoflann::L2_Simple_Adaptor<double, Points, double, std::uint32_t>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Points, 3, std::uint32_t>;

  /// A result of a search that only calls a function.
  template <class Visit>
  struct Hits {
    using DistanceType = double;
    using IndexType = std::uint32_t;

    double squared_radius;
    Visit& visit;

    bool addPoint(double, std::uint32_t i) {
      visit(i);
      return true;
    }
    double worstDist() const { return squared_radius; }
    std::size_t size() const { return 0; }
    bool full() const { return true; }
    void sort() {}
  };

  Points points_;
  Tree tree_;
};

#endif

} // namespace quadrille::internal

namespace quadrille {

/// The pair policy of simplified_soup(), which finds the pairs of ThresholdPairs with nanoflann.
/// Where the library was compiled without nanoflann, validate() says so and throws.
class SoupPairs {
public:
  static constexpr bool includes_edges = true;  ///< edges are pairs, too
  static constexpr bool ignores_indices = true; ///< the engine may reorder points

  /// t is in the soup's units, at least 0 and finite.
  explicit SoupPairs(double t) : threshold_(t, false) {}

  /// Throws std::invalid_argument for a threshold that is negative or not finite, and
  /// std::logic_error without nanoflann.
  void validate() const {
    threshold_.validate();
#ifndef QUADRILLE_HAS_NANOFLANN
    throw std::logic_error("quadrille::ThresholdPairs: this library was compiled without "
                           "nanoflann (libnanoflann-dev), which finds pairs that are closer than "
                           "a distance: install it and compile the library again");
#endif
  }

  /// Calls emit(i, j) as ThresholdPairs does.
  void operator()([[maybe_unused]] const SurfaceView& surface,
                  [[maybe_unused]] const EmitPair& emit) const {
#ifdef QUADRILLE_HAS_NANOFLANN
    threshold_.emit_pairs<internal::SoupPointTree>(surface, emit);
#endif
  }

private:
  internal::PairThreshold threshold_;
};

} // namespace quadrille

#endif // QUADRILLE_COMPILED_SOUP_PAIRS_H
