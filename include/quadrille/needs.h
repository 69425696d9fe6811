#ifndef QUADRILLE_NEEDS_H
#define QUADRILLE_NEEDS_H

namespace quadrille {

/// Which numbers of a Status a stop policy needs that are found out for those only that need them:
/// see StopPolicy. Others are told the greatest numbers that there are, or infinity.
struct Needs {
  bool distance = false;      ///< Status::next_distance, as ErrorLimit does
  bool distance_back = false; ///< Status::next_distance_back, as HausdorffLimit; implies `distance`
  bool tolerance = false;     ///< Status::next_tolerance, as ToleranceLimit; implies both of these
  bool cost = false;          ///< Status::next_cost, as CostLimit
  bool edges = false;         ///< Status::edges and initial_edges, as EdgeCount

  /// What either needs.
  friend constexpr Needs operator|(const Needs& a, const Needs& b) {
    return {a.distance || b.distance, a.distance_back || b.distance_back,
            a.tolerance || b.tolerance, a.cost || b.cost, a.edges || b.edges};
  }
  /// What both need.
  friend constexpr Needs operator&(const Needs& a, const Needs& b) {
    return {a.distance && b.distance, a.distance_back && b.distance_back,
            a.tolerance && b.tolerance, a.cost && b.cost, a.edges && b.edges};
  }
  /// Do both need the same?
  friend constexpr bool operator==(const Needs&, const Needs&) = default;
};

} // namespace quadrille

#endif // QUADRILLE_NEEDS_H
