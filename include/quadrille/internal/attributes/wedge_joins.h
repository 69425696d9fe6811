#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_JOINS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_JOINS_H

#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/base/index.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace quadrille::internal {

/// Which wedges become one where a pair is contracted: those that a face of both ends joins.
class WedgeJoins {
public:
  /// Wedges at the first end and at the second that become one.
  struct Group {
    WedgeList first, second;
  };

  void add(Index at_first, Index at_second) {
    const std::array pair{at_first, at_second};
    if (std::find(pairs_.begin(), pairs_.end(), pair) == pairs_.end())
      pairs_.push_back(pair);
  }

  /// Does each group have one wedge of each end?
  bool are_of_two() const {
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      for (std::size_t q = 0; q < p; ++q)
        if (pairs_[p][0] == pairs_[q][0] || pairs_[p][1] == pairs_[q][1])
          return false;
    return true;
  }
  /// Calls visit(at first, at second) for each pair.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (const auto& [at_first, at_second] : pairs_)
      visit(at_first, at_second);
  }

  /// Calls visit(group) for each, in the order of their first pairs.
  template <class Visit>
  void for_each_group(Visit visit) const {
    boost::container::small_vector<bool, 4> is_done(pairs_.size(), false);
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (is_done[p])
        continue;
      Group group;
      collect(p, group, is_done);
      visit(group);
    }
  }

private:
  template <class Flags>
  void collect(std::size_t p, Group& group, Flags& is_done) const {
    is_done[p] = true;
    const auto [at_first, at_second] = pairs_[p];
    add_once(group.first, at_first);
    add_once(group.second, at_second);
    for (std::size_t q = 0; q < pairs_.size(); ++q)
      if (!is_done[q] && (pairs_[q][0] == at_first || pairs_[q][1] == at_second))
        collect(q, group, is_done);
  }
  static void add_once(WedgeList& wedges, Index wedge) {
    if (std::find(wedges.begin(), wedges.end(), wedge) == wedges.end())
      wedges.push_back(wedge);
  }

  boost::container::small_vector<std::array<Index, 2>, 4> pairs_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_JOINS_H
