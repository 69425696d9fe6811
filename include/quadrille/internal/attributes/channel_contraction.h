#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_CONTRACTION_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_CONTRACTION_H

#include <quadrille/internal/attributes/affine_maps.h>
#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/quadric_form.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

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

/// Contracts the wedges of a pair in a channel: those that a face of both ends joins become one,
/// all others stay.
class ChannelContraction {
public:
  /// The replacement for some wedges in a contraction.
  struct Change {
    WedgeMap map;     ///< about the target
    WedgeList wedges; ///< the wedges that become it
    Index origin;     ///< see Channel::origin
  };
  using Changes = boost::container::small_vector<Change, 4>;

  ChannelContraction(const Channel& channel, const TriangleComplex& complex,
                     const ContractedPair& pair)
      : channel_(channel), complex_(complex), pair_(pair) {}

  /// Adds what wedges of the pair disagree about that its contraction joins.
  QUADRILLE_NOINLINE void add_joins(QuadricForm<3>& form) const {
    const WedgeJoins joins = this->joins();
    const bool is_fixed = pair_.is_first_fixed || pair_.is_second_fixed;
    if (!is_fixed && joins.are_of_two())
      joins.for_each_pair([&](Index w, Index x) { add_join(w, x, form); });
    else
      joins.for_each_group([&](const WedgeJoins::Group& group) { joined(group, {}, form); });
  }
  /// Would the contraction of a pair make one wedge of two between which there is a seam?
  bool closes_seam(const PairStar& star) const {
    if (table().has_one(pair_.first) && table().has_one(pair_.second))
      return false;
    const WedgeJoins joins = this->joins();
    if (joins.are_of_two())
      return false;
    bool closes = false;
    joins.for_each_group([&](const WedgeJoins::Group& group) {
      closes = closes ||
               has_seam_within(star.first, star, pair_.first, pair_.second, group.first) ||
               has_seam_within(star.second, star, pair_.second, pair_.first, group.second);
    });
    return closes;
  }

  /// Computes the wedges of a pair at a target, given from the first end. The discrepancy of those
  /// that are joined is added to `form`, about the first end.
  Changes changes(const Vector<3>& target, QuadricForm<3>& form) const {
    Changes changes;
    joins().for_each_group(
        [&](const WedgeJoins::Group& group) { changes.emplace_back(joined(group, target, form)); });
    add_others(pair_.first, {}, target, changes);
    add_others(pair_.second, pair_.to_second, target, changes);
    return changes;
  }

  /// Carries the contraction out: `kept` has the changed wedges now.
  void apply(Channel& channel, const PairStar& star, Index kept, const Changes& changes) const {
    WedgeList wedges;
    table().append_all(wedges, kept);
    table().append_all(wedges, kept == pair_.first ? pair_.second : pair_.first);
    channel.apply(complex_, star, pair_, wedges, changes,
                  [&](Index old) { return wedges[index_of(changes, old)]; });
  }

  /// Would a face turn over in the texture at a target? One that has no area there may do what it
  /// likes.
  bool turns_over(const PairStar& star, const Vector<3>& target) const {
    if (channel_.joins_two(pair_)) {
      const Vector<2> joined = channel_.joined_texture(pair_, target);
      const auto any_turns = [&](const AppendBuffer<StarFace>& faces, Index vertex) {
        const Moved moved{records().texture_at(vertex), joined};
        return any_turns_over(faces, [&](Index) { return moved; });
      };
      return any_turns(star.first, pair_.first) || any_turns(star.second, pair_.second);
    }
    QuadricForm<3> form;
    const Changes changes = this->changes(target, form);
    const auto any_turns = [&](const AppendBuffer<StarFace>& faces, Index vertex) {
      return any_turns_over(faces, [&](Index face) {
        const Index old = channel_.wedge(complex_, face, vertex);
        const auto& maps = changes[index_of(changes, old)].map.maps;
        return Moved{records().texture_at(old), {maps[0].value, maps[1].value}};
      });
    };
    return any_turns(star.first, pair_.first) || any_turns(star.second, pair_.second);
  }

private:
  // The texture coordinates of a corner before a contraction and after it.
  struct Moved {
    Vector<2> from, to;
  };
  // Does any face turn over whose corner at an end is moved(face)?
  template <class MovedAt>
  bool any_turns_over(const AppendBuffer<StarFace>& faces, MovedAt moved) const {
    return std::any_of(faces.begin(), faces.end(), [&](const StarFace& f) {
      const auto [from, to] = moved(f.face);
      const Vector<2> second = channel_.texture_at(complex_, f.face, f.second);
      const Vector<2> third = channel_.texture_at(complex_, f.face, f.third);
      const double before = doubled_area(from, second, third);
      const double after = doubled_area(to, second, third);
      return before > 0 ? !(after > 0) : before < 0 && !(after < 0);
    });
  }

  const WedgeTable& table() const { return channel_.table(); }
  const MapJoiner& joiner() const { return channel_.joiner(); }
  const WedgeRecords& records() const { return channel_.records(); }

