#ifndef QUADRILLE_EXAMPLES_JOBS_H
#define QUADRILLE_EXAMPLES_JOBS_H

/// \file
/// What quadrille_do() does, by what a bag holds, and back into it. Each job throws what is wrong.

#include "bag.h"

#include "../../mesh_io/mesh_io.h"

#include <quadrille/report.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// A job, for which a function may be asked whether to proceed.
struct Work {
  quadrille_bag& bag;
  quadrille_call* call;
  quadrille_part_function progress;

  /// Throws if the function has failed.
  bool proceed(double part) const {
    const int32_t answer = progress ? progress(part) : 1;
    if (answer < 0)
      throw quadrille::internal::FunctionFailed("progress");
    return answer != 0;
  }
};

void read_file(const Work& work);
void write_file(const Work& work);
void measure_distance(const Work& work);
void verify_result(const Work& work);
void find_hidden(const Work& work);
void remove_hidden(const Work& work);
void find_visibility(const Work& work);
void simplify_document(const Work& work);

// --- glTF, where nlohmann_json is there

/// Whether a file has this extension, and the module knows glTF.
bool is_gltf_file(std::string_view extension);
const MeshFormat& format_of_gltf();
IndexedMesh read_gltf_mesh(const std::filesystem::path& path);
/// Adds what could not be written to the losses of the mesh.
void write_gltf_mesh(const std::filesystem::path& path, IndexedMesh& mesh);

/// Gives the members of a report, from which Python makes one.
void give_report(quadrille_bag& bag, const quadrille::Report& report);

} // namespace quadrille_examples

#endif
