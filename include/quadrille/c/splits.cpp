#include <quadrille/c/arrays.h>
#include <quadrille/c/call.h>
#include <quadrille/c/failures.h>
#include <quadrille/level_splits.h>
#include <quadrille/quadrille.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

struct quadrille_splits {
  quadrille::VertexSplits splits;
};

namespace quadrille::internal {

namespace {

quadrille_array array_of(const VertexSplits& splits, std::string_view name) {
  const std::array<std::pair<std::string_view, quadrille_array>, 13> arrays{
      {{"points", view_of(splits.points)},
       {"faces", view_of(splits.faces)},
       {"input_points", view_of(splits.input_vertices)},
       {"input_faces", view_of(splits.input_faces)},
       {"point_counts", view_of(splits.vertex_counts)},
       {"face_counts", view_of(splits.face_counts)},
       {"errors", view_of(splits.errors)},
       {"parents", view_of(splits.parents)},
       {"children", view_of(splits.children)},
       {"merged_points", view_of(splits.merged_points)},
       {"parent_points", view_of(splits.parent_points)},
       {"corner_begins", view_of(splits.corner_begins)},
       {"corners", view_of(splits.corners)}}};
  for (const auto& [known, array] : arrays)
    if (known == name)
      return array;
  throw std::invalid_argument("splits have no array " + std::string(name));
}

} // namespace

} // namespace quadrille::internal

using namespace quadrille::internal;

extern "C" {

int32_t quadrille_levels_splits(const quadrille_levels* levels, quadrille_splits** splits,
                                char* error, size_t error_size) {
  return code_of(CallersText{error, error_size},
                 [&] { *splits = new quadrille_splits{quadrille::vertex_splits(levels->levels)}; });
}

void quadrille_splits_delete(quadrille_splits* splits) {
  delete splits;
}

int32_t quadrille_splits_array(const quadrille_splits* splits, const char* name,
                               quadrille_array* view) {
  return code_of([](const char*) {}, [&] { *view = array_of(splits->splits, name); });
}

} // extern "C"
