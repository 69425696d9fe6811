#ifndef QUADRILLE_CLUSTER_H
#define QUADRILLE_CLUSTER_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

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
/// Uniform vertex clustering: the usual baseline for simplification by pair contraction, and a fast
/// method for surfaces that are too large for anything else.

namespace quadrille {

/// The number of cells along each axis, from 1 to 2⁵². The cells fill the bounding box.
struct Grid {
  std::size_t x; ///< cells along the first axis
  std::size_t y; ///< cells along the second axis
  std::size_t z; ///< cells along the third axis

  /// compares the counts along each axis
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Cubes with an edge of this length, in the unit of the points. The first one starts at the lower
/// corner of the bounding box.
struct CellSize {
  double edge; ///< above 0 and finite
};

/// The cells of cluster_vertices(). FaceCount{n} chooses the smallest cubes that leave at most n
/// faces, with a whole number of them along the longest side of the box.
using ClusterCells = std::variant<Grid, CellSize, FaceCount>;

/// The position of a vertex in its cell.
enum class ClusterPlacement {
  mean,   ///< at the mean of the cell's points
  quadric ///< the point of least squared distance to the planes of the triangles at these points
};

/// The report of cluster_vertices(). It can be printed in one line.
struct ClusterReport {
  std::size_t faces_before = 0;    ///< triangles of the soup
  std::size_t faces_after = 0;     ///< triangles of the result
  std::size_t vertices_before = 0; ///< points of the soup
  std::size_t vertices_after = 0;  ///< points of the result
  /// Triangles that were removed because another one joins the same three cells.
  std::size_t doubled_faces = 0;
  Grid cells{};   ///< along each axis
  Vector<3> cell; ///< the lengths of a cell's edges: no point has moved by more than the cell's
                  ///< diagonal
};

/// Prints a report in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const ClusterReport& report) {
  return out << report.faces_before << " -> " << report.faces_after << " faces, "
             << report.vertices_before << " -> " << report.vertices_after << " vertices, "
             << report.cells.x << " x " << report.cells.y << " x " << report.cells.z << " cells, "
             << report.doubled_faces << " duplicate faces";
}

namespace internal {

/// The points of a soup that clustering accepts.
template <class P>
concept ClusteredPoints = std::ranges::random_access_range<P> && requires(P& points) {
  points.push_back(points[0]);
  requires NamedPoint<std::ranges::range_value_t<P>> || IndexedPoint<std::ranges::range_value_t<P>>;
};

template <class Soup>
CellGrid grid_of(const Soup& soup, const Grid& grid, Clusters&) {
  if (grid.x == 0 || grid.y == 0 || grid.z == 0)
    reject_clustering("a grid of " + std::to_string(grid.x) + " x " + std::to_string(grid.y) +
                      " x " + std::to_string(grid.z) + " cells is empty");
  return CellGrid(soup.box(), {static_cast<double>(grid.x), static_cast<double>(grid.y),
                               static_cast<double>(grid.z)});
}

template <class Soup>
CellGrid grid_of(const Soup& soup, const CellSize& size, Clusters&) {
  if (!(size.edge > 0) || !std::isfinite(size.edge))
    reject_clustering("CellSize " + text_of(size.edge) + " is not positive and finite");
  return CellGrid::of_cubes(soup.box(), soup.scale().length_from_mesh(size.edge));
}

template <class Soup>
CellGrid grid_of(const Soup& soup, const FaceCount& count, Clusters& scratch) {
  return FaceCountSearch::grid(soup, count.faces, scratch);
}

/// Writes the cells that have a face to the soup, in their order.
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

/// Merges the points in each cell of a grid, in place. It accepts any soup.
///
/// `points` and `triangles` are random-access containers: points are those of a CGAL kernel or
/// three floating-point numbers each, as std::array<float, 3>, and triangles have three indices
/// each. The grid covers the bounding box of the points that triangles use; a point on the face
/// between two cells belongs to the upper one. Triangles with two corners in one cell are removed,
/// and with them edges and points that Rossignac and Borrel keep. Among triangles between the same
/// three cells, in either orientation, the first one stays. So the two sides of a wall thinner than
/// a cell become one, with the orientation of one of them; components that are close to each other
/// are joined; components smaller than a cell vanish; and edges may get any number of faces. The
/// remaining points and triangles keep their order, and a point that is alone in its cell keeps its
/// position. Points without a triangle are dropped.
///
/// With ClusterPlacement::quadric a vertex is where the sum of the squared distances to the planes
/// of the triangles at its cell's points, weighted by area, is least: on the edge or at the corner
/// of a box. Where the planes leave directions free, it is the minimizer nearest to the mean, and
/// it never leaves its cell.
///
/// Expected time O(n + m) for n points and m triangles; with FaceCount three to five times that.
/// Memory in addition to the soup and the result: 5 bytes per point, 80 to 100 bytes per cell with
/// points (80 more with quadrics), and 24 to 48 bytes per remaining triangle.
///
/// Throws std::invalid_argument for a face that is not a triangle or has an index without a point,
/// a point that is not finite, a grid without cells, with more than 2⁵² along an axis or more than
/// 2⁶³ in total, and a CellSize that is not positive and finite; std::length_error for more than
/// 2³² − 2 points or triangles. If it throws, the soup is unchanged.
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
    internal::reject_clustering(internal::text_of(x) + " x " + internal::text_of(y) + " x " +
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
