#include "engines.h"

#include <quadrille/compiled/run_soup.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

namespace quadrille_examples {

namespace {

using namespace quadrille;

/// What vertices remember is what they remember for Quadric.
class FunctionCost : public Quadric {
public:
  static constexpr bool asks_for_indices = true;

  explicit FunctionCost(const CostFunction& function) : function_(&function) {}

  double operator()(const auto& pair, const Vector<3>& x) const {
    return (*function_)({pair.first_index, pair.second_index, pair.first.coordinates,
                         pair.second.coordinates, x.coordinates, Quadric::operator()(pair, x)});
  }
  double squared_error(const auto& /*pair*/, double cost) const { return cost; }

private:
  const CostFunction* function_;
};

} // namespace

SoupResult soup_by_cost(const SoupView& soup, const SoupOptions& options,
                        const CostFunction& function) {
  return internal::run_soup(soup, options, [&](internal::SoupRun& run) {
    return internal::simplify_with_all(run, internal::with_weights(FunctionCost(function), options),
                                       internal::placement_of<FunctionCost>(options),
                                       internal::order_of(options));
  });
}

} // namespace quadrille_examples
