// SPDX-License-Identifier: MIT

#include "contender.h"

#ifndef BENCH_WITH_VTK
std::vector<bench::Contender> bench::vtk_contenders() {
  return {};
}
#else

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

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

} // namespace

std::vector<Contender> vtk_contenders() {
  // VolumePreservation changes nothing as long as there are no attributes.
  return {{"VTK", "vtkQuadricDecimation, no attributes; double points", simplify}};
}

} // namespace bench

#endif
