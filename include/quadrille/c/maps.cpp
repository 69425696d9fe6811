#include <quadrille/c/call.h>
#include <quadrille/compiled.h>
#include <quadrille/level_maps.h>
#include <quadrille/levels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace quadrille::internal {

namespace {

// Returns the triangles of a soup that a recording has, with points as vertices: several points at
// one place may be one vertex of the recording.
NumberedSurface surface_of(const SoupView& soup, const std::vector<std::uint32_t>& faces) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(faces.size());
  for (const std::uint32_t face : faces)
    triangles.push_back(soup.triangles[face]);
  return {soup.points.size(), corners_by_face(triangles, faces)};
}

// Gives points without a place that of another point at exactly the same position.
void share_places(const SoupView& soup, std::vector<SurfacePlace>& places) {
  std::map<std::array<double, 3>, SurfacePlace> by_position;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].face != not_recorded)
      by_position.try_emplace(soup.points[i], places[i]);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const auto found = by_position.find(soup.points[i]);
        places[i].face == not_recorded && found != by_position.end())
      places[i] = found->second;
}

SparseRows empty_rows(std::size_t rows, std::size_t columns) {
  return {columns, std::vector<std::int64_t>(rows + 1, 0), {}, {}};
}

} // namespace

void set_maps(quadrille_call& call, const SoupView& soup, const Levels& levels) {
  const SoupResult& result = call.result;
  if (result.triangles.empty()) {
    call.old_to_new = empty_rows(soup.points.size(), result.points.size());
    call.new_to_old = empty_rows(result.points.size(), soup.points.size());
    return;
  }
  const LevelInfo fine = levels.finest(), coarse = levels.coarsest();
  const NumberedSurface old_surface = surface_of(soup, levels.at(AfterContractions{0}).input_faces);
  const NumberedSurface new_surface{result.points.size(),
                                    corners_by_face(result.triangles, result.input_faces)};
  std::vector<SurfacePlace> places = old_surface.places();
  if (call.job.split_vertices)
    share_places(soup, places);
  call.old_to_new = rows_of(carried_places(levels, fine, coarse, places), new_surface);
  call.new_to_old = vertex_rows(levels, coarse, new_surface, fine, old_surface);
}

} // namespace quadrille::internal
