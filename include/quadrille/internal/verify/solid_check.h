#ifndef QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H
#define QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H

#include <quadrille/internal/verify/checked_surface.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>
#include <boost/ref.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What solids have, and a surface that is none has not.
struct SolidMeasures {
  std::size_t open_edges = 0;      ///< that have not as many faces on one side as on the other
  std::size_t components = 0;      ///< pieces of the surface, cut where it only touches itself
  std::ptrdiff_t euler_number = 0; ///< of all of them: twice their number, less twice their genus
  std::size_t nesting = 0;         ///< the sum over them of how many others they lie in
  bool bounds_a_volume = false;    ///< as CGAL says
};

/// Measures a surface as CGAL sees it, once it has been cut to a manifold: at an edge of more than
/// two faces, those are joined between which the solid lies; at a vertex, the faces that this
/// connects. It shares nothing with the engine.
class SolidCheck {
public:
  explicit SolidCheck(const CheckedSurface& surface)
      : surface_(surface), umbrella_(3 * surface.faces.size()) {
    std::iota(umbrella_.begin(), umbrella_.end(), std::size_t{0});
    for (std::size_t face = 0; face < surface.faces.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = vertex(face, i), w = vertex(face, i + 1);
        sides_of_edge_[std::minmax(v, w)].push_back({face, i, v < w});
      }
  }

  SolidMeasures measure() {
    SolidMeasures measures;
    for (auto& [edge, sides] : sides_of_edge_)
      measures.open_edges += !join(edge, sides);
    if (measures.open_edges > 0 || surface_.faces.empty())
      return measures;
    Mesh mesh;
    const auto [points, faces] = cut();
    namespace PMP = CGAL::Polygon_mesh_processing;
    if (!PMP::is_polygon_soup_a_polygon_mesh(faces))
      return measures;
    PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
    measures.euler_number = static_cast<std::ptrdiff_t>(mesh.number_of_vertices()) -
                            static_cast<std::ptrdiff_t>(mesh.number_of_edges()) +
                            static_cast<std::ptrdiff_t>(mesh.number_of_faces());
    measures.bounds_a_volume = CGAL::is_closed(mesh) && PMP::does_bound_a_volume(mesh);
    std::vector<std::size_t> levels;
    PMP::volume_connected_components(
        mesh, CGAL::Constant_property_map<Mesh::Face_index, std::size_t>(0),
        CGAL::parameters::nesting_levels(boost::ref(levels)).do_orientation_tests(false));
    measures.components = (std::max)(levels.size(), std::size_t{1});
    measures.nesting = std::accumulate(levels.begin(), levels.end(), std::size_t{0});
    return measures;
  }

private:
  using Mesh = CGAL::Surface_mesh<ExactKernel::Point_3>;
  using Edge = std::pair<std::size_t, std::size_t>;

  /// A face at an edge, which begins in that place of its corners; does it run up the edge, from
  /// the lower number to the higher?
  struct Side {
    std::size_t face, corner;
    bool is_up;
    double angle = 0;
  };

  std::size_t vertex(std::size_t face, std::size_t i) const { return surface_.faces[face][i % 3]; }

  /// Joins the faces at an edge in pairs; false if they do not go up in pairs.
  bool join(const Edge& edge, std::vector<Side>& sides) {
    const auto ups =
        std::count_if(sides.begin(), sides.end(), [](const Side& s) { return s.is_up; });
    if (2 * static_cast<std::size_t>(ups) != sides.size())
      return false;
    if (sides.size() > 2)
      sort_around(edge, sides);
    // Seen from the higher end, the solid lies on the right of faces that run up: each ends there.
    std::vector<std::size_t> open;
    const std::size_t n = sides.size();
    for (std::size_t step = 0; step < 2 * n; ++step) {
      const Side& side = sides[step % n];
      if (!side.is_up && step < n)
        open.push_back(step % n);
      else if (side.is_up && !open.empty() && !is_joined(side)) {
        join(sides[open.back()], side);
        open.pop_back();
      }
    }
    return true;
  }

  void sort_around(const Edge& edge, std::vector<Side>& sides) const {
    const auto& low = surface_.points[edge.first];
    const auto axis = surface_.points[edge.second] - low;
    const auto away = [&](const Side& side) {
      return CGAL::cross_product(axis, surface_.points[vertex(side.face, side.corner + 2)] - low);
    };
    const auto x = away(sides.front());
    const auto y = CGAL::cross_product(axis, x);
    for (Side& side : sides)
      side.angle = std::atan2(away(side) * y / std::sqrt(axis.squared_length()), away(side) * x);
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.angle < b.angle; });
  }

  bool is_joined(const Side& side) const { return joined_.contains(3 * side.face + side.corner); }
  void join(const Side& down, const Side& up) {
    joined_.insert(3 * up.face + up.corner);
    unite(corner(down, 0), corner(up, 1));
    unite(corner(down, 1), corner(up, 0));
  }
  static std::size_t corner(const Side& side, std::size_t i) {
    return 3 * side.face + (side.corner + i) % 3;
  }

  std::size_t root(std::size_t corner) {
    while (umbrella_[corner] != corner)
      corner = umbrella_[corner] = umbrella_[umbrella_[corner]];
    return corner;
  }
  void unite(std::size_t a, std::size_t b) { umbrella_[root(a)] = root(b); }

  /// A point for each umbrella.
  std::pair<std::vector<ExactKernel::Point_3>, std::vector<Corners>> cut() {
    std::vector<ExactKernel::Point_3> points;
    std::vector<Corners> faces(surface_.faces.size());
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t corner = 0; corner < umbrella_.size(); ++corner) {
      const auto [at, is_new] = numbers.try_emplace(root(corner), points.size());
      if (is_new)
        points.push_back(surface_.points[surface_.faces[corner / 3][corner % 3]]);
      faces[corner / 3][corner % 3] = at->second;
    }
    return {std::move(points), std::move(faces)};
  }

  const CheckedSurface& surface_;
  std::map<Edge, std::vector<Side>> sides_of_edge_;
  std::vector<std::size_t> umbrella_; // of each corner, another one of it, or itself
  std::set<std::size_t> joined_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H
