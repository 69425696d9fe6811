// Channels beside one another and beside any cost: values, seams that are kept, priced or free,
// weights, and what is refused.
#include "charts.h"
#include "mesh_types.h"
#include "meshes.h"
#include "snapshot.h"
#include "soups.h"
#include "textured.h"
#include "textured_meshes.h"

#include <quadrille/channels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/texture_deviation.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;
using Catch::Contains;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// --- One texture ---------------------------------------------------------------------------------

struct TextureResult {
  Textured surface;
  Report report;
};

template <class Cost = Quadric, class Order = GreedyOrder>
TextureResult with_texture(const Textured& surface, std::size_t faces, ChannelOptions options = {},
                           const Order& order = {}) {
  PointSoup soup(surface.soup);
  auto [values, triples] = indexed(surface.texture);
  const Report report = simplify(soup.points, soup.triangles, Cost{}, order, FaceCount{faces},
                                 Texture{values, triples, options});
  const std::vector<int> labels(soup.triangles.size(), 0);
  return {{to_soup(soup), at_corners(values, triples), labels}, report};
}

std::vector<Textured> surfaces() {
  const auto noisy = [](const Textured& surface) {
    return with_points(surface, with_noise(surface.soup, 1, 0.004));
  };
  return {noisy(textured_cylinder(24, 10)), noisy(textured_torus(24, 16)),
          noisy(sphere_of_20_charts(2)), noisy(dart(16)), noisy(mirrored_sphere(3))};
}

std::size_t part_of(const Textured& surface, double ratio) {
  return static_cast<std::size_t>(ratio * static_cast<double>(surface.labels.size()));
}

// --- Normals -------------------------------------------------------------------------------------

struct NormalsResult {
  Soup soup;
  CornerValues<3> normals;
  Report report;
};

NormalsResult with_normals(const Soup& surface, const CornerValues<3>& normals, std::size_t faces,
                           ChannelOptions options = {}) {
  PointSoup soup(surface);
  auto [values, triples] = indexed(normals);
  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{faces}, Normals{values, triples, options});
  return {to_soup(soup), at_corners(values, triples), report};
}

Soup plain(const Soup& surface, std::size_t faces) {
  PointSoup soup(surface);
  simplify(soup.points, soup.triangles, FaceCount{faces});
  return to_soup(soup);
}

template <std::size_t N>
double greatest_deviation_from_unit_length(const CornerValues<N>& values) {
  double greatest = 0;
  for (const auto& triangle : values)
    for (const auto& value : triangle)
      greatest = std::max(greatest, std::abs(std::sqrt(squared_length(value)) - 1));
  return greatest;
}

// --- Four channels -------------------------------------------------------------------------------

struct Options {
  ChannelOptions texture = {}, normals = {}, colors = {}, heights = {};
};

struct Asset {
  PointSoup soup{Soup{}};
  IndexedCorners<2> texture;
  IndexedCorners<3> normals;
  std::vector<Vector<4>> colors; // of points
  std::vector<double> heights;
  std::vector<std::size_t> image; // of old points

