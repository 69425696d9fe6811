#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_PATCH_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_PATCH_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/guards/distance/boundary_strips.h>
#include <quadrille/internal/guards/distance/face_of_star.h>
#include <quadrille/internal/guards/distance/polygon_table.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

namespace quadrille::internal {

/// A plane on which points of space are projected, with coordinates u and v in it.
class ProjectionPlane {
public:
  /// The plane gets this normal. False if it has no length.
  bool look_along(const Vector<3>& normal) {
    const double length = std::sqrt(squared_length(normal));
    if (!(length > 0))
      return false;
    const Vector<3> n = (1 / length) * normal;
    const std::size_t least = std::abs(n[0]) < std::abs(n[1])
                                  ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                  : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
    Vector<3> axis;
    axis[least] = 1;
    u_ = cross(axis, n);
    u_ = (1 / std::sqrt(squared_length(u_))) * u_;
    v_ = cross(n, u_);
    return true;
  }
  /// The point has the coordinates 0 and 0.
  void pass_through(const Vector<3>& point) { zero_ = point; }

  FlatPoint flat(const Vector<3>& p) const {
    const Vector<3> d = p - zero_;
    return {p, dot(d, u_), dot(d, v_)};
  }

private:
  Vector<3> zero_, u_, v_;
};

/// Faces of one fan of a star, wound alike, of which new ones are compared with old ones.
///
/// A new face is cut into polygons, each of which lies over one old face, or over one strip along
/// the boundary of the region (see BoundaryStrips), in the plane of their mean normal: the distance
/// of a polygon to that face is greatest at one of its corners. As long as no new face is turned
/// over in this plane, the polygons leave nothing out, whatever the old faces look like. For the
/// other direction see OldStarPatch.
class StarPatch {
public:
  using Face = FaceOfStar;

  /// Returns an upper limit of the roundings of all measurements in a star of this extent.
  static double rounding(double extent) { return 0x1p-48 * extent; }

  /// Starts with the pair of these ends, the second of which is b, which is contracted to x.
  void begin(const std::array<Vector<3>, 2>& ends, Index b, const Vector<3>& x, double extent) {
    ends_ = ends;
    b_ = b;
    x_.point = x;
    extent_ = extent;
  }

  void take(std::span<Face* const> faces) {
    faces_.assign(faces.begin(), faces.end());
    kept_ = nullptr;
  }
  /// Adds the polygons that measure() finds to a table, by the places of faces after the first.
  void keep_polygons(PolygonTable& table, const Face* first) {
    kept_ = &table;
    first_ = first;
  }
  /// Takes those faces whose normals are within 60 degrees of that of one of them.
  void take_like(const Face& seed, const std::vector<Face*>& faces) {
    const Vector<3>& axis = seed.area;
    faces_.clear();
    kept_ = nullptr;
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(faces_), [&](const Face* f) {
      const double along = dot(axis, f->area);
      return along > 0 && 4 * along * along > squared_length(axis) * squared_length(f->area);
    });
  }

  auto begin() const { return faces_.begin(); }
  auto end() const { return faces_.end(); }
  bool has(const Face* face) const {
    return std::find(faces_.begin(), faces_.end(), face) != faces_.end();
  }

  /// Puts them in the plane of their mean normal. If there is none, none of them is left.
  bool lay_flat() {
    Vector<3> normal;
    for (const Face* f : faces_)
      normal += f->area;
    if (!plane_.look_along(normal)) {
      faces_.clear();
      return false;
    }
    plane_.pass_through(ends_[0]);
    x_ = plane_.flat(x_.point);
    for (Face* f : faces_)
      for (std::size_t i = 0; i < 3; ++i)
        f->flat[i] = plane_.flat(f->corners[i]);
    return true;
  }

  /// Takes new faces that are turned over, or are nearly, out of the region. Were there any?
  bool leaves_steep_ones() {
    return std::erase_if(faces_, [this](const Face* f) {
             if (f->is_shared)
               return false;
             const double flat = flat_area(x_, f->flat[1], f->flat[2]);
             const Vector<3> area = double_area_vector(x_.point, f->corners[1], f->corners[2]);
             return !(flat > 0 && flat * flat > steepest * steepest * squared_length(area));
           }) > 0;
  }

  /// Finds the strips along its boundary, which measure() needs.
  template <BoundaryStrips::Side side = BoundaryStrips::Side::of_new>
  void find_strips() {
    boundary_.clear();
    for (const Face* f : faces_)
      boundary_.add(*f, b_);
    boundary_.sum_up();
    strips_ = &boundary_.strips<side>(ends_, x_, tolerance() / 2,
                                      [this](const Vector<3>& p) { return plane_.flat(p); });
  }
  /// Skips the search for strips if it is known that there are none.
  void find_no_strips() {
    boundary_.clear();
    strips_ =
        &boundary_.strips(ends_, x_, 0, [this](const Vector<3>& p) { return plane_.flat(p); });
  }

