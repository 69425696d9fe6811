#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PROPOSALS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PROPOSALS_H

#include <quadrille/internal/core/base/digit_sort.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/append_buffer.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A pair that a pass may contract.
struct Proposal {
  float cost;
  Index first, second;
};

/// The proposals that a thread is at, and those that it leaves for later.
class Proposals {
public:
  explicit Proposals(Arena* arena) : now_(arena), others_(arena) {}

  void clear() { now_.clear(); }
  void reserve(std::size_t count) { now_.extend(count); }
  /// Adds a proposal, if `stays`: without a branch.
  void add_if(bool stays, const Proposal& proposal) { now_.add_if(stays, proposal); }
  /// Adds all proposals of a list, whose memory is given back.
  void take(std::vector<Proposal>& list) {
    const std::vector<Proposal> taken = std::exchange(list, {});
    std::copy(taken.begin(), taken.end(), now_.extend(taken.size()));
    now_.add(taken.size());
  }

  std::size_t size() const { return now_.size(); }
  const Proposal& operator[](std::size_t i) const { return now_[i]; }

  /// By the top 16 bits of the costs; those that have them in common keep their order.
  void sort() {
    for (int shift : {16, 24}) {
      others_.clear();
      sort_by_digit<8>(now_.data(), now_.size(), others_.extend(now_.size()),
                       [shift](const Proposal& p) {
                         return (std::bit_cast<std::uint32_t>(p.cost) >> shift) & 255;
                       });
      others_.add(now_.size());
      std::swap(now_, others_);
    }
  }

  /// Calls is_left(proposal) for each, in order, and returns those for which it is true.
  template <class IsLeft>
  std::vector<Proposal> left_by(IsLeft is_left) {
    others_.clear();
    for (std::size_t i = 0; i < now_.size(); ++i)
      if (const Proposal& proposal = now_[i]; is_left(proposal))
        others_.add_if(true, proposal);
    return {others_.begin(), others_.end()};
  }

  /// Gives memory back.
  void release() {
    now_.release();
    others_.release();
  }

private:
  AppendBuffer<Proposal> now_;
  AppendBuffer<Proposal> others_; // half sorted, then those that are left
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PROPOSALS_H
