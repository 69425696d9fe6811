#ifndef QUADRILLE_INTERNAL_POLICY_FILTER_LIST_H
#define QUADRILLE_INTERNAL_POLICY_FILTER_LIST_H

#include <quadrille/filters.h>
#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/policy/contraction_view.h>
#include <quadrille/internal/policy/mesh_units.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The filters of a call, told at run time: a NormalFlip, which is there always and compiled into
/// the engine, and others of any type, in the order of the call.
template <std::size_t N>
class FilterList {
public:
  /// The default of a call: NormalFlip, unless one is among the filters.
  template <class... Filters>
  static FilterList of(const Filters&... filters) {
    FilterList list;
    (list.add(filters), ...);
    return list;
  }

  /// What the first that does not allow the contraction refuses it as.
  std::optional<Rejection> refusal(const ContractionView<N>& contraction,
                                   const Scale<N>& scale) const {
    if (!normal_flip_.allows(contraction))
      return NormalFlip::cause;
    for (const Other& other : others_)
      if (!other.allows(other.filter.get(), contraction, scale))
        return other.cause;
    return std::nullopt;
  }

private:
  struct Other {
    std::shared_ptr<const void> filter;
    bool (*allows)(const void*, const ContractionView<N>&, const Scale<N>&);
    Rejection cause;
  };

  template <class Filter>
  void add(const Filter& filter) {
    if constexpr (std::same_as<Filter, NormalFlip>)
      if (!std::exchange(is_normal_flip_given_, true)) {
        normal_flip_ = filter;
        return;
      }
    others_.push_back({std::make_shared<const Filter>(filter), &allows<Filter>, cause<Filter>()});
  }

  template <class Filter>
  static bool allows(const void* filter, const ContractionView<N>& contraction,
                     [[maybe_unused]] const Scale<N>& scale) {
    const Filter& by_type = *static_cast<const Filter*>(filter);
    if constexpr (is_scale_free<Filter>)
      return by_type.allows(contraction);
    else
      return by_type.allows(ContractionInMeshUnits<N>(contraction, scale));
  }

  template <class Filter>
  static constexpr Rejection cause() {
    if constexpr (requires { Filter::cause; })
      return Filter::cause;
    else
      return Rejection::filter;
  }

  NormalFlip normal_flip_;
  bool is_normal_flip_given_ = false;
  std::vector<Other> others_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_FILTER_LIST_H
