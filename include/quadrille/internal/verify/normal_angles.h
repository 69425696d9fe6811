#ifndef QUADRILLE_INTERNAL_VERIFY_NORMAL_ANGLES_H
#define QUADRILLE_INTERNAL_VERIFY_NORMAL_ANGLES_H

#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Measures how far the normals of a result are from the normals of the input faces that now lie on
/// each face or on one of its edges, according to a map of the vertices. All faces are compared by
/// brute force, without cones.
class NormalAngles {
public:
  /// Both values are in degrees. The truth is between them; they differ by the accuracy to which
  /// doubles determine the normals.
  struct Greatest {
    double at_least = 0, at_most = 0;
    std::size_t face = 0;          ///< the face of the result that has it
    std::size_t unknown = 0;       ///< the number of faces of the result that no input face has
                                   ///< become
    std::size_t first_unknown = 0; ///< the first of these
  };

  /// `vertex_map` gives, for each vertex of the input, the vertex of the result that it has become,
  /// or no vertex of the result if there is none. Throws std::invalid_argument if their number is
  /// not the number of input vertices.
  NormalAngles(const SurfaceView& input, const std::vector<std::size_t>& vertex_map,
               const SurfaceView& result)
      : input_(input), vertex_map_(vertex_map), result_(result) {
    if (vertex_map.size() != input.points.size())
      throw std::invalid_argument(
          "quadrille::verify: the number of images is not the number of vertices of the input");
    std::set<Corners> forward_faces;
    for (std::size_t face = 0; face < result.triangles.size(); ++face)
      if (is_forward(result.triangles[face], forward_faces)) {
        const Corners& f = result.triangles[face];
        faces_[rotated(f)].push_back(face);
        for (std::size_t i = 0; i < 3; ++i)
          at_edges_[std::minmax(f[i], f[(i + 1) % 3])].push_back(face);
      }
  }

  Greatest measure() const {
    Greatest greatest;
    std::set<Corners> forward_faces;
    std::set<std::size_t> known;
    for (const Corners& face : input_.triangles) {
      if (!is_forward(face, forward_faces))
        continue;
      const std::vector<std::size_t> mapped_faces = faces_of(face);
      if (is_face(face))
        known.insert(mapped_faces.begin(), mapped_faces.end());
      if (const auto normal = normal_of(input_, face))
        for (std::size_t mapped : mapped_faces)
          if (const auto other = normal_of(result_, result_.triangles[mapped]))
            take(*normal, *other, mapped, greatest);
    }
    for (const auto& [corners, faces] : faces_)
      for (const std::size_t face : faces)
        if (!known.contains(face))
          greatest.first_unknown =
              greatest.unknown++ == 0 ? face : (std::min)(greatest.first_unknown, face);
    return greatest;
  }

private:
  struct Normal {
    Vector<3> direction;
    double error; ///< in radians
  };

  static Corners rotated(Corners face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  /// The first side of a double-sided face stands for both sides.
  static bool is_forward(const Corners& face, std::set<Corners>& forward_faces) {
    if (forward_faces.contains(rotated({face[1], face[0], face[2]})))
      return false;
    forward_faces.insert(rotated(face));
    return true;
  }

  /// Has the face become a face of the result?
  bool is_face(const Corners& face) const {
    const std::size_t a = vertex_map_[face[0]], b = vertex_map_[face[1]], c = vertex_map_[face[2]];
    return a != b && b != c && c != a;
  }

  /// Returns the faces of the result on which a face of the input lies, or on an edge of which it
  /// lies.
  std::vector<std::size_t> faces_of(const Corners& face) const {
    if (std::any_of(face.begin(), face.end(),
                    [&](std::size_t v) { return vertex_map_[v] >= result_.points.size(); }))
      return {};
    const auto mapped_of = [&](std::size_t i) {
      return static_cast<std::uint32_t>(vertex_map_[face[i]]);
    };
    const Corners mapped{mapped_of(0), mapped_of(1), mapped_of(2)};
    const std::set<std::size_t> different(mapped.begin(), mapped.end());
    if (different.size() == 3)
      return found(faces_, rotated(mapped), rotated({mapped[1], mapped[0], mapped[2]}));
    if (different.size() == 2)
      return found(at_edges_, std::pair(*different.begin(), *different.rbegin()));
    return {};
  }

  /// Returns the value of the first key that the map contains.
  template <class Map, class... Keys>
  static std::vector<std::size_t> found(const Map& map, const Keys&... keys) {
    std::vector<std::size_t> result;
    (void)((map.contains(keys) && (result = map.at(keys), true)) || ...);
    return result;
  }

  /// Returns nothing if doubles do not determine the normal.
  static std::optional<Normal> normal_of(const SurfaceView& surface, const Corners& face) {
    const auto edge = [&](std::size_t i) {
      return surface.points[face[i]] - surface.points[face[0]];
    };
    const Vector<3> e = edge(1), f = edge(2), n = cross(e, f);
    const double length = std::sqrt(squared_length(n));
    const double error = 0x1p-49 * std::sqrt(squared_length(e)) * std::sqrt(squared_length(f));
    if (!(length > 0 && error <= 0.1 * length))
      return std::nullopt;
    return Normal{1 / length * n, error / length};
  }

  static void take(const Normal& a, const Normal& b, std::size_t face, Greatest& greatest) {
    const double angle = std::atan2(std::sqrt(squared_length(cross(a.direction, b.direction))),
                                    dot(a.direction, b.direction));
    const double error = a.error + b.error;
    constexpr double degrees = 180 / std::numbers::pi;
    if (degrees * (angle - error) > greatest.at_least) {
      greatest.at_least = degrees * (angle - error);
      greatest.face = face;
    }
    greatest.at_most = (std::max)(greatest.at_most, degrees * (angle + error));
  }

  SurfaceView input_;
  const std::vector<std::size_t>& vertex_map_;
  SurfaceView result_;
  std::map<Corners, std::vector<std::size_t>> faces_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> at_edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_NORMAL_ANGLES_H
