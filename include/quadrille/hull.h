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
concept RemembersQuadric = requires(const Pair& pair) {
  { pair.memory } -> std::convertible_to<QuadricForm<3>>;
};

/// Half-spaces, few of which take no memory of their own.
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

/// Placement and filter in one: each contraction adds to what the surface encloses and takes
/// nothing away, so that the result encloses the input. `OuterHull` is `Hull<Side::outer>`.
/// `InnerHull` is the same the other way round: no point has a greater winding number in the result
/// than in the input. That alone does not keep it inside: where a wall is thinner than what
/// contractions take away, it turns over, and points that neither enclosed have −1. Beside
/// NoSelfIntersection it does not, so of an input that does not intersect itself the result lies
/// inside; it ends where that leaves no pair. Pass both.
///
/// The pair goes to the position of least cost on the outer side of the planes of all faces around
/// it, those that vanish too. Each tetrahedron of such a face and the new vertex is then oriented
/// positively or flat, by an exact predicate and for coordinates as they are written; where
/// rounding is in the way, the position moves outward by a rounding, and by eight times as much
/// each time. Where there is no such position within the distance of the farthest neighbour, the
/// pair is refused (Rejection::hull).
///
/// *Why the result encloses the input.* Let S be the faces around the pair, oriented, and C the
/// faces of the new vertex, a cone over the same border. S and C together bound the tetrahedra of
/// the faces of S and the new vertex. If these are oriented positively, the winding number of every
/// point grows by the number of tetrahedra in which it lies, and never falls. So each point of
/// winding number 1 or more keeps one, even where the surface passes through itself. The other way
/// round it never grows, and where the surface cannot turn over none becomes negative.
///
/// The surface has to be closed and oriented: each edge has as many faces on one side as on the
/// other, else std::invalid_argument says how many do not, as for a surface that is oriented
/// inwards as a whole, and for topology that is free. Parts may lie inside of others. Places are
/// rounded to floats where the points of the mesh are of floats, or with coordinates_are_floats.
///
/// With Quadric, MemorylessQuadric or ThinFeatureQuadric, and GreedyOrder. This header includes
/// CGAL's kernel of exact predicates (LGPL).
///
/// Source: Sander, Gu, Gortler, Hoppe and Snyder, Silhouette clipping, 2000 (progressive hulls).
template <Side side>
class Hull {
public:
  using ScaleFree = Hull;                             ///< as well in any unit of length
  using Guess = OptimalPlacement;                     ///< orders pairs until their turn
  static constexpr bool looks_at_star = true;         ///< the place is settled by the faces around
  static constexpr bool asks_for_volume = true;       ///< Report tells the volume
  static constexpr bool needs_closed_surface = true;  ///< others are refused
  static constexpr Rejection cause = Rejection::hull; ///< what refusals count as

  /// The guess by which pairs are ordered: the position of least cost on any side.
  template <class Cost, class Pair>
  requires HasMinimizer<Cost, Pair>
  auto operator()(const Cost& cost, const Pair& pair) const {
    return OptimalPlacement{}(cost, pair);
  }

  /// What a contraction costs by this, as a rule, is 1.5 to 5 times what OptimalPlacement costs.
  static constexpr double rise_of_guess = 1.5;

  /// The position of least cost, up to rounding.
  template <class Cost, class Pair, class Star>
  std::optional<Vector<3>> settle(const Cost&, const Pair& pair, const Star& star) const {
    const Planes<Pair, Star> planes(pair, star);
    const std::optional<Vector<3>> x = planes.least_of_all();
    return x ? x : planes.least_within(planes.rounding());
  }

  /// Does it lie on the right side of all planes, exactly?
  template <class Pair, class Star>
  bool admits(const Pair&, const Star& star, const Vector<3>& x) const {
    return star.all_faces([&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
      return x == p || x == q || x == r ||
             CGAL::orientation(exact(p), exact(q), exact(r), exact(x)) != forbidden;
    });
  }

  /// Does the predicate hold of a position further out, where rounding may be in the way?
  template <class Cost, class Pair, class Star, class Predicate>
  bool any_further(const Cost&, const Pair& pair, const Star& star, Predicate predicate) const {
    const Planes<Pair, Star> planes(pair, star);
    double margin = planes.rounding();
    for (int step = 0; step < most_steps; ++step, margin *= 8)
      if (const auto x = planes.least_within(margin); x && predicate(*x))
        return true;
    return false;
  }

  /// As OptimalPlacement::any_equal.
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

  // The quadratic programme of a pair: its quadric, and the half-spaces of its faces.
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
      rounding_ = 0x1p-45 * std::sqrt(pair.squared_reach) + 8 * star.rounding(size);
    }

    // More than rounding amounts to, and than a predicate in doubles can tell, as a rule.
    double rounding() const { return rounding_; }

    /// The position of least cost, if it lies within all half-spaces up to rounding: an end of the
    /// pair itself, if it is next to that.
    std::optional<Vector<3>> least_of_all() const {
      if (!least_)
        return std::nullopt;
      for (const internal::HalfSpace& h : half_spaces_.all())
        if (h.offset - dot(h.normal, *least_) > tolerance())
          return std::nullopt;
      const Vector<3> x = pair_.first + *least_;
      for (const Vector<3>& end : {pair_.first, pair_.second})
        if (squared_distance(end, x) <= 0x1p-60 * pair_.squared_reach)
          return end;
      return written(x);
    }

    /// The position of least cost that lies so far within all half-spaces.
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
      static_assert(internal::SeesQuadric<Pair> || internal::RemembersQuadric<Pair>,
                    "OuterHull and InnerHull need a cost with a quadric: use Quadric, "
                    "MemorylessQuadric or ThinFeatureQuadric.");
      if constexpr (internal::SeesQuadric<Pair>)
        return pair.current.quadric;
      else
        return pair.memory;
    }

    static SymmetricMatrix<3> regular(SymmetricMatrix<3> matrix, double weight) {
      matrix.add_to_diagonal(weight);
      return matrix;
    }

    double tolerance() const { return 0.25 * rounding_; }

    std::optional<Vector<3>> written(const Vector<3>& position) const {
      const Vector<3> x = star_.as_written(position);
      if ((std::min)(squared_distance(x, pair_.first), squared_distance(x, pair_.second)) <=
          pair_.squared_reach)
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
/// Beside NoSelfIntersection its result is enclosed by the input.
using InnerHull = Hull<Side::inner>;

} // namespace quadrille

#endif // QUADRILLE_HULL_H
