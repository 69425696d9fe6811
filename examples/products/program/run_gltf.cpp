#include "../mesh_io/gltf.h"
#include "../mesh_io/gltf/compression.h"
#include "../mesh_io/mesh/follow_triangles.h"
#include "../mesh_io/mesh/winding.h"
#include "calibration.h"
#include "hidden.h"
#include "outcome.h"
#include "runs.h"
#include "simplify_mesh.h"
#include "trials.h"
#include "verification.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using Surfaces = std::vector<GltfSurface>;

void require_fit(const Options& options, const Surfaces& surfaces) {
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
    reject_without_faces(options, vertices);
}

void print_remarks(const Options& options, GltfMeshes& meshes) {
  for (const std::string& remark :
       remarks_of(meshes, options.input, options.output, options.leaves_images))
    print_remark(options, remark);
}

/// What can be measured of a surface where it is in the scene: positions and the first texture
/// coordinates, by primitives.
IndexedMesh measurable(const GltfSurface& surface, const GltfPlacement& placement) {
  IndexedMesh mesh;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    const auto [x, y, z] = placement.largest(surface.place(v));
    mesh.points.emplace_back(x, y, z);
  }
  mesh.triangles = surface.triangles;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    const std::size_t primitive = surface.primitive_of(face);
    const auto& attributes = surface.primitives()[primitive].attributes;
    const auto texture =
        std::find_if(attributes.begin(), attributes.end(), [](const GltfAttribute& attribute) {
          return attribute.kind == AttributeKind::texture;
        });
    mesh.parts.of_faces.push_back(static_cast<std::uint32_t>(face));
    mesh.parts.parts.push_back({.material = static_cast<std::uint32_t>(primitive),
                                .has_textures = texture != attributes.end()});
    std::array<std::uint32_t, 3>& corners = mesh.corner_textures.triples.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = static_cast<std::uint32_t>(mesh.corner_textures.values.size());
      std::array<double, 2>& value = mesh.corner_textures.values.emplace_back();
      if (texture != attributes.end()) {
        const Element element =
            surface.corner(face, i)[static_cast<std::size_t>(texture - attributes.begin())];
        value = {element[0], element[1]};
      }
    }
  }
  return mesh;
}

void append(IndexedMesh& mesh, const IndexedMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({first + a, first + b, first + c});
}

/// Distances of the scene as a whole, in which meshes may have gone, and textures of each surface.
std::optional<Measurement> measure(const Surfaces& input, const Surfaces& result,
                                   const std::vector<GltfPlacement>& placements) {
  IndexedMesh scene_before, scene_after;
  std::vector<TextureMeasurement> textures;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const GltfPlacement& placement = placements[input[i].mesh()];
    const IndexedMesh before = measurable(input[i], placement),
                      after = measurable(result[i], placement);
    if (const auto texture = measure_texture(before, after))
      textures.push_back(*texture);
    append(scene_before, before);
    append(scene_after, after);
  }
  std::optional<Measurement> measured = measure(scene_before, scene_after);
  if (measured)
    measured->texture = united(textures);
  return measured;
}

/// A document on its way to its result.
class GltfRun {
public:
  GltfRun(const Options& options, ProgressLine& progress) : options_(options), progress_(progress) {
    require_replaceable(options.output, options.is_forced);
  }

  bool run() {
    progress_.show_stage("reading");
    GltfMeshes meshes = GltfMeshes::read_shared(options_.input, options_.labels);
    progress_.clear();
    require_fit(options_, meshes.surfaces());
    print_remarks(options_, meshes);
    print_preset(options_);
    if (const std::string& how = meshes.document().compression;
        !how.empty() && options_.compression.empty())
      print_remark(options_,
                   "IN is compressed, OUT is not: --compress " + how + " compresses it again");
    placements_ = meshes.placements();
    print_hint(meshes.surfaces());
    prepare_hidden(meshes.surfaces());
    if (options_.levels.empty()) {
      const Surfaces input =
          may_be_tried(options_, faces_of(meshes)) ? meshes.surfaces() : Surfaces();
      simplify_to(options_.output, meshes.surfaces(), options_);
      const std::size_t before = meshes.size();
      GltfDocument document = meshes.take();
      print_remark_of_size(before, document.size(), meshes.surfaces());
      write(std::move(document));
      try_more(input);
    } else {
      write(meshes.take_with(levels_of(meshes)));
    }
    return tell(options_, outcomes_);
  }

private:
  void print_hint(Surfaces& surfaces) const {
    if (options_.is_quiet)
      return;
    const GltfSceneSurface scene(surfaces, placements_);
    const IndexedMesh mesh = bare_mesh(scene.points(), scene.triangles());
    quadrille_examples::print_hint(options_, mesh, Winding(mesh));
  }

  /// Drops faces that nobody sees in the scene at rest, or weights vertices, as --hidden says.
  void prepare_hidden(Surfaces& surfaces) {
    const GltfSceneSurface scene(surfaces, placements_);
    HiddenAnswer answer = find_hidden(options_, scene.points(), scene.triangles(), progress_);
    hidden_ = std::move(answer.summary);
    options_.soup.importance = std::move(answer.importances);
    if (answer.is_dropped.empty())
      return;
    auto first = answer.is_dropped.begin();
    for (GltfSurface& surface : surfaces) {
      const auto end = first + static_cast<std::ptrdiff_t>(surface.triangles.size());
      surface.keep_faces(kept_triangles({first, end}));
      first = end;
    }
  }

