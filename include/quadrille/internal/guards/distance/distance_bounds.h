#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_BOUNDS_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_BOUNDS_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/guards/distance/recent_faces.h>
#include <quadrille/internal/guards/distance/reverse_deviation.h>
#include <quadrille/internal/guards/distance/star_deviation.h>
#include <quadrille/internal/guards/distance/tolerances.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The kind of the faces around a pair: closed around each end and oriented alike; closed; or
/// unknown.
enum class StarKind { oriented, closed, any };

/// An upper limit of the distance of each face from the input: the sum over contractions. And, if
/// distances count both ways, an upper limit of the distance of the input points that have come to
/// lie in it. If there are tolerances both are fractions of these, which contractions have used.
class DistanceBounds {
public:
  /// `size` is the greatest coordinate of the surface.
  explicit DistanceBounds(std::size_t faces, double size = 0, bool both_ways = false,
                          Tolerances tolerances = {})
      : of_face_(faces, 0), reverse_of_face_(both_ways ? faces : 0, 0),
        tolerances_(std::move(tolerances)), size_(size) {}

  /// A distance that may be nothing but the sum of many roundings, on a surface of this size.
  double rounding() const { return 0x1p-40 * size_; }

  bool has_tolerances() const { return tolerances_.are_given(); }
  /// Returns the greatest tolerance, of which the bounds are fractions; 1 if they are distances.
  double greatest_tolerance() const {
    return has_tolerances() ? (std::max)(tolerances_.greatest(), rounding()) : 1;
  }
  /// Returns the tolerance of the faces around a pair.
  StarTolerance tolerance_of(const PairStar& star) const {
    StarTolerance result;
    if (!tolerances_.are_given())
      return result;
    result = {true, tolerances_.least(star), 0, rounding(), greatest_tolerance()};
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        result.used = (std::max)({result.used, of_face_[f.face], reverse_of_face_[f.face]});
    return result;
  }

  /// Computes the bounds of the faces that a contraction changes, in the order of the star, and the
  /// greatest of these. Once is_too_far(distance) is true nothing else is measured: then only the
  /// distance that is too far is returned. If a distance is too far, so is any greater one.
  template <std::size_t N, class IsTooFar>
  FaceDeviation measure(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
                        const Vector<3>& x, StarKind kind, const StarTolerance& tolerance,
                        StarDeviation& deviation, std::vector<float>& bounds,
                        IsTooFar is_too_far) const {
    deviation.take(star, a, b, positions, x,
                   [&](Index face) { return tolerance.length_of(of_face_[face]); });
    if (reverse_of_face_.size() > 0)
      deviation.keep_polygons();
    const auto bound = [&](double distance) {
      return static_cast<double>(rounded_up(distance + deviation.rounding()));
    };
    const auto is_beyond = [&](double distance) { return is_too_far(bound(distance)); };
    const bool is_one_fan = kind == StarKind::oriented;
    std::optional<FaceDeviation> beyond = deviation.compare_each(is_one_fan, is_beyond);
    if (!beyond && kind == StarKind::any)
      beyond = deviation.compare_boundary(is_beyond);
    if (!beyond)
      beyond = deviation.compare_fans(is_one_fan, is_beyond);
    if (beyond) { // returned as it was queried, since it might otherwise seem not to be too far
      beyond->from_input = bound(beyond->from_input);
      return *beyond;
    }
    if (kind == StarKind::any)
      deviation.add_boundary();
    FaceDeviation greatest = deviation.greatest();
    greatest.from_input = take_bounds(star, tolerance, deviation, bounds);
    return greatest;
  }

  /// How far the input points of the star will be from the surface, at most, if the contraction is
  /// done that has just been measured. Once is_too_far(distance) says so of some, how far these
  /// are.
  template <class IsTooFar>
  double measure_reverse(const PairStar& star, StarKind kind, const StarTolerance& tolerance,
                         StarDeviation& deviation, ReverseDeviation& reverse,
                         IsTooFar is_too_far) const {
    return reverse.measure(
        star, deviation, kind == StarKind::oriented, kind != StarKind::any,
        [&](Index face) { return tolerance.length_of(reverse_of_face_[face]); }, is_too_far);
  }

  /// Will one of very many faces at an end be too far? It measures them before the star is
  /// gathered, first those that were too far the last times: at a high-valence vertex they are few
  /// and mostly the same. At a vertex where fans meet, each fan may have few faces: there it counts
  /// as a high-valence vertex only if it has so many that sorting the fans takes long.
  template <std::size_t N, class MayBeJunction, class IsTooFar>
  bool is_beyond_high_valence(const TriangleComplex& complex, Index a, Index b,
                              const Array<Vector<N>>& positions, const Vector<3>& x,
                              RecentFaces& recent_faces, MayBeJunction may_be_junction,
                              IsTooFar is_too_far) const {
    const auto at = [&](Index v) { return space(positions[v]); };
    const auto is_beyond = [&](Index end, Index other) {
      const std::size_t degree = complex.degree_bound(end);
      if (degree <= 2 * StarDeviation::most_faces || at(end) == x ||
          (degree <= many_fans && may_be_junction(end)))
        return false;
      const auto is_face_beyond = [&](Index face, Index i) {
        const StarFace f = star_face_at(complex, face, i);
        if (f.second == other || f.third == other)
          return false;
        const double squared = squared_distance_to_triangle(x, at(end), at(f.second), at(f.third));
        StarTolerance tolerance; // that of the star is not greater, so more of it would be used
        if (tolerances_.are_given())
          tolerance = {true, tolerances_[face], of_face_[face], rounding(), greatest_tolerance()};
        const double length = tolerance.length_of(of_face_[face]) + std::sqrt(squared);
        return squared > 0x1p-40 * squared_distance(x, at(f.second)) && // else it may be rounding
               is_too_far(static_cast<double>(rounded_up(length)), tolerance);
      };
      return recent_faces.any_at(complex, end, is_face_beyond) ||
             complex.any_corner(end, [&](Index face, Index i) {
               const bool result = is_face_beyond(face, i);
               if (result)
                 recent_faces.add(face);
               return result;
             });
    };
    return is_beyond(a, b) || is_beyond(b, a);
  }

