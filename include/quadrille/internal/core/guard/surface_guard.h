#ifndef QUADRILLE_INTERNAL_CORE_GUARD_SURFACE_GUARD_H
#define QUADRILLE_INTERNAL_CORE_GUARD_SURFACE_GUARD_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <cstddef>
#include <span>

namespace quadrille::internal {

/// The surface that a guard looks at, as it is at any time.
template <std::size_t N>
struct GuardRoom {
  const TriangleComplex& complex;
  const Geometry<N>& geometry;
  const Numbering& numbering;
  const Scale<N>& scale;
  bool is_topology_kept;
};

/// A contraction as a guard sees it. The places are those of the ends before it.
template <std::size_t N>
struct GuardedPair {
  const PairStar& star;
  Index first, second;
  const Vector<N>&first_place, &second_place, &target;
};

/// Keeps an invariant of a surface, from before the first contraction to the last: one is made for
/// each guard of a call, and compiled for calls with that guard only.
///
/// In passes any number of threads ask at once, and follow contractions of stars that have no face
/// in common: see works_in_passes in <quadrille/guard.h>.
template <std::size_t N>
class SurfaceGuard {
public:
  virtual ~SurfaceGuard() = default;

  /// The surface is as it is before the first contraction. May throw, if it cannot be guarded.
  virtual void begin(Report& report) = 0;
  /// Must the ends of this pair not come together at its target?
  virtual bool rejects(const GuardedPair<N>& pair) = 0;
  /// A contraction has been done: the vertex that is kept has its place. The star is as it was
  /// before.
  virtual void follow(const GuardedPair<N>& pair, Index kept) = 0;
  /// These faces are about to be removed, with their whole component.
  virtual void forget(std::span<const Index> /*faces*/) {}
  /// Faces that are removed are about to lose their numbers, in a pass.
  virtual void pack() {}
  /// The surface is as it is after the last contraction.
  virtual void end(Report& report) = 0;

  /// Does it reject pairs because of other faces, so that they may have another turn when these
  /// have changed, or another place is tried?
  virtual bool has_obstacles() const { return false; }
  /// Returns the face that obstructed the last pair that it was asked about; none if it is in the
  /// star, or if there was none.
  virtual Index obstacle() const { return none; }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_GUARD_SURFACE_GUARD_H
