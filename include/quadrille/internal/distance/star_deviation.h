#ifndef QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H
#define QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/distance/border_strips.h>
#include <quadrille/internal/distance/flat_pieces.h>
#include <quadrille/internal/distance/projection_plane.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// An old face of a star, and in which sheet it is: see StarDeviation.
struct FaceOfStar {
  std::array<Vector<3>, 3> corners; // an end of the pair comes first
  Vector<3> area;
  Index second, third;
  double bound;
  std::size_t end;
  bool is_shared;
  bool is_open = true, is_in_sheet = false; // not yet in a sheet; in the one at hand
  FlatTriangle flat = {};
};

/// How far a contraction takes the faces around a pair away from those that were there, at most.
///
/// A new face is compared with the face that it was: the distance to a triangle is convex, so it is
/// greatest at the corner that has moved. Or it is cut into pieces, each of which lies over one old
/// face, or over one strip along the border (see BorderStrips), in the plane of their mean normal:
/// the distance of a piece to that face is greatest at one of its corners. As long as no new face
/// is turned over, the pieces leave nothing out, whatever the old faces look like.
///
/// Where some new face is turned over in that plane, at a sharp crease or where more than two faces
/// meet, faces of like normals make up a sheet each, with a border where it meets others.
class StarDeviation {
public:
  /// Where more faces change, pieces would take long: each face may meet each.
  static constexpr std::size_t most_faces = 128;

  /// Takes the star of the pair ab, and the place x to which it is contracted. bound_of(face) is
  /// how far an old face may be from the input. The faces of an end at x do not change and are left
  /// out.
  template <std::size_t N, class BoundOf>
  void take(const PairStar& star, Index a, Index b, const Array<Vector<N>>& positions,
            const Vector<3>& x, BoundOf bound_of) {
    const auto at = [&](Index v) { return space(positions[v]); };
    x_.point = x;
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
  }

  /// Are the faces of an end, 0 or 1, not changed at all, since the new vertex is where it was?
  bool is_unchanged(std::size_t end) const { return ends_[end] == x_.point; }

  /// Of the faces that change: those of the first end come first.
  const FaceDeviation& operator[](std::size_t i) const { return deviations_[i]; }

  /// The greatest of each kind, of all faces.
  FaceDeviation greatest() const {
    FaceDeviation greatest;
    for (const FaceDeviation& d : deviations_)
      greatest.raise_to(d);
    return greatest;
  }

  /// The greatest extent of the star, up to a factor of two.
  double extent() const { return extent_; }
  /// What the roundings of all that is measured come to, at most.
  double rounding() const { return 0x1p-48 * extent_; }

  /// Compares each face with the one that it was. If it is certain that one will be too far,
  /// returns how far that is.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_each(IsTooFar is_too_far) {
    deviations_.clear();
    FaceDeviation least{std::numeric_limits<double>::infinity(), 0}; // pieces find no less at x
    for (const Face& f : faces_) {
      const auto& [p, q, r] = f.corners;
      const double distance = std::sqrt(squared_distance_to_triangle(x_.point, p, q, r));
      const FaceDeviation deviation{f.bound + distance, distance};
      if (deviation.from_input < least.from_input)
        least = deviation;
      if (f.is_shared)
        continue;
      if (changed_ > most_faces && is_too_far(deviation.from_input))
        return deviation;
      deviations_.push_back(deviation);
    }
    if (changed_ > 0 && is_too_far(least.from_input))
      return least;
    return std::nullopt;
  }

  /// Adds how far the border moves, to either side, to what is known of the faces at it. If that is
  /// too far, returns how far it is.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_border(IsTooFar is_too_far) {
    border_.clear();
    for (const Face& f : faces_)
      add_spokes(f);
    border_.sum_up();
    border_.keep_open_ones([this](std::size_t end) { return !is_unchanged(end); });
    const FaceDeviation moved = border_.deviation(ends_, x_.point);
    if (is_too_far(moved.from_input))
      return moved;
    for (std::size_t i = 0; i < changed_; ++i)
      if (border_.has(faces_[i].second) || border_.has(faces_[i].third))
        deviations_[i].raise_to(moved);
    return std::nullopt;
  }

  /// Compares them by pieces. Once a face is too far either way, returns how far that is.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_sheets(IsTooFar is_too_far) {
    if (changed_ > most_faces)
      return std::nullopt;
    for (int sheets = 0; sheets < most_sheets && find_sheet(sheets == 0); ++sheets)
      if (const auto beyond = measure_sheet(is_too_far))
        return beyond;
    return std::nullopt;
  }

