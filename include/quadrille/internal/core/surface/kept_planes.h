#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_PLANES_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_PLANES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A plane normal · x = offset, with a normal of length 1. If it is perpendicular to an axis, the
/// normal is that axis, and the offset is a coordinate.
struct RegionPlane {
  Vector<3> normal;
  double offset = 0;
  std::optional<std::size_t> axis = {};

  double height(const Vector<3>& x) const {
    return axis ? x[*axis] - offset : dot(normal, x) - offset;
  }
};

/// The points that several planes have in common: a plane, a line or a point.
class CommonPoints {
public:
  CommonPoints() = default;
  /// Planes perpendicular to axes have to come first: their coordinates are then exact. A plane
  /// that is nearly parallel to the points in common of those before it does not count.
  explicit CommonPoints(std::vector<RegionPlane> planes) : planes_(std::move(planes)) {
    for (const RegionPlane& plane : planes_)
      add(plane);
  }

  const std::vector<RegionPlane>& planes() const { return planes_; }
  /// How many of the planes are independent: 1 for a plane, 2 for a line, 3 for a point.
  std::size_t rank() const { return rank_; }

  /// Returns the nearest of them.
  Vector<3> nearest(Vector<3> x) const {
    for (int round = 0; round < 2; ++round) // the second one removes the rounding of the first
      for (std::size_t i = 0; i < rank_; ++i)
        x += (offsets_[i] - dot(normals_[i], x)) * normals_[i];
    for (const RegionPlane& plane : planes_)
      if (plane.axis)
        x[*plane.axis] = plane.offset;
    return x;
  }

  /// Returns the distance of a point from the farthest plane; coordinates that a plane determines
  /// have to be exact, else it is infinite.
  double distance(const Vector<3>& x) const {
    double farthest = 0;
    for (const RegionPlane& plane : planes_)
      if (const double height = std::abs(plane.height(x)); !plane.axis)
        farthest = (std::max)(farthest, height);
      else if (height != 0)
        return HUGE_VAL;
    return farthest;
  }

  /// Converts lengths to another unit.
  template <class Convert>
  void convert_lengths(Convert convert) {
    for (RegionPlane& plane : planes_)
      plane.offset = convert(plane.offset);
    for (double& offset : offsets_)
      offset = convert(offset);
  }

private:
  static constexpr double least_sine = 1e-3; // of the angle to the points in common before

  void add(const RegionPlane& plane) {
    Vector<3> normal = plane.normal;
    double offset = plane.offset;
    for (std::size_t i = 0; i < rank_; ++i) {
      const double along = dot(plane.normal, normals_[i]);
      normal -= along * normals_[i];
      offset -= along * offsets_[i];
    }
    const double length = std::sqrt(squared_length(normal));
    if (rank_ == 3 || !(length > least_sine))
      return;
    normals_[rank_] = (1 / length) * normal;
    offsets_[rank_] = offset / length;
    ++rank_;
  }

  std::vector<RegionPlane> planes_;
  std::size_t rank_ = 0;
  std::array<Vector<3>, 3> normals_; // perpendicular to each other
  std::array<double, 3> offsets_{};
};

/// The planes in which the vertices of an input have to stay, in the mesh's unit. A place of
/// `set_of_vertex` is that of a vertex in the positions.
struct PlanesOfInput {
  /// Planes that a vertex may have to stay in, all at once.
  struct Set {
    std::vector<Index> regions; ///< ascending
    CommonPoints points;
    double slack = 0; ///< how far vertices of the input are from the farthest plane, by rounding

    template <class Convert>
    void convert_lengths(Convert convert) {
      points.convert_lengths(convert);
      slack = convert(slack);
    }
  };
  std::vector<Set> sets;            ///< the first of them has no plane
  std::vector<Index> set_of_vertex; ///< empty if there are no planes
  std::size_t regions = 0;          ///< how many regions there are
  /// The edges between a region and other faces, or none; by the ends' places in the positions.
  std::vector<std::array<Index, 2>> outlines;
  std::optional<double> outline_limit; ///< how far outlines may go from those of the input
};

