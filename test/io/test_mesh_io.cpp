// Reading and writing of meshes in examples/products/mesh_io/mesh_io.h: small files, most of them
// broken, written here into a folder of their own.

#include "../examples/products/mesh_io/formats/obj_writer.h"
#include "../examples/products/mesh_io/formats/ply_writer.h"
#include "../examples/products/mesh_io/formats/stl.h"
#include "../examples/products/mesh_io/mesh/split_seams.h"
#include "../examples/products/mesh_io/mesh_io.h"
#include "../examples/products/mesh_io/replace_file.h"
#include "../examples/products/mesh_io/text.h"
#include "folder.h"

#include <catch2/catch.hpp>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using namespace quadrille_examples;
using test::Folder;

namespace {

IndexedMesh read(const std::string& name, const std::string& content, Weld weld = Weld::surfaces) {
  const Folder folder;
  return read_mesh(folder.file(name, content), weld);
}

/// What reading the file complains about, without the folder; "accepted" if it does not.
std::string complaint(const std::string& name, const std::string& content) {
  const Folder folder;
  const fs::path path = folder.file(name, content);
  try {
    read_mesh(path);
  } catch (const std::runtime_error& error) {
    const std::string folder_name = path.parent_path().string() + "/";
    const std::string message = error.what();
    return message.starts_with(folder_name) ? message.substr(folder_name.size()) : message;
  }
  return "accepted";
}

/// The colours as bytes, as most programs have them.
std::vector<CGAL::IO::Color> bytes_of(const IndexedMesh& mesh) {
  std::vector<CGAL::IO::Color> result;
  const auto byte = [&](double channel) {
    const double fraction = std::clamp(channel / mesh.color_type.full, 0., 1.);
    return static_cast<unsigned char>(std::lround(255 * fraction));
  };
  for (const auto& [red, green, blue, alpha] : mesh.colors)
    result.emplace_back(byte(red), byte(green), byte(blue), byte(alpha));
  return result;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Value>
std::string bytes(Value value, std::endian order = std::endian::little) {
  std::string result;
  append_little_endian(result, value);
  return order == std::endian::little ? result : std::string(result.rbegin(), result.rend());
}

/// Wherever the format has them; there are no seams.
std::vector<std::array<double, 2>> textures_of_vertices(const IndexedMesh& mesh) {
  return mesh.corner_textures.empty() ? mesh.texture_coordinates
                                      : with_vertex_textures(mesh).texture_coordinates;
}

double area(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += std::sqrt(CGAL::squared_area(mesh.points[a], mesh.points[b], mesh.points[c]));
  return sum;
}

using Triangle = std::array<std::uint32_t, 3>;
const std::vector<Triangle> one_triangle = {{0, 1, 2}};
const std::vector<Point> its_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

const std::string off_triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string stl_triangle =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
const std::string ts_triangle = "GOCAD TSurf 1\nHEADER {\nname:a\n}\nTFACE\nVRTX 1 0 0 0\n"
                                "VRTX 2 1 0 0\nPVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n";

/// The vertices are items "vertex" of x y z and the faces a list of ints, unless told otherwise.
std::string ply(const std::string& format, const std::string& body,
                const std::string& index = "int", const std::string& count = "uchar",
                const std::string& more = "") {
  return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" +
         "property float z\n" + more + "element face 1\nproperty list " + count + " " + index +
         " vertex_indices\nend_header\n" + body;
}

std::string float_points(std::endian order = std::endian::little) {
  std::string result;
  for (const float coordinate : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
    result += bytes(coordinate, order);
  return result;
}

const std::string text_points = "0 0 0\n1 0 0\n0 1 0\n";
const std::string ply_triangle = ply("ascii", text_points + "3 0 1 2\n");

} // namespace

TEST_CASE("A triangle is the same in every format", "[mesh_io]") {
  const auto [name, content] = GENERATE(table<std::string, std::string>(
      {{"a.off", off_triangle},
       {"a.obj", obj_triangle},
       {"a.stl", stl_triangle},
       {"a.ts", ts_triangle},
       {"a.ply", ply_triangle},
       {"A.OFF", off_triangle},
       {"binary.ply", ply("binary_little_endian", float_points() + bytes(std::uint8_t{3}) +
                                                      bytes(0) + bytes(1) + bytes(2))}}));
  CAPTURE(name);
  const IndexedMesh mesh = read(name, content);
  CHECK(mesh.points == its_points);
  CHECK(mesh.triangles == one_triangle);
  CHECK(mesh.colors.empty());
  CHECK(mesh.texture_coordinates.empty());
  CHECK(mesh.remarks.empty());
}

TEST_CASE("Lines may end in CR LF, in CR, or with the file", "[mesh_io]") {
  for (const std::string newline : {"\n", "\r\n", "\r"}) {
    std::string content;
    for (const char c : off_triangle)
      content += c == '\n' ? newline : std::string(1, c);
    CHECK(read("a.off", content).triangles == one_triangle);
    CHECK(complaint("a.off", content + "x") ==
          "a.off:7: the file goes on after the last of 1 faces");
    content.resize(content.size() - newline.size());
    CHECK(read("a.off", content).triangles == one_triangle);
  }
}

TEST_CASE("Files that are missing, empty or of no known format are refused", "[mesh_io]") {
  CHECK(complaint("a.off", "") == "a.off: the file is empty");
  CHECK(complaint("a.obj", "") == "a.obj: the file is empty");
  CHECK(complaint("a.stl", "") == "a.stl: the file is empty");
  CHECK(complaint("a.txt", "x") ==
        "a.txt: the extension '.txt' is not one of .off .obj .ply .stl .ts");
  CHECK(complaint("off", "x") == "off: the extension '' is not one of .off .obj .ply .stl .ts");
  const Folder folder;
  CHECK_THROWS_WITH(read_mesh(folder.path("a.off")), Catch::EndsWith("a.off: no such file"));
  fs::create_directory(folder.path("b.off"));
  CHECK_THROWS_WITH(read_mesh(folder.path("b.off")), Catch::EndsWith("b.off: not a regular file"));
}

TEST_CASE("Broken OFF files are refused with their place", "[mesh_io]") {
  const auto [content, message] = GENERATE(table<std::string, std::string>({
      {"# nothing\n\n", "a.off:2: not an OFF file: it contains only comments"},
      {"PLY\n", "a.off:1: not a three-dimensional OFF file: it starts with 'PLY'"},
      {"nOFF\n4\n", "a.off:1: not a three-dimensional OFF file: it starts with 'nOFF'"},
      {"OFF BINARY\n", "a.off:1: binary OFF is not supported"},
      {"OFF\n\0", "a.off:1: the file ends before the counts"},
      {"OFF\n3\n", "a.off:2: the line ends before the next face count"},
      {"OFF\n3 x 0\n", "a.off:2: face count 'x' is not an integer"},
      {"OFF\n-3 1 0\n", "a.off:2: vertex count -3 is negative"},
      {"OFF\n3 -1 0\n", "a.off:2: face count -1 is negative"},
      {"OFF\n99999999999 1 0\n0 0 0\n", "a.off:2: 99999999999 vertices do not fit into the file"},
      {"OFF\n99999999999999999999 1 0\n",
       "a.off:2: vertex count '99999999999999999999' is not an integer"},
      {"OFF\n1 4000000000 0\n0 0 0\n", "a.off:2: 4000000000 faces do not fit into the file"},
      {"OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
       "a.off:3: the line ends before the next coordinate"},
      {"OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n",
       "a.off:4: coordinate 'zero' is not a number"},
      {"OFF\n3 1 0\n0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", "a.off:4: coordinate '0,5' is not a number"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n\n",
       "a.off:5: the file ends before vertex 2 of 3 (counted from 0)"},
      {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
       "a.off:6: the file ends before face 1 of 2 (counted from 0)"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
       "a.off:6: the line ends before the next vertex index"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
       "a.off:6: vertex index 3 is out of range: there are 3"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
       "a.off:6: vertex index -1 is out of range: there are 3"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n",
       "a.off:6: vertex index '1.5' is not an integer"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
       "a.off:6: the line ends before the next vertex index"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "a.off:6: corner count -3 is negative"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n",
       "a.off:7: the file goes on after the last of 1 faces"},
      {"OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
       "a.off: vertex 1, counted from 0, is not finite"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e999 0\n3 0 1 2\n",
       "a.off: vertex 2, counted from 0, is not finite"},
      {"4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n",
       "a.off: vertex 1, counted from 0, is not finite"},
      {"NOFF\n1 0 0\n0 0 0 0 0\n", "a.off:3: the line ends before the next normal"},
      {"COFF\n1 0 0\n0 0 0 255 255\n", "a.off:3: the line ends before the next colour"},
      {"STOFF\n1 0 0\n0 0 0 0.5\n", "a.off:3: the line ends before the next texture coordinate"},
  }));
  CAPTURE(content);
  CHECK(complaint("a.off", content) == message);
}

TEST_CASE("What a message quotes is short and printable", "[mesh_io]") {
  CHECK(
      complaint("a.off", "\1\x7F\xFF" + std::string(1000, 'x')) ==
      "a.off:1: not a three-dimensional OFF file: it starts with '???xxxxxxxxxxxxxxxxxxxxx...'");
}

TEST_CASE("OFF files come in variants", "[mesh_io]") {
  CHECK(read("a.off", "3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").points == its_points);
  CHECK(read("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").points == its_points);
  CHECK(
      read("a.off", "#c\nOFF # c\n\n3 1 0 # c\n0 0 0#c\n#\n+1 0 0\n0 1e0 0 \n3 0 1 2\n#").points ==
      its_points);
  CHECK(read("a.off", "\xEF\xBB\xBF" + off_triangle).points == its_points);
  CHECK(read("a.off", "4OFF 3 1 0\n0 0 0 1\n2 0 0 2\n0 .5 0 .5\n3 0 1 2").points == its_points);
  CHECK(read("a.off", "NOFF 3 1 0\n0 0 0 7 7 7\n1 0 0 7 7 7\n0 1 0 7 7 7\n3 0 1 2").points ==
        its_points);
  CHECK(read("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n").triangles ==
        one_triangle);
  CHECK(read("a.off", "OFF 0 0 0").points.empty());
  const std::string triangle = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string keyword : {"OFF", "off", "OFF\n", "Off "})
    if (keyword == "Off ")
      CHECK(complaint("a.off", keyword + triangle) ==
            "a.off:1: not a three-dimensional OFF file: it starts with 'Off'");
    else
      CHECK(read("a.off", keyword + triangle).points == its_points);
}

TEST_CASE("The letters of an OFF keyword come in any order", "[mesh_io]") {
  const auto read_as = [](const std::string& keyword) {
    std::string content = keyword + "3 1 0\n";
    for (const std::string place : {"0 0 0", "1 0 0", "0 1 0"}) {
      content += place;
      if (keyword.find('4') != std::string::npos)
        content += " 1";
      if (keyword.find('N') != std::string::npos)
        content += " 0 0 1";
      if (keyword.find('C') != std::string::npos)
        content += " 9 8 7 6";
      if (keyword.find("ST") != std::string::npos)
        content += " .25 .75";
      content += "\n";
    }
    return read("a.off", content + "3 0 1 2\n");
  };
  for (const std::string keyword :
       {"NCOFF", "CNOFF", "STCNOFF", "NSTCOFF", "C4OFF\n", "CNST4OFF ", "4STNCOFF"}) {
    CAPTURE(keyword);
    const IndexedMesh mesh = read_as(keyword);
    CHECK(mesh.points == its_points);
    CHECK(bytes_of(mesh)[2] == CGAL::IO::Color(9, 8, 7, 6));
    CHECK(mesh.texture_coordinates.empty() == (keyword.find("ST") == std::string::npos));
    CHECK(mesh.losses.text() == (keyword.find('N') == std::string::npos ? "" : "normals"));
  }
  CHECK(complaint("a.off", "CCOFF 0 0 0") ==
        "a.off:1: not a three-dimensional OFF file: it starts with 'CCOFF'");
}

TEST_CASE("Broken OBJ files are refused with their place", "[mesh_io]") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto [rest, message] = GENERATE(table<std::string, std::string>({
      {"f 1 2 0\n", "a.obj:4: vertex index 0 is out of range: there are 3"},
      {"f 1 2 4\n", "a.obj:4: vertex index 4 is out of range: there are 3"},
      {"f 1 2 9999999999\n", "a.obj:4: vertex index 9999999999 is out of range: there are 3"},
      {"f -1 -2 -4\n", "a.obj:4: vertex index -4 is out of range: there are 3"},
      {"f 1 2 99\nv 1 1 1\n", "a.obj:4: vertex index 99 is out of range: there are 4"},
      {"f 1 2 2.5\n", "a.obj:4: vertex index '2.5' is not an integer"},
      {"f a b c\n", "a.obj:4: vertex index 'a' is not an integer"},
      {"f 1 2 /3\n", "a.obj:4: vertex index '' is not an integer"},
      {"vn 0 0 1\nf 1//x 2//1 3//1\n", "a.obj:5: normal index 'x' is not an integer"},
      {"vn 0 0\n", "a.obj:4: the line ends before the next normal"},
      {"vn 0 0 up\n", "a.obj:4: normal 'up' is not a number"},
      {"f 1/1/1/1 2 3\n", "a.obj:4: face corner '1/1/1/1' has more than three parts"},
      {"v 1 2\n", "a.obj:4: the line ends before the next coordinate"},
      {"v 1 2 x\n", "a.obj:4: coordinate 'x' is not a number"},
      {"v 1 2 3 red green blue\n", "a.obj:4: colour 'red' is not a number"},
      {"vt\n", "a.obj:4: the line ends before the next texture coordinate"},
      {"v 0 0 inf\nf 1 2 4\n", "a.obj: vertex 3, counted from 0, is not finite"},
      {std::string("\0", 1), "a.obj: not a text file"},
  }));
  CAPTURE(rest);
  CHECK(complaint("a.obj", points + rest) == message);
}

