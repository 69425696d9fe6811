#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_H

#include <quadrille/internal/attributes/affine_maps.h>
#include <quadrille/internal/attributes/channel_reader.h>
#include <quadrille/internal/attributes/channel_weights.h>
#include <quadrille/internal/attributes/wedge_records.h>
#include <quadrille/internal/attributes/wedge_sums.h>
#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns for each wedge the sum of the unit normals of its faces, weighted by their angles there.
/// Source: Thürmer and Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998.
template <class Positions>
std::vector<Vector<3>> wedge_normals(const WedgeTable& table, std::size_t wedges,
                                     const Positions& positions, const TriangleComplex& complex) {
  std::vector<Vector<3>> sums(wedges);
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    const auto& v = complex.vertices(face);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<3> one = positions[v[(i + 1) % 3]] - positions[v[i]];
      const Vector<3> other = positions[v[(i + 2) % 3]] - positions[v[i]];
      const Vector<3> normal = cross(one, other);
      const double length = std::sqrt(squared_length(normal));
      if (length > 0)
        sums[table.at(face, i, v[i])] += (std::atan2(length, dot(one, other)) / length) * normal;
    }
  }
  return sums;
}

/// A pair as channels see it.
struct ContractedPair {
  Index first, second;
  Vector<3> to_second; ///< from the first end
  bool is_first_fixed = false, is_second_fixed = false;
};

/// One channel of a surface: its wedges, and a map of the attributes for each. ChannelContraction
/// contracts it.
class Channel {
public:
  /// If pairs need not be edges, wedges of different values may come together anywhere, unless each
  /// vertex has one.
  template <class Numbering>
  Channel(const ChannelInput& input, const Numbering& numbering, const TriangleComplex& complex,
          ChannelWeights weights, bool are_pairs_edges)
      : seams_(input.seams), new_values_(input.new_values), is_texture_(input.is_texture()),
        boundary_weight_(input.chart_boundary_weight),
        are_pairs_edges_(are_pairs_edges || has_one_a_vertex(input)),
        factors_(std::move(weights.factors)), as_written_(input.as_written),
        table_(complex.arena()), records_(weights.squared, complex.arena()),
        joiner_(std::move(weights.squared)), is_plain_(complex.arena()) {
    const ChannelReader reader(input, numbering, complex);
    if (has_one_a_vertex(input))
      reader.read_vertices(records_);
    else
      reader.read_wedges(table_, records_, are_pairs_edges_);
  }

  bool is_texture() const { return is_texture_; }
  bool are_seams_kept() const { return seams_ == Seams::kept; }
  bool are_seams_soft() const { return seams_ == Seams::soft; }
  bool has_seams() const { return table_.has_seams(); }
  std::size_t components() const { return records_.components(); }

  Index wedge(const TriangleComplex& complex, Index face, Index vertex) const {
    return table_.at(complex, face, vertex);
  }
  bool has_one_wedge(Index vertex) const { return table_.has_one(vertex); }
  double value(Index wedge, std::size_t c) const { return records_.value(wedge, c); }
  /// See WedgeRecords.
  Index origin(Index wedge) const { return records_.origin(wedge); }
  std::size_t wedge_count(std::size_t vertices) const { return table_.size(vertices); }
  /// Appends the components of a wedge as they would be written. False if they would not be.
  bool append_final_values(Index wedge, std::vector<double>& values) const {
    const std::size_t begin = values.size();
    for (std::size_t c = 0; c < components(); ++c)
      values.push_back(records_.final_value(wedge, c));
    const bool is_new = records_.origin(wedge) == none;
    return as_written_(std::span(values).subspan(begin), is_new);
  }

  Vector<2> texture_at(const TriangleComplex& complex, Index face, Index vertex) const {
    return records_.texture_at(wedge(complex, face, vertex));
  }