  Report run(std::size_t faces, const Options& options = {}) {
    return simplify(soup.points, soup.triangles, FaceCount{faces},
                    Texture{texture.values, texture.triples, options.texture},
                    Normals{normals.values, normals.triples, options.normals},
                    Colors{CGAL::make_property_map(colors), options.colors},
                    Attributes{CGAL::make_property_map(heights), options.heights},
                    parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  }

  Textured surface() const {
    return {to_soup(soup), at_corners(texture.values, texture.triples),
            std::vector<int>(soup.triangles.size(), 0)};
  }
  CornerValues<3> corner_normals() const { return at_corners(normals.values, normals.triples); }

  // All but what is filled by `simplify` alone.
  auto all() const {
    std::vector<Vector<3>> points;
    for (const Point& p : soup.points)
      points.push_back(to_position(p));
    return std::tuple(points, soup.triangles, texture.values, texture.triples, normals.values,
                      normals.triples, colors, heights);
  }
};

double angle_of(const Position& p) {
  return std::atan2(p[1], p[0]);
}

// A cylinder. The texture has a seam at the angle 0. Normals have a hard edge at the angle π, from
// which they come back to those of the cylinder. Heights are z.
Asset cylinder_of_four_channels() {
  const std::uint32_t around = 24;
  const Textured surface = textured_cylinder(around, 10);
  const auto normals = corner_values<3>(surface.soup, [&](std::size_t t, std::uint32_t v) {
    const double angle = angle_of(surface.soup.points[v]);
    const bool is_outside = centre(surface.soup, surface.soup.triangles[t])[1] < 0;
    const double off = std::numbers::pi - std::abs(angle);
    const double turned = is_outside ? angle - 0.5 * (1 - off / std::numbers::pi) : angle;
    return Vector<3>{{std::cos(turned), std::sin(turned), 0}};
  });
  Asset asset{PointSoup(surface.soup), indexed(surface.texture), indexed(normals), {}, {}, {}};
  for (const Position& p : surface.soup.points) {
    asset.colors.push_back(
        {{0.5 + 0.5 * std::sin(2 * angle_of(p)), p[2] / 2, p[2] > 1 ? 1. : 0., 1}});
    asset.heights.push_back(p[2]);
  }
  asset.image.resize(surface.soup.points.size());
  return asset;
}

// The angles of the vertices at edges where values jump at both ends.
template <std::size_t N>
std::vector<double> angles_of_jumps(const Soup& soup, const CornerValues<N>& values) {
  std::vector<double> angles;
  for (const auto& [edge, sides] : sides_of_edges(soup))
    if (sides.size() == 2 && jumps(values, sides) == 2)
      for (const std::uint32_t v : edge)
        angles.push_back(angle_of(soup.points[v]));
  return angles;
}

// --- Maps that fail ------------------------------------------------------------------------------

// A map over a container, of which one write fails.
template <class Key, class Container>
struct FragileMap {
  using category = boost::read_write_property_map_tag;
  using key_type = Key;
  using value_type = TexturePlace;
  using reference = TexturePlace;

  Container* values;
  int* writes_left;

  friend value_type get(const FragileMap& map, const key_type& key) { return map.values->at(key); }
  friend void put(const FragileMap& map, const key_type& key, const value_type& value) {
    if ((*map.writes_left)-- == 0)
      throw std::runtime_error("no more writes");
    map.values->at(key) = value;
  }
};
using FragileVector = FragileMap<std::size_t, std::vector<TexturePlace>>;
using FragileHalfedges =
    FragileMap<Mesh::Halfedge_index, std::map<Mesh::Halfedge_index, TexturePlace>>;

constexpr int never = std::numeric_limits<int>::max();

// The texture of a mesh, with some vertices that stay.
struct MeshAsset {
  TexturedMesh<Mesh> textured;
  std::set<Mesh::Vertex_index> fixed;

  explicit MeshAsset(const Textured& surface) : textured(surface) {}

  Report run(std::size_t faces, int writes = never) {
    const auto is_fixed = boost::make_function_property_map<Mesh::Vertex_index>(
        [this](Mesh::Vertex_index v) { return fixed.contains(v); });
    return simplify(textured.mesh, FaceCount{faces},
                    Texture{FragileHalfedges{&textured.texture, &writes}, {.seams = Seams::kept}},
                    CGAL::parameters::vertex_is_constrained_map(is_fixed));
  }
};

// The places in the texture at a vertex.
std::set<std::array<double, 2>> places_at(const TexturedMesh<Mesh>& asset, Mesh::Vertex_index v) {
  std::set<std::array<double, 2>> places;
  for (const auto h : halfedges_around_target(halfedge(v, asset.mesh), asset.mesh))
    if (!is_border(h, asset.mesh))
      places.insert(asset.texture.at(h).coordinates);
  return places;
}

// Refused are four channels that `spoil` has changed, or their options.
template <class Spoil>
void require_rejected(Spoil spoil, const std::string& message, const Options& options = {}) {
  CAPTURE(message);
  Asset asset = cylinder_of_four_channels();
  spoil(asset);
  const auto before = asset.all();
  CHECK_THROWS_AS(asset.run(50, options), std::invalid_argument);
  CHECK_THROWS_WITH(asset.run(50, options), Contains(message));
  const auto after = asset.all();
  CHECK((std::get<1>(after) == std::get<1>(before)));
  CHECK((std::get<3>(after) == std::get<3>(before)));
  CHECK((std::get<5>(after) == std::get<5>(before)));
  CHECK(std::get<2>(after).size() == std::get<2>(before).size());
  CHECK((std::get<0>(after) == std::get<0>(before)));
}

} // namespace