TEST_CASE("OBJ files come in variants", "[mesh_io]") {
  CHECK(read("a.obj", "# nothing").triangles.empty());
  CHECK(read("a.obj", "f 1 2 3\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n").points == its_points);
  CHECK(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nl 1 2\ng x\nusemtl y\ncurv 0 1\n")
            .triangles == one_triangle);
  CHECK(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n2\\\n\\\n 3").triangles == one_triangle);
  CHECK(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\").triangles == one_triangle);
}

TEST_CASE("An OBJ file's texture coordinates and normals are those of corners", "[mesh_io]") {
  // 4---3   the texture has a seam along 1-3, the normals have none
  // | / |
  // 1---2
  const IndexedMesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt .5 0\nvt .5 1\nvt .6\nvt .9 1\n"
                    "vn 0 0 1\nvn 0 .6 .8\nf 1/1/1 2/2/1 3/3/2\nf 1/4/1 3/5/2 4/5/2\n");
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.texture_coordinates.empty());
  CHECK(mesh.corner_textures.values ==
        std::vector<std::array<double, 2>>{{0, 0}, {.5, 0}, {.5, 1}, {.6, 0}, {.9, 1}});
  CHECK(mesh.corner_textures.triples == std::vector<Triangle>{{0, 1, 2}, {3, 4, 4}});
  CHECK(mesh.corner_normals.values == std::vector<std::array<double, 3>>{{0, 0, 1}, {0, .6, .8}});
  CHECK(mesh.corner_normals.triples == std::vector<Triangle>{{0, 0, 1}, {0, 1, 1}});
  CHECK(mesh.losses.empty());
}

TEST_CASE("An OBJ file with all there is reads back as it was written", "[mesh_io]") {
  const std::string content =
      "# 5 vertices, 5 faces\nmtllib a b.mtl c.mtl\nmtllib d.mtl\nv 0.1 0 0 0.5 0.25 1\n"
      "v 1 0 0 1 1 1\nv 1 1 0 0 0 0\nv 0 1 0 1 0 0\nv 0 0 1e-310 0 1 0\n"
      "vt 0.1 -3\nvt 0.3333333333333333 1e-310\nvt 5 7\nvn 0 0 1\nvn 0.1 0.2 0.3\n"
      "f 1 2 3\no an object\ng first second\nusemtl Material #25\ns 1\nf 1/1/1 2/2/2 3/3/1\n"
      "usemtl\ns off\nf 1/1 3/2 4/1\ng\nf 1//2 4//1 5//2\no\ng first second\n"
      "usemtl Material #25\nf 5/1/1 4/3/2 3/2/1\n";
  const Folder folder;
  const IndexedMesh mesh = read_mesh(folder.file("a.obj", content));
  CHECK(mesh.losses.empty());
  CHECK(mesh.remarks.empty());
  CHECK(mesh.parts.libraries == std::vector<std::string>{"a b.mtl c.mtl", "d.mtl"});
  const FaceParts& parts = mesh.parts;
  CHECK(parts.names[parts.of(1).object] == "an object");
  CHECK(parts.names[parts.of(1).group] == "first second");
  CHECK(parts.names[parts.of(1).material] == "Material #25");
  CHECK(parts.names[parts.of(1).smoothing] == "1");
  write_mesh(folder.path("b.obj"), mesh);
  CHECK(content_of(folder.path("b.obj")) == content);
}

TEST_CASE("Faces that name texture coordinates or normals that are not there do without",
          "[mesh_io]") {
  const IndexedMesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"
                    "f 2/2/1 4/1/1 3/1/1\nf 2/-3 4/1 1/1\nf 1//0 2//1 4//1\nf 1//9 2//9 4//9\n");
  CHECK(mesh.triangles.size() == 5);
  CHECK(mesh.remarks ==
        std::vector<std::string>{
            "faces with texture coordinate indices that are out of range, read without them: 2",
            "faces with normal indices that are out of range, read without them: 2"});
  const auto has = [&](std::size_t face, bool FacePart::*what) {
    return mesh.parts.of(face).*what;
  };
  CHECK(has(0, &FacePart::has_textures));
  CHECK(!has(1, &FacePart::has_textures));
  CHECK(has(1, &FacePart::has_normals));
  CHECK(!has(2, &FacePart::has_textures));
  CHECK(!has(3, &FacePart::has_normals));
  CHECK(!has(4, &FacePart::has_normals));
}

TEST_CASE("Names in OBJ files may hold blanks and #, and end before a comment", "[mesh_io]") {
  const auto name_of = [](const std::string& line) {
    const FaceParts parts = read("a.obj", line + "\n" + obj_triangle).parts;
    return parts.names[parts.of(0).material];
  };
  CHECK(name_of("usemtl red") == "red");
  CHECK(name_of("usemtl \t dark  red \t ") == "dark  red");
  CHECK(name_of("usemtl red # not blue") == "red");
  CHECK(name_of("usemtl red #") == "red");
  CHECK(name_of("usemtl # red") == "");
  CHECK(name_of("usemtl #1") == "#1");
  CHECK(name_of("usemtl Material #25 # red") == "Material #25");
  CHECK(name_of("usemtl a#b\r") == "a#b");
  CHECK(name_of("usemtl a# b#") == "a# b#");
}

TEST_CASE("Parts that differ by their smoothing groups only are one region", "[mesh_io]") {
  const std::string f = "f 1 2 3\n";
  const FaceParts parts =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\n" + f + "s 1\n" + f + "g b\n" + f +
                        "usemtl c\n" + f + "g\ns 0\nusemtl a\n" + f + "o d\n" + f)
          .parts;
  CHECK(parts.of_faces == std::vector<std::uint32_t>{0, 1, 2, 3, 0, 4});
  CHECK(parts.regions() == std::vector<std::uint32_t>{0, 0, 1, 2, 3});
}

