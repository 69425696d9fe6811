#ifndef QUADRILLE_TEST_SOUPS_H
#define QUADRILLE_TEST_SOUPS_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <ostream>
#include <random>
#include <set>
#include <utility>
#include <vector>

/// \file
/// Surfaces to test with, as polygon soups, and what can be said of them: plain maps and sets,
/// nothing of CGAL and nothing of the engine. Every generator gives the same surface at every call
/// and on every platform.

namespace test {

using Position = quadrille::Vector<3>;
using Triangle = std::array<std::uint32_t, 3>;

struct Soup {
  std::vector<Position> points;
  std::vector<Triangle> triangles;
};

/// Numbers in [low, high), the same ones on every platform.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }

private:
  std::mt19937_64 engine_;
};

// --- Small surfaces ------------------------------------------------------------------------------

Soup triangle();

/// 3---2
/// | \ |    bent along the diagonal
/// 0---1
Soup two_triangles();

Soup tetrahedron();

Soup octahedron();

// --- Surfaces of any size ------------------------------------------------------------------------

/// A grid of columns × rows squares, two triangles each, in the unit square of the plane z = 0.
Soup grid(std::uint32_t columns, std::uint32_t rows);

/// The wall of a cylinder of radius 1 and height 2, open at both ends.
Soup open_cylinder(std::uint32_t around, std::uint32_t along);

/// A sphere of radius 1 with poles and meridians: 2 · meridians · (parallels − 1) faces.
Soup uv_sphere(std::uint32_t meridians, std::uint32_t parallels);

/// An octahedron of which every face is cut into four, again and again: 8 · 4^levels faces.
Soup sphere(int levels);

/// A torus of radii 1 and 0.4.
Soup torus(std::uint32_t around, std::uint32_t across);

/// The surface of all unit cubes (x, y, z) in [0, nx) × [0, ny) × [0, nz) for which is_solid(x, y,
/// z) holds; cubes that only touch along an edge or in a vertex make it non-manifold.
template <class IsSolid>
Soup surface_of_cubes(int nx, int ny, int nz, IsSolid is_solid) {
  Soup soup;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [found, is_new] =
        number.try_emplace(p, static_cast<std::uint32_t>(soup.points.size()));
    if (is_new)
      soup.points.push_back({{double(p[0]), double(p[1]), double(p[2])}});
    return found->second;
  };
  const auto solid = [&](const std::array<int, 3>& c) {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < nx && c[1] < ny && c[2] < nz &&
           is_solid(c[0], c[1], c[2]);
  };
  const auto add_square = [&](std::array<int, 3> corner, std::size_t axis, bool is_upper) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<std::uint32_t, 4> q{};
    corner[axis] += is_upper;
    q[0] = vertex(corner);
    ++corner[u];
    q[1] = vertex(corner);
    ++corner[v];
    q[2] = vertex(corner);
    --corner[u];
    q[3] = vertex(corner);
    if (!is_upper)
      std::swap(q[1], q[3]);
    soup.triangles.push_back({q[0], q[1], q[2]});
    soup.triangles.push_back({q[0], q[2], q[3]});
  };
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (int side : {-1, 1}) {
            const std::array<int, 3> cube{x, y, z};
            std::array<int, 3> neighbour = cube;
            neighbour[axis] += side;
            if (solid(cube) && !solid(neighbour))
              add_square(cube, axis, side > 0);
          }
  return soup;
}

/// A cube of side 1 with n × n squares a side: 12 n² faces.
Soup cube(int n = 1);

/// A plate with `genus` square holes in a row; `fineness` squares go along the side of a hole.
Soup plate_with_holes(int genus, int fineness = 1);

// --- Changes -------------------------------------------------------------------------------------

/// Moves every point by up to `amplitude` along each axis.
Soup with_noise(Soup soup, std::uint64_t seed, double amplitude);

/// Rounds coordinates to floats, so that meshes of any kernel hold the same points.
Soup as_floats(Soup soup);

/// Maps every point by `f`.
template <class F>
Soup mapped(Soup soup, F f) {
  for (Position& p : soup.points)
    p = f(p);
  return soup;
}

