// The command-line program: reads a mesh, simplifies it and writes it.
//
//   simplify IN OUT [--faces N | --ratio R | --vertices N | --error D] [options]
//
// Exit status: 0 done; 1 the target was not reached, OUT holds how far it went; 2 bad usage or
// file, or nothing to simplify, OUT is as it was.

#include "carrying_cost.h"
#if __has_include(<nlohmann/json.hpp>)
#define QUADRILLE_SIMPLIFIES_GLTF
#include "gltf.h"
#endif
#include "local_cost.h"
#include "mesh_attributes.h"
#include "mesh_channels.h"
#include "mesh_io.h"
#include "report_sum.h"

#include <quadrille/compiled.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using namespace quadrille_examples;

// --- Policies chosen at run time: one engine for each cost is enough then ------------------------

struct Target {
  std::variant<quadrille::FaceRatio, quadrille::FaceCount, quadrille::VertexCount,
               quadrille::ErrorLimit>
      chosen;
  double distance = 0; // of an error limit

  bool operator()(const quadrille::Status& status) const {
    return std::visit([&](const auto& stop) { return stop(status); }, chosen);
  }
  bool is_passed(const quadrille::Status& status) const {
    const auto asked = [&](const auto& stop) {
      if constexpr (requires { stop.is_passed(status); })
        return stop.is_passed(status);
      else
        return false;
    };
    return std::visit(asked, chosen);
  }
  void tell(quadrille::SoupOptions& options) const {
    if (const auto* stop = std::get_if<quadrille::FaceRatio>(&chosen))
      options.ratio = stop->ratio;
    if (const auto* stop = std::get_if<quadrille::FaceCount>(&chosen))
      options.faces = stop->faces;
    if (const auto* stop = std::get_if<quadrille::VertexCount>(&chosen))
      options.vertices = stop->vertices;
    if (std::holds_alternative<quadrille::ErrorLimit>(chosen))
      options.error = distance;
  }
  /// The target of a surface of some faces, where `done` tells of surfaces before it and `rest` are
  /// the faces from it on: its part of what those before it leave.
  Target share(const quadrille::Report& done, std::size_t faces, std::size_t rest) const {
    const auto left = [](double wanted, std::size_t used) {
      return std::max(0., wanted - static_cast<double>(used));
    };
    const auto share_of = [&](std::size_t wanted, std::size_t used) {
      const double part = static_cast<double>(faces) / static_cast<double>(rest);
      return static_cast<std::size_t>(std::llround(left(static_cast<double>(wanted), used) * part));
    };
    Target result = *this;
    if (auto* stop = std::get_if<quadrille::FaceRatio>(&result.chosen)) {
      const double wanted = stop->ratio * static_cast<double>(done.faces_before + rest);
      stop->ratio = std::min(1., left(wanted, done.faces_after) / static_cast<double>(rest));
    }
    if (auto* stop = std::get_if<quadrille::FaceCount>(&result.chosen))
      stop->faces = share_of(stop->faces, done.faces_after);
    if (auto* stop = std::get_if<quadrille::VertexCount>(&result.chosen))
      stop->vertices = share_of(stop->vertices, done.vertices_after);
    return result;
  }
  /// An error limit is kept also if there is nothing more to contract. A target that was passed by
  /// a face or so counts as met: the report tells.
  bool is_met(quadrille::StopReason reason) const {
    return quadrille::is_target_reached(reason) ||
           std::holds_alternative<quadrille::ErrorLimit>(chosen);
  }
};

struct Placement {
  enum { optimal, endpoint, midpoint } chosen;
  using ScaleFree = Placement; // as each of them is

  // The return type is spelt out so that asking whether this is a policy of another kind is no
  // error.
  auto operator()(const auto& cost, const auto& pair) const
      -> std::remove_cvref_t<decltype(pair.first)> {
    if constexpr (requires { cost.minimizer(pair); })
      if (chosen == optimal)
        return quadrille::OptimalPlacement{}(cost, pair);
    if (chosen == endpoint)
      return quadrille::EndpointPlacement{}(cost, pair);
    return quadrille::MidpointPlacement{}(cost, pair);
  }
};

// --- The command line ----------------------------------------------------------------------------

struct Options {
  std::string input, output;
  Target target;
  std::string format, output_format; // empty: as their names say
  std::string cost;                  // empty: quadric with attributes
  std::string placement;             // empty: the best that the cost has
  double boundary_weight = quadrille::Quadric{}.boundary_weight;
  double pairs_closer_than = 0;
  std::string topology; // empty: free if there are pairs that are no edges
  bool welds = false;
  bool is_forced = false;
  bool is_quiet = false;
};

