#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_DEVIATION_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_DEVIATION_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/guards/distance/boundary_strips.h>
#include <quadrille/internal/guards/distance/face_of_star.h>
#include <quadrille/internal/guards/distance/fans_of_star.h>
#include <quadrille/internal/guards/distance/polygon_table.h>
#include <quadrille/internal/guards/distance/star_patch.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace quadrille::internal {

/// How far a contraction takes the faces around a pair away from those that were there, at most.
///
/// A new face is compared with its former self: the distance to a triangle is convex, so it is
/// greatest at the corner that has moved. Or it is cut into polygons: see StarPatch.
///
/// Each fan between boundaries and junction lines is compared with itself, and has a boundary
/// where it meets others: see FansOfStar. If some new face is turned over in the plane of a
/// fan, at a sharp crease, faces of similar normals are compared separately in the same way.
class StarDeviation {
public:
  /// If more faces change, cutting polygons would take long: each face may meet each.
  static constexpr std::size_t most_faces = 128;

  /// Takes the star of the pair ab, and the place x to which it is contracted. bound_of(face) is
  /// how far an old face may be from the input. The faces of an end at x do not change and are left
  /// out.
  template <std::size_t N, class BoundOf>
  void take(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
            const Vector<3>& x, BoundOf bound_of) {
    const auto at = [&](Index v) { return space(positions[v]); };
    x_ = x;
    ends_ = {at(a), at(b)};
    b_ = b;
    faces_.clear();
    extent_ = 0;
    const auto see = [&](const Vector<3>& p) {
      for (std::size_t i = 0; i < 3; ++i)
        extent_ = (std::max)(extent_, std::abs(p[i] - ends_[0][i]));
    };
    see(x), see(ends_[1]);
    const auto add = [&](const StarFace& f, std::size_t end, bool is_shared) {
      const std::array<Vector<3>, 3> corners{ends_[end], at(f.second), at(f.third)};
      const Vector<3> area = double_area_vector(corners[0], corners[1], corners[2]);
      see(corners[1]), see(corners[2]);
      const auto bound = static_cast<double>(bound_of(f.face));
      faces_.push_back({corners, area, f.second, f.third, bound, end, is_shared});
    };
    if (!is_unchanged(0))
      for (const StarFace& f : star.first)
        add(f, 0, false);
    if (!is_unchanged(1))
      for (const StarFace& f : star.second)
        add(f, 1, false);
    changed_ = faces_.size();
    for (const StarFace& f : star.shared)
      add(f, 0, true);
    patch_.begin(ends_, b, x, extent_);
    polygons_.clear();
  }
  /// Keeps the polygons of those fans that are compared whole.
  void keep_polygons() { polygons_.begin(faces_.size()); }
  const PolygonTable& polygons() const { return polygons_; }

  /// Are the faces of an end, 0 or 1, not changed at all, since the new vertex is where it was?
  bool is_unchanged(std::size_t end) const { return ends_[end] == x_; }

  /// Returns the deviation of a face that changes: those of the first end come first.
  const FaceDeviation& operator[](std::size_t i) const { return deviations_[i]; }

  /// The greatest of each kind, of all faces.
  FaceDeviation greatest() const {
    FaceDeviation greatest;
    for (const FaceDeviation& d : deviations_)
      greatest.raise_to(d);
    return greatest;
  }

  /// Returns the faces that change, in the order of the star, and after them those that are
  /// removed. A caller that projects them for a comparison of its own begins its region here.
  std::vector<FaceOfStar>& faces() { return faces_; }
  std::size_t changed() const { return changed_; }
  void begin(StarPatch& patch) const { patch.begin(ends_, b_, x_, extent_); }
  const Vector<3>& target() const { return x_; }
  bool is_second_end(Index v) const { return v == b_; }
  /// Returns the fans that were compared last.
  const FansOfStar& fans() const { return fans_; }

  /// The greatest extent of the star, up to a factor of two.
  double extent() const { return extent_; }
  /// Returns an upper limit of the roundings of all measurements.
  double rounding() const { return StarPatch::rounding(extent_); }

  /// Compares each face with the one that it was. If it is certain that one will be too far,
  /// returns how far that is. Are all of one fan, and wound alike?
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_each(bool is_one_fan, IsTooFar is_too_far) {
    deviations_.clear();
    FaceDeviation least{std::numeric_limits<double>::infinity(), 0}; // polygons find no less at x
    for (const Face& f : faces_) {
      const auto& [p, q, r] = f.corners;
      const double distance = std::sqrt(squared_distance_to_triangle(x_, p, q, r));
      const FaceDeviation deviation{f.bound + distance, distance};
      if (deviation.from_input < least.from_input)
        least = deviation;
      if (f.is_shared)
        continue;
      if (is_one_fan && changed_ > most_faces && is_too_far(deviation.from_input))
        return deviation;
      deviations_.push_back(deviation);
    }
    if (changed_ > 0 && is_too_far(least.from_input))
      return least;
    return std::nullopt;
  }

