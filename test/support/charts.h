#ifndef QUADRILLE_TEST_CHARTS_H
#define QUADRILLE_TEST_CHARTS_H

#include "soups.h"
#include "textured.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

/// \file
/// What can be said of the charts of a texture, by plain maps over the values at corners: nothing
/// of the engine.
///
/// A seam is an edge of other than two faces, of two labels, with other places in the texture at
/// both of its ends, or along which the texture is folded.

namespace test {

/// A face at an edge: its corners at the lower and the upper vertex of the edge, and its third one.
struct EdgeSide {
  std::size_t face, lower, upper, third;
};
using Edge = std::array<std::uint32_t, 2>;
using EdgeSides = std::map<Edge, std::vector<EdgeSide>>;

inline EdgeSides sides_of_edges(const Soup& soup) {
  EdgeSides result;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const std::uint32_t v = soup.triangles[f][i], w = soup.triangles[f][j];
      if (v < w)
        result[{v, w}].push_back({f, i, j, k});
      else
        result[{w, v}].push_back({f, j, i, k});
    }
  return result;
}

/// At how many ends of an edge of two faces do the values differ?
template <std::size_t N>
std::size_t jumps(const CornerValues<N>& values, const std::vector<EdgeSide>& sides) {
  const auto& [a, b] = std::pair(sides[0], sides[1]);
  return std::size_t{!(values[a.face][a.lower] == values[b.face][b.lower])} +
         std::size_t{!(values[a.face][a.upper] == values[b.face][b.upper])};
}

/// How many edges of two faces have other values at just so many of their ends, 1 or 2.
template <std::size_t N>
std::size_t count_jumps(const Soup& soup, const CornerValues<N>& values, std::size_t ends) {
  std::size_t count = 0;
  for (const auto& [edge, sides] : sides_of_edges(soup))
    count += sides.size() == 2 && jumps(values, sides) == ends;
  return count;
}

// --- The texture of a triangle -------------------------------------------------------------------

inline double double_area(const TexturePlace& a, const TexturePlace& b, const TexturePlace& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// In the texture, negative if the triangle is turned over.
inline double texture_area(const std::array<TexturePlace, 3>& t) {
  return double_area(t[0], t[1], t[2]) / 2;
}
inline double texture_area(const Textured& surface) {
  double area = 0;
  for (const auto& triangle : surface.texture)
    area += std::abs(texture_area(triangle));
  return area;
}
inline std::size_t count_turned(const Textured& surface) {
  return static_cast<std::size_t>(std::count_if(surface.texture.begin(), surface.texture.end(),
                                                [](auto& t) { return texture_area(t) < 0; }));
}

inline bool is_finite(const Textured& surface) {
  const auto is_finite_place = [](const TexturePlace& q) { return quadrille::is_finite(q); };
  return is_finite(surface.soup) &&
         std::all_of(surface.texture.begin(), surface.texture.end(), [&](const auto& triangle) {
           return std::all_of(triangle.begin(), triangle.end(), is_finite_place);
         });
}

/// Do the two faces of an edge lie on the same side of it in the texture?
inline bool is_folded(const Textured& surface, const std::vector<EdgeSide>& sides) {
  std::array<double, 2> areas;
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& triangle = surface.texture[sides[s].face];
    areas[s] =
        double_area(triangle[sides[s].lower], triangle[sides[s].upper], triangle[sides[s].third]);
  }
  return (areas[0] > 0 && areas[1] > 0) || (areas[0] < 0 && areas[1] < 0);
}

inline bool is_seam(const Textured& surface, const std::vector<EdgeSide>& sides) {
  return sides.size() != 2 || surface.labels[sides[0].face] != surface.labels[sides[1].face] ||
         jumps(surface.texture, sides) == 2 || is_folded(surface, sides);
}

inline std::vector<Edge> seams_of(const Textured& surface) {
  std::vector<Edge> seams;
  for (const auto& [edge, sides] : sides_of_edges(surface.soup))
    if (is_seam(surface, sides))
      seams.push_back(edge);
  return seams;
}

// --- The pattern of charts -----------------------------------------------------------------------

/// What must not change where seams are kept.
struct ChartPattern {
  using Place = std::array<double, 3>;

