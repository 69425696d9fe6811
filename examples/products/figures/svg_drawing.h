#ifndef QUADRILLE_EXAMPLES_SVG_DRAWING_H
#define QUADRILLE_EXAMPLES_SVG_DRAWING_H

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

/// \file
/// A picture of meshes in rows, as one SVG file, which any browser shows.

namespace quadrille_examples {

/// Meshes are seen along the shortest side of the first one of their row, with its faces and their
/// edges; those that look away are left out, and the farthest are drawn first.
template <class Mesh>
class SvgDrawing {
public:
  void begin_row() { rows_.emplace_back(); }
  void add(const Mesh& mesh, std::string title) {
    rows_.back().push_back({mesh, std::move(title)});
  }

  /// Throws nothing; false if the file cannot be written.
  bool write(const std::string& path) const {
    std::size_t columns = 0;
    for (const auto& row : rows_)
      columns = (std::max)(columns, row.size());
    std::ofstream out(path);
    out.precision(4);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << side * columns << ' '
        << side * rows_.size() << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<style>path { stroke: #345; stroke-width: 0.25; stroke-linejoin: round }</style>\n";
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t column = 0; column < rows_[row].size(); ++column)
        write_drawing(out, rows_[row][column], View(rows_[row].front().mesh), side * column,
                      side * row);
    out << "</svg>\n";
    return static_cast<bool>(out.flush());
  }

private:
  static constexpr std::size_t side = 240; // of a drawing
  using Place = std::array<double, 3>;     // to the right, down, towards the eye

  struct Drawing {
    Mesh mesh;
    std::string title;
  };

  static double coordinate(const Mesh& mesh, auto v, std::size_t k) {
    return mesh.point(v)[static_cast<int>(k)];
  }

  /// Which axes of a mesh go where, and the scale.
  struct View {
    std::array<std::size_t, 3> axes{0, 1, 2};
    Place low, high;
    double scale;

    explicit View(const Mesh& mesh) {
      low.fill(1e300);
      high.fill(-1e300);
      for (const auto v : mesh.vertices())
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = (std::min)(low[k], coordinate(mesh, v, k));
          high[k] = (std::max)(high[k], coordinate(mesh, v, k));
        }
      const auto extent = [&](std::size_t k) { return high[k] - low[k]; };
      const auto depth = std::min_element(axes.begin(), axes.end(),
                                          [&](auto a, auto b) { return extent(a) < extent(b); });
      std::rotate(depth, depth + 1, axes.end()); // the shortest one last
      scale = 0.85 * side / (std::max)(extent(axes[0]), extent(axes[1]));
    }

    Place of(const Mesh& mesh, auto v) const {
      const auto from_middle = [&](std::size_t k) {
        return scale * (coordinate(mesh, v, k) - (low[k] + high[k]) / 2);
      };
      const bool is_mirrored = axes[2] == 1; // x, z to the right and up see from the front
      return {from_middle(axes[0]), -from_middle(axes[1]),
              (is_mirrored ? -1 : 1) * from_middle(axes[2])};
    }
  };

  /// A face as it is drawn.
  struct Shape {
    std::array<Place, 3> corners;
    double light;
    double depth() const { return corners[0][2] + corners[1][2] + corners[2][2]; }
  };

  static std::vector<Shape> shapes_of(const Mesh& mesh, const View& view) {
    std::vector<Shape> shapes;
    for (const auto f : mesh.faces()) {
      Shape shape{};
      std::size_t i = 0;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        shape.corners[i++] = view.of(mesh, v);
      const auto& [a, b, c] = shape.corners;
      const Place n{(b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                    (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])};
      const double length = std::hypot(n[0], n[1], n[2]);
      if (!(n[2] < 0)) // y points down, so what looks at the eye runs the other way round
        continue;
      shape.light = (0.4 * n[0] + 0.5 * n[1] - 0.75 * n[2]) / length;
      shapes.push_back(shape);
    }
    std::sort(shapes.begin(), shapes.end(),
              [](const Shape& a, const Shape& b) { return a.depth() < b.depth(); });
    return shapes;
  }

  static void write_drawing(std::ostream& out, const Drawing& drawing, const View& view,
                            std::size_t x, std::size_t y) {
    out << "<g transform=\"translate(" << x + side / 2 << ' ' << y + side / 2 << ")\">\n";
    for (const Shape& shape : shapes_of(drawing.mesh, view)) {
      const int grey = 60 + static_cast<int>(190 * (std::clamp)(shape.light, 0.0, 1.0));
      out << "<path fill=\"rgb(" << grey << ' ' << grey << ' ' << grey << ")\" d=\"M";
      for (const Place& corner : shape.corners)
        out << corner[0] << ' ' << corner[1] << ' ';
      out << "z\"/>\n";
    }
    out << "<text y=\"" << side / 2 - 6 << "\" text-anchor=\"middle\">" << drawing.title
        << "</text>\n</g>\n";
  }

  std::vector<std::vector<Drawing>> rows_;
};

} // namespace quadrille_examples

#endif
