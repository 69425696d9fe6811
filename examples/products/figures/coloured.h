#ifndef QUADRILLE_EXAMPLES_FIGURES_COLOURED_H
#define QUADRILLE_EXAMPLES_FIGURES_COLOURED_H

#include "generate.h"
#include "surfaces.h"

#include <quadrille/quadric_form.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Coloured surfaces for the figures.

namespace figures {

using Color = CGAL::IO::Color;
using ColorMap = Mesh::Property_map<Vertex, Color>;
using Vector3 = Kernel::Vector_3;

/// The colours of a mesh; they are made when they are first asked for. CGAL writes them to PLY.
inline ColorMap colors(Mesh& mesh) {
  return mesh.add_property_map<Vertex, Color>("v:color").first;
}
inline ColorMap colors(const Mesh& mesh) {
  return mesh.property_map<Vertex, Color>("v:color").first;
}

/// Red, green and blue from 0 to 1, what is beyond clamped.
inline Color color_of(const quadrille::Vector<3>& rgb) {
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(rgb[i], 0.0, 1.0)));
  };
  return Color(byte(0), byte(1), byte(2));
}

/// A globe of 18,000 faces with relief, and seas and lands that meet at sharp shores.
inline Mesh globe() {
  const auto height = [](const Point& d) {
    return std::sin(2.1 * d.x() + 1.3 * d.z() + 0.4) + std::sin(2.7 * d.y() - 1.9 * d.x()) +
           std::sin(3.1 * d.z() + 1.1 * d.y() + 2.0) - 0.3;
  };
  Mesh mesh = ball(100, 91, [&](const Point& d) {
    const double ripple = std::sin(9 * d.x()) * std::sin(8 * d.y() + 1) * std::sin(10 * d.z());
    return 1 + 0.06 * std::max(0.0, height(d)) + 0.03 * ripple;
  });
  ColorMap color = colors(mesh);
  for (const Vertex v : mesh.vertices()) {
    const Vector3 d = mesh.point(v) - CGAL::ORIGIN;
    const double h = height(CGAL::ORIGIN + d / std::sqrt(d.squared_length()));
    color[v] = h < 0 ? Color(30, 70, 160) : h < 1.2 ? Color(90, 150, 60) : Color(235, 230, 220);
  }
  return mesh;
}

/// A room of 73,728 faces, lit by a square lamp in the ceiling: a tiled floor of 128 × 128 squares,
/// four walls of 64 × 64, a ceiling of 32 × 32, and two boxes with six sides of 16 × 16. The
/// surfaces do not share vertices: where they meet, the light is not the same on both sides.
class Room {
public:
  static Mesh make() { return Room().mesh_; }

private:
  struct Box {
    Point low, high;
  };

  static constexpr double width = 6, depth = 5, height = 3;
  static inline const std::array<Box, 2> boxes = {
      Box{Point(1.2, 1.4, 0.9), Point(3.4, 2.8, 1.1)},  // the top of a table
      Box{Point(4.4, 3.4, 0.0), Point(5.4, 4.6, 1.5)}}; // a cupboard

  Room() {
    const Point o(0, 0, 0);
    const Vector3 x(width, 0, 0), y(0, depth, 0), z(0, 0, height);
    const quadrille::Vector<3> white{{0.85, 0.85, 0.8}}, red{{0.75, 0.2, 0.15}},
        green{{0.2, 0.5, 0.25}}, wood{{0.7, 0.5, 0.3}}, dark{{0.3, 0.35, 0.45}};
    add(128, o, x, y, [&](const Point& p) { return is_dark_tile(p) ? dark : white; });
    const auto plain = [](const quadrille::Vector<3>& paint) {
      return [paint](const Point&) { return paint; };
    };
    add(64, o, y, z, plain(red));
    add(64, o + x, z, y, plain(green));
    add(64, o, z, x, plain(white));
    add(64, o + y, x, z, plain(white));
    add(32, o + z, y, x, plain(white));
    for (const Box& box : boxes) {
      const Vector3 size = box.high - box.low;
      const Vector3 a(size.x(), 0, 0), b(0, size.y(), 0), c(0, 0, size.z());
      const std::array<std::array<Vector3, 2>, 3> sides = {{{a, b}, {b, c}, {c, a}}};
      for (const auto& [s, t] : sides) {
        add(16, box.low, t, s, plain(wood));
        add(16, box.high, -s, -t, plain(wood));
      }
    }
  }

  // A square patch on `corner`; it looks to the side from which s turns left to t.
  void add(std::size_t squares, const Point& corner, const Vector3& s, const Vector3& t,
           const auto& paint) {
    const Vector3 cross = CGAL::cross_product(s, t);
    const Vector3 normal = cross / std::sqrt(cross.squared_length());
    const auto vertices = add_grid(mesh_, squares, squares,
                                   [&](double u, double v) { return corner + u * s + v * t; });
    ColorMap color = colors(mesh_);
    for (const Vertex v : vertices)
      color[v] = color_of(light(mesh_.point(v), normal) * paint(mesh_.point(v)));
  }

  static bool is_dark_tile(const Point& p) {
    return (static_cast<int>(8 * p.x() / width) + static_cast<int>(8 * p.y() / depth)) % 2 == 1;
  }

  // From the lamp, by 5 × 5 points of it, and a little from everywhere.
  static double light(const Point& p, const Vector3& normal) {
    double sum = 0;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        const Point lamp(2.5 + 0.25 * i, 2.0 + 0.25 * j, height - 0.01);
        const Vector3 ray = lamp - p;
        const double squared = ray.squared_length();
        const double facing = (ray * normal) * ray.z() / (squared * squared);
        if (facing > 0 && !is_hidden(p + 1e-3 * normal, lamp))
          sum += facing;
      }
    return 0.15 + 0.2 * sum;
  }

  static bool is_hidden(const Point& p, const Point& lamp) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
      double from = 0, to = 1; // of the segment, the part that is inside the box
      for (int i = 0; i < 3; ++i) {
        const double step = lamp[i] - p[i];
        const double enter = (box.low[i] - p[i]) / step, leave = (box.high[i] - p[i]) / step;
        if (step == 0 && (p[i] < box.low[i] || p[i] > box.high[i]))
          return false;
        if (step == 0)
          continue;
        from = std::max(from, std::min(enter, leave));
        to = std::min(to, std::max(enter, leave));
      }
      return from < to;
    });
  }

  Mesh mesh_;
};

} // namespace figures

#endif
