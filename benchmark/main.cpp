// SPDX-License-Identifier: MIT
//
// Simplifies models with every contender and writes, per model, a table and a CSV file.

#include "report.h"
#include "settings.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace {

using namespace bench;
namespace fs = std::filesystem;

std::vector<Contender> contenders(const Settings& settings) {
  std::vector<Contender> chosen;
  for (const auto& family : {our_contenders(), cgal_contenders(), meshoptimizer_contenders(),
                             openmesh_contenders(), vtk_contenders()})
    std::ranges::copy_if(family, std::back_inserter(chosen), [&](const Contender& contender) {
      return settings.takes(contender.name, contender.is_slow);
    });
  return chosen;
}

/// A model as a triangle mesh; a soup is made a mesh, a polygon triangles.
Mesh read(const std::string& file) {
  Mesh mesh;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
    throw std::runtime_error("cannot be read");
  if (!CGAL::is_triangle_mesh(mesh))
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  mesh.collect_garbage();
  return mesh;
}

/// The same with noise, of which Settings tells.
Mesh with_noise(Mesh mesh, double edges) {
  if (edges != 0)
    add_noise(mesh, edges, 1);
  return mesh;
}

/// Round after round, so that a slow minute of the machine falls on all alike.
Result compete(const std::string& model, const Mesh& clean, const Settings& settings) {
  const Mesh mesh = with_noise(clean, settings.noise);
  Result result{.model = model,
                .input_faces = mesh.number_of_faces(),
                .target_faces = settings.target(mesh.number_of_faces()),
                .samples = settings.samples,
                .rows = {}};
  const Soup input = to_soup(clean);
  const std::vector<Contender> all = contenders(settings);
  for (const Contender& contender : all)
    result.rows.push_back({contender.name, contender.options, {}, {}});
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::cerr << model << ", memory and error: " << all[i].name << "\n";
    Row& row = result.rows[i];
    const auto run =
        run_in_child(all[i], mesh, result.target_faces, settings.limit, Purpose::memory);
    if (!run)
      continue;
    row.peak_megabytes = run->peak_megabytes;
    row.quality = measure(input, run->answer, settings.samples);
  }
  for (int round = 0; round < settings.runs; ++round) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      Row& row = result.rows[i];
      if (!row.quality)
        continue; // it has failed
      std::cerr << model << ", round " << round + 1 << ": " << row.contender << "\n";
      auto run = run_in_child(all[i], mesh, result.target_faces, settings.limit, Purpose::time);
      if (!run)
        continue;
      run->answer = {};
      row.runs.push_back(*run);
    }
  }
  return result;
}

/// False when the model could not be used.
bool benchmark(const std::string& file, const Settings& settings) {
  try {
    const std::string model = fs::path(file).stem().string();
    const Result result = compete(model, read(file), settings);
    write_markdown(result, std::cout);
    std::cout << std::endl;
    const std::string name =
        model + "_" + std::to_string(result.target_faces) + (settings.noise > 0 ? "_noisy" : "");
    settings.write_file(name + ".csv", [&](auto& out) { write_csv(result, out); });
    settings.write_file(name + ".md", [&](auto& out) { write_markdown(result, out); });
    return true;
  } catch (const std::exception& error) {
    std::cerr << file << ": " << error.what() << "\n";
    return false;
  }
}

} // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("Simplifies models with every contender; writes a table and a CSV file per model");
  settings.add_to(app);
  CLI11_PARSE(app, argc, argv);

  fs::create_directories(settings.out);
  bool all_used = true;
  for (const std::string& model : settings.models)
    all_used &= benchmark(model, settings);
  return all_used ? EXIT_SUCCESS : EXIT_FAILURE;
}
