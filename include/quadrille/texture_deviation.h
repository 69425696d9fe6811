#ifndef QUADRILLE_TEXTURE_DEVIATION_H
#define QUADRILLE_TEXTURE_DEVIATION_H

#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Measures how far the texture of a surface has moved from its place on the original. It works for
/// any simplifier and shares no code with the engine.

namespace quadrille {

/// A surface with texture coordinates at the corners of its triangles, as in an OBJ file.
struct TexturedSoup {
  TriangleSoup<> shape;            ///< in space
  TriangleSoup<Vector<2>> texture; ///< the triangles at their places in the texture
  std::vector<std::size_t> labels; ///< a label for each triangle, such as its material; empty: all
                                   ///< are the same
};

/// The result of texture_deviation(). Lengths are in the unit of the points.
struct TextureDeviation {
  double rms = 0;           ///< root mean square, over all samples that do not bleed
  double greatest = 0;      ///< the greatest deviation of these samples
  double percentile_99 = 0; ///< the deviation that 99 % of the area does not exceed
  double bleeding = 0;      ///< the fraction of the area that shows texture outside of the
                            ///< original's triangles
  double flipped = 0;       ///< the fraction of the area that is flipped in the texture
};

namespace internal {

/// A triangle in the plane of the texture.
inline std::array<Vector<2>, 3> texture_corners(const TexturedSoup& soup, std::size_t triangle) {
  const auto [a, b, c] = soup.texture.triangles[triangle];
  const std::vector<Vector<2>>& at = soup.texture.points;
  return {at[a], at[b], at[c]};
}

/// A grid of the triangles in the texture plane, for searches by place.
class TextureGrid {
public:
  explicit TextureGrid(const TexturedSoup& soup) : soup_(soup) {
    low_.coordinates.fill((std::numeric_limits<double>::max)());
    Vector<2> high;
    high.coordinates.fill(std::numeric_limits<double>::lowest());
    for (const Vector<2>& q : soup.texture.points)
      for (std::size_t i = 0; i < 2; ++i) {
        low_[i] = (std::min)(low_[i], q[i]);
        high[i] = (std::max)(high[i], q[i]);
      }
    side_ =
        1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(soup.shape.triangles.size())));
    for (std::size_t i = 0; i < 2; ++i)
      cells_a_unit_[i] = high[i] > low_[i] ? static_cast<double>(side_) / (high[i] - low_[i]) : 0;
    cells_.resize(side_ * side_);
    for (std::size_t t = 0; t < soup.shape.triangles.size(); ++t) {
      const auto [a, b, c] = texture_corners(soup_, t);
      for_each_cell({(std::min)({cell(a, 0), cell(b, 0), cell(c, 0)}),
                     (std::max)({cell(a, 0), cell(b, 0), cell(c, 0)})},
                    {(std::min)({cell(a, 1), cell(b, 1), cell(c, 1)}),
                     (std::max)({cell(a, 1), cell(b, 1), cell(c, 1)})},
                    [t](std::vector<std::size_t>& list) { list.push_back(t); });
    }
  }

  /// Calls visit(triangle, weights, area) for each triangle with the place q, up to rounding: its
  /// barycentric coordinates, and twice the triangle's area, negative if it is flipped.
  template <class Visit>
  void for_each_at(const Vector<2>& q, Visit visit) const {
    for (std::size_t t : cells_[side_ * cell(q, 1) + cell(q, 0)]) {
      const auto [a, b, c] = texture_corners(soup_, t);
      const double area = double_area(a, b, c);
      if (area == 0)
        continue;
      const std::array weights{double_area(q, b, c) / area, double_area(a, q, c) / area,
                               double_area(a, b, q) / area};
      if (*std::min_element(weights.begin(), weights.end()) >= -tolerance)
        visit(t, weights, area);
    }
  }

  static double double_area(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

private:
  static constexpr double tolerance = 1e-9;

  std::size_t cell(const Vector<2>& q, std::size_t i) const {
    const double place = (q[i] - low_[i]) * cells_a_unit_[i];
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(side_ - 1)));
  }

  template <class Visit>
  void for_each_cell(std::array<std::size_t, 2> columns, std::array<std::size_t, 2> rows,
                     Visit visit) {
    for (std::size_t row = rows[0]; row <= rows[1]; ++row)
      for (std::size_t column = columns[0]; column <= columns[1]; ++column)
        visit(cells_[side_ * row + column]);
  }

  const TexturedSoup& soup_;
  Vector<2> low_, cells_a_unit_;
  std::size_t side_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