  struct Chart {
    int label = 0;
    int turned = 0; ///< 1 if all faces are turned over in the texture, −1 if none is, else 0
    long euler = 0; ///< of the chart, cut along its seams
    friend auto operator<=>(const Chart&, const Chart&) = default;
  };
  /// Seams from a corner to a corner. The lower place is first.
  using Arc = std::array<Place, 2>;

  std::vector<Chart> charts;  ///< in ascending order
  std::vector<Place> corners; ///< vertices of seams other than two, in ascending order
  std::vector<Arc> arcs;      ///< in ascending order
  std::size_t loops = 0;      ///< circles of seams without a corner

  friend bool operator==(const ChartPattern&, const ChartPattern&) = default;
  friend std::ostream& operator<<(std::ostream& out, const ChartPattern& p) {
    out << p.charts.size() << " charts:";
    for (const Chart& chart : p.charts)
      out << " (label " << chart.label << ", turned " << chart.turned << ", Euler " << chart.euler
          << ')';
    return out << ", " << p.corners.size() << " corners, " << p.arcs.size() << " arcs, " << p.loops
               << " loops";
  }
};

namespace detail {

/// The pattern of the seams by themselves.
class SeamGraph {
public:
  SeamGraph(const Soup& soup, const std::vector<Edge>& seams) : soup_(soup) {
    for (const auto& [v, w] : seams) {
      neighbours_[v].insert(w);
      neighbours_[w].insert(v);
    }
  }

  void describe(ChartPattern& pattern) {
    for (const auto& [v, others] : neighbours_)
      if (others.size() != 2) {
        pattern.corners.push_back(place(v));
        for (std::uint32_t w : others)
          add_arc(v, w, pattern);
      }
    for (const auto& [v, others] : neighbours_)
      if (others.size() == 2 && !passed_.contains(v)) {
        ++pattern.loops;
        walk(v, *others.begin(), v);
      }
    std::sort(pattern.corners.begin(), pattern.corners.end());
    std::sort(pattern.arcs.begin(), pattern.arcs.end());
  }

private:
  ChartPattern::Place place(std::uint32_t v) const { return soup_.points[v].coordinates; }

  // The corner that is reached from v by way of w, or `end`; and the last vertex before it.
  std::pair<std::uint32_t, std::uint32_t> walk(std::uint32_t v, std::uint32_t w,
                                               std::uint32_t end) {
    while (w != end && neighbours_.at(w).size() == 2) {
      passed_.insert(w);
      const auto& others = neighbours_.at(w);
      const std::uint32_t next = *others.begin() == v ? *others.rbegin() : *others.begin();
      v = std::exchange(w, next);
    }
    passed_.insert(w);
    return {w, v};
  }

  // Each arc is found from both of its ends, and taken from the lower one.
  void add_arc(std::uint32_t v, std::uint32_t w, ChartPattern& pattern) {
    const auto [end, before] = walk(v, w, v);
    if (std::pair(v, w) <= std::pair(end, before))
      pattern.arcs.push_back({std::min(place(v), place(end)), std::max(place(v), place(end))});
  }

  const Soup& soup_;
  std::map<std::uint32_t, std::set<std::uint32_t>> neighbours_;
  std::set<std::uint32_t> passed_;
};

} // namespace detail

/// The faces of each chart.
inline std::vector<std::vector<std::size_t>> faces_of_charts(const Textured& surface) {
  detail::Partition parts(surface.soup.triangles.size());
  for (const auto& [edge, sides] : sides_of_edges(surface.soup))
    if (!is_seam(surface, sides))
      parts.merge(static_cast<std::uint32_t>(sides[0].face),
                  static_cast<std::uint32_t>(sides[1].face));
  std::map<std::uint32_t, std::vector<std::size_t>> faces;
  for (std::uint32_t f = 0; f < surface.soup.triangles.size(); ++f)
    faces[parts.root(f)].push_back(f);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [root, list] : faces)
    result.push_back(std::move(list));
  return result;
}

