#ifndef QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_CHECKS_H
#define QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_CHECKS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/intersection/intersection_check.h>
#include <quadrille/internal/normals/normal_check.h>
#include <quadrille/internal/policy/engine_policies.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <cstddef>
#include <memory>
#include <optional>

namespace quadrille::internal {

/// What looks at places as they will be written, and follows contractions, where that is asked for:
/// see NoSelfIntersection and NormalDeviation. Where nothing is, that is all that is looked at.
class OptionalChecks {
public:
  template <class Policies, std::size_t N>
  OptionalChecks(const Policies& policies, const TriangleComplex& complex,
                 const Geometry<N>& geometry, bool is_topology_kept) {
    const auto& optional = policies.optional;
    if (optional.make_intersection_check)
      intersections_ = optional.make_intersection_check(complex, geometry);
    if (optional.make_normal_check)
      normals_ =
          optional.make_normal_check(complex, geometry, is_topology_kept, optional.normal_degrees);
    is_any_ = intersections_ || normals_;
  }

  bool is_any() const { return is_any_; }
  /// nullptr if nobody asks.
  IntersectionCheck* intersections() const { return intersections_.get(); }

  /// The surface is as it is before the first contraction.
  void begin(Report& report) const {
    if (normals_)
      normals_->begin();
    if (intersections_) {
      intersections_->begin();
      report.self_intersections = {intersections_->count(), 0};
    }
  }
  void end(Report& report) const {
    if (normals_)
      report.normal_bound_degrees = normals_->greatest_degrees();
    if (intersections_)
      report.self_intersections->after = intersections_->count();
  }

  /// Why the ends of a contraction must not come to a target, if so.
  template <class Contraction>
  QUADRILLE_NOINLINE std::optional<Rejection> refusal(const Contraction& contraction,
                                                      const Vector<3>& target) const {
    const auto& star = contraction.star();
    const Index a = contraction.first(), b = contraction.second();
    if (normals_ && normals_->is_too_far(star, b, target))
      return Rejection::normal_deviation;
    if (intersections_ && intersections_->makes_intersection(star, a, b, target))
      return Rejection::self_intersection;
    return std::nullopt;
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) const {
    if (is_any_) [[unlikely]]
      follow(event.contraction.star(), event.contraction.first(), event.contraction.second());
  }
  void vanished(const PartEvent& event) const {
    if (intersections_)
      intersections_->forget(event.faces);
  }

  /// Faces that are removed are about to lose their numbers, in a pass.
  template <class IsLeft>
  void pack_if(IsLeft) const {
    if (normals_)
      normals_->pack();
  }

private:
  QUADRILLE_NOINLINE void follow(const PairStar& star, Index a, Index b) const {
    if (normals_)
      normals_->follow(star, b);
    if (intersections_)
      intersections_->follow(star, a);
  }

  std::unique_ptr<IntersectionCheck> intersections_;
  std::unique_ptr<NormalCheck> normals_;
  bool is_any_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_CHECKS_H
