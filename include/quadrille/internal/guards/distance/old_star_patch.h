#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_OLD_STAR_PATCH_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_OLD_STAR_PATCH_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/guards/distance/boundary_strips.h>
#include <quadrille/internal/guards/distance/polygon_table.h>
#include <quadrille/internal/guards/distance/star_patch.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Faces of one fan of a star, wound alike, of which old ones are compared with new ones: the
/// same the other way round.
///
/// As long as no old face is turned over in the plane, the polygons leave nothing out, whatever the
/// new faces look like: each point lies under a new face or under a strip beyond the new boundary.
class OldStarPatch : public StarPatch {
public:
  /// The faces of a table come after this one.
  void look_up_from(const Face* first) { first_ = first; }

  /// Takes old faces that are turned over, or are nearly, out of the region. Were there any?
  bool leaves_steep_old_ones() {
    return std::erase_if(faces_, [](const Face* f) {
             const double flat = flat_area(f->flat);
             return !(flat > 0 && flat * flat > steepest * steepest * squared_length(f->area));
           }) > 0;
  }

  /// Projects the new faces into the plane, which measure_old() needs in addition to the strips.
  void find_new_faces() {
    new_.clear();
    for (const Face* f : faces_)
      if (!f->is_shared)
        if (const FlatTriangle now{x_, f->flat[1], f->flat[2]}; flat_area(now) > 0)
          new_.push_back({f, now});
  }

  /// Are the polygons of all its new faces in a table?
  bool has_all_polygons(const PolygonTable& table) const {
    return std::all_of(faces_.begin(), faces_.end(), [&](const Face* f) {
      return f->is_shared || table.is_complete(index_of(*f));
    });
  }

  /// Measures how far the points of an old face are from new ones, by its polygons, each of which
  /// lies under one new face, or under a strip beyond the new boundary: visit(face, distance) for
  /// the current new face. Returns false if a distance is not less than the known one, or if there
  /// is no new face. Polygons of the whole fan that are in a table are not cut again.
  template <class Visit>
  bool measure_old(const Face& face, double known, const PolygonTable* table, Visit visit) const {
    double covered = 0;
    const auto take = [&](const Face* now, double area, double distance) {
      covered += area;
      if (!now || !(distance < known))
        return false;
      visit(*now, distance);
      return true;
    };
    const bool is_thin = flat_area(face.flat) < squared_width(face.flat) / 8;
    for (const NewFace& f : new_)
      if (const auto* polygon = is_thin ? nullptr : known_polygon(table, *f.face, face)) {
        // A height is measured at points of the new face, so it is rounded once more.
        if (polygon->distance >= 0 &&
            !take(f.face, polygon->area, polygon->distance + rounding(extent_)))
          return false;
      } else if (!cut(
                     face, f.now, f.face,
                     [&](const FlatPoint& y) { return squared_height(y, f.now); }, take)) {
        return false;
      }
    for (const BoundaryStrips::Strip& s : *strips_)
      if (!cut(
              face, s.triangle, new_face_next_to(s.neighbour),
              [&](const FlatPoint& y) {
                return squared_distance_to_segment(y.point, s.from, s.to);
              },
              take))
        return false;
    return covered >= (1 - 1e-6) * flat_area(face.flat);
  }

private:
  struct NewFace {
    const Face* face;
    FlatTriangle now;
  };

  // None where it has to be cut: over a face that is thin its heights may be off along it, and what
  // is next to nothing has to be looked at.
  const PolygonTable::Polygon* known_polygon(const PolygonTable* table, const Face& now,
                                             const Face& old) const {
    if (!table || !table->is_complete(index_of(now)))
      return nullptr;
    const PolygonTable::Polygon& polygon = (*table)(index_of(now), index_of(old));
    return may_be_noise(polygon.distance) ? nullptr : &polygon;
  }

  // Finds the polygon of an old face that lies under some of the new ones, if there is one:
  // take(new face, its area, distance).
  template <class Squared, class Take>
  bool cut(const Face& face, const FlatTriangle& region, const Face* now, Squared squared,
           Take take) const {
    if (lies_next_to(face.flat, region))
      return true;
    FlatPolygon polygon(face.flat);
    polygon.clip(region, tolerance());
    if (polygon.empty())
      return true;
    double most = 0;
    for (const FlatPoint& y : polygon)
      most = (std::max)(most, squared(y));
    const double distance = std::sqrt(most);
    if (may_be_noise(distance))
      if (const Face* nearest = new_face_at(polygon))
        return take(nearest, polygon.area(), rounding(extent_));
    return take(now, polygon.area(), distance);
  }

  // Returns the squared length of the longest edge, in the plane.
  static double squared_width(const FlatTriangle& t) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const FlatPoint &p = t[i], &q = t[i == 2 ? 0 : i + 1];
      most = (std::max)(most, (q.u - p.u) * (q.u - p.u) + (q.v - p.v) * (q.v - p.v));
    }
    return most;
  }

  // Returns a new face that contains the whole polygon, up to roundings; or none.
  const Face* new_face_at(const FlatPolygon& polygon) const {
    const double enough = rounding(extent_) * rounding(extent_);
    for (const NewFace& f : new_)
      if (std::all_of(polygon.begin(), polygon.end(), [&](const FlatPoint& y) {
            return squared_distance_to_triangle(y.point, f.now[0].point, f.now[1].point,
                                                f.now[2].point) <= enough;
          }))
        return f.face;
    return nullptr;
  }
  // One that has the edge from the new place to a neighbour; or none.
  const Face* new_face_next_to(Index neighbour) const {
    for (const Face* f : faces_)
      if (!f->is_shared && (f->second == neighbour || f->third == neighbour))
        return f;
    return nullptr;
  }

  std::vector<NewFace> new_; // not turned over
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_OLD_STAR_PATCH_H