/// Corners are one vertex of a surface that is cut along its seams, if edges that are none connect
/// them: the number of the vertex of corner i of face f is at 3 f + i.
inline std::vector<std::uint32_t> cut_vertices(const Textured& surface) {
  detail::Partition parts(3 * surface.soup.triangles.size());
  for (const auto& [edge, sides] : sides_of_edges(surface.soup))
    if (!is_seam(surface, sides)) {
      const EdgeSide &one = sides[0], &two = sides[1];
      const auto corner = [](std::size_t face, std::size_t i) {
        return static_cast<std::uint32_t>(3 * face + i);
      };
      parts.merge(corner(one.face, one.lower), corner(two.face, two.lower));
      parts.merge(corner(one.face, one.upper), corner(two.face, two.upper));
    }
  std::vector<std::uint32_t> result;
  for (std::uint32_t corner = 0; corner < 3 * surface.soup.triangles.size(); ++corner)
    result.push_back(parts.root(corner));
  return result;
}

inline ChartPattern pattern_of(const Textured& surface) {
  ChartPattern pattern;
  const std::vector<std::uint32_t> vertex = cut_vertices(surface);
  std::vector<std::size_t> sides_inside(surface.labels.size()); // of a face, those that are no seam
  for (const auto& [edge, sides] : sides_of_edges(surface.soup))
    if (!is_seam(surface, sides))
      for (const EdgeSide& side : sides)
        ++sides_inside[side.face];
  for (const auto& faces : faces_of_charts(surface)) {
    std::set<std::uint32_t> vertices;
    std::size_t inside = 0, turned = 0, upright = 0;
    for (std::size_t f : faces) {
      vertices.insert(&vertex[3 * f], &vertex[3 * f] + 3);
      inside += sides_inside[f];
      turned += texture_area(surface.texture[f]) < 0;
      upright += texture_area(surface.texture[f]) > 0;
    }
    const long edges = long(3 * faces.size()) - long(inside / 2);
    pattern.charts.push_back({surface.labels[faces[0]],
                              turned == 0    ? -1
                              : upright == 0 ? 1
                                             : 0,
                              long(vertices.size()) - edges + long(faces.size())});
  }
  std::sort(pattern.charts.begin(), pattern.charts.end());
  detail::SeamGraph(surface.soup, seams_of(surface)).describe(pattern);
  return pattern;
}

/// The pattern of the labels alone.
inline ChartPattern pattern_of_labels(Textured surface) {
  for (std::size_t f = 0; f < surface.labels.size(); ++f)
    surface.texture[f] = {}; // without an area nothing is folded
  return pattern_of(surface);
}

/// How far the seams of a surface are from those of another, at most: from their vertices and the
/// middles of their edges.
inline double seam_drift(const Textured& surface, const Textured& original) {
  const auto distance_to_edge = [&](const Position& x, const Edge& edge) {
    const Position &p = original.soup.points[edge[0]], d = original.soup.points[edge[1]] - p;
    const double t = std::clamp(dot(x - p, d) / squared_length(d), 0., 1.);
    return squared_distance(x, p + t * d);
  };
  const std::vector<Edge> before = seams_of(original);
  double greatest = 0;
  for (const auto& [v, w] : seams_of(surface)) {
    const Position &p = surface.soup.points[v], &q = surface.soup.points[w];
    for (const Position& x : {p, 0.5 * (p + q), q}) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Edge& edge : before)
        nearest = std::min(nearest, distance_to_edge(x, edge));
      greatest = std::max(greatest, nearest);
    }
  }
  return std::sqrt(greatest);
}

// --- The same asset ------------------------------------------------------------------------------

/// The faces of a surface by the places of their corners, their texture and their label, in
/// ascending order: two surfaces with the same list are the same, bit for bit but for signs of 0,
/// however they are numbered.
inline std::vector<std::vector<double>> described(const Textured& surface) {
  std::vector<std::vector<double>> faces;
  for (std::size_t f = 0; f < surface.labels.size(); ++f) {
    std::array<std::array<double, 5>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& p = surface.soup.points[surface.soup.triangles[f][i]];
      const TexturePlace& q = surface.texture[f][i];
      corners[i] = {p[0], p[1], p[2], q[0], q[1]};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double>& face = faces.emplace_back(1, surface.labels[f]);
    for (const auto& corner : corners)
      face.insert(face.end(), corner.begin(), corner.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

} // namespace test

#endif // QUADRILLE_TEST_CHARTS_H
