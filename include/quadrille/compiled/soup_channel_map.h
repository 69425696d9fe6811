#ifndef QUADRILLE_COMPILED_SOUP_CHANNEL_MAP_H
#define QUADRILLE_COMPILED_SOUP_CHANNEL_MAP_H

#include <quadrille/channel_options.h>
#include <quadrille/compiled.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace quadrille::internal {

/// A channel of a caller whose kind and components are only known at run time: the type-erased
/// counterpart of ChannelMap, with bit-identical results.
class SoupChannelMap {
public:
  explicit SoupChannelMap(const SoupChannelView& channel) : channel_(channel) {}

  const SoupChannelView& channel() const { return channel_; }
  bool is_indexed() const { return !channel_.triangles.empty(); }
  std::size_t value_count() const { return channel_.values.size() / channel_.components; }

  /// Throws std::invalid_argument for an invalid channel, with its `name` in the message.
  void validate(const std::string& name, std::size_t points, std::size_t triangles) const;

  /// Returns the input of the channel, except for the corners.
  ChannelInput input(Arena& arena) const;
  /// Keeps written values within the range of the faces' values.
  void end_of_reading(ChannelInput& input, const Array<TriangleComplex::Triangle>& triangles);

  /// Appends the value of a wedge in the result, which replaces an old value, from its components.
  /// `is_new` means that the simplification has changed it.
  void append(std::span<const double> components, bool is_new, Index old,
              std::vector<double>& values) const;

private:
  using Kind = SoupChannelView::Kind;

  std::span<const double> raw(Index value) const {
    return channel_.values.subspan(value * channel_.components, channel_.components);
  }
  /// Returns the number that the engine uses for a value: in linear light if that is requested.
  double counted(double number, std::size_t component) const;
  double of_user(double number, std::size_t component) const;
  /// Returns false if no value is in range, so that the old value stays.
  bool bring_in_range(std::span<double> value) const;

  SoupChannelView channel_;
  std::vector<double> low_, high_; // the range of colours
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_CHANNEL_MAP_H
