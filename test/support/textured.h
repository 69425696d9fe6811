#ifndef QUADRILLE_TEST_TEXTURED_H
#define QUADRILLE_TEST_TEXTURED_H

#include "soups.h"

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// Surfaces with values at their corners, above all texture coordinates in charts, and the forms in
/// which an asset has them. Nothing of CGAL and nothing of the engine.

namespace test {

/// Of each triangle, the values of N components at its three corners.
template <std::size_t N>
using CornerValues = std::vector<std::array<quadrille::Vector<N>, 3>>;
using TexturePlace = quadrille::Vector<2>;

struct Textured {
  Soup soup;
  CornerValues<2> texture;
  std::vector<int> labels; ///< of each triangle
};

// --- Forms of an asset ---------------------------------------------------------------------------

/// Values with an index triple for each triangle, as in an OBJ file.
template <std::size_t N>
struct IndexedCorners {
  std::vector<quadrille::Vector<N>> values;
  std::vector<Triangle> triples;
};

/// Each value once.
template <std::size_t N>
IndexedCorners<N> indexed(const CornerValues<N>& corners) {
  IndexedCorners<N> result;
  std::map<std::array<double, N>, std::uint32_t> number;
  for (const auto& triangle : corners) {
    Triangle& triple = result.triples.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [found, is_new] = number.try_emplace(
          triangle[i].coordinates, static_cast<std::uint32_t>(result.values.size()));
      if (is_new)
        result.values.push_back(triangle[i]);
      triple[i] = found->second;
    }
  }
  return result;
}

template <std::size_t N>
CornerValues<N> at_corners(const std::vector<quadrille::Vector<N>>& values,
                           const std::vector<Triangle>& triples) {
  CornerValues<N> result;
  for (const auto& [a, b, c] : triples)
    result.push_back({values.at(a), values.at(b), values.at(c)});
  return result;
}

/// A vertex for each combination of a point and values, as in the buffers of a renderer.
template <std::size_t... N>
struct SplitSoup {
  Soup soup;
  std::tuple<std::vector<quadrille::Vector<N>>...> values; ///< of each point
};

/// Points keep their order: those of one place are neighbours.
template <std::size_t... N>
SplitSoup<N...> split(const Soup& soup, const CornerValues<N>&... corners) {
  const auto key_of = [&](std::size_t t, std::size_t i) {
    return std::tuple(soup.triangles[t][i], corners[t][i].coordinates...);
  };
  std::map<decltype(key_of(0, 0)), std::uint32_t> number;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      number[key_of(t, i)] = 0;
  SplitSoup<N...> result;
  for (auto& [key, index] : number) {
    index = static_cast<std::uint32_t>(result.soup.points.size());
    result.soup.points.push_back(soup.points[std::get<0>(key)]);
    std::apply(
        [&](std::uint32_t, const std::array<double, N>&... values) {
          std::apply([&](auto&... of_points) { (of_points.push_back({values}), ...); },
                     result.values);
        },
        key);
  }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    result.soup.triangles.push_back(
        {number.at(key_of(t, 0)), number.at(key_of(t, 1)), number.at(key_of(t, 2))});
  return result;
}

/// Points at the same place are one, the first of them.
inline Soup welded(const Soup& soup) {
  Soup result;
  std::map<std::array<double, 3>, std::uint32_t> number;
  std::vector<std::uint32_t> new_index;
  for (const Position& p : soup.points) {
    const auto [found, is_new] =
        number.try_emplace(p.coordinates, static_cast<std::uint32_t>(result.points.size()));
    if (is_new)
      result.points.push_back(p);
    new_index.push_back(found->second);
  }
  for (const auto& [a, b, c] : soup.triangles)
    result.triangles.push_back({new_index[a], new_index[b], new_index[c]});
  return result;
}

// --- Making them ---------------------------------------------------------------------------------

inline Position centre(const Soup& soup, const Triangle& t) {
  return (1. / 3) * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
}

/// Values by value_at(t, v), of the corner of triangle t at vertex v.
template <std::size_t N, class ValueAt>
CornerValues<N> corner_values(const Soup& soup, ValueAt value_at) {
  CornerValues<N> result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto [a, b, c] = soup.triangles[t];
    result.push_back({value_at(t, a), value_at(t, b), value_at(t, c)});
  }
  return result;
}

/// All of one label.
template <class PlaceAt>
Textured textured(const Soup& soup, PlaceAt place_at) {
  return {soup, corner_values<2>(soup, place_at), std::vector<int>(soup.triangles.size(), 0)};
}

template <class LabelAt>
Textured with_labels(Textured surface, LabelAt label_at) {
  for (std::size_t t = 0; t < surface.labels.size(); ++t)
    surface.labels[t] = label_at(centre(surface.soup, surface.soup.triangles[t]));
  return surface;
}

