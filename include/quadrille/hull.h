#ifndef QUADRILLE_HULL_H
#define QUADRILLE_HULL_H

#include <quadrille/internal/guards/hull/half_spaces.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The side of a surface on which it may grow.
enum class Side { outer, inner };

namespace internal {

/// The quadric of a pair about its first end, for costs that have one.
template <class Pair>
concept SeesQuadric = requires(const Pair& pair) {
  { pair.current.quadric } -> std::convertible_to<QuadricForm<3>>;
};
template <class Pair>
concept AccumulatesQuadric = requires(const Pair& pair) {
  { pair.state } -> std::convertible_to<QuadricForm<3>>;
};

/// A set of half-spaces; a small set needs no memory of its own.
class HalfSpaces {
public:
  explicit HalfSpaces(std::size_t most) {
    if (most > few_.size())
      many_.resize(most);
  }
  void push_back(const HalfSpace& h) { data()[size_++] = h; }
  std::span<const HalfSpace> all() const {
    return {many_.empty() ? few_.data() : many_.data(), size_};
  }

private:
  HalfSpace* data() { return many_.empty() ? few_.data() : many_.data(); }

  std::array<HalfSpace, 24> few_;
  std::vector<HalfSpace> many_;
  std::size_t size_ = 0;
};

} // namespace internal

/// Placement and filter in one: each contraction only adds to the volume that the surface encloses,
/// so that the result encloses the input. `OuterHull` is `Hull<Side::outer>`. `InnerHull` is the
/// opposite: no point has a greater winding number in the result than in the input. This alone does
/// not keep the result inside: a wall that is thinner than what contractions remove turns inside
/// out, and points that no surface enclosed get −1. Together with NoSelfIntersection this cannot
/// happen, so the result lies inside an input that does not intersect itself; the simplification
/// ends when no such pair is left. Pass both.
///
/// The pair goes to the position of least cost on the outer side of the planes of all faces around
/// it, including those that vanish. Each tetrahedron of such a face and the new vertex is then
/// oriented positively or flat, by an exact predicate and for the coordinates as they are written.
/// If rounding prevents this, the position moves outward by one rounding error, and by eight times
/// as much in each further step. If there is no such position within the distance of the farthest
/// neighbour, the pair is rejected (Rejection::hull).
///
/// *Why the result encloses the input.* Let S be the faces around the pair, oriented, and C the
/// faces of the new vertex, a cone over the same boundary. S and C together bound the tetrahedra of
/// the faces of S and the new vertex. If these are oriented positively, the winding number of every
/// point grows by the number of tetrahedra in which it lies, and never falls. So each point of
/// winding number 1 or more keeps such a number, even where the surface intersects itself. For
/// InnerHull the winding number never grows, and if the surface cannot turn inside out it never
/// becomes negative.
///
/// The surface must be closed and oriented: each edge has as many faces on one side as on the
/// other. Otherwise std::invalid_argument is thrown, with the number of edges that do not; it is
/// also thrown for a surface that is oriented inwards as a whole, and for free topology. Components
/// may lie inside others. Positions are rounded to floats if the points of the mesh are floats, or
/// with coordinates_are_floats.
///
/// It works with Quadric, MemorylessQuadric or ThinFeatureQuadric, and GreedyOrder. This header
/// includes CGAL's kernel of exact predicates (LGPL).
///
/// Source: Sander, Gu, Gortler, Hoppe and Snyder, Silhouette clipping, 2000 (progressive hulls).
template <Side side>
class Hull {
public:
  using ScaleFree = Hull;                             ///< scale-invariant
  using Estimate = OptimalPlacement;                  ///< orders pairs until they are contracted
  static constexpr bool looks_at_star = true;         ///< the faces around the pair decide the
                                                      ///< position
  static constexpr bool asks_for_volume = true;       ///< Report contains the volume
  static constexpr bool needs_closed_surface = true;  ///< other surfaces are rejected
  static constexpr Rejection cause = Rejection::hull; ///< counts its rejections

  /// Returns the estimate by which pairs are ordered: the position of least cost on any side.
  template <class Cost, class Pair>
  requires HasMinimizer<Cost, Pair>
  auto operator()(const Cost& cost, const Pair& pair) const {
    return OptimalPlacement{}(cost, pair);
  }

  /// The typical cost with this placement is 1.5 to 5 times the cost with OptimalPlacement.
  static constexpr double rise_of_estimate = 1.5;

  /// Returns the position of least cost, up to rounding.
  template <class Cost, class Pair, class Star>
  std::optional<Vector<3>> resolve(const Cost&, const Pair& pair, const Star& star) const {
    const Planes<Pair, Star> planes(pair, star);
    const std::optional<Vector<3>> x = planes.least_of_all();
    return x ? x : planes.least_within(planes.rounding());
  }

  /// Returns whether the position lies on the right side of all planes, exactly.
  template <class Pair, class Star>
  bool admits(const Pair&, const Star& star, const Vector<3>& x) const {
    return star.all_faces([&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
      return x == p || x == q || x == r ||
             CGAL::orientation(exact(p), exact(q), exact(r), exact(x)) != forbidden;
    });
  }

