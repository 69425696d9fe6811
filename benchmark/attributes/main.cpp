// SPDX-License-Identifier: MIT
//
// Simplifies models with colours or texture coordinates with every contender and writes, per model,
// a table and a CSV file.

#include "../settings.h"
#include "report.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>

namespace {

using namespace bench;

std::vector<AttributeContender> contenders(const Settings& settings) {
  std::vector<AttributeContender> chosen;
  for (const auto& family : {our_attribute_contenders(), meshoptimizer_attribute_contenders(),
                             vtk_attribute_contenders()})
    std::ranges::copy_if(family, std::back_inserter(chosen), [&](const auto& contender) {
      return settings.takes(contender.name, false);
    });
  return chosen;
}

std::optional<Run> run(const AttributeContender& contender, const Model& model,
                       const AttributeTask& task, double limit, Purpose purpose) {
  Soup soup;
  return run_in_child({.prepare =
                           [&] {
                             soup = sphere(task.kind).soup;
                             contender.simplify(soup, {task.kind, 128, task.factor, task.weight});
                             soup = model.soup;
                           },
                       .simplify = [&] { return contender.simplify(soup, task); },
                       .answer = [&] { return std::move(soup); }},
                      limit, purpose);
}

/// Memory and errors, with the best factor.
void measure_quality(const AttributeContender& contender, const Model& model,
                     const AttributeTask& task, const Settings& settings, AttributeRow& row) {
  for (double factor : contender.factors) {
    std::cerr << row.contender << ", memory and error, factor " << factor << "\n";
    const auto measured =
        run(contender, model, {task.kind, task.faces, factor, factor * task.weight}, settings.limit,
            Purpose::memory);
    if (!measured)
      continue;
    const AttributeQuality quality = measure(model, measured->answer, settings.samples);
    if (row.quality && score(quality, model.kind) >= score(*row.quality, model.kind))
      continue;
    row.factor = factor;
    row.quality = quality;
    row.peak_megabytes = measured->peak_megabytes;
  }
}

/// Round after round, so that a slow minute of the machine falls on all alike.
AttributeResult compete(const std::string& name, const Model& model, const Settings& settings) {
  const std::size_t faces = model.soup.triangles.size();
  const AttributeTask task{model.kind, settings.target(faces), 1, default_weight(model)};
  AttributeResult result{.model = name,
                         .kind = model.kind,
                         .input_faces = faces,
                         .input_open_edges = open_edges(model.soup),
                         .target_faces = task.faces,
                         .samples = settings.samples,
                         .rows = {}};
  const std::vector<AttributeContender> all = contenders(settings);
  for (const AttributeContender& contender : all) {
    result.rows.push_back({contender.name, contender.options, 1, {}, {}});
    measure_quality(contender, model, task, settings, result.rows.back());
  }
  for (int round = 0; round < settings.runs; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      AttributeRow& row = result.rows[i];
      if (!row.quality)
        continue; // it has failed
      std::cerr << name << ", round " << round + 1 << ": " << row.contender << "\n";
      auto timed = run(all[i], model, {task.kind, task.faces, row.factor, row.factor * task.weight},
                       settings.limit, Purpose::time);
      if (!timed)
        continue;
      timed->answer = {};
      row.runs.push_back(*timed);
    }
  return result;
}

/// False when the model could not be used.
bool benchmark(const std::string& name, const auto& get, const Settings& settings) {
  try {
    const AttributeResult result = compete(name, get(), settings);
    write_markdown(result, std::cout);
    std::cout << std::endl;
    const std::string file = name + "_attributes_" + std::to_string(result.target_faces);
    settings.write_file(file + ".csv", [&](auto& out) { write_csv(result, out); });
    settings.write_file(file + ".md", [&](auto& out) { write_markdown(result, out); });
    return true;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return false;
  }
}

bool benchmark(const std::string& model, const Settings& settings) {
  if (model == "colored-sphere")
    return benchmark(
        model, [] { return sphere(Kind::color); }, settings);
  if (model == "textured-sphere")
    return benchmark(
        model, [] { return sphere(Kind::texture); }, settings);
  return benchmark(
      std::filesystem::path(model).stem().string(), [&] { return read_model(model); }, settings);
}

} // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("Simplifies models with colours or texture coordinates with every contender; writes "
               "a table and a CSV file per model. The names colored-sphere and textured-sphere "
               "stand for small models that are made");
  settings.add_to(app);
  CLI11_PARSE(app, argc, argv);

  if (contenders(settings).empty())
    return EXIT_SUCCESS; // it is another benchmark that is asked for
  std::filesystem::create_directories(settings.out);
  bool all_used = true;
  for (const std::string& model : settings.models)
    all_used &= benchmark(model, settings);
  return all_used ? EXIT_SUCCESS : EXIT_FAILURE;
}
