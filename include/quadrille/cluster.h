#ifndef QUADRILLE_CLUSTER_H
#define QUADRILLE_CLUSTER_H

#include <quadrille/internal/core/base/compiler.h> // first, since it tells what compiler this needs

#include <quadrille/internal/cluster/cell_grid.h>
#include <quadrille/internal/cluster/cell_vertices.h>
#include <quadrille/internal/cluster/clustered_soup.h>
#include <quadrille/internal/cluster/clusters.h>
#include <quadrille/internal/cluster/face_count_search.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric_form.h>
#include <quadrille/stop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <ranges>
#include <string>
#include <variant>
#include <vector>

/// \file
/// Uniform vertex clustering: what simplification by pairs is compared with, and a
/// fast way for surfaces that are too large for anything else.

namespace quadrille {

/// That many cells along each axis, from 1 to 2⁵². They fill the bounding box.
struct Grid {
  std::size_t x; ///< cells along the first axis
  std::size_t y; ///< cells along the second axis
  std::size_t z; ///< cells along the third axis

  friend bool operator==(const Grid&, const Grid&) = default; ///< equal along each axis
};

/// Cubes with an edge of that length, in the unit of the points, from the lower corner of the
/// bounding box on.
struct CellSize {
  double edge; ///< above 0 and finite
};

/// What the cells of cluster_vertices() are. FaceCount{n}: cubes as small as the box can be cut
/// into, a whole number of them along its longest side, that leave at most n faces.
using ClusterCells = std::variant<Grid, CellSize, FaceCount>;

/// Where in its cell a vertex is.
enum class ClusterPlacement {
  mean,   ///< at the mean of the cell's points
  quadric ///< where it is nearest to the planes of the triangles at these points
};

/// What cluster_vertices() did. It prints itself in one line.
struct ClusterReport {
  std::size_t faces_before = 0;    ///< triangles of the soup
  std::size_t faces_after = 0;     ///< triangles of the result
  std::size_t vertices_before = 0; ///< points of the soup
  std::size_t vertices_after = 0;  ///< points of the result
  /// Triangles that went because one between the same three cells is left.
  std::size_t doubled_faces = 0;
  Grid cells{};   ///< along each axis
  Vector<3> cell; ///< the lengths of its edges: no point has moved by more than its diagonal
};

/// Prints a report in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const ClusterReport& report) {
  return out << report.faces_before << " -> " << report.faces_after << " faces, "
             << report.vertices_before << " -> " << report.vertices_after << " vertices, "
             << report.cells.x << " x " << report.cells.y << " x " << report.cells.z << " cells, "
             << report.doubled_faces << " doubled faces";
}

namespace internal {

/// The points of a soup as clustering takes them.
template <class P>
concept ClusteredPoints = std::ranges::random_access_range<P> && requires(P& points) {
  points.push_back(points[0]);
  requires NamedPoint<std::ranges::range_value_t<P>> || IndexedPoint<std::ranges::range_value_t<P>>;
};

template <class Soup>
CellGrid grid_of(const Soup& soup, const Grid& grid, Clusters&) {
  if (grid.x == 0 || grid.y == 0 || grid.z == 0)
    refuse_clustering("a grid of " + std::to_string(grid.x) + " x " + std::to_string(grid.y) +
                      " x " + std::to_string(grid.z) + " cells has none");
  return CellGrid(soup.box(), {static_cast<double>(grid.x), static_cast<double>(grid.y),
                               static_cast<double>(grid.z)});
}

template <class Soup>
CellGrid grid_of(const Soup& soup, const CellSize& size, Clusters&) {
  if (!(size.edge > 0) || !std::isfinite(size.edge))
    refuse_clustering("CellSize " + text_of(size.edge) + " is no length");
  return CellGrid::of_cubes(soup.box(), soup.scale().length_from_mesh(size.edge));
}

template <class Soup>
CellGrid grid_of(const Soup& soup, const FaceCount& count, Clusters& scratch) {
  return FaceCountSearch::grid(soup, count.faces, scratch);
}

/// Writes the cells with a face to the soup, in their order.
template <class Soup>
void write_clusters(Soup& soup, const Clusters& clusters, const CellVertices& vertices) {
  std::vector<Index> number(clusters.cell_count(), none);
  for (Index f : clusters.faces())
    for (Index v : soup.corners(f))
      number[clusters.cell(v)] = 0;
  std::vector<Index> cells;
  for (Index cell = 0; cell < number.size(); ++cell)
    if (number[cell] != none) {
      number[cell] = static_cast<Index>(cells.size());
      cells.push_back(cell);
    }
  soup.rewrite(
      cells.size(),
      [&](std::size_t i) {
        return soup.moved(vertices.first(cells[i]), vertices.position(cells[i]));
      },
      clusters.faces(), [&](Index v) { return number[clusters.cell(v)]; });
}

} // namespace internal

