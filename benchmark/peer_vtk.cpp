// SPDX-License-Identifier: MIT

#include "contender.h"

#ifndef BENCH_WITH_VTK
std::vector<bench::Contender> bench::vtk_contenders() {
  return {};
}
#else

#include <quadrille/cluster.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bench {
namespace {

vtkSmartPointer<vtkPolyData> to_polydata(const Soup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(soup.points.size()));
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Point& p = soup.points[i];
    points->SetPoint(static_cast<vtkIdType>(i), p.x(), p.y(), p.z());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(soup.triangles.size()),
                       static_cast<vtkIdType>(soup.triangles.size() * 3));
  for (const auto& [a, b, c] : soup.triangles)
    cells->InsertNextCell({a, b, c});
  auto polydata = vtkSmartPointer<vtkPolyData>::New();
  polydata->SetPoints(points);
  polydata->SetPolys(cells);
  return polydata;
}

Soup from_polydata(vtkPolyData& polydata) {
  Soup soup;
  for (vtkIdType i = 0; i < polydata.GetNumberOfPoints(); ++i) {
    double p[3];
    polydata.GetPoint(i, p);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  vtkCellArray* cells = polydata.GetPolys();
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(size, corners);)
    soup.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                              static_cast<std::uint32_t>(corners[1]),
                              static_cast<std::uint32_t>(corners[2])});
  return soup;
}

Answer simplify(Mesh& mesh, std::size_t faces) {
  const Soup input = to_soup(mesh);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(to_polydata(input));
  decimation->SetTargetReduction(1 - static_cast<double>(faces) /
                                         static_cast<double>(input.triangles.size()));
  const Stopwatch stopwatch;
  decimation->Update();
  const double seconds = stopwatch.seconds();
  Soup output = from_polydata(*decimation->GetOutput());
  to_mesh(output, mesh);
  return {.own_seconds = seconds, .soup = std::move(output)};
}

/// So many cubes lie along the longest side of the box.
void cluster(vtkQuadricClustering& clustering, vtkPolyData& input, int cells) {
  double bounds[6];
  input.GetBounds(bounds);
  const std::array extents{bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]};
  std::array<int, 3> divisions;
  for (std::size_t i = 0; i < 3; ++i)
    divisions[i] =
        std::max(1, static_cast<int>(std::ceil(cells * extents[i] / std::ranges::max(extents))));
  clustering.SetNumberOfDivisions(divisions.data());
  clustering.Update();
}

/// How many cubes cluster_vertices() takes along the longest side, to begin with.
int cells_of_ours(Soup soup, std::size_t faces) {
  const auto [x, y, z] =
      cluster_vertices(soup.points, soup.triangles, quadrille::FaceCount{faces}).cells;
  return static_cast<int>(std::max({x, y, z}));
}

/// The filter is told cells and no number of faces. The most cells that give no more are looked for
/// first; the time of its own is that of the run with these. Its memory grows with all cells, empty
/// ones too, so the search goes downwards from little above.
Answer simplify_by_clustering(Mesh& mesh, std::size_t faces) {
  const Soup soup = to_soup(mesh);
  const auto input = to_polydata(soup);
  for (int cells = cells_of_ours(soup, faces) + 2;; --cells) {
    vtkNew<vtkQuadricClustering> clustering;
    clustering->SetInputData(input);
    clustering->AutoAdjustNumberOfDivisionsOff();
    const Stopwatch stopwatch;
    cluster(*clustering, *input, cells);
    const double seconds = stopwatch.seconds();
    if (static_cast<std::size_t>(clustering->GetOutput()->GetNumberOfPolys()) <= faces) {
      Soup output = from_polydata(*clustering->GetOutput());
      to_mesh(output, mesh);
      return {.own_seconds = seconds, .soup = std::move(output)};
    }
  }
}

} // namespace

std::vector<Contender> vtk_contenders() {
  // VolumePreservation changes nothing as long as there are no attributes.
  return {{"VTK", "vtkQuadricDecimation, no attributes; double points", simplify},
          {"VTK clustering", "vtkQuadricClustering, as many cells as it takes; double points",
           simplify_by_clustering}};
}

} // namespace bench

#endif
