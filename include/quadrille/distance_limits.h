#ifndef QUADRILLE_DISTANCE_LIMITS_H
#define QUADRILLE_DISTANCE_LIMITS_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/guards/distance/distance_check.h>
#include <quadrille/report.h>

#include <stdexcept>
#include <string>

/// \file
/// How far a surface may be from the input: DistanceLimit, HausdorffLimit, ToleranceLimit.

namespace quadrille {

namespace internal {

/// A distance, or a fraction of the diagonal of the bounding box.
class DistanceOrFraction {
public:
  /// Returns the limit in the mesh's units, for a bounding box with this diagonal.
  double distance(double diagonal) const { return is_relative_ ? number_ * diagonal : number_; }

protected:
  DistanceOrFraction(double number, bool is_relative)
      : number_(number), is_relative_(is_relative) {}

  double number() const { return number_; }
  bool is_relative() const { return is_relative_; }
  /// Throws if the limit is negative or not a number; the message names `what`.
  void require_distance(const char* what) const {
    if (!(number_ >= 0))
      throw std::invalid_argument(std::string(what) + ": the limit " + text_of(number_) +
                                  " is not a distance");
  }

private:
  double number_;
  bool is_relative_;
};

} // namespace internal

/// Rejects each contraction that might leave a point of the surface further from the input than a
/// limit, and stops when no other contraction is left. The result is within the limit;
/// Report::distance_bound is the proven bound.
///
/// The bound is conservative. It accumulates the displacement of each contraction, so the result is
/// often at least twice as close to the input as the bound. A boundary counts by its distance from
/// the old boundary, to either side: sliding along a straight boundary costs nothing, and no
/// boundary recedes further than the limit.
///
/// Distances up to 2⁻⁴⁰ of the greatest coordinate, about 10⁻¹², may be mere sums of rounding
/// errors, and pass any limit: DistanceLimit{0} contracts whatever is exact up to these, as in flat
/// regions and along straight creases. Report::distance_bound includes them nevertheless.
///
/// A stop policy that calls this one must declare that it needs distances; otherwise no distance is
/// known to be within the limit, and no contraction is done. A user's policy that reads
/// Status::next_distance may be called several times for one contraction, with increasing lower
/// bounds of its distance; if it stops at one distance, it must stop at all greater ones. Source:
/// the projection along the mean normal is that of Bajaj and Schikore 1996.
class DistanceLimit : public internal::DistanceOrFraction {
public:
  /// `distance` is in the mesh's units.
  explicit DistanceLimit(double distance) : DistanceLimit(distance, false) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static DistanceLimit relative(double fraction) { return DistanceLimit(fraction, true); }

  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr Needs needs = {.distance = true};

  /// Returns true once the next contraction would exceed the limit.
  bool operator()(const Status& status) const {
    return status.next_distance > distance(status.diagonal);
  }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const { require_distance("quadrille::DistanceLimit"); }

private:
  DistanceLimit(double number, bool is_relative) : DistanceOrFraction(number, is_relative) {}
};

/// A limit in both directions: no point of the result will be further from the input than the
/// limit, and no point of the input further from the result. No feature larger than the limit is
/// lost, neither spikes nor boundaries, and the Hausdorff distance of input and result is within
/// the limit: see Report::hausdorff_bound.
///
/// In addition to the bound of DistanceLimit, each face has a bound for the input points that have
/// come to lie in it, which takes 4 more bytes per face. This bound is accumulated too, and exact
/// contractions cost nothing: in flat regions, along straight boundaries and creases. A contraction
/// that leaves points of the input without any face, which only a free topology allows, is
/// rejected, and so is one that would remove a component. Input faces that have a vertex twice are
/// ignored.
///
/// One of DistanceLimit's roundings passes any limit here as well. A stop policy that asks this one
/// has to say that it needs reverse_distance.
class HausdorffLimit : public internal::DistanceOrFraction {
public:
  /// `distance` is in the mesh's units.
  explicit HausdorffLimit(double distance) : HausdorffLimit(distance, false) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static HausdorffLimit relative(double fraction) { return HausdorffLimit(fraction, true); }

  /// Looks at Status::next_distance and next_reverse_distance: see StopPolicy.
  static constexpr Needs needs = {.reverse_distance = true};

  /// Returns true once the next contraction would exceed the limit in either direction.
  bool operator()(const Status& status) const {
    const double limit = distance(status.diagonal);
    return status.next_distance > limit || status.next_reverse_distance > limit;
  }

  /// Returns this limit multiplied by a factor.
  HausdorffLimit times(double factor) const { return {factor * number(), is_relative()}; }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const { require_distance("quadrille::HausdorffLimit"); }

private:
  HausdorffLimit(double number, bool is_relative) : DistanceOrFraction(number, is_relative) {}
};

/// A limit in both directions that varies over the surface. Each face of the input has a tolerance,
/// the least of those of its corners, which the named parameter vertex_tolerance_map provides
/// (SoupOptions::tolerance; for files OutOfCore::tolerance). No point of an input face will be
/// further than its tolerance from the result, and each point of the result is near to some input
/// face, within the tolerance of that. Where the tolerance is 0, the surface only moves within its
/// plane, or along its straight crease or boundary.
///
/// The limit applies to the fraction of its tolerance that each face has used: a contraction that
/// moves the surface by h uses h/τ more of it, where τ is the least tolerance around, so a small
/// tolerance affects a few faces of the result beyond its own. It is as conservative as
/// HausdorffLimit, which is the case of equal tolerances. Source of the sum: the composition of
/// mappings, Cohen, Manocha and Olano 1997.
///
/// In a call with this limit, Status::next_distance and Report::distance_bound are this fraction of
/// the greatest tolerance, which is a coarse bound: to limit the distance as well, lower the
/// tolerances. The limit and vertex_tolerance_map need each other; simplify throws
/// std::invalid_argument if one is missing. It takes 4 more bytes per face than HausdorffLimit.
class ToleranceLimit {
public:
  /// Looks at Status::next_tolerance: see StopPolicy.
  static constexpr Needs needs = {.tolerance = true};

  /// Returns true once the next contraction would exceed a tolerance.
  bool operator()(const Status& status) const { return status.next_tolerance > 1; }
};

} // namespace quadrille

#endif // QUADRILLE_DISTANCE_LIMITS_H