  /// Measures how far the boundary moves, to either side. If that is too far, returns the distance.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_boundary(IsTooFar is_too_far) {
    boundary_.clear();
    for (const Face& f : faces_)
      boundary_.add(f, b_);
    boundary_.sum_up();
    boundary_.keep_open_ones([this](std::size_t end) { return !is_unchanged(end); });
    of_boundary_ = boundary_.deviation(ends_, x_);
    return is_too_far(of_boundary_.from_input) ? std::optional(of_boundary_) : std::nullopt;
  }
  /// Adds it to the known deviations of the faces at the boundary.
  void add_boundary() {
    for (std::size_t i = 0; i < changed_; ++i)
      if (boundary_.has(faces_[i].second) || boundary_.has(faces_[i].third))
        deviations_[i].raise_to(of_boundary_);
  }

  /// Compares them by polygons. Once a face is too far either way, returns the distance.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_fans(bool is_one_fan, IsTooFar is_too_far) {
    if (is_one_fan && changed_ > most_faces)
      return std::nullopt;
    if (is_one_fan)
      fans_.take_one(faces_);
    else
      fans_.find(faces_, b_);
    for (std::size_t i = 0; i < fans_.size(); ++i)
      if (const auto beyond = compare_fan(fans_[i], is_too_far))
        return beyond;
    return std::nullopt;
  }

private:
  using Face = FaceOfStar;

  // Compares the fan whole, or else in groups of similar normals.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_fan(std::span<Face* const> fan, IsTooFar is_too_far) {
    const auto changed =
        std::count_if(fan.begin(), fan.end(), [](const Face* f) { return !f->is_shared; });
    if (changed > static_cast<std::ptrdiff_t>(most_faces))
      return first_beyond(fan, is_too_far);
    patch_.take(fan);
    if (patch_.lay_flat() && !patch_.leaves_steep_ones()) {
      if (polygons_.is_kept())
        patch_.keep_polygons(polygons_, faces_.data());
      return measure_patch(is_too_far);
    }
    rest_.assign(fan.begin(), fan.end());
    while (Face* const seed = largest_of_rest()) {
      patch_.take_like(*seed, rest_);
      if (patch_.lay_flat())
        patch_.leaves_steep_ones();
      const bool is_left_out = !patch_.has(seed);
      std::erase_if(rest_, [&](const Face* f) { return f == seed || patch_.has(f); });
      if (is_left_out && is_too_far(known_of(*seed).from_input))
        return known_of(*seed);
      if (const auto beyond = measure_patch(is_too_far))
        return beyond;
    }
    return std::nullopt;
  }

  // Measures the faces of a fan that is not cut into polygons.
  template <class IsTooFar>
  std::optional<FaceDeviation> first_beyond(std::span<Face* const> fan, IsTooFar is_too_far) {
    for (const Face* f : fan)
      if (!f->is_shared && is_too_far(known_of(*f).from_input))
        return known_of(*f);
    return std::nullopt;
  }

  Face* largest_of_rest() const {
    Face* largest = nullptr;
    for (Face* f : rest_)
      if (!f->is_shared && (!largest || squared_length(f->area) > squared_length(largest->area)))
        largest = f;
    return largest;
  }

  template <class IsTooFar>
  std::optional<FaceDeviation> measure_patch(IsTooFar is_too_far) {
    patch_.find_strips();
    for (const Face* f : patch_) {
      if (f->is_shared)
        continue;
      FaceDeviation& known = known_of(*f);
      if (known.from_star > 0)
        if (const FaceDeviation found = patch_.measure(*f, known.from_input);
            found.from_input < known.from_input)
          known = found;
      if (is_too_far(known.from_input))
        return known;
    }
    return std::nullopt;
  }

  // Returns the known deviation of a face that changes.
  FaceDeviation& known_of(const Face& face) {
    return deviations_[static_cast<std::size_t>(&face - faces_.data())];
  }

  Vector<3> x_;
  std::array<Vector<3>, 2> ends_;
  Index b_ = 0;
  std::vector<Face> faces_; // those that change come first, then those that go
  std::vector<FaceDeviation> deviations_;
  FansOfStar fans_;
  PolygonTable polygons_;   // of fans
  StarPatch patch_;         // of a fan, that is compared now
  std::vector<Face*> rest_; // of it, for later
  std::size_t changed_ = 0;
  double extent_ = 0;
  BoundaryStrips boundary_; // of the surface
  FaceDeviation of_boundary_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_DEVIATION_H
