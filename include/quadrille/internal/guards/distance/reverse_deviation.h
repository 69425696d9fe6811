#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_REVERSE_DEVIATION_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_REVERSE_DEVIATION_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/guards/distance/face_of_star.h>
#include <quadrille/internal/guards/distance/old_star_patch.h>
#include <quadrille/internal/guards/distance/star_deviation.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Faces of a star that have the same corners once it is contracted: all but one may go, see
/// Cleanup, and leave their points to it.
class DoubledFacesOfStar {
public:
  /// Joins the bounds of the faces that a contraction changes, in the order of the star: the one
  /// that is left gets the greatest of them.
  void join(const PairStar& star, std::vector<float>& bounds) {
    doubled_.clear();
    star.for_each_changed([&](const StarFace& f) {
      const auto& [p, q] = std::minmax(f.second, f.third);
      doubled_.push_back({p, q, f.face, doubled_.size()});
    });
    std::sort(doubled_.begin(), doubled_.end());
    for (std::size_t i = 1, first = 0; i < doubled_.size(); ++i) {
      const auto& [p, q, face, position] = doubled_[i];
      const auto& [first_p, first_q, first_face, left] = doubled_[first];
      if (p == first_p && q == first_q) // the one that is left has the least number
        bounds[left] = (std::max)(bounds[left], bounds[position]);
      else
        first = i;
    }
  }

private:
  std::vector<std::tuple<Index, Index, Index, std::size_t>> doubled_;
};

/// Maps the points of the faces around a pair that is contracted, and bounds their displacement.
///
/// Each point of an old face maps to a point of some new one, also those of the faces that vanish.
/// An old face maps whole to the face that it becomes (to one next to the edge that it becomes, if
/// it vanishes): the distance to a triangle is convex, so it is greatest at a corner. Or it is cut
/// into polygons, each of which maps to the new face over it, as StarDeviation cuts new faces. The
/// shorter of both displacements is used. A new face receives the distance of the input points that
/// come to lie in it: the former distance of those of an old face, plus its displacement.
class ReverseDeviation {
public:
  /// Measures the star that a StarDeviation has just compared, fan by fan or as one; is it
  /// closed around each end? bound_of(face) is the distance bound of the input points of an old
  /// face. Returns an upper limit of their distances then: anything beyond the limit, once
  /// is_too_far(distance) is true for one of them; infinity if there is no face left to which they
  /// could map.
  template <class BoundOf, class IsTooFar>
  double measure(const PairStar& star, StarDeviation& deviation, bool is_one_fan, bool is_closed,
                 BoundOf bound_of, IsTooFar is_too_far) {
    take(star, deviation, bound_of);
    is_closed_ = is_closed;
    if (!is_one_fan || deviation.changed() <= StarDeviation::most_faces)
      for (std::size_t i = 0; i < deviation.fans().size(); ++i)
        if (const auto beyond = compare_fan(deviation.fans()[i], is_too_far))
          return *beyond;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      if (matches_[i].is_in_polygons)
        continue;
      look_at_one(i);
      look_everywhere(i, is_too_far);
      const double bound = bound_by(matches_[i].distance, i);
      if (is_too_far(bound))
        return bound;
      if (matches_[i].to != none)
        raise(matches_[i].to, bound);
      is_any_lost_ |= matches_[i].to == none;
    }
    take_bounds();
    if (!is_one_fan)
      doubled_.join(star, bounds_);
    return is_any_lost_ ? infinity : static_cast<double>(rounded_up(greatest_));
  }

  /// Returns bounds of the input points of the remaining faces of the star, in its order.
  const std::vector<float>& bounds() const { return bounds_; }
  /// Are there points that have no face left to go to?
  bool is_any_lost() const { return is_any_lost_; }