  // Only textures hold boundaries.
  void add_join(Index w, Index x, QuadricForm<3>& form) const {
    if (!records().has_constrained_boundary(w) && !records().has_constrained_boundary(x))
      channel_.add_difference(w, x, pair_.to_second, form);
    else
      joiner().add_boundary_difference(records().weight(w), records().boundary(w),
                                       records().weight(x), records().boundary(x),
                                       records().texture_difference(w, x, pair_.to_second), form);
  }

  WedgeJoins joins() const {
    const Index a = pair_.first, b = pair_.second;
    WedgeJoins joins;
    if (channel_.are_pairs_edges() && table().has_one(a) && table().has_one(b)) {
      joins.add(a, b);
      return joins;
    }
    bool is_edge = false;
    table().for_each_shared(complex_, a, b, [&](Index at_a, Index at_b) {
      joins.add(at_a, at_b);
      is_edge = true;
    });
    if (!is_edge)
      join_equal_values(joins);
    return joins;
  }

  void join_equal_values(WedgeJoins& joins) const {
    WedgeList at_a, at_b;
    table().append_all(at_a, pair_.first);
    table().append_all(at_b, pair_.second);
    for (Index w : at_a)
      for (Index x : at_b)
        if (records().have_equal_values(w, x))
          joins.add(w, x);
  }
  // Is there a seam at an end, other than that between the ends, between two of some wedges? The
  // faces at that end alone are given.
  bool has_seam_within(const AppendBuffer<StarFace>& faces, const PairStar& star, Index v,
                       Index other_end, const WedgeList& wedges) const {
    if (wedges.size() < 2)
      return false;
    std::vector<std::pair<Index, Index>> sides; // the other end of an edge, a face
    for (const StarFace& f : faces)
      for (Index w : {f.second, f.third})
        sides.emplace_back(w, f.face);
    for (const StarFace& f : star.shared)
      sides.emplace_back(f.other_than(pair_.second), f.face);
    std::erase_if(sides, [&](const auto& side) {
      const Index wedge = channel_.wedge(complex_, side.second, v);
      return side.first == other_end ||
             std::find(wedges.begin(), wedges.end(), wedge) == wedges.end();
    });
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < sides.size() && sides[j].first == sides[i].first; ++j)
        if (channel_.has_seam(complex_, sides[i].second, sides[j].second, v, sides[i].first))
          return true;
    return false;
  }

  Change joined(const WedgeJoins::Group& group, const Vector<3>& target,
                QuadricForm<3>& form) const {
    Change change{records().map(group.first[0]), group.first, none};
    for (std::size_t k = 1; k < group.first.size(); ++k)
      joiner().join(change.map, records().map(group.first[k]), {}, form);
    for (Index wedge : group.second)
      joiner().join(change.map, records().map(wedge), -1.0 * pair_.to_second, form);
    change.wedges.insert(change.wedges.end(), group.second.begin(), group.second.end());
    if (pair_.is_first_fixed || pair_.is_second_fixed) {
      change.map.move_origin(pair_.is_first_fixed ? Vector<3>{} : pair_.to_second);
      constrain(change, pair_.is_first_fixed ? group.first[0] : group.second[0], form);
    } else {
      change.map.move_origin(target);
    }
    set_origin(change);
    return change;
  }

  // The wedge of a fixed vertex keeps its values.
  void constrain(Change& change, Index wedge, QuadricForm<3>& form) const {
    std::vector<double> values(records().components());
    for (std::size_t c = 0; c < records().components(); ++c)
      values[c] = records().value(wedge, c);
    joiner().constrain(change.map, values.data(), form);
    for (std::size_t c = 0; c < records().components(); ++c)
      change.map.maps[c].value = values[c];
  }

  // The wedges of a vertex, at `origin`, that are in no change yet.
  void add_others(Index vertex, const Vector<3>& origin, const Vector<3>& target,
                  Changes& changes) const {
    WedgeList wedges;
    table().append_all(wedges, vertex);
    for (Index wedge : wedges) {
      if (index_of(changes, wedge) < changes.size())
        continue;
      Change change{records().map(wedge), {wedge}, none};
      if (target != origin)
        change.map.move_origin(target - origin);
      set_origin(change);
      changes.push_back(std::move(change));
    }
  }

  static std::size_t index_of(const Changes& changes, Index wedge) {
    const auto has_wedge = [&](const Change& change) {
      return std::find(change.wedges.begin(), change.wedges.end(), wedge) != change.wedges.end();
    };
    return static_cast<std::size_t>(std::find_if(changes.begin(), changes.end(), has_wedge) -
                                    changes.begin());
  }

  void set_origin(Change& change) const {
    change.origin = records().origin_of(change.wedges, change.map, joiner().squared_weights());
  }

  const Channel& channel_;
  const TriangleComplex& complex_;
  ContractedPair pair_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_CONTRACTION_H
