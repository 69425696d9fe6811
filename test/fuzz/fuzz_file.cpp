// Bytes are a file, the first of them its format: it is refused with an exception, or read, and
// then simplified with its colours, texture coordinates, normals and parts, written and read again.
#include "../../examples/products/mesh_io/attributes/mesh_channels.h"
#include "../../examples/products/mesh_io/mesh/split_seams.h"
#include "../../examples/products/mesh_io/mesh_io.h"

#include <quadrille/simplify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille_examples;

void require(bool holds, const char* what) {
  if (holds)
    return;
  std::cerr << what << '\n';
  std::abort();
}

bool is_finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

template <std::size_t N>
void require_valid(const CornerValues<N>& corners, std::size_t triangles) {
  require(corners.empty() || corners.triples.size() == triangles, "triples");
  for (const auto& triple : corners.triples)
    for (const std::uint32_t index : triple)
      require(index < corners.values.size(), "an index of no value");
  for (const auto& value : corners.values)
    for (const double number : value)
      require(std::isfinite(number), "a value at a corner that is none");
}

void require_valid(const FaceParts& parts, std::size_t triangles) {
  require(parts.of_faces.empty() || parts.of_faces.size() == triangles, "parts");
  for (const std::uint32_t part : parts.of_faces)
    require(part < parts.parts.size(), "no part");
}

void require_valid(const IndexedMesh& mesh) {
  require_valid(mesh.corner_textures, mesh.triangles.size());
  require_valid(mesh.corner_normals, mesh.triangles.size());
  require_valid(mesh.parts, mesh.triangles.size());
  require(std::all_of(mesh.points.begin(), mesh.points.end(), is_finite), "not finite");
  require(mesh.colors.empty() || mesh.colors.size() == mesh.points.size(), "colours");
  require(mesh.texture_coordinates.empty() || mesh.texture_coordinates.size() == mesh.points.size(),
          "texture coordinates");
  for (const Color& color : mesh.colors)
    for (const double channel : color)
      require(std::isfinite(channel) &&
                  (!mesh.color_type.is_whole || (channel == std::round(channel) && channel >= 0 &&
                                                 channel <= mesh.color_type.full)),
              "a colour that is none");
  for (const auto& [u, v] : mesh.texture_coordinates)
    require(std::isfinite(u) && std::isfinite(v), "a texture coordinate that is none");
  for (const auto& [a, b, c] : mesh.triangles) {
    require(std::max({a, b, c}) < mesh.points.size(), "an index of no point");
    require(a != b && b != c && c != a, "a face with two equal corners");
  }
}

IndexedMesh read(const MeshFormat& format, const std::filesystem::path& path, std::string content,
                 Weld weld) {
  IndexedMesh mesh = read_mesh({path, std::move(content)}, format, weld);
  require_valid(mesh);
  return mesh;
}

/// As the program does.
void simplify(IndexedMesh& mesh) {
  if (needs_channels(mesh)) {
    MeshChannels(mesh).simplify({}, {});
    return;
  }
  quadrille::simplify(mesh.points, mesh.triangles);
  resize_constants(mesh);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array names{"a.off", "a.obj", "a.ply", "a.stl", "a.ts"};
  if (size < 2) // empty files are refused before they are parsed
    return 0;
  const std::filesystem::path path = names[data[0] % names.size()];
  const Weld weld = data[0] / names.size() % 2 == 0 ? Weld::surfaces : Weld::places;
  const MeshFormat& format = mesh_format(path);
  try {
    IndexedMesh mesh = read(format, path, std::string(data + 1, data + size), weld);
    const std::string losses = mesh.losses.text();
    require(losses.find('\n') == std::string::npos, "losses in more than one line");
    simplify(mesh);
    require_valid(mesh);
    const std::string written = format.encode(with_vertices_of_values(mesh));
    const bool is_single = path.extension() == ".stl";
    if (is_single || mesh.points.empty())
      return 0;
    const IndexedMesh again = read(format, path, written, Weld::surfaces);
    require(again.triangles.size() == mesh.triangles.size() || !again.remarks.empty(),
            "other triangles were written");
    require(again.colors.empty() != format.holds_attributes || mesh.colors.empty(),
            "colours were lost");
    const bool have_same = again.corner_textures.empty() == mesh.corner_textures.empty() &&
                           again.corner_normals.empty() == mesh.corner_normals.empty();
    require(path.extension() != ".obj" || !again.remarks.empty() || !have_same ||
                format.encode(again) == written,
            "another file was written");
  } catch (const std::runtime_error& error) { // refused, in one line
    require(std::string(error.what()).find('\n') == std::string::npos, "more than one line");
  } catch (const std::invalid_argument&) { // attributes that no weight makes comparable
  }
  return 0;
}
