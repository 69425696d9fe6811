#ifndef QUADRILLE_QUADRIC_H
#define QUADRILLE_QUADRIC_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric_form.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace quadrille {

namespace internal {

inline void require_weight(const char* policy, const char* name, double weight) {
  if (!(weight >= 0) || !std::isfinite(weight))
    throw std::invalid_argument(std::string(policy) + ": " + name + " " +
                                internal::text_of(weight) + " is negative or not finite");
}

/// The weight of the distances to the ends of a pair, relative to the accumulated planes. See
/// TieBreak.
inline constexpr double shape_weight = 1e-9;

/// Orders pairs, and positions, that the planes leave equal: the sum of the squared distances to
/// the two ends, with a billionth of the weight of the planes. It affects the order of pairs and
/// the choice of a position, but not the cost, and is not accumulated.
template <std::size_t N>
class TieBreak {
public:
  /// `trace` is the trace of the planes' matrix; `to_second` is the vector between the ends of the
  /// pair.
  TieBreak(double trace, const Vector<N>& to_second)
      : weight_(shape_weight * trace), to_second_(to_second) {}

  /// Evaluates the tie break at a position x relative to the first end.
  double operator()(const Vector<N>& x) const {
    return 0.5 * weight_ * (squared_length(x) + squared_distance(x, to_second_));
  }

  /// Returns the position of least cost by the planes alone, relative to the first end; among
  /// several, the one that this tie break prefers.
  std::optional<Vector<N>> minimizer(const QuadricForm<N>& planes) const {
    return planes.minimizer_near(0.5 * to_second_, weight_);
  }
  /// Returns the position of least cost on the plane normal · x = offset, if the normal is not
  /// zero.
  std::optional<Vector<N>> minimizer(const QuadricForm<N>& planes, const Vector<N>& normal,
                                     double offset) const {
    return planes.minimizer_near_on_plane(0.5 * to_second_, weight_, normal, offset);
  }

private:
  double weight_;
  Vector<N> to_second_;
};

} // namespace internal

/// The weight of the plane of a face.
enum class Weighting {
  by_area, ///< the area: the error does not depend on how a surface is triangulated
  uniform, ///< one, the scheme of the 1997 paper
  /// The square of the area, the triangle quadric: the cost is the square of three times the volume
  /// of the tetrahedron between the face and a position (the volume optimization of Lindstrom and
  /// Turk 1998). It is for Quadric. Large faces count more, small ones less.
  by_squared_area
};

/// The cost of Garland and Heckbert: the state of a vertex is the sum of the quadrics of the faces
/// that were merged into it, and the cost of a position is the weighted sum of its squared
/// distances to their planes.
///
/// A boundary edge adds the squared distance to its line, weighted with boundary_weight · |edge|²,
/// so that it scales as the areas do; a distance along the normal of its face counts half. The
/// constraint plane of the paper, perpendicular to the face, only constrains a vertex within the
/// surface. Where a boundary is jagged and the surface noisy, such planes meet in lines that lean
/// along the normal. A vertex slides up such a line to satisfy planes that contradict each other by
/// d, at worst by d / (2β) if a distance along the normal counts β times. With β = 1/2 this is at
/// most d. Quadrics are stored relative to their vertices, where a new plane has neither a linear
/// nor a constant term.
///
/// If the planes leave a direction free (in a flat region, along a straight crease), positions
/// of equal cost are ordered by their distances to the two ends of the pair. So flat regions keep
/// an even triangulation, and the linear system never becomes singular by rounding. This does not
/// change the cost: simplifying a flat region has an error of 0, up to rounding.
///
/// In addition to planes, the state may include lines and noise, which are off by default, at no
/// cost. The manual says when they help, and shows their effect on ten models. Reported errors
/// include them as if they were distances to planes.
///
/// - `line_weight` l: an input vertex whose planes have the total weight w adds l · w times the
///   squared distance to the line through it along its normal. This constrains vertices within flat
///   and noisy regions and improves the shape of triangles.
/// - `normal_noise` s: the normal n of each face is a random vector with the variance s² in each
///   direction, so that its plane through the vertex p has the mean cost (n · (x − p))² + s² |x −
///   p|².
/// - `position_noise` t: the position of each plane is random too, with the variance t². This adds
///   (1 + 3s²) t² to the cost everywhere, so that regions with few faces are simplified first.
///
/// Source: Garland and Heckbert, Surface Simplification Using Quadric Error Metrics, 1997, sections
/// 4 to 6; area weights and the squared edge length: Garland's thesis, 1999. Lines: Liu, Rahimzadeh
/// and Zordan, Controlling Quadric Error Simplification with Line Quadrics, 2025: Qᵢ + wᵢ aᵢ Qᵢˡ.
/// Noise: Trettner and Kobbelt, Fast and Robust QEF Minimization using Probabilistic Quadrics,
/// 2020: the probabilistic plane quadric, A = n nᵀ + Σₙ and c = nᵀ Σₚ n + tr(Σₙ Σₚ) about p.
struct Quadric {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = Quadric;                  ///< scale-invariant: see CostPolicy
  using TieBreak = Quadric;                   ///< has the scale of this class's values
  using TwoLanes = Quadric;                   ///< pairs may be costed two at a time: see CostPolicy
  using State = QuadricForm<3>;               ///< planes, relative to the vertex