private:
  using Face = FaceOfStar;

  static constexpr int most_sheets = 4;
  static constexpr double steepest = 0x1p-3; // of a new face: cosine of its angle to the plane

  // The faces of the next sheet leave the open ones; at first all together. False at the end.
  bool find_sheet(bool is_first) {
    const Face* seed = nullptr;
    for (const Face& f : faces_)
      if (f.is_open && !f.is_shared &&
          (!seed || squared_length(f.area) > squared_length(seed->area)))
        seed = &f;
    if (!seed)
      return false;
    const Vector<3> axis = seed->area;
    Vector<3> normal;
    for (Face& f : faces_) {
      const double along = dot(axis, f.area);
      f.is_in_sheet =
          f.is_open && (is_first || (along > 0 && 4 * along * along > squared_length(axis) *
                                                                          squared_length(f.area)));
      if (f.is_in_sheet)
        normal += f.area;
    }
    const bool is_whole = plane_.look_along(normal) && leave_steep_ones(is_first);
    if (is_first && !is_whole)
      return find_sheet(false);
    for (Face& f : faces_)
      f.is_open &= !f.is_in_sheet && &f != seed;
    return true;
  }

  // Takes new faces that are turned over, or are nearly, out of the sheet. False if there are any
  // and none may be.
  bool leave_steep_ones(bool is_whole) {
    plane_.pass_through(ends_[0]);
    x_ = plane_.flat(x_.point);
    for (Face& f : faces_) {
      if (!f.is_in_sheet)
        continue;
      for (std::size_t i = 0; i < 3; ++i)
        f.flat[i] = plane_.flat(f.corners[i]);
      if (f.is_shared)
        continue;
      const double flat = flat_area(x_, f.flat[1], f.flat[2]);
      const Vector<3> area = double_area_vector(x_.point, f.corners[1], f.corners[2]);
      f.is_in_sheet = flat > 0 && flat * flat > steepest * steepest * squared_length(area);
      if (is_whole && !f.is_in_sheet)
        return false;
    }
    return true;
  }

  template <class IsTooFar>
  std::optional<FaceDeviation> measure_sheet(IsTooFar is_too_far) {
    border_.clear();
    for (const Face& f : faces_)
      if (f.is_in_sheet)
        add_spokes(f);
    border_.sum_up();
    const auto& strips =
        border_.strips(ends_, x_, [this](const Vector<3>& p) { return plane_.flat(p); });
    for (std::size_t i = 0; i < changed_; ++i) {
      FaceDeviation& known = deviations_[i];
      if (!faces_[i].is_in_sheet)
        continue;
      if (known.from_star > 0)
        if (const FaceDeviation found = measure(faces_[i], strips, known.from_input);
            found.from_input < known.from_input)
          known = found;
      if (is_too_far(known.from_input))
        return known;
    }
    return std::nullopt;
  }

  void add_spokes(const Face& f) {
    const auto& [end, second, third] = f.corners;
    if (!f.is_shared) {
      border_.add_spoke(f.third, f.end, 1, third, f.bound);
      border_.add_spoke(f.second, f.end, -1, second, f.bound);
    } else if (f.second == b_) {
      border_.add_between(1, f.bound);
      border_.add_spoke(f.third, 0, 1, third, f.bound);
      border_.add_spoke(f.third, 1, -1, third, f.bound);
    } else {
      border_.add_between(-1, f.bound);
      border_.add_spoke(f.second, 0, -1, second, f.bound);
      border_.add_spoke(f.second, 1, 1, second, f.bound);
    }
  }

  // By its pieces; anything beyond what is known, once it is beyond.
  FaceDeviation measure(const Face& face, const std::vector<BorderStrips::Strip>& strips,
                        double known) {
    const FlatTriangle now{x_, face.flat[1], face.flat[2]};
    const double all = flat_area(now), tolerance = 0x1p-50 * extent_;
    FaceDeviation deviation;
    double covered = 0;
    const auto look_at = [&](const FlatTriangle& part, double bound, auto squared) {
      if (lies_beside(now, part))
        return;
      FlatPiece piece(now);
      piece.clip(part, tolerance);
      if (piece.empty())
        return;
      double most = 0;
      for (const FlatPoint& y : piece)
        most = (std::max)(most, squared(y));
      covered += piece.area();
      const double distance = std::sqrt(most);
      deviation.raise_to({bound + distance, distance});
    };
    for (const Face& f : faces_)
      if (f.is_in_sheet && deviation.from_input < known && flat_area(f.flat) > 0)
        look_at(f.flat, f.bound, [&](const FlatPoint& y) { return squared_height(y, f.flat); });
    for (const BorderStrips::Strip& s : strips)
      if (deviation.from_input < known)
        look_at(s.triangle, s.bound, [&](const FlatPoint& y) {
          return squared_distance_to_segment(y.point, s.from, s.to);
        });
    if (covered < (1 - 1e-6) * all) // only if it was not looked at to the end
      deviation.from_input = std::numeric_limits<double>::infinity();
    return deviation;
  }

  FlatPoint x_{};
  std::array<Vector<3>, 2> ends_;
  Index b_ = 0;
  std::vector<Face> faces_; // those that change come first, then those that go
  std::vector<FaceDeviation> deviations_;
  std::size_t changed_ = 0;
  double extent_ = 0;
  ProjectionPlane plane_;
  BorderStrips border_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H
