#ifndef QUADRILLE_MEMORYLESS_QUADRIC_H
#define QUADRILLE_MEMORYLESS_QUADRIC_H

#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/cost/local_terms.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace quadrille {

/// Quadrics of the surface as it is now: a position costs the sum of its squared distances to the
/// planes of the current faces around the pair, each counted once, with weights between their areas
/// and the squares of these: area^(5/4). The position of least cost is sought among those that keep
/// the volume, with which the result is more accurate than with what `Quadric` remembers, by a
/// fifth in root mean square at a tenth of the faces, and takes about twice the time. At very low
/// counts the order may turn: thin parts that no vertex remembers get lost. ThinFeatureQuadric
/// keeps them.
///
/// Boundary edges add the constraint planes of the paper, perpendicular to their faces, each with
/// the weight of a square on its edge. The error in Status and Report is that of single
/// contractions, each from the surface just before it: it does not add up to a distance to the
/// input.
///
/// Source: Lindstrom and Turk, Fast and Memory Efficient Polygonal Simplification, 1998 (memoryless
/// costs, volume preservation); Hoppe, New Quadric Metric, 1999, section 5 (the same for quadrics).
struct MemorylessQuadric {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = MemorylessQuadric;        ///< as well in any unit: see CostPolicy
  using TieBreak = MemorylessQuadric;         ///< on the scale of the values of this class
  using TwoLanes = MemorylessQuadric;         ///< pairs may be costed two at a time: see CostPolicy

  double boundary_weight = 100; ///< at least 0; 0 lets boundaries recede

  /// Values grow with that power of lengths.
  double degree() const { return 4.5; }

  /// Nothing.
  struct State {
    State& operator+=(const State&) { return *this; } ///< nothing and nothing is nothing
  };
  /// Leaves nothing.
  State face(const Vector<3>&, const Vector<3>&, const Vector<3>&) const { return {}; }
  static constexpr bool face_is_alike_at_corners = true; ///< nothing is the same at all

  /// A pair that has become more costly while it waited, but by no more than this factor, is
  /// contracted all the same: to send it back takes time, and the error is no lower for it.
  static constexpr double tolerated_rise = 1.1;

  /// Where unevenness() has fallen by more than this factor, the pairs of the vertex are costed
  /// anew, since they would come too late.
  static constexpr double tolerated_fall = 0.7;

  /// How much more than its area a face counts, in √length. With 1 for all the error is lower by
  /// 0.3 % on some surfaces and higher by 0.6 % on a million noisy faces.
  static double emphasis(double area) { return std::sqrt(std::sqrt(area)); }

  /// How much a face counts for the attributes of channels: as for the shape.
  static double channel_weight(double area) { return area * emphasis(area); }

  /// What the faces around a vertex say now, about the vertex, through which all their planes go.
  struct Current {
    SymmetricMatrix<3> matrix; ///< of the planes
    Vector<3> doubled_area;    ///< the sum of their doubled area vectors

    /// Takes in what further faces say.
    Current& operator+=(const Current& other) {
      matrix += other.matrix;
      doubled_area += other.doubled_area;
      return *this;
    }
    /// Takes out what some faces say.
    Current& operator-=(const Current& other) {
      matrix -= other.matrix;
      doubled_area -= other.doubled_area;
      return *this;
    }
  };

  /// About what costs at a vertex are in proportion to: the product of the three eigenvalues of the
  /// planes of its faces, by the square of their sum. 0 where the faces lie in a plane or fold
  /// along one line.
  double unevenness(const Current& current) const {
    const double trace = current.matrix.trace();
    return trace > 0 ? current.matrix.determinant() / (trace * trace) : 0;
  }

