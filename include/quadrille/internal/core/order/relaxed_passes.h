#ifndef QUADRILLE_INTERNAL_CORE_ORDER_RELAXED_PASSES_H
#define QUADRILLE_INTERNAL_CORE_ORDER_RELAXED_PASSES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/contraction/contraction_count.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/attempt.h>
#include <quadrille/internal/core/order/block_stars.h>
#include <quadrille/internal/core/order/cost_stop.h>
#include <quadrille/internal/core/order/proposals.h>
#include <quadrille/internal/core/order/vanishing_components.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The plan of a pass over the blocks of a surface: it contracts pairs that cost no more than a
/// limit, and in each block no more of them than its quota. It is made from a sample of the costs
/// of each block's pairs.
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

/// Does the stop policy stop at a contraction in a pass, while other contractions may still be
/// done?
template <class Policies>
bool is_stop_in_pass(const WorkingSurface<Policies>& surface,
                     typename WorkingSurface<Policies>::Contraction& contraction) {
  Status status = surface.status();
  status.next_error = contraction.error();
  const auto& stop = surface.policies().stop;
  if (stop.needs().cost)
    status.next_cost = surface.evaluator().cost_of_mesh(contraction.key());
  if (!stop.needs().distance)
    return stop(status);
  status.next_distance = 0;
  if (stop.needs().reverse_distance)
    status.next_reverse_distance = 0;
  if (stop.needs().tolerance)
    status.next_tolerance = 0;
  return stop(status) || surface.distances()->is_too_far(contraction, status);
}

/// Contracts pairs in passes, as RelaxedOrder says.
template <class Policies>
class RelaxedPasses {
public:
  RelaxedPasses(WorkingSurface<Policies>& surface, const PassSettings& settings)
      : surface_(surface), settings_(settings),
        count_(surface.state().is_topology_kept, surface.complex().reverse_faces()),
        cost_stop_(surface), stars_(surface.complex().arena()) {
    Arena* const arena = surface.complex().arena(); // for one thread
    for (Scratch& scratch : surface.state().scratches)
      workers_.push_back(
          {scratch, Proposals(surface.state().scratches.size() == 1 ? arena : nullptr)});
  }

  /// Passes as long as they pay. False if the visitor said so.
  bool run() {
    for (;;) {
      const Status before = surface_.status();
      const std::size_t least = (std::max)(least_contractions, before.vertices / least_fraction);
      const std::size_t quota = count_.contractions(surface_.policies().stop, before);
      if (quota < least)
        return true;
      const std::size_t left = pass(quota);
      if (!surface_.progress().proceed())
        return false;
      const std::size_t contractions = surface_.status().contractions - before.contractions;
      if (contractions < least || (Policies::has_channels && contractions < left))
        return true;
    }
  }

private:
  using Cost = typename Policies::Cost;
  using Contraction = internal::Contraction<Cost>;

  struct Block {
    Index begin, end;      // vertices
    std::size_t quota = 0; // contractions
    std::vector<Proposal> rest = {};
  };

  // Each thread has one.
  struct Worker {
    Scratch& scratch;
    Proposals proposals;
  };

  // A pass of fewer contractions, or of a smaller fraction of the vertices, is not worthwhile.
  static constexpr std::size_t least_contractions = 64, least_fraction = 32;
  static constexpr std::size_t block_size = 4096; // vertices: what they need fits into a cache
  static constexpr std::size_t joined_blocks = BlockStars::joined_blocks;
  static constexpr std::size_t no_quota = ~std::size_t{0}; // of contractions
  // From which part of the way to the farthest neighbour on an error is left to the greedy order.
  // That of attributes is a distance too, and as large where they are noisy.
  static constexpr double coarse_fraction = Policies::has_channels ? 0.3 : 0.1;

  // The data of a block is loaded once: it is contracted right after its costs are known.
  std::size_t pass(std::size_t quota) {
    divide();
    const PassPlan plan = PassPlan::make(samples(), settings_.share, quota, cost_stop_.limit());
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      blocks_[i].quota = plan.quotas[i];
    for_each_block([&](Block& block, Worker& worker) {
      propose(block, plan.cost_limit, worker);
      contract_inside(block, worker);
    });
    while (blocks_.size() >= 2 * joined_blocks) {
      join_blocks();
      for_each_block([&](Block& block, Worker& worker) {
        worker.proposals.clear();
        worker.proposals.take(block.rest);
        worker.proposals.sort();
        contract_inside(block, worker);
      });
    }
    std::size_t left = 0;
    for (Worker& worker : workers_) {
      left += worker.scratch.counters.left;
      surface_.progress().count(worker.scratch.counters);
    }
    contract_between(workers_.front());
    if (workers_.size() == 1)
      workers_.front().proposals.release(); // what comes next needs as much
    surface_.end_pass(settings_.refresh);
    let_components_vanish(static_cast<double>(plan.cost_limit));
    return left;
  }

