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

/// Quadrics of the current surface: the cost of a position is the sum of its squared distances to
/// the planes of the current faces around the pair. Each face counts once, with the weight
/// area^(5/4), between its area and the square of its area. The position of least cost is chosen
/// among those that keep the volume. The result is more accurate than with the accumulated planes
/// of `Quadric`, by a fifth in root mean square at a tenth of the faces, and takes about twice the
/// time. At very low counts it may be less accurate, because thin features, of which no vertex
/// keeps a state, get lost. ThinFeatureQuadric keeps them.
///
/// Boundary edges add the constraint planes of the paper, perpendicular to their faces, each with
/// the weight of a square on its edge. The error in Status and Report is that of single
/// contractions, relative to the surface just before each of them: it does not accumulate to a
/// distance from the input.
///
/// Source: Lindstrom and Turk, Fast and Memory Efficient Polygonal Simplification, 1998 (memoryless
/// costs, volume preservation); Hoppe, New Quadric Metric, 1999, section 5 (the same for quadrics).
struct MemorylessQuadric {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = MemorylessQuadric;        ///< scale-invariant: see CostPolicy
  using TieBreak = MemorylessQuadric;         ///< has the scale of this class's values
  using TwoLanes = MemorylessQuadric;         ///< pairs may be costed two at a time: see CostPolicy

  double boundary_weight = 100; ///< at least 0; 0 lets boundaries recede

  /// Returns the power of lengths with which the cost grows.
  double degree() const { return 4.5; }

  /// The empty state of a vertex.
  struct State {
    State& operator+=(const State&) { return *this; } ///< adds nothing
  };
  /// Returns the empty state.
  State face(const Vector<3>&, const Vector<3>&, const Vector<3>&) const { return {}; }
  static constexpr bool face_is_alike_at_corners = true; ///< the empty state is the same at all
                                                         ///< corners

  /// A pair that has become more costly in the queue, but by no more than this factor, is
  /// contracted anyway: returning it to the queue takes time and does not lower the error.
  static constexpr double tolerated_rise = 1.1;

  /// If unevenness() has fallen by more than this factor, the pairs of the vertex are costed again,
  /// since they would come too late.
  static constexpr double tolerated_fall = 0.7;

  /// Returns the factor on the area in the weight of a face, in √length. With 1 for all faces the
  /// error is lower by 0.3 % on some surfaces and higher by 0.6 % on a million noisy faces.
  static double emphasis(double area) { return std::sqrt(std::sqrt(area)); }

  /// Returns the weight of a face for the attributes of channels: the same as for the shape.
  static double channel_weight(double area) { return area * emphasis(area); }

  /// The contribution of the current faces around a vertex, relative to the vertex, through which
  /// all their planes pass.
  struct Current {
    SymmetricMatrix<3> matrix; ///< the matrix of the planes
    Vector<3> doubled_area;    ///< the sum of their doubled area vectors

    /// Adds the contribution of further faces.
    Current& operator+=(const Current& other) {
      matrix += other.matrix;
      doubled_area += other.doubled_area;
      return *this;
    }
    /// Subtracts the contribution of some faces.
    Current& operator-=(const Current& other) {
      matrix -= other.matrix;
      doubled_area -= other.doubled_area;
      return *this;
    }
  };

  /// Returns a number that is roughly proportional to the costs at a vertex: the product of the
  /// three eigenvalues of the planes of its faces, divided by the square of their sum. It is 0 if
  /// the faces lie in a plane or meet in one straight crease.
  double unevenness(const Current& current) const {
    const double trace = current.matrix.trace();
    return trace > 0 ? current.matrix.determinant() / (trace * trace) : 0;
  }

  /// Returns the contribution of a face pqr at each of its corners; zero for a face without a
  /// normal.
  Current current_face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return weighted_face(p, q, r, [](double area) { return emphasis(area); });
  }
  /// Returns the contribution of a face with the weight emphasis(area) times its area.
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

  /// Returns the contribution of the boundary edge pq of a face pqr at both of its ends.
  Current current_boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    const double weight = boundary_weight * emphasis(squared_length(q - p));
    return {Quadric::constraint_plane(p, q, r, weight).matrix(), {}};
  }

  /// The local terms of a pair, relative to its first end: the quadric, and the plane that keeps
  /// the volume.
  struct PairCurrent {
    QuadricForm<3> quadric; ///< the quadric of all planes around the pair
    Vector<3> normal;       ///< the sum of the doubled area vectors
    double offset = 0;      ///< normal · x = offset keeps the volume
  };

  /// Joins the contributions of the two ends, `to_second` apart, and subtracts the one that they
  /// share.
  PairCurrent join(const Current& first, const Current& second, const Current& shared,
                   const Vector<3>& to_second) const {
    QuadricForm<3> quadric(second.matrix);
    quadric.move_origin(-1.0 * to_second);
    quadric.matrix() += first.matrix;
    quadric.matrix() -= shared.matrix;
    return {quadric, first.doubled_area + second.doubled_area - shared.doubled_area,
            dot(second.doubled_area, to_second)};
  }

  /// Returns the weighted sum of the squared distances of x to the planes around the pair.
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.current.quadric(x - pair.first);
  }

  /// Orders pairs of equal cost: see CostPolicy.
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return tie_break_of(pair)(x - pair.first);
  }

  /// Returns the position of least cost among those that keep the volume, if it exists.
  std::optional<Vector<3>> minimizer(const auto& pair) const {
    const PairCurrent& current = pair.current;
    std::optional<Vector<3>> x =
        tie_break_of(pair).minimizer(current.quadric, current.normal, current.offset);
    if (x)
      *x += pair.first;
    return x;
  }

  /// Returns the square of the root mean square distance to the planes around the pair.
  double squared_error(const auto& pair, double cost) const {
    const double weight = pair.current.quadric.trace();
    return weight > 0 ? cost / weight : 0;
  }

  /// Throws std::invalid_argument for a weight that is negative, infinite or not a number.
  void validate() const {
    internal::require_weight("quadrille::MemorylessQuadric", "boundary_weight", boundary_weight);
  }