TEST_CASE("Faces without texture coordinates are written without them", "[mesh_io]") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 9 9\nvt 1 0\nvn 0 0 1\n";
  const IndexedMesh mesh = read("a.obj", points + "f 1/2/1 2/1/1 3/1/1\nf 1 3 4\nf 4/1 3/1 2\n");
  CHECK(mesh.losses.text() == "texture coordinates of faces that have them only at some corners");
  CHECK(mesh.corner_textures.triples == std::vector<Triangle>{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  CHECK(encode_obj(mesh).ends_with("f 1/2/1 2/1/1 3/1/1\nf 1 3 4\nf 4 3 2\n"));
  CHECK(mesh.parts.of_faces == std::vector<std::uint32_t>{0, 1, 1});
  CHECK(mesh.parts.regions() == std::vector<std::uint32_t>{0, 1});

  const IndexedMesh unused = read("a.obj", points + "f 1 2 3\n");
  CHECK(unused.corner_textures.values.empty());
  CHECK(unused.corner_normals.values.empty());
}

TEST_CASE("Corners keep what they have where polygons are cut and triangles left out",
          "[mesh_io]") {
  // Each corner of a point has the texture coordinate and the normal of its number.
  std::string content = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\n";
  for (int i = 0; i < 5; ++i)
    content += "vt 0 " + std::to_string(i) + "\nvn 0 1 " + std::to_string(i) + "\n";
  const auto face = [](const std::vector<int>& corners) {
    std::string line = "f";
    for (const int c : corners)
      line += " " + std::to_string(c) + "/" + std::to_string(c) + "/" + std::to_string(c);
    return line + "\n";
  };
  const IndexedMesh mesh =
      read("a.obj", content + "usemtl a\n" + face({1, 2, 3, 4, 5}) + "usemtl b\n" +
                        face({1, 1, 2}) + face({1, 2, 1, 2}) + "usemtl c\n" + face({1, 2, 3, 5}) +
                        face({1, 2, 2, 3, 1}) + face({2, 3, 2, 3, 5, 3}));
  CHECK(mesh.remarks.size() == 3); // faces of too few corners, a fan, triangles of two equal ones
  CHECK(mesh.corner_textures.triples == mesh.triangles);
  CHECK(mesh.corner_normals.triples == mesh.triangles);
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    ++count[mesh.parts.names[mesh.parts.of(i).material]];
  CHECK(mesh.parts.of_faces.size() == mesh.triangles.size());
  CHECK(count["a"] == 3);
  CHECK(count["b"] == 0);
  CHECK(count["c"] == mesh.triangles.size() - 3);
}

TEST_CASE("Vertices that only normals or texture coordinates at corners tell apart are one",
          "[mesh_io]") {
  // A roof of two slopes; the ridge has vertices of its own for each.
  const IndexedMesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 0 1 1\nv 1 1 1\nv 1 2 0\nv 0 2 0\n"
                    "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n"
                    "f 5/2/2 6/2/2 7/2/2\nf 5/2/2 7/2/2 8/2/2\n");
  CHECK(mesh.points.size() == 6);
  CHECK(mesh.corner_normals.triples[0] == Triangle{0, 0, 0});
  CHECK(mesh.corner_normals.triples[2] == Triangle{1, 1, 1});
  CHECK(mesh.corner_textures.triples == mesh.corner_normals.triples);
  CHECK(mesh.remarks ==
        std::vector<std::string>{"vertices merged with another one at the same place: 2"});
  CHECK(mesh.losses.empty());
}

TEST_CASE("Texture coordinates and normals of corners that are no numbers are replaced",
          "[mesh_io]") {
  const IndexedMesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan 1\nvt 1 inf\nvt 1 2\nvn 0 nan 0\nvn 2 0 0\n"
                    "f 1/1/1 2/2/2 3/3/2\n");
  CHECK(mesh.corner_textures.values == std::vector<std::array<double, 2>>{{0, 0}, {0, 0}, {1, 2}});
  CHECK(mesh.corner_normals.values == std::vector<std::array<double, 3>>{{0, 0, 1}, {2, 0, 0}});
  CHECK(mesh.remarks ==
        std::vector<std::string>{"texture coordinates that are not finite, replaced by 0: 2",
                                 "normals that are not finite, replaced by (0, 0, 1): 1"});
}

TEST_CASE("OFF gets a vertex for each side of a seam of the texture", "[mesh_io]") {
  // 4---3---5   a seam along 1-3; the texture is the same on both sides of 2-3, though written
  // twice; | / | /     1, 4 and 6 have a face without texture coordinates 1---2
  const IndexedMesh mesh = read(
      "a.obj",
      "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 0\nv 2 1 0 0 1 1\nv -1 0 0 1 1 1\n"
      "vt 0 0\nvt .5 0\nvt .5 1\nvt .6\nvt .9 1\nvt .5 0\nvt 1 1\nf 1/1 2/2 3/3\n"
      "f 1/4 3/5 4/5\nf 2/6 5/7 3/3\nf 1 4 6\n");
  const Folder folder;
  write_mesh(folder.path("a.off"), mesh);
  const IndexedMesh again = read_mesh(folder.path("a.off"));
  CHECK(again.triangles == mesh.triangles); // joined again
  CHECK(again.value_triangles == std::vector<Triangle>{{0, 1, 2}, {6, 7, 3}, {1, 4, 2}, {0, 3, 5}});
  CHECK(points_of_values(again)[6] == mesh.points[0]);
  CHECK(points_of_values(again)[7] == mesh.points[2]);
  CHECK(bytes_of(again)[7] == bytes_of(mesh)[2]);
  CHECK(again.texture_coordinates ==
        std::vector<std::array<double, 2>>{
            {0, 0}, {.5, 0}, {.5, 1}, {.9, 1}, {1, 1}, {0, 0}, {.6, 0}, {.9, 1}});

  write_mesh(folder.path("a.ply"), mesh);
  const IndexedMesh of_ply = read_mesh(folder.path("a.ply"));
  CHECK(of_ply.triangles == mesh.triangles);
  CHECK(of_ply.parts.of_faces == mesh.parts.of_faces);
  for (std::size_t face = 0; face < 3; ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [s, t] = mesh.corner_textures.values[mesh.corner_textures.triples[face][i]];
      CHECK(of_ply.corner_textures.values[of_ply.corner_textures.triples[face][i]] ==
            std::array<double, 2>{static_cast<float>(s), static_cast<float>(t)});
    }
  write_mesh(folder.path("a.stl"), mesh);
  CHECK(read_mesh(folder.path("a.stl")).points.size() == 6);
}

TEST_CASE("What a format does not hold of corners and parts is told and left out", "[mesh_io]") {
  const std::string content =
      "mtllib a.mtl\nusemtl b\ng c\no d\ns 1\nvt 0 0\nvt 0 1\nvt 1 1\nvn 0 0 1\n"
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/2/1 3/3/1\nusemtl e\nf 1/2/1 3/3/1 2/1/1\n";
  const IndexedMesh mesh = read("a.obj", content);
  const auto fitted = [&](const std::string& name) {
    IndexedMesh result = mesh;
    fit_to_format(result, mesh_format(name));
    return result;
  };
  CHECK(fitted("a.obj").losses.empty());
  CHECK(encode_obj(fitted("a.obj")) == encode_obj(mesh));
  const std::string parts =
      "material libraries (mtllib), materials (usemtl), objects, groups, smoothing groups";
  CHECK(fitted("a.ply").losses.text() == parts);
  CHECK(fitted("a.off").losses.text() == "normals, " + parts);
  CHECK(fitted("a.stl").losses.text() == "texture coordinates, normals, " + parts);
  CHECK(!fitted("a.ply").corner_normals.empty());
  CHECK(fitted("a.off").corner_normals.empty());
  CHECK(!fitted("a.ply").corner_textures.empty());
  CHECK(mesh.parts.differ());
  CHECK(!fitted("a.ply").parts.differ());
  CHECK(fitted("a.ply").parts.of(0).has_normals);
  CHECK(!fitted("a.off").parts.of(0).has_normals);
}

TEST_CASE("PLY faces may hold the texture coordinates of their corners", "[mesh_io]") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar float texcoord\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const IndexedMesh mesh = read("a.ply", header + "0 3 2 1 3\n6 0 0 .5 0 0 .5 3 0 1 2\n"
                                                  "6 .5 0 1 1 0 .9 3 1 3 2\n");
  CHECK(mesh.texture_coordinates.empty());
  CHECK(mesh.losses.empty());
  CHECK(mesh.corner_textures.values ==
        std::vector<std::array<double, 2>>{{0, 0}, {.5, 0}, {0, .5}, {.5, 0}, {1, 1}, {0, .9}});
  CHECK(mesh.corner_textures.triples == std::vector<Triangle>{{0, 0, 0}, {0, 1, 2}, {3, 4, 5}});
  CHECK(encode_obj(mesh).ends_with("vt 0 0\nvt 0.5 0\nvt 0 0.5\nvt 0.5 0\nvt 1 1\nvt 0 0.9\n"
                                   "f 3 2 4\nf 1/1 2/2 3/3\nf 2/4 4/5 3/6\n"));
  CHECK(read("a.ply", header + "0 3 2 1 3\n0 3 0 1 2\n0 3 1 3 2\n").corner_textures.empty());
  for (const std::string list : {"2 1 1", "5 0 0 0 0 0", "7 0 0 0 0 0 0 0", "8 0 0 0 0 0 0 0 0"})
    CHECK(complaint("a.ply", header + "0 3 2 1 3\n" + list + " 3 0 1 2\n0 3 1 3 2\n") ==
          "a.ply:16: a list of " + list.substr(0, 1) + " texture coordinates for 3 corners");
}

namespace {

/// A PLY file with all there is, in the order in which it is written: two triangles, of which one
/// has no texture coordinates.
std::string ply_of_everything(const std::string& format, std::endian order) {
  const auto all = [order](auto... values) { return (bytes(values, order) + ...); };
  std::string content =
      "ply\nformat " + format +
      " 1.0\ncomment TextureFile a#1.png\ncomment TextureFile b.png\nelement vertex 4\n"
      "property double x\nproperty double y\nproperty double z\nproperty float nx\n"
      "property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty float quality\nproperty double heat\nproperty int label\n"
      "property char c\nproperty short d\nproperty ushort e\nproperty uint f\nelement face 2\n"
      "property list uchar uint vertex_indices\nproperty list uchar double texcoord\n"
      "property int texnumber\nproperty uchar red\nproperty float area\nend_header\n";
  for (int i = 0; i < 4; ++i) {
    content += all(double(i % 2), double(i / 2), 1e-310 * i, 0.6F, 0.F, 0.8F);
    content += all(std::uint8_t(250 + i), std::uint8_t{7}, std::uint8_t{9});
    content += all(0.1F + float(i), i == 2 ? std::nan("") : 1. / 3, std::int32_t{-1 - i});
    content += all(std::int8_t{-128}, std::int16_t{-32768}, std::uint16_t{65535}, ~0U);
  }
  content += all(std::uint8_t{3}, 0U, 1U, 2U, std::uint8_t{6}, 0., .1, .2, .3, 1e-310, 3.);
  content += all(-7, std::uint8_t{255}, 0.25F);
  content += all(std::uint8_t{3}, 1U, 3U, 2U, std::uint8_t{0}, 8, std::uint8_t{1}, 0.75F);
  return content;
}

} // namespace

