#include "soups.h"

namespace test {

Soup triangle() {
  return {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{0, 1, 2}}};
}

Soup two_triangles() {
  return {{{{0, 0, 0}}, {{1, 0, 0.25}}, {{1, 1, 0}}, {{0, 1, 0}}}, {{0, 1, 3}, {1, 2, 3}}};
}

Soup tetrahedron() {
  return {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

Soup octahedron() {
  return {{{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}, {{0, -1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Soup grid(std::uint32_t columns, std::uint32_t rows) {
  Soup soup;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      soup.points.push_back({{double(i) / columns, double(j) / rows, 0}});
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

Soup open_cylinder(std::uint32_t around, std::uint32_t along) {
  Soup soup;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      soup.points.push_back({{std::cos(angle), std::sin(angle), 2.0 * j / along}});
    }
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t next = (i + 1) % around;
      const std::uint32_t a = j * around + i, b = j * around + next;
      const std::uint32_t c = a + around, d = b + around;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

Soup uv_sphere(std::uint32_t meridians, std::uint32_t parallels) {
  Soup soup;
  soup.points.push_back({{0, 0, -1}});
  for (std::uint32_t j = 1; j < parallels; ++j)
    for (std::uint32_t i = 0; i < meridians; ++i) {
      const double u = 2 * std::numbers::pi * i / meridians;
      const double v = std::numbers::pi * j / parallels;
      soup.points.push_back({{std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v)}});
    }
  soup.points.push_back({{0, 0, 1}});
  const auto top = static_cast<std::uint32_t>(soup.points.size() - 1);
  for (std::uint32_t i = 0; i < meridians; ++i) {
    const std::uint32_t next = (i + 1) % meridians;
    soup.triangles.push_back({0, 1 + next, 1 + i});
    for (std::uint32_t j = 0; j + 2 < parallels; ++j) {
      const std::uint32_t a = 1 + j * meridians + i, b = 1 + j * meridians + next;
      const std::uint32_t c = a + meridians, d = b + meridians;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
    soup.triangles.push_back({top - meridians + i, top - meridians + next, top});
  }
  return soup;
}

Soup sphere(int levels) {
  Soup soup = octahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] = midpoints.try_emplace(
          {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(soup.points.size()));
      if (is_new) {
        const Position p = soup.points[a] + soup.points[b];
        soup.points.push_back(1 / std::sqrt(squared_length(p)) * p);
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : soup.triangles) {
      const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(t);
    }
    soup.triangles = std::move(finer);
  }
  return soup;
}

Soup torus(std::uint32_t around, std::uint32_t across) {
  Soup soup;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = 1 + 0.4 * std::cos(v);
      soup.points.push_back({{r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)}});
    }
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = i1 * across + j;
      const std::uint32_t c = i1 * across + j1, d = i * across + j1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

Soup cube(int n) {
  Soup soup = surface_of_cubes(n, n, n, [](int, int, int) { return true; });
  for (Position& p : soup.points)
    p *= 1.0 / n;
  return soup;
}

Soup plate_with_holes(int genus, int fineness) {
  const int n = fineness;
  Soup soup = surface_of_cubes((2 * genus + 1) * n, 3 * n, n,
                               [&](int x, int y, int) { return !(x / n % 2 == 1 && y / n == 1); });
  for (Position& p : soup.points)
    p *= 1.0 / n;
  return soup;
}

Soup with_noise(Soup soup, std::uint64_t seed, double amplitude) {
  Random random(seed);
  for (Position& p : soup.points)
    for (double& x : p.coordinates)
      x += random(-amplitude, amplitude);
  return soup;
}

Soup as_floats(Soup soup) {
  for (Position& p : soup.points)
    for (double& x : p.coordinates)
      x = static_cast<float>(x);
  return soup;
}

Soup tilted(const Soup& soup) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  return mapped(soup, [&](const Position& p) {
    const Position q{{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]}};
    return Position{{q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]}};
  });
}

Soup joined(Soup a, const Soup& b, const Position& d) {
  const auto offset = static_cast<std::uint32_t>(a.points.size());
  for (const Position& p : b.points)
    a.points.push_back(p + d);
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

bool is_identical(const Soup& a, const Soup& b) {
  return a.points == b.points && a.triangles == b.triangles;
}

Soup shuffled(Soup soup, std::uint64_t seed) {
  Random random(seed);
  const auto shuffle = [&](auto& values) {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[random.below(i)]);
  };
  std::vector<std::uint32_t> number(soup.points.size());
  std::iota(number.begin(), number.end(), 0);
  shuffle(number);
  Soup result = soup;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.points[number[v]] = soup.points[v];
  for (Triangle& t : result.triangles)
    for (std::uint32_t& v : t)
      v = number[v];
  shuffle(result.triangles);
  return result;
}

Soup without_isolated_points(const Soup& soup) {
  constexpr auto unused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(soup.points.size(), unused);
  for (const Triangle& t : soup.triangles)
    for (std::uint32_t v : t)
      number[v] = 0;
  Soup result;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (number[v] != unused) {
      number[v] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  for (const auto& [a, b, c] : soup.triangles)
    result.triangles.push_back({number[a], number[b], number[c]});
  return result;
}

} // namespace test

namespace test {
namespace detail {

bool is_path_or_cycle(const std::vector<std::array<std::uint32_t, 2>>& edges) {
  std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
  for (const auto& [p, q] : edges) {
    neighbours[p].insert(q);
    neighbours[q].insert(p);
  }
  std::size_t ends = 0;
  for (const auto& [v, around] : neighbours) {
    if (around.size() > 2)
      return false;
    ends += around.size() == 1;
  }
  std::set<std::uint32_t> reached;
  std::vector<std::uint32_t> next{edges.front()[0]};
  while (!next.empty()) {
    const std::uint32_t v = next.back();
    next.pop_back();
    if (reached.insert(v).second)
      next.insert(next.end(), neighbours[v].begin(), neighbours[v].end());
  }
  return reached.size() == neighbours.size() && ends <= 2;
}

} // namespace detail
} // namespace test

namespace test {

SoupTopology topology_of(const Soup& soup) {
  SoupTopology result;
  std::map<std::array<std::uint32_t, 2>, std::vector<bool>> edges; // is each face's side ascending?
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> links;
  std::set<Triangle> seen;
  detail::Partition parts(soup.points.size());
  for (const Triangle& t : soup.triangles) {
    const auto& [a, b, c] = t;
    if (a == b || b == c || c == a) {
      result.has_collapsed_faces = true;
      continue;
    }
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    result.has_duplicate_faces |= !seen.insert(sorted).second;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i], p = t[(i + 1) % 3], q = t[(i + 2) % 3];
      edges[{std::min(v, p), std::max(v, p)}].push_back(v < p);
      links[v].push_back({p, q});
      parts.merge(v, p);
    }
    ++result.faces;
  }
  result.vertices = links.size();
  result.edges = edges.size();
  for (const auto& [v, link] : links) {
    result.components += parts.root(v) == v;
    result.is_manifold &= detail::is_path_or_cycle(link);
  }
  detail::Partition loops(soup.points.size());
  std::set<std::uint32_t> on_boundary;
  for (const auto& [edge, sides] : edges) {
    result.is_manifold &= sides.size() <= 2;
    result.is_oriented &= sides.size() != 2 || sides[0] != sides[1];
    if (sides.size() != 1)
      continue;
    ++result.boundary_edges;
    loops.merge(edge[0], edge[1]);
    on_boundary.insert(edge.begin(), edge.end());
  }
  for (std::uint32_t v : on_boundary)
    result.boundary_loops += loops.root(v) == v;
  return result;
}

Position area_vector(const Soup& soup, const Triangle& t) {
  return 0.5 * double_area_vector(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
}

std::size_t count_degenerate_faces(const Soup& soup) {
  return static_cast<std::size_t>(
      std::count_if(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
        return !(squared_length(area_vector(soup, t)) > 0);
      }));
}

bool is_finite(const Soup& soup) {
  return std::all_of(soup.points.begin(), soup.points.end(),
                     [](const Position& p) { return quadrille::is_finite(p); });
}

double volume(const Soup& soup) {
  double sum = 0;
  for (const auto& [a, b, c] : soup.triangles)
    sum += dot(soup.points[a], cross(soup.points[b], soup.points[c])) / 6;
  return sum;
}

long double exact_volume(const Soup& soup) {
  long double sum = 0;
  const Position o = soup.points.front();
  const auto at = [&](std::uint32_t v) {
    return std::array{static_cast<long double>(soup.points[v][0]) - o[0],
                      static_cast<long double>(soup.points[v][1]) - o[1],
                      static_cast<long double>(soup.points[v][2]) - o[2]};
  };
  for (const auto& [i, j, k] : soup.triangles) {
    const auto a = at(i), b = at(j), c = at(k);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

double diagonal(const Soup& soup) {
  Position low = soup.points.front(), high = low;
  for (const Position& p : soup.points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return std::sqrt(squared_distance(low, high));
}

std::size_t count_fold_overs(const Soup& soup, double degrees) {
  std::map<std::array<std::uint32_t, 2>, std::vector<Position>> normals;
  for (const Triangle& t : soup.triangles) {
    const Position a = area_vector(soup, t);
    const double length = std::sqrt(squared_length(a));
    if (!(length > 0))
      continue;
    for (std::size_t i = 0; i < 3; ++i)
      normals[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}].push_back(
          1 / length * a);
  }
  const double limit = -std::cos(degrees * std::numbers::pi / 180);
  return static_cast<std::size_t>(std::count_if(normals.begin(), normals.end(), [&](const auto& e) {
    return e.second.size() == 2 && dot(e.second[0], e.second[1]) < limit;
  }));
}

Soup with_flipped_edges(Soup soup, std::uint64_t seed, int flips) {
  Random random(seed);
  const auto has_edge = [&](std::uint32_t v, std::uint32_t w) {
    return std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
      return std::count(t.begin(), t.end(), v) + std::count(t.begin(), t.end(), w) == 2;
    });
  };
  for (int flip = 0; flip < flips; ++flip) {
    Triangle& first = soup.triangles[random.below(soup.triangles.size())];
    const std::uint32_t k = random.below(3);
    const std::uint32_t a = first[k], b = first[(k + 1) % 3], c = first[(k + 2) % 3];
    for (Triangle& second : soup.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        if (second[i] != b || second[(i + 1) % 3] != a)
          continue;
        const std::uint32_t d = second[(i + 2) % 3];
        if (c == d || has_edge(c, d))
          break;
        first = {a, d, c};
        second = {d, b, c};
        break;
      }
  }
  return soup;
}

Soup random_closed(std::uint64_t seed) {
  const Soup base = seed % 3 == 0 ? sphere(2) : seed % 3 == 1 ? torus(9, 7) : plate_with_holes(2);
  return with_noise(with_flipped_edges(base, seed, 40), seed + 1000, 0.1);
}

Soup with_holes(Soup soup, std::uint64_t seed, int count) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const auto at = soup.triangles.begin() + random.below(soup.triangles.size());
    const Triangle taken = *at;
    *at = soup.triangles.back();
    soup.triangles.pop_back();
    if (!topology_of(soup).is_manifold)
      soup.triangles.push_back(taken);
  }
  return without_isolated_points(soup);
}

Soup random_with_boundaries(std::uint64_t seed) {
  if (seed % 2 == 0)
    return with_holes(random_closed(seed), seed, 25);
  return with_holes(with_noise(with_flipped_edges(grid(9, 8), seed, 30), seed, 0.03), seed, 12);
}

} // namespace test
