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

/// A channel of a caller's of which kind and components are known at run time only: what ChannelMap
/// is of those that types tell, to the same bits.
class SoupChannelMap {
public:
  explicit SoupChannelMap(const SoupChannelView& channel) : channel_(channel) {}

  const SoupChannelView& channel() const { return channel_; }
  bool is_indexed() const { return !channel_.triangles.empty(); }
  std::size_t value_count() const { return channel_.values.size() / channel_.components; }

  /// Throws std::invalid_argument for a channel that makes no sense, which is called `name`.
  void validate(const std::string& name, std::size_t points, std::size_t triangles) const;

  /// With all but corners.
  ChannelInput input(Workspace& workspace) const;
  /// What is written stays in the limits of what faces had.
  void end_of_reading(ChannelInput& input, const Array<TriangleComplex::Triangle>& triangles);

  /// Appends what a wedge of a result has in place of an old value, by its components in the
  /// result. `is_new`: a simplification has changed it.
  void append(std::span<const double> components, bool is_new, Index old,
              std::vector<double>& values) const;

private:
  using Kind = SoupChannelView::Kind;

  std::span<const double> raw(Index value) const {
    return channel_.values.subspan(value * channel_.components, channel_.components);
  }
  /// The number of a value that counts: in linear light if that is asked for.
  double counted(double number, std::size_t component) const;
  double of_user(double number, std::size_t component) const;
  /// False where there is nothing in range, so that the old value is left.
  bool bring_in_range(std::span<double> value) const;

  SoupChannelView channel_;
  std::vector<double> low_, high_; // of colours
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_CHANNEL_MAP_H
