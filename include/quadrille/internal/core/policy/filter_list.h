#ifndef QUADRILLE_INTERNAL_CORE_POLICY_FILTER_LIST_H
#define QUADRILLE_INTERNAL_CORE_POLICY_FILTER_LIST_H

#include <quadrille/filters.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/policy/contraction_view.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
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
  /// The default of a call: NormalFlip, unless one is among the filters. Each may be a
  /// std::optional.
  template <class... Filters>
  static FilterList of(const Filters&... filters) {
    FilterList list;
    (if_given(filters, [&](const auto& filter) { list.add(filter); }), ...);
    return list;
  }

  /// What the first that does not allow the contraction, of which this is a view, refuses it as.
  template <class Contraction>
  std::optional<Rejection> refusal(const ContractionView<N>& view, const Contraction& contraction,
                                   const Numbering& numbering, const Scale<N>& scale) const {
    if (!normal_flip_.allows(view))
      return NormalFlip::cause;
    if (others_.empty())
      return std::nullopt;
    return refusal_by_others(view, contraction, numbering, scale);
  }

private:
  struct Other {
    std::shared_ptr<const void> filter;
    bool (*allows)(const void*, const IndexedContraction<N>&, const Scale<N>&);
    Rejection cause;
  };

  template <class Contraction>
  QUADRILLE_NOINLINE std::optional<Rejection>
  refusal_by_others(const ContractionView<N>& view, const Contraction& contraction,
                    const Numbering& numbering, const Scale<N>& scale) const {
    const IndexedContraction<N> indexed(view, contraction.star(), contraction.first(),
                                        contraction.second(), numbering);
    for (const Other& other : others_)
      if (!other.allows(other.filter.get(), indexed, scale))
        return other.cause;
    return std::nullopt;
  }

  template <class Filter>
  void add(const Filter& filter) {
    validate(filter);
    if constexpr (std::same_as<Filter, NormalFlip>)
      if (!std::exchange(is_normal_flip_given_, true)) {
        normal_flip_ = filter;
        return;
      }
    others_.push_back({std::make_shared<const Filter>(filter), &allows<Filter>, cause_of<Filter>});
  }

  template <class Filter>
  static bool allows(const void* filter, const IndexedContraction<N>& contraction,
                     [[maybe_unused]] const Scale<N>& scale) {
    const Filter& by_type = *static_cast<const Filter*>(filter);
    if constexpr (is_scale_free<Filter>)
      return by_type.allows(contraction);
    else
      return by_type.allows(ContractionInMeshUnits<N>(contraction, scale));
  }

  NormalFlip normal_flip_;
  bool is_normal_flip_given_ = false;
  std::vector<Other> others_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_FILTER_LIST_H