  double boundary_weight = 100; ///< at least 0; 0 lets boundaries recede
  double crease_weight = 100;   ///< at least 0; applies to each of the two faces of a crease
  double crease_degrees = 180;  ///< an edge is a crease if its normals differ by more; with 180
                                ///< there is none
  Weighting weighting = Weighting::by_area; ///< the weight of each plane
  double line_weight = 0;    ///< the weight of lines along vertex normals: at least 0; 0.001 is
                             ///< little, 0.1 much
  double normal_noise = 0;   ///< standard deviation of unit normals, at least 0; 0.1 is 6 degrees
  double position_noise = 0; ///< standard deviation of positions, in the mesh's unit, at least 0

  /// Throws std::invalid_argument for a weight or an angle that is out of range.
  void validate() const {
    internal::require_weight("quadrille::Quadric", "boundary_weight", boundary_weight);
    internal::require_weight("quadrille::Quadric", "crease_weight", crease_weight);
    if (!(crease_degrees >= 0 && crease_degrees <= 180))
      throw std::invalid_argument("quadrille::Quadric: crease_degrees " +
                                  internal::text_of(crease_degrees) + " is not in [0, 180]");
    internal::require_weight("quadrille::Quadric", "line_weight", line_weight);
    internal::require_weight("quadrille::Quadric", "normal_noise", normal_noise);
    internal::require_weight("quadrille::Quadric", "position_noise", position_noise);
  }

  /// Returns the power of lengths with which the cost grows.
  double degree() const {
    return weighting == Weighting::by_area ? 4 : weighting == Weighting::by_squared_area ? 6 : 2;
  }

  /// Returns the contribution of a face pqr at each of its corners; zero for a face without a
  /// normal.
  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    const Vector<3> normal = normal_vector(p, q, r);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return {};
    const double weight = weighting == Weighting::by_area           ? std::sqrt(squared) / 2
                          : weighting == Weighting::by_squared_area ? squared / 4
                                                                    : 1;
    return State::plane(normal, weight / squared);
  }
  /// The plane of a face is the same at all its corners.
  static constexpr bool face_is_alike_at_corners = true;

  /// Returns whether vertices contribute terms of their own.
  bool has_vertex_terms() const {
    return line_weight > 0 || normal_noise > 0 || position_noise > 0;
  }
  /// Returns the contribution of a vertex: a line along its normal, which may have any length, and
  /// noise. `planes` is the contribution of its faces.
  State vertex(const State& planes, const Vector<3>& normal) const {
    const double weight = planes.trace(); // for unit normals
    const double s2 = normal_noise * normal_noise, t2 = position_noise * position_noise;
    SymmetricMatrix<3> a;
    a.add_to_diagonal(s2 * weight);
    State terms(a, {}, (1 + 3 * s2) * t2 * weight);
    if (const double squared = squared_length(normal); squared > 0) {
      terms += State::point(line_weight * weight);
      terms += State::plane(normal, -line_weight * weight / squared);
    }
    return terms;
  }
  /// Converts lengths to another unit: see CostPolicy.
  void convert_lengths(const auto& convert) { position_noise = convert(position_noise); }

  /// Returns the contribution of the boundary edge pq of a face pqr at both of its ends.
  State boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return constraint_line(p, q, r, boundary_weight * emphasis(p, q));
  }

  /// Returns the contribution of a crease pq at both of its ends for its face pqr.
  State crease(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return constraint_line(p, q, r, crease_weight * emphasis(p, q));
  }

  /// Returns the weighted sum of the squared distances of x to the planes accumulated at both ends.
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.state(x - pair.first);
  }

  /// Orders pairs of equal cost: see CostPolicy.
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return tie_break_of(pair)(x - pair.first);
  }

  /// Returns the position of least cost, if it exists.
  std::optional<Vector<3>> minimizer(const auto& pair) const {
    std::optional<Vector<3>> x = tie_break_of(pair).minimizer(pair.state);
    if (x)
      *x += pair.first;
    return x;
  }

  /// Returns the square of the root mean square distance to the planes: see Report::error.
  double squared_error(const auto& pair, double cost) const {
    const double weight = pair.state.trace(); // a plane with a unit normal has its weight as its
                                              // trace
    return weight > 0 ? cost / weight : 0;
  }

  /// Returns the squared distance to the line pq, relative to p, with the weight weight · |pq|²; a
  /// distance along the normal of pqr counts half.
  static State constraint_line(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r,
                               double weight) {
    const Vector<3> normal = normal_vector(p, q, r);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return {};
    State line = constraint_plane(p, q, r, weight);
    line += State::plane(normal, 0.25 * weight * squared_distance(p, q) / squared);
    return line;
  }

  /// Returns the plane through the edge pq and perpendicular to the face pqr, relative to p, with
  /// the weight weight · |pq|².
  static State constraint_plane(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r,
                                double weight) {
    const Vector<3> normal = normal_vector(p, q, r);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return {};
    // The vector edge × unit normal is as long as the edge: its square provides the factor |pq|².
    return State::plane(cross(q - p, normal), weight / squared);
  }

private:
  // Makes edges scale as faces do.
  double emphasis(const Vector<3>& p, const Vector<3>& q) const {
    return weighting == Weighting::by_squared_area ? squared_distance(p, q) : 1;
  }

  static internal::TieBreak<3> tie_break_of(const auto& pair) {
    return {pair.state.trace(), pair.second - pair.first};
  }
};

} // namespace quadrille

#endif // QUADRILLE_QUADRIC_H
