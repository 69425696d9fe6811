#include "gltf.h"

#include "../mesh_io/gltf.h"
#include "../mesh_io/gltf/mesh_document.h"
#include "../mesh_io/gltf/scene_mesh.h"
#include "callbacks.h"
#include "interruptible.h"

#include <quadrille/channels.h>
#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using namespace quadrille;

std::tuple<Report, std::vector<std::string>>
simplify_gltf(const std::filesystem::path& in, const std::filesystem::path& out,
              SoupOptions options, const std::optional<Seams>& seams,
              const std::set<std::string>& labels, const py::object& stop, py::object progress) {
  Interruptible proceed(std::move(progress));
  options.proceed = [&](const Status& status) { return proceed(status); };
  options.stop = stop_of(stop);
  const py::gil_scoped_release unlocked;
  GltfMeshes meshes = GltfMeshes::read_shared(in, labels);
  if (meshes.surfaces().empty())
    throw std::invalid_argument(in.string() + ": it has no triangles to simplify");
  std::vector<std::string> remarks = remarks_of(meshes, in, out, false);
  const Report report =
      GltfSceneSurface(meshes.surfaces(), meshes.placements())
          .simplify(std::move(options), {.of_numbers = hardly, .texture_seams = seams});
  GltfDocument document = meshes.take();
  for (std::string& remark : GltfImageFiles::take_in(document, in, out, out.extension().string()))
    remarks.push_back(std::move(remark));
  write_gltf(out, std::move(document), out.extension().string());
  return {report, std::move(remarks)};
}

} // namespace

const MeshFormat& format_of_gltf() {
  return gltf_format;
}

IndexedMesh read_gltf_mesh(const std::filesystem::path& path) {
  return GltfSceneMesh::read(path);
}

void write_gltf_mesh(const std::filesystem::path& path, IndexedMesh& mesh) {
  std::vector<std::string> remarks;
  GltfDocument document =
      with_errors_of(path, [&] { return GltfMeshDocument::of(mesh, path, false, remarks); });
  write_gltf(path, std::move(document), path.extension().string());
  for (const std::string& remark : remarks)
    mesh.losses.add(remark);
}

void add_gltf(py::module_& m) {
  m.def("simplify_gltf", simplify_gltf);
}

} // namespace quadrille_examples