  static quadrille::Report simplify(GltfSceneSurface& scene, const Options& options) {
    return with_errors_of_file(
        options, [&] { return scene.simplify(soup_of(scene, options), channel_choices(options)); });
  }
  static quadrille::SoupOptions soup_of(const GltfSceneSurface& scene, const Options& options) {
    quadrille::SoupOptions soup = soup_options(options, scene.points(), scene.triangles());
    soup.coordinates_are_floats = scene.is_of_floats();
    return soup;
  }

  /// With the greatest multiple of --error that is proved to be within it, as the file has it.
  quadrille::Report simplify_calibrated(GltfSceneSurface& scene, const Surfaces& surfaces,
                                        const Options& options) {
    const CalibratedLimit limit = calibrated_limit(
        mesh_that_runs_begin_with(scene.points(), scene.triangles(), soup_of(scene, options)),
        options, [&](const Options& coarser, IndexedMesh& left) {
          Surfaces copy = surfaces;
          GltfSceneSurface trial(copy, placements_);
          const quadrille::Report report = simplify(trial, coarser);
          const GltfSceneSurface written(copy, placements_);
          left = bare_mesh(written.points(), written.triangles());
          return report;
        });
    quadrille::Report report = simplify(scene, limit.options);
    if (limit.bound)
      report.distance_bound = report.hausdorff_bound = *limit.bound;
    return report;
  }

  /// Once the result is written.
  void try_more(const Surfaces& input) {
    if (!input.empty())
      try_options(options_, outcomes_.front(), progress_, [&](const Options& options) {
        Surfaces surfaces = input;
        GltfSceneSurface scene(surfaces, placements_);
        return simplify(scene, options);
      });
  }

  void simplify_to(const std::string& name, Surfaces& surfaces, const Options& options) {
    const Surfaces input = options.measures ? surfaces : Surfaces();
    GltfSceneSurface scene(surfaces, placements_);
    const double diagonal = quadrille_examples::diagonal(scene.points(), scene.triangles());
    const quadrille::Report report = options.target.is_calibrated
                                         ? simplify_calibrated(scene, surfaces, options)
                                         : simplify(scene, options);
    if (options.promises())
      for (GltfSurface& surface : surfaces)
        surface.write_positions_as_floats();
    require_not_interrupted(options);
    outcomes_.push_back({name, options.target, report, diagonal});
    outcomes_.back().has_labels = scene.has_labels();
    outcomes_.back().hidden = hidden_;
    if (options.measures || options.verifies)
      progress_.show_stage("measuring");
    if (options.measures)
      outcomes_.back().measured = measure(input, surfaces, placements_);
    if (options.verifies)
      outcomes_.back().verdict = verified(options, report, scene, surfaces);
  }

  /// The scene, as the soup that has been simplified, and as the numbers of the file have it.
  quadrille::Verdict verified(const Options& options, const quadrille::Report& report,
                              const GltfSceneSurface& scene, Surfaces surfaces) {
    const quadrille::PreparedSurface& prepared = scene.result().prepared;
    const bool is_prepared = !prepared.points.empty();
    const IndexedMesh input = is_prepared ? bare_mesh(prepared.points, prepared.triangles)
                                          : bare_mesh(scene.points(), scene.triangles());
    const GltfSceneSurface written(surfaces, placements_);
    return verify(options, report,
                  {input, input, bare_mesh(scene.result().points, scene.result().triangles),
                   bare_mesh(written.points(), written.triangles())},
                  is_prepared ? prepared.vertex_map : scene.result().vertex_map, progress_);
  }

  static std::size_t faces_of(GltfMeshes& meshes) {
    std::size_t faces = 0;
    for (const GltfSurface& surface : meshes.surfaces())
      faces += surface.triangles.size();
    return faces;
  }

  std::vector<Surfaces> levels_of(GltfMeshes& meshes) {
    meshes.require_fit_for_levels();
    require_descending(options_.levels, faces_of(meshes));
    std::vector<Surfaces> levels;
    for (const AskedLevel& level : options_.levels) {
      levels.push_back(meshes.surfaces());
      simplify_to(options_.output + ", level " + level.word, levels.back(),
                  options_of_level(options_, level));
    }
    return levels;
  }

  /// As where primitives shared vertices that are written for each of them, or where integers that
  /// OUT could not keep a promise with have become floats.
  void print_remark_of_size(std::size_t before, std::size_t after, const Surfaces& surfaces) const {
    const bool are_new_floats =
        std::any_of(surfaces.begin(), surfaces.end(),
                    [](const GltfSurface& surface) { return surface.has_become_floats(); });
    if (after > before)
      print_remark(options_,
                   "the buffers of IN have " + with_commas(before) + " bytes, those of OUT " +
                       with_commas(after) +
                       (are_new_floats
                            ? ": a promise needs floats, and the positions of IN were integers"
                            : ""));
  }

  void write(GltfDocument document) {
    progress_.show_stage("writing");
    take_images_in(document);
    compress(document, compression_of(options_.compression), options_.promises());
    require_not_interrupted(options_);
    write_gltf(options_.output, std::move(document), output_extension(options_),
               options_.is_forced);
    progress_.clear();
  }

  void take_images_in(GltfDocument& document) const {
    if (options_.leaves_images)
      return;
    with_errors_of(options_.input, [&] {
      for (const std::string& remark : GltfImageFiles::take_in(
               document, options_.input, options_.output, output_extension(options_)))
        print_remark(options_, remark);
    });
  }

  Options options_;
  ProgressLine& progress_;
  std::optional<HiddenSummary> hidden_;
  std::vector<GltfPlacement> placements_; // of the meshes
  std::vector<Outcome> outcomes_;
};

} // namespace

bool run_gltf(const Options& options, ProgressLine& progress) {
  return GltfRun(options, progress).run();
}

} // namespace quadrille_examples
