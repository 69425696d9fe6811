#ifndef QUADRILLE_INTERNAL_DISTANCE_BOUND_H
#define QUADRILLE_INTERNAL_DISTANCE_BOUND_H

#include <quadrille/internal/array.h>
#include <quadrille/internal/packing.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/vector.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// How far a contraction takes the faces around a pair away from those that were there, at most.
///
/// Where both the old and the new faces, seen along their mean normal, cover the same polygon just
/// once, their heights above each other are linear between the places where an edge of the one
/// crosses an edge of the other, so the largest is at one of these places or at a vertex. Elsewhere
/// (at borders, at folds) a new face is compared with the face that it was: the distance to a
/// triangle is convex, so it is greatest at the corner that has moved.
class StarDeviation {
public:
  /// The star of the pair ab, and the place x to which it is contracted.
  template <std::size_t N>
  StarDeviation(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
                const Vector<3>& x)
      : origin_(space(positions[a])), x_(x) {
    const auto at = [&](Index v) { return space(positions[v]); };
    for (const StarFace& f : star.first)
      add_changed({at(a), at(f.second), at(f.third)});
    for (const StarFace& f : star.second)
      add_changed({at(b), at(f.second), at(f.third)});
    for (const StarFace& f : star.shared) {
      old_.push_back({at(a), at(f.second), at(f.third)});
      edges_.push_back({at(a), at(f.second)});
      if (f.second == b)
        edges_.push_back({at(b), at(f.third)});
    }
    ends_ = {at(a), at(b)};
  }

  /// Of the i-th changed face: those of the first end come first.
  double of_face(std::size_t i) const {
    using Kernel = CGAL::Simple_cartesian<double>;
    const auto point = [](const Vector<3>& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
    const Triangle& t = old_[i];
    return std::sqrt(CGAL::squared_distance(
        point(x_), Kernel::Triangle_3(point(t.corner), point(t.second), point(t.third))));
  }

  /// Of all of them, if they close up around both ends; nothing where that can't be told, or would
  /// take long.
  std::optional<double> of_star() {
    if (changed_ > most_faces || !choose_plane())
      return std::nullopt;
    const Flat x = project(x_);
    std::size_t turns = 0;
    for (std::size_t i = 0; i < changed_; ++i) {
      const Flat p = project(old_[i].second), q = project(old_[i].third);
      if (!(area(x, p, q) > 0))
        return std::nullopt;
      turns += p.v <= x.v && x.v < q.v;
    }
    for (const Triangle& t : old_)
      if (!(area(project(t.corner), project(t.second), project(t.third)) > 0))
        return std::nullopt;
    if (turns != 1)
      return std::nullopt;
    return greatest_height(x);
  }

private:
  static constexpr std::size_t most_faces = 128; // each meets each

  struct Triangle {
    Vector<3> corner, second, third;
  };
  struct Edge {
    Vector<3> from, to;
  };
  struct Flat {
    double u, v, height;
  };

  // A changed face has one edge of each vertex of the link that begins at its end.
  void add_changed(const Triangle& t) {
    old_.push_back(t);
    edges_.push_back({t.corner, t.second});
    ++changed_;
  }

  bool choose_plane() {
    Vector<3> normal;
    for (const Triangle& t : old_)
      normal += double_area_vector(t.corner, t.second, t.third);
    const double length = std::sqrt(squared_length(normal));
    if (!(length > 0))
      return false;
    normal_ = (1 / length) * normal;
    const std::size_t least = std::abs(normal_[0]) < std::abs(normal_[1])
                                  ? (std::abs(normal_[0]) < std::abs(normal_[2]) ? 0 : 2)
                                  : (std::abs(normal_[1]) < std::abs(normal_[2]) ? 1 : 2);
    Vector<3> axis;
    axis[least] = 1;
    u_ = cross(axis, normal_);
    u_ = (1 / std::sqrt(squared_length(u_))) * u_;
    v_ = cross(normal_, u_);
    return true;
  }

  Flat project(const Vector<3>& p) const {
    const Vector<3> d = p - origin_;
    return {dot(d, u_), dot(d, v_), dot(d, normal_)};
  }

  static double area(const Flat& p, const Flat& q, const Flat& r) {
    return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
  }

  // The height of y above the triangle pqr, if it lies in it.
  static std::optional<double> height_above(const Flat& y, const Flat& p, const Flat& q,
                                            const Flat& r) {
    const double wp = area(y, q, r), wq = area(p, y, r), wr = area(p, q, y);
    if (wp < 0 || wq < 0 || wr < 0 || !(wp + wq + wr > 0))
      return std::nullopt;
    return y.height - (wp * p.height + wq * q.height + wr * r.height) / (wp + wq + wr);
  }

  std::optional<double> greatest_height(const Flat& x) const {
    double greatest = 0;
    const auto see = [&](double height) { greatest = std::max(greatest, std::abs(height)); };

    bool is_covered = false; // the new vertex by an old face
    for (const Triangle& t : old_)
      if (const auto h = height_above(x, project(t.corner), project(t.second), project(t.third))) {
        see(*h);
        is_covered = true;
      }
    std::size_t covered_ends = 0; // the old vertices by new faces
    for (const Vector<3>& end : {ends_.first, ends_.second}) {
      bool is_end_covered = false;
      for (std::size_t i = 0; i < changed_; ++i)
        if (const auto h =
                height_above(project(end), x, project(old_[i].second), project(old_[i].third))) {
          see(*h);
          is_end_covered = true;
        }
      covered_ends += is_end_covered;
    }
    if (!is_covered || covered_ends < 2)
      return std::nullopt;
    for (std::size_t i = 0; i < changed_; ++i)
      for (const Edge& edge : edges_)
        see(height_at_crossing(x, project(old_[i].second), project(edge.from), project(edge.to)));
    return greatest;
  }

  // Of the segment pq above rs where they cross; 0 where they do not.
  static double height_at_crossing(const Flat& p, const Flat& q, const Flat& r, const Flat& s) {
    const double ap = area(r, s, p), aq = area(r, s, q);
    const double ar = area(p, q, r), as = area(p, q, s);
    if ((ap > 0) == (aq > 0) || (ar > 0) == (as > 0))
      return 0;
    const double t = ap / (ap - aq), w = ar / (ar - as);
    return p.height + t * (q.height - p.height) - (r.height + w * (s.height - r.height));
  }

  Vector<3> origin_, x_;
  std::vector<Triangle> old_; // those that change come first
  std::vector<Edge> edges_;   // of the old faces, but for those of the link
  std::size_t changed_ = 0;
  std::pair<Vector<3>, Vector<3>> ends_;
  Vector<3> normal_, u_, v_;
};

/// Do the faces around each end of the pair ab close up, each beginning where one ends? Then they
/// have no border but the link.
inline bool closes_up(const PairStar& star, Index a, Index b) {
  const auto is_closed = [](const std::vector<StarFace>& fan) {
    std::vector<Index> begins, ends;
    for (const StarFace& f : fan) {
      begins.push_back(f.second);
      ends.push_back(f.third);
    }
    std::sort(begins.begin(), begins.end());
    std::sort(ends.begin(), ends.end());
    return begins == ends;
  };
  std::vector<StarFace> at_a(star.first.begin(), star.first.end()),
      at_b(star.second.begin(), star.second.end());
  for (const StarFace& f : star.shared) { // as a sees it
    at_a.push_back(f);
    at_b.push_back(f.second == b ? StarFace(f.face, f.third, a) : StarFace(f.face, a, f.second));
  }
  return is_closed(at_a) && is_closed(at_b);
}

/// Of each face, how far its points are from the input at most: what each contraction has added.
class DistanceBounds {
public:
  explicit DistanceBounds(std::size_t faces) : of_face_(faces, 0) {}