/// A finite number of the interval; CLI11's own checks let nan through.
CLI::Validator number_in(double least, double most, const std::string& what) {
  const auto complaint = [=](const std::string& word) {
    const std::optional<double> value = parse_number(word);
    const bool is_good = value && std::isfinite(*value) && *value >= least && *value <= most;
    return is_good ? "" : in_quotes(word) + " is not " + what;
  };
  return {complaint, ""};
}

/// CLI11 reads -1 as a very large count.
CLI::Validator count() {
  const auto complaint = [](const std::string& word) {
    const std::optional<std::int64_t> value = parse_integer(word);
    return value && *value >= 0 ? "" : in_quotes(word) + " is not a count";
  };
  return {complaint, ""};
}

void add_target(CLI::App& app, Target& target) {
  const auto stop_at_faces = [&](std::size_t n) { target.chosen = quadrille::FaceCount{n}; };
  const auto stop_at_ratio = [&](double ratio) { target.chosen = quadrille::FaceRatio{ratio}; };
  const auto stop_at_vertices = [&](std::size_t n) { target.chosen = quadrille::VertexCount{n}; };
  const auto stop_at_error = [&](double error) {
    target.chosen = quadrille::ErrorLimit(error);
    target.distance = error;
  };
  CLI::Option_group* const group = app.add_option_group("Target", "half of the faces by default");
  group->require_option(0, 1);
  group->add_option_function<std::size_t>("--faces", stop_at_faces, "stop at so many faces")
      ->check(count());
  group->add_option_function<double>("--ratio", stop_at_ratio, "stop at this part of the faces")
      ->check(number_in(0, 1, "in [0, 1]"));
  group
      ->add_option_function<std::size_t>("--vertices", stop_at_vertices, "stop at so many vertices")
      ->check(count());
  group
      ->add_option_function<double>("--error", stop_at_error,
                                    "stay within that distance of the input")
      ->check(number_in(0, std::numeric_limits<double>::infinity(), "a distance"));
}

void add_policies(CLI::App& app, Options& options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  app.add_option(
         "--cost", options.cost,
         "which pair is contracted first: by distance to the planes of all faces so far, of the "
         "current faces, the same and of lost thin parts, with colours or texture coordinates as "
         "further dimensions, or the shortest (default: quadric, with all attributes of IN)")
      ->check(
          CLI::IsMember({"quadric", "memoryless", "thin-features", "color", "texture", "length"}));
  app.add_option("--placement", options.placement,
                 "where the vertex goes (default: optimal, or midpoint with --cost length)")
      ->check(CLI::IsMember({"optimal", "endpoint", "midpoint"}));
  app.add_option("--boundary-weight", options.boundary_weight, "how firmly boundaries hold")
      ->check(number_in(0, infinity, "a weight"))
      ->capture_default_str();
  app.add_option("--pairs-closer-than", options.pairs_closer_than,
                 "contract also vertices without an edge, if they are closer than this")
      ->check(number_in(0, infinity, "a distance"));
  app.add_option("--topology", options.topology,
                 "may holes close and parts join? (default: kept, or free with "
                 "--pairs-closer-than)")
      ->check(CLI::IsMember({"kept", "free"}));
}

void add_files(CLI::App& app, Options& options) {
  const CLI::IsMember is_format({"off", "obj", "ply", "stl", "ts", "gltf", "glb"});
  const std::string formats = " (.off .obj .ply .stl .ts, or .gltf .glb for both; - is standard ";
  app.add_option("IN", options.input, "the mesh to read" + formats + "input)")->required();
  app.add_option("OUT", options.output, "the mesh to write" + formats + "output)")->required();
  app.add_option("--format", options.format,
                 "the format of IN and OUT where their names end in none")
      ->check(is_format);
  app.add_option("--out-format", options.output_format, "the format of OUT, whatever its name")
      ->check(is_format);
  app.add_flag("--force", options.is_forced, "replace OUT even if it is read-only");
}

void add_options(CLI::App& app, Options& options) {
  add_files(app, options);
  add_target(app, options.target);
  add_policies(app, options);
  app.add_flag("--weld", options.welds,
               "make vertices at exactly the same place one; without this, that is done only if no "
               "two faces share a vertex, and to vertices of the same colour and texture "
               "coordinate");
  app.add_flag("--quiet", options.is_quiet, "print errors only");
}

