#ifndef QUADRILLE_INTERNAL_ORDER_RELAXED_PASSES_H
#define QUADRILLE_INTERNAL_ORDER_RELAXED_PASSES_H

#include <quadrille/internal/base/digit_sort.h>
#include <quadrille/internal/base/parallel.h>
#include <quadrille/internal/base/ranges.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/allowance.h>
#include <quadrille/internal/contraction/leftovers.h>
#include <quadrille/internal/contraction/pair_contraction.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/order/block_stars.h>
#include <quadrille/order.h>
#include <quadrille/report.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Contracts pairs in passes, as RelaxedOrder says.
template <class Policies>
class RelaxedPasses {
public:
  RelaxedPasses(PairContraction<Policies>& surface, const RelaxedOrder& order)
      : surface_(surface), order_(order), allowance_(surface.is_topology_kept()),
        stars_(surface.complex().workspace()) {
    Workspace* const workspace = surface.complex().workspace(); // for one thread
    for (Scratch& scratch : surface.scratches())
      workers_.emplace_back(scratch, surface.scratches().size() == 1 ? workspace : nullptr);
  }

  /// Passes as long as they pay. False if the visitor said so.
  bool run() {
    for (;;) {
      const Status before = surface_.status();
      const std::size_t least = std::max(least_contractions, before.vertices / least_part);
      const std::size_t quota = allowance_.contractions(surface_.policies().stop, before);
      if (quota < least)
        return true;
      pass(quota);
      if (!surface_.proceed())
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

  struct Block {
    Index begin, end;               // vertices
    std::vector<float> sample = {}; // what some of its pairs cost
    std::size_t allowance = 0;      // contractions
    std::vector<Proposal> rest = {};
  };

  // Each thread has one.
  struct Worker {
    Worker(Scratch& s, Workspace* workspace)
        : scratch(s), proposals(workspace), others(workspace) {}

    void release() {
      proposals.release();
      others.release();
    }

    Scratch& scratch;
    Room<Proposal> proposals;
    Room<Proposal> others; // half sorted, then those that are left
  };

  // A pass of fewer contractions, or of a lesser part of the vertices, does not pay.
  static constexpr std::size_t least_contractions = 64, least_part = 32;
  static constexpr std::size_t block_size = 4096; // vertices: what they need fits into a cache
  static constexpr std::size_t joined_blocks = BlockStars::joined_blocks;
  static constexpr Index sample_step = 32;
  static constexpr std::size_t pairs_per_contraction = 4; // so many find enough that can be done

  // What a block needs is loaded once: it is contracted right after its costs are known.
  void pass(std::size_t quota) {
    divide();
    sample();
    const float limit = cost_limit(quota);
    share_out(quota, limit);
    parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
      propose(blocks_[block], limit, workers_[worker]);
      contract_inside(blocks_[block], workers_[worker]);
    });
    while (blocks_.size() >= 2 * joined_blocks) {
      join_blocks();
      parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
        workers_[worker].proposals.clear();
        take_rest(blocks_[block], workers_[worker]);
        sort(workers_[worker]);
        contract_inside(blocks_[block], workers_[worker]);
      });
    }
    for (Worker& worker : workers_)
      surface_.count(worker.scratch.tally);
    contract_between(workers_.front());
    if (workers_.size() == 1)
      workers_.front().release(); // what comes next needs as much
    surface_.end_pass(order_.refresh);
  }

  using Threads = typename Policies::Threads;
  Threads threads() const {
    return surface_.pairs().has_others() ? Threads() : surface_.policies().threads;
  }

  // One more of the last bits of their numbers where half of the vertices are gone.
  void divide() {
    const std::size_t capacity = surface_.vertex_capacity();
    const std::size_t sparsity = std::bit_floor(capacity / surface_.status().vertices);
    const std::size_t size = std::min(block_size * sparsity, std::size_t{1} << 31);
    blocks_.clear();
    for (std::size_t begin = 0; begin < capacity; begin += size)
      blocks_.push_back(
          {static_cast<Index>(begin), static_cast<Index>(std::min(begin + size, capacity))});
    stars_.measure(surface_.complex(), std::countr_zero(size), threads());
  }

  // What the pairs of one vertex in 32 cost.
  void sample() {
    parallel_for(threads(), blocks_.size(), [&](std::size_t index, std::size_t worker) {
      Block& block = blocks_[index];
      block.sample.reserve(4 * block_size / sample_step); // as a rule there are fewer
      surface_.pairs().for_each_above(
          workers_[worker].scratch, block.begin, block.end, sample_step,
          [&](Index, Index, float cost) { block.sample.push_back(cost); });
    });
  }

  // The share of the pairs costs no more; less at the end, when there are few contractions to go.
  float cost_limit(std::size_t quota) const {
    std::size_t count = 0;
    for (const Block& block : blocks_)
      count += block.sample.size();
    std::vector<float> costs;
    costs.reserve(count);
    for (const Block& block : blocks_)
      costs.insert(costs.end(), block.sample.begin(), block.sample.end());
    const std::size_t rank =
        std::min(static_cast<std::size_t>(order_.share * static_cast<double>(costs.size())),
                 pairs_per_contraction * quota / sample_step);
    if (rank >= costs.size())
      return std::numeric_limits<float>::infinity();
    const auto nth = costs.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(costs.begin(), nth, costs.end());
    return *nth;
  }

  // To blocks, by the cheap pairs that the sample has found there; less than the quota in all.
  void share_out(std::size_t quota, float limit) {
    const auto cheap_ones = [limit](const Block& block) {
      const auto is_cheap = [limit](float cost) { return cost <= limit; };
      return static_cast<std::size_t>(
          std::count_if(block.sample.begin(), block.sample.end(), is_cheap));
    };
    std::size_t all = 1;
    for (const Block& block : blocks_)
      all += cheap_ones(block);
    for (Block& block : blocks_) {
      block.allowance = quota * cheap_ones(block) / all;
      block.sample = std::vector<float>(); // gives its memory back
    }
  }

  // The cheap pairs of a block, in the order of their costs.
  void propose(const Block& block, float limit, Worker& worker) {
    Room<Proposal>& proposals = worker.proposals;
    proposals.clear();
    proposals.extend(2 * block_size); // as a rule there are fewer
    surface_.pairs().for_each_above(worker.scratch, block.begin, block.end, 1,
                                    [&](Index v, Index w, float cost) {
                                      proposals.add_if(cost <= limit, {cost, v, w});
                                    });
    sort(worker);
  }

  // By the top 16 bits of the costs; those that have them in common keep their order.
  static void sort(Worker& worker) {
    for (int shift : {16, 24}) {
      const Room<Proposal>& from = worker.proposals;
      worker.others.clear();
      sort_by_digit<8>(from.data(), from.size(), worker.others.extend(from.size()),
                       [shift](const Proposal& p) {
                         return (std::bit_cast<std::uint32_t>(p.cost) >> shift) & 255;
                       });
      worker.others.add(from.size());
      std::swap(worker.proposals, worker.others);
    }
  }

  // The proposals whose stars lie inside of the block, as many as it may; the others are left for
  // larger blocks, or the end of the pass.
  void contract_inside(Block& block, Worker& worker) {
    const Room<Proposal>& proposals = worker.proposals;
    worker.others.clear();
    for (std::size_t i = 0; i < proposals.size(); ++i) {
      const auto [cost, v, w] = proposals[i];
      const bool is_own = w < block.end; // else another thread may write to it
      if (is_over(v) || (is_own && is_over(w)))
        continue;
      if (is_own && stars_.are_inside(v, w) && block.allowance > 0) {
        gather(worker.scratch, proposals[i]);
        if (allowance_.most_used(worker.scratch.star) <= block.allowance) {
          const Tally& tally = worker.scratch.tally;
          const std::size_t faces = tally.faces, vertices = tally.vertices;
          contract(worker.scratch, proposals[i]);
          block.allowance -= allowance_.used(tally.faces - faces, tally.vertices - vertices);
          continue;
        }
      }
      worker.others.add_if(true, proposals[i]);
    }
    block.rest.assign(worker.others.begin(), worker.others.end());
  }

  // What crosses the bounds of blocks lies inside of larger ones, for the most part.
  void join_blocks() {
    std::vector<Block> joined;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      Block& part = blocks_[i];
      if (i % joined_blocks == 0)
        joined.push_back({part.begin, part.end});
      Block& block = joined.back();
      block.end = part.end;
      block.allowance += part.allowance;
      block.rest.insert(block.rest.end(), part.rest.begin(), part.rest.end());
      part.rest = std::vector<Proposal>();
    }
    blocks_ = std::move(joined);
    stars_.join();
  }

  // Appends it to the proposals of a worker.
  static void take_rest(Block& block, Worker& worker) {
    const std::vector<Proposal> rest = std::exchange(block.rest, {});
    std::copy(rest.begin(), rest.end(), worker.proposals.extend(rest.size()));
    worker.proposals.add(rest.size());
  }

  // Counts each at once, so that a target is met as exactly as in greedy order.
  void contract_between(Worker& worker) {
    worker.proposals.clear();
    for (Block& block : blocks_)
      take_rest(block, worker);
    sort(worker);
    const Room<Proposal>& proposals = worker.proposals;
    for (std::size_t i = 0; i < proposals.size() && !surface_.is_enough(); ++i) {
      if (is_over(proposals[i].first) || is_over(proposals[i].second))
        continue;
      gather(worker.scratch, proposals[i]);
      contract(worker.scratch, proposals[i]);
      surface_.count(worker.scratch.tally);
    }
  }

  // Has it been contracted in this pass, or lost its faces?
  bool is_over(Index v) const {
    return stars_.is_touched(v) ||
           (!surface_.is_topology_kept() && !surface_.complex().has_faces(v));
  }

  void gather(Scratch& scratch, const Proposal& proposal) {
    surface_.gather(scratch, proposal.first, proposal.second);
  }

  // Unless it is refused.
  void contract(Scratch& scratch, const Proposal& proposal) {
    const auto [cost, first, second] = proposal;
    Candidate candidate = surface_.evaluate(first, second);
    if (const auto cause = surface_.rejection(scratch, first, second, candidate)) {
      ++scratch.tally.rejections[static_cast<std::size_t>(*cause)];
      return;
    }
    if (is_stop(scratch, proposal, candidate) || surface_.overshoots(scratch, second) ||
        surface_.is_destructive(candidate) || cuts_off_touched(scratch.star, second))
      return; // the greedy loop decides
    // Other blocks look at the vertices whose stars reach into them.
    surface_.contract_in_pass(scratch, first, second, candidate,
                              [this](Index v) { return stars_.is_inside(v); });
    stars_.touch(first);
    stars_.touch(second);
  }

  bool cuts_off_touched(const PairStar& star, Index second) const {
    return !surface_.is_topology_kept() &&
           any_cut_off(star, second, [this](Index v) { return stars_.is_touched(v); });
  }

  bool is_stop(Scratch& scratch, const Proposal& proposal, Candidate& candidate) const {
    Status status = surface_.status();
    status.next_error = candidate.error;
    if constexpr (asks_for_distance<typename Policies::Stop>) {
      status.next_distance = 0;
      return surface_.policies().stop(status) ||
             surface_.is_too_far(scratch, proposal.first, proposal.second, candidate, status);
    } else {
      return surface_.policies().stop(status);
    }
  }

  PairContraction<Policies>& surface_;
  RelaxedOrder order_;
  Allowance allowance_;
  std::vector<Block> blocks_;
  BlockStars stars_;
  std::vector<Worker> workers_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_RELAXED_PASSES_H
