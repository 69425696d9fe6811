// SPDX-License-Identifier: MIT
//
// What a benchmark is asked for on its command line.

#ifndef QUADRILLE_BENCHMARK_SETTINGS_H
#define QUADRILLE_BENCHMARK_SETTINGS_H

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

struct Settings {
  std::vector<std::string> models;
  double ratio = 0.1;
  std::size_t faces = 0;
  int runs = 5;
  double limit = 900;
  std::vector<std::string> only;
  std::size_t samples = 100'000;
  double noise = 0;
  std::filesystem::path out = ".";

  void add_to(CLI::App& app) {
    app.add_option("models", models, "Files of meshes")->required();
    app.add_option("--ratio", ratio, "Faces to keep, of each model")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    app.add_option("--faces", faces, "Faces to keep, as a number; goes before the ratio");
    app.add_option("--runs", runs, "Runs of each contender")->capture_default_str();
    app.add_option("--limit", limit, "Seconds after which a run is given up")
        ->capture_default_str();
    app.add_option("--only", only, "Names of the contenders that take part");
    app.add_option("--samples", samples, "Samples on each surface, for the distances")
        ->capture_default_str();
    app.add_option("--noise", noise,
                   "Moves each coordinate of the input by at most that many mean edge lengths; "
                   "distances are still those to the surface without noise")
        ->capture_default_str();
    app.add_option("--out", out, "Folder for the results")->capture_default_str();
  }

  bool takes(const std::string& contender, bool is_slow) const {
    return (only.empty() && !is_slow) || std::ranges::find(only, contender) != only.end();
  }
  std::size_t target(std::size_t input_faces) const {
    return faces != 0
               ? faces
               : static_cast<std::size_t>(std::llround(ratio * static_cast<double>(input_faces)));
  }

  /// Writes a file of results: write(stream).
  template <class Write>
  void write_file(const std::string& name, Write write) const {
    const std::filesystem::path file = out / name;
    std::ofstream stream(file);
    write(stream);
    if (!stream.flush())
      throw std::runtime_error("cannot write " + file.string());
  }
};

} // namespace bench

#endif
