#ifndef QUADRILLE_TEST_ARCHETYPES_H
#define QUADRILLE_TEST_ARCHETYPES_H

#include <quadrille/guard.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <cstddef>

/// \file
/// An archetype of each concept: the least type that models it. It cannot be assigned, converted or
/// compared, has no member that the concept does not name, and what it gives back can do nothing
/// but be converted. That `simplify` compiles with it proves that the concept asks for enough.

namespace test {

/// Can be made and copied, and nothing else.
struct Minimal {
  Minimal() = default;
  Minimal(const Minimal&) = default;
  Minimal& operator=(const Minimal&) = delete;
  void operator&() const = delete;
};

/// Can be converted to T and nothing else.
template <class T>
class ConvertibleTo {
public:
  explicit ConvertibleTo(const T& value) : value_(value) {}
  ConvertibleTo(const ConvertibleTo&) = delete;
  operator T() const { return value_; }

private:
  T value_;
};

/// Costs the distance that the two ends have to go, in 3 + `attributes` dimensions.
template <std::size_t attributes = 0>
struct CostArchetype : Minimal {
  static constexpr std::size_t dimension = 3 + attributes;

  struct State {
    void operator+=(const State&) {}
  };
  using Position = quadrille::Vector<dimension>;

  ConvertibleTo<State> face(const Position&, const Position&, const Position&) const {
    return ConvertibleTo<State>({});
  }

  template <class Pair>
  ConvertibleTo<double> operator()(const Pair& pair, const Position& x) const {
    const State& state = pair.state;
    static_cast<void>(state);
    return ConvertibleTo<double>(squared_distance(pair.first, x) +
                                 squared_distance(pair.second, x));
  }
};

/// Goes to the first end.
struct PlacementArchetype : Minimal {
  template <class Cost, class Pair>
  ConvertibleTo<quadrille::Vector<Cost::dimension>> operator()(const Cost&,
                                                               const Pair& pair) const {
    return ConvertibleTo<quadrille::Vector<Cost::dimension>>(pair.first);
  }
};

/// Pairs each vertex with the next one.
struct PairArchetype : Minimal {
  void operator()(const quadrille::SurfaceView& surface, const quadrille::EmitPair& emit) const {
    for (std::size_t i = 1; i < surface.points.size(); ++i)
      emit(i - 1, i);
  }
};

/// Stops at 8 faces.
struct StopArchetype : Minimal {
  ConvertibleTo<bool> operator()(const quadrille::Status& status) const {
    return ConvertibleTo<bool>(status.faces <= 8);
  }
};

/// Allows everything.
struct FilterArchetype : Minimal {
  template <class Contraction>
  ConvertibleTo<bool> allows(const Contraction&) const {
    return ConvertibleTo<bool>(true);
  }
};

/// Allows everything, and follows nothing.
struct GuardArchetype : Minimal {
  struct State {
    State() = default;
    State(State&&) = default;
    State& operator=(State&&) = default;

    template <class Contraction>
    ConvertibleTo<bool> allows(const Contraction&) {
      return ConvertibleTo<bool>(true);
    }
    template <class Contraction>
    void follow(const Contraction&) {}
  };
  State begin(const quadrille::GuardedSurface&) const { return {}; }
};

} // namespace test

#endif // QUADRILLE_TEST_ARCHETYPES_H
