#ifndef QUADRILLE_INTERNAL_CORE_POLICY_TIE_BREAK_H
#define QUADRILLE_INTERNAL_CORE_POLICY_TIE_BREAK_H

#include <concepts>

namespace quadrille::internal {

/// A cost with a tie break, its own or inherited.
template <class Cost, class Pair, class Position>
concept HasTieBreak = requires(const Cost& cost, const Pair& pair, const Position& x) {
  { cost.tie_break(pair, x) } -> std::convertible_to<double>;
};

/// Is the call of a class that of the class Base which it is derived from? A member that is
/// inherited has the base in the type of its pointer.
template <class Cost, class Base, class Pair>
concept InheritsCall = requires {
  requires std::same_as<decltype(&Cost::template operator()<Pair>),
                        decltype(&Base::template operator()<Pair>)>;
};

/// Is the tie break of a class that of the class Base which it is derived from?
template <class Cost, class Base, class Pair>
concept InheritsTieBreak = requires {
  requires std::same_as<decltype(&Cost::template tie_break<Pair>),
                        decltype(&Base::template tie_break<Pair>)>;
};

/// May a cost's tie break be added to its values? It is on their scale in the class that says
/// `using TieBreak = ThisClass;`. It is unknown for a class that is derived from that one and has
/// values of its own but no tie break of its own.
template <class Cost, class Pair, class Position>
concept BreaksTies = HasTieBreak<Cost, Pair, Position> &&
    (!requires { typename Cost::TieBreak; } || InheritsCall<Cost, typename Cost::TieBreak, Pair> ||
     !InheritsTieBreak<Cost, typename Cost::TieBreak, Pair>);

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_TIE_BREAK_H
