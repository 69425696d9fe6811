#include "../mesh_io/attributes/face_labels.h"
#include "../mesh_io/gltf/compression.h"
#include "../mesh_io/gltf/mesh_document.h"
#include "../mesh_io/gltf/scene_mesh.h"
#include "../mesh_io/mesh/bounding_box.h"
#include "../mesh_io/mesh/winding.h"
#include "../mesh_io/mesh_io.h"
#include "../mesh_io/replace_file.h"
#include "../mesh_io/text.h"
#include "calibration.h"
#include "figures.h"
#include "kind_hint.h"
#include "option_names.h"
#include "outcome.h"
#include "position_recorder.h"
#include "region.h"
#include "runs.h"
#include "simplify_mesh.h"
#include "trials.h"
#include "verification.h"

#include <quadrille/compiled/option_setting.h>
#include <quadrille/compiled/presets.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

void require_fit(const Options& options, const IndexedMesh& mesh) {
  require_fit(options, !mesh.colors.empty(),
              !mesh.texture_coordinates.empty() || !mesh.corner_textures.empty());
  if (mesh.triangles.empty())
    reject_without_faces(options, mesh.points.size(), mesh.losses.text());
}

void take_scalars(Options& options, const IndexedMesh& mesh) {
  try {
    for (const auto& [option, scalar] : options.scalars)
      quadrille::internal::set_array(options.soup, option, [&, name = scalar](auto value) {
        const auto numbers = point_numbers(mesh, name, [](double a, double b) { return a > b; });
        return std::vector<decltype(value)>(numbers.begin(), numbers.end());
      });
    if (!options.target.tolerance.empty())
      options.soup.tolerance =
          point_numbers(mesh, options.target.tolerance, [](double a, double b) { return a < b; });
    if (!options.region.empty())
      options.soup.selected = Region(mesh, options.region).faces();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
}

namespace {

bool is_of_broken_indices(const std::string& remark) {
  return remark.find("indices that are out of range") != std::string::npos;
}

} // namespace

void print_remarks(const Options& options, const IndexedMesh& mesh) {
  for (const std::string& remark : mesh.remarks)
    if (is_of_broken_indices(remark) &&
        !options.is_quiet) // what OUT lacks is told with its figures
      output_of_figures(options) << options.input << ": " << remark << '\n';
    else
      print_remark(options, remark);
  if (!mesh.losses.empty())
    print_remark(options, "not kept: " + mesh.losses.text());
}

void print_preset(const Options& options) {
  if (!options.soup.preset || !options.is_verbose)
    return;
  std::string name;
  for (const OptionWord& word : quadrille::internal::call_words)
    if (word.option == std::string_view("preset") &&
        word.value == static_cast<int>(*options.soup.preset))
      name = name_of(word);
  for (const auto& [preset, option, value] : quadrille::internal::preset_options)
    if (preset == options.soup.preset)
      print_remark(options,
                   "--preset " + name + ": " + std::string(option) + " " + std::string(value));
}

void print_hint(const Options& options, const IndexedMesh& mesh, const Winding& winding) {
  const quadrille::SoupOptions& soup = options.soup;
  if (options.is_quiet || soup.preset || soup.manifold || soup.height_field ||
      options.joins_gaps() || options.cuts_handles() || options.has_length("voxel_size") ||
      soup.topology == quadrille::Topology::free)
    return;
  if (const std::string hint = SurfaceKind(mesh, winding).hint(); !hint.empty())
    print_remark(options, hint);
}

void orient(const Options& options, IndexedMesh& mesh) {
  if (options.is_quiet && !options.orients)
    return;
  const Winding winding(mesh);
  print_hint(options, mesh, winding);
  const std::string count = with_commas(winding.against());
  if (options.orients)
    winding.turn(mesh);
  if (winding.against() > 0)
    print_remark(
        options,
        options.orients
            ? "faces turned to agree with their neighbours: " + count
            : "faces wound against their neighbours (--orient turns them, for correct normals, "
              "fold-over checks and hulls): " +
                  count);
  if (winding.one_sided() > 0)
    print_remark(options, "one-sided components, whose faces cannot be wound alike: " +
                              with_commas(winding.one_sided()));
}

namespace {

/// Material files that OUT will name, but which lie beside IN only.
void print_remark_of_materials(const Options& options, const IndexedMesh& mesh) {
  const auto is_next_to = [](const std::string& file, const std::string& library) {
    return std::filesystem::exists(std::filesystem::path(file).parent_path() / library);
  };
  for (const std::string& library : mesh.parts.libraries)
    if (is_next_to(options.input, library) && !is_next_to(options.output, library))
      print_remark(options, "OUT refers to the material file " + in_quotes(library, 100) +
                                ", which is not in its folder: copy it there with its images");
}

/// Has a mesh anything that a record of positions has not?
bool has_attributes(const IndexedMesh& mesh) {
  return !mesh.colors.empty() || !mesh.texture_coordinates.empty() ||
         !mesh.corner_textures.empty() || !mesh.corner_normals.empty() || mesh.parts.differ() ||
         !mesh.vertex_numbers.empty() || !mesh.face_numbers.empty();
}

const MeshFormat& format_of_output(const Options& options) {
  return is_gltf(output_extension(options)) ? gltf_format : output_format(options);
}

/// The content of IN, but of glTF, which is read by itself.
Source source_of(const Options& options) {
  if (is_gltf(extension_of(options.input, options)))
    return {};
  return read_source(options.input);
}

IndexedMesh read(const Options& options, const Source& source) {
  if (is_gltf(extension_of(options.input, options)))
    return GltfSceneMesh::read(options.input);
  return read_mesh(source, format_of(options.input, options),
                   options.weld ? Weld::places : Weld::surfaces, options.weld.value_or(Amount{}));
}

/// The files that a run writes its results to, all of which may be written, else it throws.
std::vector<std::string> files_of_results(const Options& options) {
  std::vector<std::string> files;
  if (options.levels.empty())
    files.push_back(options.output);
  else if (is_standard_output(options.output))
    throw std::runtime_error(options.output + ": --levels writes a file for each level, so OUT " +
                             "cannot be standard output");
  for (std::size_t number = 1; number <= options.levels.size(); ++number)
    files.push_back(file_of_level(options.output, number));
  for (const std::string& file : files)
    require_replaceable(file, options.is_forced);
  return files;
}

/// May the record be written, and beside the result? Throws if not.
void require_recordable(const Options& options) {
  if (is_standard_output(options.record))
    throw std::runtime_error(options.record + ": a record cannot be written to standard output");
  if (options.record == options.output)
    throw std::runtime_error(options.record + ": the record and OUT are the same file");
  require_replaceable(options.record, options.is_forced);
}

/// Rounds what is to be written so; had any point other coordinates?
bool round_to_floats(IndexedMesh& mesh) {
  bool has_changed = false;
  for (auto& p : mesh.points) {
    const auto nearest = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    const Point rounded(nearest(p.x()), nearest(p.y()), nearest(p.z()));
    has_changed |= rounded != p;
    p = rounded;
  }
  return has_changed;
}

std::string text_of_length(double length) {
  std::ostringstream text;
  text << length;
  return std::move(text).str();
}

std::string encoded_levels(const quadrille::Levels& levels) {
  std::ostringstream file;
  quadrille::write_levels(file, levels);
  return std::move(file).str();
}

/// One mesh on its way to its results.
class MeshRun {
public:
  MeshRun(const Options& options, ProgressLine& progress)
      : options_(options), progress_(progress), format_(format_of_output(options)),
        files_(files_of_results(options)) {
    if (!options.record.empty())
      require_recordable(options);
  }

  bool run() {
    print_remark_of_memory(options_);
    progress_.show_stage("reading");
    const Source source = source_of(options_);
    IndexedMesh mesh = read(options_, source);
    require_fit(options_, mesh);
    take_scalars(options_, mesh); // OUT may not hold them
    fit_to_format(mesh, format_);
    progress_.clear();
    print_remarks(options_, mesh);
    print_preset(options_);
    orient(options_, mesh);
    if (!is_standard_output(options_.output) && !writes_gltf())
      print_remark_of_materials(options_, mesh);
    diagonal_ = diagonal(mesh.points, mesh.triangles);
    look_for_labels(mesh);
    compare_with_file(source, mesh);
    hidden_ = prepare_hidden(options_, mesh, progress_);
    if (!options_.levels.empty())
      simplify_to_levels(mesh);
    else if (!options_.record.empty())
      simplify_recorded(std::move(mesh));
    else
      simplify_once(std::move(mesh));
    write();
    try_more();
    print_remark_of_doubled_faces();
    return tell(options_, outcomes_);
  }

private:
  bool writes_gltf() const { return &format_ == &gltf_format; }

  /// A label does not go with a small part, unless that is asked for.
  void look_for_labels(const IndexedMesh& mesh) {
    const FaceRegions regions(mesh);
    has_labels_ = !regions.labels().empty();
    options_.keeps_components |= regions.is_segmented() && !options_.drops_components;
  }

  std::string content(const std::string& file, const IndexedMesh& mesh) {
    if (!writes_gltf())
      return encoded(file, mesh, format_);
    return with_errors_of(file, [&] {
      const bool is_first = contents_.empty();
      std::vector<std::string> remarks;
      GltfDocument document =
          GltfMeshDocument::of(mesh, options_.input, options_.leaves_images, remarks);
      for (const std::string& remark : remarks)
        if (is_first)
          print_remark(options_, remark);
      compress(document, compression_of(options_.compression), options_.promises());
      return encode_document(std::move(document), output_extension(options_));
    });
  }

  /// Where something is promised: what is simplified is as OUT can hold it, and how far it is then
  /// from what IN is, without any welding, counts.
  void compare_with_file(const Source& source, IndexedMesh& mesh) {
    if (!options_.promises())
      return;
    std::optional<IndexedMesh> scene; // of glTF, which is not welded
    if (is_gltf(extension_of(options_.input, options_)))
      scene = mesh;
    const bool is_rounded = writes_floats(options_) && round_to_floats(mesh);
    if (!is_rounded && options_.weld.value_or(Amount{}).value == 0)
      return;
    if (!options_.soup.tolerance.empty())
      throw std::runtime_error(
          options_.input + ": --weld and a single-precision OUT move points, " +
          "which --tolerance does not account for: write a welded file first, " +
          "and simplify it into a format with double precision");
    file_ = scene ? std::move(*scene) : read_mesh(source, format_of(options_.input, options_));
    progress_.show_stage("measuring");
    moved_ = distance_between(*file_, mesh, progress_);
  }

  /// What is left of a limit of distance for the simplification, so that OUT is within it of IN.
  Options with_rest_of_limit(Options options) const {
    if (!file_ || !options.target.error)
      return options;
    const double limit =
        length_of(*options.target.error, diagonal(file_->points, file_->triangles));
    if (!(moved_ < limit))
      throw std::runtime_error(
          options.input + ": --weld or the precision of OUT moves points by up to " +
          text_of_length(moved_) + " before the simplification begins, and --error allows " +
          text_of_length(limit));
    options.target.error = Amount{limit - moved_, false};
    return options;
  }

  /// A run to one target; `simplify` is what simplifies a mesh, and tells what points become.
  void simplify_to(const std::string& file, IndexedMesh mesh, const Options& asked_options,
                   const Simplify& simplify) {
    const Options options = with_rest_of_limit(asked_options);
    const std::optional<IndexedMesh> input =
        options.measures || options.verifies ? std::optional(mesh) : std::nullopt;
    quadrille::PreparedSurface begun;
    quadrille::PreparedSurface* const asked = options.verifies ? &begun : nullptr;
    quadrille::Report report = with_errors_of_file(options, [&] {
      return options.target.is_calibrated ? simplify_calibrated(mesh, options, asked, simplify)
                                          : simplify(mesh, options, asked);
    });
    require_not_interrupted(options);
    report.distance_bound += moved_;
    report.hausdorff_bound += moved_;
    outcomes_.push_back({file, asked_options.target, report, diagonal_});
    outcomes_.back().has_labels = has_labels_;
    outcomes_.back().hidden = hidden_;
    contents_.push_back(content(file, mesh));
    if (input)
      progress_.show_stage("measuring");
    if (options.measures)
      outcomes_.back().measured = measure(*input, mesh);
    if (options.verifies)
      outcomes_.back().verdict = verified(options, report, *input, mesh, std::move(begun));
  }

  /// Limits are from the surface with which the run has begun. Where IN is another one since points
  /// have been moved, OUT is as much further from it as the faces that close cuts are.
  quadrille::Verdict verified(const Options& options, quadrille::Report report,
                              const IndexedMesh& input, const IndexedMesh& mesh,
                              quadrille::PreparedSurface begun) {
    std::optional<IndexedMesh> prepared;
    if (!begun.points.empty())
      prepared = bare_mesh(begun.points, begun.triangles);
    const IndexedMesh& from = prepared ? *prepared : input;
    if (file_) {
      report.distance_bound += report.cut_distance;
      report.hausdorff_bound += report.cut_distance;
    }
    const bool has_tolerances = !options.soup.tolerance.empty(); // of the points of the input
    return verify(options, report,
                  {file_            ? *file_
                   : has_tolerances ? input
                                    : from,
                   from, mesh, read_back(mesh)},
                  std::move(begun.vertex_map), progress_);
  }
  void simplify_to(const std::string& file, IndexedMesh mesh, const Options& options) {
    simplify_to(file, std::move(mesh), options,
                [](IndexedMesh& m, const Options& o, quadrille::PreparedSurface* begun) {
                  return simplify_mesh(m, o, {}, begun);
                });
  }

  void simplify_once(IndexedMesh mesh) {
    if (may_be_tried(options_, mesh.triangles.size()))
      to_try_ = mesh;
    simplify_to(files_.front(), std::move(mesh), options_);
  }

  /// Once the result is written.
  void try_more() {
    if (to_try_)
      try_options(options_, outcomes_.front(), progress_, [&](const Options& options) {
        IndexedMesh mesh = *to_try_;
        return simplify_mesh(mesh, options);
      });
  }

  /// The last result, as it will be read from its file.
  IndexedMesh read_back(const IndexedMesh& mesh) const {
    return writes_gltf() || mesh.triangles.empty()
               ? mesh
               : read_mesh(Source{options_.output, contents_.back()}, format_);
  }

  /// Each with all that the mesh has, as a run of its own.
  void simplify_to_levels(const IndexedMesh& mesh) {
    require_descending(options_.levels, mesh.triangles.size());
    for (std::size_t i = 0; i < files_.size(); ++i)
      simplify_to(files_[i], mesh, options_of_level(options_, options_.levels[i]));
  }

  void simplify_recorded(IndexedMesh mesh) {
    if (has_attributes(mesh)) {
      progress_.clear();
      print_remark(options_, "the record contains positions only");
    }
    quadrille::Levels levels;
    PositionRecorder recorder(levels);
    simplify_to(files_.front(), std::move(mesh), options_,
                [&](IndexedMesh& m, const Options& o, quadrille::PreparedSurface* begun) {
                  return simplify_mesh(m, o, quadrille::record_into(recorder), begun);
                });
    files_.insert(files_.begin(), options_.record);
    contents_.insert(contents_.begin(), encoded_levels(levels));
  }

  /// Those that run against each other stay: these are the sides of a sheet.
  void print_remark_of_doubled_faces() const {
    if (const std::size_t faces = outcomes_.front().report.doubled_faces; faces > 0)
      print_remark(options_, "duplicate faces left out (same corners, same winding): " +
                                 std::to_string(faces));
  }

  /// All or, where something has gone wrong before, nothing.
  void write() {
    progress_.show_stage("writing");
    require_not_interrupted(options_);
    for (std::size_t i = 0; i < files_.size(); ++i)
      replace_file(files_[i], contents_[i], options_.is_forced);
    progress_.clear();
  }

  Options options_;
  ProgressLine& progress_;
  const MeshFormat& format_;
  std::vector<std::string> files_, contents_;
  double diagonal_ = 0;
  bool has_labels_ = false; // of faces, materials say
  std::optional<HiddenSummary> hidden_;
  std::optional<IndexedMesh> file_; // what IN is, where that has been moved; by so much at most
  double moved_ = 0;
  std::optional<IndexedMesh> to_try_; // the input, where other options may be tried
  std::vector<Outcome> outcomes_;
};

} // namespace

bool run_mesh(const Options& options, ProgressLine& progress) {
  return MeshRun(options, progress).run();
}

} // namespace quadrille_examples
