// SPDX-License-Identifier: MIT
//
// VTK has one value for each point: vertices are split at seams.

#include "contender.h"

#ifndef BENCH_WITH_VTK
std::vector<bench::AttributeContender> bench::vtk_attribute_contenders() {
  return {};
}
#else

#include "model.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

namespace bench {
namespace {

/// Colours are vectors to VTK, since scalars would be one number.
vtkSmartPointer<vtkPolyData> to_polydata(const Soup& soup, Kind kind) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : soup.points)
    points->InsertNextPoint(p.x(), p.y(), p.z());
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : soup.triangles)
    cells->InsertNextCell({a, b, c});
  vtkNew<vtkDoubleArray> values;
  const auto m = static_cast<int>(soup.attributes.components);
  values->SetNumberOfComponents(m);
  values->SetNumberOfTuples(static_cast<vtkIdType>(soup.attributes.size()));
  for (std::size_t i = 0; i < soup.attributes.values.size(); ++i)
    values->SetValue(static_cast<vtkIdType>(i), soup.attributes.values[i]);
  auto polydata = vtkSmartPointer<vtkPolyData>::New();
  polydata->SetPoints(points);
  polydata->SetPolys(cells);
  if (kind == Kind::texture)
    polydata->GetPointData()->SetTCoords(values);
  else
    polydata->GetPointData()->SetVectors(values);
  return polydata;
}

Soup from_polydata(vtkPolyData& polydata, Kind kind) {
  Soup soup;
  vtkPointData* const data = polydata.GetPointData();
  vtkDataArray* const values = kind == Kind::texture ? data->GetTCoords() : data->GetVectors();
  soup.attributes.components = static_cast<std::size_t>(values->GetNumberOfComponents());
  for (vtkIdType i = 0; i < polydata.GetNumberOfPoints(); ++i) {
    double p[3];
    polydata.GetPoint(i, p);
    soup.points.emplace_back(p[0], p[1], p[2]);
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      soup.attributes.values.push_back(values->GetComponent(i, c));
  }
  vtkCellArray* const cells = polydata.GetPolys();
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(size, corners);)
    soup.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                              static_cast<std::uint32_t>(corners[1]),
                              static_cast<std::uint32_t>(corners[2])});
  soup.attributes.triangles = soup.triangles;
  return soup;
}

std::optional<double> simplify(Soup& soup, const AttributeTask& task) {
  split_points(soup);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(to_polydata(soup, task.kind));
  decimation->SetTargetReduction(1 - static_cast<double>(task.faces) /
                                         static_cast<double>(soup.triangles.size()));
  decimation->AttributeErrorMetricOn();
  decimation->VolumePreservationOn(); // without it attributes cost shape, as its documentation says
  decimation->SetTCoordsWeight(0.1 * task.factor); // 0.1 by default, of all kinds of attributes
  decimation->SetVectorsWeight(0.1 * task.factor);
  const Stopwatch stopwatch;
  decimation->Update();
  const double seconds = stopwatch.seconds();
  soup = from_polydata(*decimation->GetOutput(), task.kind);
  return seconds;
}

} // namespace

std::vector<AttributeContender> vtk_attribute_contenders() {
  return {{"VTK attributes",
           "vtkQuadricDecimation, AttributeErrorMetric, VolumePreservation; double points; weights "
           "as multiples of 0.1, VTK's default",
           peer_factors, simplify}};
}

} // namespace bench

#endif
