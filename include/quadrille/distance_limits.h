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

/// A distance, or a part of the diagonal of the bounding box.
class DistanceOrPart {
public:
  /// In the mesh's units, for a bounding box of that diagonal.
  double distance(double diagonal) const { return is_relative_ ? number_ * diagonal : number_; }

protected:
  DistanceOrPart(double number, bool is_relative) : number_(number), is_relative_(is_relative) {}

  double number() const { return number_; }
  bool is_relative() const { return is_relative_; }
  /// Throws for what is negative or not a number; `what` needs it.
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

/// Takes no contraction that might leave a point of the surface further from the input than a
/// limit, and stops when there is none left that does not. The result is within the limit:
/// Report::distance_bound says how far at most.
///
/// The bound is conservative. It adds up what each contraction moves the surface, so a result is
/// often twice as close to the input as it says, or more. A border counts by how far it moves away
/// from itself, to either side: to slide along a straight one costs nothing, and none recedes
/// further than the limit.
///
/// Distances up to 2⁻⁴⁰ of the greatest coordinate, about 10⁻¹², may be nothing but the sum of
/// roundings, and pass any limit: DistanceLimit{0} contracts what is exact but for these, as on
/// flat parts and along straight creases. Report::distance_bound tells them nevertheless.
///
/// A stop policy that asks one of these has to say that it needs distances, else nothing is known
/// to be within the limit and not one contraction is done. A policy of one's own that looks at
/// Status::next_distance may be asked several times for one contraction, with distances that it has
/// at least; where it stops at one it has to stop at all greater ones. Source: the projection along
/// the mean normal is that of Bajaj and Schikore 1996.
class DistanceLimit : public internal::DistanceOrPart {
public:
  /// `distance` is in the mesh's units.
  explicit DistanceLimit(double distance) : DistanceLimit(distance, false) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static DistanceLimit relative(double fraction) { return DistanceLimit(fraction, true); }

  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr Needs needs = {.distance = true};

  /// Is it enough?
  bool operator()(const Status& status) const {
    return status.next_distance > distance(status.diagonal);
  }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const { require_distance("quadrille::DistanceLimit"); }

private:
  DistanceLimit(double number, bool is_relative) : DistanceOrPart(number, is_relative) {}
};

/// The same both ways: no point of the result will be further from the input than the limit, and no
/// point of the input further from the result. Nothing within the limit of the result is lost,
/// neither spikes nor borders; and their Hausdorff distance is within it, as
/// Report::hausdorff_bound says.
///
/// Beside what DistanceLimit does each face knows how far the input points may be that have come to
/// lie in it, which takes 4 bytes more for each. That adds up, too, and what is exact costs
/// nothing: flat parts, straight borders and creases. A contraction that leaves points of the input
/// without any face, which only a free topology allows, is refused, and so is a part that would
/// vanish. Of the input, faces that have a vertex twice are no part.
///
/// One of DistanceLimit's roundings passes any limit here as well. A stop policy that asks this one
/// has to say that it needs distance_back.
class HausdorffLimit : public internal::DistanceOrPart {
public:
  /// `distance` is in the mesh's units.
  explicit HausdorffLimit(double distance) : HausdorffLimit(distance, false) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static HausdorffLimit relative(double fraction) { return HausdorffLimit(fraction, true); }

  /// Looks at Status::next_distance and next_distance_back: see StopPolicy.
  static constexpr Needs needs = {.distance_back = true};

  /// Is it enough?
  bool operator()(const Status& status) const {
    const double limit = distance(status.diagonal);
    return status.next_distance > limit || status.next_distance_back > limit;
  }

  /// Another limit, so many times as large.
  HausdorffLimit times(double factor) const { return {factor * number(), is_relative()}; }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const { require_distance("quadrille::HausdorffLimit"); }

private:
  HausdorffLimit(double number, bool is_relative) : DistanceOrPart(number, is_relative) {}
};

/// The same where the limit varies: each face of the input has a tolerance, the least of those of
/// its corners, which the named parameter vertex_tolerance_map tells (SoupOptions::tolerance;
/// of files OutOfCore::tolerance). No
/// point of an input face will be further than its tolerance from the result, and each point of the
/// result is near to some input face, within the tolerance of that. Where it is 0 nothing moves but
/// within its plane, or along its straight crease or border.
///
/// What counts is the part of its tolerance that each face has used: a contraction that moves the
/// surface by h uses h/τ more of it, where τ is the least tolerance around, so a small tolerance
/// reaches a few faces of the result beyond its own. As conservative as HausdorffLimit, which is
/// the case that all tolerances are the same; source of the sum: the composition of mappings,
/// Cohen, Manocha and Olano 1997.
///
/// In a call with it, Status::next_distance and Report::distance_bound are that part of the
/// greatest tolerance of all, which is a bound, and a coarse one: for a limit beside it, lower the
/// tolerances. It needs vertex_tolerance_map, and that needs it, else simplify throws
/// std::invalid_argument. 4 bytes a face more than HausdorffLimit.
class ToleranceLimit {
public:
  /// Looks at Status::next_tolerance: see StopPolicy.
  static constexpr Needs needs = {.tolerance = true};

  /// Is it enough?
  bool operator()(const Status& status) const { return status.next_tolerance > 1; }
};

} // namespace quadrille

#endif // QUADRILLE_DISTANCE_LIMITS_H