TEST_CASE("A PLY file with all there is reads back as it was written", "[mesh_io]") {
  const std::string content = ply_of_everything("binary_little_endian", std::endian::little);
  const Folder folder;
  for (const std::string& variant :
       {content, ply_of_everything("binary_big_endian", std::endian::big)}) {
    const IndexedMesh mesh = read_mesh(folder.file("a.ply", variant));
    CHECK(mesh.losses.empty());
    CHECK(mesh.remarks.empty());
    CHECK(mesh.texture_comments.size() == 2);
    CHECK(mesh.vertex_numbers.size() == 7);
    CHECK(mesh.face_numbers.size() == 3);
    write_mesh(folder.path("b.ply"), mesh);
    CHECK(content_of(folder.path("b.ply")) == content);
  }
  for (std::size_t size = 0; size < content.size(); ++size) {
    CAPTURE(size);
    CHECK_THROWS_AS(read_mesh(folder.file("c.ply", content.substr(0, size))), std::runtime_error);
  }
}

TEST_CASE("Properties of PLY are told where a format does not hold them", "[mesh_io]") {
  const std::string content = ply_of_everything("binary_little_endian", std::endian::little);
  const auto fitted = [&](const std::string& name) {
    IndexedMesh mesh = read("a.ply", content);
    fit_to_format(mesh, mesh_format(name));
    CHECK((mesh.vertex_numbers.empty() && mesh.face_numbers.empty()));
    CHECK(mesh.texture_comments.empty());
    return mesh.losses.text();
  };
  const std::string numbers =
      "comment 'TextureFile a#1.png', comment 'TextureFile b.png', vertex property 'quality', "
      "vertex property 'heat', vertex property 'label', vertex property 'c', vertex property 'd', "
      "vertex property 'e', vertex property 'f', face property 'texnumber', face property 'red', "
      "face property 'area'";
  CHECK(fitted("a.obj") == numbers);
  CHECK(fitted("a.off") == numbers + ", normals");
  CHECK(fitted("a.stl") == numbers + ", colours, texture coordinates, normals");
  CHECK(fitted("a.ts") == numbers + ", colours, texture coordinates, normals");
}

TEST_CASE("PLY vertices are split where the normals of corners differ", "[mesh_io]") {
  // A roof of two slopes, of which the ridge has two normals and the eaves have none of their own.
  const IndexedMesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 1 2 0\nv 0 2 0\nvn 0 0 1\nvn 0 1 0\n"
                    "vt 0 0\nvt 1 0\nvt 1 1\n"
                    "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/1/1\nf 4/1/2 3/3/2 5/2/2\nf 4 5 6\n");
  const Folder folder;
  write_mesh(folder.path("a.ply"), mesh);
  const std::string content = content_of(folder.path("a.ply"));
  CHECK(content.find("element vertex 8\n") != std::string::npos);
  CHECK(content.find("property float nx\n") != std::string::npos);
  const IndexedMesh again = read_mesh(folder.path("a.ply"));
  CHECK(again.points.size() == 6);
  CHECK(again.corner_textures.triples.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto normal = [&](std::size_t face) {
      return again.corner_normals.values[again.corner_normals.triples[face][i]];
    };
    CHECK(normal(1) == std::array<double, 3>{0, 0, 1});
    CHECK(normal(2) == std::array<double, 3>{0, 1, 0});
  }
}

TEST_CASE("Where vertices of PLY differ by a property is a seam", "[mesh_io]") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property float w\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1 0\n1 0 0 0 0 1 nan\n0 1 0 0 0 1 0\n1 0 0 0 1 0 nan\n1 1 0 0 0 1 0\n";
  const std::string faces = "3 0 1 2\n3 3 4 5\n";
  CHECK(read("a.ply", header + "0 1 0 0 1 0 0\n" + faces).points.size() == 4);
  const IndexedMesh mesh = read("a.ply", header + "0 1 0 0 1 0 3\n" + faces);
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.vertex_numbers[0].values.size() == 5);
  CHECK(mesh.vertex_numbers[0].values.back() == 3);
  CHECK(mesh.value_triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 4}});
}

TEST_CASE("Properties of PLY are kept with the faces and vertices that are", "[mesh_io]") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\n"
      "element face 3\nproperty uchar label\nproperty list uchar int vertex_indices\n"
      "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar id\nend_header\n4 1 2 4 5\n";
  const IndexedMesh mesh = read("a.ply", header + "7 4 1 2 5 4\n8 3 1 1 2\n300 3 2 1 4\n"
                                                  "nan 0 0 50\n0 0 0 51\n1 0 0 52\n"
                                                  "0 inf 0 53\n0 1 0 54\n1 1 0 -1\n");
  REQUIRE(mesh.face_numbers.size() == 1);
  CHECK(mesh.face_numbers[0].values == std::vector<double>{0, 0, 7, 7, 255});
  CHECK(mesh.vertex_numbers[0].values == std::vector<double>{51, 52, 54, 0});
  CHECK(mesh.remarks[0] == "integers out of the range of their type, clamped: 2");
}

TEST_CASE("No name is written twice to PLY", "[mesh_io]") {
  const auto header_of = [](const std::string& properties, const std::string& faces) {
    std::string row = "0 0 0";
    for (std::size_t at = 0; (at = properties.find('\n', at)) != std::string::npos; ++at)
      row += " 1";
    const IndexedMesh mesh = read(
        "a.ply", ply("ascii", row + "\n1" + row.substr(1) + "\n0 1" + row.substr(3) + "\n" + faces,
                     "int", "uchar", properties));
    const std::string content = encode_ply(mesh);
    return mesh.losses.text() +
           content.substr(content.find("z\n") + 2,
                          content.find("element face") - content.find("z\n") - 2);
  };
  const std::string face = "3 0 1 2\n";
  CHECK(header_of("property float u\nproperty float v\nproperty float s\nproperty float t\n",
                  face) == "vertex property 's', vertex property 't'property double s\n"
                           "property double t\n");
  CHECK(header_of("property uchar r\nproperty uchar g\nproperty uchar b\nproperty uchar red\n",
                  face) == "vertex property 'red'property uchar red\nproperty uchar green\n"
                           "property uchar blue\n");
  CHECK(header_of("property uchar red\nproperty float nx\nproperty float u\n", face) ==
        "property uchar red\nproperty float nx\nproperty float u\n");
}

TEST_CASE("Broken PLY headers are refused with their place", "[mesh_io]") {
  const std::string start = "ply\nformat ascii 1.0\n";
  const auto [content, message] = GENERATE_COPY(table<std::string, std::string>({
      {"pla\n", "a.ply:1: not a PLY file: its first line is not 'ply'"},
      {"ply\nelement vertex 3\n", "a.ply:2: the line that names the format is missing"},
      {"ply\nformat ebcdic 1.0\n", "a.ply:2: unknown format 'ebcdic'"},
      {start, "a.ply:2: the file ends inside the header"},
      {start + "elephant vertex 3\n", "a.ply:3: unknown keyword 'elephant' in the header"},
      {start + "element vertex\n", "a.ply:3: the line ends before the next element count"},
      {start + "element vertex -3\n", "a.ply:3: element count -3 is negative"},
      {start + "element vertex 3\nelement vertex 3\n",
       "a.ply:4: element 'vertex' is declared twice"},
      {start + "property float x\n", "a.ply:3: a property without an element"},
      {start + "element vertex 3\nelement vertices 3\nend_header\n",
       "a.ply: the header declares vertices under two names"},
      {start + "element vertex 3\nelement face 3\nelement faces 3\nend_header\n",
       "a.ply: the header declares faces under two names"},
      {start + "element vertex 3\nproperty quad x\n", "a.ply:4: unknown type 'quad'"},
      {start + "element vertex 3\nproperty float\n", "a.ply:4: a property without a name"},
      {start + "element vertex 3\nproperty list float int x\n",
       "a.ply:4: the count of a list does not have an integer type"},
      {start + "element vertex 3\nproperty float x\nproperty float x\n",
       "a.ply:5: property 'x' is declared twice"},
      {start + "end_header\n", "a.ply: the header declares no element 'vertex'"},
      {start + "element vertex 1\nproperty float x\nend_header\n0\n",
       "a.ply: the vertices have no x, y and z"},
      {start + "element vertex 4000000000\nproperty float x\nend_header\n0\n",
       "a.ply: the file is too short for 4000000000 items of element 'vertex'"},
      {start + "element vertex 5000000000\nproperty float x\nend_header\n0\n",
       "a.ply: 5000000000 vertices do not fit into 32-bit indices"},
      {start + "element vertex 0\nelement face 1\nproperty list uchar float vertex_indices\n"
               "end_header\n0\n",
       "a.ply: element 'face' has no list of integers 'vertex_indices'"},
      {start + "element vertex 0\nelement face 1\nproperty int vertex_indices\nend_header\n0\n",
       "a.ply: element 'face' has no list of integers 'vertex_indices'"},
  }));
  CAPTURE(content);
  CHECK(complaint("a.ply", content) == message);
}

TEST_CASE("A PLY header of endless names is refused", "[mesh_io]") {
  std::string elements = "ply\nformat ascii 1.0\n", properties = elements + "element vertex 0\n";
  for (int i = 0; i < 1001; ++i) {
    elements += "element e" + std::to_string(i) + " 0\n";
    properties += "property float p" + std::to_string(i) + "\n";
  }
  CHECK(complaint("a.ply", elements) == "a.ply:1003: more than 1000 elements");
  CHECK(complaint("a.ply", properties) == "a.ply:1004: more than 1000 properties");
}

