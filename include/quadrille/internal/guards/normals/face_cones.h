#ifndef QUADRILLE_INTERNAL_GUARDS_NORMALS_FACE_CONES_H
#define QUADRILLE_INTERNAL_GUARDS_NORMALS_FACE_CONES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/star_face.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/guards/normals/normal_cone.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// Updates the cones of the faces around a pair that is contracted.
///
/// A face of one end keeps its cone. A face of both ends becomes the edge of the new vertex and its
/// third vertex: the faces at that edge take its cone. If there are none it maps to nothing, and
/// the cones are incomplete: the edge might come to lie on another one later.
///
/// With free topology, edges and faces of both ends may come to lie on each other though no
/// vanishing face is between them. An edge into which others were merged is in the cone of each
/// face that has it. So if a neighbour of both ends has no vanishing face, the faces of its one
/// edge take the cone of a face at the other; and faces that come to have the same three vertices,
/// of which one is left, take the cones of each other.
class ConesOfStar {
public:
  /// `cone_of(face)`: as it is now.
  template <class ConeOf>
  ConesOfStar(const PairStar& star, Index second, bool is_topology_kept, ConeOf cone_of) {
    star.for_each_changed([&](const StarFace& f) { faces_.push_back({f, cone_of(f.face)}); });
    end_of_first_ = star.first.size();
    for (const StarFace& f : star.shared)
      is_complete_ &= hand_over(cone_of(f.face), f.other_than(second));
    if (!is_topology_kept)
      join_edges(star, second, cone_of);
  }

  struct Face {
    StarFace face;
    NormalCone cone;
  };
  /// Returns the faces that are left, in the order of the star.
  const std::vector<Face>& faces() const { return faces_; }
  /// Has each face that vanishes been taken over by another one?
  bool is_complete() const { return is_complete_; }

private:
  // Hands on the cone of a face that vanishes, with that third vertex; returns false if no face can
  // take it.
  bool hand_over(const NormalCone& cone, Index third) {
    bool is_taken = false;
    for (Face& f : faces_)
      if (f.face.has(third)) {
        f.cone.add(cone);
        is_taken = true;
      }
    return is_taken;
  }

  struct Edge {
    Index third;
    std::size_t face; // that has it
    bool is_of_first; // end
  };

  template <class ConeOf>
  void join_edges(const PairStar& star, Index second, ConeOf cone_of) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const Index v : {faces_[i].face.second, faces_[i].face.third})
        edges.push_back({v, i, i < end_of_first_});
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tuple(a.third, a.face) < std::tuple(b.third, b.face);
    });
    const auto is_at_shared = [&](Index v) {
      return std::any_of(star.shared.begin(), star.shared.end(),
                         [&](const StarFace& f) { return f.other_than(second) == v; });
    };
    for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end) {
      const Index third = begin->third;
      end = std::find_if(begin, edges.end(), [=](const Edge& e) { return e.third != third; });
      // Faces of the first end come first.
      if (begin->is_of_first && !std::prev(end)->is_of_first && !is_at_shared(third)) {
        const NormalCone of_first = cone_of(faces_[begin->face].face.face);
        const NormalCone of_second = cone_of(faces_[std::prev(end)->face].face.face);
        for (auto e = begin; e != end; ++e)
          faces_[e->face].cone.add(e->is_of_first ? of_second : of_first);
      }
    }
    join_duplicates();
  }

  void join_duplicates() {
    std::vector<std::tuple<Index, Index, std::size_t>> sides; // opposite to the new vertex
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto [low, high] = std::minmax(faces_[i].face.second, faces_[i].face.third);
      sides.emplace_back(low, high, i);
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      const auto is_same = [&](std::size_t j) {
        return std::get<0>(sides[j]) == std::get<0>(sides[i]) &&
               std::get<1>(sides[j]) == std::get<1>(sides[i]);
      };
      NormalCone all;
      for (end = i; end < sides.size() && is_same(end); ++end)
        all.add(faces_[std::get<2>(sides[end])].cone);
      for (std::size_t j = i; j < end && end > i + 1; ++j)
        faces_[std::get<2>(sides[j])].cone = all;
    }
  }

  std::vector<Face> faces_;
  std::size_t end_of_first_ = 0;
  bool is_complete_ = true;
};

/// The cone of each face contains the normals of all faces of the input that contractions have
/// mapped into it or onto its edges, if both ends of each pair went to the new vertex. See
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
    if (star.high_valence != none && meets_further_high_valence(star, second))
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

  // At an edge between high-valence vertices the star has one face only.
  bool meets_further_high_valence(const PairStar& star, Index second) const {
    return star.may_meet_high_valence ||
           std::any_of(star.shared.begin(), star.shared.end(), [&](const StarFace& f) {
             return complex_.high_valence_vertices().has(f.other_than(second));
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
