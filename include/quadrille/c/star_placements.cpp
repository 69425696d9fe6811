#include <quadrille/compiled/soup_job.h>

#include <quadrille/compiled/run_soup.h>
#include <quadrille/hull.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/order.h>
#include <quadrille/placement.h>

namespace quadrille::internal {

namespace {

/// OuterHull or InnerHull, known at run time: one engine is compiled for both.
class EitherHull {
public:
  using ScaleFree = EitherHull;
  using Estimate = OuterHull::Estimate;
  static constexpr bool looks_at_star = true;
  static constexpr bool asks_for_volume = true;
  static constexpr bool needs_closed_surface = true;
  static constexpr Rejection cause = OuterHull::cause;
  static constexpr double rise_of_estimate = OuterHull::rise_of_estimate;

  explicit EitherHull(bool is_outer) : is_outer_(is_outer) {}

  auto operator()(const auto& cost, const auto& pair) const { return Estimate{}(cost, pair); }
  auto resolve(const auto& cost, const auto& pair, const auto& star) const {
    return by([&](const auto& hull) { return hull.resolve(cost, pair, star); });
  }
  bool admits(const auto& pair, const auto& star, const Vector<3>& x) const {
    return by([&](const auto& hull) { return hull.admits(pair, star, x); });
  }
  bool any_further(const auto& cost, const auto& pair, const auto& star,
                   const auto& predicate) const {
    return by([&](const auto& hull) { return hull.any_further(cost, pair, star, predicate); });
  }
  static bool any_equal(const auto& cost, const auto& pair, const auto& x, const auto& predicate) {
    return OuterHull::any_equal(cost, pair, x, predicate);
  }

private:
  auto by(const auto& call) const { return is_outer_ ? call(OuterHull{}) : call(InnerHull{}); }

  bool is_outer_;
};

template <class Placement>
SoupResult soup_placed_by(const Placement& placement, const SoupView& soup,
                          const SoupOptions& options) {
  return run_soup(soup, options, [&](SoupRun& run) {
    return simplify_with_all(run, with_weights(MemorylessQuadric{}, options), placement,
                             GreedyOrder{});
  });
}

} // namespace

SoupResult hull_of_soup(const SoupView& soup, const SoupOptions& options, bool is_outer) {
  SoupOptions apart = options; // what turns over does not lie inside
  apart.no_self_intersection |= !is_outer;
  return soup_placed_by(EitherHull(is_outer), soup, apart);
}

SoupResult soup_of_same_volume(const SoupView& soup, const SoupOptions& options) {
  return soup_placed_by(VolumeKeeping<OptimalPlacement>{}, soup, options);
}

} // namespace quadrille::internal
