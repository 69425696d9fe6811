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

/// Of the ends of a pair, beside the planes that it remembers. See TieBreak.
inline constexpr double shape_weight = 1e-9;

/// What decides between pairs, and between positions, that planes leave equal: the sum of the
/// squared distances to the two ends, with a billionth of the weight of the planes. It belongs to
/// the order of pairs and to the choice of a position, not to the cost, and is forgotten then.
template <std::size_t N>
class TieBreak {
public:
  /// `trace` is that of the planes' matrix; the ends of the pair are `to_second` apart.
  TieBreak(double trace, const Vector<N>& to_second)
      : weight_(shape_weight * trace), to_second_(to_second) {}

  /// At a position x from the first end.
  double operator()(const Vector<N>& x) const {
    return 0.5 * weight_ * (squared_length(x) + squared_distance(x, to_second_));
  }

  /// The position of least cost by the planes alone, and of those the one that this prefers, from
  /// the first end.
  std::optional<Vector<N>> minimizer(const QuadricForm<N>& planes) const {
    return planes.minimizer_near(0.5 * to_second_, weight_);
  }
  /// The same on the plane normal · x = offset, if the normal has a length.
  std::optional<Vector<N>> minimizer(const QuadricForm<N>& planes, const Vector<N>& normal,
                                     double offset) const {
    return planes.minimizer_near_on_plane(0.5 * to_second_, weight_, normal, offset);
  }

private:
  double weight_;
  Vector<N> to_second_;
};

} // namespace internal

/// How much the plane of a face counts.
enum class Weighting {
  by_area, ///< as its area: the error does not depend on how a surface is cut into triangles
  uniform, ///< as one, the scheme of the 1997 paper
  /// As the square of its area, the triangle quadric: the square of three times the volume of the
  /// tetrahedron between the face and a position (the volume optimisation of Lindstrom and Turk
  /// 1998). For Quadric. Large faces count more, small ones less.
  by_squared_area
};

/// The cost of Garland and Heckbert: a vertex remembers the planes of the faces that have gone into
/// it, as a sum of quadrics, and a position costs the weighted sum of its squared distances to
/// them.
///
/// A boundary edge adds the squared distance to its line, weighted with boundary_weight · |edge|²,
/// so that it scales as the areas do; along the normal of its face a distance counts half. The
/// constraint plane of the paper, perpendicular to the face, holds within the surface only: where a
/// rim is jagged and the surface noisy, such planes meet in lines that lean along the normal, and a
/// vertex slides up one of these to satisfy planes that contradict each other by d, at worst by
/// d / (2β) where a distance along the normal counts β times. With a half it is no more than d.
/// Quadrics are kept about their vertices, where a new plane has neither a linear nor a constant
/// term.
///
/// Where the planes leave a direction free (a flat part, a straight crease), positions that cost
/// the same are told apart by their distances to the two ends of the pair, so flat parts keep an
/// even triangulation and the system to be solved is never singular by rounding. This is no part of
/// the cost: simplifying a flat part has an error of 0, up to rounding.
///
/// Beside planes a vertex may remember lines and noise, which are 0 by default and then cost
/// nothing: the manual says when they help, and what they do on ten models. Errors that are told
/// count them as if they were distances to planes.
///
/// - `line_weight` l: a vertex of the input whose planes have the weight w in sum adds l · w times
///   the squared distance to the line through it along its normal. It holds vertices within flat
///   and noisy parts, which makes better triangles.
/// - `normal_noise` s: the normal n of each face is taken for a random vector with the variance s²
///   in each direction, so that its plane through the vertex p costs (n · (x − p))² + s² |x − p|²
///   in the mean.
/// - `position_noise` t: so is the place of each plane, with the variance t²; it then costs
///   (1 + 3s²) t² more, wherever it is, so that what has few planes comes first.
///
/// Source: Garland and Heckbert, Surface Simplification Using Quadric Error Metrics, 1997, sections
/// 4 to 6; area weights and the squared edge length: Garland's thesis, 1999. Lines: Liu, Rahimzadeh
/// and Zordan, Controlling Quadric Error Simplification with Line Quadrics, 2025: Qᵢ + wᵢ aᵢ Qᵢˡ.
/// Noise: Trettner and Kobbelt, Fast and Robust QEF Minimization using Probabilistic Quadrics,
/// 2020: the probabilistic plane quadric, A = n nᵀ + Σₙ and c = nᵀ Σₚ n + tr(Σₙ Σₚ) about p.
struct Quadric {
  static constexpr std::size_t dimension = 3; ///< positions only
  using ScaleFree = Quadric;                  ///< as well in any unit: see CostPolicy
  using TieBreak = Quadric;                   ///< on the scale of the values of this class
  using TwoLanes = Quadric;                   ///< pairs may be costed two at a time: see CostPolicy
  using State = QuadricForm<3>;               ///< planes, about the vertex

