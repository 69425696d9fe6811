#ifndef QUADRILLE_THIN_FEATURE_QUADRIC_H
#define QUADRILLE_THIN_FEATURE_QUADRIC_H

#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>
#include <quadrille/vector.h>

namespace quadrille {

/// MemorylessQuadric that does not lose thin parts (legs, horns, handles) at low counts. The faces
/// of a part that has become thin have little area, so they hardly speak against its end; what
/// they have replaced does. A vertex therefore remembers the planes of its input faces as with
/// Quadric, and a contraction costs more where it is a *loss*: where the squared distances to the
/// remembered planes, in sum, grow by more than a part of the square of their area.
///
/// With the cost C of MemorylessQuadric by plain areas, the remembered quadrics Q of the ends a and
/// b, and A, a third of their trace, the area of the faces, each of which three vertices remember:
///
///     C(x) + loss_weight · max(0, Q(x) − Qa(a) − Qb(b) − 3 (loss_tolerance · A)²)
///
/// Neither factor has a unit. The position of least cost is that of C everywhere. Takes up to
/// a third more time than MemorylessQuadric, and 88 bytes more a vertex. With RelaxedOrder::refresh
/// vertices remember no more than the last pass.
///
/// As with MemorylessQuadric the error in Status and Report is that of single contractions; a loss
/// counts in it as in the cost. Boundaries are what MemorylessQuadric makes of them.
struct ThinFeatureQuadric : MemorylessQuadric {
  using ScaleFree = ThinFeatureQuadric; ///< as well in any unit: see CostPolicy
  using TieBreak = ThinFeatureQuadric;  ///< on the scale of the values of this class
  using TwoLanes = ThinFeatureQuadric;  ///< pairs may be costed two at a time: see CostPolicy

  double loss_weight = 3;       ///< at least 0
  double loss_tolerance = 0.15; ///< at least 0; more: only larger losses count

  static constexpr double tolerated_rise = 1;   ///< with more, some legs are lost
  static constexpr double tolerated_fall = 0.5; ///< as in MemorylessQuadric

  /// Values grow with that power of lengths.
  double degree() const { return 4; }

  /// What a vertex remembers of its input faces.
  struct Memory {
    QuadricForm<3> planes; ///< about the vertex
    double before = 0;     ///< of a pair: what the planes cost at its two ends

    /// Joins what two vertices remember, about one origin.
    Memory& operator+=(const Memory& other) {
      planes += other.planes;
      return *this;
    }
    /// Takes out what one of several pieces of a surface remembers, about one origin.
    Memory& operator-=(const Memory& other) {
      planes -= other.planes;
      return *this;
    }
    void move_origin(const Vector<3>& d) { planes.move_origin(d); } ///< as QuadricForm::move_origin
    /// As QuadricForm::sum_about_first, and what both cost where they are.
    static Memory sum_about_first(const Memory& first, const Memory& second, const Vector<3>& d) {
      return {QuadricForm<3>::sum_about_first(first.planes, second.planes, d),
              first.planes.constant() + second.planes.constant()};
    }
  };
  /// The plane of an input face, weighted with its area.
  Memory face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return {Quadric{}.face(p, q, r)};
  }

  /// How much a face counts for attributes.
  static double channel_weight(double area) { return area; }
  /// As in MemorylessQuadric, by plain areas.
  Current current_face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return weighted_face(p, q, r, [](double) { return 1.0; });
  }
  /// As in MemorylessQuadric, by plain squares.
  Current current_boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return {Quadric::constraint_plane(p, q, r, boundary_weight).matrix(), {}};
  }

  /// The cost of MemorylessQuadric by plain areas, and that of the loss.
  double operator()(const auto& pair, const Vector<3>& x) const {
    const QuadricForm<3>& planes = pair.memory.planes;
    return MemorylessQuadric::operator()(pair, x) +
           loss(planes(x - pair.first) - pair.memory.before, planes.trace());
  }

  /// What it costs if remembered planes of a trace get worse by `growth`.
  template <class Number>
  Number loss(const Number& growth, const Number& trace) const {
    const Number excess = growth - loss_tolerance * loss_tolerance / 3 * trace * trace;
    return internal::select(excess > Number{}, loss_weight * excess, Number{});
  }

  /// Throws std::invalid_argument for a weight or a tolerance that makes no sense.
  void validate() const {
    MemorylessQuadric::validate();
    internal::require_weight("quadrille::ThinFeatureQuadric", "loss_weight", loss_weight);
    internal::require_weight("quadrille::ThinFeatureQuadric", "loss_tolerance", loss_tolerance);
  }
};

} // namespace quadrille

#ifdef QUADRILLE_WITH_COMPILED
#include <quadrille/internal/core/call/compiled_engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(extern template, ThinFeatureQuadric);
} // namespace quadrille::internal
#endif

#endif // QUADRILLE_THIN_FEATURE_QUADRIC_H
