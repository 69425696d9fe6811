#ifndef QUADRILLE_INTERNAL_ORDER_PLACE_AT_END_H
#define QUADRILLE_INTERNAL_ORDER_PLACE_AT_END_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>

namespace quadrille::internal {

/// Are both ends of a pair free to come to the other?
template <class Evaluator, class Contraction>
bool may_move_to_end(const Evaluator& evaluator, const Contraction& contraction) {
  const auto& geometry = evaluator.geometry();
  return contraction.star().hub == none && !geometry.is_fixed(contraction.first()) &&
         !geometry.is_fixed(contraction.second());
}

/// Moves a contraction to the cheaper end of the pair that refusal(contraction) does not refuse, if
/// there is any.
template <class Evaluator, class Contraction, class Refusal>
QUADRILLE_NOINLINE bool moves_to_end(const Evaluator& evaluator, Contraction& contraction,
                                     Refusal refusal) {
  if (!may_move_to_end(evaluator, contraction))
    return false;
  const typename Contraction::Candidate wanted = contraction.candidate();
  for (const auto& end : evaluator.at_ends(wanted)) {
    contraction.replace(end);
    if (!refusal(contraction))
      return true;
  }
  contraction.replace(wanted);
  return false;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_PLACE_AT_END_H