TEST_CASE("Broken text PLY files are refused with their place", "[mesh_io]") {
  const auto [body, message] = GENERATE(table<std::string, std::string>({
      {"0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "a.ply:12: the line ends before the next value"},
      {"0 0 0\n1 0 0\n0 1 0 0\n3 0 1 2\n",
       "a.ply:12: the line has more values than the header declares"},
      {"0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n", "a.ply:12: value 'x' is not a number"},
      {"0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", "a.ply: vertex 2, counted from 0, is not finite"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a.ply:13: the line ends before the next value"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.ply:13: vertex index 3 is out of range: there are 3"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.ply:13: vertex index -1 is out of range: there are 3"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", "a.ply:13: value '1.5' is not an integer"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 inf\n", "a.ply:13: value 'inf' is not an integer"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 3.0\n", "a.ply:13: vertex index 3 is out of range: there are 3"},
      {"0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "a.ply:13: a list of -3 values"},
      {"0 0 0\n1 0 0\n0 1 0\n3000000000 0 1 2\n", "a.ply:13: the line ends before the next value"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n",
       "a.ply:14: the file goes on after the last element"},
      {"0 0 0\n1 0 0\n0 1 0\n\n",
       "a.ply:13: the file ends before face 0 of 1 (counted from 0)"},
      {"0 0 0\n1 0 0\n\n", "a.ply: the file is too short for 3 items of element 'vertex'"},
      {"0 0 0\n1 0 0\n             \n\n",
       "a.ply:13: the file ends before vertex 2 of 3 (counted from 0)"},
  }));
  CAPTURE(body);
  CHECK(complaint("a.ply", ply("ascii", body)) == message);
}

TEST_CASE("Broken binary PLY files are refused with their place", "[mesh_io]") {
  const std::string face = bytes(std::uint8_t{3}) + bytes(0) + bytes(1) + bytes(2);
  const auto check = [](const std::string& body, const std::string& message,
                        const std::string& index = "int", const std::string& count = "uchar") {
    CHECK(complaint("a.ply", ply("binary_little_endian", body, index, count)) ==
          "a.ply: " + message);
  };
  check(float_points().substr(1), "the file is too short for 3 items of element 'vertex'");
  check(float_points(), "the file is too short for 1 items of element 'face'");
  for (std::size_t cut = 1; cut < face.size(); ++cut)
    check(float_points() + face.substr(0, cut),
          "the file ends before face 0 of 1 (counted from 0)");
  check(float_points() + face + "x", "the file goes on after the last element");
  check(float_points() + bytes(std::uint8_t{3}) + bytes(0) + bytes(1) + bytes(-1),
        "face 0: vertex index -1 is out of range: there are 3");
  check(float_points() + bytes(std::uint8_t{3}) + bytes(0) + bytes(1) + bytes(~0U),
        "face 0: vertex index 4294967295 is out of range: there are 3", "uint");
  check(float_points() + bytes(-3) + bytes(0) + bytes(1) + bytes(2), "face 0: a list of -3 values",
        "int", "int");
  check(float_points() + bytes(~0U) + bytes(0) + bytes(1) + bytes(2),
        "the file ends before face 0 of 1 (counted from 0)", "int", "uint");
  const std::string nan = bytes(std::nanf(""));
  check(float_points().replace(12, 4, nan) + face, "vertex 1, counted from 0, is not finite");
}

TEST_CASE("PLY files come in every type and byte order", "[mesh_io]") {
  const std::endian big = std::endian::big;
  CHECK(read("a.ply", ply("binary_big_endian", float_points(big) + bytes(std::uint8_t{3}) +
                                                   bytes(0, big) + bytes(1, big) + bytes(2, big)))
            .points == its_points);
  const auto triangle_of = [](auto zero, const std::string& type) {
    using Index = decltype(zero);
    const std::string face = bytes(Index{3}) + bytes(Index{0}) + bytes(Index{1}) + bytes(Index{2});
    return read("a.ply", ply("binary_little_endian", float_points() + face, type, type)).triangles;
  };
  CHECK(triangle_of(std::int8_t{}, "char") == one_triangle);
  CHECK(triangle_of(std::uint8_t{}, "uint8") == one_triangle);
  CHECK(triangle_of(std::int16_t{}, "int16") == one_triangle);
  CHECK(triangle_of(std::uint16_t{}, "ushort") == one_triangle);
  CHECK(triangle_of(std::int32_t{}, "int32") == one_triangle);
  CHECK(triangle_of(std::uint32_t{}, "uint") == one_triangle);
}

TEST_CASE("PLY elements and properties may come in any order, with others between", "[mesh_io]") {
  const std::string header =
      "ply\nformat ascii 1.0\ncomment c\nobj_info o\nelement nothing 4000000000\nelement face 1\n"
      "property uchar flags\nproperty list uchar int vertex_index\nelement camera 1\n"
      "property list uint float w\nelement vertex 3\nproperty double z\nproperty list uchar int l\n"
      "property double y\nproperty double x\nend_header\n";
  const IndexedMesh mesh =
      read("a.ply", header + "9 3 0 1 2\n2 7 7\n0 0 0 0\n0 2 7 7 0 1\n0 0 1 0\n");
  CHECK(mesh.points == its_points);
  CHECK(mesh.triangles == one_triangle);
}

TEST_CASE("A PLY file may hold triangle strips", "[mesh_io]") {
  // 1---3   5     every second triangle of a strip is turned over
  // | \ |  / \    .
  // 0---2  4-6
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\n"
      "property list int int vertex_indices\nend_header\n";
  const IndexedMesh mesh =
      read("a.ply", header + "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n3 1 0\n3 0 0\n"
                             "9 0 1 2 3 3 -1 4 5 6\n");
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}});
}

TEST_CASE("Colours are read in the units of each format", "[mesh_io]") {
  using CGAL::IO::Color;
  const std::vector<Color> expected = {{255, 0, 0}, {0, 255, 0, 128}, {51, 102, 153}};
  const auto ply_colors = [](const std::string& type, const std::string& body) {
    return bytes_of(
        read("a.ply", ply("ascii", body, "int", "uchar",
                          "property " + type + " red\nproperty " + type + " green\nproperty " +
                              type + " blue\nproperty " + type + " alpha\n")));
  };
  CHECK(
      ply_colors("uchar", "0 0 0 255 0 0 255\n1 0 0 0 255 0 128\n0 1 0 51 102 153 255\n3 0 1 2") ==
      expected);
  CHECK(ply_colors("float", "0 0 0 1 0 0 1\n1 0 0 0 1 0 .5\n0 1 0 .2 .4 .6 1\n3 0 1 2") ==
        expected);
  CHECK(
      ply_colors("float", "0 0 0 255 0 0 255\n1 0 0 0 255 0 128\n0 1 0 51 102 153 255\n3 0 1 2") ==
      expected);
  CHECK(ply_colors("ushort", "0 0 0 65535 0 0 65535\n1 0 0 0 65535 0 32896\n"
                             "0 1 0 13107 26214 39321 65535\n3 0 1 2") == expected);
  CHECK(bytes_of(read("a.off", "COFF 3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0 128\n0 1 0 51 102 153\n"
                               "3 0 1 2")) == expected);
  CHECK(bytes_of(read("a.off", "COFF 3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0 0.5\n0 1 0 .2 .4 .6\n"
                               "3 0 1 2")) == expected);
  CHECK(bytes_of(read("a.obj", "v 0 0 0\nv 1 0 0 0 1 0\nv 0 1 0 .2 .4 .6\nf 1 2 3")) ==
        std::vector<Color>{{255, 255, 255}, {0, 255, 0}, {51, 102, 153}});
}

TEST_CASE("Colours and texture coordinates that are no numbers are taken as 0", "[mesh_io]") {
  const IndexedMesh mesh =
      read("a.off", "STCOFF 3 1 0\n0 0 0 nan 0 inf 1 nan 1\n1 0 0 0.5 -1 0 1 1 1\n"
                    "0 1 0 0 0 0 1 1 -inf\n3 0 1 2");
  CHECK(bytes_of(mesh) == std::vector<CGAL::IO::Color>{{0, 0, 255}, {128, 0, 0}, {0, 0, 0}});
  CHECK(mesh.texture_coordinates == std::vector<std::array<double, 2>>{{0, 0}, {1, 1}, {0, 0}});
  CHECK(mesh.remarks ==
        std::vector<std::string>{"colour values that are not numbers, replaced by 0: 1",
                                 "texture coordinates that are not finite, replaced by 0: 2"});
}

TEST_CASE("OFF colours before texture coordinates may do without opacity", "[mesh_io]") {
  const IndexedMesh mesh = read(
      "a.off", "STCOFF 3 1 0\n0 0 0 1 2 3 .1 .2\n1 0 0 1 2 3 4 .1 .2\n0 1 0 1 2 3 .1 .2\n3 0 1 2");
  CHECK(bytes_of(mesh) == std::vector<CGAL::IO::Color>{{1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3}});
  CHECK(mesh.texture_coordinates ==
        std::vector<std::array<double, 2>>{{.1, .2}, {.1, .2}, {.1, .2}});
}

TEST_CASE("Broken STL files are refused with their place", "[mesh_io]") {
  CHECK(complaint("a.stl", "triangle") ==
        "a.stl: neither a text STL file nor long enough for a binary one");
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"solid\n", "a.stl:1: the file ends before 'endsolid'"},
      {"solid\nfacet\nvertex 0 0 0\nendfacet\n", "a.stl:4: a facet of 1 vertices"},
      {"solid\nfacet\nvertex 0 0\n", "a.stl:3: the line ends before the next coordinate"},
      {"solid\nfacet\nvertex 0 0 x\n", "a.stl:3: coordinate 'x' is not a number"},
      {"solid\nvertex 0 0 0\n", "a.stl:2: a vertex outside of a facet"},
      {"solid\nfacet\nfacet\n", "a.stl:3: 'facet' is out of place"},
      {"solid\nfacet\nendsolid\n", "a.stl:3: 'endsolid' is out of place"},
      {"solid\nendsolid\nfacet\n", "a.stl:3: 'facet' is out of place"},
      {"solid\nface\n", "a.stl:2: unknown keyword 'face'"},
  }));
  CAPTURE(text);
  CHECK(complaint("a.stl", text) == message);
}

TEST_CASE("The keywords of text STL files come in any spelling, on one line or on many",
          "[mesh_io]") {
  const std::string one_line = "solid m facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 "
                               "vertex 0 1 0 endloop endfacet endsolid m";
  const auto spelt = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
      text.replace(at, from.size(), to);
    return text;
  };
  const auto upper = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return text;
  };
  for (const std::string& text :
       {one_line, spelt(stl_triangle, "endloop", "end loop"),
        spelt(stl_triangle, "endfacet", "end facet"),
        spelt(stl_triangle, "endsolid", "end solid m"), spelt(one_line, "end", "end "),
        upper(spelt(stl_triangle, "end", "end ")), upper(one_line),
        spelt(stl_triangle, "solid\n", "solid a facet of the end # 1\n"),
        spelt(one_line, "0 0 1", "nan nan nan"), "solid m endsolid m " + one_line,
        "# a comment\n" + stl_triangle, spelt(stl_triangle, "endfacet", "endfacet // done"),
        spelt(stl_triangle, " normal 0 0 1", "")}) {
    CAPTURE(text);
    CHECK(read("a.stl", text).points == its_points);
    CHECK(read("a.stl", text).triangles == one_triangle);
  }
  CHECK(read("a.stl", one_line + " " + spelt(one_line, " m", " my solid part")).triangles.size() ==
        2);
}