/// The same surface and texture, where the points are others.
inline Textured with_points(Textured surface, const Soup& soup) {
  surface.soup.points = soup.points;
  return surface;
}

/// The normal of its triangle at each corner.
inline CornerValues<3> facet_normals(const Soup& soup) {
  return corner_values<3>(soup, [&](std::size_t t, std::uint32_t) {
    const Position area = area_vector(soup, soup.triangles[t]);
    return 1 / std::sqrt(squared_length(area)) * area;
  });
}

/// Of n columns in a circle, the place of column i in a triangle of these columns: n where the
/// triangle reaches it from behind.
inline double unrolled(std::uint32_t i, std::uint32_t n, const Triangle& columns) {
  const bool is_outside = std::count(columns.begin(), columns.end(), n - 1) > 0;
  return i == 0 && is_outside ? n : i;
}

// --- Models --------------------------------------------------------------------------------------

/// open_cylinder() with u around and v along, both in [0, 1], and a seam at a column.
inline Textured textured_cylinder(std::uint32_t around, std::uint32_t along,
                                  std::uint32_t seam = 0) {
  const Soup soup = open_cylinder(around, along);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    Triangle columns = soup.triangles[t];
    for (std::uint32_t& column : columns)
      column = (column + around - seam) % around;
    const double column = unrolled((v + around - seam) % around, around, columns);
    return TexturePlace{{column / around, soup.points[v][2] / 2}};
  });
}

/// torus() with two seams, that cross at one vertex.
inline Textured textured_torus(std::uint32_t around, std::uint32_t across) {
  const Soup soup = torus(around, across);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    Triangle rings = soup.triangles[t], columns = rings;
    for (std::uint32_t& ring : rings)
      ring /= across;
    for (std::uint32_t& column : columns)
      column %= across;
    return TexturePlace{{unrolled(v / across, around, rings) / around,
                         unrolled(v % across, across, columns) / across}};
  });
}

/// uv_sphere() with a seam from pole to pole; at the poles each face has a value of its own.
inline Textured earth(std::uint32_t meridians, std::uint32_t parallels) {
  const Soup soup = uv_sphere(meridians, parallels);
  const auto top = static_cast<std::uint32_t>(soup.points.size() - 1);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    const auto is_pole = [&](std::uint32_t w) { return w == 0 || w == top; };
    Triangle columns = soup.triangles[t];
    const Triangle corners = columns;
    for (std::uint32_t& column : columns)
      column = is_pole(column) ? meridians : (column - 1) % meridians;
    if (!is_pole(v))
      return TexturePlace{{unrolled((v - 1) % meridians, meridians, columns) / meridians,
                           double(1 + (v - 1) / meridians) / parallels}};
    double u = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_pole(corners[i]))
        u += unrolled(columns[i], meridians, columns) / meridians / 2;
    return TexturePlace{{u, v == top ? 1. : 0.}};
  });
}

/// On which side of cube() a place is: 0 to 5.
inline int side_of_cube(const Position& p) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int is_upper : {0, 1})
      if (std::abs(p[axis] - is_upper) < 1e-9)
        return static_cast<int>(2 * axis) + is_upper;
  return -1;
}

/// The place in the texture of a point of a side of cube(): charts of side 1/4, 1/32 apart, in two
/// rows of three.
inline TexturePlace place_on_cube(int side, const Position& p) {
  const auto axis = static_cast<std::size_t>(side / 2);
  double x = p[(axis + 1) % 3], y = p[(axis + 2) % 3];
  if (side % 2 == 0)
    std::swap(x, y);
  return {{(side % 3) * 0.28125 + 0.25 * x, (side / 3) * 0.28125 + 0.25 * y}};
}

/// cube() with a chart for each side.
inline Textured textured_cube(int n) {
  const Soup soup = cube(n);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    return place_on_cube(side_of_cube(centre(soup, soup.triangles[t])), soup.points[v]);
  });
}

/// Every triangle cut into four.
inline Textured refined(const Textured& surface) {
  Textured result{{surface.soup.points, {}}, {}, {}};
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = midpoints.try_emplace(
        {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(result.soup.points.size()));
    if (is_new)
      result.soup.points.push_back(0.5 * (surface.soup.points[a] + surface.soup.points[b]));
    return found->second;
  };
  for (std::size_t t = 0; t < surface.labels.size(); ++t) {
    const auto [a, b, c] = surface.soup.triangles[t];
    const auto [p, q, r] = surface.texture[t];
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    const TexturePlace pq = 0.5 * (p + q), qr = 0.5 * (q + r), rp = 0.5 * (r + p);
    for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      result.soup.triangles.push_back(part);
    for (const auto& part : {std::array{p, pq, rp}, {pq, q, qr}, {rp, qr, r}, {pq, qr, rp}})
      result.texture.push_back(part);
    result.labels.insert(result.labels.end(), 4, surface.labels[t]);
  }
  return result;
}

