#ifndef QUADRILLE_VISITOR_H
#define QUADRILLE_VISITOR_H

#include <quadrille/report.h>

#include <concepts>

namespace quadrille {

/// Watches a simplification, and may cancel it: a base for a user's own visitor, given as the CGAL
/// named parameter `visitor`.
///
/// A visitor is copied, as all that is given by name; `visitor(std::ref(v))` refers to v itself, so
/// that what it has gathered is there after the call. It need not be constant.
struct Visitor {
  /// Called by the thread that has called `simplify`:
  ///
  /// - when the surface has been read: no contractions, Status::progress 0, Stage::prepare
  /// - while it is prepared, several times, and where pairs are costed for the queue once for
  ///   65,536 vertices: the same
  /// - before the first pair is looked at: the same, but Stage::contract from here on
  /// - every few hundred pairs that are looked at, contracted or not, and after each pass of
  ///   RelaxedOrder
  /// - at the end, unless it has cancelled, just before the surface is rewritten: Status::progress
  ///   1, Stage::write. What it returns then has no effect.
  ///
  /// What becomes of each pair is told to a recorder instead: see record.h.
  ///
  /// Returning false ends the simplification with StopReason::cancelled: before the first
  /// contraction with the surface as it was, later with what has been done until then. So that
  /// Status::progress can be told, the stop policy is asked beforehand about counts to come.
  bool proceed(const Status& /*status*/) const { return true; }
};

/// **Visitor**: what is told of a simplification, and may cancel it?
///
/// **Has models** Visitor.
///
/// **Requirements**, for a `visitor`, which need not be constant:
///
/// - `visitor.proceed(status)`: a bool; `status` is a Status. When it is called: see Visitor.
template <class V>
concept VisitorPolicy = requires(V& visitor, const Status status) {
  { visitor.proceed(status) } -> std::convertible_to<bool>;
};

} // namespace quadrille

#endif // QUADRILLE_VISITOR_H
