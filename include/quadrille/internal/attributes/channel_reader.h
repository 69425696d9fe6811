#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_READER_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_READER_H

#include <quadrille/internal/attributes/wedge_records.h>
#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Makes wedges of a channel's input, for a complex with the numbers of a numbering.
template <class Numbering>
class ChannelReader {
public:
  ChannelReader(const ChannelInput& input, const Numbering& numbering,
                const TriangleComplex& complex)
      : input_(input), numbering_(numbering), complex_(complex) {}

  /// Several wedges a vertex, where values differ. A table that may stay empty does so where none
  /// has several.
  void read_wedges(WedgeTable& table, WedgeRecords& records, bool may_stay_empty) const {
    Array<Index> origins(complex_.vertex_capacity(), none, complex_.arena());
    table.build(
        complex_, [&](Index face, Index i) { return value_at(face, i); },
        [&](Index value, Index other) { return input_.are_equal(value, other); },
        [&](Index wedge, Index value) {
          if (wedge >= origins.size())
            origins.resize(std::size_t{wedge} + 1, none);
          origins[wedge] = value;
        });
    if (may_stay_empty)
      table.simplify_if_possible(complex_.vertex_capacity());
    records.read(input_, std::move(origins));
  }

  /// One wedge a vertex, with the mean of the values at its corners where these differ, or the
  /// first of them where only existing values may be.
  void read_vertices(WedgeRecords& records) const {
    Array<Index> origins(complex_.vertex_capacity(), none, complex_.arena());
    for (Index v = 0; v < origins.size(); ++v)
      if (input_.corners.empty())
        origins[v] = complex_.has_faces(v) ? numbering_.vertices[v] : none;
      else
        complex_.for_each_corner(v, [&](Index face, Index i) {
          if (origins[v] == none)
            origins[v] = value_at(face, i);
        });
    records.read(input_, std::move(origins));
    if (!input_.corners.empty() && input_.new_values != NewValues::existing)
      for (Index v = 0; v < complex_.vertex_capacity(); ++v)
        take_mean(records, v);
  }

private:
  Index value_at(Index face, std::size_t i) const {
    return input_.value_at(numbering_.faces[face], i,
                           numbering_.vertices[complex_.vertices(face)[i]]);
  }

  void take_mean(WedgeRecords& records, Index v) const {
    std::vector<double> sum(input_.components, 0.0);
    double count = 0;
    bool are_equal = true;
    complex_.for_each_corner(v, [&](Index face, Index i) {
      const Index value = value_at(face, i);
      are_equal = are_equal && input_.are_equal(value, records.origin(v));
      for (std::size_t c = 0; c < input_.components; ++c)
        sum[c] += input_.value(value, c);
      ++count;
    });
    if (are_equal)
      return;
    for (double& s : sum)
      s /= count;
    records.set_values(v, sum);
  }

  const ChannelInput& input_;
  const Numbering& numbering_;
  const TriangleComplex& complex_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_READER_H
