// SPDX-License-Identifier: MIT

#include "measure.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bench {
namespace {

using Triangle = Kernel::Triangle_3;

/// Triangles in space, with values at their corners.
class Field {
public:
  explicit Field(const Soup& soup) : attributes_(soup.attributes) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      const auto& [a, b, c] = soup.triangles[t];
      const Triangle triangle(soup.points[a], soup.points[b], soup.points[c]);
      if (triangle.is_degenerate())
        continue;
      triangles_.push_back(triangle);
      corners_.push_back(soup.attributes.triangles[t]);
    }
    tree_.rebuild(triangles_.begin(), triangles_.end());
  }
  Field(const Field&) = delete;

  /// The mean over places that are spread evenly, and over components, of the squared difference
  /// to the nearest place of another field.
  double mean_squared_difference(const Field& other, std::size_t samples) const {
    double all = 0, passed = 0, sum = 0;
    for (const Triangle& t : triangles_)
      all += std::sqrt(t.squared_area());
    std::size_t taken = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      passed += std::sqrt(triangles_[t].squared_area()) / all;
      for (; static_cast<double>(taken) < passed * static_cast<double>(samples); ++taken)
        sum += squared_difference(t, sample(taken), other);
    }
    return taken > 0 ? sum / static_cast<double>(taken * attributes_.components) : 0;
  }

private:
  using Weights = std::array<double, 3>;
  using Iterator = std::vector<Triangle>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;

  // A sequence that fills the square evenly, folded to a triangle (Roberts 2018).
  static Weights sample(std::size_t n) {
    const double number = static_cast<double>(n) + 0.5;
    double u = std::fmod(number * 0.7548776662466927, 1.0);
    double v = std::fmod(number * 0.5698402909980532, 1.0);
    if (u + v > 1)
      u = 1 - u, v = 1 - v;
    return {1 - u - v, u, v};
  }

  double squared_difference(std::size_t t, const Weights& weights, const Field& other) const {
    const Triangle& triangle = triangles_[t];
    const Point p =
        CGAL::barycenter(triangle[0], weights[0], triangle[1], weights[1], triangle[2], weights[2]);
    const auto [q, found] = other.tree_.closest_point_and_primitive(p);
    const auto face = static_cast<std::size_t>(found - other.triangles_.begin());
    const Weights there = other.weights(face, q);
    double sum = 0;
    for (std::size_t c = 0; c < attributes_.components; ++c) {
      const double off = value(t, weights, c) - other.value(face, there, c);
      sum += off * off;
    }
    return sum;
  }

  double value(std::size_t t, const Weights& weights, std::size_t c) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += weights[i] * attributes_.values[corners_[t][i] * attributes_.components + c];
    return sum;
  }

  // Of a point of the triangle, by area.
  Weights weights(std::size_t face, const Point& p) const {
    const Triangle& t = triangles_[face];
    const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    const auto part = [&](const Point& a, const Point& b) {
      return std::clamp(normal * CGAL::cross_product(b - a, p - a) / normal.squared_length(), 0.0,
                        1.0);
    };
    const double first = part(t[1], t[2]), second = std::min(part(t[2], t[0]), 1 - first);
    return {first, second, 1 - first - second};
  }

  const Attributes& attributes_;
  std::vector<Triangle> triangles_;
  Triangles corners_; // values of each
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

ColorDifference color_difference(const Soup& input, const Soup& answer, std::size_t samples) {
  const Field a(input), b(answer);
  const double in_to_out = a.mean_squared_difference(b, samples);
  const double out_to_in = b.mean_squared_difference(a, samples);
  return {std::sqrt((in_to_out + out_to_in) / 2), std::sqrt(in_to_out), std::sqrt(out_to_in)};
}

template <class Position>
quadrille::TriangleSoup<Position> triangles_between(std::vector<Position> points,
                                                    const Triangles& triangles) {
  quadrille::TriangleSoup<Position> result{std::move(points), {}};
  for (const auto& [a, b, c] : triangles)
    result.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                static_cast<std::uint32_t>(c)});
  return result;
}

quadrille::TriangleSoup<> shape_of(const Soup& soup) {
  std::vector<quadrille::Vector<3>> points;
  for (const Point& p : soup.points)
    points.push_back({{p.x(), p.y(), p.z()}});
  return triangles_between(std::move(points), soup.triangles);
}

quadrille::TexturedSoup textured(const Soup& soup) {
  std::vector<quadrille::Vector<2>> coordinates;
  for (std::size_t i = 0; i < soup.attributes.size(); ++i)
    coordinates.push_back({{soup.attributes.values[2 * i], soup.attributes.values[2 * i + 1]}});
  return {shape_of(soup), triangles_between(std::move(coordinates), soup.attributes.triangles), {}};
}

} // namespace

std::size_t open_edges(const Soup& soup) {
  return quadrille::count_torn_edges(shape_of(soup));
}

AttributeQuality measure(const Model& input, const Soup& answer, std::size_t samples) {
  AttributeQuality quality{.faces = answer.triangles.size(),
                           .open_edges = open_edges(answer),
                           .distance = quadrille::surface_distance(
                               input.soup.points, input.soup.triangles, answer.points,
                               answer.triangles, {.samples = samples}),
                           .texture = {},
                           .color = {}};
  if (input.kind == Kind::texture)
    quality.texture = quadrille::texture_deviation(textured(answer), textured(input.soup), samples);
  else
    quality.color = color_difference(input.soup, answer, samples);
  const double diagonal = quadrille::bounding_box_diagonal(input.soup.points);
  quadrille::SurfaceDistance& d = quality.distance;
  quadrille::TextureDeviation& t = quality.texture;
  for (double* length : {&d.rms, &d.hausdorff, &d.rms_a_to_b, &d.rms_b_to_a, &d.hausdorff_a_to_b,
                         &d.hausdorff_b_to_a, &t.rms, &t.greatest, &t.percentile_99})
    *length /= diagonal;
  return quality;
}

double score(const AttributeQuality& quality, Kind kind) {
  if (kind == Kind::texture)
    return quality.texture.rms; // which counts both where a surface lies and what it shows there
  return quality.distance.rms * quality.color.rms;
}

} // namespace bench
