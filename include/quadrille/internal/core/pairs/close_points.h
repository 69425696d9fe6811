#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H

// CGAL's kd-tree is GPL: see <quadrille/threshold_pairs.h>, the only header that includes this one.

#include <quadrille/quadric_form.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Finds the pairs of points that are closer than t > 0; t² must neither over- nor underflow.
///
/// Points at one position are a group, and the kd-tree is one of groups: CGAL's is as deep as the
/// number of equal points in it.
class ClosePoints {
public:
  /// Keeps a view of the points, of which there is at least one: CGAL's tree is never empty.
  ClosePoints(std::span<const Vector<3>> points, double t) : points_(points), t_(t) {
    find_groups();
    std::vector<Entry> entries;
    entries.reserve(group_count());
    for (std::uint32_t group = 0; group < group_count(); ++group)
      entries.emplace_back(cgal_point(group), group);
    tree_.insert(entries.begin(), entries.end());
    tree_.build();
  }

  /// All j > i closer to i than t, in order.
  void find_after(std::uint32_t i, std::vector<std::uint32_t>& near) const {
    near.clear();
    for_each_near(group_of_[i], [&](std::uint32_t group) {
      const auto points = points_of(group);
      near.insert(near.end(), std::upper_bound(points.begin(), points.end(), i), points.end());
    });
    std::sort(near.begin(), near.end());
  }

  /// How many others are closer to i than t.
  double count(std::uint32_t i) const {
    double n = -1; // i itself
    for_each_near(group_of_[i], [&](std::uint32_t group) { n += size_of(group); });
    return n;
  }

  /// The number of pairs, or only of those of the first groups if that is already above the limit.
  double count_pairs(double limit) const {
    double pairs = 0;
    for (std::uint32_t g = 0; g < group_count() && !(pairs > limit); ++g)
      for_each_near(g, [&](std::uint32_t other) {
        if (other == g)
          pairs += size_of(g) * (size_of(g) - 1) / 2;
        else if (other > g)
          pairs += size_of(g) * size_of(other);
      });
    return pairs;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Entry = std::pair<Kernel::Point_3, std::uint32_t>;
  using Traits = CGAL::Search_traits_adapter<Entry, CGAL::First_of_pair_property_map<Entry>,
                                             CGAL::Search_traits_3<Kernel>>;

  // Halves the longest side of the box around the points. CGAL's Sliding_midpoint does too, but
  // takes off one point at a time where no number lies between the two ends.
  struct Splitter : CGAL::Splitter_base<double> {
    using Container = CGAL::Point_container<Traits>;
    using Separator = CGAL::Plane_separator<double>;

    void operator()(Separator& separator, Container& points, Container& lower) const {
      const double low = points.max_tight_span_lower(), high = points.max_tight_span_upper();
      const double middle = (low + high) / 2;
      separator = Separator(points.max_tight_span_coord(), middle > low ? middle : high);
      points.split(lower, separator);
    }
  };

  void find_groups() {
    order_.resize(points_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
      const auto& a = points_[i].coordinates;
      const auto& b = points_[j].coordinates;
      return a < b || (a == b && i < j);
    });
    group_of_.resize(points_.size());
    for (std::uint32_t k = 0; k < order_.size(); ++k) {
      if (k == 0 || points_[order_[k]] != points_[order_[k - 1]])
        first_.push_back(k);
      group_of_[order_[k]] = static_cast<std::uint32_t>(first_.size() - 1);
    }
    first_.push_back(static_cast<std::uint32_t>(order_.size()));
  }

  std::size_t group_count() const { return first_.size() - 1; }
  double size_of(std::uint32_t group) const { return first_[group + 1] - first_[group]; }
  const Vector<3>& position(std::uint32_t group) const { return points_[order_[first_[group]]]; }

  // In order.
  std::span<const std::uint32_t> points_of(std::uint32_t group) const {
    return {order_.data() + first_[group], order_.data() + first_[group + 1]};
  }

  Kernel::Point_3 cgal_point(std::uint32_t group) const {
    const Vector<3>& p = position(group);
    return {p[0], p[1], p[2]};
  }

  // The group itself is among them. The sphere of CGAL is not exact at its surface: it is taken
  // larger, and each hit is tested.
  template <class Visit>
  void for_each_near(std::uint32_t group, Visit visit) const {
    const auto test = [&](const Entry& entry) {
      if (squared_distance(position(group), position(entry.second)) < t_ * t_)
        visit(entry.second);
    };
    const CGAL::Fuzzy_sphere<Traits> sphere(cgal_point(group), t_ * (1 + 1e-12));
    tree_.search(boost::make_function_output_iterator(std::cref(test)), sphere);
  }

  std::span<const Vector<3>> points_;
  double t_;
  std::vector<std::uint32_t> order_;    // indices of points, by position, then by index
  std::vector<std::uint32_t> first_;    // of each group in that order, and its end
  std::vector<std::uint32_t> group_of_; // each point
  CGAL::Kd_tree<Traits, Splitter> tree_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H