Placement placement(const Options& options) {
  if (options.placement == "endpoint")
    return {Placement::endpoint};
  if (options.placement == "midpoint" || options.cost == "length")
    return {Placement::midpoint};
  return {Placement::optimal};
}

quadrille::Topology topology(const Options& options) {
  const bool is_free =
      options.topology.empty() ? options.pairs_closer_than > 0 : options.topology == "free";
  return is_free ? quadrille::Topology::free : quadrille::Topology::kept;
}

bool is_gltf(const std::string& extension) {
  return equal_ignoring_case(extension, ".gltf") || equal_ignoring_case(extension, ".glb");
}

/// The extension that tells the format of a file: that of its name, else that of --format.
std::string extension_of(const std::string& file, const Options& options) {
  const std::string extension = std::filesystem::path(file).extension().string();
  const bool tells = options.format.empty() || find_format(extension) || is_gltf(extension);
  return tells ? extension : "." + options.format;
}

/// The format that the name of a file ends in, else that of --format.
const MeshFormat& format_of(const std::string& file, const Options& options) {
  if (const MeshFormat* named = find_format(std::filesystem::path(file).extension().string()))
    return *named;
  if (options.format.empty() && (is_standard_input(file) || is_standard_output(file)))
    throw std::runtime_error(file + ": its name tells no format: pass --format");
  return options.format.empty() ? mesh_format(file) : *find_format("." + options.format);
}

const MeshFormat& output_format(const Options& options) {
  return options.output_format.empty() ? format_of(options.output, options)
                                       : *find_format("." + options.output_format);
}

/// What concerns several options, or options and what the file has.
void require_fit(const Options& options, bool has_colors, bool has_textures) {
  if (options.cost == "length" && options.placement == "optimal")
    throw std::runtime_error("--placement optimal does not go with --cost length");
  if (options.cost == "color" && !has_colors)
    throw std::runtime_error(options.input + ": no colours for --cost color");
  if (options.cost == "texture" && !has_textures)
    throw std::runtime_error(options.input + ": no texture coordinates for --cost texture");
}

[[noreturn]] void refuse_without_faces(const Options& options, std::size_t vertices) {
  throw std::runtime_error(options.input + ": nothing to simplify: no face of three different " +
                           "vertices, " + std::to_string(vertices) + " vertices");
}

void require_fit(const Options& options, const IndexedMesh& mesh) {
  require_fit(options, !mesh.colors.empty(),
              !mesh.texture_coordinates.empty() || !mesh.corner_textures.empty());
  if (mesh.triangles.empty() && !mesh.is_blank)
    refuse_without_faces(options, mesh.points.size());
}

// --- The work ------------------------------------------------------------------------------------

template <class Cost>
Cost with_boundary_weight(Cost cost, const Options& options) {
  cost.boundary_weight = options.boundary_weight;
  return cost;
}

quadrille::Report simplify(auto& mesh, const Options& options, const auto& cost,
                           const auto&... named) {
  const auto until = [&](const auto& stop) {
    return quadrille::simplify(mesh.points, mesh.triangles, cost, placement(options),
                               quadrille::ThresholdPairs(options.pairs_closer_than), stop,
                               topology(options), named...);
  };
  // It asks for distances that other targets need not pay for.
  if (const auto* limit = std::get_if<quadrille::ErrorLimit>(&options.target.chosen))
    return until(*limit);
  return until(options.target);
}

/// With attributes, which the engine places together with the positions.
template <std::size_t N>
quadrille::Report simplify_with(const MeshAttributes& attributes, IndexedMesh& mesh,
                                const Options& options, const auto& cost) {
  std::vector<CarriedAttributes<N>> carried = attributes.carried<N>();
  const quadrille::Report report =
      simplify(mesh, options, cost,
               quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(carried)));
  attributes.restore(mesh, carried);
  return report;
}

/// N attributes as further dimensions. They are lengths already.
template <std::size_t N>
quadrille::AttributeQuadric<N> attribute_quadric(const Options& options) {
  auto cost = with_boundary_weight(quadrille::AttributeQuadric<N>{}, options);
  cost.weights.emplace().coordinates.fill(1);
  return cost;
}

/// The quadric in as many dimensions as vary, rounded up, since each takes time to compile.
quadrille::Report simplify_by_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                         const Options& options) {
  if (attributes.size() <= 2)
    return simplify_with<2>(attributes, mesh, options, attribute_quadric<2>(options));
  if (attributes.size() == 3)
    return simplify_with<3>(attributes, mesh, options, attribute_quadric<3>(options));
  return simplify_with<6>(attributes, mesh, options, attribute_quadric<6>(options));
}

