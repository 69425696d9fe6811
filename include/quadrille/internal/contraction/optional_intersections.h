#ifndef QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H
#define QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/intersection/intersection_check.h>
#include <quadrille/internal/policy/engine_policies.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/report.h>

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
  void begin() {
    if (check_) {
      check_->begin();
      before_ = check_->count();
    }
  }
  void tell(Report& report) const {
    if (check_)
      report.self_intersections = {before_, check_->count()};
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) {
    if (check_) [[unlikely]]
      check_->follow(event.contraction.star(), event.contraction.first());
  }
  void vanished(const PartEvent& event) {
    if (check_)
      check_->forget(event.faces);
  }

private:
  std::unique_ptr<IntersectionCheck> check_;
  std::size_t before_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_OPTIONAL_INTERSECTIONS_H