// --- Values --------------------------------------------------------------------------------------

TEST_CASE(
    "Each of several channels keeps to its own seams, and is continuous over those of others") {
  for (const Seams seams : {Seams::priced, Seams::kept})
    for (const std::size_t faces : {200U, 80U}) {
      Asset asset = cylinder_of_four_channels();
      const Textured before = asset.surface();
      const Report report = asset.run(faces, {.normals = {.seams = seams}});
      CAPTURE(faces, report);
      CHECK(is_target_reached(report.stop));
      const Textured after = asset.surface();
      const CornerValues<3> normals = asset.corner_normals();
      const bool is_same = pattern_of(after) == pattern_of(before);
      CHECK(is_same);
      CHECK(count_jumps(after.soup, after.texture, 1) == 0);
      const auto of_texture = angles_of_jumps(after.soup, after.texture);
      CHECK_FALSE(of_texture.empty());
      for (const double angle : of_texture)
        CHECK(std::abs(angle) < 0.05);
      const auto of_normals = angles_of_jumps(after.soup, normals);
      CHECK_FALSE(of_normals.empty());
      for (const double angle : of_normals)
        CHECK(std::abs(angle) > std::numbers::pi - 0.2);
    }
}

TEST_CASE("What is linear in space stays so, normals have length 1, colours stay in their range") {
  for (const double shift : {0., -2.}) { // colours in [0, 1], and elsewhere
    Asset asset = cylinder_of_four_channels();
    for (Vector<4>& color : asset.colors)
      color[0] += shift;
    asset.run(60);
    for (std::size_t v = 0; v < asset.soup.points.size(); ++v) {
      CHECK(asset.heights[v] == Approx(to_position(asset.soup.points[v])[2]).margin(1e-9));
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(asset.colors[v][i] >= (i == 0 ? shift : 0));
        CHECK(asset.colors[v][i] <= (i == 0 ? shift + 1 : 1));
      }
    }
    CHECK(greatest_deviation_from_unit_length(asset.corner_normals()) < 1e-12);
    CHECK(asset.colors.size() == asset.image.size()); // with old values at its end
    std::set<std::uint32_t> used;
    for (const Triangle& triple : asset.texture.triples)
      used.insert(triple.begin(), triple.end());
    CHECK(used.size() == asset.texture.values.size()); // those that nothing uses are gone
  }
}