  /// Is the channel discontinuous between two faces at both ends of an edge?
  bool has_seam(const TriangleComplex& complex, Index face, Index other, Index v, Index w) const {
    return table_.has_seams() && wedge(complex, face, v) != wedge(complex, other, v) &&
           wedge(complex, face, w) != wedge(complex, other, w);
  }
  /// Does the texture of two faces at the edge vw lie on one side of it, so that it is folded?
  bool has_texture_fold(const TriangleComplex& complex, Index face, Index other, Index v,
                        Index w) const {
    if (!is_texture_)
      return false;
    const auto area = [&](Index f) { return texture_area(complex, f); };
    return are_folded(complex, face, area(face), other, area(other), v, w);
  }
  /// Answers that where the areas of the faces in the texture are known, or their signs.
  static bool are_folded(const TriangleComplex& complex, Index face, double area, Index other,
                         double other_area, Index v, Index w) {
    if (area == 0 || other_area == 0)
      return false;
    const auto runs_from_v = [&](Index f) {
      const auto& [p, q, r] = complex.vertices(f);
      return (p == v && q == w) || (q == v && r == w) || (r == v && p == w);
    };
    return ((area > 0) == runs_from_v(face)) == ((other_area > 0) == runs_from_v(other));
  }
  /// Twice the area of a face in the texture, negative if it is turned over.
  double texture_area(const TriangleComplex& complex, Index face) const {
    const auto& [p, q, r] = complex.vertices(face);
    return doubled_area(records_.texture_at(table_.at(face, 0, p)),
                        records_.texture_at(table_.at(face, 1, q)),
                        records_.texture_at(table_.at(face, 2, r)));
  }

  /// Computes the maps of the current attributes. The discrepancies of the faces of a wedge are
  /// added to its vertex: add(v, matrix). `labels`: of each face; or empty. An area counts
  /// weight(area).
  template <class Positions, class Weight, class Add>
  void accumulate(const Positions& positions, const TriangleComplex& complex,
                  const Array<Index>& labels, Weight weight_of_area, Add add, Threads threads) {
    records_.forget_boundaries();
    if (components() == 0)
      return;
    with_wedge_sums(
        wedge_count(complex.vertex_capacity()), components(), complex.arena(), [&](auto sums) {
          for_each_range(threads, complex.vertex_capacity(), [&](const auto& range, std::size_t) {
            for (Index v = range.begin; v < range.end; ++v)
              table_.for_each(v, [&](Index wedge) { sums.clear(wedge); });
            add_faces(range, positions, complex, labels, weight_of_area, sums);
            for (Index v = range.begin; v < range.end; ++v)
              table_.for_each(v, [&](Index wedge) { add(v, sums.resolve(wedge, records_)); });
          });
        });
  }

  /// Does a chart end between two faces at the edge vw, or is it folded there?
  bool ends_between(const TriangleComplex& complex, Index face, Index other, Index v,
                    Index w) const {
    return has_seam(complex, face, other, v, w) || has_texture_fold(complex, face, other, v, w);
  }
  /// Are chart boundaries constrained, and may no face turn over in the texture?
  bool constrains_charts() const { return is_texture_ && (are_seams_kept() || are_seams_soft()); }
  double chart_boundary_weight() const {
    return boundary_weight_.value_or(0);
  } ///< see ChannelOptions
  bool is_boundary_weight_given() const { return boundary_weight_.has_value(); }
  /// Sets the weight of soft seams, by the fraction of edges that they are: if they are few,
  /// constraining them strongly costs little of the shape; if they are many, little else can
  /// change.
  void choose_boundary_weight(double fraction) {
    boundary_weight_ = std::clamp(0.0036 / (fraction * fraction), 0.1, 1.0);
  }
  /// Constrains the chart of a face at its edge vw, which counts as an area: the texture may slide
  /// along the edge and not away from it. The constraint at v is added to `form`.
  void constrain_boundary(const TriangleComplex& complex, const Array<Index>& labels, Index face,
                          Index v, Index w, double area, QuadricForm<3>& form) {
    records_.constrain_boundaries();
    const Index at_v = wedge(complex, face, v);
    const Vector<2> p = records_.texture_at(at_v), q = texture_at(complex, face, w);
    const Vector<2> along = q - p;
    const double squared = squared_length(along);
    if (!(squared > 0))
      return;
    const double factor = this->factor(labels, face) * chart_boundary_weight() * area *
                          joiner_.squared_weights()[0] / squared;
    WedgeMap edge;
    edge.boundary = {factor * along[1] * along[1], -factor * along[0] * along[1],
                     factor * along[0] * along[0]};
    edge.maps = {AffineMap{{}, p[0]}, AffineMap{{}, p[1]}};
    WedgeMap chart = records_.map(at_v);
    joiner_.join(chart, edge, {}, form);
    records_.write(at_v, chart);
  }

