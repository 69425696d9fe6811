#ifndef QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H
#define QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/intersection/intersection_check.h>
#include <quadrille/internal/policy/engine_policies.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <cstddef>
#include <memory>

namespace quadrille::internal {

/// What keeps the faces of a surface apart, as an observer of its contractions, if that is asked
/// for: see NoSelfIntersection.
class OptionalIntersections {
public:
  template <class Policies, std::size_t N>
  OptionalIntersections(const Policies& policies, const TriangleComplex& complex,
                        const Geometry<N>& geometry) {
    if (policies.optional.make_intersection_check)
      check_ = policies.optional.make_intersection_check(complex, geometry);
  }

  /// nullptr if nobody asks.
  IntersectionCheck* get() const { return check_.get(); }

  /// The surface is as it is before the first contraction.
  void begin(Report& report) const {
    if (check_) {
      check_->begin();
      report.self_intersections = {check_->count(), 0};
    }
  }
  void end(Report& report) const {
    if (check_)
      report.self_intersections->after = check_->count();
  }

  /// Would faces intersect that do not, if the ends of a contraction came to a target?
  template <class Contraction>
  bool are_made_by(const Contraction& contraction, const Vector<3>& target) const {
    if (check_) [[unlikely]]
      return check_->makes_intersection(contraction.star(), contraction.first(),
                                        contraction.second(), target);
    return false;
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) const {
    if (check_) [[unlikely]]
      check_->follow(event.contraction.star(), event.contraction.first());
  }
  void vanished(const PartEvent& event) const {
    if (check_)
      check_->forget(event.faces);
  }

private:
  std::unique_ptr<IntersectionCheck> check_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H
