#ifndef QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H
#define QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/distance/border_strips.h>
#include <quadrille/internal/distance/face_of_star.h>
#include <quadrille/internal/distance/flat_pieces.h>
#include <quadrille/internal/distance/projection_plane.h>
#include <quadrille/internal/distance/sheets_of_star.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace quadrille::internal {

/// How far a contraction takes the faces around a pair away from those that were there, at most.
///
/// A new face is compared with the face that it was: the distance to a triangle is convex, so it is
/// greatest at the corner that has moved. Or it is cut into pieces, each of which lies over one old
/// face, or over one strip along the border (see BorderStrips), in the plane of their mean normal:
/// the distance of a piece to that face is greatest at one of its corners. As long as no new face
/// is turned over, the pieces leave nothing out, whatever the old faces look like.
///
/// Each sheet between borders and junction lines is compared with itself, and has a border where it
/// meets others: see SheetsOfStar. Where some new face is turned over in the plane of a sheet, at a
/// sharp crease, faces of like normals are compared apart in the same way.
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
  /// returns how far that is. Are all of one sheet, and wound alike?
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_each(bool is_one_sheet, IsTooFar is_too_far) {
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
      if (is_one_sheet && changed_ > most_faces && is_too_far(deviation.from_input))
        return deviation;
      deviations_.push_back(deviation);
    }
    if (changed_ > 0 && is_too_far(least.from_input))
      return least;
    return std::nullopt;
  }

  /// Measures how far the border moves, to either side. If that is too far, returns how far it is.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_border(IsTooFar is_too_far) {
    border_.clear();
    for (const Face& f : faces_)
      add_spokes(border_, f);
    border_.sum_up();
    border_.keep_open_ones([this](std::size_t end) { return !is_unchanged(end); });
    of_border_ = border_.deviation(ends_, x_.point);
    return is_too_far(of_border_.from_input) ? std::optional(of_border_) : std::nullopt;
  }
  /// Adds it to what is known of the faces at the border.
  void add_border() {
    for (std::size_t i = 0; i < changed_; ++i)
      if (border_.has(faces_[i].second) || border_.has(faces_[i].third))
        deviations_[i].raise_to(of_border_);
  }

  /// Compares them by pieces. Once a face is too far either way, returns how far that is.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_sheets(bool is_one_sheet, IsTooFar is_too_far) {
    if (is_one_sheet && changed_ > most_faces)
      return std::nullopt;
    if (is_one_sheet)
      sheets_.take_one(faces_);
    else
      sheets_.find(faces_, b_);
    for (std::size_t i = 0; i < sheets_.size(); ++i)
      if (const auto beyond = compare_sheet(sheets_[i], is_too_far))
        return beyond;
    return std::nullopt;
  }

