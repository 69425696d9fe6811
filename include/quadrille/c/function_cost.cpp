#include <quadrille/compiled/run_soup.h>
#include <quadrille/compiled/soup_job.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

namespace quadrille::internal {

namespace {

/// A cost by a function. Vertices have the states that they have for Quadric.
class FunctionCost : public Quadric {
public:
  static constexpr bool asks_for_indices = true;

  explicit FunctionCost(const SoupCostFunction& function) : function_(&function) {}

  double operator()(const auto& pair, const Vector<3>& x) const {
    return (*function_)({pair.first_index, pair.second_index, pair.first.coordinates,
                         pair.second.coordinates, x.coordinates, Quadric::operator()(pair, x)});
  }
  double squared_error(const auto& /*pair*/, double cost) const { return cost; }

private:
  const SoupCostFunction* function_;
};

} // namespace

SoupResult soup_by_cost(const SoupView& soup, const SoupOptions& options,
                        const SoupCostFunction& function) {
  return run_soup(soup, options, [&](SoupRun& run) {
    return simplify_with_all(run, with_weights(FunctionCost(function), options),
                             placement_of<FunctionCost>(options), order_of(options));
  });
}

} // namespace quadrille::internal
