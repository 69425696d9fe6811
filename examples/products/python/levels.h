#ifndef QUADRILLE_EXAMPLES_PYTHON_LEVELS_H
#define QUADRILLE_EXAMPLES_PYTHON_LEVELS_H

/// \file
/// Levels of detail for Python.

#include "arrays.h"

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
  result["hausdorff_bound"] = info.hausdorff_bound;
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

/// Levels that threads of Python share. They are called with the lock of the interpreter, which a
/// task may let go of and has again when it ends: meanwhile others may read where it reads, and are
/// refused where it records, or where they want to.
class SharedLevels {
public:
  SharedLevels() = default;
  explicit SharedLevels(quadrille::Levels levels) : levels_(std::move(levels)) {}
  SharedLevels(SharedLevels&& other) noexcept : levels_(std::move(other.levels_)) {}
  SharedLevels& operator=(const SharedLevels&) = delete;

  /// Returns task(levels).
  template <class Task>
  auto read(Task task) const {
    if (is_recorded_)
      throw py::value_error("these Levels are being recorded by another call of simplify()");
    const Use use(readers_);
    return task(levels_);
  }

  SharedLevels copy() const {
    return SharedLevels(read([](const quadrille::Levels& levels) { return levels; }));
  }

  /// As read(), with levels that change.
  template <class Task>
  auto record(Task task) {
    if (is_recorded_ || readers_ > 0)
      throw py::value_error(
          std::string("these Levels are being ") +
          (is_recorded_ ? "recorded by another call of simplify()" : "read by another thread"));
    const Use use(is_recorded_);
    return task(levels_);
  }

private:
  class Use {
  public:
    explicit Use(int& count) : count_(count) { ++count_; }
    ~Use() { --count_; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

  private:
    int& count_;
  };

  quadrille::Levels levels_;
  mutable int readers_ = 0;
  int is_recorded_ = 0;
};

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
inline void save(const SharedLevels& shared, const std::filesystem::path& path,
                 const std::string& comment) {
  shared.read([&](const quadrille::Levels& levels) {
    with_value_errors([&] {
      const py::gil_scoped_release unlocked;
      quadrille::LevelsFileOptions options;
      options.comment = comment;
      write_levels(path, levels, options);
    });
  });
}

inline std::pair<SharedLevels, std::string> load(const std::filesystem::path& path) {
  const py::gil_scoped_release unlocked;
  quadrille::LevelsFile file(path);
  return {SharedLevels(file.read()), file.comment()};
}

inline void add_levels(py::module_& m) {
  using quadrille::Levels;
  py::class_<SharedLevels>(m, "Levels")
      .def(py::init<>())
      .def("copy", &SharedLevels::copy)
      .def("empty",
           [](const SharedLevels& shared) {
             return shared.read([](const Levels& levels) { return levels.empty(); });
           })
      .def("at",
           [](const SharedLevels& shared, const std::string& stop, double number) {
             return shared.read(
                 [&](const Levels& levels) { return dict_of(level_at(levels, stop, number)); });
           })
      .def("info",
           [](const SharedLevels& shared, const std::string& stop, double number) {
             return shared.read(
                 [&](const Levels& levels) { return dict_of(level_info(levels, stop, number)); });
           })
      .def("finest",
           [](const SharedLevels& shared) {
             return shared.read([](const Levels& levels) { return dict_of(levels.finest()); });
           })
      .def("coarsest",
           [](const SharedLevels& shared) {
             return shared.read([](const Levels& levels) {
               return with_value_errors([&] { return dict_of(levels.coarsest()); });
             });
           })
      .def("save", save);
  m.def("load_levels", load);
}

} // namespace quadrille_examples

#endif
