// SPDX-License-Identifier: MIT

#include "model.h"

#include "../../examples/products/mesh_io/mesh_io.h"

#include <quadrille/distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

namespace bench {
namespace {

/// Numbers things in the order in which they come.
template <class Thing>
class Numbers {
public:
  std::uint32_t operator()(const Thing& thing) {
    return numbers_.try_emplace(thing, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }
  std::size_t size() const { return numbers_.size(); }

private:
  std::map<Thing, std::uint32_t> numbers_;
};

/// A value as it is compared.
std::vector<double> value(const Attributes& attributes, std::size_t i) {
  const auto first =
      attributes.values.begin() + static_cast<std::ptrdiff_t>(i * attributes.components);
  return {first, first + static_cast<std::ptrdiff_t>(attributes.components)};
}

/// Two of the coordinates, or three of the colours, of a file.
Attributes attributes_of(const quadrille_examples::IndexedMesh& mesh, Kind kind) {
  Attributes attributes{
      .components = kind == Kind::texture ? 2u : 3u, .values = {}, .triangles = mesh.triangles};
  if (kind == Kind::texture)
    for (const auto& [u, v] : mesh.texture_coordinates)
      attributes.values.insert(attributes.values.end(), {u, v});
  else
    for (const auto& color : mesh.colors)
      for (std::size_t i = 0; i < 3; ++i)
        attributes.values.push_back(color[i] / mesh.color_type.full);
  return attributes;
}

double area(const Soup& soup) {
  double sum = 0;
  for (const auto& [a, b, c] : soup.triangles)
    sum += std::sqrt(
        Kernel::Triangle_3(soup.points[a], soup.points[b], soup.points[c]).squared_area());
  return sum;
}

double texture_area(const Attributes& attributes) {
  double sum = 0;
  for (const auto& [a, b, c] : attributes.triangles) {
    const auto at = [&](std::uint32_t i, std::size_t j) { return attributes.values[2 * i + j]; };
    sum += std::abs((at(b, 0) - at(a, 0)) * (at(c, 1) - at(a, 1)) -
                    (at(b, 1) - at(a, 1)) * (at(c, 0) - at(a, 0))) /
           2;
  }
  return sum;
}

double largest_range(const Attributes& attributes) {
  double largest = 0;
  for (std::size_t c = 0; c < attributes.components; ++c) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      const double x = attributes.values[i * attributes.components + c];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

} // namespace

Model read_model(const std::string& file) {
  const quadrille_examples::IndexedMesh mesh = quadrille_examples::read_mesh(file);
  if (mesh.texture_coordinates.empty() && mesh.colors.empty())
    throw std::runtime_error("has neither colours nor texture coordinates");
  const Kind kind = mesh.texture_coordinates.empty() ? Kind::color : Kind::texture;
  Model model{kind, {mesh.points, mesh.triangles, attributes_of(mesh, kind)}};
  weld_points(model.soup);
  return model;
}

Model sphere(Kind kind) {
  constexpr std::uint32_t meridians = 32, parallels = 21;
  Model model{kind, {}};
  Attributes& attributes = model.soup.attributes;
  attributes.components = kind == Kind::texture ? 2 : 3;
  for (std::uint32_t j = 0; j <= parallels; ++j)
    for (std::uint32_t i = 0; i <= meridians; ++i) {
      const double u = double(i) / meridians, v = double(j) / parallels;
      const double side = std::sin(v * std::numbers::pi);
      const double angle = 2 * std::numbers::pi * (i % meridians) / meridians;
      const bool is_pole = j % parallels == 0;
      const Point p(is_pole ? 0 : side * std::cos(angle), is_pole ? 0 : side * std::sin(angle),
                    std::cos(v * std::numbers::pi));
      model.soup.points.push_back(p);
      if (kind == Kind::texture)
        attributes.values.insert(attributes.values.end(), {u, v});
      else
        attributes.values.insert(attributes.values.end(),
                                 {(1 + p.x()) / 2, (1 + p.y()) / 2, (1 + p.z()) / 2});
    }
  for (std::uint32_t j = 0; j < parallels; ++j)
    for (std::uint32_t i = 0; i < meridians; ++i) {
      const std::uint32_t a = j * (meridians + 1) + i, b = a + 1, c = a + meridians + 1, d = c + 1;
      model.soup.triangles.push_back({a, c, d});
      model.soup.triangles.push_back({a, d, b});
    }
  attributes.triangles = model.soup.triangles;
  weld_points(model.soup);
  return model;
}

double default_weight(const Model& model) {
  const Attributes& attributes = model.soup.attributes;
  if (model.kind == Kind::texture)
    return std::sqrt(area(model.soup) / texture_area(attributes));
  return 0.02 * quadrille::bounding_box_diagonal(model.soup.points) / largest_range(attributes);
}

void split_points(Soup& soup) {
  Numbers<std::array<std::uint32_t, 2>> numbers;
  Soup split;
  split.attributes.components = soup.attributes.components;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    split.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = soup.triangles[t][i], q = soup.attributes.triangles[t][i];
      split.triangles.back()[i] = numbers({p, q});
      if (numbers.size() == split.points.size())
        continue;
      split.points.push_back(soup.points[p]);
      const std::vector<double> components = value(soup.attributes, q);
      split.attributes.values.insert(split.attributes.values.end(), components.begin(),
                                     components.end());
    }
  }
  split.attributes.triangles = split.triangles;
  soup = std::move(split);
}

void drop_unused_points(Soup& soup) {
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(soup.points.size(), unused);
  Soup used;
  const std::size_t m = used.attributes.components = soup.attributes.components;
  for (auto& t : soup.triangles)
    for (std::uint32_t& p : t) {
      if (number[p] == unused) {
        number[p] = static_cast<std::uint32_t>(used.points.size());
        used.points.push_back(soup.points[p]);
        const auto first = soup.attributes.values.begin() + static_cast<std::ptrdiff_t>(m * p);
        used.attributes.values.insert(used.attributes.values.end(), first,
                                      first + static_cast<std::ptrdiff_t>(m));
      }
      p = number[p];
    }
  used.triangles = std::move(soup.triangles);
  used.attributes.triangles = used.triangles;
  soup = std::move(used);
}

void weld_points(Soup& soup) {
  Numbers<Point> places;
  Numbers<std::vector<double>> values;
  Soup welded;
  welded.attributes.components = soup.attributes.components;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{}, corner_values{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = soup.points[soup.triangles[t][i]];
      corners[i] = places(p);
      if (places.size() > welded.points.size())
        welded.points.push_back(p);
      const std::vector<double> q = value(soup.attributes, soup.attributes.triangles[t][i]);
      corner_values[i] = values(q);
      if (values.size() > welded.attributes.size())
        welded.attributes.values.insert(welded.attributes.values.end(), q.begin(), q.end());
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      continue;
    welded.triangles.push_back(corners);
    welded.attributes.triangles.push_back(corner_values);
  }
  soup = std::move(welded);
}

} // namespace bench