TEST_CASE("Values at vertices that nothing has touched keep their bits") {
  const Asset before = cylinder_of_four_channels();
  Asset after = before;
  after.run(300);
  std::map<std::size_t, std::vector<std::size_t>> origins;
  for (std::size_t v = 0; v < before.image.size(); ++v)
    origins[after.image[v]].push_back(v);
  const auto values_at = [](const Asset& asset, std::size_t v) {
    std::set<std::array<double, 2>> places;
    std::set<std::array<double, 3>> normals;
    for (std::size_t t = 0; t < asset.soup.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        if (asset.soup.triangles[t][i] == v) {
          places.insert(asset.texture.values[asset.texture.triples[t][i]].coordinates);
          normals.insert(asset.normals.values[asset.normals.triples[t][i]].coordinates);
        }
    return std::pair(places, normals);
  };
  std::size_t untouched = 0;
  for (std::size_t v = 0; v < after.soup.points.size(); ++v) {
    if (origins.at(v).size() > 1)
      continue;
    const std::size_t old = origins.at(v)[0];
    ++untouched;
    CHECK(after.soup.points[v] == before.soup.points[old]);
    CHECK((after.colors[v] == before.colors[old]));
    CHECK(after.heights[v] == before.heights[old]);
    CHECK((values_at(after, v) == values_at(before, old)));
  }
  CHECK(untouched > 20);
  CHECK(untouched < after.soup.points.size());
}

TEST_CASE("Vertices that are constrained keep their values") {
  MeshAsset asset(surfaces()[1]);
  Random random(3);
  std::map<Mesh::Vertex_index, std::set<std::array<double, 2>>> places;
  for (const auto v : vertices(asset.textured.mesh))
    if (random.below(8) == 0) {
      asset.fixed.insert(v);
      places[v] = places_at(asset.textured, v);
    }
  const Report report = asset.run(250);
  CHECK(is_target_reached(report.stop));
  for (const auto v : asset.fixed)
    for (const auto& place : places_at(asset.textured, v))
      CHECK(places.at(v).contains(place));
  CHECK(is_finite(asset.textured.surface()));
}

TEST_CASE("Values at vertices are as good as those at corners") {
  const Textured surface = surfaces()[4];
  const TextureResult expected = with_texture(surface, 100);
  std::vector<TexturePlace> places(surface.soup.points.size());
  for (std::size_t t = 0; t < surface.labels.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      places[surface.soup.triangles[t][i]] = surface.texture[t][i];

  Mesh mesh = make_mesh(surface.soup);
  const auto of_vertices = mesh.add_property_map<Mesh::Vertex_index, TexturePlace>("place").first;
  for (const auto v : vertices(mesh))
    of_vertices[v] = places[v.idx()];
  simplify(mesh, FaceCount{100}, Texture{of_vertices});
  mesh.collect_garbage();
  Textured result{test::to_soup(mesh), {}, expected.surface.labels};
  result.texture = corner_values<2>(result.soup, [&](std::size_t, std::uint32_t v) {
    return of_vertices[Mesh::Vertex_index(v)];
  });
  CHECK((described(result) == described(expected.surface)));

  PointSoup soup(surface.soup);
  int writes = never;
  simplify(soup.points, soup.triangles, FaceCount{100}, Texture{FragileVector{&places, &writes}});
  result = {to_soup(soup), at_corners(places, soup.triangles), expected.surface.labels};
  CHECK((described(result) == described(expected.surface)));
}

TEST_CASE("A channel of one value changes nothing") {
  for (const Soup& soup : {with_noise(sphere(3), 1, 0.01), bumpy_sheet(12)}) {
    const auto constant = corner_values<3>(soup, [](std::size_t, std::uint32_t) {
      return Vector<3>{{0, 0.6, 0.8}};
    });
    const NormalsResult result = with_normals(soup, constant, 60);
    CHECK(is_identical(result.soup, plain(soup, 60)));
    for (const auto& triangle : result.normals)
      for (const auto& normal : triangle)
        CHECK((normal == Vector<3>{{0, 0.6, 0.8}}));

    const auto place = [](std::size_t, std::uint32_t) { return TexturePlace{{0.1, 7}}; };
    const TextureResult textured_result = with_texture(textured(soup, place), 60);
    CHECK(is_identical(textured_result.surface.soup, plain(soup, 60)));
    for (const auto& triangle : textured_result.surface.texture)
      for (const TexturePlace& at : triangle)
        CHECK((at == TexturePlace{{0.1, 7}}));
  }
}

TEST_CASE("A component that is the same at all corners keeps its bits") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Textured surface = random_corners(random_closed(seed), seed);
    for (auto& triangle : surface.texture)
      for (TexturePlace& place : triangle)
        place[1] = 0.3;
    const Textured result = with_texture(surface, part_of(surface, 0.3)).surface;
    CHECK(is_finite(result));
    for (const auto& triangle : result.texture)
      for (const TexturePlace& place : triangle)
        CHECK(place[1] == 0.3);
  }
}

TEST_CASE("Values may be of floats, and triples of integers with a sign") {
  const Textured surface = textured_cylinder(24, 10);
  PointSoup soup(surface.soup);
  const IndexedCorners<2> corners = indexed(surface.texture);
  std::vector<std::array<float, 2>> values;
  std::vector<std::array<int, 3>> triples;
  for (const TexturePlace& place : corners.values)
    values.push_back({static_cast<float>(place[0]), static_cast<float>(place[1])});
  for (const auto& [a, b, c] : corners.triples)
    triples.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});

  triples[5][1] = -1;
  CHECK_THROWS_AS(simplify(soup.points, soup.triangles, FaceCount{100}, Texture{values, triples}),
                  std::invalid_argument);
  CHECK((snapshot(soup) == snapshot(PointSoup(surface.soup))));
  triples[5][1] = static_cast<int>(corners.triples[5][1]);

  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{100}, Texture{values, triples});
  CHECK(is_target_reached(report.stop));
  Textured result{to_soup(soup), {}, std::vector<int>(soup.triangles.size(), 0)};
  for (const auto& triple : triples) {
    auto& places = result.texture.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [u, v] = values.at(static_cast<std::size_t>(triple[i]));
      places[i] = {{double(u), double(v)}};
    }
  }
  const bool is_same = pattern_of(result) == pattern_of(surface);
  CHECK(is_same);
}

