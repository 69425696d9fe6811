#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_TWO_CHANNEL_FORMS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_TWO_CHANNEL_FORMS_H

#include <quadrille/internal/attributes/affine_maps.h>
#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/attributes/channel_contraction.h>
#include <quadrille/internal/attributes/channels.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/evaluation/two_quadrics.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// \file
/// Adds the costs of channels to two pairs at the price of one.

/// Adds what the maps of the wedges that have the numbers of the ends of two pairs disagree about:
/// see MapJoiner::add_difference. `to_seconds`: from the first ends to the second.
QUADRILLE_ALWAYS_INLINE inline void add_differences(const Channel& channel, const TwoPairs& two,
                                                    const LaneVector& to_seconds, LaneForm& form) {
  const WedgeRecords& records = channel.records();
  const auto& [p, q] = two;
  const Lanes w1{records.weight(p.first), records.weight(q.first)};
  const Lanes w2{records.weight(p.second), records.weight(q.second)};
  const Lanes sum = w1 + w2;
  const Lanes weight = select(sum > Lanes{}, w1 * w2 / sum, Lanes{});
  const AffineMap *const a = records.maps(p.first), *const b = records.maps(q.first);
  const AffineMap *const c = records.maps(p.second), *const d = records.maps(q.second);
  const std::vector<double>& squared_weights = channel.joiner().squared_weights();
  for (std::size_t i = 0; i < squared_weights.size(); ++i) {
    const LaneVector gradient = both(c[i].gradient, d[i].gradient);
    const Lanes off =
        Lanes{c[i].value, d[i].value} - dot(gradient, to_seconds) - Lanes{a[i].value, b[i].value};
    form += squared_plane(gradient - both(a[i].gradient, b[i].gradient), off,
                          squared_weights[i] * weight);
  }
}

/// Returns the discrepancies of all channels at two pairs, about their first ends. Fixed ends are
/// treated as free ones.
template <class Channels>
LaneForm two_joins(const Channels& channels, const TwoPairs& two,
                   const std::array<Vector<3>, 2>& to_seconds) {
  LaneForm form;
  const auto& [p, q] = two;
  const LaneVector displacements = both(to_seconds[0], to_seconds[1]);
  for (const Channel& channel : channels.all()) {
    if (channel.joins_two(p.first, p.second) && channel.joins_two(q.first, q.second)) [[likely]] {
      add_differences(channel, two, displacements, form);
    } else {
      std::array<QuadricForm<3>, 2> forms;
      for (std::size_t k = 0; k < 2; ++k)
        channels.add_joins(channel, {two[k].first, two[k].second, to_seconds[k]}, forms[k]);
      form += both(forms[0], forms[1]);
    }
  }
  return form;
}

/// Returns these with the quadrics of channels at the ends, if a cost adds these to its local
/// terms; NothingAdded, if a cost does not count channels.
template <class Cost>
auto two_channel_forms(const Channels<Cost>& channels, const TwoPairs& two,
                       const std::array<Vector<3>, 2>& to_seconds) {
  if constexpr (accumulates_forms<Cost>) {
    return two_joins(channels, two, to_seconds);
  } else if constexpr (sees_forms<Cost>) {
    const auto& [p, q] = two;
    LaneForm form = LaneForm::sum_about_first(
        both(channels.form(p.first), channels.form(q.first)),
        both(channels.form(p.second), channels.form(q.second)), both(to_seconds[0], to_seconds[1]));
    form += two_joins(channels, two, to_seconds);
    return form;
  } else {
    return NothingAdded{};
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_TWO_CHANNEL_FORMS_H