  /// What a contraction would make of the bounds of the faces that it changes, in the order of the
  /// star; and the greatest of these.
  template <std::size_t N>
  double after(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
               const Vector<3>& x, std::vector<float>& bounds) const {
    StarDeviation deviation(star, a, b, positions, x);
    double before = 0;
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        before = std::max(before, double{of_face_[f.face]});
    const std::optional<double> of_star =
        closes_up(star, a, b) ? deviation.of_star() : std::nullopt;

    bounds.clear();
    double greatest = 0;
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces) {
        double bound = of_face_[f.face] + deviation.of_face(bounds.size());
        if (of_star)
          bound = std::min(bound, before + *of_star);
        bounds.push_back(rounded_up(bound));
        greatest = std::max(greatest, double{bounds.back()});
      }
    return greatest;
  }

  /// The contraction has been done.
  void set(const PairStar& star, const std::vector<float>& bounds) {
    auto bound = bounds.begin();
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces)
        of_face_[f.face] = *bound++;
  }

  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(of_face_, is_left);
  }

  /// Of the faces that are left.
  double greatest(const TriangleComplex& complex) const {
    float greatest = 0;
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_dead(face))
        greatest = std::max(greatest, of_face_[face]);
    return greatest;
  }

private:
  static float rounded_up(double bound) {
    constexpr double slack = 1 + 1e-6; // more than all roundings on the way
    return std::nextafter(static_cast<float>(bound * slack),
                          std::numeric_limits<float>::infinity());
  }

  Array<float> of_face_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_DISTANCE_BOUND_H
