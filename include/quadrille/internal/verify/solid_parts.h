#ifndef QUADRILLE_INTERNAL_VERIFY_SOLID_PARTS_H
#define QUADRILLE_INTERNAL_VERIFY_SOLID_PARTS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/part_shape.h>
#include <quadrille/internal/verify/umbrellas_of_solid.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A piece of a closed surface that has been cut where it only touches itself.
struct SolidPart {
  std::vector<std::size_t> faces;
  std::ptrdiff_t euler_number = 0; ///< two, less twice its genus
  PartShape shape;
  std::vector<std::size_t> around; ///< other parts that it lies in, by their numbers
};

/// The parts of a closed surface, numbered by their first faces: how each is oriented, how many
/// handles it has, and in which of the others it lies, by how often these wind around a point of
/// it. Nothing here fails for a part that is flat, a line or a point.
inline std::vector<SolidPart> solid_parts(const SurfaceView& surface, UmbrellasOfSolid& umbrellas,
                                          CheckProgress& progress);

/// Counts pairs of faces on the same three vertices, of which each face is in one pair at most: a
/// sheet, or a pillow, that encloses nothing. `first` becomes the lowest number of such a face.
inline std::size_t count_doubled_faces(const SurfaceView& surface, std::size_t& first) {
  std::set<Corners> single;
  std::size_t count = 0;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    Corners key = surface.triangles[face];
    std::sort(key.begin(), key.end());
    if (single.insert(key).second)
      continue;
    single.erase(key);
    if (count++ == 0)
      first = face;
  }
  return count;
}

/// How often a part winds around a point.
inline double winding_number(const SurfaceView& surface, const SolidPart& part,
                             const Vector<3>& p) {
  double sum = 0;
  for (const std::size_t face : part.faces) {
    const auto [a, b, c] = corners_seen_from(surface, face, p);
    const double k = length(a), l = length(b), m = length(c);
    sum +=
        std::atan2(dot(a, cross(b, c)), k * l * m + dot(a, b) * m + dot(b, c) * k + dot(c, a) * l);
  }
  return sum / (2 * std::numbers::pi);
}

/// Does one part lie in another one? Where they touch, a point may lie on both, and the number of
/// times that it is wound around is none: so the point counts that knows best.
inline bool lies_in(const SurfaceView& surface, const SolidPart& inner, const SolidPart& outer) {
  constexpr std::size_t most_points = 16;
  constexpr double enough = 1e-6;
  const std::size_t step = (std::max)(std::size_t{1}, inner.faces.size() / most_points);
  double best = 0, error = 1;
  for (std::size_t i = 0; i < inner.faces.size() && error > enough; i += step) {
    const auto [a, b, c] = corners_seen_from(surface, inner.faces[i], {});
    const double winding = winding_number(surface, outer, 1.0 / 3 * (a + b + c));
    if (const double e = std::abs(winding - std::round(winding)); e < error) {
      best = std::round(winding);
      error = e;
    }
  }
  return best != 0;
}

inline std::vector<SolidPart> solid_parts(const SurfaceView& surface, UmbrellasOfSolid& umbrellas,
                                          CheckProgress& progress) {
  std::vector<SolidPart> parts;
  std::map<std::size_t, std::size_t> numbers;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    const auto [at, is_new] = numbers.try_emplace(umbrellas.part_of(face), parts.size());
    if (is_new)
      parts.emplace_back();
    parts[at->second].faces.push_back(face);
  }
  for (SolidPart& part : parts) {
    // Each face has three half-edges, and two of these are an edge: F - E = -F/2.
    part.euler_number = static_cast<std::ptrdiff_t>(umbrellas.count(part.faces)) -
                        static_cast<std::ptrdiff_t>(part.faces.size() / 2);
    part.shape = PartShape(surface, part.faces);
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < parts.size(); ++j) {
      progress.step();
      if (i != j && parts[j].shape.box_holds(parts[i].shape) &&
          lies_in(surface, parts[i], parts[j]))
        parts[i].around.push_back(j);
    }
  return parts;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_SOLID_PARTS_H
