// Writes a surface that is made by a formula as binary PLY, row by row, so that it may have any
// number of faces and is never in memory: for tests and measurements of <quadrille/file.h>.
//
//   formula_ply torus|plate FACES FILE
//   formula_ply check FILE
//
// torus: closed, genus 1, with bumps of all sizes; plate: a closed plate with square pockets and
// studs, flat but for their edges, as a part of a machine is. check: is a file of either, as
// simplify_file has left it, closed and manifold by its edges, and of genus 1? Takes 24 bytes a
// face.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr double turn = 2 * std::numbers::pi;

struct Grid {
  std::uint32_t rows, columns; // both wrap around
};

/// Bumps, each of them of half the size of the one before.
double bumps(double u, double v) {
  double sum = 0, height = 0.05;
  for (int k = 0; k < 9; ++k, height *= 0.48) {
    const double n = 3 << k;
    sum += height * std::sin(turn * (n * u + 0.37 * k)) * std::cos(turn * (n * v + 0.61 * k * k)) +
           0.5 * height * std::sin(turn * (n * (u + v) + 0.17 * k));
  }
  return sum;
}

void put_torus(double u, double v, float* p) {
  const double r = 0.4 + bumps(u, v);
  p[0] = static_cast<float>((1 + r * std::cos(turn * v)) * std::cos(turn * u));
  p[1] = static_cast<float>((1 + r * std::cos(turn * v)) * std::sin(turn * u));
  p[2] = static_cast<float>(r * std::sin(turn * v));
}

/// A torus of rectangular section, whose upper side has pockets and studs.
void put_plate(double u, double v, float* p) {
  const double side = 4 * v;
  const double t = side - std::floor(side);
  double radius = 1, z = 0;
  if (side < 1) { // upper side, outwards
    radius = 0.5 + t;
    const double a = 24 * u - std::floor(24 * u), b = 4 * t - std::floor(4 * t);
    const bool is_inside = std::abs(a - 0.5) < 0.25 && std::abs(b - 0.5) < 0.25;
    const int cell = static_cast<int>(24 * u) + static_cast<int>(4 * t);
    z = 0.1 + (is_inside ? (cell % 2 == 0 ? 0.04 : -0.04) : 0.0);
  } else if (side < 2) {
    radius = 1.5, z = 0.1 - 0.2 * t;
  } else if (side < 3) {
    radius = 1.5 - t, z = -0.1;
  } else {
    radius = 0.5, z = -0.1 + 0.2 * t;
  }
  p[0] = static_cast<float>(radius * std::cos(turn * u));
  p[1] = static_cast<float>(radius * std::sin(turn * u));
  p[2] = static_cast<float>(z);
}

void put_vertices(std::ostream& out, const Grid& grid, bool is_plate) {
  std::vector<float> row(3 * std::size_t{grid.columns});
  for (std::uint32_t i = 0; i < grid.rows; ++i) {
    for (std::uint32_t j = 0; j < grid.columns; ++j)
      (is_plate ? put_plate : put_torus)(i / static_cast<double>(grid.rows),
                                         j / static_cast<double>(grid.columns), &row[3 * j]);
    out.write(reinterpret_cast<const char*>(row.data()),
              static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
}

void put_faces(std::ostream& out, const Grid& grid) {
  std::vector<char> row(26 * std::size_t{grid.columns});
  for (std::uint32_t i = 0; i < grid.rows; ++i) {
    const std::uint32_t next = (i + 1) % grid.rows;
    for (std::uint32_t j = 0; j < grid.columns; ++j) {
      const std::uint32_t beside = (j + 1) % grid.columns;
      const std::uint32_t a = i * grid.columns + j, b = next * grid.columns + j;
      const std::uint32_t c = next * grid.columns + beside, d = i * grid.columns + beside;
      const std::uint32_t faces[2][3] = {{a, b, c}, {a, c, d}};
      for (int f = 0; f < 2; ++f) {
        char* const to = &row[26 * std::size_t{j} + 13 * static_cast<std::size_t>(f)];
        *to = 3;
        std::memcpy(to + 1, faces[f], 12);
      }
    }
    out.write(row.data(), static_cast<std::streamsize>(row.size()));
  }
}

/// Reads the file that simplify_file has written: little-endian, floats, 32-bit corners.
bool is_torus(const char* path) {
  std::ifstream in(path, std::ios::binary);
  std::uint64_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    if (line.rfind("element vertex ", 0) == 0)
      vertices = std::stoull(line.substr(15));
    if (line.rfind("element face ", 0) == 0)
      faces = std::stoull(line.substr(13));
  }
  in.seekg(static_cast<std::streamoff>(12 * vertices), std::ios::cur);
  std::vector<std::uint64_t> edges; // each as its face runs
  std::vector<bool> is_used(vertices);
  for (std::uint64_t f = 0; f < faces; ++f) {
    char row[13];
    in.read(row, sizeof(row));
    std::uint32_t corners[3];
    std::memcpy(corners, row + 1, sizeof(corners));
    for (int i = 0; i < 3; ++i) {
      edges.push_back(std::uint64_t{corners[i]} << 32 | corners[(i + 1) % 3]);
      is_used.at(corners[i]) = true;
    }
  }
  std::sort(edges.begin(), edges.end());
  const bool is_once = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  const bool is_paired = std::all_of(edges.begin(), edges.end(), [&](std::uint64_t e) {
    return std::binary_search(edges.begin(), edges.end(), e >> 32 | e << 32);
  });
  const bool is_all = std::find(is_used.begin(), is_used.end(), false) == is_used.end();
  std::cout << faces << " faces, " << vertices
            << " vertices: " << (is_once && is_paired ? "closed" : "NOT CLOSED")
            << (in && is_all ? "" : ", NOT WHOLE") << ", Euler number "
            << static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(faces) / 2 << '\n';
  return in && is_once && is_paired && is_all && 2 * vertices == faces;
}

} // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "check")
    return is_torus(argv[2]) ? 0 : 1;
  if (argc != 4) {
    std::cerr << "usage: formula_ply torus|plate FACES FILE, or formula_ply check FILE\n";
    return 2;
  }
  const bool is_plate = std::string(argv[1]) == "plate";
  const double faces = std::strtod(argv[2], nullptr);
  const auto columns = static_cast<std::uint32_t>(std::sqrt(faces / 2 / 2.5));
  const Grid grid{static_cast<std::uint32_t>(faces / 2 / columns), columns};
  std::ofstream out(argv[3], std::ios::binary);
  const std::uint64_t vertices = std::uint64_t{grid.rows} * grid.columns;
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << vertices
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * vertices
      << "\nproperty list uchar uint vertex_indices\nend_header\n";
  put_vertices(out, grid, is_plate);
  put_faces(out, grid);
  if (!out.flush()) {
    std::cerr << argv[3] << ": cannot be written in full\n";
    return 1;
  }
}