  // Lets components vanish that cost less than the pairs of the pass.
  void let_components_vanish(double limit) {
    if (limit == std::numeric_limits<double>::infinity())
      return; // the pairs that cost most are for the greedy order
    VanishingComponents<Policies> components(surface_);
    while (components.has_below(limit, false) &&
           components.vanish_next([](Index) {}, [] { return false; })) {
    }
    cost_stop_.announce_none();
  }

  template <class Task>
  void for_each_block(Task task) {
    parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
      surface_.run().begin_block(block, workers_[worker].scratch);
      task(blocks_[block], workers_[worker]);
    });
    surface_.run().end_stage();
  }
  Threads threads() const {
    return surface_.pairs().has_others() ? Threads() : surface_.policies().threads;
  }

  // One more of the last bits of their numbers where half of the vertices are gone.
  void divide() {
    const std::size_t capacity = surface_.complex().vertex_capacity();
    const std::size_t sparsity = std::bit_floor(capacity / surface_.status().vertices);
    const std::size_t size = (std::min)(block_size * sparsity, std::size_t{1} << 31);
    blocks_.clear();
    for (std::size_t begin = 0; begin < capacity; begin += size)
      blocks_.push_back(
          {static_cast<Index>(begin), static_cast<Index>((std::min)(begin + size, capacity))});
    stars_.measure(surface_.complex(), std::countr_zero(size), threads());
  }

  // Returns the costs of some of the pairs of each block.
  std::vector<std::vector<float>> samples() {
    std::vector<std::vector<float>> samples(blocks_.size());
    parallel_for(threads(), blocks_.size(), [&](std::size_t block, std::size_t worker) {
      std::vector<float>& sample = samples[block];
      sample.reserve(4 * block_size / PassPlan::sample_step); // as a rule there are fewer
      surface_.pairs().for_each_above(workers_[worker].scratch, blocks_[block].begin,
                                      blocks_[block].end, PassPlan::sample_step,
                                      [&](Index, Index, float cost) { sample.push_back(cost); });
    });
    return samples;
  }

  // The cheap pairs of a block, in the order of their costs.
  void propose(const Block& block, float limit, Worker& worker) {
    Proposals& proposals = worker.proposals;
    proposals.clear();
    proposals.reserve(2 * block_size); // as a rule there are fewer
    surface_.pairs().for_each_above(
        worker.scratch, block.begin, block.end, 1,
        [&](Index v, Index w, float cost) {
          proposals.add_if(cost <= limit, {cost, v, w});
        },
        limit);
    proposals.sort();
  }

  // The proposals whose stars lie inside of the block, as many as it may; the others are left for
  // larger blocks, or the end of the pass.
  void contract_inside(Block& block, Worker& worker) {
    block.rest = worker.proposals.left_by([&](const Proposal& proposal) {
      const auto [cost, v, w] = proposal;
      const bool is_own = w < block.end; // else another thread may write to it
      if (is_over(v) || (is_own && is_over(w)))
        return false;
      return !is_own || !stars_.are_inside(v, w) || !contract_within(block.quota, proposal, worker);
    });
  }

  // Contracts a pair unless it is rejected. False if the quota is too small for it.
  bool contract_within(std::size_t& quota, const Proposal& proposal, Worker& worker) {
    if (quota == 0)
      return false;
    const Counters& counters = worker.scratch.counters;
    const std::size_t faces = counters.faces, vertices = counters.vertices, edges = counters.edges;
    if (!contract(proposal, quota, worker.scratch))
      return false;
    const std::size_t used =
        count_.used(counters.faces - faces, counters.vertices - vertices, counters.edges - edges);
    quota -= (std::min)(quota, used); // edges of no face that goes may be more
    return true;
  }

  // Pairs that cross the bounds of blocks are inside larger blocks, for the most part.
  void join_blocks() {
    std::vector<Block> joined;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      Block& member = blocks_[i];
      if (i % joined_blocks == 0)
        joined.push_back({member.begin, member.end});
      Block& block = joined.back();
      block.end = member.end;
      block.quota += member.quota;
      block.rest.insert(block.rest.end(), member.rest.begin(), member.rest.end());
      member.rest = std::vector<Proposal>();
    }
    blocks_ = std::move(joined);
    stars_.join();
  }

  // Counts each at once, so that a target is met as exactly as in greedy order.
  void contract_between(Worker& worker) {
    Proposals& proposals = worker.proposals;
    proposals.clear();
    for (Block& block : blocks_)
      proposals.take(block.rest);
    proposals.sort();
    surface_.run().begin_block(0, worker.scratch);
    for (std::size_t i = 0; i < proposals.size() && !surface_.progress().is_enough(); ++i) {
      if (is_over(proposals[i].first) || is_over(proposals[i].second))
        continue;
      contract(proposals[i], no_quota, worker.scratch);
      surface_.progress().count(worker.scratch.counters);
    }
    surface_.run().end_stage();
  }

  // Has it been contracted in this pass, or lost its faces?
  bool is_over(Index v) const {
    return stars_.is_touched(v) ||
           (!surface_.state().is_topology_kept && !surface_.complex().has_faces(v));
  }

  // Decides attempts in passes: pairs that the greedy order must look at are left to it.
  class PassJudge : public Judge<Policies> {
  public:
    using typename Judge<Policies>::Contraction;

    PassJudge(RelaxedPasses& passes, std::size_t quota)
        : Judge<Policies>(passes.surface_), passes_(passes), quota_(quota) {}

    QUADRILLE_ALWAYS_INLINE bool is_too_large(const PairStar& star) {
      return quota_ < no_quota && passes_.count_.may_take_more(star, quota_);
    }
    QUADRILLE_ALWAYS_INLINE Attempt verdict(Contraction& contraction) {
      return passes_.is_left_to_greedy_order(contraction) ? Attempt::deferred(contraction.key())
                                                          : Attempt();
    }

  private:
    RelaxedPasses& passes_;
    std::size_t quota_;
  };

  // Contracts a pair unless something speaks against it. False if the quota is too small for it.
  bool contract(const Proposal& proposal, std::size_t quota, Scratch& scratch) {
    const std::array ends{proposal.first, proposal.second};
    PassJudge judge(*this, quota);
    const Attempt attempt =
        internal::attempt(surface_, ends[0], ends[1], scratch, judge,
                          [&](const Contraction& c) QUADRILLE_ALWAYS_INLINE_LAMBDA {
                            // Other blocks read the vertices whose stars extend into them.
                            const auto is_inside = [this](Index v) { return stars_.is_inside(v); };
                            surface_.apply(c, InPass{is_inside});
                            stars_.touch(ends[0]);
                            stars_.touch(ends[1]);
                          });
    if (attempt.outcome == Outcome::rejected)
      surface_.run().reject_in_pass(ends, attempt.cause, attempt.error, scratch);
    else if (attempt.outcome == Outcome::deferred)
      ++scratch.counters.left;
    return attempt.outcome != Outcome::put_back;
  }

  bool is_left_to_greedy_order(Contraction& contraction) {
    TargetRules<Policies>& rules = surface_.run().target_rules();
    return is_stop_in_pass(surface_, contraction) ||
           rules.overshoots(contraction, surface_.status()) ||
           rules.is_coarse(contraction, coarse_fraction) ||
           surface_.shape_check().spoils_component(contraction) || cuts_off_touched(contraction);
  }

  bool cuts_off_touched(const Contraction& contraction) const {
    return !surface_.state().is_topology_kept &&
           any_cut_off(contraction.star(), contraction.second(),
                       [this](Index v) { return stars_.is_touched(v); });
  }

  WorkingSurface<Policies>& surface_;
  const PassSettings settings_;
  ContractionCount count_;
  CostStop<Policies> cost_stop_;
  std::vector<Block> blocks_;
  BlockStars stars_;
  std::vector<Worker> workers_;
};

/// For OptionalModules.
template <class Policies>
bool run_passes(WorkingSurface<Policies>& surface, const PassSettings& settings) {
  return RelaxedPasses<Policies>(surface, settings).run();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_RELAXED_PASSES_H
