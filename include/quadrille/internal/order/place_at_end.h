#ifndef QUADRILLE_INTERNAL_ORDER_PLACE_AT_END_H
#define QUADRILLE_INTERNAL_ORDER_PLACE_AT_END_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>

namespace quadrille::internal {

/// Moves a contraction to the cheaper end of the pair that refusal(contraction) does not refuse, if
/// there is any.
template <class Evaluator, class Contraction, class Refusal>
QUADRILLE_NOINLINE bool moves_to_end(const Evaluator& evaluator, Contraction& contraction,
                                     Refusal refusal) {
  const auto& geometry = evaluator.geometry();
  if (contraction.star().hub != none || geometry.is_fixed(contraction.first()) ||
      geometry.is_fixed(contraction.second()))
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