/// With a cost that looks at positions only, along which attributes are carried.
quadrille::Report simplify_carrying(const MeshAttributes& attributes, IndexedMesh& mesh,
                                    const Options& options, const auto& cost) {
  return simplify_with<6>(attributes, mesh, options,
                          CarryingCost<std::remove_cvref_t<decltype(cost)>, 6>(cost));
}

quadrille::SoupOptions soup_options(const Options& options) {
  using Cost = quadrille::SoupOptions::Cost;
  quadrille::SoupOptions result;
  options.target.tell(result);
  result.cost = options.cost == "length"          ? Cost::edge_length
                : options.cost == "memoryless"    ? Cost::memoryless_quadric
                : options.cost == "thin-features" ? Cost::thin_feature_quadric
                                                  : Cost::quadric;
  result.boundary_weight = options.boundary_weight;
  if (options.placement == "endpoint")
    result.placement = quadrille::SoupOptions::Placement::endpoint;
  if (options.placement == "midpoint")
    result.placement = quadrille::SoupOptions::Placement::midpoint;
  result.pairs_closer_than = options.pairs_closer_than;
  result.topology = topology(options);
  return result;
}

/// Without attributes that vary.
quadrille::Report simplify_positions(const MeshAttributes& attributes, IndexedMesh& mesh,
                                     const Options& options) {
  quadrille::SoupPoints points(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), points.begin(), [](const Point& p) {
    return std::array{p.x(), p.y(), p.z()};
  });
  const quadrille::Report report =
      quadrille::simplify_soup(points, mesh.triangles, soup_options(options));
  mesh.points.resize(points.size());
  std::transform(points.begin(), points.end(), mesh.points.begin(),
                 [](const auto& p) { return Point(p[0], p[1], p[2]); });
  attributes.restore(mesh);
  return report;
}

/// By how much less counts what shall hardly count.
constexpr double hardly = 1. / 64;

/// As AttributeQuadric has it for each kind. If one is asked for by name, the other hardly counts.
Importance importance(const Options& options) {
  Importance importance{quadrille::ColorQuadric{}.importance,
                        quadrille::TextureQuadric{}.importance};
  if (options.cost == "color")
    importance.of_textures *= hardly;
  if (options.cost == "texture")
    importance.of_colors *= hardly;
  return importance;
}

/// All count by default; else only those that the cost is asked for by name. Numbers may be noise,
/// so they hardly count.
ChannelImportance channel_importance(const Options& options) {
  const auto importance_if_asked_by = [&](const char* cost) {
    return options.cost.empty() || options.cost == cost ? 1. : hardly;
  };
  return {.of_colors = importance_if_asked_by("color"),
          .of_textures = importance_if_asked_by("texture"),
          .of_normals = importance_if_asked_by(""),
          .of_numbers = hardly};
}

/// With values at corners, named numbers and parts of faces, which `taken` takes through.
quadrille::Report simplify_by_channels(auto& mesh, auto&& taken, const Options& options) {
  const auto simplify_by = [&](const auto& cost) {
    return taken.take_through(
        [&](const auto&... channels) { return simplify(mesh, options, cost, channels...); },
        channel_importance(options));
  };
  LocalCost local;
  local.boundary_weight = options.boundary_weight;
  if (options.cost == "memoryless")
    local.kind = LocalCost::memoryless;
  else if (options.cost == "thin-features")
    local.kind = LocalCost::thin_features;
  else if (options.cost == "length")
    local.kind = LocalCost::length;
  else
    return simplify_by(with_boundary_weight(quadrille::Quadric{}, options));
  return simplify_by(local);
}

quadrille::Report simplify_by_cost(IndexedMesh& mesh, const Options& options) {
  if (needs_channels(mesh))
    return simplify_by_channels(mesh, MeshChannels(mesh), options);
  const MeshAttributes attributes(mesh, importance(options));
  if (attributes.size() == 0)
    return simplify_positions(attributes, mesh, options);
  const auto carrying = [&](const auto& cost) {
    return simplify_carrying(attributes, mesh, options, cost);
  };
  if (options.cost == "length")
    return carrying(quadrille::EdgeLength{});
  if (options.cost == "memoryless")
    return carrying(with_boundary_weight(quadrille::MemorylessQuadric{}, options));
  if (options.cost == "thin-features")
    return carrying(with_boundary_weight(quadrille::ThinFeatureQuadric{}, options));
  if (options.cost != "quadric")
    return simplify_by_attributes(attributes, mesh, options);
  return carrying(with_boundary_weight(quadrille::Quadric{}, options));
}