  /// The faces of a star that a contraction has changed have the bounds that were measured for it.
  void set(const PairStar& star, const std::vector<float>& bounds) {
    set(of_face_, star, bounds, [](float bound) { return bound; });
  }
  /// Sets the bounds of their input points, if distances count both ways.
  void set_reverse(const PairStar& star, const std::vector<float>& lengths,
                   const StarTolerance& tolerance) {
    if (!tolerance.is_given) {
      set(reverse_of_face_, star, lengths, [](float length) { return length; });
      return;
    }
    set(reverse_of_face_, star, lengths, [&](float length) {
      return static_cast<float>(tolerance.bound_of(static_cast<double>(length)));
    });
    tolerances_.set(star, tolerance.least);
  }

  /// The faces begin with what is known of them, by the numbers that they and their reverse faces
  /// have in the input. Tolerances are those of vertices, if these have any.
  template <class Inputs>
  void take_given(const std::vector<FaceBound>& given, std::optional<double> greatest_tolerance,
                  const TriangleComplex& complex, const Inputs& inputs) {
    if (greatest_tolerance)
      tolerances_ = Tolerances(of_face_.size(), *greatest_tolerance);
    for_inputs(complex, inputs, [&](Index face, Index input) {
      of_face_[face] = (std::max)(of_face_[face], given[input].from_input);
      if (reverse_of_face_.size() > 0)
        reverse_of_face_[face] = (std::max)(reverse_of_face_[face], given[input].to_input);
      if (greatest_tolerance)
        tolerances_.limit(face, given[input].tolerance);
    });
  }
  /// Sets the bounds of the remaining faces, in the same way.
  template <class Inputs>
  void write_to(std::vector<FaceBound>& reported, const TriangleComplex& complex,
                const Inputs& inputs) const {
    for_inputs(complex, inputs, [&](Index face, Index input) {
      reported[input] = {of_face_[face], reverse_of_face_.size() > 0 ? reverse_of_face_[face] : 0,
                         has_tolerances() ? static_cast<float>(tolerances_[face]) : 0};
    });
  }

  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(of_face_, is_left);
    if (reverse_of_face_.size() > 0)
      internal::pack_if(reverse_of_face_, is_left);
    if (tolerances_.are_given())
      tolerances_.pack_if(is_left);
  }

  /// Returns the greatest bound of the remaining faces.
  double greatest(const TriangleComplex& complex) const { return greatest(of_face_, complex); }
  /// Which of these has used most of its tolerance, the lowest if several have; `none` of none.
  Index most_used(const TriangleComplex& complex) const {
    Index most = none;
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face) && (most == none || used(face) > used(most)))
        most = face;
    return most;
  }
  double used(Index face) const {
    return static_cast<double>((std::max)(of_face_[face], reverse_of_face_[face]));
  }
  /// Returns the greatest bound of their input points.
  double greatest_reverse(const TriangleComplex& complex) const {
    return greatest(reverse_of_face_, complex);
  }

private:
  template <class Inputs, class Take>
  static void for_inputs(const TriangleComplex& complex, const Inputs& inputs, Take take) {
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      if (complex.is_removed(face))
        continue;
      take(face, inputs[face]);
      if (complex.reverse_faces().has(face))
        take(face, complex.reverse_faces().input_face(face));
    }
  }

  template <class Stored>
  static void set(Array<float>& of_face, const PairStar& star, const std::vector<float>& bounds,
                  Stored stored) {
    auto bound = bounds.begin();
    star.for_each_changed([&](const StarFace& f) { of_face[f.face] = stored(*bound++); });
  }
  static double greatest(const Array<float>& of_face, const TriangleComplex& complex) {
    float greatest = 0;
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face))
        greatest = (std::max)(greatest, of_face[face]);
    return static_cast<double>(greatest);
  }

  // Takes the bounds of the faces of a star, in its order. Returns the greatest of those that
  // change.
  double take_bounds(const PairStar& star, const StarTolerance& tolerance,
                     const StarDeviation& deviation, std::vector<float>& bounds) const {
    bounds.clear();
    std::size_t changed = 0;
    float greatest = 0;
    const auto take = [&](const AppendBuffer<StarFace>& faces, std::size_t end) {
      for (const StarFace& f : faces)
        if (deviation.is_unchanged(end)) {
          bounds.push_back(of_face_[f.face]);
        } else {
          const float length = rounded_up(deviation[changed++].from_input + deviation.rounding());
          greatest = (std::max)(greatest, length);
          bounds.push_back(static_cast<float>(tolerance.bound_of(static_cast<double>(length))));
        }
    };
    take(star.first, 0);
    take(star.second, 1);
    return static_cast<double>(greatest);
  }

  static constexpr std::size_t many_fans = 4096; // faces of them

  static float rounded_up(double bound) {
    return std::nextafter(static_cast<float>(bound), std::numeric_limits<float>::infinity());
  }

  Array<float> of_face_;
  Array<float> reverse_of_face_; // none where distances count one way
  Tolerances tolerances_;
  double size_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_BOUNDS_H
