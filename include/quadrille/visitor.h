#ifndef QUADRILLE_VISITOR_H
#define QUADRILLE_VISITOR_H

#include <quadrille/report.h>

namespace quadrille {

/// Watches a simplification, and may cancel it: a base for a user's own visitor, given as the CGAL
/// named parameter `visitor`.
struct Visitor {
  /// Called every few hundred pairs that are looked at, contracted or not, and after each pass of
  /// RelaxedOrder. Returning false ends the simplification with a valid
  /// mesh and StopReason::cancelled.
  bool proceed(const Status& /*status*/) const { return true; }
};

} // namespace quadrille

#endif // QUADRILLE_VISITOR_H
