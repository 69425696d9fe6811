#ifndef QUADRILLE_EXAMPLES_PYTHON_LEVELS_H
#define QUADRILLE_EXAMPLES_PYTHON_LEVELS_H

/// \file
/// Levels of detail for Python.

#include "arrays.h"

#include <quadrille/level.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/stop.h>

#include <pybind11/stl/filesystem.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

/// Calls task(stop) with the one that a name and a number say.
template <class Task>
auto with_level_stop(const std::string& name, double number, Task task) {
  const auto count = [number] { return static_cast<std::size_t>(number); };
  if (name == "faces")
    return task(quadrille::FaceCount{count()});
  if (name == "vertices")
    return task(quadrille::VertexCount{count()});
  if (name == "error")
    return task(quadrille::ErrorAtMost{number});
  if (name == "distance")
    return task(quadrille::DistanceAtMost{number});
  return task(quadrille::AfterContractions{count()});
}

inline py::dict dict_of(const quadrille::LevelInfo& info) {
  py::dict result;
  result["faces"] = info.faces;
  result["vertices"] = info.vertices;
  result["contractions"] = info.contractions;
  result["error"] = info.error;
  result["distance_bound"] = info.distance_bound;
  return result;
}

/// The arrays of a level, with its channels as values and indices of corners, or None.
inline py::dict dict_of(quadrille::Level level) {
  py::dict result;
  result["info"] = dict_of(static_cast<const quadrille::LevelInfo&>(level));
  result["points"] = array_of_rows(std::move(level.points));
  result["faces"] = array_of_rows(std::move(level.triangles));
  result["input_points"] = array_of_numbers(std::move(level.input_vertices));
  result["input_faces"] = array_of_numbers(std::move(level.input_faces));
  py::list channels;
  for (quadrille::LevelChannel& channel : level.channels) {
    const bool has_corners =
        !channel.triangles.empty() || result["faces"].attr("size").cast<int>() == 0;
    py::object corners = py::none();
    if (has_corners)
      corners = array_of_rows(std::move(channel.triangles));
    channels.append(
        py::make_tuple(array_of_values(std::move(channel.values), channel.components), corners));
  }
  result["channels"] = channels;
  return result;
}

/// What is wrong with levels, or with what is asked of them, is a ValueError in Python.
template <class Task>
auto with_value_errors(Task task) {
  try {
    return task();
  } catch (const std::logic_error& error) {
    throw py::value_error(error.what());
  }
}

inline quadrille::Level level_at(const quadrille::Levels& levels, const std::string& stop,
                                 double number) {
  return with_value_errors([&] {
    return with_level_stop(stop, number,
                           [&](auto policy) { return in_input_order(levels.at(policy)); });
  });
}

inline quadrille::LevelInfo level_info(const quadrille::Levels& levels, const std::string& stop,
                                       double number) {
  return with_value_errors([&] {
    return with_level_stop(stop, number, [&](auto policy) { return levels.info(policy); });
  });
}

/// With a comment, by which the names of channels are read again.
inline void save(const quadrille::Levels& levels, const std::filesystem::path& path,
                 const std::string& comment) {
  with_value_errors([&] {
    quadrille::LevelsFileOptions options;
    options.comment = comment;
    write_levels(path, levels, options);
  });
}

inline std::pair<quadrille::Levels, std::string> load(const std::filesystem::path& path) {
  quadrille::LevelsFile file(path);
  quadrille::Levels levels = file.read();
  return {std::move(levels), file.comment()};
}

} // namespace quadrille_examples

#endif
