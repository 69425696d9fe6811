#ifndef QUADRILLE_INTERNAL_BASE_MERGES_H
#define QUADRILLE_INTERNAL_BASE_MERGES_H

#include <quadrille/internal/base/index.h>

namespace quadrille::internal {

/// What a number has become part of in the end, where `merged_into` tells for each number another
/// one that it has become part of, or none. Shortens the way that it goes, so that many questions
/// take little more than linear time.
template <class Numbers>
Index follow_merges(Numbers& merged_into, Index number) {
  while (merged_into[number] != none) {
    Index& next = merged_into[number];
    if (merged_into[next] != none)
      next = merged_into[next];
    number = next;
  }
  return number;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_MERGES_H
