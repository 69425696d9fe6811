#ifndef QUADRILLE_INTERNAL_ORDER_WAITING_PAIRS_H
#define QUADRILLE_INTERNAL_ORDER_WAITING_PAIRS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/order/pair_queue.h>
#include <quadrille/internal/order/refused_pairs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Refused pairs, until something changes beside them, or what was in their way does.
///
/// Looking at a pair takes time in proportion to the faces at its ends, but for those of hubs. So
/// that no vertex takes more time at each change than one of few faces, a change beside it brings
/// back only as many of its pairs as `most_pairs` says, and all of them when no others are left, as
/// long as that pays.
class WaitingPairs {
public:
  static constexpr std::size_t few_faces = 64; // at a vertex
  static constexpr std::size_t all = ~std::size_t{0};

  explicit WaitingPairs(const TriangleComplex& complex)
      : complex_(complex), refused_(complex.vertex_capacity(), complex.workspace()) {}

  /// `is_held`: see held(). `face`: what was in its way.
  void add(const QueuedPair& pair, bool is_held = false, Index face = none) {
    refused_.add(pair, is_held, face);
  }
  /// How many wait that were refused for what holds the surface.
  std::size_t held() const { return refused_.held(); }
  /// Some pairs of a vertex of many faces have been added, and others are in the queue.
  void note_left_behind(Index v) { left_behind_.push_back(v); }
  bool empty() const { return refused_.size() == 0; }

  /// That many pairs of a vertex look at few² faces together; all of them where there are few.
  std::size_t most_pairs(Index v) const {
    const std::size_t faces = complex_.degree_bound(v);
    return faces <= few_faces ? all : (std::max<std::size_t>)(1, few_faces * few_faces / faces);
  }

  /// All pairs of a vertex are outdated.
  void forget(Index v) { refused_.forget(v); }

  /// The surroundings of a vertex have changed, so the answer of a filter may. Calls push(pair) for
  /// pairs that are to be looked at once more.
  template <class Push>
  void release(Index v, Push push) {
    if (refused_.has(v))
      release_some(v, push);
  }

  /// Do pairs wait for faces?
  bool has_behind() const { return refused_.has_behind(); }
  /// A face has changed, or is gone, so it may be in the way no more. Calls push(pair) as
  /// release().
  template <class Push>
  void release_behind(Index face, Push push) {
    refused_.release_behind(face, push);
  }

  /// Calls push(pair) for all of them.
  template <class Push>
  void release_all(Push push) {
    left_behind_.clear();
    for (Index v = 0; v < complex_.vertex_capacity(); ++v)
      refused_.release(v, all, push);
  }

  /// Those that were left behind, at a time. False if there are none, or if those of the last time
  /// brought too few contractions: time counts these.
  template <class Push>
  bool release_rest(std::uint32_t time, Push push) {
    if (time < time_to_release_)
      return false;
    std::size_t released = 0;
    for (Index v : std::exchange(left_behind_, {}))
      refused_.release(v, all, [&](const QueuedPair& pair) {
        ++released;
        push(pair);
      });
    time_to_release_ = time + static_cast<std::uint32_t>(released / few_faces);
    return released > 0;
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const { refused_.prefetch(v); }

private:
  template <class Push>
  QUADRILLE_NOINLINE void release_some(Index v, Push push) { // seldom
    if (!refused_.release(v, most_pairs(v), push))
      left_behind_.push_back(v);
  }

  const TriangleComplex& complex_;
  RefusedPairs refused_;
  std::vector<Index> left_behind_; // vertices of some of them
  std::uint32_t time_to_release_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_WAITING_PAIRS_H
