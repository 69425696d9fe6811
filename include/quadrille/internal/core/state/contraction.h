#ifndef QUADRILLE_INTERNAL_CORE_STATE_CONTRACTION_H
#define QUADRILLE_INTERNAL_CORE_STATE_CONTRACTION_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/surface/geometry.h>

#include <tuple>
#include <utility>

namespace quadrille::internal {

/// The star of a pair, in the memory of a scratch: the next one that is gathered takes its place.
class GatheredStar {
public:
  GatheredStar(TriangleComplex& complex, Index first, Index second, Scratch& scratch)
      : scratch_(scratch) {
    if (const Index high_valence = complex.high_valence_vertices().of_pair(first, second);
        high_valence != none)
      scratch.star.gather_at_high_valence(complex, first, second, high_valence);
    else
      scratch.star.gather(complex, first, second);
  }

  const PairStar& operator*() const { return scratch_.star; }
  Scratch& scratch() const { return scratch_; }

private:
  Scratch& scratch_;
};

/// A contraction: a candidate with the star of its pair. It is made of both, checked, and applied
/// to the surface; checks may move the candidate to another place.
template <class Cost>
class Contraction {
public:
  using Candidate = internal::Candidate<Cost>;
  using Position = typename Candidate::Position;

  Contraction(Candidate& candidate, const GatheredStar& star)
      : candidate_(candidate), scratch_(star.scratch()) {}

  Index first() const { return candidate_.first; }
  Index second() const { return candidate_.second; }
  const PairOf<Cost>& pair() const { return candidate_.pair; }
  const Position& target() const { return candidate_.target; }
  double cost() const { return candidate_.cost; }
  double key() const { return candidate_.key; }
  double error() const { return candidate_.error; }
  const PairStar& star() const { return scratch_.star; }

  const Candidate& candidate() const { return candidate_; }
  /// To a place that costs the same.
  void move_to(const Position& target) { candidate_.target = target; }
  void replace(const Candidate& candidate) { candidate_ = candidate; }

  Scratch& scratch() const { return scratch_; }

private:
  Candidate& candidate_;
  Scratch& scratch_;
};

/// How a contraction is applied: by itself, so that the lists of the complex are up to date after
/// it.
struct AtOnce {
  static constexpr bool is_in_pass = false;
  static constexpr bool may_write_to(Index) { return true; }
};

/// The mode in which a contraction is applied: among others that have no end in common with it,
/// before lists are rebuilt. may_write_to(v) is true for vertices around it that no other thread
/// reads.
template <class MayWriteTo>
struct InPass {
  static constexpr bool is_in_pass = true;
  MayWriteTo may_write_to;
};
template <class MayWriteTo>
InPass(MayWriteTo) -> InPass<MayWriteTo>;

/// Which end of a pair is kept, and which is gone: a high-valence vertex is kept, or one that keeps
/// its place, else the first.
template <class Cost>
std::pair<Index, Index> kept_and_gone(const Contraction<Cost>& contraction,
                                      const Geometry<Cost::dimension>& geometry) {
  const Index a = contraction.first(), b = contraction.second();
  const auto& pair = contraction.pair();
  const auto& target = contraction.target();
  if (const Index high_valence = contraction.star().high_valence; high_valence != none)
    return {high_valence, high_valence == a ? b : a};
  const bool b_stays = !geometry.is_fixed(a) &&
                       (geometry.is_fixed(b) || (target == pair.second && target != pair.first));
  return b_stays ? std::pair(b, a) : std::pair(a, b);
}

/// The feature loss of a contraction: see feature_loss_of.
struct FeatureLoss {
  double displacement; ///< in the engine's unit; 0 where the surface is not thin
  double error; ///< the error of the contraction, with that, in the mesh's unit: see Report::error
};

/// The event that observers of the surface receive before a contraction and after it: it names the
/// vertex that is kept and the one that is gone.
///
/// An observer is a component of the surface that must be kept up to date. It has a function
/// before(event), or after(event), or both; an absent function costs nothing. In a pass several
/// threads notify an observer at a time, each of another contraction: it may write only to the data
/// of the two ends, of the faces of the star, and of vertices that the mode allows.
template <class Cost, class Mode>
struct ContractionEvent {
  static constexpr bool is_in_pass = Mode::is_in_pass;

  const Contraction<Cost>& contraction;
  const Mode& mode;
  Index kept, gone;
  FeatureLoss feature_loss;
};

template <class Observer, class Event>
concept ReceivesBefore = requires(Observer& observer, const Event& event) {
  observer.before(event);
};
template <class Observer, class Event>
concept ReceivesAfter = requires(Observer& observer, const Event& event) {
  observer.after(event);
};

template <class Observer, class Event>
QUADRILLE_ALWAYS_INLINE inline void notify_before(Observer& observer, const Event& event) {
  static_assert(
      ReceivesBefore<Observer, Event> || ReceivesAfter<Observer, Event>,
      "quadrille: an observer of contractions needs a member before(event) or after(event)");
  if constexpr (ReceivesBefore<Observer, Event>)
    observer.before(event);
}
template <class Observer, class Event>
QUADRILLE_ALWAYS_INLINE inline void notify_after(Observer& observer, const Event& event) {
  if constexpr (ReceivesAfter<Observer, Event>)
    observer.after(event);
}

template <class Event, class... Observer>
QUADRILLE_ALWAYS_INLINE inline void notify_all_before(const std::tuple<Observer&...>& observers,
                                                      const Event& event) {
  std::apply([&](auto&... observer)
                 QUADRILLE_ALWAYS_INLINE_LAMBDA { (notify_before(observer, event), ...); },
             observers);
}
template <class Event, class... Observer>
QUADRILLE_ALWAYS_INLINE inline void notify_all_after(const std::tuple<Observer&...>& observers,
                                                     const Event& event) {
  std::apply([&](auto&... observer)
                 QUADRILLE_ALWAYS_INLINE_LAMBDA { (notify_after(observer, event), ...); },
             observers);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_CONTRACTION_H
