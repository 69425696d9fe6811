#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_KD_TREE_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_KD_TREE_H

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

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// CGAL's kd-tree over points, for ClosePoints.
class KdTree {
public:
  /// There is at least one point: CGAL's tree is never empty.
  explicit KdTree(const std::vector<Vector<3>>& points) {
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (const Vector<3>& p : points)
      entries.emplace_back(cgal_point(p), static_cast<std::uint32_t>(entries.size()));
    tree_.insert(entries.begin(), entries.end());
    tree_.build();
  }

  /// Visits all points that are closer to p than the radius, up to rounding.
  template <class Visit>
  void for_each_within(const Vector<3>& p, double radius, Visit visit) const {
    const auto take = [&](const Entry& entry) { visit(entry.second); };
    const CGAL::Fuzzy_sphere<Traits> sphere(cgal_point(p), radius);
    tree_.search(boost::make_function_output_iterator(std::cref(take)), sphere);
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

  static Kernel::Point_3 cgal_point(const Vector<3>& p) { return {p[0], p[1], p[2]}; }

  CGAL::Kd_tree<Traits, Splitter> tree_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_KD_TREE_H
