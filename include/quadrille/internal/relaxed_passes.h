#ifndef QUADRILLE_INTERNAL_RELAXED_PASSES_H
#define QUADRILLE_INTERNAL_RELAXED_PASSES_H

#include <quadrille/internal/pair_contraction.h>
#include <quadrille/internal/parallel.h>
#include <quadrille/internal/scratch.h>
#include <quadrille/order.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille::internal {

/// Contracts pairs in passes, as RelaxedOrder says.
template <class Policies>
class RelaxedPasses {
public:
  RelaxedPasses(PairContraction<Policies>& surface, const RelaxedOrder& order)
      : surface_(surface), order_(order), is_touched_(surface.vertex_capacity()),
        block_(surface.vertex_capacity()) {
    workers_.assign(order.threads, Scratch(surface.vertex_capacity()));
  }

  /// Passes as long as they pay. False if the visitor said so.
  bool run() {
    for (;;) {
      const Status before = surface_.status();
      const std::size_t least = std::max(least_contractions, before.vertices / least_part);
      const std::size_t quota = allowed_contractions();
      if (quota < least)
        return true;
      pass(quota);
      if (!surface_.policies().visitor.proceed(surface_.status()))
        return false;
      if (surface_.status().contractions - before.contractions < least)
        return true;
    }
  }

private:
  using Candidate = typename PairContraction<Policies>::Candidate;

  struct Proposal {
    float cost;
    Index first, second;
  };

  // A pass of fewer contractions, or of a lesser part of the vertices, does not pay.
  static constexpr std::size_t least_contractions = 64, least_part = 32;
  static constexpr std::size_t block_size = 4096;         // vertices
  static constexpr std::size_t pairs_per_contraction = 3; // so many find enough that can be done

  // As many as the stop policy, asked before each, would let pass in a row.
  std::size_t allowed_contractions() const {
    const Status now = surface_.status();
    // Where topology is free, doubled faces go too.
    const std::size_t faces_per_contraction = surface_.is_topology_kept() ? 2 : 4;
    const auto is_enough_after = [&](std::size_t contractions) {
      Status after = now;
      after.faces -= std::min(after.faces, faces_per_contraction * contractions);
      after.vertices -= contractions;
      after.contractions += contractions;
      after.next_error = after.next_distance = 0;
      return surface_.policies().stop(after);
    };
    std::size_t allowed = 0; // the first `allowed` are, `refused` are not
    std::size_t refused = now.vertices + 1;
    while (refused - allowed > 1) {
      const std::size_t middle = allowed + (refused - allowed) / 2;
      (is_enough_after(middle - 1) ? refused : allowed) = middle;
    }
    return allowed;
  }

