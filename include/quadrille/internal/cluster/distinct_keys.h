#ifndef QUADRILLE_INTERNAL_CLUSTER_DISTINCT_KEYS_H
#define QUADRILLE_INTERNAL_CLUSTER_DISTINCT_KEYS_H

#include <quadrille/internal/core/base/index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// All bits of the result depend on all bits of x (the finalizer of Steele, Lea and Flood's
/// SplitMix64, 2014).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}
constexpr std::uint64_t mixed(const std::array<Index, 3>& key) {
  return mixed(mixed(std::uint64_t{key[0]} << 32 | key[1]) ^ key[2]);
}

/// Numbers keys 0, 1, … in the order in which they first come: a hash table that is at most half
/// full. Expected time O(1) a key; 8 to 16 bytes for each one beside the key itself.
template <class Key>
class DistinctKeys {
public:
  std::size_t size() const { return keys_.size(); }

  /// The number of a key, which is size() before the call if the key is new.
  Index number(const Key& key) {
    if (2 * (keys_.size() + 1) > slots_.size())
      grow();
    Index& slot = slot_of(key);
    if (slot == none) {
      keys_.push_back(key);
      slot = static_cast<Index>(keys_.size() - 1);
    }
    return slot;
  }

  void clear() {
    keys_.clear();
    slots_.clear();
  }

private:
  // That of the key, or the empty one where it belongs.
  Index& slot_of(const Key& key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(mixed(key)) & mask;
    while (slots_[at] != none && keys_[slots_[at]] != key)
      at = (at + 1) & mask;
    return slots_[at];
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), none);
    for (Index i = 0; i < keys_.size(); ++i)
      slot_of(keys_[i]) = i;
  }

  std::vector<Key> keys_;
  std::vector<Index> slots_; // as many as a power of two
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_DISTINCT_KEYS_H