TEST_CASE("Binary STL files are refused if their size does not fit", "[mesh_io]") {
  std::string facet = std::string(12, '\0') + float_points() + "  ";
  const auto file = [&](std::uint32_t count, const std::string& facets) {
    std::string header = "solid, for all that it is binary";
    header.resize(80, ' ');
    return header + bytes(count) + facets;
  };
  CHECK(read("a.stl", file(1, facet)).points == its_points);
  CHECK(read("a.stl", file(1, facet)).triangles == one_triangle);
  CHECK(read("a.stl", file(0, "")).triangles.empty());
  CHECK(read("a.stl", file(1, facet + "spare")).remarks ==
        std::vector<std::string>{"the bytes after the last facet are left out"});
  CHECK(complaint("a.stl", file(2, facet)) ==
        "a.stl: the file ends before facet 1 of 2 (counted from 0)");
  CHECK(complaint("a.stl", file(~0U, facet)) ==
        "a.stl: the file ends before facet 1 of 4294967295 (counted from 0)");
  CHECK(complaint("a.stl", file(1, facet + facet)) ==
        "a.stl: the file goes on after the last of 1 facets");
  CHECK(complaint("a.stl", file(1, facet.replace(12, 4, bytes(std::nanf(""))))) ==
        "a.stl: vertex 0, counted from 0, is not finite");
}

TEST_CASE("Broken GOCAD files are refused with their place", "[mesh_io]") {
  const std::string start = "GOCAD TSurf 1\nVRTX 1 0 0 0\n";
  const auto [content, message] = GENERATE_COPY(table<std::string, std::string>({
      {"GODOT\n", "a.ts:1: not a GOCAD file: its first word is not 'GOCAD'"},
      {start, "a.ts:2: the file ends before 'END'"},
      {start + "VRTX 1 0 0 0\n", "a.ts:3: vertex number 1 is defined twice"},
      {start + "VRTX 2 0 0\n", "a.ts:3: the line ends before the next coordinate"},
      {start + "VRTX two 0 0 0\n", "a.ts:3: vertex number 'two' is not an integer"},
      {start + "TRGL 1 1 4000000000\n", "a.ts:3: vertex number 4000000000 is not defined"},
      {start + "TRGL 1 1\n", "a.ts:3: the line ends before the next vertex number"},
      {start + "TFACE\nEND\nGOCAD TSurf 1\nTRGL 1 1 1\n", "a.ts:6: vertex number 1 is not defined"},
      {start + "END\n", "a.ts:3: 'END' before 'TFACE'"},
  }));
  CAPTURE(content);
  CHECK(complaint("a.ts", content) == message);
}

TEST_CASE("Vertices that no face uses may be broken", "[mesh_io]") {
  const IndexedMesh mesh =
      read("a.off", "OFF 5 1 0\n0 0 nan\n0 0 0\n1 0 0\ninf 0 0\n0 1 0\n3 1 2 4");
  CHECK(mesh.points == its_points);
  CHECK(mesh.triangles == one_triangle);
  CHECK(mesh.remarks ==
        std::vector<std::string>{"isolated vertices left out (not finite): 2"});
}

TEST_CASE("Faces without three different corners are left out", "[mesh_io]") {
  const IndexedMesh mesh = read(
      "a.off",
      "OFF 3 7 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0\n1 0\n2 0 1\n3 0 1 1\n5 0 0 1 2 0\n4 0 1 0 1");
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}});
  CHECK(mesh.remarks ==
        std::vector<std::string>{"faces left out (fewer than three different corners): 4",
                                 "triangles left out (two equal corners): 2"});
}

namespace {

/// Edges of one face, by their vertices.
std::size_t count_open(const IndexedMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> faces;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++faces[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second == 1; }));
}

/// An OFF file of parts, each of which has points and faces of its own.
std::string off_of(const std::vector<std::pair<std::vector<Point>, std::vector<Triangle>>>& parts) {
  std::ostringstream points, faces;
  std::size_t count = 0, face_count = 0;
  for (const auto& [own_points, own_faces] : parts) {
    for (const Point& p : own_points)
      points << p << '\n';
    for (const auto& [a, b, c] : own_faces)
      faces << "3 " << a + count << ' ' << b + count << ' ' << c + count << '\n';
    count += own_points.size();
    face_count += own_faces.size();
  }
  return "OFF " + std::to_string(count) + ' ' + std::to_string(face_count) + " 0\n" + points.str() +
         faces.str();
}

/// A closed tetrahedron above (or, mirrored, beside) the edge from (0, 0, 0) to (0, 0, 1), as one
/// part or as one for each face.
std::vector<std::pair<std::vector<Point>, std::vector<Triangle>>> tetrahedron(double side,
                                                                              bool is_loose) {
  const std::vector<Point> points = {{0, 0, 0}, {0, 0, 1}, {side, 1, 0.5}, {side, -1, 0.5}};
  std::vector<Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  if (side < 0)
    for (Triangle& face : faces)
      std::swap(face[1], face[2]);
  if (!is_loose)
    return {{points, faces}};
  std::vector<std::pair<std::vector<Point>, std::vector<Triangle>>> parts;
  for (const auto& [a, b, c] : faces)
    parts.push_back({{points[a], points[b], points[c]}, {{0, 1, 2}}});
  return parts;
}

} // namespace

TEST_CASE("What is one surface is joined, edge by edge", "[mesh_io]") {
  // Two triangles along an edge, each with points of its own.
  const std::string loose =
      "OFF 6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n-0. 1 0\n3 0 1 2\n3 3 4 5";
  const IndexedMesh welded = read("a.off", loose);
  CHECK(welded.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  CHECK(welded.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
  CHECK(welded.remarks ==
        std::vector<std::string>{"vertices merged with another one at the same place: 2"});

  // A third triangle shares the first point: the same, for what is elsewhere does not matter.
  const std::string connected =
      "OFF 7 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n3 0 1 2\n3 3 4 5\n3 0 6 1";
  CHECK(read("a.off", connected).points.size() == 5);
  CHECK(read("a.off", connected, Weld::places).points.size() == 5);

  // Faces that touch at a point only have one each, unless all places shall be one.
  const std::string touching =
      "OFF 6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 3 4 5";
  CHECK(read("a.off", touching).points.size() == 6);
  CHECK(read("a.off", touching, Weld::places).points.size() == 5);

  // Wound against each other they are one surface none the less, but not twice the same face.
  CHECK(read("a.off", off_of({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
                              {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 2, 1}}}}))
            .points.size() == 4);
  const std::vector<Point> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> halves = {{0, 1, 2}, {0, 2, 3}};
  CHECK(read("a.off", off_of({{square, halves}, {square, halves}})).points.size() == 8);

  const IndexedMesh collapsed =
      read("a.off", "OFF 3 1 0\n0 0 0\n0 0 0\n0 1 0\n3 0 1 2", Weld::places);
  CHECK(collapsed.triangles.empty());
}

TEST_CASE("A pole that each face has for itself is one point, whose neighbours are shared",
          "[mesh_io]") {
  // Two cones on one ring, as a sphere of few faces has them; each face has a tip of its own.
  std::vector<Point> points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  std::vector<Triangle> faces;
  for (const double z : {1., -1.})
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t j = (i + 1) % 4, tip = static_cast<std::uint32_t>(points.size());
      points.emplace_back(0, 0, z);
      faces.push_back(z > 0 ? Triangle{i, j, tip} : Triangle{j, i, tip});
    }
  const IndexedMesh mesh = read("a.off", off_of({{points, faces}}));
  CHECK(mesh.points.size() == 6);
  CHECK(count_open(mesh) == 0);
}

TEST_CASE("Bodies that touch along an edge stay two, and are closed", "[mesh_io]") {
  const bool is_loose = GENERATE(false, true), is_inside_out = GENERATE(false, true);
  auto parts = tetrahedron(1, is_loose);
  for (auto& part : tetrahedron(-1, is_loose))
    parts.push_back(std::move(part));
  for (auto& [points, faces] : parts)
    for (Triangle& face : faces)
      if (is_inside_out)
        std::swap(face[1], face[2]);
  const IndexedMesh mesh = read("a.off", off_of(parts));
  CHECK(mesh.points.size() == 8);
  CHECK(count_open(mesh) == 0);
}

TEST_CASE("Three sheets along an edge are joined, and a wall with the floor", "[mesh_io]") {
  std::vector<std::pair<std::vector<Point>, std::vector<Triangle>>> sheets;
  for (const Point& p : {Point(1, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0)})
    sheets.push_back({{{0, 0, 0}, {0, 0, 1}, p}, {{0, 1, 2}}});
  CHECK(read("a.off", off_of(sheets)).points.size() == 5);

  const std::vector<Point> floor = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  const std::vector<Triangle> two = {{0, 1, 2}, {1, 0, 3}};
  CHECK(read("a.off", off_of({{floor, two}, {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}}}))
            .points.size() == 5);
  // A decal on one of the faces does not become that face a second time.
  CHECK(read("a.off", off_of({{{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {-1, 1, 1}},
                               {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}}},
                              {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}}}}))
            .triangles.size() == 4);
}

TEST_CASE("The sides of a sheet have the same vertices", "[mesh_io]") {
  // A card of 3 x 3 squares: the points inside lie on no border of either side.
  std::vector<Point> points;
  std::vector<Triangle> front, back;
  for (std::uint32_t i = 0; i < 16; ++i)
    points.emplace_back(i % 4, i / 4, 0);
  for (std::uint32_t i = 0; i < 11; ++i)
    if (i % 4 != 3) {
      front.push_back({i, i + 1, i + 5});
      front.push_back({i, i + 5, i + 4});
      back.push_back({i, i + 5, i + 1});
      back.push_back({i, i + 4, i + 5});
    }
  const IndexedMesh card = read("a.off", off_of({{points, front}, {points, back}}));
  CHECK(card.points.size() == 16);
  CHECK(card.triangles.size() == 36);
}

TEST_CASE("Values that differ at one vertex are seams", "[mesh_io]") {
  const std::string content = "COFF 6 2 0\n0 0 0 1 0 0\n1 0 0 2 0 0\n0 1 0 3 0 0\n1 0 0 4 0 0\n"
                              "1 1 0 5 0 0\n0 1 0 3 0 0\n3 0 1 2\n3 3 4 5";
  for (const Weld weld : {Weld::surfaces, Weld::places}) {
    const IndexedMesh mesh = read("a.off", content, weld);
    CHECK(mesh.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    CHECK(bytes_of(mesh) ==
          std::vector<CGAL::IO::Color>{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}, {4, 0, 0}});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    CHECK(mesh.value_triangles == std::vector<Triangle>{{0, 1, 2}, {4, 3, 2}});
    CHECK(mesh.losses.empty());
    // Written, each side has a vertex again.
    const IndexedMesh written = with_vertices_of_values(mesh);
    CHECK(written.points.size() == 5);
    CHECK(written.points[4] == Point(1, 0, 0));
    CHECK(written.triangles == std::vector<Triangle>{{0, 1, 2}, {4, 3, 2}});
    CHECK(written.value_triangles.empty());
  }
}

