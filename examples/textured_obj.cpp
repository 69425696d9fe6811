// textured_obj INPUT OUTPUT: simplifies an OBJ file to 1,000 faces, with its texture coordinates
// and materials. OUTPUT is written for the same folder, where its material file is.
#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <quadrille/channels.h>
#include <quadrille/simplify.h>
#include <stdexcept>
#include <string>
#include <tiny_obj_loader.h>
#include <vector>

using Triangle = std::array<std::uint32_t, 3>;

struct Asset {
  std::vector<std::array<float, 3>> points;
  std::vector<Triangle> triangles;
  std::vector<std::array<float, 2>> uvs;
  std::vector<Triangle> uv_triangles; // indices into uvs, for each of triangles
  std::vector<int> materials;         // for each of triangles
  std::vector<std::string> names;     // of the materials
};

Asset read(const std::string& file) {
  tinyobj::ObjReader reader;
  if (!reader.ParseFromFile(file)) // which also makes triangles of its polygons
    throw std::runtime_error(file + ": " + reader.Error());
  const tinyobj::attrib_t& all = reader.GetAttrib();
  Asset asset;
  for (std::size_t i = 0; i + 2 < all.vertices.size(); i += 3)
    asset.points.push_back({all.vertices[i], all.vertices[i + 1], all.vertices[i + 2]});
  for (std::size_t i = 0; i + 1 < all.texcoords.size(); i += 2)
    asset.uvs.push_back({all.texcoords[i], all.texcoords[i + 1]});
  for (const tinyobj::material_t& material : reader.GetMaterials())
    asset.names.push_back(material.name);
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const tinyobj::mesh_t& mesh = shape.mesh;
    for (std::size_t face = 0; face < mesh.material_ids.size(); ++face) {
      Triangle corners{}, uv_corners{};
      for (std::size_t c = 0; c < 3; ++c) {
        const tinyobj::index_t& index = mesh.indices[3 * face + c];
        if (index.texcoord_index < 0)
          throw std::runtime_error(file + ": a face has no texture coordinates");
        corners[c] = static_cast<std::uint32_t>(index.vertex_index);
        uv_corners[c] = static_cast<std::uint32_t>(index.texcoord_index);
      }
      asset.triangles.push_back(corners);
      asset.uv_triangles.push_back(uv_corners);
      asset.materials.push_back(mesh.material_ids[face]);
    }
  }
  return asset;
}

// The line that names the material file, which the reader does not tell.
std::string material_line(const std::string& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("mtllib"))
      return line;
  return "";
}

void write(const std::string& file, const Asset& asset, const std::string& first_line) {
  std::ofstream out(file);
  out.precision(9);
  out << first_line << '\n';
  for (const auto& [x, y, z] : asset.points)
    out << "v " << x << ' ' << y << ' ' << z << '\n';
  for (const auto& [u, v] : asset.uvs)
    out << "vt " << u << ' ' << v << '\n';
  for (std::size_t face = 0; face < asset.triangles.size(); ++face) {
    const int material = asset.materials[face];
    if (material >= 0 && (face == 0 || material != asset.materials[face - 1]))
      out << "usemtl " << asset.names[static_cast<std::size_t>(material)] << '\n';
    out << 'f';
    for (std::size_t c = 0; c < 3; ++c)
      out << ' ' << asset.triangles[face][c] + 1 << '/' << asset.uv_triangles[face][c] + 1;
    out << '\n';
  }
  if (!out.flush())
    throw std::runtime_error(file + ": cannot be written");
}

int main(int argc, char* argv[]) try {
  using namespace quadrille;
  if (argc < 3)
    throw std::runtime_error("usage: textured_obj INPUT.obj OUTPUT.obj");
  Asset asset = read(argv[1]);
  std::cout << simplify(asset.points, asset.triangles, FaceCount{1000},
                        Texture{asset.uvs, asset.uv_triangles},
                        Labels{CGAL::make_property_map(asset.materials)})
            << '\n';
  asset.materials.resize(asset.triangles.size()); // those of the faces that are left are in front
  write(argv[2], asset, material_line(argv[1]));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