  /// Finds the vertices that have one wedge and constrain no boundary of a chart, once this is
  /// known of all.
  void find_plain_vertices(std::size_t vertices) {
    is_plain_.resize(vertices);
    for (Index v = 0; v < vertices; ++v)
      is_plain_[v] = is_plain(v);
  }

  /// Does the contraction of a pair only join the one wedge of each of its ends, freely?
  QUADRILLE_ALWAYS_INLINE bool joins_two(const ContractedPair& pair) const {
    return joins_two(pair.first, pair.second) && !pair.is_first_fixed && !pair.is_second_fixed;
  }
  /// Answers this for pairs without a fixed end.
  QUADRILLE_ALWAYS_INLINE bool joins_two(Index first, Index second) const {
    return (is_plain_[first] & is_plain_[second]) != 0;
  }

  /// Adds what the wedges of two ends disagree about, about the first end.
  QUADRILLE_ALWAYS_INLINE void add_difference(Index first, Index second, const Vector<3>& to_second,
                                              QuadricForm<3>& form) const {
    const double weight = MapJoiner::parallel(records_.weight(first), records_.weight(second));
    for_each_four(components(), [&](std::size_t four, auto count) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      const auto [x, y, z, off] =
          records_.template differences<count>(first, second, to_second, four);
      for (std::size_t i = 0; i < count; ++i)
        form += squared_plane(in_doubles(x[i], y[i], z[i]), static_cast<double>(off[i]), weight);
    });
  }
  /// The texture coordinates of the joined wedge at a target, given from the first end.
  Vector<2> joined_texture(const ContractedPair& pair, const Vector<3>& target) const {
    const Lanes values =
        records_.joined(pair.first, pair.second, pair.to_second, target, 0).values[0];
    return {values[0], values[1]};
  }
  /// Carries the contraction of a pair out that joins two wedges: see joins_two().
  void apply_join(const TriangleComplex& complex, const PairStar& star, const ContractedPair& pair,
                  Index kept, const Vector<3>& target) {
    records_.join(pair.first, pair.second, pair.to_second, target, kept, joiner_.squared_weights());
    if (!table_.has_seams())
      return;
    const bool is_first_kept = kept == pair.first; // whose corners have its wedge already
    for (const StarFace& f : is_first_kept ? star.second : star.first)
      table_.rename_corner(complex, f.face, is_first_kept ? pair.second : pair.first,
                           [kept](Index) { return kept; });
  }

  /// Carries a contraction out: the first of some wedges, those of both ends, get the maps and
  /// origins of changes, and a corner of the star gets the wedge renamed(old wedge).
  template <class Changes, class Rename>
  void apply(const TriangleComplex& complex, const PairStar& star, const ContractedPair& pair,
             WedgeList wedges, const Changes& changes, Rename renamed) {
    for (std::size_t k = 0; k < changes.size(); ++k)
      records_.write(wedges[k], changes[k].map, changes[k].origin);
    if (table_.has_seams()) {
      rename_corners(complex, star, pair, renamed);
      wedges.resize(changes.size());
      table_.chain(wedges);
    }
    is_plain_[wedges.front()] = is_plain(wedges.front());
  }

  /// Gives the wedges the values of a result, where these are not those of least cost.
  template <class Positions>
  void resolve(const Positions& positions, const TriangleComplex& complex) {
    if (new_values_ == NewValues::existing)
      records_.restore_existing();
    if (new_values_ == NewValues::recomputed)
      records_.set_normals(
          wedge_normals(table_, wedge_count(complex.vertex_capacity()), positions, complex));
  }

  /// Keeps only the vertices of an ascending list, and the faces for which is_left is true.
  template <class IsLeft>
  void pack(const Array<Index>& vertices, IsLeft is_left) {
    internal::pack(is_plain_, vertices);
    records_.pack(table_.pack(vertices, is_left));
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const {
    records_.prefetch(vertex);
    table_.prefetch(vertex);
  }

  const WedgeTable& table() const { return table_; }
  const MapJoiner& joiner() const { return joiner_; }
  const WedgeRecords& records() const { return records_; }
  WedgeRecords& records() { return records_; }
  bool are_pairs_edges() const { return are_pairs_edges_; }

private:
  bool is_plain(Index v) const {
    return are_pairs_edges_ && table_.has_one(v) && !records_.has_constrained_boundary(v);
  }
  static bool has_one_a_vertex(const ChannelInput& input) {
    return input.corners.empty() || input.seams == Seams::free;
  }
  // How much more a face weighs than others, for its label.
  double factor(const Array<Index>& labels, Index face) const {
    return factors_.empty() || labels.empty() ? 1 : factors_[labels[face]];
  }

  // A texture changes by a length for each length nearly everywhere; others change by much more at
  // what is sharp in them, and are to count there.
  double steepness_factor() const { return is_texture_ ? 1 : 1.0 / 16; }
  // Adds all faces to the sums of the wedges of a range of vertices.
  template <class Range, class Positions, class Weight, class Sums>
  void add_faces(const Range& range, const Positions& positions, const TriangleComplex& complex,
                 const Array<Index>& labels, Weight weight_of_area, Sums& sums) const {
    typename Sums::Row row(components());
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      const auto& v = complex.vertices(face);
      if (complex.is_removed(face) ||
          !(range.contains(v[0]) || range.contains(v[1]) || range.contains(v[2])))
        continue;
      const std::array wedges{table_.at(face, 0, v[0]), table_.at(face, 1, v[1]),
                              table_.at(face, 2, v[2])};
      const std::array corners{positions[v[0]], positions[v[1]], positions[v[2]]};
      if (!set_row(row, corners, wedges, factor(labels, face), weight_of_area))
        continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (range.contains(v[i]))
          sums.add(wedges[i], row);
    }
  }
  // Computes the gradients of the attributes on a face, with their weight: the area, and less if
  // attributes change by more than a length (for others than textures, four) for each length, so
  // that the weight of slivers is bounded. False if it has none.
  template <class Row, class Weight>
  QUADRILLE_ALWAYS_INLINE bool set_row(Row& row, const std::array<Vector<3>, 3>& corners,
                                       const std::array<Index, 3>& wedges, double factor,
                                       Weight weight_of_area) const {
    const Vector<3> to_second = corners[1] - corners[0], to_third = corners[2] - corners[0];
    const Vector<3> normal = cross(to_second, to_third);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return false;
    const double inverse = 1 / squared;
    const double steepness = row.set(records_, wedges, inverse * cross(to_third, normal),
                                     inverse * cross(normal, to_second));
    const double weight =
        factor * weight_of_area(0.5 * std::sqrt(squared)) /
        (1 + steepness_factor() * factor * steepness / static_cast<double>(components()));
    row.weigh(weight);
    return weight > 0;
  }

  template <class Rename>
  void rename_corners(const TriangleComplex& complex, const PairStar& star,
                      const ContractedPair& pair, Rename renamed) {
    for (const StarFace& f : star.first)
      table_.rename_corner(complex, f.face, pair.first, renamed);
    for (const StarFace& f : star.second)
      table_.rename_corner(complex, f.face, pair.second, renamed);
  }

  Seams seams_;
  NewValues new_values_;
  bool is_texture_;
  std::optional<double> boundary_weight_;
  bool are_pairs_edges_;                                    // or may be taken as such
  std::vector<double> factors_;                             // of each label; or none
  std::function<bool(std::span<double>, bool)> as_written_; // see ChannelInput
  WedgeTable table_;
  WedgeRecords records_;
  MapJoiner joiner_;
  Array<unsigned char> is_plain_; // of each vertex: see joins_two()
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_H
