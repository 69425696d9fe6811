// The command-line program: reads a mesh, simplifies it and writes it.
//
//   simplify IN OUT [--faces N | --ratio R | --vertices N | --error D] [options]
//
// Exit status: 0 done; 1 the target was not reached, OUT holds how far it went; 2 bad usage or
// file, OUT is as it was.

#include "mesh_io.h"
#include "transfer_attributes.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
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
  /// An error limit is kept also if there is nothing more to contract.
  bool is_met(quadrille::StopReason reason) const {
    return reason == quadrille::StopReason::target_met ||
           std::holds_alternative<quadrille::ErrorLimit>(chosen);
  }
};

struct Placement {
  enum { optimal, endpoint, midpoint } chosen;

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
  std::string cost = "quadric";
  std::string placement; // empty: the best that the cost has
  double boundary_weight = quadrille::Quadric{}.boundary_weight;
  double pairs_closer_than = 0;
  std::string topology; // empty: free if there are pairs that are no edges
  bool welds = false;
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
  const auto stop_at_error = [&](double error) { target.chosen = quadrille::ErrorLimit(error); };
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
         "further dimensions, or the shortest")
      ->check(
          CLI::IsMember({"quadric", "memoryless", "thin-features", "color", "texture", "length"}))
      ->capture_default_str();
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

void add_options(CLI::App& app, Options& options) {
  const std::string formats = " (.off .obj .ply .stl .ts)";
  app.add_option("IN", options.input, "the mesh to read" + formats)->required();
  app.add_option("OUT", options.output, "the mesh to write" + formats)->required();
  add_target(app, options.target);
  add_policies(app, options);
  app.add_flag("--weld", options.welds,
               "make vertices at exactly the same place one; without this, that is done only if no "
               "two faces share a vertex");
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

/// What concerns several options, or options and the mesh.
void require_fit(const Options& options, const IndexedMesh& mesh) {
  if (options.cost == "length" && options.placement == "optimal")
    throw std::runtime_error("--placement optimal does not go with --cost length");
  if (options.cost == "color" && mesh.colors.empty())
    throw std::runtime_error(options.input + ": no colours for --cost color");
  if (options.cost == "texture" && mesh.texture_coordinates.empty())
    throw std::runtime_error(options.input + ": no texture coordinates for --cost texture");
}

// --- The work ------------------------------------------------------------------------------------

template <class Cost>
Cost with_boundary_weight(Cost cost, const Options& options) {
  cost.boundary_weight = options.boundary_weight;
  return cost;
}

quadrille::Report simplify(IndexedMesh& mesh, const Options& options, const auto& cost,
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

quadrille::Report simplify_by_cost(IndexedMesh& mesh, const Options& options) {
  namespace parameters = CGAL::parameters;
  if (options.cost == "length")
    return simplify(mesh, options, quadrille::EdgeLength{});
  if (options.cost == "memoryless")
    return simplify(mesh, options, with_boundary_weight(quadrille::MemorylessQuadric{}, options));
  if (options.cost == "thin-features")
    return simplify(mesh, options, with_boundary_weight(quadrille::ThinFeatureQuadric{}, options));
  if (options.cost == "color")
    return simplify(mesh, options, with_boundary_weight(quadrille::ColorQuadric{}, options),
                    parameters::vertex_color_map(CGAL::make_property_map(mesh.colors)));
  if (options.cost == "texture")
    return simplify(
        mesh, options, with_boundary_weight(quadrille::TextureQuadric{}, options),
        parameters::vertex_texture_map(CGAL::make_property_map(mesh.texture_coordinates)));
  return simplify(mesh, options, with_boundary_weight(quadrille::Quadric{}, options));
}

/// Colours and texture coordinates that the cost looks at are its own results. The others are
/// taken from the closest places of the input.
quadrille::Report simplify_with_attributes(IndexedMesh& mesh, const Options& options) {
  const bool keeps_colors = options.cost != "color" && !mesh.colors.empty();
  const bool keeps_textures = options.cost != "texture" && !mesh.texture_coordinates.empty();
  const IndexedMesh input = keeps_colors || keeps_textures ? mesh : IndexedMesh{};
  const quadrille::Report report = simplify_by_cost(mesh, options);
  if (!mesh.colors.empty())
    mesh.colors.resize(mesh.points.size());
  if (!mesh.texture_coordinates.empty())
    mesh.texture_coordinates.resize(mesh.points.size());
  if (mesh.points.empty() || !(keeps_colors || keeps_textures))
    return report;
  const std::vector<SurfacePlace> places = closest_places(input, mesh.points);
  if (keeps_colors)
    mesh.colors = sampled(input.colors, places);
  if (keeps_textures)
    mesh.texture_coordinates = sampled(input.texture_coordinates, places);
  return report;
}

/// False if the target was not reached.
bool run(const Options& options) {
  mesh_format(options.output); // complains before the work rather than after
  IndexedMesh mesh = read_mesh(options.input, options.welds ? Weld::always : Weld::loose_faces);
  require_fit(options, mesh);
  for (const std::string& remark : mesh.remarks)
    if (!options.is_quiet)
      std::cerr << options.input << ": " << remark << '\n';
  const quadrille::Report report = simplify_with_attributes(mesh, options);
  write_mesh(options.output, mesh);
  if (!options.is_quiet)
    std::cout << report << std::endl;
  if (options.target.is_met(report.stop))
    return true;
  std::cerr << options.output << ": the target was not reached: " << to_string(report.stop) << '\n';
  return false;
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
