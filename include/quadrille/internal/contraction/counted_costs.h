#ifndef QUADRILLE_INTERNAL_CONTRACTION_COUNTED_COSTS_H
#define QUADRILLE_INTERNAL_CONTRACTION_COUNTED_COSTS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/cost_histogram.h>
#include <quadrille/internal/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// Counts the faces that contractions take at their edges, by what these cost, where that is asked
/// for. In greedy order a contraction counts as costly as the most costly one before it, so that
/// the faces up to a cost are those that a run up to it would have taken; in a pass by its own key.
class CountedCosts {
public:
  /// `histogram` is null if nobody asks.
  CountedCosts(CostHistogram* histogram, const TriangleComplex& complex)
      : histogram_(histogram), complex_(complex) {}

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if (histogram_) [[unlikely]]
      count<Event::is_in_pass>(static_cast<float>(event.contraction.key()),
                               complex_.backs().count_all(event.contraction.star().shared));
  }

private:
  template <bool is_in_pass>
  QUADRILLE_NOINLINE void count(float key, std::size_t faces) {
    if constexpr (is_in_pass) {
      histogram_->add_in_pass(key, faces);
    } else {
      highest_ = (std::max)(highest_, key);
      histogram_->add(highest_, faces);
    }
  }

  CostHistogram* histogram_;
  const TriangleComplex& complex_;
  float highest_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_COUNTED_COSTS_H
