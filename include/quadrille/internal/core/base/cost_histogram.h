#ifndef QUADRILLE_INTERNAL_CORE_BASE_COST_HISTOGRAM_H
#define QUADRILLE_INTERNAL_CORE_BASE_COST_HISTOGRAM_H

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille::internal {

/// How many faces contractions took, by what these cost: a counter for each value of the upper bits
/// of a float that is not negative, eight of the exponent and five of the mantissa, so that costs
/// of one counter differ by 3 % at most. Numbers are whole, so the sum of histograms is the same in
/// any order. 64 KB.
class CostHistogram {
public:
  static constexpr std::size_t size = 8192;

  CostHistogram() : counters_(size, 0) {}

  /// A contraction of that key took so many faces. A key that is negative counts as 0.
  void add(float key, std::uint64_t faces) { counters_[counter_of(key)] += faces; }
  /// Adds faces at a cost, by several threads at a time.
  void add_in_pass(float key, std::uint64_t faces) {
    std::uint64_t& counter = counters_[counter_of(key)];
#ifdef __cpp_lib_atomic_ref
    std::atomic_ref(counter).fetch_add(faces, std::memory_order_relaxed);
#else // LLVM's library has none before its version 19
    __atomic_fetch_add(&counter, faces, __ATOMIC_RELAXED);
#endif
  }

  CostHistogram& operator+=(const CostHistogram& other) {
    std::transform(counters_.begin(), counters_.end(), other.counters_.begin(), counters_.begin(),
                   std::plus<>());
    return *this;
  }

  /// All faces that were taken.
  std::uint64_t total() const {
    return std::accumulate(counters_.begin(), counters_.end(), std::uint64_t{0});
  }
  /// Counts the faces that were removed at no more than the greatest cost of this cost's counter.
  std::uint64_t up_to(float key) const {
    const auto end = counters_.begin() + static_cast<std::ptrdiff_t>(counter_of(key)) + 1;
    return std::accumulate(counters_.begin(), end, std::uint64_t{0});
  }
  /// The greatest cost of the first counter at which at least that many faces have been taken;
  /// infinity if fewer were in all.
  float cost_for(std::uint64_t faces) const {
    std::uint64_t taken = 0;
    for (std::size_t counter = 0; counter < size; ++counter)
      if ((taken += counters_[counter]) >= faces)
        return greatest_of(counter);
    return std::numeric_limits<float>::infinity();
  }

  std::span<std::uint64_t, size> counters() {
    return std::span<std::uint64_t, size>(counters_.data(), size);
  }
  std::span<const std::uint64_t, size> counters() const {
    return std::span<const std::uint64_t, size>(counters_.data(), size);
  }

private:
  static constexpr int lower_bits = 18;

  static std::size_t counter_of(float key) {
    return key > 0 ? std::bit_cast<std::uint32_t>(key) >> lower_bits : 0; // NaN counts as 0
  }
  static float greatest_of(std::size_t counter) {
    const auto next = static_cast<std::uint32_t>(counter + 1) << lower_bits;
    return (std::min)(std::bit_cast<float>(next - 1), (std::numeric_limits<float>::max)());
  }

  std::vector<std::uint64_t> counters_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_COST_HISTOGRAM_H