private:
  // The new position of an old face.
  struct Match {
    double bound;        // of its points, before
    double distance;     // by how far they go if they all go to one face
    std::size_t to;      // that face, in the order of the star
    bool is_looked_at;   // is that known?
    bool is_in_polygons; // they go to several
  };
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  template <class BoundOf>
  void take(const PairStar& star, StarDeviation& deviation, BoundOf bound_of) {
    star_ = &star;
    deviation_ = &deviation;
    faces_ = deviation.faces();
    deviation.begin(patch_);
    patch_.look_up_from(faces_.data());
    greatest_ = 0;
    is_any_lost_ = false;
    new_bounds_.clear();
    matches_.clear();
    first_changed_ = deviation.is_unchanged(0) ? star.first.size() : 0;
    const auto take_end = [&](const AppendBuffer<StarFace>& faces, std::size_t end) {
      for (const StarFace& f : faces)
        if (deviation.is_unchanged(end)) {
          new_bounds_.push_back(static_cast<double>(bound_of(f.face)));
        } else {
          new_bounds_.push_back(0);
          add(bound_of(f.face));
        }
    };
    take_end(star.first, 0);
    take_end(star.second, 1);
    for (const StarFace& f : star.shared)
      add(bound_of(f.face));
  }
  void add(double bound) { matches_.push_back({bound, infinity, none, false, false}); }

  // Finds the face to which all points of an old one go; none if it leaves no edge of a face.
  void look_at_one(std::size_t i) {
    if (matches_[i].is_looked_at)
      return;
    matches_[i].is_looked_at = true;
    if (i >= deviation_->changed())
      look_around(i);
    else // the two others belong to both
      go_to(matches_[i], first_changed_ + i,
            std::sqrt(squared_distance_to_triangle(faces_[i].corners[0], deviation_->target(),
                                                   faces_[i].corners[1], faces_[i].corners[2])));
  }

  // Maps a face that vanishes to one that has the edge that it becomes.
  void look_around(std::size_t i) {
    const FaceOfStar& old = faces_[i];
    const Index v = deviation_->is_second_end(old.second) ? old.third : old.second;
    Match& match = matches_[i];
    for (std::size_t k = 0; k < deviation_->changed(); ++k)
      if (faces_[k].second == v || faces_[k].third == v)
        go_to(match, first_changed_ + k, displacement_of_all(old, faces_[k]));
    if (match.to != none)
      return;
    // The edge is that of a face at an end that stays: each point goes to the edge.
    const auto& [a, second, third] = old.corners;
    const auto& [b, p] = old.second == v ? std::pair(third, second) : std::pair(second, third);
    const Vector<3>& x = deviation_->target();
    const double displacement = std::sqrt(
        (std::max)(squared_distance_to_segment(a, x, p), squared_distance_to_segment(b, x, p)));
    std::size_t position = 0;
    star_->for_each_changed([&](const StarFace& f) {
      if (f.has(v))
        go_to(match, position, displacement);
      ++position;
    });
  }

  // To any new face, if it is too far to those that were looked at.
  template <class IsTooFar>
  void look_everywhere(std::size_t i, IsTooFar is_too_far) {
    Match& match = matches_[i];
    if (match.distance > 0 && deviation_->changed() <= StarDeviation::most_faces &&
        is_too_far(bound_by(match.distance, i)))
      for (std::size_t k = 0; k < deviation_->changed(); ++k)
        go_to(match, first_changed_ + k, displacement_of_all(faces_[i], faces_[k]));
  }

  double displacement_of_all(const FaceOfStar& old, const FaceOfStar& now) const {
    double most = 0;
    for (const Vector<3>& p : old.corners)
      most = (std::max)(most, squared_distance_to_triangle(p, deviation_->target(), now.corners[1],
                                                           now.corners[2]));
    return std::sqrt(most);
  }

  static void go_to(Match& match, std::size_t to, double distance) {
    if (distance < match.distance) {
      match.distance = distance;
      match.to = to;
    }
  }

  // Measures a fan whole, or else in groups of similar normals.
  template <class IsTooFar>
  std::optional<double> compare_fan(std::span<FaceOfStar* const> fan, IsTooFar is_too_far) {
    const auto changed =
        std::count_if(fan.begin(), fan.end(), [](const FaceOfStar* f) { return !f->is_shared; });
    if (changed == 0 || changed > static_cast<std::ptrdiff_t>(StarDeviation::most_faces))
      return std::nullopt;
    patch_.take(fan);
    if (patch_.lay_flat() && !patch_.leaves_steep_old_ones()) {
      if (is_closed_)
        patch_.find_no_strips();
      else
        patch_.find_strips<BoundaryStrips::Side::of_old>();
      return measure_patch(&deviation_->polygons(), is_too_far);
    }
    rest_.assign(fan.begin(), fan.end());
    while (!rest_.empty()) {
      FaceOfStar* const seed = *std::max_element(
          rest_.begin(), rest_.end(), [](const FaceOfStar* f, const FaceOfStar* g) {
            return squared_length(f->area) < squared_length(g->area);
          });
      patch_.take_like(*seed, rest_);
      if (patch_.lay_flat())
        patch_.leaves_steep_old_ones();
      std::erase_if(rest_, [&](const FaceOfStar* f) { return f == seed || patch_.has(f); });
      patch_.find_strips<BoundaryStrips::Side::of_old>();
      if (const auto beyond = measure_patch(nullptr, is_too_far))
        return beyond;
    }
    return std::nullopt;
  }

  template <class IsTooFar>
  std::optional<double> measure_patch(const PolygonTable* table, IsTooFar is_too_far) {
    if (table && !table->is_kept())
      table = nullptr;
    patch_.find_new_faces();
    const bool is_known = table && patch_.has_all_polygons(*table);
    for (const FaceOfStar* f : patch_) {
      const std::size_t i = index_of(*f);
      if (!is_known)
        look_at_one(i);
      if (!(matches_[i].distance > 0))
        continue; // all of it is in the face that it becomes
      cut(*f, i, table, is_too_far);
      if (!matches_[i].is_in_polygons)
        continue;
      for (const auto& [to, distance] : polygons_) {
        const double bound = bound_by(distance, i);
        if (bound > greatest_ && is_too_far(bound))
          return bound;
        raise(to, bound);
      }
    }
    return std::nullopt;
  }

  // Measures by polygons, unless all points move less far to one face. That is checked if it
  // matters: if polygons are too far, or if they are very small, which may be pure rounding.
  template <class IsTooFar>
  void cut(const FaceOfStar& f, std::size_t i, const PolygonTable* table, IsTooFar is_too_far) {
    polygons_.clear();
    double most = 0;
    Match& match = matches_[i];
    match.is_in_polygons =
        patch_.measure_old(f, match.distance, table, [&](const FaceOfStar& now, double distance) {
          polygons_.push_back({first_changed_ + index_of(now), distance});
          most = (std::max)(most, distance);
        });
    if (!match.is_in_polygons || match.is_looked_at)
      return;
    const double bound = bound_by(most, i);
    if (most > 16 * deviation_->rounding() && !(bound > greatest_ && is_too_far(bound)))
      return;
    look_at_one(i);
    match.is_in_polygons = most < match.distance;
  }

  std::size_t index_of(const FaceOfStar& face) const {
    return static_cast<std::size_t>(&face - faces_.data());
  }

  double bound_by(double distance, std::size_t i) const {
    return matches_[i].bound + distance + deviation_->rounding();
  }

  void raise(std::size_t to, double bound) {
    new_bounds_[to] = (std::max)(new_bounds_[to], bound);
    greatest_ = (std::max)(greatest_, bound);
  }

  void take_bounds() {
    bounds_.clear();
    for (std::size_t i = 0; i < new_bounds_.size(); ++i)
      bounds_.push_back(rounded_up(new_bounds_[i]));
  }
  // A float is not less; those that are floats stay what they are.
  static float rounded_up(double bound) {
    const auto near = static_cast<float>(bound);
    return static_cast<double>(near) < bound
               ? std::nextafter(near, std::numeric_limits<float>::infinity())
               : near;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const PairStar* star_ = nullptr; // at hand
  StarDeviation* deviation_ = nullptr;
  std::span<FaceOfStar> faces_;   // of the star
  std::size_t first_changed_ = 0; // of them, in the order of the star
  std::vector<Match> matches_;    // of each of them
  std::vector<float> bounds_;
  std::vector<double> new_bounds_; // the same, not rounded yet
  double greatest_ = 0;            // of faces that points came to
  bool is_any_lost_ = false;
  bool is_closed_ = false;
  OldStarPatch patch_;            // of a fan, that is compared now
  std::vector<FaceOfStar*> rest_; // of it, for later
  std::vector<std::pair<std::size_t, double>> polygons_;
  DoubledFacesOfStar doubled_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_REVERSE_DEVIATION_H