  /// Returns how far a changed face comes to lie, by its polygons; anything beyond the known
  /// distance, once it is beyond.
  FaceDeviation measure(const Face& face, double known) const {
    const FaceDeviation plain =
        kept_ ? measure_and_keep(face, known)
              : measure_by(face, known, [](const FlatPolygon&, double, const Face*, const auto& d) {
                  return d;
                });
    if (!may_be_noise(plain.from_star))
      return plain;
    return measure_by(
        face, known,
        [this](const FlatPolygon& polygon, double, const Face*, const FaceDeviation& d) {
          return may_be_noise(d.from_star) ? nearest_to(polygon, d) : d;
        });
  }

protected:
  static constexpr double steepest = 0x1p-3; // of a face: cosine of its angle to the plane

  // The width by which polygons are enlarged, so that roundings leave no gaps. If a strip is left
  // out that is narrower than half of it, the new face is no further off than the next polygon by
  // rounding(), since it is not steep.
  double tolerance() const { return 0x1p-50 * extent_; }

  std::size_t index_of(const Face& face) const { return static_cast<std::size_t>(&face - first_); }

  // Is it very small, but more than roundings? Acute angles enlarge these, in the height over a
  // thin face and where they put the tip of a face over one next to it.
  bool may_be_noise(double distance) const {
    return distance > 8 * rounding(extent_) && distance < 0x1p-30 * extent_;
  }

  std::vector<Face*> faces_;
  const Face* first_ = nullptr; // of those that a table is about
  FlatPoint x_{};
  double extent_ = 0;
  const std::vector<BoundaryStrips::Strip>* strips_ = nullptr;

private:
  // Measures by polygons, which are added to the table.
  FaceDeviation measure_and_keep(const Face& face, double known) const {
    const auto put = [&](const FlatPolygon&, double area, const Face* old, const FaceDeviation& d) {
      if (old)
        kept_->put(index_of(face), index_of(*old), {d.from_star, area});
      return d;
    };
    const FaceDeviation deviation = measure_by(face, known, put);
    if (deviation.from_input < known)
      kept_->complete(index_of(face));
    return deviation;
  }

  // Measures by polygons, for each of which mended(polygon, its area, old face, deviation) returns
  // the final value.
  template <class Mended>
  FaceDeviation measure_by(const Face& face, double known, Mended mended) const {
    const FlatTriangle now{x_, face.flat[1], face.flat[2]};
    const double all = flat_area(now);
    FaceDeviation deviation;
    double covered = 0;
    const auto look_at = [&](const FlatTriangle& region, const Face* old, double bound,
                             auto squared) {
      if (lies_next_to(now, region))
        return;
      FlatPolygon polygon(now);
      polygon.clip(region, tolerance());
      if (polygon.empty())
        return;
      double most = 0;
      for (const FlatPoint& y : polygon)
        most = (std::max)(most, squared(y));
      const double area = polygon.area();
      covered += area;
      const double distance = std::sqrt(most);
      deviation.raise_to(mended(polygon, area, old, FaceDeviation{bound + distance, distance}));
    };
    for (const Face* f : faces_)
      if (deviation.from_input < known && flat_area(f->flat) > 0)
        look_at(f->flat, f, f->bound,
                [&](const FlatPoint& y) { return squared_height(y, f->flat); });
    for (const BoundaryStrips::Strip& s : *strips_)
      if (deviation.from_input < known)
        look_at(s.triangle, nullptr, s.bound, [&](const FlatPoint& y) {
          return squared_distance_to_segment(y.point, s.from, s.to);
        });
    if (covered < (1 - 1e-6) * all) // only if it was not looked at to the end
      deviation.from_input = std::numeric_limits<double>::infinity();
    return deviation;
  }

  // Returns the distance of a polygon to any face of the region, if that is very small, otherwise
  // the known distance.
  FaceDeviation nearest_to(const FlatPolygon& polygon, const FaceDeviation& known) const {
    const double enough = rounding(extent_) * rounding(extent_);
    for (const Face* f : faces_) {
      const std::array<Vector<3>, 3>& t = f->corners;
      const auto is_near = [&](const FlatPoint& y) {
        return squared_distance_to_triangle(y.point, t[0], t[1], t[2]) <= enough;
      };
      if (f->bound <= known.from_input && std::all_of(polygon.begin(), polygon.end(), is_near))
        return {f->bound + rounding(extent_), rounding(extent_)};
    }
    return known;
  }

  PolygonTable* kept_ = nullptr;
  std::array<Vector<3>, 2> ends_;
  Index b_ = 0;
  ProjectionPlane plane_;
  BoundaryStrips boundary_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_STAR_PATCH_H
