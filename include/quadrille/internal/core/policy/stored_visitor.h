#ifndef QUADRILLE_INTERNAL_CORE_POLICY_STORED_VISITOR_H
#define QUADRILLE_INTERNAL_CORE_POLICY_STORED_VISITOR_H

#include <quadrille/report.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <optional>

/// The type-erased visitor of a call: an empty function if there is none.

namespace quadrille::internal {

using StoredVisitor = std::function<bool(const Status&)>;

inline StoredVisitor store_visitor(CGAL::internal_np::Param_not_found) {
  return {};
}
/// One that was given by value: policies are constant, a visitor need not be.
template <class V>
StoredVisitor store_visitor(const V& visitor) {
  static_assert(VisitorPolicy<V>,
                "A visitor has to have a member function bool proceed(const quadrille::Status&): "
                "derive it from quadrille::Visitor.");
  return
      [stored = visitor](const Status& status) mutable -> bool { return stored.proceed(status); };
}
/// One that the user keeps.
template <class V>
StoredVisitor store_visitor(const std::reference_wrapper<V>& visitor) {
  static_assert(VisitorPolicy<V>,
                "A visitor has to have a member function bool proceed(const quadrille::Status&), "
                "which is const if the visitor is: derive it from quadrille::Visitor, and pass "
                "std::ref of a visitor that changes.");
  return [visitor](const Status& status) -> bool { return visitor.get().proceed(status); };
}

/// One that may be given.
template <class V>
StoredVisitor store_visitor(const std::optional<V>& visitor) {
  return visitor ? store_visitor(*visitor) : StoredVisitor();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_STORED_VISITOR_H