/// Turns a surface about an axis through the origin that is parallel to no coordinate axis.
Soup tilted(const Soup& soup);

/// Two surfaces side by side, the second moved by d.
Soup joined(Soup a, const Soup& b, const Position& d = {});

/// The same points and triangles, with the same numbers, bit for bit?
bool is_identical(const Soup& a, const Soup& b);

/// The same surface with other numbers of its points and triangles.
Soup shuffled(Soup soup, std::uint64_t seed);

/// Drops points of no triangle; the others keep their order.
Soup without_isolated_points(const Soup& soup);

// --- What can be said of them --------------------------------------------------------------------

struct SoupTopology {
  std::size_t vertices = 0; ///< those of a triangle
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;   ///< parts that no vertex connects
  std::size_t boundary_edges = 0; ///< edges of one face
  std::size_t boundary_loops = 0; ///< if it is manifold
  bool is_manifold = true;      ///< at most two faces an edge, a path or a cycle round each vertex
  bool is_oriented = true;      ///< faces at an edge run along it in opposite directions
  bool has_duplicate_faces = false;
  bool has_collapsed_faces = false; ///< with two equal corners

  bool is_closed() const { return boundary_edges == 0; }
  long euler() const { return long(vertices) - long(edges) + long(faces); }
  /// Of a closed surface: the sum over its components.
  long genus() const { return long(components) - euler() / 2; }

  /// The same surface up to deformation, as far as numbers tell?
  friend bool is_same_topology(const SoupTopology& a, const SoupTopology& b) {
    return a.euler() == b.euler() && a.components == b.components &&
           a.boundary_loops == b.boundary_loops && a.is_manifold == b.is_manifold &&
           a.is_oriented == b.is_oriented;
  }
  friend std::ostream& operator<<(std::ostream& out, const SoupTopology& t) {
    return out << t.vertices << " vertices, " << t.edges << " edges, " << t.faces << " faces, "
               << t.components << " components, " << t.boundary_edges << " border edges in "
               << t.boundary_loops << " loops" << (t.is_manifold ? "" : ", not manifold")
               << (t.is_oriented ? "" : ", not oriented")
               << (t.has_duplicate_faces ? ", duplicate faces" : "")
               << (t.has_collapsed_faces ? ", collapsed faces" : "");
  }
};

namespace detail {

/// Sets of numbers that are merged.
class Partition {
public:
  explicit Partition(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::uint32_t root(std::uint32_t v) {
    while (parent_[v] != v)
      v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void merge(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

private:
  std::vector<std::uint32_t> parent_;
};

// The link of a vertex as the set of its edges: is it one path or one cycle?
bool is_path_or_cycle(const std::vector<std::array<std::uint32_t, 2>>& edges);

} // namespace detail

SoupTopology topology_of(const Soup& soup);

Position area_vector(const Soup& soup, const Triangle& t);

/// How many faces have no area.
std::size_t count_degenerate_faces(const Soup& soup);

bool is_finite(const Soup& soup);

/// The volume that a closed surface encloses; negative if its faces look inwards.
double volume(const Soup& soup);

/// The same about the first point and in long doubles: far from the origin, too.
long double exact_volume(const Soup& soup);

double diagonal(const Soup& soup);

/// Edges along which the surface is folded back on itself: the normals of their two faces are
/// opposed to within `degrees`.
std::size_t count_fold_overs(const Soup& soup, double degrees = 15);

// --- Random surfaces -----------------------------------------------------------------------------

/// Flips up to `flips` edges between two faces, chosen at random, wherever that leaves a surface of
/// the same topology without doubled edges.
Soup with_flipped_edges(Soup soup, std::uint64_t seed, int flips);

/// A closed surface of genus 0, 1 or 2 by the seed, of about 100 to 200 faces, with vertices of
/// many different degrees.
Soup random_closed(std::uint64_t seed);

/// Takes faces out at random, up to `count` of them, wherever the rest stays manifold and oriented.
Soup with_holes(Soup soup, std::uint64_t seed, int count);

/// A manifold surface with borders.
Soup random_with_boundaries(std::uint64_t seed);

} // namespace test

#endif // QUADRILLE_TEST_SOUPS_H
