#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_CHANNEL_INPUT_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_CHANNEL_INPUT_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// A channel as an adapter reads it: values, and which of them each corner of a face has.
struct ChannelInput {
  explicit ChannelInput(Arena* arena = nullptr) : values(arena), corners(arena) {}
  /// Takes the options of a channel of `size` components; its values and corners are still missing.
  ChannelInput(const ChannelOptions& options, std::size_t size, Attribute kind, Arena& arena)
      : ChannelInput(&arena) {
    components = size;
    weights = options.weights;
    importance = options.importance;
    attribute = kind;
    seams = options.seams.value_or(is_texture() ? Seams::soft : Seams::priced);
    chart_boundary_weight = options.chart_boundary_weight;
    if (seams != Seams::soft && !chart_boundary_weight)
      chart_boundary_weight = 10;
    new_values = options.new_values;
  }

  std::size_t components = 0;
  Array<double> values; ///< the components of each value, one value after the other
  /// The values of each input face, in the order of its corners; empty: a value has the index of
  /// its vertex.
  Array<std::array<Index, 3>> corners;
  /// The weights of the components, in the mesh's unit; empty: by default.
  std::vector<double> weights;
  double importance = 1;
  Seams seams = Seams::priced;
  Attribute attribute = Attribute::any;
  std::optional<double>
      chart_boundary_weight; ///< see ChannelOptions; none: by the fraction that seams are
  NewValues new_values = NewValues::optimal;
  /// Turns the components of a value into those that the adapter would write, before they are
  /// rounded to its type. False if it would leave the old ones. as_written(values, has_changed)
  std::function<bool(std::span<double>, bool)> as_written;

  bool is_texture() const { return attribute == Attribute::texture; }
  std::size_t size() const { return components == 0 ? 0 : values.size() / components; }
  double value(Index i, std::size_t component) const { return values[i * components + component]; }
  /// Returns the value of a corner of an input face, which is at an input vertex.
  Index value_at(Index face, std::size_t corner, Index vertex) const {
    return corners.empty() ? vertex : corners[face][corner];
  }
  bool are_equal(Index i, Index j) const {
    if (i == j)
      return true;
    for (std::size_t c = 0; c < components; ++c)
      if (value(i, c) != value(j, c))
        return false;
    return true;
  }

  void require_finite() const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw std::invalid_argument("quadrille::simplify: value " + std::to_string(i / components) +
                                    " of a channel is not finite");
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_CHANNEL_INPUT_H