/// Makes the points in each cell of a grid one, in place, whatever the soup.
///
/// `points` and `triangles` are random-access containers: of points of a CGAL kernel or of three
/// floating-point numbers, as std::array<float, 3>, and of three indices each. The box of the grid
/// is that of the points that triangles use; a point on the side between two cells is in the upper
/// one. Triangles with two corners in one cell go, and with them edges and points that Rossignac
/// and Borrel keep; of those between the same three cells, whichever way they look, the first is
/// left. So the two sheets of a wall that is thinner than a cell become one, with the orientation
/// of one of them; parts that are close to each other grow together, those that are smaller than a
/// cell vanish, and edges of any number of faces may arise. Points and triangles that are left keep
/// their order, a point that is alone in its cell its place; points of no triangle are dropped.
///
/// With ClusterPlacement::quadric a vertex is where the sum of the squared distances to the planes
/// of the triangles at its cell's points, weighted by area, is least: on the edge or at the corner
/// of a box. Where planes leave directions free, it is as near to the mean as that, and where its
/// cell ends, it goes no further.
///
/// Expected time O(n + m) for n points and m triangles; with FaceCount three to five times that.
/// Memory beside the soup and the result: 5 bytes a point, for each cell with points 80 to 100,
/// with quadrics 80 more, and for each triangle that is left 24 to 48.
///
/// Throws std::invalid_argument for a face that is not a triangle or names a point that is not
/// there, a point that is not finite, a grid of no cells, of more than 2⁵² along an axis or more
/// than 2⁶³ in all, a CellSize that is no length; std::length_error above 2³² − 2 points or
/// triangles. If it throws, the soup is as it was.
///
/// Source: Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes,
/// 1993 (without their weights); placement by quadrics: Lindstrom, Out-of-core simplification of
/// large polygonal models, 2000.
template <class Points, class Triangles>
requires internal::ClusteredPoints<Points> && internal::TriangleContainer<Triangles>
    ClusterReport cluster_vertices(Points& points, Triangles& triangles, const ClusterCells& cells,
                                   ClusterPlacement placement = ClusterPlacement::mean) {
  internal::ClusteredSoup soup(points, triangles);
  ClusterReport report;
  report.faces_before = soup.triangle_count();
  report.vertices_before = soup.point_count();
  internal::Clusters clusters;
  const internal::CellGrid grid = std::visit(
      [&](const auto& choice) { return internal::grid_of(soup, choice, clusters); }, cells);
  const auto [x, y, z] = grid.counts();
  if (!grid.is_numbered())
    internal::refuse_clustering(internal::text_of(x) + " x " + internal::text_of(y) + " x " +
                                internal::text_of(z) + " cells are too many");
  report.cells = {static_cast<std::size_t>(x), static_cast<std::size_t>(y),
                  static_cast<std::size_t>(z)};
  for (std::size_t i = 0; i < 3; ++i)
    report.cell[i] = soup.scale().length_of_mesh(grid.width()[i]);

  clusters.assign(soup, grid);
  report.doubled_faces = clusters.doubled_faces();
  internal::CellVertices vertices(soup, clusters);
  if (placement == ClusterPlacement::quadric)
    vertices.minimize_quadrics(soup, clusters, grid);
  internal::write_clusters(soup, clusters, vertices);
  report.faces_after = soup.triangle_count();
  report.vertices_after = soup.point_count();
  return report;
}

} // namespace quadrille

#endif // QUADRILLE_CLUSTER_H