  /// Returns whether the predicate holds for a position further out, if rounding prevents it here.
  template <class Cost, class Pair, class Star, class Predicate>
  bool any_further(const Cost&, const Pair& pair, const Star& star, Predicate predicate) const {
    const Planes<Pair, Star> planes(pair, star);
    double margin = planes.rounding();
    for (int step = 0; step < most_steps; ++step, margin *= 8)
      if (const auto x = planes.least_within(margin); x && predicate(*x))
        return true;
    return false;
  }

  /// Works as OptimalPlacement::any_equal.
  template <class Cost, class Pair, class Predicate>
  static bool any_equal(const Cost& cost, const Pair& pair, const auto& x, Predicate predicate) {
    return OptimalPlacement::any_equal(cost, pair, x, predicate);
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  static constexpr int most_steps = 6;
  static constexpr double sign = side == Side::outer ? 1 : -1;
  static constexpr CGAL::Orientation forbidden =
      side == Side::outer ? CGAL::NEGATIVE : CGAL::POSITIVE;

  static Kernel::Point_3 exact(const Vector<3>& p) { return {p[0], p[1], p[2]}; }

  // The quadratic program of a pair: its quadric and the half-spaces of its faces.
  template <class Pair, class Star>
  class Planes {
  public:
    Planes(const Pair& pair, const Star& star)
        : Planes(pair, star, quadric_of(pair), internal::shape_weight * quadric_of(pair).trace()) {}
    Planes(const Pair& pair, const Star& star, const QuadricForm<3>& quadric, double weight)
        : pair_(pair), star_(star), half_spaces_(star.size()),
          least_(quadric.minimizer_near(0.5 * (pair.second - pair.first), weight)),
          hessian_(regular(quadric.matrix(), weight)) {
      double size = 0;
      star.for_each_face([&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
        add(p, q, r);
        size = (std::max)({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
      });
      rounding_ = 0x1p-45 * std::sqrt(pair.squared_ring_radius) + 8 * star.rounding(size);
    }

    // Returns a distance above the rounding errors, and usually above what a predicate in doubles
    // can decide.
    double rounding() const { return rounding_; }

    /// Returns the position of least cost if it lies within all half-spaces up to rounding, or an
    /// end of the pair if this is next to it.
    std::optional<Vector<3>> least_of_all() const {
      if (!least_)
        return std::nullopt;
      for (const internal::HalfSpace& h : half_spaces_.all())
        if (h.offset - dot(h.normal, *least_) > tolerance())
          return std::nullopt;
      const Vector<3> x = pair_.first + *least_;
      for (const Vector<3>& end : {pair_.first, pair_.second})
        if (squared_distance(end, x) <= 0x1p-60 * pair_.squared_ring_radius)
          return end;
      return written(x);
    }

    /// Returns the position of least cost that is at least `margin` inside all half-spaces.
    std::optional<Vector<3>> least_within(double margin) const {
      if (!least_ || hessian_.is_singular())
        return std::nullopt;
      const auto x =
          internal::LeastInHalfSpaces(half_spaces_.all(), hessian_, margin, tolerance())(*least_);
      return x ? written(pair_.first + *x) : std::nullopt;
    }

  private:
    void add(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
      const Vector<3> normal = double_area_vector(p, q, r);
      const double length = std::sqrt(squared_length(normal));
      if (!(length > 0))
        return;
      const Vector<3> unit = sign / length * normal;
      half_spaces_.push_back({unit, dot(unit, p - pair_.first)});
    }

    static QuadricForm<3> quadric_of(const Pair& pair) {
      static_assert(
          internal::SeesQuadric<Pair> || internal::AccumulatesQuadric<Pair>,
          "OuterHull and InnerHull need a cost with a quadric: use Quadric, MemorylessQuadric "
          "or ThinFeatureQuadric.");
      if constexpr (internal::SeesQuadric<Pair>)
        return pair.current.quadric;
      else
        return pair.state;
    }

    static SymmetricMatrix<3> regular(SymmetricMatrix<3> matrix, double weight) {
      matrix.add_to_diagonal(weight);
      return matrix;
    }

    double tolerance() const { return 0.25 * rounding_; }

    std::optional<Vector<3>> written(const Vector<3>& position) const {
      const Vector<3> x = star_.as_written(position);
      if ((std::min)(squared_distance(x, pair_.first), squared_distance(x, pair_.second)) <=
          pair_.squared_ring_radius)
        return x;
      return std::nullopt;
    }

    const Pair& pair_;
    const Star& star_;
    internal::HalfSpaces half_spaces_;
    std::optional<Vector<3>> least_; // from the first end
    Factorization<3> hessian_;
    double rounding_ = 0;
  };
};

using OuterHull = Hull<Side::outer>; ///< its result encloses the input
/// The result is enclosed by the input if NoSelfIntersection is passed too.
using InnerHull = Hull<Side::inner>;

} // namespace quadrille

#endif // QUADRILLE_HULL_H
