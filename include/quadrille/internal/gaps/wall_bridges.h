#ifndef QUADRILLE_INTERNAL_GAPS_WALL_BRIDGES_H
#define QUADRILLE_INTERNAL_GAPS_WALL_BRIDGES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/gaps/bridge.h>
#include <quadrille/internal/gaps/face_boxes.h>
#include <quadrille/internal/gaps/facing_walls.h>
#include <quadrille/internal/gaps/wall_disc.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Bridges between walls that face each other.
///
/// From two faces opposite to each other, the faces of each wall that face the other one form a
/// disc, in a ball that is made smaller until they do, and until a bridge between both loops
/// crosses nothing. The discs are taken out, and the bridge comes in.
class WallBridges {
public:
  /// The surface and its walls must stay as they are. `component`: of each vertex.
  WallBridges(const HalfEdges& surface, const std::vector<Index>& component,
              const FacingWalls& walls)
      : surface_(surface), component_(component), walls_(walls),
        is_removed_(surface.faces(), false) {
    for (Index v = 0; v < surface.vertices(); ++v)
      wall_.push_back(walls.nearest(v));
  }

  /// The wall that a vertex faces.
  const FacingWall& wall(Index v) const { return wall_[v]; }

  /// Calls visit(triangle, like) for all faces that are left and then for those of bridges, with
  /// the face itself or the one of which the bridge has a side.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (Index face = 0; face < surface_.faces(); ++face)
      if (!is_removed_[face])
        visit(surface_.triangle(face), face);
    for (const Built& bridge : bridges_)
      for (const Bridge::Face& face : bridge.faces)
        visit(face.vertices, HalfEdges::face(face.side));
  }

  /// Builds a bridge as wide as the walls are near each other, from a vertex to the wall that it
  /// faces. Returns whether that could be done; nothing if no face at either end faces the other
  /// wall altogether.
  std::optional<bool> build_wide(Index v) {
    const auto [near_face, far_face, centre] = ends_at(v);
    if (near_face == none || far_face == none || !faces_wall(near_face, wall_[v].component) ||
        !faces_wall(far_face, component_[v]))
      return std::nullopt;
    for (double radius = std::numeric_limits<double>::infinity();;) {
      const WallDisc near = disc(near_face, wall_[v].component, centre, radius),
                     far = disc(far_face, component_[v], centre, radius);
      if (connect(near, far))
        return true;
      if (near.faces().size() == 1 && far.faces().size() == 1)
        return false;
      radius = shrinkage * (std::min)(radius, (std::max)(near.radius(centre), far.radius(centre)));
    }
  }

  /// Builds a narrow one: from all faces around a vertex, or one of them, to those around a vertex
  /// opposite to it.
  std::optional<bool> build_narrow(Index v) {
    const auto [near_face, far_face, centre] = ends_at(v);
    if (near_face == none || far_face == none)
      return std::nullopt;
    const std::vector<WallDisc> near =
                                    small_discs(v, wall_[v].component, wall_[v].direction, centre),
                                far = small_discs(nearest_corner(far_face, v), component_[v],
                                                  -wall_[v].direction, centre);
    for (const WallDisc& a : near)
      for (const WallDisc& b : far)
        if (connect(a, b))
          return true;
    return false;
  }