inline void require_textured(const TexturedSoup& soup, const char* which) {
  const auto reject = [&](const std::string& what) {
    throw std::invalid_argument(std::string("quadrille::texture_deviation: ") + which + what);
  };
  if (soup.texture.triangles.size() != soup.shape.triangles.size())
    reject(" does not have three coordinates for each triangle");
  if (!soup.labels.empty() && soup.labels.size() != soup.shape.triangles.size())
    reject(" does not have a label for each triangle");
  for (std::size_t t = 0; t < soup.shape.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (soup.shape.triangles[t][i] >= soup.shape.points.size() ||
          soup.texture.triangles[t][i] >= soup.texture.points.size())
        reject(" refers to a point or a coordinate that does not exist, in triangle " +
               std::to_string(t));
}

/// The nearest point to p on the original among those with the place q of the texture: the square
/// of its distance, or infinity if there is none; and whether the texture is flipped there.
struct NearestInTexture {
  double squared = std::numeric_limits<double>::infinity();
  bool is_flipped = false;
};

/// Finds samples of a surface's triangles in the original.
class TextureSampler {
public:
  TextureSampler(const TexturedSoup& surface, const TexturedSoup& original)
      : surface_(surface), original_(original), grid_(original) {}

  double area(std::size_t t) const {
    const auto [a, b, c] = surface_.shape.triangles[t];
    const auto& p = surface_.shape.points;
    return std::sqrt(squared_length(cross(p[b] - p[a], p[c] - p[a]))) / 2;
  }

  /// Finds sample number `n`, in triangle t.
  NearestInTexture nearest(std::size_t t, std::size_t n) const {
    // A sequence that fills the square evenly, folded to a triangle (Roberts 2018).
    const double number = static_cast<double>(n) + 0.5;
    double u = std::fmod(number * 0.7548776662466927, 1.0);
    double v = std::fmod(number * 0.5698402909980532, 1.0);
    if (u + v > 1)
      u = 1 - u, v = 1 - v;
    const auto mix = [&](const auto& x, const auto& y, const auto& z) {
      return (1 - u - v) * x + u * y + v * z;
    };
    const auto [a, b, c] = surface_.shape.triangles[t];
    const auto [qa, qb, qc] = texture_corners(surface_, t);
    return nearest(
        t, mix(surface_.shape.points[a], surface_.shape.points[b], surface_.shape.points[c]),
        mix(qa, qb, qc), TextureGrid::double_area(qa, qb, qc));
  }

private:
  NearestInTexture nearest(std::size_t t, const Vector<3>& p, const Vector<2>& q,
                           double orientation) const {
    NearestInTexture found;
    grid_.for_each_at(q, [&](std::size_t face, const auto& weights, double area) {
      if (!surface_.labels.empty() && !original_.labels.empty() &&
          surface_.labels[t] != original_.labels[face])
        return;
      Vector<3> place;
      for (std::size_t i = 0; i < 3; ++i)
        place += weights[i] * original_.shape.points[original_.shape.triangles[face][i]];
      const double squared = squared_distance(p, place);
      if (squared < found.squared)
        found = {squared, area * orientation < 0};
    });
    return found;
  }

  const TexturedSoup &surface_, &original_;
  TextureGrid grid_;
};

} // namespace internal

/// Measures the distance of each point of a surface from the points of the original that show the
/// same place of the texture, with the same label.
///
/// The surface is sampled evenly, by about `samples` points. Each has a place in space and one in
/// the texture; its deviation is the distance to the nearest point of the original that has the
/// same place in the texture. A sample whose place does not occur in the original *bleeds*: it
/// shows texture between the charts. It counts for `bleeding` only. If the nearest such point lies
/// in a triangle of opposite orientation, the sample is *flipped*.
///
/// Equal arguments give equal results. Time O(s + n) for s samples and n triangles of about
/// even size in the texture. Throws std::invalid_argument for an index out of range.
///
/// Source: texture deviation, Cohen, Olano and Manocha 1998.
inline TextureDeviation texture_deviation(const TexturedSoup& surface, const TexturedSoup& original,
                                          std::size_t samples = 200'000) {
  internal::require_textured(surface, "the surface");
  internal::require_textured(original, "the original");
  const internal::TextureSampler sampler(surface, original);
  double all = 0;
  for (std::size_t t = 0; t < surface.shape.triangles.size(); ++t)
    all += sampler.area(t);

  std::vector<double> squares; // for samples that do not bleed
  std::size_t taken = 0, flipped = 0;
  double passed = 0;
  for (std::size_t t = 0; all > 0 && t < surface.shape.triangles.size(); ++t) {
    passed += sampler.area(t) / all;
    for (; static_cast<double>(taken) < passed * static_cast<double>(samples); ++taken) {
      const internal::NearestInTexture nearest = sampler.nearest(t, taken);
      flipped += nearest.is_flipped;
      if (nearest.squared < std::numeric_limits<double>::infinity())
        squares.push_back(nearest.squared);
    }
  }
  TextureDeviation result;
  if (taken > 0) {
    result.bleeding = static_cast<double>(taken - squares.size()) / static_cast<double>(taken);
    result.flipped = static_cast<double>(flipped) / static_cast<double>(taken);
  }
  if (squares.empty())
    return result;
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
  result.rms = std::sqrt(sum / static_cast<double>(squares.size()));
  std::sort(squares.begin(), squares.end());
  result.greatest = std::sqrt(squares.back());
  result.percentile_99 = std::sqrt(squares[(squares.size() - 1) * 99 / 100]);
  return result;
}

/// Returns the number of edges that do not have exactly two faces, after merging points at the same
/// place: for a closed surface, the number of torn edges.
inline std::size_t count_torn_edges(const SurfaceView& surface) {
  std::map<std::array<double, 3>, std::size_t> place;
  std::vector<std::size_t> welded;
  for (const Vector<3>& p : surface.points)
    welded.push_back(place.try_emplace({p[0], p[1], p[2]}, place.size()).first->second);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> faces;
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++faces[std::minmax({welded[t[i]], welded[t[(i + 1) % 3]]})];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second != 2; }));
}

} // namespace quadrille

#endif // QUADRILLE_TEXTURE_DEVIATION_H