// --- Seams that are priced or free ---------------------------------------------------------------

TEST_CASE("A surface each face of which has its normal goes where it goes without") {
  for (const Soup& soup : {sphere(3), with_noise(torus(24, 12), 1, 0.01)})
    for (const std::size_t faces : {200U, 50U}) {
      const NormalsResult result = with_normals(soup, facet_normals(soup), faces);
      CAPTURE(faces, result.report);
      CHECK(is_target_reached(result.report.stop));
      CHECK(result.soup.triangles.size() == plain(soup, faces).triangles.size());
      CHECK(result.report.rejected(Rejection::seam) == 0);
      CHECK(greatest_deviation_from_unit_length(result.normals) < 1e-12);
    }
}

TEST_CASE("Where each face has its normal and seams are kept, nothing goes") {
  const Soup soup = sphere(2);
  const NormalsResult result = with_normals(soup, facet_normals(soup), 20, {.seams = Seams::kept});
  CHECK(result.report.stop == StopReason::all_pairs_rejected);
  CHECK(result.report.contractions == 0);
  CHECK(result.report.rejected(Rejection::seam) > 0);
  CHECK(is_identical(result.soup, soup));
}

TEST_CASE("A cube keeps its hard edges, as far as they are not free") {
  const Soup soup = cube(6);
  for (const Seams seams : {Seams::priced, Seams::kept}) {
    const NormalsResult result = with_normals(soup, facet_normals(soup), 12, {.seams = seams});
    CAPTURE(result.report);
    REQUIRE(result.soup.triangles.size() == 12);
    const CornerValues<3> expected = facet_normals(result.soup);
    for (std::size_t t = 0; t < 12; ++t)
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(squared_distance(result.normals[t][i], expected[t][i]) < 1e-24);
  }
  const NormalsResult result = with_normals(soup, facet_normals(soup), 12, {.seams = Seams::free});
  CHECK(result.soup.triangles.size() == 12);
  CHECK(count_jumps(result.soup, result.normals, 1) == 0);
  CHECK(count_jumps(result.soup, result.normals, 2) == 0);
  CHECK(greatest_deviation_from_unit_length(result.normals) < 1e-12);
}

