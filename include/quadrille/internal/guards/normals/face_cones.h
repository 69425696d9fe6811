#ifndef QUADRILLE_INTERNAL_GUARDS_NORMALS_FACE_CONES_H
#define QUADRILLE_INTERNAL_GUARDS_NORMALS_FACE_CONES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/star_face.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/guards/normals/cones_of_star.h>
#include <quadrille/internal/guards/normals/normal_cone.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

namespace quadrille::internal {

/// Of each face, the cone of the normals of all faces of the input that contractions have mapped
/// into it or onto its edges, where both ends of each pair went to the new vertex. See
/// NormalDeviation.
template <std::size_t N>
class FaceCones final : public SurfaceGuard<N> {
public:
  FaceCones(const GuardRoom<N>& room, double degrees)
      : complex_(room.complex), geometry_(room.geometry), is_topology_kept_(room.is_topology_kept),
        limit_(degrees * (std::numbers::pi / 180)) {}

  void begin(Report&) override {
    cones_.resize(complex_.face_capacity());
    for (Index face = 0; face < cones_.size(); ++face)
      if (!complex_.is_removed(face))
        cones_[face] = NormalCone(normal_of(face));
  }

  bool rejects(const GuardedPair<N>& pair) override {
    return is_too_far(pair.star, pair.second, space(pair.target));
  }

  void follow(const GuardedPair<N>& pair, Index) override {
    const ConesOfStar cones = cones_of(pair.star, pair.second);
    for (const ConesOfStar::Face& f : cones.faces())
      cones_[f.face.face] = f.cone;
  }

  void pack() override {
    internal::pack_if(cones_, [this](Index face) { return !complex_.is_removed(face); });
  }

  void end(Report& report) override { report.normal_bound_degrees = greatest_degrees(); }

private:
  bool is_too_far(const PairStar& star, Index second, const Vector<3>& target) const {
    if (star.hub != none && meets_further_hub(star, second))
      return true; // of whose faces not all are known
    const ConesOfStar cones = cones_of(star, second);
    const auto is_face_too_far = [&](const ConesOfStar::Face& f) {
      const FaceNormal normal(target, place(f.face.second), place(f.face.third));
      if (f.cone.is_empty() || normal.is_null())
        return false;
      return !normal.is_known() || f.cone.greatest_angle(normal.direction) + normal.error > limit_;
    };
    return !cones.is_complete() ||
           std::any_of(cones.faces().begin(), cones.faces().end(), is_face_too_far);
  }

  double greatest_degrees() const {
    double greatest = 0;
    for (Index face = 0; face < cones_.size(); ++face) {
      if (complex_.is_removed(face) || cones_[face].is_empty())
        continue;
      if (const FaceNormal normal = normal_of(face); normal.is_known())
        greatest =
            (std::max)(greatest, cones_[face].greatest_angle(normal.direction) + normal.error);
    }
    return greatest * (180 / std::numbers::pi);
  }

  Vector<3> place(Index v) const { return space(geometry_.position(v)); }
  FaceNormal normal_of(Index face) const {
    const auto& v = complex_.vertices(face);
    return {place(v[0]), place(v[1]), place(v[2])};
  }

  ConesOfStar cones_of(const PairStar& star, Index second) const {
    return {star, second, is_topology_kept_, [this](Index face) { return cones_[face]; }};
  }

  // Of an edge between hubs the star has one face only.
  bool meets_further_hub(const PairStar& star, Index second) const {
    return star.may_meet_hub ||
           std::any_of(star.shared.begin(), star.shared.end(), [&](const StarFace& f) {
             return complex_.hubs().has(f.other_than(second));
           });
  }

  const TriangleComplex& complex_;
  const Geometry<N>& geometry_;
  bool is_topology_kept_;
  double limit_; // in radians
  std::vector<NormalCone> cones_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_NORMALS_FACE_CONES_H