TEST_CASE("The first of many vertices at one place is kept", "[mesh_io]") {
  std::string points, faces;
  for (int i = 0; i < 150; ++i) // more than a sort leaves in order by chance
    points += std::to_string(i % 3) + " 0 0 " + std::to_string(i) + " 0 0\n";
  for (int i = 0; i < 150; i += 3)
    faces +=
        "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  const IndexedMesh mesh = read("a.off", "COFF 150 50 0\n" + points + faces, Weld::places);
  const std::vector<CGAL::IO::Color> colors = bytes_of(mesh);
  REQUIRE(mesh.points.size() == 3);
  CHECK(std::vector(colors.begin(), colors.begin() + 3) ==
        std::vector<CGAL::IO::Color>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
}

TEST_CASE("Polygons that are not convex are cut without folds", "[mesh_io]") {
  // A flat polygon's triangles cover it once exactly if their areas add up to its own.
  SECTION("a star") {
    const std::size_t n = 16;
    std::string text = "OFF 16 1 0\n", face = "16";
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = static_cast<double>(i) * 3.14159265358979 / 8;
      const double radius = i % 2 == 0 ? 3 : 1;
      text += std::to_string(radius * std::cos(angle)) + " 0 " +
              std::to_string(radius * std::sin(angle)) + "\n";
      face += " " + std::to_string(i);
    }
    const IndexedMesh mesh = read("a.off", text + face);
    CHECK(mesh.triangles.size() == n - 2);
    CHECK(area(mesh) == Approx(8 * 3 * std::sin(3.14159265358979 / 8)).epsilon(1e-5));
    CHECK(mesh.remarks.empty());
  }
  SECTION("a quadrilateral") { // an arrow head, of which corner 0 is the notch or its opposite
    for (const std::string face : {"4 0 1 2 3", "4 1 2 3 0", "4 3 2 1 0", "4 2 1 0 3"}) {
      const IndexedMesh mesh = read("a.off", "OFF 4 1 0\n1 1 0\n0 4 0\n0 0 0\n4 0 0\n" + face);
      CHECK(area(mesh) == Approx(4));
    }
  }
  SECTION("at extreme sizes and places") {
    for (const std::string unit : {"1", "1e-310", "1e-200", "1e200"}) {
      const IndexedMesh mesh =
          read("a.off", "OFF 6 1 0\n0 0 0\n2" + unit.substr(1) + " 0 0\n2" + unit.substr(1) + " " +
                            unit + " 0\n" + unit + " " + unit + " 0\n" + unit + " 2" +
                            unit.substr(1) + " 0\n0 2" + unit.substr(1) + " 0\n6 0 1 2 3 4 5");
      CHECK(mesh.triangles.size() == 4);
      CHECK(mesh.remarks.empty());
    }
  }
}

TEST_CASE("The triangles of a polygon face the way it does", "[mesh_io]") {
  const std::string points = "OFF 5 1 0\n0 0 0\n2 0 0\n2 2 0\n1 .5 0\n0 2 0\n";
  for (const std::string face : {"5 0 1 2 3 4", "5 4 3 2 1 0"}) {
    const IndexedMesh mesh = read("a.off", points + face);
    CHECK(mesh.triangles.size() == 3);
    for (const auto& [a, b, c] : mesh.triangles) {
      const double z = CGAL::normal(mesh.points[a], mesh.points[b], mesh.points[c]).z();
      CHECK((z > 0) == (face == "5 0 1 2 3 4"));
    }
  }
}

TEST_CASE("Polygons that cross themselves or are flat are cut into fans", "[mesh_io]") {
  const IndexedMesh crossing =
      read("a.off", "OFF 5 1 0\n0 0 0\n2 2 0\n2 0 0\n0 2 0\n-1 1 0\n5 0 1 2 3 4");
  CHECK(crossing.triangles.size() == 3);
  CHECK(crossing.remarks == std::vector<std::string>{
                                "polygons cut into fans (without area, or crossing themselves): 1"});
  CHECK(
      read("a.off", "OFF 5 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n5 0 1 2 3 4").triangles.size() ==
      3);
}

TEST_CASE("What is written reads back the same", "[mesh_io]") {
  IndexedMesh mesh;
  mesh.points = {{0.1, -1e-310, 1. / 3}, {1e150, 0, -0.}, {123456789.123456789, 1, 1}, {0, 1, 2}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  const Folder folder;
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.ts"}) {
    CAPTURE(name);
    write_mesh(folder.path(name), mesh);
    const IndexedMesh again = read_mesh(folder.path(name));
    CHECK(again.points == mesh.points);
    CHECK(again.triangles == mesh.triangles);
    CHECK(again.colors.empty());
    CHECK(again.texture_coordinates.empty());
  }
  mesh.colors = {{255, 0, 0, 255}, {1, 2, 3, 255}, {0, 128, 255, 255}, {254, 253, 252, 255}};
  mesh.texture_coordinates = {{0, 0}, {.1, 1. / 3}, {1, 1}, {-1, 2}};
  for (const std::string name : {"a.off", "a.obj", "a.ply"}) {
    CAPTURE(name);
    write_mesh(folder.path(name), mesh);
    const IndexedMesh again = read_mesh(folder.path(name));
    CHECK(again.points == mesh.points);
    CHECK(again.triangles == mesh.triangles);
    CHECK(bytes_of(again) == bytes_of(mesh));
    CHECK(textures_of_vertices(again) == mesh.texture_coordinates);
    CHECK(again.color_type.has_alpha == false);
  }
  mesh.colors[0] = {255, 0, 0, 77};
  mesh.color_type.has_alpha = true;
  for (const std::string name : {"a.off", "a.obj", "a.ply"}) {
    CAPTURE(name);
    write_mesh(folder.path(name), mesh);
    CHECK(bytes_of(read_mesh(folder.path(name))) == bytes_of(mesh));
    CHECK(read_mesh(folder.path(name)).color_type.has_alpha);
  }
}

TEST_CASE("Colours of every type are written without loss where the format can", "[mesh_io]") {
  const std::string text = "0 0 0 0.1 0 1\n1 0 0 .9 1.0001 0\n0 1 0 .3 .3 .3\n3 0 1 2\n";
  const std::string rgb = " red\nproperty @ green\nproperty @ blue\n";
  const auto ply_of = [&](const std::string& type, const std::string& body) {
    std::string more = "property @" + rgb;
    for (std::size_t at = more.find('@'); at != std::string::npos; at = more.find('@'))
      more.replace(at, 1, type);
    return ply("ascii", body, "int", "uchar", more);
  };
  const Folder folder;
  const auto again = [&](const IndexedMesh& mesh, const std::string& name) {
    write_mesh(folder.path(name), mesh);
    return read_mesh(folder.path(name));
  };
  const IndexedMesh doubles = read("a.off", "COFF 3 1 0\n" + text);
  for (const std::string name : {"b.off", "b.obj", "b.ply"})
    CHECK(again(doubles, name).colors == doubles.colors);
  for (const std::string type : {"float", "double"}) {
    const IndexedMesh mesh = read("a.ply", ply_of(type, text));
    CHECK(mesh.colors[1][0] == (type == "float" ? double{.9F} : .9));
    CHECK(again(mesh, "b.ply").color_type.is_single == (type == "float"));
    CHECK(content_of(folder.path("b.ply")).find("property " + type + " red") != std::string::npos);
  }
  const std::string words = "0 0 0 65535 0 1\n1 0 0 2 3 4\n0 1 0 5 6 7\n3 0 1 2\n";
  const IndexedMesh deep = read("a.ply", ply_of("ushort", words));
  CHECK(again(deep, "b.ply").colors == deep.colors);
  CHECK(again(deep, "b.ply").color_type.full == 65535);
  CHECK(bytes_of(again(deep, "b.off")) == bytes_of(deep));
}

TEST_CASE("The unit of colours goes by their type, then by all of them", "[mesh_io]") {
  const auto [content, full, remark] = GENERATE(table<std::string, double, std::string>({
      // whole numbers in OFF
      {"0 0 0 200 1 1\n1 0 0 1 1 0\n0 1 0 0 0 0\n", 255, ""},
      {"0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n", 1,
       "colours that are all 0 or 1 are taken as fractions"},
      {"0 0 0 0 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n", 255, ""},
      {"0 0 0 1 0 0 255\n1 0 0 1 1 0 255\n0 1 0 0 1 1 255\n", 255, ""},
      // with decimal points
      {"0 0 0 1. 0 0\n1 0 0 0 1 0\n0 1 0 0 1 1\n", 1, ""},
      {"0 0 0 .5 .5 .5\n1 0 0 .9 .9 .9\n0 1 0 1.0001 .5 .5\n", 1,
       "colours are taken as fractions; values above 1, which are kept unchanged: 1"},
      {"0 0 0 3.5 .5 .5\n1 0 0 2.5 7 1.5\n0 1 0 1.0001 .5 .5\n", 1,
       "colours are taken as fractions; values above 1, which are kept unchanged: 5"},
      {"0 0 0 20.0 .5 .5\n1 0 0 .5 7 .5\n0 1 0 .1 .5 .5\n", 1,
       "colours are taken as fractions; values above 1, which are kept unchanged: 2"},
      {"0 0 0 255.0 0 0\n1 0 0 0 1 0.5\n0 1 0 12.5 128 3\n", 255,
       "colours are taken as 0 to 255, since most of their values are above 1"},
  }));
  CAPTURE(content);
  const IndexedMesh mesh = read("a.off", "COFF 3 1 0\n" + content + "3 0 1 2\n");
  CHECK(mesh.color_type.full == full);
  CHECK(mesh.remarks ==
        (remark.empty() ? std::vector<std::string>{} : std::vector<std::string>{remark}));
}