inline Soup icosahedron() {
  const double g = std::numbers::phi;
  return {{{{-1, g, 0}},
           {{1, g, 0}},
           {{-1, -g, 0}},
           {{1, -g, 0}},
           {{0, -1, g}},
           {{0, 1, g}},
           {{0, -1, -g}},
           {{0, 1, -g}},
           {{g, 0, -1}},
           {{g, 0, 1}},
           {{-g, 0, -1}},
           {{-g, 0, 1}}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// A sphere of 20 · 4^levels faces with a chart for each side of an icosahedron.
inline Textured sphere_of_20_charts(int levels) {
  const Soup soup = icosahedron();
  Textured surface = textured(soup, [&](std::size_t t, std::uint32_t v) {
    const Triangle& corners = soup.triangles[t];
    const TexturePlace cell{{double(t % 5), double(t / 5)}};
    const TexturePlace corner{{v == corners[1] ? 0.75 : 0, v == corners[2] ? 0.75 : 0}};
    return cell + corner;
  });
  for (int level = 0; level < levels; ++level)
    surface = refined(surface);
  return with_points(surface, mapped(surface.soup, [](const Position& p) {
                       return 1 / std::sqrt(squared_length(p)) * p;
                     }));
}

/// The azimuthal map of a unit sphere about the pole at the upper end of an axis.
inline TexturePlace azimuthal(const Position& p, std::size_t axis) {
  const double x = p[(axis + 1) % 3], y = p[(axis + 2) % 3], off = std::hypot(x, y);
  const double r = std::atan2(off, p[axis]);
  return off > 0 ? TexturePlace{{r * x / off, r * y / off}} : TexturePlace{};
}

/// sphere() of two halves, x > 0 and x < 0, that have the same texture, of which one is turned
/// over. All is continuous.
inline Textured mirrored_sphere(int levels) {
  const Soup soup = sphere(levels);
  return textured(soup, [&](std::size_t, std::uint32_t v) {
    const Position& p = soup.points[v];
    return azimuthal({{std::abs(p[0]), p[1], p[2]}}, 0);
  });
}

/// sphere() of two labels and a chart for each. The border is the equator, up to a wave.
inline Textured two_materials(int levels, double wave) {
  const Soup soup = sphere(levels);
  const auto is_upper = [&](std::size_t t) {
    const Position p = centre(soup, soup.triangles[t]);
    return p[2] > wave * std::sin(3 * std::atan2(p[1], p[0]));
  };
  Textured surface = textured(soup, [&](std::size_t t, std::uint32_t v) {
    const Position& p = soup.points[v];
    return is_upper(t) ? azimuthal(p, 2)
                       : azimuthal({{p[0], -p[1], -p[2]}}, 2) + TexturePlace{{4, 0}};
  });
  for (std::size_t t = 0; t < surface.labels.size(); ++t)
    surface.labels[t] = is_upper(t);
  return surface;
}

/// A bumpy sheet of n × n squares, n a multiple of 4.
inline Soup bumpy_sheet(std::uint32_t n) {
  return mapped(grid(n, n), [](const Position& p) {
    return Position{{p[0], p[1], 0.1 * std::sin(4 * p[0]) * std::cos(5 * p[1])}};
  });
}

/// bumpy_sheet() that is cut in the texture along y = 1/2: by opening(x), wherever that is above 0.
template <class Opening>
Textured slit_sheet(std::uint32_t n, Opening opening) {
  const Soup soup = bumpy_sheet(n);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    const Position& p = soup.points[v];
    const bool is_above = centre(soup, soup.triangles[t])[1] > 0.5;
    return TexturePlace{{p[0], p[1] + (is_above ? std::max(0., opening(p[0])) : 0)}};
  });
}

/// A cut from the border, that ends inside.
inline Textured dart(std::uint32_t n) {
  return slit_sheet(n, [](double x) { return 0.5 * (0.5 - x); });
}
/// A cut both ends of which are inside.
inline Textured double_dart(std::uint32_t n) {
  return slit_sheet(n, [](double x) { return 0.5 * (0.25 - std::abs(x - 0.5)); });
}

/// A Möbius strip of around × across squares. The texture has a seam at one column; triangles are
/// not oriented alike on the two sides of column 0.
inline Textured moebius_strip(std::uint32_t around, std::uint32_t across, std::uint32_t seam) {
  Soup soup;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j <= across; ++j) {
      const double angle = 2 * std::numbers::pi * i / around;
      const double off = 0.8 * j / across - 0.4, r = 1 + off * std::cos(angle / 2);
      soup.points.push_back(
          {{r * std::cos(angle), r * std::sin(angle), off * std::sin(angle / 2)}});
    }
  CornerValues<2> texture;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const auto vertex = [&](std::uint32_t column, std::uint32_t row) {
        return column < around ? column * (across + 1) + row : across - row;
      };
      const auto place = [&](std::uint32_t column, std::uint32_t row) {
        const std::uint32_t k = (i + around - seam) % around + column - i;
        return TexturePlace{{double(k) / around, double(i < seam ? across - row : row) / across}};
      };
      const auto add = [&](auto... corners) {
        soup.triangles.push_back({vertex(corners.first, corners.second)...});
        texture.push_back({place(corners.first, corners.second)...});
      };
      add(std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1));
      add(std::pair(i, j), std::pair(i + 1, j + 1), std::pair(i, j + 1));
    }
  return {soup, texture, std::vector<int>(soup.triangles.size(), 0)};
}

