#ifndef QUADRILLE_EXAMPLES_AMOUNT_H
#define QUADRILLE_EXAMPLES_AMOUNT_H

#include "text.h"

#include <cmath>
#include <optional>
#include <string_view>

namespace quadrille_examples {

/// A number, or one with a percent sign: that many hundredths.
struct Amount {
  double value = 0;
  bool is_percentage = false;
};

/// Nothing for a word that is neither, or is negative or not finite.
inline std::optional<Amount> parse_amount(std::string_view word) {
  const bool is_percentage = word.ends_with('%');
  const std::optional<double> number =
      parse_number(word.substr(0, word.size() - (is_percentage ? 1 : 0)));
  if (!number || !std::isfinite(*number) || *number < 0)
    return std::nullopt;
  return Amount{is_percentage ? *number / 100 : *number, is_percentage};
}

/// An amount of lengths: in the units of the mesh, or a part of the diagonal of its bounding box.
inline double length_of(const Amount& amount, double diagonal) {
  return amount.is_percentage ? amount.value * diagonal : amount.value;
}

} // namespace quadrille_examples

#endif