private:
  static internal::TieBreak<3> tie_break_of(const auto& pair) {
    return {pair.current.quadric.trace(), pair.second - pair.first};
  }
};

/// A MemorylessQuadric that preserves thin features (legs, horns, handles) at low counts. The faces
/// of a feature that has become thin have little area, so their planes hardly add to the cost of
/// removing it; the planes of the faces that they have replaced do. The state of a vertex therefore
/// accumulates the planes of its input faces, as with Quadric, and a contraction costs more if it
/// is a *feature loss*: if the sum of the squared distances to the accumulated planes grows by more
/// than a fraction of the square of their area.
///
/// The cost uses the cost C of MemorylessQuadric with plain areas, the accumulated quadrics Q of
/// the ends a and b, and A, a third of their trace. This is the area of the faces, since three
/// vertices accumulate each face:
///
///     C(x) + loss_weight · max(0, Q(x) − Qa(a) − Qb(b) − 3 (loss_tolerance · A)²)
///
/// Neither factor has a unit. The position of least cost is always that of C. It takes up to a
/// third more time than MemorylessQuadric, and 88 more bytes per vertex. With RelaxedOrder::refresh
/// the state only goes back to the last pass.
///
/// As with MemorylessQuadric the error in Status and Report is that of single contractions; it
/// includes a feature loss as the cost does. Boundaries are treated as in MemorylessQuadric.
struct ThinFeatureQuadric : MemorylessQuadric {
  using ScaleFree = ThinFeatureQuadric; ///< scale-invariant: see CostPolicy
  using TieBreak = ThinFeatureQuadric;  ///< has the scale of this class's values
  using TwoLanes = ThinFeatureQuadric;  ///< pairs may be costed two at a time: see CostPolicy

  double loss_weight = 3;       ///< at least 0
  double loss_tolerance = 0.15; ///< at least 0; with a higher value only larger losses count

  static constexpr double tolerated_rise = 1;   ///< a higher value loses some legs
  static constexpr double tolerated_fall = 0.5; ///< as in MemorylessQuadric

  /// Returns the power of lengths with which the cost grows.
  double degree() const { return 4; }

  /// The accumulated planes of the input faces of a vertex.
  struct State {
    QuadricForm<3> planes; ///< relative to the vertex
    double before = 0;     ///< for a pair: the cost of the planes at its two ends

    /// Adds the state of another vertex, with the same origin.
    State& operator+=(const State& other) {
      planes += other.planes;
      return *this;
    }
    /// Subtracts the state of one of several tiles of a surface, with the same origin.
    State& operator-=(const State& other) {
      planes -= other.planes;
      return *this;
    }
    void move_origin(const Vector<3>& d) { planes.move_origin(d); } ///< as QuadricForm::move_origin
    /// Does the same as QuadricForm::sum_about_first, and adds the cost of both at their positions.
    static State sum_about_first(const State& first, const State& second, const Vector<3>& d) {
      return {QuadricForm<3>::sum_about_first(first.planes, second.planes, d),
              first.planes.constant() + second.planes.constant()};
    }
  };
  /// Returns the plane of an input face, weighted with its area.
  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return {Quadric{}.face(p, q, r)};
  }

  /// Returns the weight of a face for attributes.
  static double channel_weight(double area) { return area; }
  /// Does the same as in MemorylessQuadric, with plain areas.
  Current current_face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return weighted_face(p, q, r, [](double) { return 1.0; });
  }
  /// Does the same as in MemorylessQuadric, with plain squares.
  Current current_boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return {Quadric::constraint_plane(p, q, r, boundary_weight).matrix(), {}};
  }

  /// Returns the cost of MemorylessQuadric with plain areas, plus that of the loss.
  double operator()(const auto& pair, const Vector<3>& x) const {
    const QuadricForm<3>& planes = pair.state.planes;
    return MemorylessQuadric::operator()(pair, x) +
           loss(planes(x - pair.first) - pair.state.before, planes.trace());
  }

  /// Returns the cost of a growth of the accumulated planes' cost by `growth`, for planes with this
  /// trace.
  template <class Number>
  Number loss(const Number& growth, const Number& trace) const {
    const Number excess = growth - loss_tolerance * loss_tolerance / 3 * trace * trace;
    return internal::select(excess > Number{}, loss_weight * excess, Number{});
  }

  /// Throws std::invalid_argument for a weight or a tolerance that is negative, infinite or not a
  /// number.
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
