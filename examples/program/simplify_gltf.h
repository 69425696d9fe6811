#ifndef QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_GLTF_H
#define QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_GLTF_H

/// \file
/// Simplifies glTF documents, where nlohmann/json.hpp is to be had.

#include "options.h"
#include "report.h"
#include "simplify_levels.h"
#include "simplify_mesh.h"

#if __has_include(<nlohmann/json.hpp>)
#define QUADRILLE_SIMPLIFIES_GLTF
#include "../gltf.h"
#endif
#include "../report_sum.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

#ifdef QUADRILLE_SIMPLIFIES_GLTF

inline void require_fit(const Options& options, const std::vector<GltfSurface>& surfaces) {
  const auto have = [&](AttributeKind kind) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const GltfSurface& surface) { return surface.has(kind); });
  };
  require_fit(options, have(AttributeKind::color), have(AttributeKind::texture));
  std::size_t faces = 0, vertices = 0;
  for (const GltfSurface& surface : surfaces) {
    faces += surface.triangles.size();
    vertices += surface.points.size();
  }
  if (faces == 0)
    refuse_without_faces(options, vertices);
}

inline void print_remarks(const Options& options, GltfMeshes& meshes) {
  const auto remark = [&](const char* what, std::size_t count) {
    if (count > 0 && !options.is_quiet)
      std::cerr << options.input << ": " << what << ": " << count << '\n';
  };
  std::size_t left_out = 0;
  for (const GltfSurface& surface : meshes.surfaces())
    left_out += surface.count_left_out();
  remark(
      "triangles left out for having two equal corners, or the corners of another one, whichever "
      "way round",
      left_out);
  const auto folder = [](const std::string& file) {
    return std::filesystem::absolute(file).lexically_normal().parent_path();
  };
  if (folder(options.input) != folder(options.output))
    remark("its images are files, which OUT names as it does, but from another folder",
           meshes.image_files().size());
}

/// One after the other, the small ones first: what these cannot contribute, a large one can.
inline quadrille::Report simplify_surfaces(std::vector<GltfSurface>& surfaces,
                                           const Options& options) {
  std::vector<GltfSurface*> order;
  std::size_t rest = 0;
  for (GltfSurface& surface : surfaces) {
    order.push_back(&surface);
    rest += surface.triangles.size();
  }
  std::stable_sort(order.begin(), order.end(), [](const GltfSurface* a, const GltfSurface* b) {
    return a->triangles.size() < b->triangles.size();
  });
  quadrille::Report sum = report_of_none();
  for (GltfSurface* const surface : order) {
    const std::size_t faces = surface->triangles.size();
    Options share = options;
    share.target = options.target.share(sum, faces, std::max<std::size_t>(rest, 1));
    add_report(sum, simplify_by_channels(*surface, *surface, share));
    rest -= faces;
  }
  const quadrille::Status all{.initial_faces = sum.faces_before,
                              .initial_vertices = sum.vertices_before,
                              .faces = sum.faces_after,
                              .vertices = sum.vertices_after};
  if (!quadrille::is_target_reached(sum.stop) && options.target(all))
    sum.stop = quadrille::StopReason::target_met;
  return sum;
}

/// One document with all levels. False if one was not reached.
inline bool run_gltf_levels(const Options& options, GltfMeshes& meshes,
                            const std::string& output_extension) {
  meshes.require_fit_for_levels();
  std::size_t faces = 0;
  for (const GltfSurface& surface : meshes.surfaces())
    faces += surface.triangles.size();
  require_descending(options.levels, faces);
  std::vector<std::vector<GltfSurface>> levels;
  std::vector<quadrille::Report> reports;
  for (const AskedLevel& level : options.levels) {
    levels.push_back(meshes.surfaces());
    reports.push_back(with_errors_of_file(options, [&] {
      return simplify_surfaces(levels.back(), options_of_level(options, level));
    }));
  }
  write_gltf(options.output, meshes.take_with(std::move(levels)), output_extension,
             options.is_forced);
  bool is_reached = true;
  for (std::size_t i = 0; i < reports.size(); ++i)
    is_reached &= tell(options_of_level(options, options.levels[i]), reports[i],
                       options.output + ", level " + options.levels[i].word);
  return is_reached;
}

/// False if the target was not reached.
inline bool run_gltf(const Options& options, const std::string& output_extension) {
  GltfMeshes meshes = GltfMeshes::read(options.input);
  require_fit(options, meshes.surfaces());
  print_remarks(options, meshes);
  if (!options.levels.empty())
    return run_gltf_levels(options, meshes, output_extension);
  const quadrille::Report report =
      with_errors_of_file(options, [&] { return simplify_surfaces(meshes.surfaces(), options); });
  write_gltf(options.output, meshes.take(), output_extension, options.is_forced);
  return tell(options, report);
}

#else

inline bool run_gltf(const Options& options, const std::string&) {
  throw std::runtime_error(options.input + ": this program was built without nlohmann/json.hpp, " +
                           "which it needs for glTF");
}

#endif

} // namespace quadrille_examples

#endif
