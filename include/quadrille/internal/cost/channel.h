#ifndef QUADRILLE_INTERNAL_COST_CHANNEL_H
#define QUADRILLE_INTERNAL_COST_CHANNEL_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/complex/wedge_table.h>
#include <quadrille/internal/cost/affine_maps.h>
#include <quadrille/internal/cost/channel_reader.h>
#include <quadrille/internal/cost/wedge_records.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/surface/channel_input.h>
#include <quadrille/internal/surface/channel_weights.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/quadric_form.h>
#include <quadrille/vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A pair as channels see it.
struct ContractedPair {
  Index first, second;
  Vector<3> to_second; ///< from the first end
  bool is_first_fixed = false, is_second_fixed = false;
};

/// One channel of a surface: its wedges, and of each a map of the attributes.
class Channel {
public:
  /// What a contraction leaves instead of some wedges.
  struct Change {
    WedgeMap map;     ///< about the first end, later about the target
    WedgeList wedges; ///< that become it
    Index origin;     ///< see origin()
  };
  using Changes = boost::container::small_vector<Change, 4>;

  /// `squared_weights`: see MapJoiner. `factors`: how much more each label weighs; none if all
  /// weigh the same. Where pairs may be no edges, wedges of different values may come together
  /// anywhere.
  template <class Numbering>
  Channel(const ChannelInput& input, const Numbering& numbering, const TriangleComplex& complex,
          ChannelWeights weights, bool are_pairs_edges)
      : seams_(input.seams), is_texture_(input.is_texture), border_weight_(input.border_weight),
        has_one_a_vertex_(input.corners.empty() || input.seams == Seams::free),
        are_pairs_edges_(are_pairs_edges || has_one_a_vertex_),
        factors_(std::move(weights.factors)), table_(complex.workspace()),
        joiner_(std::move(weights.squared)), records_(input.components, complex.workspace()) {
    const ChannelReader reader(input, numbering, complex);
    if (has_one_a_vertex_)
      reader.read_vertices(records_);
    else
      reader.read_wedges(table_, records_, are_pairs_edges_);
  }

  bool is_texture() const { return is_texture_; }
  bool are_seams_kept() const { return seams_ == Seams::kept; }
  bool has_seams() const { return table_.has_seams(); }
  std::size_t components() const { return records_.components(); }

  Index wedge(const TriangleComplex& complex, Index face, Index vertex) const {
    return table_.at(complex, face, vertex);
  }
  bool has_one_wedge(Index vertex) const { return table_.has_one(vertex); }
  double value(Index wedge, std::size_t component) const {
    return records_.value(wedge, component);
  }
  /// See WedgeRecords.
  Index origin(Index wedge) const { return records_.origin(wedge); }
  std::size_t wedge_count(std::size_t vertices) const { return table_.size(vertices); }

  /// Is the channel discontinuous between two faces at both ends of an edge?
  bool has_seam(const TriangleComplex& complex, Index face, Index other, Index v, Index w) const {
    return table_.has_seams() && wedge(complex, face, v) != wedge(complex, other, v) &&
           wedge(complex, face, w) != wedge(complex, other, w);
  }
  /// Does the texture of two faces at the edge vw lie on one side of it, so that it is folded?
  bool has_fold(const TriangleComplex& complex, Index face, Index other, Index v, Index w) const {
    if (!is_texture_)
      return false;
    const auto side = [&](Index f) {
      const auto& corners = complex.vertices(f);
      const auto third =
          std::find_if(corners.begin(), corners.end(), [&](Index x) { return x != v && x != w; });
      return third == corners.end()
                 ? 0.0
                 : doubled_area(texture_at(complex, f, v), texture_at(complex, f, w),
                                texture_at(complex, f, *third));
    };
    const double one = side(face), two = side(other);
    return (one > 0 && two > 0) || (one < 0 && two < 0);
  }

  /// Would the contraction of a pair make one wedge of two between which there is a seam?
  bool closes_seam(const TriangleComplex& complex, const PairStar& star, Index a, Index b) const {
    if (table_.has_one(a) && table_.has_one(b))
      return false;
    const WedgeJoins joins = this->joins(complex, a, b);
    if (joins.are_of_two())
      return false;
    bool closes = false;
    joins.for_each_group([&](const WedgeJoins::Group& group) {
      closes = closes || has_seam_within(complex, star.first, a, group.first) ||
               has_seam_within(complex, star.second, b, group.second);
    });
    return closes;
  }