/// What is wrong with attributes that no weight makes comparable with positions is told of the
/// file.
quadrille::Report with_errors_of_file(const Options& options, const auto& simplify) {
  try {
    return simplify();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
}

/// Whatever of the file the result will not have, and what a user may not expect.
void print_remarks(const Options& options, IndexedMesh& mesh) {
  if (!mesh.losses.empty())
    mesh.remarks.push_back("not kept: " + mesh.losses.text());
  const std::size_t open = options.pairs_closer_than > 0 ? 0 : OpenSeams::count(mesh);
  if (open > 0)
    mesh.remarks.push_back(
        "boundary edges at the place of another one, along which cracks may open, since the two do "
        "not share their vertices (--weld makes them one): " +
        std::to_string(open));
  for (const std::string& remark : mesh.remarks)
    std::cerr << options.input << ": " << remark << '\n';
}

/// On standard output, unless that is the mesh.
void print_report(const Options& options, const quadrille::Report& report) {
  (is_standard_output(options.output) ? std::cerr : std::cout) << report << std::endl;
}

/// False if the target was not reached.
bool tell(const Options& options, const quadrille::Report& report) {
  if (!options.is_quiet)
    print_report(options, report);
  if (options.target.is_met(report.stop))
    return true;
  std::cerr << options.output << ": the target was not reached: " << to_string(report.stop) << '\n';
  return false;
}

// --- Documents of several meshes -----------------------------------------------------------------

#ifdef QUADRILLE_SIMPLIFIES_GLTF

void require_fit(const Options& options, const std::vector<GltfSurface>& surfaces) {
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

void print_remarks(const Options& options, GltfMeshes& meshes) {
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
quadrille::Report simplify_surfaces(std::vector<GltfSurface>& surfaces, const Options& options) {
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

/// False if the target was not reached.
bool run_gltf(const Options& options, const std::string& output_extension) {
  GltfMeshes meshes = GltfMeshes::read(options.input);
  require_fit(options, meshes.surfaces());
  print_remarks(options, meshes);
  const quadrille::Report report =
      with_errors_of_file(options, [&] { return simplify_surfaces(meshes.surfaces(), options); });
  write_gltf(options.output, meshes.take(), output_extension, options.is_forced);
  return tell(options, report);
}

#else

bool run_gltf(const Options& options, const std::string&) {
  throw std::runtime_error(options.input + ": this program was built without nlohmann/json.hpp, " +
                           "which it needs for glTF");
}

#endif

// --- The program ---------------------------------------------------------------------------------

/// False if the target was not reached.
bool run_mesh(const Options& options) {
  const MeshFormat& format = output_format(options); // complains before the work, not after
  require_replaceable(options.output, options.is_forced);
  IndexedMesh mesh = read_mesh(options.input, format_of(options.input, options),
                               options.welds ? Weld::always : Weld::loose_faces);
  require_fit(options, mesh);
  fit_to_format(mesh, format);
  if (!options.is_quiet)
    print_remarks(options, mesh);
  const quadrille::Report report =
      with_errors_of_file(options, [&] { return simplify_by_cost(mesh, options); });
  write_mesh(options.output, mesh, format, options.is_forced);
  return tell(options, report);
}

bool run(const Options& options) {
  const std::string output_extension = options.output_format.empty()
                                           ? extension_of(options.output, options)
                                           : "." + options.output_format;
  const bool reads_gltf = is_gltf(extension_of(options.input, options));
  if (reads_gltf != is_gltf(output_extension))
    throw std::runtime_error(options.input + ": glTF goes to glTF only (.gltf, .glb), and no " +
                             "other format does");
  if (!reads_gltf)
    return run_mesh(options);
  require_replaceable(options.output, options.is_forced);
  return run_gltf(options, output_extension);
}

} // namespace

int main(int argc, char** argv) {
  enum ExitStatus { done, target_not_reached, failure };
  CLI::App app("Simplifies a triangle surface by contracting vertex pairs.", "simplify");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : failure; // --help is an error to CLI11, but not here
  }
  try {
    return run(options) ? done : target_not_reached;
  } catch (const std::bad_alloc&) {
    std::cerr << options.input << ": out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return failure;
}
