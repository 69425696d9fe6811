#ifndef QUADRILLE_INTERNAL_CONTRACTION_CONTRACTION_H
#define QUADRILLE_INTERNAL_CONTRACTION_CONTRACTION_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/cost/candidate.h>
#include <quadrille/internal/policy/policies.h>

#include <vector>

namespace quadrille::internal {

/// A contraction: a candidate with the star of its pair. It is made of both, checked, and applied
/// to the surface; checks may move the candidate to another place. The next one that is made with
/// the same scratch takes its star.
template <class Cost>
class Contraction {
public:
  using Candidate = internal::Candidate<Cost>;
  using Position = typename Candidate::Position;

  Contraction(Candidate& candidate, TriangleComplex& complex, Scratch& scratch)
      : candidate_(candidate), scratch_(scratch) {
    scratch.star.gather(complex, candidate.first, candidate.second);
  }

  Index first() const { return candidate_.first; }
  Index second() const { return candidate_.second; }
  const PairOf<Cost>& pair() const { return candidate_.pair; }
  const Position& target() const { return candidate_.target; }
  double cost() const { return candidate_.cost; }
  double error() const { return candidate_.error; }
  const PairStar& star() const { return scratch_.star; }
  /// Of the faces that change, in the order of the star: how far they will be from the input at
  /// most, once that has been measured.
  std::vector<float>& bounds() const { return scratch_.bounds; }

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

/// How a contraction is applied: among others that have no end in common with it, before lists are
/// built anew. may_write_to(v) tells which vertices around it no other thread looks at.
template <class MayWriteTo>
struct InPass {
  static constexpr bool is_in_pass = true;
  MayWriteTo may_write_to;
};
template <class MayWriteTo>
InPass(MayWriteTo) -> InPass<MayWriteTo>;

/// What observers of the surface are told before a contraction, and after it: which vertex is kept
/// and which is gone.
///
/// An observer is a part of the surface that has something to keep up to date. It has a function
/// before(event), or after(event), or both; what it has not costs nothing.
template <class Cost, class Mode>
struct ContractionEvent {
  static constexpr bool is_in_pass = Mode::is_in_pass;

  const Contraction<Cost>& contraction;
  const Mode& mode;
  Index kept, gone;
};

template <class Observer, class Event>
QUADRILLE_ALWAYS_INLINE inline void tell_before(Observer& observer, const Event& event) {
  if constexpr (requires { observer.before(event); })
    observer.before(event);
}
template <class Observer, class Event>
QUADRILLE_ALWAYS_INLINE inline void tell_after(Observer& observer, const Event& event) {
  if constexpr (requires { observer.after(event); })
    observer.after(event);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_CONTRACTION_H