private:
  using Face = FaceOfStar;

  static constexpr double steepest = 0x1p-3; // of a new face: cosine of its angle to the plane

  // Whole, or else by parts of like normals.
  template <class IsTooFar>
  std::optional<FaceDeviation> compare_sheet(std::span<Face* const> sheet, IsTooFar is_too_far) {
    const auto changed =
        std::count_if(sheet.begin(), sheet.end(), [](const Face* f) { return !f->is_shared; });
    if (changed > static_cast<std::ptrdiff_t>(most_faces))
      return first_beyond(sheet, is_too_far);
    part_.assign(sheet.begin(), sheet.end());
    if (lay_flat() && !leaves_steep_ones())
      return measure_part(is_too_far);
    rest_.assign(sheet.begin(), sheet.end());
    while (Face* const seed = largest_of_rest()) {
      take_like(*seed);
      if (lay_flat())
        leaves_steep_ones();
      else
        part_.clear();
      Face* const left_out = is_in_part(seed) ? nullptr : seed;
      std::erase_if(rest_, [&](const Face* f) { return f == seed || is_in_part(f); });
      if (left_out && is_too_far(known_of(*left_out).from_input))
        return known_of(*left_out);
      if (const auto beyond = measure_part(is_too_far))
        return beyond;
    }
    return std::nullopt;
  }

  // Of the faces of a sheet that is not cut into pieces.
  template <class IsTooFar>
  std::optional<FaceDeviation> first_beyond(std::span<Face* const> sheet, IsTooFar is_too_far) {
    for (const Face* f : sheet)
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

  void take_like(const Face& seed) {
    const Vector<3>& axis = seed.area;
    part_.clear();
    std::copy_if(rest_.begin(), rest_.end(), std::back_inserter(part_), [&](const Face* f) {
      const double along = dot(axis, f->area);
      return along > 0 && 4 * along * along > squared_length(axis) * squared_length(f->area);
    });
  }

  bool is_in_part(const Face* face) const {
    return std::find(part_.begin(), part_.end(), face) != part_.end();
  }

  // In the plane of the mean normal of the part. False if there is none.
  bool lay_flat() {
    Vector<3> normal;
    for (const Face* f : part_)
      normal += f->area;
    if (!plane_.look_along(normal))
      return false;
    plane_.pass_through(ends_[0]);
    x_ = plane_.flat(x_.point);
    for (Face* f : part_)
      for (std::size_t i = 0; i < 3; ++i)
        f->flat[i] = plane_.flat(f->corners[i]);
    return true;
  }

  // Takes new faces that are turned over, or are nearly, out of the part. Were there any?
  bool leaves_steep_ones() {
    return std::erase_if(part_, [this](const Face* f) {
             if (f->is_shared)
               return false;
             const double flat = flat_area(x_, f->flat[1], f->flat[2]);
             const Vector<3> area = double_area_vector(x_.point, f->corners[1], f->corners[2]);
             return !(flat > 0 && flat * flat > steepest * steepest * squared_length(area));
           }) > 0;
  }

  template <class IsTooFar>
  std::optional<FaceDeviation> measure_part(IsTooFar is_too_far) {
    rim_.clear();
    for (const Face* f : part_)
      add_spokes(rim_, *f);
    rim_.sum_up();
    const auto& strips =
        rim_.strips(ends_, x_, [this](const Vector<3>& p) { return plane_.flat(p); });
    for (const Face* f : part_) {
      if (f->is_shared)
        continue;
      FaceDeviation& known = known_of(*f);
      if (known.from_star > 0)
        if (const FaceDeviation found = measure(*f, strips, known.from_input);
            found.from_input < known.from_input)
          known = found;
      if (is_too_far(known.from_input))
        return known;
    }
    return std::nullopt;
  }

  // Of one that changes.
  FaceDeviation& known_of(const Face& face) {
    return deviations_[static_cast<std::size_t>(&face - faces_.data())];
  }

  void add_spokes(BorderStrips& border, const Face& f) const {
    const auto& [end, second, third] = f.corners;
    if (!f.is_shared) {
      border.add_spoke(f.third, f.end, 1, third, f.bound);
      border.add_spoke(f.second, f.end, -1, second, f.bound);
    } else if (f.second == b_) {
      border.add_between(1, f.bound);
      border.add_spoke(f.third, 0, 1, third, f.bound);
      border.add_spoke(f.third, 1, -1, third, f.bound);
    } else {
      border.add_between(-1, f.bound);
      border.add_spoke(f.second, 0, -1, second, f.bound);
      border.add_spoke(f.second, 1, 1, second, f.bound);
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
    for (const Face* f : part_)
      if (deviation.from_input < known && flat_area(f->flat) > 0)
        look_at(f->flat, f->bound, [&](const FlatPoint& y) { return squared_height(y, f->flat); });
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
  SheetsOfStar sheets_;
  std::vector<Face*> part_, rest_; // of a sheet: what is compared now, and later
  std::size_t changed_ = 0;
  double extent_ = 0;
  ProjectionPlane plane_;
  BorderStrips border_, rim_; // of the surface, and of a part of a sheet
  FaceDeviation of_border_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_DISTANCE_STAR_DEVIATION_H
