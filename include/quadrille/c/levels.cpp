#include <quadrille/c/arrays.h>
#include <quadrille/c/call.h>
#include <quadrille/c/failures.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/quadrille.h>
#include <quadrille/stop.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace quadrille::internal {

namespace {

std::filesystem::path path_of(const char* path) {
  return reinterpret_cast<const char8_t*>(path);
}

// Calls task(stop) with the stop policy that a name and a number mean.
template <class Task>
auto with_level_stop(const Levels& levels, std::string_view name, double number, Task task) {
  const auto count = [&] {
    if (!(number >= 0 && number < 18446744073709551616.0))
      throw std::invalid_argument(std::string(name) + " is " + text_of(number) + ", not a count");
    return static_cast<std::size_t>(number);
  };
  if (name == "faces")
    return task(FaceCount{count()});
  if (name == "vertices")
    return task(VertexCount{count()});
  if (name == "error")
    return task(ErrorAtMost{number});
  if (name == "distance")
    return task(DistanceAtMost{number});
  if (name == "contractions")
    return task(AfterContractions{count()});
  if (name == "finest")
    return task(AfterContractions{0});
  if (name == "coarsest")
    return task(AfterContractions{levels.coarsest().contractions});
  throw std::invalid_argument("there is no level by " + std::string(name));
}

quadrille_level_info figures_of(const LevelInfo& info) {
  return {info.faces, info.vertices,       info.contractions,
          info.error, info.distance_bound, info.hausdorff_bound};
}

quadrille_array array_of(const Level& level, std::string_view name, std::size_t channel) {
  if (name == "points")
    return view_of(level.points);
  if (name == "triangles")
    return view_of(level.triangles);
  if (name == "input_points")
    return view_of(level.input_vertices);
  if (name == "input_faces")
    return view_of(level.input_faces);
  if (channel >= level.channels.size() || (name != "values" && name != "corners"))
    throw std::invalid_argument("a level has no array " + std::string(name) + " of the channel " +
                                std::to_string(channel));
  const LevelChannel& found = level.channels[channel];
  return name == "values" ? view_of(found.values, found.components) : view_of(found.triangles);
}

} // namespace

} // namespace quadrille::internal

using namespace quadrille::internal;

extern "C" {

quadrille_levels* quadrille_levels_new(void) {
  return new (std::nothrow) quadrille_levels;
}

quadrille_levels* quadrille_levels_copy(const quadrille_levels* levels) {
  quadrille_levels* copy = nullptr;
  std::string error;
  code_of(error, [&] { copy = std::make_unique<quadrille_levels>(*levels).release(); });
  return copy;
}

void quadrille_levels_delete(quadrille_levels* levels) {
  delete levels;
}

const char* quadrille_levels_error(const quadrille_levels* levels) {
  return levels->error.c_str();
}

int32_t quadrille_levels_empty(const quadrille_levels* levels) {
  return levels->levels.empty() ? 1 : 0;
}

int32_t quadrille_levels_save(quadrille_levels* levels, const char* path, const char* comment) {
  return code_of(levels->error, [&] {
    quadrille::LevelsFileOptions options;
    options.comment = comment;
    quadrille::write_levels(path_of(path), levels->levels, options);
  });
}

int32_t quadrille_levels_load(quadrille_levels* levels, const char* path) {
  return code_of(levels->error, [&] {
    quadrille::LevelsFile file(path_of(path));
    quadrille::Levels read = file.read();
    levels->comment = file.comment();
    levels->levels = std::move(read);
  });
}

const char* quadrille_levels_comment(const quadrille_levels* levels) {
  return levels->comment.c_str();
}

int32_t quadrille_levels_info(const quadrille_levels* levels, const char* stop, double number,
                              quadrille_level_info* info, char* error, size_t error_size) {
  return code_of(CallersText{error, error_size}, [&] {
    *info = with_level_stop(levels->levels, stop, number, [&](const auto& policy) {
      return figures_of(levels->levels.info(policy));
    });
  });
}

int32_t quadrille_levels_at(const quadrille_levels* levels, const char* stop, double number,
                            quadrille_level** level, char* error, size_t error_size) {
  return code_of(CallersText{error, error_size}, [&] {
    *level = with_level_stop(levels->levels, stop, number, [&](const auto& policy) {
      return new quadrille_level{in_input_order(levels->levels.at(policy))};
    });
  });
}

void quadrille_level_delete(quadrille_level* level) {
  delete level;
}

quadrille_level_info quadrille_level_figures(const quadrille_level* level) {
  return figures_of(level->level);
}

size_t quadrille_level_channels(const quadrille_level* level) {
  return level->level.channels.size();
}

int32_t quadrille_level_array(const quadrille_level* level, const char* name, size_t channel,
                              quadrille_array* view) {
  return code_of([](const char*) {}, [&] { *view = array_of(level->level, name, channel); });
}

} // extern "C"