  /// Maps of the attributes as they are now. What the faces of a wedge disagree about goes to its
  /// vertex: add(v, matrix). `labels`: of each face; or empty.
  template <class Positions, class Add>
  void remember(const Positions& positions, const TriangleComplex& complex,
                const Array<Index>& labels, Add add) {
    records_.forget_faces();
    if (components() == 0)
      return;
    std::vector<Vector<3>> gradients(components());
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      if (complex.is_removed(face))
        continue;
      double weight = find_gradients(positions, complex, face, gradients);
      if (!factors_.empty() && !labels.empty())
        weight *= factors_[labels[face]];
      if (!(weight > 0))
        continue;
      const auto& vertices = complex.vertices(face);
      for (std::size_t i = 0; i < 3; ++i)
        add(vertices[i], records_.join_face(table_.at(face, i, vertices[i]), weight, gradients,
                                            joiner_.squared_weights()));
    }
  }

  /// Are charts held where they end?
  bool holds_borders() const { return is_texture_ && seams_ == Seams::kept && border_weight_ > 0; }
  /// Holds the chart of a face at its edge vw, as long as the square tells: the texture may slide
  /// along the edge and not off it. What that leaves at v goes to `form`.
  void hold_border(const TriangleComplex& complex, Index face, Index v, Index w,
                   double squared_length_of_edge, QuadricForm<3>& form) {
    records_.hold_borders();
    const Index at_v = wedge(complex, face, v);
    const Vector<2> p = records_.texture_at(at_v), q = texture_at(complex, face, w);
    const Vector<2> along = q - p;
    const double squared = squared_length(along);
    if (!(squared > 0))
      return;
    const double factor =
        border_weight_ * squared_length_of_edge * joiner_.squared_weights()[0] / squared;
    WedgeMap edge;
    edge.border = {factor * along[1] * along[1], -factor * along[0] * along[1],
                   factor * along[0] * along[0]};
    edge.maps = {AffineMap{{}, p[0]}, AffineMap{{}, p[1]}};
    WedgeMap chart = records_.map(at_v);
    joiner_.join(chart, edge, {}, form);
    records_.write(at_v, chart);
  }

  /// Does the contraction of a pair only join the one wedge of each of its ends, freely?
  QUADRILLE_ALWAYS_INLINE bool joins_two(const ContractedPair& pair) const {
    return are_pairs_edges_ && table_.has_one(pair.first) && table_.has_one(pair.second) &&
           !pair.is_first_fixed && !pair.is_second_fixed && !records_.holds_border(pair.first) &&
           !records_.holds_border(pair.second);
  }

  /// Adds what wedges of a pair disagree about that its contraction joins.
  QUADRILLE_ALWAYS_INLINE void add_joins(const TriangleComplex& complex, const ContractedPair& pair,
                                         QuadricForm<3>& form) const {
    if (joins_two(pair))
      joiner_.add_difference(records_.weight(pair.first), records_.maps(pair.first),
                             records_.weight(pair.second), records_.maps(pair.second),
                             -1.0 * pair.to_second, form);
    else
      add_other_joins(complex, pair, form);
  }

  /// Carries the contraction of a pair out that joins two wedges: see joins_two().
  void apply_join(const TriangleComplex& complex, const PairStar& star, const ContractedPair& pair,
                  Index kept, const Vector<3>& target, QuadricForm<3>& form) {
    joiner_.add_difference(records_.weight(pair.first), records_.maps(pair.first),
                           records_.weight(pair.second), records_.maps(pair.second),
                           -1.0 * pair.to_second, form);
    records_.join(pair.first, pair.second, pair.to_second, target, kept);
    if (table_.has_seams())
      rename_corners(complex, star, pair, [kept](Index) { return kept; });
  }

  /// What becomes of the wedges of a pair at a target, given from the first end. What those that
  /// are joined disagree about goes to `form`, about the first end.
  Changes changes(const TriangleComplex& complex, const ContractedPair& pair,
                  const Vector<3>& target, QuadricForm<3>& form) const {
    Changes changes;
    joins(complex, pair.first, pair.second).for_each_group([&](const WedgeJoins::Group& group) {
      changes.emplace_back(joined(group, pair, target, form));
    });
    add_others(pair.first, {}, target, changes);
    add_others(pair.second, pair.to_second, target, changes);
    return changes;
  }

  /// Carries a contraction out: `kept` has the changed wedges now.
  void apply(const TriangleComplex& complex, const PairStar& star, const ContractedPair& pair,
             Index kept, const Changes& changes) {
    WedgeList wedges;
    table_.append_all(wedges, kept);
    table_.append_all(wedges, kept == pair.first ? pair.second : pair.first);
    for (std::size_t k = 0; k < changes.size(); ++k)
      records_.write(wedges[k], changes[k].map, changes[k].origin);
    if (!table_.has_seams())
      return;
    const auto renamed = [&](Index old) { return wedges[index_of(changes, old)]; };
    rename_corners(complex, star, pair, renamed);
    wedges.resize(changes.size());
    table_.chain(wedges);
  }

  /// Would a face turn over in the texture? One that has no area there may do what it likes.
  bool turns_over(const TriangleComplex& complex, const PairStar& star, const ContractedPair& pair,
                  const Changes& changes) const {
    const auto turns = [&](const StarFace& f, Index vertex) {
      const Index old = wedge(complex, f.face, vertex);
      const Vector<2> second = texture_at(complex, f.face, f.second);
      const Vector<2> third = texture_at(complex, f.face, f.third);
      const auto& maps = changes[index_of(changes, old)].map.maps;
      const double before = doubled_area(records_.texture_at(old), second, third);
      const double after = doubled_area({maps[0].value, maps[1].value}, second, third);
      return before > 0 ? !(after > 0) : before < 0 && !(after < 0);
    };
    return std::any_of(star.first.begin(), star.first.end(),
                       [&](const StarFace& f) { return turns(f, pair.first); }) ||
           std::any_of(star.second.begin(), star.second.end(),
                       [&](const StarFace& f) { return turns(f, pair.second); });
  }

  /// Leaves out all vertices but those of an ascending list, and the faces for which is_left does
  /// not hold.
  template <class IsLeft>
  void pack(const Array<Index>& vertices, IsLeft is_left) {
    records_.pack(table_.pack(vertices, is_left));
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const {
    records_.prefetch(vertex);
    table_.prefetch(vertex);
  }

private:
  // Of each attribute on a face. Returns how much they weigh: the area, and less where attributes
  // change by more than a length for each length, so that slivers do not count without bound.
  template <class Positions>
  double find_gradients(const Positions& positions, const TriangleComplex& complex, Index face,
                        std::vector<Vector<3>>& gradients) const {
    const auto& v = complex.vertices(face);
    const Vector<3> to_second = positions[v[1]] - positions[v[0]];
    const Vector<3> to_third = positions[v[2]] - positions[v[0]];
    const Vector<3> normal = cross(to_second, to_third);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return 0;
    const Vector<3> first_way = (1 / squared) * cross(to_third, normal);
    const Vector<3> second_way = (1 / squared) * cross(normal, to_second);
    const std::array<Index, 3> w{table_.at(face, 0, v[0]), table_.at(face, 1, v[1]),
                                 table_.at(face, 2, v[2])};
    double steepness = 0;
    for (std::size_t c = 0; c < components(); ++c) {
      gradients[c] = (value(w[1], c) - value(w[0], c)) * first_way +
                     (value(w[2], c) - value(w[0], c)) * second_way;
      steepness += joiner_.squared_weights()[c] * squared_length(gradients[c]);
    }
    return 0.5 * std::sqrt(squared) / (1 + steepness / static_cast<double>(components()));
  }

  QUADRILLE_NOINLINE void add_other_joins(const TriangleComplex& complex,
                                          const ContractedPair& pair, QuadricForm<3>& form) const {
    const WedgeJoins joins = this->joins(complex, pair.first, pair.second);
    const bool is_fixed = pair.is_first_fixed || pair.is_second_fixed;
    if (!is_fixed && joins.are_of_two())
      joins.for_each_pair([&](Index w, Index x) { add_join(w, x, pair.to_second, form); });
    else
      joins.for_each_group([&](const WedgeJoins::Group& group) { joined(group, pair, {}, form); });
  }
  void add_join(Index w, Index x, const Vector<3>& to_second, QuadricForm<3>& form) const {
    if (!records_.holds_border(w) && !records_.holds_border(x)) {
      joiner_.add_difference(records_.weight(w), records_.maps(w), records_.weight(x),
                             records_.maps(x), -1.0 * to_second, form);
    } else {
      WedgeMap map = records_.map(w);
      joiner_.join(map, records_.map(x), -1.0 * to_second, form);
    }
  }

  WedgeJoins joins(const TriangleComplex& complex, Index a, Index b) const {
    WedgeJoins joins;
    if (are_pairs_edges_ && table_.has_one(a) && table_.has_one(b)) {
      joins.add(a, b);
      return joins;
    }
    bool is_edge = false;
    table_.for_each_shared(complex, a, b, [&](Index at_a, Index at_b) {
      joins.add(at_a, at_b);
      is_edge = true;
    });
    if (!is_edge)
      join_equal_values(a, b, joins);
    return joins;
  }

  void join_equal_values(Index a, Index b, WedgeJoins& joins) const {
    WedgeList at_a, at_b;
    table_.append_all(at_a, a);
    table_.append_all(at_b, b);
    for (Index w : at_a)
      for (Index x : at_b)
        if (records_.have_equal_values(w, x))
          joins.add(w, x);
  }
  template <class Rename>
  void rename_corners(const TriangleComplex& complex, const PairStar& star,
                      const ContractedPair& pair, Rename renamed) {
    for (const StarFace& f : star.first)
      table_.rename_corner(complex, f.face, pair.first, renamed);
    for (const StarFace& f : star.second)
      table_.rename_corner(complex, f.face, pair.second, renamed);
  }

  // Is there a seam at a vertex between two of some wedges?
  bool has_seam_within(const TriangleComplex& complex, const AppendBuffer<StarFace>& faces, Index v,
                       const WedgeList& wedges) const {
    if (wedges.size() < 2)
      return false;
    const auto is_within = [&](const StarFace& f) {
      return std::find(wedges.begin(), wedges.end(), wedge(complex, f.face, v)) != wedges.end();
    };
    for (const StarFace& f : faces)
      for (const StarFace& g : faces)
        for (Index w : {f.second, f.third})
          if (f.face < g.face && g.has(w) && has_seam(complex, f.face, g.face, v, w) &&
              is_within(f) && is_within(g))
            return true;
    return false;
  }

  Change joined(const WedgeJoins::Group& group, const ContractedPair& pair, const Vector<3>& target,
                QuadricForm<3>& form) const {
    Change change{records_.map(group.first[0]), group.first, none};
    for (std::size_t k = 1; k < group.first.size(); ++k)
      joiner_.join(change.map, records_.map(group.first[k]), {}, form);
    for (Index wedge : group.second)
      joiner_.join(change.map, records_.map(wedge), -1.0 * pair.to_second, form);
    change.wedges.insert(change.wedges.end(), group.second.begin(), group.second.end());
    if (pair.is_first_fixed || pair.is_second_fixed) {
      change.map.move_origin(pair.is_first_fixed ? Vector<3>{} : pair.to_second);
      hold(change, pair.is_first_fixed ? group.first[0] : group.second[0], form);
    } else {
      change.map.move_origin(target);
    }
    change.origin = origin_of(change);
    return change;
  }

  // The wedge of a fixed vertex keeps its values.
  void hold(Change& change, Index wedge, QuadricForm<3>& form) const {
    std::vector<double> values(components());
    for (std::size_t c = 0; c < components(); ++c)
      values[c] = value(wedge, c);
    joiner_.hold(change.map, values.data(), form);
    for (std::size_t c = 0; c < components(); ++c)
      change.map.maps[c].value = values[c];
  }

  // The wedges of a vertex, at `origin`, that are in no change yet.
  void add_others(Index vertex, const Vector<3>& origin, const Vector<3>& target,
                  Changes& changes) const {
    WedgeList wedges;
    table_.append_all(wedges, vertex);
    for (Index wedge : wedges) {
      if (index_of(changes, wedge) < changes.size())
        continue;
      Change change{records_.map(wedge), {wedge}, none};
      if (target != origin)
        change.map.move_origin(target - origin);
      change.origin = origin_of(change);
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

  // A value that has not changed has the index that it had.
  Index origin_of(const Change& change) const {
    for (Index wedge : change.wedges)
      if (records_.is_origin_of(wedge, change.map))
        return records_.origin(wedge);
    return none;
  }

  Vector<2> texture_at(const TriangleComplex& complex, Index face, Index vertex) const {
    return records_.texture_at(wedge(complex, face, vertex));
  }
  static double doubled_area(const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  Seams seams_;
  bool is_texture_;
  double border_weight_;
  bool has_one_a_vertex_; // whatever its pairs
  bool are_pairs_edges_;
  std::vector<double> factors_; // of each label; or none
  WedgeTable table_;
  MapJoiner joiner_;
  WedgeRecords records_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COST_CHANNEL_H
