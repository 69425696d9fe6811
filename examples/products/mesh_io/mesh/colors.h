#ifndef QUADRILLE_EXAMPLES_MESH_IO_COLORS_H
#define QUADRILLE_EXAMPLES_MESH_IO_COLORS_H

/// \file
/// Colours as files write them, and in which unit.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace quadrille_examples {

/// Red, green, blue and alpha, in the unit of a ColorType.
using Color = std::array<double, 4>;

/// How the numbers of colours are written.
struct ColorType {
  double full = 255;      ///< full intensity: 1, 255 or 65535
  bool is_whole = true;   ///< integers from 0 to `full`; else any numbers
  bool is_single = false; ///< of single precision; else double
  bool has_alpha = false; ///< else it is `full` everywhere
};

/// A number that is not there: full intensity, whatever the unit.
inline constexpr double opaque = std::numeric_limits<double>::infinity();

/// Of the numbers of all colours.
class ColorNumbers {
public:
  explicit ColorNumbers(const std::vector<Color>& colors) {
    for (const Color& color : colors)
      for (const double channel : color)
        if (std::isfinite(channel) && channel != 0)
          add(channel);
  }

  double greatest() const { return greatest_; }
  std::size_t above_one() const { return above_one_; }

  /// No fractions, for most are above 1; where all are below 17, they are bright fractions.
  bool look_like_bytes() const { return 2 * above_one_ > others_than_zero_ && greatest_ > 16; }

private:
  void add(double channel) {
    greatest_ = std::max(greatest_, channel);
    above_one_ += channel > 1;
    ++others_than_zero_;
  }

  double greatest_ = 0;
  std::size_t above_one_ = 0, others_than_zero_ = 0;
};

/// Decides the unit of colours whose type does not tell it, and returns what was guessed, if
/// anything. Numbers of a floating-point type, or of a text with decimal points, are fractions;
/// unless most of those that are not 0 are above 1. Whole numbers of a text are from 0 to 255;
/// unless none is above 1.
inline std::optional<std::string> estimate_unit(const std::vector<Color>& colors, ColorType& type) {
  const ColorNumbers numbers(colors);
  if (type.is_whole) {
    type.full = 255;
    if (numbers.greatest() != 1)
      return std::nullopt;
    type.full = 1;
    type.is_whole = false;
    return "colours that are all 0 or 1 are taken as fractions";
  }
  type.full = numbers.look_like_bytes() ? 255 : 1;
  if (type.full == 255)
    return "colours are taken as 0 to 255, since most of their values are above 1";
  if (numbers.above_one() > 0)
    return "colours are taken as fractions; values above 1, which are kept unchanged: " +
           std::to_string(numbers.above_one());
  return std::nullopt;
}

/// A number as one of single precision, which may be infinite.
inline double as_single(double x) {
  if (std::abs(x) > std::numeric_limits<float>::max())
    return std::copysign(std::numeric_limits<double>::infinity(), x);
  return static_cast<float>(x);
}

/// Makes the colours finite numbers of their type, those of integers within their range. Returns
/// how many numbers were none, and how many out of range.
inline std::array<std::size_t, 2> mend_colors(std::vector<Color>& colors, const ColorType& type) {
  std::size_t not_numbers = 0, out_of_range = 0;
  for (Color& color : colors)
    for (double& channel : color) {
      if (type.is_single)
        channel = as_single(channel);
      not_numbers += std::isnan(channel);
      if (!std::isfinite(channel))
        channel = channel > 0 ? type.full : 0; // NaN is not above 0
      const double inside = std::clamp(channel, 0., type.full);
      if (type.is_whole && channel != inside) {
        channel = inside;
        ++out_of_range;
      }
    }
  return {not_numbers, out_of_range};
}

} // namespace quadrille_examples

#endif