  double boundary_weight = 100; ///< at least 0; 0 lets boundaries recede
  double crease_weight = 100;   ///< the same for each of the two faces of a crease
  double crease_degrees = 180;  ///< an edge is a crease if its normals differ by more; 180: none is
  Weighting weighting = Weighting::by_area; ///< how much each plane counts
  double line_weight = 0;  ///< of lines along vertex normals: at least 0; 0.001 is little, 0.1 much
  double normal_noise = 0; ///< standard deviation of unit normals, at least 0; 0.1 is 6 degrees
  double position_noise = 0; ///< the same of places, a length in the mesh's unit, at least 0

  /// Throws std::invalid_argument for a weight or an angle that makes no sense.
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

  /// Values grow with that power of lengths.
  double degree() const {
    return weighting == Weighting::by_area ? 4 : weighting == Weighting::by_squared_area ? 6 : 2;
  }

  /// What a face pqr leaves at each of its corners. Nothing for a face without a normal.
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
  /// All corners of a face get the same plane.
  static constexpr bool face_is_alike_at_corners = true;

  /// Does a vertex leave anything itself?
  bool has_vertex_terms() const {
    return line_weight > 0 || normal_noise > 0 || position_noise > 0;
  }
  /// What it leaves: a line along its normal, of any length, and noise. `planes` are those that its
  /// faces leave.
  State vertex(const State& planes, const Vector<3>& normal) const {
    const double weight = planes.trace(); // of unit normals
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
  /// Takes lengths to another unit: see CostPolicy.
  void convert_lengths(const auto& convert) { position_noise = convert(position_noise); }

  /// What the boundary edge pq of a face pqr leaves at both of its ends.
  State boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return constraint_line(p, q, r, boundary_weight * emphasis(p, q));
  }

  /// What a crease pq leaves at both of its ends for its face pqr.
  State crease(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return constraint_line(p, q, r, crease_weight * emphasis(p, q));
  }

  /// The weighted sum of the squared distances of x to the planes that both ends remember.
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.state(x - pair.first);
  }

  /// Tells pairs of equal costs apart: see CostPolicy.
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return tie_break_of(pair)(x - pair.first);
  }

  /// The position of least cost, if there is one.
  std::optional<Vector<3>> minimizer(const auto& pair) const {
    std::optional<Vector<3>> x = tie_break_of(pair).minimizer(pair.state);
    if (x)
      *x += pair.first;
    return x;
  }

  /// The square of the root mean square distance to the planes: see Report::error.
  double squared_error(const auto& pair, double cost) const {
    const double weight = pair.state.trace(); // a plane of unit normal has a trace of its weight
    return weight > 0 ? cost / weight : 0;
  }

  /// The squared distance to the line pq, about p, with weight · |pq|²; along the normal of pqr a
  /// distance counts half.
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

  /// The plane through the edge pq and perpendicular to the face pqr, about p, with weight · |pq|².
  static State constraint_plane(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r,
                                double weight) {
    const Vector<3> normal = normal_vector(p, q, r);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return {};
    // edge × unit normal is as long as the edge: its square brings the weight's |pq|²
    return State::plane(cross(q - p, normal), weight / squared);
  }

private:
  // So that edges scale as faces do.
  double emphasis(const Vector<3>& p, const Vector<3>& q) const {
    return weighting == Weighting::by_squared_area ? squared_distance(p, q) : 1;
  }

  static internal::TieBreak<3> tie_break_of(const auto& pair) {
    return {pair.state.trace(), pair.second - pair.first};
  }
};

} // namespace quadrille

#endif // QUADRILLE_QUADRIC_H
