#ifndef QUADRILLE_EXAMPLES_CARRYING_COST_H
#define QUADRILLE_EXAMPLES_CARRYING_COST_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace quadrille_examples {

/// A cost that looks at positions only, for vertices that have N attributes beside: they take no
/// part in the cost, and are carried along. Where a contracted vertex gets the position of least
/// cost, its attributes are those of the edge there: they lie between those of the two ends as the
/// position, projected to the edge, does. An end that a vertex is put on has its own, bit for bit.
///
/// The attributes come from `quadrille::parameters::vertex_attribute_map`.
template <class Cost, std::size_t N>
struct CarryingCost : Cost {
  static constexpr std::size_t dimension = 3 + N;
  using Position = quadrille::Vector<dimension>;
  using SpaceState = typename Cost::State;
  using ScaleFree = CarryingCost; ///< for a cost that is

  explicit CarryingCost(const Cost& cost) : Cost(cost) {}

  /// What the cost remembers, for the engine that moves it in all dimensions.
  struct State {
    SpaceState in_space{};

    State& operator+=(const State& other) {
      in_space += other.in_space;
      return *this;
    }
    void move_origin(const Position& d) requires requires(SpaceState m, quadrille::Vector<3> v) {
      m.move_origin(v);
    }
    { in_space.move_origin(space(d)); }
    static State sum_about_first(const State& first, const State& second,
                                 const Position& d) requires
        requires(SpaceState m, quadrille::Vector<3> v) {
      SpaceState::sum_about_first(m, m, v);
    }
    { return {SpaceState::sum_about_first(first.in_space, second.in_space, space(d))}; }
  };

  /// A pair as the cost sees it.
  template <class Pair>
  struct InSpace {
    explicit InSpace(const Pair& pair)
        : first(space(pair.first)), second(space(pair.second)), state(pair.state.in_space),
          squared_reach(pair.squared_reach), current(pair.current) {}

    quadrille::Vector<3> first, second;
    const SpaceState& state;
    double squared_reach;
    const decltype(Pair::current)& current;
  };

  State face(const Position& p, const Position& q, const Position& r) const {
    return {Cost::face(space(p), space(q), space(r))};
  }
  State boundary(const Position& p, const Position& q, const Position& r) const requires
      requires(const Cost c, quadrille::Vector<3> v) {
    c.boundary(v, v, v);
  }
  { return {Cost::boundary(space(p), space(q), space(r))}; }
  State crease(const Position& p, const Position& q, const Position& r) const requires
      requires(const Cost c, quadrille::Vector<3> v) {
    c.crease(v, v, v);
  }
  { return {Cost::crease(space(p), space(q), space(r))}; }

  auto current_face(const Position& p, const Position& q, const Position& r) const requires
      requires(const Cost c, quadrille::Vector<3> v) {
    c.current_face(v, v, v);
  }
  { return Cost::current_face(space(p), space(q), space(r)); }
  auto current_boundary(const Position& p, const Position& q, const Position& r) const requires
      requires(const Cost c, quadrille::Vector<3> v) {
    c.current_boundary(v, v, v);
  }
  { return Cost::current_boundary(space(p), space(q), space(r)); }
  auto join(const auto& first, const auto& second, const auto& shared,
            const Position& to_second) const requires
      requires(const Cost c, quadrille::Vector<3> v) {
    c.join(first, second, shared, v);
  }
  { return Cost::join(first, second, shared, space(to_second)); }

  template <class Pair>
  double operator()(const Pair& pair, const Position& x) const {
    return Cost::operator()(InSpace<Pair>(pair), space(x));
  }

  template <class Pair>
  std::optional<Position> minimizer(const Pair& pair) const requires
      requires(const Cost c, const InSpace<Pair> p) {
    c.minimizer(p);
  }
  {
    const std::optional<quadrille::Vector<3>> x = Cost::minimizer(InSpace<Pair>(pair));
    if (!x)
      return std::nullopt;
    return with_attributes(*x, pair.first, pair.second);
  }

  template <class Pair>
  double tie_break(const Pair& pair, const Position& x) const requires
      requires(const Cost c, const InSpace<Pair> p, quadrille::Vector<3> v) {
    c.tie_break(p, v);
  }
  { return Cost::tie_break(InSpace<Pair>(pair), space(x)); }

  template <class Pair>
  double squared_error(const Pair& pair, double cost) const requires
      requires(const Cost c, const InSpace<Pair> p) {
    c.squared_error(p, cost);
  }
  { return Cost::squared_error(InSpace<Pair>(pair), cost); }

private:
  static Position with_attributes(const quadrille::Vector<3>& x, const Position& first,
                                  const Position& second) {
    const quadrille::Vector<3> edge = space(second) - space(first);
    const double length = squared_length(edge);
    const double way = length > 0 ? dot(x - space(first), edge) / length : 0;
    Position result = way < 0.5 ? first : second;
    if (way > 0 && way < 1)
      for (std::size_t i = 3; i < dimension; ++i)
        result[i] = (1 - way) * first[i] + way * second[i];
    std::copy(x.coordinates.begin(), x.coordinates.end(), result.coordinates.begin());
    return result;
  }
};

} // namespace quadrille_examples

#endif