  void pass(std::size_t quota) {
    divide();
    propose(quota);
    std::fill(is_touched_.begin(), is_touched_.end(), 0);
    parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
      contract_inside(block, workers_[worker]);
    });
    for (Scratch& scratch : workers_) {
      quota -= scratch.tally.contractions;
      surface_.count(scratch.tally);
    }
    contract_between(quota);
    surface_.end_pass(order_.refresh);
  }

  unsigned threads() const { return surface_.has_other_pairs() ? 1 : order_.threads; }

  // Blocks of vertices that follow one another.
  void divide() {
    blocks_.clear();
    std::size_t in_block = block_size;
    for (Index v = 0; v < block_.size(); ++v) {
      if (surface_.complex().has_faces(v) && in_block++ == block_size) {
        blocks_.push_back({v, v, {}, 0});
        in_block = 1;
      }
      block_[v] = static_cast<Index>(blocks_.size()) - 1;
      if (!blocks_.empty())
        blocks_.back().end = v + 1;
    }
  }

  // The pairs that may be among the cheapest, by block and in the order of their costs.
  void propose(std::size_t quota) {
    const float limit = cost_limit(quota);
    parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
      std::vector<Proposal>& proposals = blocks_[block].proposals;
      proposals.clear();
      for (Index v = blocks_[block].begin; v < blocks_[block].end; ++v)
        surface_.for_each_pair_above(workers_[worker], v, [&](Index w, float cost) {
          if (cost <= limit)
            proposals.push_back({cost, v, w});
        });
      sort(proposals);
    });
    std::size_t total = 1;
    for (const Block& block : blocks_)
      total += block.proposals.size();
    for (Block& block : blocks_)
      block.allowance = quota * block.proposals.size() / total;
  }

  // By the top 16 bits of the costs; those that have them in common keep their order.
  static void sort(std::vector<Proposal>& proposals) {
    std::vector<Proposal> sorted(proposals.size());
    for (int shift : {16, 24}) {
      std::array<std::size_t, 257> begin{};
      const auto digit = [&](const Proposal& p) {
        return (std::bit_cast<std::uint32_t>(p.cost) >> shift) & 255;
      };
      for (const Proposal& p : proposals)
        ++begin[digit(p) + 1];
      std::partial_sum(begin.begin(), begin.end(), begin.begin());
      for (const Proposal& p : proposals)
        sorted[begin[digit(p)]++] = p;
      proposals.swap(sorted);
    }
  }

  // The share of the pairs that costs no more, from a sample of the vertices; less at the end, when
  // there are few contractions to go.
  float cost_limit(std::size_t quota) {
    constexpr Index step = 16;
    costs_.clear();
    for (Index v = 0; v < block_.size(); v += step)
      surface_.for_each_pair_above(workers_.front(), v,
                                   [&](Index, float cost) { costs_.push_back(cost); });
    const std::size_t rank =
        std::min(static_cast<std::size_t>(order_.share * static_cast<double>(costs_.size())),
                 pairs_per_contraction * quota / step);
    if (rank >= costs_.size())
      return std::numeric_limits<float>::infinity();
    const auto nth = costs_.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(costs_.begin(), nth, costs_.end());
    return *nth;
  }

  // The proposals whose stars lie inside of the block; the others are left for the end of the pass.
  void contract_inside(std::size_t index, Scratch& scratch) {
    Block& block = blocks_[index];
    const auto between =
        std::stable_partition(block.proposals.begin(), block.proposals.end(),
                              [&](const Proposal& p) { return block_[p.second] == index; });
    const std::span<Proposal> inside(block.proposals.begin(), between);
    std::size_t left = 0;
    for (std::size_t i = 0; i < inside.size() && block.allowance > 0; ++i) {
      prefetch(inside, i);
      if (is_touched(inside[i]))
        continue;
      gather(scratch, inside[i]);
      if (is_inside(scratch.star, index))
        block.allowance -= contract(scratch, inside[i]);
      else
        inside[left++] = inside[i];
    }
    block.proposals.erase(block.proposals.begin() + static_cast<std::ptrdiff_t>(left), between);
  }

  void contract_between(std::size_t quota) {
    rest_.clear();
    for (const Block& block : blocks_)
      rest_.insert(rest_.end(), block.proposals.begin(), block.proposals.end());
    sort(rest_);
    Scratch& scratch = workers_.front();
    for (std::size_t i = 0; i < rest_.size() && quota > 0; ++i) {
      prefetch(rest_, i);
      if (is_touched(rest_[i]))
        continue;
      gather(scratch, rest_[i]);
      quota -= contract(scratch, rest_[i]);
    }
    surface_.count(scratch.tally);
  }

  // The proposals of a block lie anywhere in it.
  void prefetch(std::span<const Proposal> proposals, std::size_t i) const {
    surface_.prefetch([&](std::size_t ahead) {
      return i + ahead < proposals.size() ? &proposals[i + ahead] : nullptr;
    });
  }

  bool is_touched(const Proposal& proposal) const {
    return is_touched_[proposal.first] | is_touched_[proposal.second];
  }

  void gather(Scratch& scratch, const Proposal& proposal) {
    surface_.gather(scratch, proposal.first, proposal.second);
  }

  bool is_inside(const PairStar& star, std::size_t block) const {
    bool inside = true;
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces) {
        inside &= block_[f.second] == block;
        inside &= block_[f.third] == block;
      }
    return inside;
  }

  // Is it done?
  bool contract(Scratch& scratch, const Proposal& proposal) {
    const auto [cost, first, second] = proposal;
    const Candidate candidate = surface_.evaluate(first, second);
    if (const auto cause = surface_.rejection(scratch, first, second, candidate)) {
      ++scratch.tally.rejections[static_cast<std::size_t>(*cause)];
      return false;
    }
    if (is_stop(scratch, proposal, candidate))
      return false;
    surface_.contract_in_pass(scratch, first, second, candidate);
    is_touched_[first] = is_touched_[second] = 1;
    return true;
  }

  bool is_stop(Scratch& scratch, const Proposal& proposal, const Candidate& candidate) const {
    Status status = surface_.status();
    status.next_error = candidate.error;
    if constexpr (asks_for_distance<typename Policies::Stop>)
      status.next_distance =
          surface_.bound_distance(scratch, proposal.first, proposal.second, candidate);
    return surface_.policies().stop(status);
  }

  struct Block {
    Index begin, end; // vertices
    std::vector<Proposal> proposals;
    std::size_t allowance; // contractions
  };

  PairContraction<Policies>& surface_;
  RelaxedOrder order_;
  std::vector<unsigned char> is_touched_; // no bits: threads write to it
  std::vector<Index> block_;              // of each vertex
  std::vector<Block> blocks_;
  std::vector<Proposal> rest_;
  std::vector<Scratch> workers_;
  std::vector<float> costs_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_RELAXED_PASSES_H