  /// What a face pqr says now at each of its corners. Nothing for a face without a normal.
  Current current_face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return weighted_face(p, q, r, [](double area) { return emphasis(area); });
  }
  /// What a face says if it counts by emphasis(area) times its area.
  template <class Emphasis>
  static Current weighted_face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r,
                               Emphasis emphasis) {
    const Vector<3> normal = normal_vector(p, q, r);
    const double length = std::sqrt(squared_length(normal));
    if (!(length > 0))
      return {};
    const double factor = emphasis(0.5 * length);
    return {SymmetricMatrix<3>::outer_product(normal, 0.5 / length * factor), normal};
  }

  /// What the boundary edge pq of a face pqr says now at both of its ends.
  Current current_boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    const double weight = boundary_weight * emphasis(squared_length(q - p));
    return {Quadric::constraint_plane(p, q, r, weight).matrix(), {}};
  }

  /// All of a pair, about its first end: the quadric, and the plane that keeps the volume.
  struct PairCurrent {
    QuadricForm<3> quadric; ///< of all planes around the pair
    Vector<3> normal;       ///< the sum of the doubled area vectors
    double offset = 0;      ///< normal · x = offset keeps the volume
  };

  /// Joins what the two ends say, `to_second` apart, and takes out what they share.
  PairCurrent join(const Current& first, const Current& second, const Current& shared,
                   const Vector<3>& to_second) const {
    QuadricForm<3> quadric(second.matrix);
    quadric.move_origin(-1.0 * to_second);
    quadric.matrix() += first.matrix;
    quadric.matrix() -= shared.matrix;
    return {quadric, first.doubled_area + second.doubled_area - shared.doubled_area,
            dot(second.doubled_area, to_second)};
  }

  /// The weighted sum of the squared distances of x to the planes around the pair.
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.current.quadric(x - pair.first);
  }

  /// Tells pairs of equal costs apart: see CostPolicy.
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return tie_break_of(pair)(x - pair.first);
  }

  /// The position of least cost among those that keep the volume, if there is one.
  std::optional<Vector<3>> minimizer(const auto& pair) const {
    const PairCurrent& current = pair.current;
    std::optional<Vector<3>> x =
        tie_break_of(pair).minimizer(current.quadric, current.normal, current.offset);
    if (x)
      *x += pair.first;
    return x;
  }

  /// The square of the root mean square distance to the planes around the pair.
  double squared_error(const auto& pair, double cost) const {
    const double weight = pair.current.quadric.trace();
    return weight > 0 ? cost / weight : 0;
  }

  /// Throws std::invalid_argument for a weight that makes no sense.
  void validate() const {
    internal::require_weight("quadrille::MemorylessQuadric", "boundary_weight", boundary_weight);
  }

private:
  static internal::TieBreak<3> tie_break_of(const auto& pair) {
    return {pair.current.quadric.trace(), pair.second - pair.first};
  }
};

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
  struct State {
    QuadricForm<3> planes; ///< about the vertex
    double before = 0;     ///< of a pair: what the planes cost at its two ends

    /// Joins what two vertices remember, about one origin.
    State& operator+=(const State& other) {
      planes += other.planes;
      return *this;
    }
    /// Takes out what one of several pieces of a surface remembers, about one origin.
    State& operator-=(const State& other) {
      planes -= other.planes;
      return *this;
    }
    void move_origin(const Vector<3>& d) { planes.move_origin(d); } ///< as QuadricForm::move_origin
    /// As QuadricForm::sum_about_first, and what both cost where they are.
    static State sum_about_first(const State& first, const State& second, const Vector<3>& d) {
      return {QuadricForm<3>::sum_about_first(first.planes, second.planes, d),
              first.planes.constant() + second.planes.constant()};
    }
  };
  /// The plane of an input face, weighted with its area.
  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
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
    const QuadricForm<3>& planes = pair.state.planes;
    return MemorylessQuadric::operator()(pair, x) +
           loss(planes(x - pair.first) - pair.state.before, planes.trace());
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
QUADRILLE_ENGINES(extern template, MemorylessQuadric);
QUADRILLE_ENGINES(extern template, ThinFeatureQuadric);
} // namespace quadrille::internal
#endif

#endif // QUADRILLE_MEMORYLESS_QUADRIC_H
