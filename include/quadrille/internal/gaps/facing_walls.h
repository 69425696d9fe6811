#ifndef QUADRILLE_INTERNAL_GAPS_FACING_WALLS_H
#define QUADRILLE_INTERNAL_GAPS_FACING_WALLS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/core/surface/nearest_point.h>
#include <quadrille/internal/gaps/face_boxes.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// A wall of another component that a vertex faces.
struct FacingWall {
  Index component = none; ///< none if there is no wall up to the size
  double distance = 0;
  Vector<3> direction; ///< from the vertex to the nearest point of the wall, of length 1
};

/// The components of a surface, and which walls face each other across a gap: the shortest way from
/// one to the other begins on the outer side of both. So the two sides of a wall do not face each
/// other, however thin it is.
class FacingWalls {
public:
  /// A way and a normal enclose at most the angle of which this is the cosine.
  static constexpr double least_cosine = 0.25;

  /// `component`: of each vertex the component of the surface; both may grow.
  FacingWalls(const HalfEdges& surface, const std::vector<Index>& component, double size)
      : surface_(surface), component_(component), size_(size) {
    std::vector<TriangleCorners> faces(surface.faces());
    for (Index face = 0; face < surface.faces(); ++face) {
      faces[face] = corners(face);
      normal_.push_back(normal_of(faces[face]));
      component_of_face_.push_back(component[surface.triangle(face)[0]]);
    }
    boxes_ = FaceBoxes(std::move(faces));
  }

  /// The faces as they were at first.
  const FaceBoxes& boxes() const { return boxes_; }
  Index component_of_face(Index face) const { return component_of_face_[face]; }
  double size() const { return size_; }

  TriangleCorners corners(Index face) const {
    const auto& [a, b, c] = surface_.triangle(face);
    return {surface_.point(a), surface_.point(b), surface_.point(c)};
  }
  static Vector<3> normal_of(const TriangleCorners& corners) {
    return unit(normal_vector(corners[0], corners[1], corners[2]));
  }
  static Vector<3> unit(const Vector<3>& v) {
    const double length = std::sqrt(squared_length(v));
    return length > 0 ? 1 / length * v : Vector<3>{};
  }

  /// The nearest point, in front of a vertex inside the surface, of other components; it is no wall
  /// if it does not face the vertex.
  FacingWall nearest(Index v) const {
    if (!surface_.is_inside(v))
      return {};
    const Vector<3>& place = surface_.point(v);
    const Vector<3> normal = normal_at(v);
    FacingWall wall;
    double nearest = std::numeric_limits<double>::infinity();
    double most_opposed = 1; // of the faces that are nearest, at most slack farther than others
    boxes_.any_meeting(cube_around(place, size_), [&](Index face) {
      if (component_of_face_[face] == component_[v])
        return false;
      const NearestPoint point = nearest_of_triangle(place, boxes_[face]);
      const double distance = std::sqrt(point.squared_distance);
      if (!(distance <= size_) || distance > nearest * (1 + slack))
        return false;
      const Vector<3> displacement = unit(combination(boxes_[face], point.weights) - place);
      if (distance > 0 && dot(displacement, normal) < least_cosine)
        return false;
      const double cosine = dot(distance > 0 ? displacement : normal, normal_[face]);
      if (distance < nearest * (1 - slack) || cosine < most_opposed) {
        wall = {component_of_face_[face], distance, distance > 0 ? displacement : -normal_[face]};
        most_opposed = cosine;
      }
      nearest = (std::min)(nearest, distance);
      return false;
    });
    return most_opposed <= -least_cosine ? wall : FacingWall{};
  }

  /// Does a face come up to the size to one of another component that faces it?
  bool is_any_near(Index face) const {
    const TriangleCorners at = corners(face);
    const Vector<3> normal = normal_of(at);
    const Index component = component_[surface_.triangle(face)[0]];
    return boxes_.any_meeting(FaceBoxes::box_of(at, size_), [&](Index other) {
      if (component_of_face_[other] == component)
        return false;
      const Vector<3> displacement = shortest_displacement(at, boxes_[other]);
      const double distance = std::sqrt(squared_length(displacement));
      if (!(distance <= size_))
        return false;
      if (!(distance > 0))
        return dot(normal, normal_[other]) <= -least_cosine;
      return dot(displacement, normal) >= least_cosine * distance &&
             dot(displacement, normal_[other]) <= -least_cosine * distance;
    });
  }

private:
  static constexpr double slack = 1e-9;

  // The sum of the normals around a vertex, each by the angle of its face there: it shows which is
  // the outer side. Source: Baerentzen and Aanaes, Signed distance computation using the angle
  // weighted pseudonormal, 2005.
  Vector<3> normal_at(Index v) const {
    Vector<3> sum;
    surface_.for_each_out(v, [&](Index h) {
      const Vector<3> a = surface_.point(surface_.target(h)) - surface_.point(v),
                      b = surface_.point(surface_.origin(HalfEdges::previous(h))) -
                          surface_.point(v);
      const Vector<3> normal = cross(a, b);
      sum += std::atan2(std::sqrt(squared_length(normal)), dot(a, b)) * unit(normal);
    });
    return unit(sum);
  }

  // From one triangle to another that it does not cross.
  static Vector<3> shortest_displacement(const TriangleCorners& from, const TriangleCorners& to) {
    Vector<3> shortest;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Vector<3>& displacement) {
      if (const double squared = squared_length(displacement); squared < least) {
        least = squared;
        shortest = displacement;
      }
    };
    for (std::size_t i = 0; i < 3; ++i) {
      offer(combination(to, nearest_of_triangle(from[i], to).weights) - from[i]);
      offer(to[i] - combination(from, nearest_of_triangle(to[i], from).weights));
      for (std::size_t k = 0; k < 3; ++k)
        offer(between_edges(from[i], from[(i + 1) % 3] - from[i], to[k], to[(k + 1) % 3] - to[k]));
    }
    return shortest;
  }
  // Between the nearest points of two lines, as far as these lie on the edges.
  static Vector<3> between_edges(const Vector<3>& p, const Vector<3>& u, const Vector<3>& q,
                                 const Vector<3>& v) {
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ud = dot(u, q - p),
                 vd = dot(v, q - p), area = uu * vv - uv * uv;
    const double s = area > 0 ? std::clamp((ud * vv - uv * vd) / area, 0., 1.) : 0;
    const double t = area > 0 ? std::clamp((ud * uv - uu * vd) / area, 0., 1.) : 0;
    return q + t * v - (p + s * u);
  }

  const HalfEdges& surface_;
  const std::vector<Index>& component_;
  double size_;
  std::vector<Vector<3>> normal_; // of each face at first
  std::vector<Index> component_of_face_;
  FaceBoxes boxes_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_FACING_WALLS_H
