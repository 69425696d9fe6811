#ifndef QUADRILLE_INTERNAL_VERIFY_UMBRELLAS_OF_SOLID_H
#define QUADRILLE_INTERNAL_VERIFY_UMBRELLAS_OF_SOLID_H

#include <quadrille/internal/verify/checked_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface that is cut to a manifold. At an edge of more than two faces, the faces on both sides
/// of the solid are joined; at a vertex, the faces that are connected in this way form an umbrella.
/// It shares nothing with the engine.
class UmbrellasOfSolid {
public:
  explicit UmbrellasOfSolid(const SurfaceView& surface)
      : surface_(surface), umbrella_(3 * surface.triangles.size()),
        component_(surface.triangles.size()) {
    std::iota(umbrella_.begin(), umbrella_.end(), std::size_t{0});
    std::iota(component_.begin(), component_.end(), std::size_t{0});
    std::map<Edge, std::vector<Side>> sides_of_edge;
    for (std::size_t face = 0; face < surface.triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = vertex(face, i), w = vertex(face, i + 1);
        sides_of_edge[std::minmax(v, w)].push_back({face, i, v < w});
      }
    for (auto& [edge, sides] : sides_of_edge)
      if (!join(edge, sides) && open_edges_++ == 0)
        open_at_ = edge.first;
  }

  /// The number of edges that do not have equally many faces on both sides; everything else
  /// requires that there are none.
  std::size_t open_edges() const { return open_edges_; }
  /// A vertex of the first open edge.
  std::size_t open_at() const { return open_at_; }

  /// Returns one face of the component that a face belongs to; it is the same for all faces of the
  /// component.
  std::size_t component_of(std::size_t face) { return root(component_, face); }

  /// Returns the number of umbrellas, which are the vertices of the manifold, of the faces of a
  /// component.
  std::size_t count(const std::vector<std::size_t>& faces) {
    std::set<std::size_t> roots;
    for (const std::size_t face : faces)
      for (std::size_t i = 0; i < 3; ++i)
        roots.insert(root(umbrella_, 3 * face + i));
    return roots.size();
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;
  using Roots = std::vector<std::size_t>;

  /// A face at an edge, and the corner at which the edge begins in it; does the face traverse the
  /// edge upward, from the lower number to the higher?
  struct Side {
    std::size_t face, corner;
    bool is_up;
    double angle = 0;
  };

  std::size_t vertex(std::size_t face, std::size_t i) const {
    return surface_.triangles[face][i % 3];
  }

  /// Joins the faces at an edge in pairs; false if they do not form pairs of one upward and one
  /// downward face.
  bool join(const Edge& edge, std::vector<Side>& sides) {
    const auto ups =
        std::count_if(sides.begin(), sides.end(), [](const Side& s) { return s.is_up; });
    if (2 * static_cast<std::size_t>(ups) != sides.size())
      return false;
    if (sides.size() > 2)
      sort_around(edge, sides);
    // Seen from the higher end, the solid lies on the right of upward faces and ends at each of
    // them.
    std::vector<std::size_t> open;
    std::vector<bool> is_joined(sides.size(), false);
    const std::size_t n = sides.size();
    for (std::size_t step = 0; step < 2 * n; ++step) {
      const std::size_t i = step % n;
      if (!sides[i].is_up && step < n)
        open.push_back(i);
      else if (sides[i].is_up && !open.empty() && !is_joined[i]) {
        is_joined[i] = true;
        join(sides[open.back()], sides[i]);
        open.pop_back();
      }
    }
    return true;
  }

  /// Among faces on the same three vertices, upward ones come first: nothing lies between them.
  void sort_around(const Edge& edge, std::vector<Side>& sides) const {
    const Vector<3>& low = surface_.points[edge.first];
    const Vector<3> axis = surface_.points[edge.second] - low;
    const auto away = [&](const Side& side) {
      return cross(axis, surface_.points[vertex(side.face, side.corner + 2)] - low);
    };
    const Vector<3> x = away(sides.front()), y = cross(axis, x);
    for (Side& side : sides)
      side.angle =
          std::atan2(dot(away(side), y) / std::sqrt(squared_length(axis)), dot(away(side), x));
    const auto key = [this](const Side& side) {
      return std::tuple(side.angle, vertex(side.face, side.corner + 2), !side.is_up, side.face);
    };
    std::sort(sides.begin(), sides.end(),
              [&](const Side& a, const Side& b) { return key(a) < key(b); });
  }

  void join(const Side& down, const Side& up) {
    unite(umbrella_, corner(down, 0), corner(up, 1));
    unite(umbrella_, corner(down, 1), corner(up, 0));
    unite(component_, down.face, up.face);
  }
  static std::size_t corner(const Side& side, std::size_t i) {
    return 3 * side.face + (side.corner + i) % 3;
  }

  static std::size_t root(Roots& of, std::size_t i) {
    while (of[i] != i)
      i = of[i] = of[of[i]];
    return i;
  }
  static void unite(Roots& of, std::size_t a, std::size_t b) { of[root(of, a)] = root(of, b); }

  SurfaceView surface_;
  Roots umbrella_; // for each corner, another one of its umbrella, or itself
  Roots component_; // for each face, another one of its component, or itself
  std::size_t open_edges_ = 0, open_at_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_UMBRELLAS_OF_SOLID_H
