#ifndef QUADRILLE_INTERNAL_POLICY_VISITOR_HOLDER_H
#define QUADRILLE_INTERNAL_POLICY_VISITOR_HOLDER_H

#include <quadrille/report.h>
#include <quadrille/visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <utility>

/// The visitor of a call, as policies hold it.

namespace quadrille::internal {

/// Where there is none.
struct NoVisitor {
  static constexpr bool is_given = false;
  bool proceed(const Status&) const { return true; }
};

/// One that was given by value: policies are constant, a visitor need not be.
template <class V>
class VisitorCopy {
public:
  static constexpr bool is_given = true;
  explicit VisitorCopy(V visitor) : visitor_(std::move(visitor)) {}
  bool proceed(const Status& status) const { return visitor_.proceed(status); }

private:
  mutable V visitor_;
};

/// One that the user keeps.
template <class V>
class VisitorReference {
public:
  static constexpr bool is_given = true;
  explicit VisitorReference(V& visitor) : visitor_(&visitor) {}
  bool proceed(const Status& status) const { return visitor_->proceed(status); }

private:
  V* visitor_;
};

inline NoVisitor hold_visitor(CGAL::internal_np::Param_not_found) {
  return {};
}
template <class V>
auto hold_visitor(const V& visitor) {
  static_assert(VisitorPolicy<V>,
                "A visitor has a member function bool proceed(const quadrille::Status&): derive it "
                "from quadrille::Visitor.");
  return VisitorCopy<V>(visitor);
}
template <class V>
auto hold_visitor(const std::reference_wrapper<V>& visitor) {
  static_assert(VisitorPolicy<V>,
                "A visitor has a member function bool proceed(const quadrille::Status&), which is "
                "const if the visitor is: derive it from quadrille::Visitor, and pass std::ref of "
                "one that changes.");
  return VisitorReference<V>(visitor.get());
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_VISITOR_HOLDER_H
