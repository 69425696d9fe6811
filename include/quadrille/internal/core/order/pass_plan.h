#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PASS_PLAN_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PASS_PLAN_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// What a pass over the blocks of a surface is to do: it contracts pairs that cost no more than a
/// limit, and in each block no more of them than its quota. It is made from a sample of what the
/// pairs of each block cost.
struct PassPlan {
  static constexpr std::size_t sample_step = 32; // one vertex in that many is in the sample

  float cost_limit = std::numeric_limits<float>::infinity();
  std::vector<std::size_t> quotas; // contractions, of each block

  /// `share` of the pairs may be contracted, less when `quota` contractions are enough, and none
  /// that costs more than `highest`.
  static PassPlan make(const std::vector<std::vector<float>>& samples, double share,
                       std::size_t quota, float highest = std::numeric_limits<float>::infinity()) {
    PassPlan plan;
    plan.cost_limit = (std::min)(limit(samples, share, quota), highest);
    plan.share_out(samples, quota);
    return plan;
  }

private:
  static constexpr std::size_t pairs_per_contraction = 4; // that many find enough that can be done

  static float limit(const std::vector<std::vector<float>>& samples, double share,
                     std::size_t quota) {
    std::size_t count = 0;
    for (const std::vector<float>& sample : samples)
      count += sample.size();
    std::vector<float> costs;
    costs.reserve(count);
    for (const std::vector<float>& sample : samples)
      costs.insert(costs.end(), sample.begin(), sample.end());
    const std::size_t rank =
        (std::min)(static_cast<std::size_t>(share * static_cast<double>(costs.size())),
                   pairs_per_contraction * quota / sample_step);
    if (rank >= costs.size())
      return std::numeric_limits<float>::infinity();
    const auto nth = costs.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(costs.begin(), nth, costs.end());
    return *nth;
  }

  // To blocks, by the cheap pairs that the sample has found there; less than the quota in all.
  void share_out(const std::vector<std::vector<float>>& samples, std::size_t quota) {
    const auto is_cheap = [this](float cost) { return cost <= cost_limit; };
    std::size_t all = 1;
    for (const std::vector<float>& sample : samples) {
      const auto cheap = std::count_if(sample.begin(), sample.end(), is_cheap);
      quotas.push_back(static_cast<std::size_t>(cheap));
      all += quotas.back();
    }
    for (std::size_t& share : quotas)
      share = quota * share / all;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PASS_PLAN_H