TEST_CASE("Whatever a file has besides is told", "[mesh_io]") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto losses = [](const std::string& name, const std::string& content) {
    return read(name, content).losses.text();
  };
  CHECK(losses("a.obj", points + "f 1 2 3") == "");
  CHECK(losses("a.obj", "mtllib a.mtl\no a\n" + points +
                            "vn 0 0 1\ng b\nusemtl c\ns 1\nusemtl d\nf 1//1 2//1 3//1\nl 1 2\n"
                            "p 1\ncurv 0 1\ns off\n") ==
        "lines, points, lines that begin with 'curv'");
  CHECK(losses("a.obj", points + "s off\nvt 0 0 0\nf 1 2 3") == "");
  CHECK(losses("a.obj", points + "v 1 1 1 .5\nvt 0 0 .5\nf 1 2 3") ==
        "extra numbers of vertices, third texture coordinates");
  CHECK(losses("a.off", "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 255 0 0") ==
        "normals, face colours");
  CHECK(losses("a.off", "OFF 3 1 0\n0 0 0 5\n1 0 0\n0 1 0\n3 0 1 2") ==
        "extra numbers of vertices");
  CHECK(
      losses(
          "a.ply",
          "ply\nformat ascii 1.0\ncomment made by hand, texture baked\ncomment TextureFile a.png\n"
          "obj_info skin.JPG\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nproperty float nx\nproperty float quality\nproperty uchar red\n"
          "property list uchar int l\nelement face 1\nproperty list uchar int vertex_indices\n"
          "property int texnumber\nproperty list uchar float color\n"
          "element edge 1\nproperty int vertex1\nelement none 0\nproperty int a\nend_header\n"
          "0 0 0 0 0 0 0\n1 0 0 0 0 0 0\n0 1 0 0 0 0 0\n3 0 1 2 0 0\n1\n") ==
      "vertex property 'l', face property 'color', element 'edge'");
  CHECK(losses("a.stl", stl_triangle + stl_triangle) == "solids");
  CHECK(losses("a.ts",
               "GOCAD TSurf 1\nHEADER {\nname:a\n*solid*color: red\n}\nTFACE\n"
               "PVRTX 1 0 0 0 7\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nBSTONE 1\nEND\n") ==
        "properties of vertices, lines that begin with 'BSTONE'");
  std::string many = points + "f 1 2 3\n";
  for (char c = 'a'; c <= 'z'; ++c)
    for (const char d : {'x', 'y'})
      many += std::string{c, d} + "\n";
  CHECK(read("a.obj", many).losses.text().ends_with(" and more"));
}

TEST_CASE("STL is written in single precision and refuses what that does not hold", "[mesh_io]") {
  IndexedMesh mesh;
  mesh.points = {{0.1F, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  const Folder folder;
  write_mesh(folder.path("a.stl"), mesh);
  CHECK(read_mesh(folder.path("a.stl")).points == mesh.points);
  CHECK(read_mesh(folder.path("a.stl")).triangles == mesh.triangles);

  mesh.points[0] = {1e-150, 0, 0};
  mesh.points[1] = {2e-150, 1e-150, 0};
  write_mesh(folder.path("a.stl"), mesh);
  const std::string tiny = content_of(folder.path("a.stl"));
  const IndexedMesh mesh_of_tiny = read_mesh(folder.path("a.stl")); // normals are finite too
  for (std::size_t offset = stl_header_size; offset < tiny.size(); offset += stl_facet_size)
    CHECK(std::isfinite(little_endian_at<float>(tiny, offset)));

  mesh.points[0] = {1e39, 0, 0};
  CHECK_THROWS_WITH(
      write_mesh(folder.path("a.stl"), mesh),
      Catch::EndsWith("a.stl: a coordinate is too large for STL, which uses single precision"));
  CHECK(content_of(folder.path("a.stl")) == tiny);
}

TEST_CASE("The sides of a sheet that differ by their normals only get the same vertices",
          "[mesh_io]") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  std::string vertices;
  for (const char* normal : {" 0 0 1\n", " 0 0 -1\n"})
    for (const char* place : {"0 0 0", "1 0 0", "0 1 0", "1 1 0"})
      vertices += std::string(place) + normal;
  const IndexedMesh mesh =
      read("a.ply", header + vertices + "3 0 1 2\n3 1 3 2\n3 6 5 4\n3 6 7 5\n");
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.triangles.size() == 4);
  CHECK(mesh.corner_normals.triples.size() == 4);
  // Of the same way round they would be faces twice.
  CHECK(read("a.ply", header + vertices + "3 0 1 2\n3 1 3 2\n3 4 5 6\n3 5 7 6\n").points.size() ==
        8);
}

TEST_CASE("Facets of STL keep their colours, and have the attribute 0 where there is none",
          "[mesh_io]") {
  const Folder folder;
  const auto attributes = [&](const std::string& name) {
    const std::string content = content_of(folder.path(name));
    std::vector<std::uint16_t> result;
    for (std::size_t end = stl_header_size + stl_facet_size; end <= content.size();
         end += stl_facet_size)
      result.push_back(little_endian_at<std::uint16_t>(content, end - 2));
    return result;
  };
  using Attributes = std::vector<std::uint16_t>;
  const auto file = [&](std::string header, const Attributes& of_facets) {
    header.resize(80, ' ');
    header += bytes(static_cast<std::uint32_t>(of_facets.size()));
    for (const std::uint16_t attribute : of_facets)
      header += std::string(12, '\0') + float_points() + bytes(attribute);
    return header;
  };
  const auto rewritten = [&](const std::string& content) {
    IndexedMesh mesh = read("a.stl", content);
    fit_to_format(mesh, *find_format(".stl"));
    write_mesh(folder.path("b.stl"), mesh);
    return attributes("b.stl");
  };
  const std::string magics = std::string("a COLOR=") + "\x10\x20\x30\x40";
  CHECK(rewritten(file("", {0, 0})) == Attributes{0, 0});
  CHECK(rewritten(file("", {0xFC00, 0, 0x801F})) == Attributes{0xFC00, 0, 0x801F});
  CHECK(rewritten(file("", {0x2020, 0x801F})) == Attributes{0, 0x801F}); // spaces are no colour
  CHECK(read("a.stl", file("", {0x2020})).losses.text() ==
        "attributes of facets that are not colours");
  CHECK(read("a.stl", file("", {0x8000})).losses.empty());
  CHECK(rewritten(file(magics, {0x001F, 0x8000, 0})) == Attributes{0x001F, 0x8000, 0});
  CHECK(content_of(folder.path("b.stl")).starts_with(magics));
  IndexedMesh mesh = read("a.stl", file("", {0xFC00, 0x801F}));
  fit_to_format(mesh, *find_format(".obj"));
  CHECK(mesh.losses.text() == "colours of facets");
}

TEST_CASE("An empty mesh is written as a valid file", "[mesh_io]") {
  const Folder folder;
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.stl", "a.ts"}) {
    CAPTURE(name);
    write_mesh(folder.path(name), {});
    CHECK(read_mesh(folder.path(name)).points.empty());
  }
}

TEST_CASE("A file is replaced as a whole or not at all", "[mesh_io]") {
  const Folder folder;
  CHECK_THROWS_WITH(write_mesh(folder.path("none/a.off"), {}),
                    Catch::Contains("none/a.off: there is no folder "));
  CHECK_THROWS_WITH(write_mesh(folder.path("a.xyz"), {}), Catch::Contains("the extension '.xyz'"));
  CHECK(folder.size() == 0);

  const fs::path target = folder.file("target.off", "old");
  fs::create_symlink(target, folder.path("link.off"));
  write_mesh(folder.path("link.off"), {});
  CHECK(fs::is_symlink(folder.path("link.off")));
  CHECK(content_of(target) == "OFF\n0 0 0\n");
  CHECK(folder.size() == 2);

  if (fs::is_character_file("/dev/full")) { // fails on every write
    fs::create_symlink("/dev/full", folder.path("full.off"));
    CHECK_THROWS_WITH(write_mesh(folder.path("full.off"), {}),
                      Catch::EndsWith("full.off: cannot be written in full"));
    CHECK(fs::is_character_file("/dev/full"));
    CHECK(folder.size() == 3);
  }
}

TEST_CASE("A file keeps its mode, a link its place, and a read-only file its content",
          "[mesh_io]") {
  const Folder folder;
  const fs::path target = folder.file("target.off", "old");
  fs::create_symlink("target.off", folder.path("link.off"));
  fs::create_symlink("link.off", folder.path("link_to_link.off"));
  for (const fs::perms mode : {fs::perms{0600}, fs::perms{0640}, fs::perms{0755}}) {
    fs::permissions(target, mode);
    write_mesh(folder.path("link_to_link.off"), {});
    CHECK(fs::status(target).permissions() == mode);
    CHECK(content_of(target) == "OFF\n0 0 0\n");
    CHECK(fs::read_symlink(folder.path("link_to_link.off")) == "link.off");
    CHECK(fs::read_symlink(folder.path("link.off")) == "target.off");
  }
  fs::create_symlink("new.off", folder.path("dangling.off"));
  write_mesh(folder.path("dangling.off"), {});
  CHECK(fs::is_symlink(folder.path("dangling.off")));
  CHECK(fs::is_regular_file(folder.path("new.off")));

  folder.file("target.off", "old");
  fs::permissions(target, fs::perms{0444});
  CHECK_THROWS_WITH(require_replaceable(target, false),
                    Catch::EndsWith("target.off: is read-only; --force replaces it"));
  CHECK_THROWS_WITH(write_mesh(folder.path("link.off"), {}),
                    Catch::EndsWith("link.off: is read-only; --force replaces it"));
  CHECK(content_of(target) == "old");
  require_replaceable(target, true);
  write_mesh(target, {}, mesh_format(target), true);
  CHECK(content_of(target) == "OFF\n0 0 0\n");
  CHECK(fs::status(target).permissions() == fs::perms{0444});
  CHECK_THROWS_WITH(require_replaceable(folder.path("."), false), Catch::EndsWith("is a folder"));
}

TEST_CASE("Any cut of a good file is refused or reads no more than there is", "[mesh_io]") {
  IndexedMesh mesh; // a strip of triangles with colours
  for (int i = 0; i < 12; ++i) {
    mesh.points.emplace_back(i, i % 2, 1. / (i + 1));
    mesh.colors.push_back({20. * i, 7, 3, 255});
  }
  for (std::uint32_t i = 2; i < 12; ++i)
    mesh.triangles.push_back({i - 2, i - 1, i});
  const Folder folder;
  for (const std::string name : {"a.off", "a.ply", "a.stl", "a.ts"}) { // OBJ has no end
    write_mesh(folder.path(name), mesh);
    const std::string whole = content_of(folder.path(name));
    for (std::size_t size = 0; size + 6 < whole.size(); ++size) {
      CAPTURE(name, size);
      CHECK_THROWS_AS(read_mesh(folder.file(name, whole.substr(0, size))), std::runtime_error);
    }
  }
}