/// The planes in which the vertices of a surface stay: see KeepPlanes. A contraction of two
/// vertices is possible if the planes of one are among those of the other, and the vertex that it
/// leaves is in all planes of both.
class KeptPlanes {
public:
  KeptPlanes() = default;
  template <std::size_t N>
  KeptPlanes(const PlanesOfInput& input, const Scale<N>& scale, Arena* arena)
      : set_of_(input.set_of_vertex.begin(), input.set_of_vertex.end(), arena), sets_(input.sets) {
    for (PlanesOfInput::Set& set : sets_)
      set.convert_lengths([&scale](double length) { return scale.length_from_mesh(length); });
  }

  bool empty() const { return set_of_.empty(); }

  /// Returns the set of planes in which the vertex of a pair has to be; none if the pair cannot be
  /// contracted.
  Index of_pair(Index v, Index w) const {
    const Index a = set_of_[v], b = set_of_[w];
    return includes(a, b) ? a : includes(b, a) ? b : none;
  }

  /// Moves a target of a pair into its planes. A target at an end of the pair becomes the end that
  /// lies in them.
  template <std::size_t N>
  void move(Vector<N>& target, Index v, Index w, const Vector<N>& first,
            const Vector<N>& second) const {
    const Index set = of_pair(v, w);
    if (set == none || sets_[set].regions.empty())
      return;
    if (target == first || target == second) {
      if (set_of_[v] != set_of_[w])
        target = set_of_[v] == set ? first : second;
      return;
    }
    const Vector<3> place = sets_[set].points.nearest(space(target));
    for (std::size_t i = 0; i < 3; ++i)
      target[i] = place[i];
  }

  /// May the pair be contracted to this target? It has to be in its planes, within the rounding of
  /// coordinates as they are written.
  template <std::size_t N>
  bool admit(Index v, Index w, const Vector<N>& target, const Scale<N>& scale) const {
    const Index set = of_pair(v, w);
    return set != none &&
           sets_[set].points.distance(space(target)) <= tolerance(set, space(target), scale);
  }

  /// Would a contraction lay a face into a plane in which it is not yet? Such a face would look
  /// like a part of the region there. Only faces of the end of fewer planes can be laid flat. Their
  /// other corners may be at another region in the same plane, or at none.
  template <std::size_t N>
  bool flatten(const PairStar& star, Index v, Index w, const Geometry<N>& geometry,
               const Scale<N>& scale) const {
    const Index all = of_pair(v, w);
    if (set_of_[v] == set_of_[w])
      return false;
    const bool is_first = set_of_[v] == all;
    const AppendBuffer<StarFace>& faces = is_first ? star.second : star.first;
    const auto& planes = sets_[all].points.planes();
    return std::any_of(planes.begin(), planes.end(), [&](const RegionPlane& plane) {
      const auto has = [&](Index vertex) {
        const Vector<3> x = space(geometry.position(vertex));
        return std::abs(plane.height(x)) <= (plane.axis ? 0 : tolerance(all, x, scale));
      };
      return !has(is_first ? w : v) &&
             std::any_of(faces.begin(), faces.end(),
                         [&](const StarFace& f) { return has(f.second) && has(f.third); });
    });
  }

  void merge(Index kept, Index gone) {
    if (!empty() && set_of_[kept] != set_of_[gone]) [[unlikely]]
      set_of_[kept] = of_pair(kept, gone);
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.set_of_); }

private:
  // How far a point may be from the planes of a set.
  template <std::size_t N>
  double tolerance(Index set, const Vector<3>& x, const Scale<N>& scale) const {
    const double size = std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
    return (std::max)(8 * scale.rounding(size), 2 * sets_[set].slack);
  }
  bool includes(Index set, Index other) const {
    if (set == other || sets_[other].regions.empty())
      return true;
    const std::vector<Index>&all = sets_[set].regions, &some = sets_[other].regions;
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  }

  Array<Index> set_of_; // of each vertex; empty if there are no planes
  std::vector<PlanesOfInput::Set> sets_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_PLANES_H
