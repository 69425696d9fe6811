// glTF documents, where nlohmann_json is there.
#include "jobs.h"

#include "../../mesh_io/gltf.h"
#include "../../mesh_io/gltf/mesh_document.h"
#include "../../mesh_io/gltf/scene_mesh.h"

#include <quadrille/c/call.h>
#include <quadrille/channels.h>
#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

using namespace quadrille;

bool is_gltf_file(std::string_view extension) {
  return is_gltf(std::string(extension));
}

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

void simplify_document(const Work& work) {
  const std::filesystem::path in = work.bag.path("source"), out = work.bag.path("target");
  const std::vector<std::string> labels = work.bag.texts("labels");
  SoupOptions options = work.call->job;
  internal::CallProgress proceed(work.call->progress, work.call->is_cancelled);
  options.proceed = [&](const Status& status) { return proceed(status); };
  if (work.call->stop)
    options.stop = [&](const Status& status) {
      return internal::answer_of(work.call->stop, "stop", internal::view_of(status));
    };
  std::optional<Seams> seams;
  if (work.bag.has("seams"))
    seams = static_cast<Seams>(work.bag.number("seams"));
  GltfMeshes meshes = GltfMeshes::read_shared(in, {labels.begin(), labels.end()});
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
  give_report(work.bag, report);
  work.bag.give_texts("remarks", remarks);
}

} // namespace quadrille_examples