TEST_CASE("A texture is continuous over the ridge of a roof, where normals are not") {
  Asset asset;
  const Soup soup = roof(12);
  asset.soup = PointSoup(soup);
  asset.texture = indexed(textured(soup, [&](std::size_t, std::uint32_t v) {
                            return TexturePlace{{soup.points[v][0], soup.points[v][1]}};
                          }).texture);
  asset.normals = indexed(facet_normals(soup));
  asset.colors.resize(soup.points.size());
  asset.heights.resize(soup.points.size());
  asset.image.resize(soup.points.size());
  const Report report = asset.run(10);
  CAPTURE(report);
  CHECK(is_target_reached(report.stop));
  const Textured result = asset.surface();
  CHECK(count_jumps(result.soup, result.texture, 1) == 0);
  CHECK(count_jumps(result.soup, result.texture, 2) == 0);
  CHECK(count_jumps(result.soup, asset.corner_normals(), 2) > 0);
  for (std::size_t t = 0; t < result.labels.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& p = result.soup.points[result.soup.triangles[t][i]];
      CHECK(squared_distance(result.texture[t][i], TexturePlace{{p[0], p[1]}}) < 1e-13);
    }
  const CornerValues<3> normals = asset.corner_normals(), expected = facet_normals(result.soup);
  for (std::size_t t = 0; t < normals.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(squared_distance(normals[t][i], expected[t][i]) < 1e-18);
}

TEST_CASE("Seams of a texture may be priced or free, and then vanish") {
  const Textured cube = textured_cube(6);
  const TextureResult kept = with_texture(cube, 4, {.seams = Seams::kept});
  CHECK(kept.surface.labels.size() == 12);
  CHECK_FALSE(is_target_reached(kept.report.stop));
  const TextureResult priced = with_texture(cube, 4, {.seams = Seams::priced});
  CHECK(priced.surface.labels.size() < 12);
  CHECK(priced.report.rejected(Rejection::seam) == 0);
  const TextureResult free = with_texture(cube, 100, {.seams = Seams::free});
  CHECK(free.surface.labels.size() <= 100);
  CHECK(count_jumps(free.surface.soup, free.surface.texture, 1) == 0);
  CHECK(count_jumps(free.surface.soup, free.surface.texture, 2) == 0);
  CHECK(is_finite(free.surface));
}

TEST_CASE("Where seams are free, places of the texture around a vertex become one between them") {
  const Textured cube = textured_cube(3);
  const Textured result = with_texture(cube, cube.labels.size(), {.seams = Seams::free}).surface;
  REQUIRE(result.soup.triangles == cube.soup.triangles);
  std::map<std::uint32_t, std::array<TexturePlace, 2>> ranges;
  for (std::size_t t = 0; t < cube.labels.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const TexturePlace& place = cube.texture[t][i];
      auto& [low, high] =
          ranges.try_emplace(cube.soup.triangles[t][i], std::array{place, place}).first->second;
      for (const std::size_t c : {0U, 1U})
        low[c] = std::min(low[c], place[c]), high[c] = std::max(high[c], place[c]);
    }
  for (std::size_t t = 0; t < cube.labels.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [low, high] = ranges.at(cube.soup.triangles[t][i]);
      for (const std::size_t c : {0U, 1U}) {
        CHECK(result.texture[t][i][c] > low[c] - 1e-12);
        CHECK(result.texture[t][i][c] < high[c] + 1e-12);
      }
    }
}

TEST_CASE("The values around a vertex where seams are free lie between those that there were") {
  const Soup soup = with_noise(sphere(2), 1, 0.01);
  Random random(1);
  const CornerValues<3> corners = corner_values<3>(soup, [&](std::size_t, std::uint32_t v) {
    Position p = soup.points[v];
    for (double& x : p.coordinates)
      x += random(-0.3, 0.3);
    return 1 / std::sqrt(squared_length(p)) * p;
  });
  const NormalsResult result =
      with_normals(soup, corners, soup.triangles.size(), {.seams = Seams::free});
  REQUIRE(result.soup.triangles == soup.triangles);
  CHECK(count_jumps(result.soup, result.normals, 1) == 0);
  CHECK(count_jumps(result.soup, result.normals, 2) == 0);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) // a mean of many, none of which is off by a half
      CHECK(dot(result.normals[t][i], soup.points[soup.triangles[t][i]]) > 0.8);
}

// --- Costs and orders ----------------------------------------------------------------------------

TEMPLATE_TEST_CASE("Every cost and order keeps charts", "", (std::tuple<Quadric, RelaxedOrder>),
                   (std::tuple<MemorylessQuadric, GreedyOrder>),
                   (std::tuple<ThinFeatureQuadric, GreedyOrder>)) {
  using Cost = std::tuple_element_t<0, TestType>;
  using Order = std::tuple_element_t<1, TestType>;
  for (const Textured& surface : surfaces())
    for (const double ratio : {0.3, 0.}) {
      const auto [result, report] = with_texture<Cost, Order>(surface, part_of(surface, ratio),
                                                              {.seams = Seams::kept}, Order{});
      CAPTURE(ratio, report);
      CHECK(is_finite(result));
      CHECK(faces_of_charts(result).size() == faces_of_charts(surface).size());
      if (count_jumps(surface.soup, surface.texture, 1) == 0) {
        const bool is_same = pattern_of(result) == pattern_of(surface);
        CHECK(is_same);
      }
      if (ratio > 0)
        CHECK(is_target_reached(report.stop));
    }
}

// --- Weights -------------------------------------------------------------------------------------

