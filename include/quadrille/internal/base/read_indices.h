#ifndef QUADRILLE_INTERNAL_BASE_READ_INDICES_H
#define QUADRILLE_INTERNAL_BASE_READ_INDICES_H

#include <quadrille/internal/base/index.h>

#include <array>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille::internal {

/// By what names a complaint about indices calls things.
struct IndexWords {
  const char* caller;
  const char* name = "point"; ///< of what an index stands for
  const char* of_what = "";
};

/// The three indices of a face, which are below `count`: of points, or of something else that the
/// face names. Throws std::invalid_argument, with not_three() if they are not three.
template <class Triple, class NotThree>
std::array<Index, 3> read_indices(const Triple& triple, std::size_t face, std::size_t count,
                                  const IndexWords& words, NotThree not_three) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(std::string(words.caller) + ": face " + std::to_string(face) +
                                what);
  };
  if (std::ranges::size(triple) != 3)
    refuse(not_three());
  std::array<Index, 3> indices;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::in_range<Index>(triple[i]) || std::cmp_greater_equal(triple[i], count))
      refuse(std::string(" names ") + words.name + " " + std::to_string(triple[i]) + " of " +
             std::to_string(count) + words.of_what);
    indices[i] = static_cast<Index>(triple[i]);
  }
  return indices;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_READ_INDICES_H
