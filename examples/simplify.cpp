// The command-line program: reads a mesh, simplifies it and writes it.
//
//   simplify IN OUT [--faces N | --ratio R | --vertices N] [options]
//
// Exit status: 0 done; 1 the target was not reached, OUT holds how far it went; 2 bad usage or
// file, OUT is as it was.

#include "mesh_io.h"

#include <quadrille/simplify.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <variant>

namespace {

using namespace quadrille_examples;

/// When to stop, as chosen at run time.
struct Target {
  std::variant<quadrille::FaceRatio, quadrille::FaceCount, quadrille::VertexCount> chosen;

  bool operator()(const quadrille::Status& status) const {
    return std::visit([&](const auto& stop) { return stop(status); }, chosen);
  }
  bool is_passed(const quadrille::Status& status) const {
    return std::visit([&](const auto& stop) { return stop.is_passed(status); }, chosen);
  }
};

struct Options {
  std::string input, output;
  Target target;
  quadrille::Quadric cost;
  std::string placement = "optimal";
  bool welds = false;
  bool is_quiet = false;
};

/// CLI11's own checks let -1 and nan through.
const CLI::Validator is_count(
    [](const std::string& word) {
      const std::optional<std::int64_t> count = parse_integer(word);
      return count && *count >= 0 ? "" : in_quotes(word) + " is not a count";
    },
    "");
const CLI::Validator is_fraction(
    [](const std::string& word) {
      const std::optional<double> value = parse_number(word);
      return value && *value >= 0 && *value <= 1 ? "" : in_quotes(word) + " is not in [0, 1]";
    },
    "");
const CLI::Validator is_weight(
    [](const std::string& word) {
      const std::optional<double> value = parse_number(word);
      return value && *value >= 0 && std::isfinite(*value) ? ""
                                                           : in_quotes(word) + " is not a weight";
    },
    "");

void add_target(CLI::App& app, Target& target) {
  CLI::Option_group* const group = app.add_option_group("Target", "half of the faces, unless told");
  group->require_option(0, 1);
  group
      ->add_option_function<std::size_t>(
          "--faces", [&](std::size_t count) { target.chosen = quadrille::FaceCount{count}; },
          "stop at so many faces")
      ->check(is_count);
  group
      ->add_option_function<double>(
          "--ratio", [&](double ratio) { target.chosen = quadrille::FaceRatio{ratio}; },
          "stop when this part of the faces is left")
      ->check(is_fraction);
  group
      ->add_option_function<std::size_t>(
          "--vertices", [&](std::size_t count) { target.chosen = quadrille::VertexCount{count}; },
          "stop at so many vertices")
      ->check(is_count);
}

void add_options(CLI::App& app, Options& options) {
  const std::string formats = " (.off .obj .ply .stl .ts)";
  app.add_option("IN", options.input, "the mesh to read" + formats)->required();
  app.add_option("OUT", options.output, "the mesh to write" + formats)->required();
  add_target(app, options.target);
  app.add_option("--placement", options.placement, "where a contracted vertex goes")
      ->check(CLI::IsMember({"optimal", "endpoint", "midpoint"}))
      ->capture_default_str();
  app.add_option("--boundary-weight", options.cost.boundary_weight, "how firmly boundaries hold")
      ->check(is_weight)
      ->capture_default_str();
  app.add_flag("--weld", options.welds,
               "make vertices at exactly the same place one; without it, only if no two faces "
               "share a vertex");
  app.add_flag("--quiet", options.is_quiet, "print nothing but errors");
}

quadrille::Report simplify(IndexedMesh& mesh, const Options& options) {
  const auto simplify_with = [&](const auto& placement) {
    return quadrille::simplify(mesh.points, mesh.triangles, options.cost, placement,
                               options.target);
  };
  if (options.placement == "endpoint")
    return simplify_with(quadrille::EndpointPlacement{});
  if (options.placement == "midpoint")
    return simplify_with(quadrille::MidpointPlacement{});
  return simplify_with(quadrille::OptimalPlacement{});
}

/// False if the target was not reached.
bool run(const Options& options) {
  mesh_format(options.output); // complains before the work rather than after
  IndexedMesh mesh = read_mesh(options.input, options.welds ? Weld::always : Weld::loose_faces);
  if (!options.is_quiet)
    for (const std::string& remark : mesh.remarks)
      std::cerr << options.input << ": " << remark << '\n';
  const quadrille::Report report = simplify(mesh, options);
  write_mesh(options.output, mesh);
  if (!options.is_quiet)
    std::cout << report << std::endl;
  if (report.stop == quadrille::StopReason::target_met)
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