private:
  struct Ends {
    Index near, far; ///< faces
    Vector<3> centre;
  };
  struct Built {
    FaceBoxes boxes;
    std::vector<Bridge::Face> faces;
  };
  using Rank = std::tuple<bool, double, Index>; // the least is the best

  Ends ends_at(Index v) const {
    const FacingWall& wall = wall_[v];
    const Vector<3> centre = surface_.point(v) + 0.5 * wall.distance * wall.direction;
    const std::vector<Index> faces = faces_at(v, wall.component, wall.direction, centre);
    return {faces.empty() ? none : faces.front(), face_opposite(v), centre};
  }

  std::vector<WallDisc> small_discs(Index v, Index wall, const Vector<3>& displacement,
                                    const Vector<3>& centre) const {
    std::vector<WallDisc> discs;
    for (const Index first : faces_at(v, wall, displacement, centre)) {
      if (discs.empty())
        discs.emplace_back(surface_, first, [&](Index face) {
          const auto& triangle = surface_.triangle(face);
          return std::find(triangle.begin(), triangle.end(), v) != triangle.end() &&
                 may_open(face, centre);
        });
      discs.emplace_back(surface_, first, [](Index) { return false; });
    }
    return discs;
  }
  Index nearest_corner(Index face, Index v) const {
    const auto& triangle = surface_.triangle(face);
    return *std::min_element(triangle.begin(), triangle.end(), [&](Index a, Index b) {
      return squared_distance(surface_.point(a), surface_.point(v)) <
             squared_distance(surface_.point(b), surface_.point(v));
    });
  }

  WallDisc disc(Index first, Index wall, const Vector<3>& centre, double radius) const {
    return {surface_, first, [&](Index face) {
              return !is_removed_[face] && faces_wall(face, wall) &&
                     is_in_ball(face, centre, radius);
            }};
  }
  bool faces_wall(Index face, Index wall) const {
    Vector<3> displacement;
    for (const Index v : surface_.triangle(face)) {
      if (wall_[v].component != wall)
        return false;
      displacement += wall_[v].direction;
    }
    return dot(FacingWalls::unit(displacement), normal(face)) >= FacingWalls::least_cosine;
  }
  bool is_in_ball(Index face, const Vector<3>& centre, double radius) const {
    for (const Index v : surface_.triangle(face))
      if (squared_distance(surface_.point(v), centre) > radius * radius)
        return false;
    return true;
  }
  Vector<3> normal(Index face) const { return FacingWalls::normal_of(walls_.corners(face)); }

  // The faces at a vertex that look along a way to a wall, the best ones first.
  std::vector<Index> faces_at(Index v, Index wall, const Vector<3>& displacement,
                              const Vector<3>& centre) const {
    std::vector<Rank> ranks;
    surface_.for_each_out(v, [&](Index h) {
      const Index face = HalfEdges::face(h);
      if (const Rank rank = rank_of(face, wall, displacement);
          std::get<1>(rank) < 0 && may_open(face, centre))
        ranks.push_back(rank);
    });
    std::sort(ranks.begin(), ranks.end());
    std::vector<Index> faces;
    for (const Rank& rank : ranks)
      faces.push_back(std::get<2>(rank));
    return faces;
  }
  // Faces that face the wall altogether come first, and then those that look most along the way.
  Rank rank_of(Index face, Index wall, const Vector<3>& displacement) const {
    return {!faces_wall(face, wall), -dot(normal(face), displacement), face};
  }
  // The best of the faces that are nearest to a vertex.
  Index face_opposite(Index v) const {
    const FacingWall& wall = wall_[v];
    const Vector<3>& place = surface_.point(v);
    const double radius = wall.distance * (1 + 1e-6);
    std::optional<Rank> best;
    walls_.boxes().any_meeting(cube_around(place, radius), [&](Index face) {
      if (walls_.component_of_face(face) != wall.component || !may_open(face, place) ||
          nearest_of_triangle(place, walls_.boxes()[face]).squared_distance > radius * radius)
        return false;
      const Rank rank = rank_of(face, component_[v], -wall.direction);
      if (std::get<1>(rank) < 0 && (!best || rank < *best))
        best = rank;
      return false;
    });
    return best ? std::get<2>(*best) : none;
  }
  // Is a face inside the surface, still there, and close to a place, or near its wall altogether?
  bool may_open(Index face, const Vector<3>& place) const {
    const auto& [a, b, c] = surface_.triangle(face);
    return !is_removed_[face] && surface_.is_inside(a) && surface_.is_inside(b) &&
           surface_.is_inside(c) &&
           (is_in_ball(face, place, 2 * walls_.size()) ||
            (wall_[a].component != none && faces_wall(face, wall_[a].component)));
  }

  // Puts a bridge in the place of two discs if it goes from one to the other without crossing
  // anything.
  bool connect(const WallDisc& near, const WallDisc& far) {
    if (near.loop().empty() || far.loop().empty() ||
        near.loop().size() * far.loop().size() > most_steps)
      return false;
    const Bridge bridge(surface_, near.loop(), far.loop());
    set_removed(near, far, true);
    std::vector<FaceCorners> faces;
    for (const Bridge::Face& face : bridge.faces())
      faces.push_back(face_corners(face.vertices));
    if (!fills(faces, near, far) || crosses(faces)) {
      set_removed(near, far, false);
      return false;
    }
    std::vector<TriangleCorners> corners;
    for (const FaceCorners& face : faces)
      corners.push_back(face.points);
    bridges_.push_back({FaceBoxes(std::move(corners)), bridge.faces()});
    return true;
  }
  void set_removed(const WallDisc& near, const WallDisc& far, bool is_removed) {
    for (const WallDisc* disc : {&near, &far})
      for (const Index face : disc->faces())
        is_removed_[face] = is_removed;
  }
  FaceCorners face_corners(const std::array<Index, 3>& vertices) const {
    return {
        vertices,
        {surface_.point(vertices[0]), surface_.point(vertices[1]), surface_.point(vertices[2])}};
  }

  // Is the volume between the discs and the bridge not negative, up to rounding?
  bool fills(const std::vector<FaceCorners>& faces, const WallDisc& near,
             const WallDisc& far) const {
    const Vector<3>& origin = faces.front().points[0];
    double volume = 0, size = 0;
    const auto add = [&](const TriangleCorners& t, double sign) {
      const double term = dot(t[0] - origin, cross(t[1] - origin, t[2] - origin));
      volume += sign * term;
      size += std::abs(term);
    };
    for (const FaceCorners& face : faces)
      add(face.points, 1);
    for (const WallDisc* disc : {&near, &far})
      for (const Index face : disc->faces())
        add(walls_.corners(face), -1);
    return volume >= -1e-9 * size;
  }

  bool crosses(const std::vector<FaceCorners>& faces) const {
    std::vector<TriangleCorners> corners;
    for (const FaceCorners& face : faces)
      corners.push_back(face.points);
    const FaceBoxes own(std::move(corners));
    for (Index i = 0; i < own.size(); ++i) {
      const FloatBox box = FaceBoxes::box_of(own[i]);
      const auto meets = [&](const FaceCorners& other) {
        return TrianglePair(faces[i], other).intersect();
      };
      if (own.any_meeting(box, [&](Index j) { return j > i && meets(faces[j]); }) ||
          walls_.boxes().any_meeting(box, [&](Index face) {
            return !is_removed_[face] && meets(face_corners(surface_.triangle(face)));
          }))
        return true;
      for (const Built& bridge : bridges_)
        if (bridge.boxes.whole().meets(box) && bridge.boxes.any_meeting(box, [&](Index j) {
              return meets(face_corners(bridge.faces[j].vertices));
            }))
          return true;
    }
    return false;
  }

  static constexpr std::size_t most_steps = std::size_t{1} << 26;
  static constexpr double shrinkage = 0.7;

  const HalfEdges& surface_;
  const std::vector<Index>& component_;
  const FacingWalls& walls_;
  std::vector<FacingWall> wall_; // of each vertex
  std::vector<bool> is_removed_; // of each face, whether it has given way to a bridge
  std::vector<Built> bridges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_WALL_BRIDGES_H
