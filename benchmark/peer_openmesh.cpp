// SPDX-License-Identifier: MIT
//
// OpenMesh's decimater: half-edge collapses, so that its answer uses input positions.

#include "contender.h"

#ifndef BENCH_WITH_OPENMESH
std::vector<bench::Contender> bench::openmesh_contenders() {
  return {};
}
#else

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace bench {
namespace {

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

TriMesh to_trimesh(const Soup& soup) {
  TriMesh mesh;
  mesh.reserve(soup.points.size(), soup.triangles.size() * 3 / 2, soup.triangles.size());
  std::vector<TriMesh::VertexHandle> handles;
  handles.reserve(soup.points.size());
  for (const Point& p : soup.points)
    handles.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const auto& [a, b, c] : soup.triangles)
    mesh.add_face(handles[a], handles[b], handles[c]);
  return mesh;
}

Soup from_trimesh(const TriMesh& mesh) {
  Soup soup;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : mesh.faces()) {
    auto corner = mesh.cfv_iter(f);
    auto& triangle = soup.triangles.emplace_back();
    for (std::uint32_t& v : triangle)
      v = static_cast<std::uint32_t>((corner++)->idx());
  }
  return soup;
}

void decimate(TriMesh& mesh, std::size_t faces) {
  mesh.request_face_normals();
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<TriMesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  decimater.module(flipping).set_max_normal_deviation(90);
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  mesh.garbage_collection();
}

Answer simplify(Mesh& mesh, std::size_t faces) {
  TriMesh trimesh = to_trimesh(to_soup(mesh));
  const Stopwatch stopwatch;
  decimate(trimesh, faces);
  const double seconds = stopwatch.seconds();
  to_mesh(from_trimesh(trimesh), mesh);
  return {.own_seconds = seconds, .soup = {}};
}

} // namespace

std::vector<Contender> openmesh_contenders() {
  return {{"OpenMesh",
           "DecimaterT, ModQuadric without limit, ModNormalFlipping at 90 degrees; double, input "
           "positions",
           simplify}};
}

} // namespace bench

#endif