/// Three bumpy pages of n × n squares with a spine in common. Their charts are `gap` apart: with 0
/// the texture is the same on all, and continuous across the spine.
inline Textured three_pages(std::uint32_t n, double gap) {
  Textured book;
  for (int page = 0; page < 3; ++page) {
    const double angle = 2 * std::numbers::pi * page / 3;
    const Soup sheet = grid(n, n);
    const auto offset = static_cast<std::uint32_t>(book.soup.points.size());
    for (const Position& p : sheet.points) {
      const double bump = 0.1 * p[0] * std::sin(5 * p[1]);
      book.soup.points.push_back({{p[0] * std::cos(angle) - bump * std::sin(angle),
                                   p[0] * std::sin(angle) + bump * std::cos(angle), p[1]}});
    }
    for (const Triangle& t : sheet.triangles) {
      book.soup.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
      std::array<TexturePlace, 3>& places = book.texture.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        places[i] = {{sheet.points[t[i]][0] + gap * page, sheet.points[t[i]][1]}};
      book.labels.push_back(0);
    }
  }
  book.soup = welded(mapped(book.soup, [](const Position& p) { // −0 and 0 are one place
    return p + Position{};
  }));
  return book;
}

/// Two sides of a roof, of n × n squares together, n even.
inline Soup roof(std::uint32_t n) {
  return mapped(grid(n, n), [](const Position& p) {
    return Position{{p[0], p[1], 0.25 - std::abs(p[0] - 0.5) / 2}};
  });
}

// --- Random values -------------------------------------------------------------------------------

/// Patches of triangles that are neighbours, about `count` of them: the number of each triangle.
inline std::vector<std::uint32_t> random_patches(const Soup& soup, std::uint64_t seed,
                                                 std::size_t count) {
  Random random(seed);
  std::vector<Position> seeds;
  for (std::size_t i = 0; i < count; ++i)
    seeds.push_back(soup.points[random.below(soup.points.size())]);
  std::vector<std::uint32_t> patches;
  for (const Triangle& t : soup.triangles) {
    const auto nearest = std::min_element(seeds.begin(), seeds.end(), [&](auto& p, auto& q) {
      return squared_distance(p, centre(soup, t)) < squared_distance(q, centre(soup, t));
    });
    patches.push_back(static_cast<std::uint32_t>(nearest - seeds.begin()));
  }
  return patches;
}

/// Each patch has its own place in the texture, or that of another patch. No edge is a seam at one
/// end only.
inline Textured random_charts(const Soup& soup, std::uint64_t seed) {
  Random random(seed);
  const auto patches = random_patches(soup, seed + 1, 12);
  std::vector<double> offsets;
  for (std::size_t i = 0; i < 12; ++i)
    offsets.push_back(2 * random.below(3));
  Textured surface = textured(soup, [&](std::size_t t, std::uint32_t v) {
    const Position& p = soup.points[v];
    return TexturePlace{{p[0] + 0.3 * p[2] + offsets[patches[t]], p[1] - 0.2 * p[2]}};
  });
  for (std::size_t t = 0; t < patches.size(); ++t)
    surface.labels[t] = patches[t] < 6 ? 0 : patches[t] < 9;
  return surface;
}

/// Every corner has one of few places, in no order.
inline Textured random_corners(const Soup& soup, std::uint64_t seed) {
  Random random(seed);
  Textured surface = textured(soup, [&](std::size_t, std::uint32_t v) {
    const double shift = random.below(6) == 0 ? 1 : 0;
    return TexturePlace{
        {soup.points[v][0] + shift, soup.points[v][1] + 2 * (random.below(6) == 0)}};
  });
  const auto patches = random_patches(soup, seed + 1, 5);
  for (std::size_t t = 0; t < patches.size(); ++t)
    surface.labels[t] = static_cast<int>(patches[t]);
  return surface;
}

} // namespace test

#endif // QUADRILLE_TEST_TEXTURED_H