TEST_CASE("The unit of a texture does not matter, and not at all if it is a power of two") {
  for (const Textured& surface : surfaces()) {
    const std::size_t faces = part_of(surface, 0.2);
    const TextureResult expected = with_texture(surface, faces);
    for (const int exponent : {-60, -21, 1, 60}) {
      CAPTURE(exponent);
      const double scale = std::ldexp(1.0, exponent);
      Textured scaled = surface;
      for (auto& triangle : scaled.texture)
        for (TexturePlace& place : triangle)
          place *= scale;
      TextureResult result = with_texture(scaled, faces);
      for (auto& triangle : result.surface.texture)
        for (TexturePlace& place : triangle)
          place *= 1 / scale;
      CHECK((described(result.surface) == described(expected.surface)));
    }
    for (const double shift : {8., -64.}) {
      CAPTURE(shift);
      Textured moved = surface;
      for (auto& triangle : moved.texture)
        for (TexturePlace& place : triangle)
          place += {{shift, -2 * shift}};
      const Textured result = with_texture(moved, faces).surface;
      REQUIRE(result.soup.triangles == expected.surface.soup.triangles);
      double greatest = 0;
      for (std::size_t v = 0; v < result.soup.points.size(); ++v)
        greatest = std::max(
            greatest, squared_distance(result.soup.points[v], expected.surface.soup.points[v]));
      for (std::size_t t = 0; t < result.labels.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
          greatest = std::max(greatest, squared_distance(result.texture[t][i],
                                                         expected.surface.texture[t][i] +
                                                             TexturePlace{{shift, -2 * shift}}));
      CHECK(greatest < 1e-18);
    }
  }
}

TEST_CASE("Weights are lengths: by default the root of the areas for a texture, times importance") {
  const Textured surface = surfaces()[1];
  double area = 0;
  for (const Triangle& t : surface.soup.triangles)
    area += std::sqrt(squared_length(area_vector(surface.soup, t)));
  const double weight = std::sqrt(area / texture_area(surface));
  const TextureResult expected = with_texture(surface, 100);
  const TextureResult same = with_texture(surface, 100, {.weights = {weight, weight}});
  CHECK(is_same_surface(same.surface.soup, expected.surface.soup, 1e-6));
  const TextureResult by_importance =
      with_texture(surface, 100, {.importance = 4, .weights = {weight / 4, weight / 4}});
  CHECK((described(by_importance.surface) == described(same.surface)));
  const TextureResult of_u = with_texture(surface, 100, {.weights = {4 * weight, weight / 4}});
  CHECK_FALSE(is_same_surface(of_u.surface.soup, expected.surface.soup, 1e-6));
}

TEST_CASE("The firmer borders of charts are held, the less the texture bleeds") {
  const Textured surface = with_points(sphere_of_20_charts(3), tilted(sphere_of_20_charts(3).soup));
  const auto as_soup = [](const Textured& textured) {
    TexturedSoup soup;
    soup.shape = {textured.soup.points, textured.soup.triangles};
    for (const auto& corners : textured.texture) {
      const auto first = static_cast<std::uint32_t>(soup.texture.points.size());
      soup.texture.triangles.push_back({first, first + 1, first + 2});
      soup.texture.points.insert(soup.texture.points.end(), corners.begin(), corners.end());
    }
    return soup;
  };
  const auto bleeding = [&](double chart_boundary_weight) {
    const Textured result =
        with_texture(surface, 150, {.chart_boundary_weight = chart_boundary_weight}).surface;
    return texture_deviation(as_soup(result), as_soup(surface), 20'000).bleeding;
  };
  const double loose = bleeding(0), firm = bleeding(0.3), firmest = bleeding(10);
  CAPTURE(loose, firm, firmest);
  CHECK(firm < 0.7 * loose);
  CHECK(firmest < 0.7 * firm);
}

// --- What is refused -----------------------------------------------------------------------------

TEST_CASE("Input that makes no sense is refused, and left as it was") {
  require_rejected([](Asset& a) { a.texture.triples[7][1] = 100'000; },
                   "face 7 names value 100000 of ");
  require_rejected(
      [](Asset& a) { a.normals.triples[7][2] = std::uint32_t(a.normals.values.size()); },
      "face 7 names value ");
  require_rejected([](Asset& a) { a.texture.triples.pop_back(); },
                   "index triples for 479 triangles of 480");
  require_rejected(
      [](Asset& a) {
        a.texture.triples.push_back({0, 0, 0});
      },
      "index triples for 481 triangles of 480");
  require_rejected([](Asset& a) { a.normals.triples.clear(); },
                   "index triples for 0 triangles of 480");

  for (const double value : {not_a_number, infinity, -infinity}) {
    require_rejected([&](Asset& a) { a.texture.values[5][1] = value; },
                     "value 5 of a channel is not finite");
    require_rejected([&](Asset& a) { a.normals.values[5][2] = value; },
                     "value 5 of a channel is not finite");
    require_rejected([&](Asset& a) { a.colors[5][3] = value; },
                     "value 5 of a channel is not finite");
    require_rejected([&](Asset& a) { a.heights[5] = value; }, "value 5 of a channel is not finite");
  }
}

TEST_CASE("Options that make no sense are refused") {
  const auto nothing = [](Asset&) {};
  require_rejected(nothing, "a channel of 2 components has 1 weights",
                   {.texture = {.weights = {1}}});
  require_rejected(nothing, "has 3 weights", {.texture = {.weights = {1, 1, 1}}});
  require_rejected(nothing, "a channel of 1 components has 2 weights",
                   {.heights = {.weights = {1, 1}}});
  require_rejected(nothing, "existing does not go with a Texture",
                   {.texture = {.new_values = NewValues::existing}});
  require_rejected(nothing, "recomputed goes with Normals",
                   {.colors = {.new_values = NewValues::recomputed}});
  require_rejected(nothing, "weights goes with Attributes",
                   {.normals = {.new_values = NewValues::weights}});
  require_rejected(nothing, "linear_light goes with Colors", {.heights = {.linear_light = true}});
  for (const double value : {-1., not_a_number, infinity})
    require_rejected(nothing, "chart_boundary_weight",
                     {.texture = {.chart_boundary_weight = value}});
  for (const double value : {0., -1., not_a_number, infinity}) {
    require_rejected(nothing, "weight", {.normals = {.weights = {1, value, 1}}});
    require_rejected(nothing, "importance", {.colors = {.importance = value}});
  }
}

TEST_CASE("Values whose type does not tell their number must have enough components") {
  PointSoup soup(textured_cube(2).soup);
  const auto triangles = soup.triangles;
  std::vector<std::vector<double>> values(4, {0.5, 1});
  values[2].pop_back();
  std::vector<Triangle> triples(triangles.size(), {0, 1, 3});
  triples[11] = {0, 1, 2};
  CHECK_THROWS_AS(simplify(soup.points, soup.triangles, FaceCount{20}, Texture{values, triples}),
                  std::invalid_argument);
  CHECK(soup.triangles == triangles);
  CHECK(values[2].size() == 1);
}

TEST_CASE("A map that throws leaves a soup as it was") {
  const Textured surface = surfaces()[4];
  const PointSoup input(surface.soup);
  const std::vector<TexturePlace> places = [&] {
    std::vector<TexturePlace> result;
    for (const Position& p : surface.soup.points)
      result.push_back({{p[0], p[1]}});
    return result;
  }();
  int failures = 0;
  for (int n = 0; n < 10'000; n = 2 * n + 1) {
    CAPTURE(n);
    PointSoup soup = input;
    std::vector<TexturePlace> values = places;
    int writes = n;
    try {
      simplify(soup.points, soup.triangles, FaceCount{100},
               Texture{FragileVector{&values, &writes}});
      CHECK(writes >= 0);
      break;
    } catch (const std::runtime_error&) {
      ++failures;
    }
    CHECK((snapshot(soup) == snapshot(input)));
    CHECK((values == places));
  }
  CHECK(failures > 5);
}

TEST_CASE("A map that throws leaves a mesh as it was") {
  const Textured surface = surfaces()[1];
  int failures = 0;
  for (int n = 0; n < 10'000; n = 2 * n + 1) {
    CAPTURE(n);
    MeshAsset asset(surface);
    const Snapshot before = snapshot(asset.textured.mesh);
    const auto texture = asset.textured.texture;
    try {
      asset.run(100, n);
      break;
    } catch (const std::runtime_error&) {
      ++failures;
    }
    CHECK((snapshot(asset.textured.mesh) == before));
    CHECK(asset.textured.mesh.number_of_removed_faces() == 0);
    for (const auto& [h, place] : texture)
      if (!is_border(h, asset.textured.mesh))
        CHECK((asset.textured.texture.at(h) == place));
  }
  CHECK(failures > 5);
}
