#ifndef QUADRILLE_SIMPLIFIED_TOPOLOGY_H
#define QUADRILLE_SIMPLIFIED_TOPOLOGY_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/order/handle_cuts.h>

#include <cmath>
#include <stdexcept>

namespace quadrille {

/// Handles and tunnels up to a size go at their price: an argument of `simplify` for soups.
///
/// Topology is kept (Topology::kept or components_may_vanish) except for cuts. Where three edges
/// run round a tunnel or a handle, so that the link condition allows none of them to be contracted,
/// the surface may be cut along them and closed on both sides by a face each. A tunnel is filled in
/// this way, and a handle becomes two stumps, which contractions take away. A manifold stays one,
/// closed where it was, with a handle less: Report::cut_handles counts them. A tunnel that joins
/// two parts of the surface, as the outer wall of a shell and its inner one, is the last that does
/// so once others are cut; it is cut if both parts are wider than the size, by four times the
/// volume over the area, and Report::split_components counts it. Nothing else is parted: limbs
/// stay however thin they are.
///
/// **What is promised.** The width of a cut is at most the size. It is a third of the length of the
/// three edges, as they are when they are cut, and the greatest error of a vertex there: the root
/// mean square distance of the vertex from the planes that it stands for, as in Report::error. So a
/// tunnel of circular cross-section with the diameter d, of which the three edges are 0.87 d long,
/// or of a square one with the side d, 1.14 d long, is cut with a size of 1.5 d, and not with 0.8
/// d. Tunnels are found when three edges are left round them: those of a fine surface not before it
/// has been simplified, so at high counts some may stay.
///
/// **The price.** No vertex moves, and two faces come. The mean of the squared distance of their
/// points from the cut, r²/6 with the radius r of the inscribed circle, times the weight that both
/// faces have in the cost, is the cost of the cut; for Quadric that is the area of one times r².
/// The cheapest of all cuts and contractions comes next. The planes of both faces are accumulated
/// as those of the input are.
///
/// It is for surfaces that are oriented and manifold where they are cut (see make_manifold),
/// without channels, labels and double-sided faces. It throws std::invalid_argument for
/// Topology::free, a pair policy, a guard, a recorder, and a stop policy that needs distances.
/// RelaxedOrder cuts at its end. A result may have more points than the input, if hardly anything
/// is contracted; arrays that cannot grow then throw std::length_error. Filters are not asked.
struct SimplifiedTopology {
  /// The greatest width of what is cut, in the unit of the points; at least 0 and finite.
  double size;

  /// Throws std::invalid_argument for a size that is negative, infinite or not a number.
  void validate() const {
    if (!(size >= 0) || !std::isfinite(size))
      throw std::invalid_argument("quadrille::SimplifiedTopology: the size " +
                                  internal::text_of(size) + " is no length");
  }
};

} // namespace quadrille

#endif // QUADRILLE_SIMPLIFIED_TOPOLOGY_H
