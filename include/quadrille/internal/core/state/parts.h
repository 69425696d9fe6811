#ifndef QUADRILLE_INTERNAL_CORE_STATE_PARTS_H
#define QUADRILLE_INTERNAL_CORE_STATE_PARTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/topology_count.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/state/distance_to_rest.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Computes the distance of the centre of each component from the faces of all components of higher
/// ranks, in its radii: from 1 to `farthest`. The search boxes are in a tree, and shrink as faces
/// are found; so a face costs a logarithm of the number of components, and no list of all faces is
/// kept.
class Isolation {
public:
  static constexpr double farthest = 4;

  /// A radius of 0 marks a component that need not be measured.
  Isolation(std::vector<Trace> parts, std::vector<Index> ranks)
      : parts_(std::move(parts)), ranks_(std::move(ranks)), order_(parts_.size()),
        tree_(parts_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    sort_for_box_tree(order_.data(), order_.data() + order_.size(),
                      [&](Index part) { return as_floats(parts_[part].centre); });
    for (std::size_t slot = 0; slot < order_.size(); ++slot) {
      const Trace& part = parts_[order_[slot]];
      distances_.push_back(farthest * part.radius);
      tree_.put(slot, box_of(part, distances_.back()));
    }
    tree_.fit();
  }

  /// Measures a face of a component with this rank.
  void see(const std::array<Vector<3>, 3>& face, Index rank) {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& p : face)
      box.add(as_floats(p));
    tree_.for_each_meeting(box, [&](std::size_t slot, const FloatBox&) {
      const Trace& part = parts_[order_[slot]];
      if (ranks_[order_[slot]] >= rank)
        return;
      const double distance =
          std::sqrt(squared_distance_to_triangle(part.centre, face[0], face[1], face[2]));
      if (distance < distances_[slot]) {
        distances_[slot] = distance;
        tree_.move(slot, box_of(part, distance));
      }
    });
  }

  /// Returns the value of each component, once all faces have been seen.
  std::vector<double> of_parts() const {
    std::vector<double> result(parts_.size(), 1);
    for (std::size_t slot = 0; slot < order_.size(); ++slot)
      if (const double radius = parts_[order_[slot]].radius; radius > 0)
        result[order_[slot]] = (std::max)(1., distances_[slot] / radius);
    return result;
  }

private:
  // In which something nearer lies; nothing counts that is nearer than the radius.
  static FloatBox box_of(const Trace& part, double distance) {
    return distance > part.radius ? cube_around(part.centre, distance) : FloatBox::empty();
  }

  std::vector<Trace> parts_;
  std::vector<Index> ranks_;
  std::vector<Index> order_; // of the slots of the tree
  BoxTree tree_;
  std::vector<double> distances_; // of slots
};

/// A connected component of a surface as it was in the input: a sphere around the centre of its
/// bounding box.
template <std::size_t N>
struct Part {
  Box<N> box = Box<N>::none();
  Vector<N> centre{};
  double squared_radius = 0; ///< in all dimensions, in the engine's unit
  double radius = 0;         ///< in space, in the mesh's unit
  double isolation = 1;      ///< see Parts::measure_isolation()
  double size = 0;           ///< the diagonal of its box in space, in the mesh's unit
  bool is_large = false;     ///< compared with the whole surface: it does not vanish
  bool is_fixed = false;     ///< is any of its vertices?
};

template <std::size_t N>
Trace trace_of(const Part<N>& part, const Scale<N>& scale) {
  return {space(part.centre), scale.length_from_mesh(part.radius)};
}

/// The component of each vertex. Contractions of edges keep it.
template <std::size_t N>
class Parts {
public:
  Parts() = default;
  /// Numbers components in the order of their first vertices, in linear time.
  Parts(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale,
        double diagonal)
      : part_(component_roots(complex)) {
    number(complex);
    if (parts_.size() == 1) { // it is the only one, and needs no measurement
      parts_.front().is_large = true;
      return;
    }
    for_each_vertex([&](Part<N>& part, Index v) {
      part.box.add(geometry.position(v));
      part.is_fixed |= geometry.is_fixed(v);
    });
    for (Part<N>& part : parts_) {
      part.centre = 0.5 * part.box.low + 0.5 * part.box.high;
      part.size = scale.length_of_mesh(part.box.diagonal());
      part.is_large = part.size >= least_large * diagonal;
    }
    for_each_vertex([&](Part<N>& part, Index v) {
      const Vector<N>& p = geometry.position(v);
      part.squared_radius = (std::max)(part.squared_radius, squared_distance(p, part.centre));
      const double squared = squared_distance(space(p), space(part.centre));
      part.radius = (std::max)(part.radius, scale.length_of_mesh(std::sqrt(squared)));
    });
  }

  /// Measures how far each component lies from all that is no smaller, if components may vanish.
  /// See Isolation.
  void measure_isolation(const TriangleComplex& complex, const Geometry<N>& geometry,
                         const Scale<N>& scale) {
    if (parts_.size() < 2)
      return;
    std::vector<Trace> traces;
    for (const Part<N>& part : parts_)
      traces.push_back(stays(part) ? Trace{space(part.centre), 0} : trace_of(part, scale));
    const std::vector<Index> ranks = this->ranks();
    Isolation isolation(std::move(traces), ranks);
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face)) {
        const auto [a, b, c] = complex.vertices(face);
        const auto at = [&](Index v) { return space(geometry.position(v)); };
        isolation.see({at(a), at(b), at(c)}, ranks[of(a)]);
      }
    const std::vector<double> isolations = isolation.of_parts();
    for (Index part = 0; part < parts_.size(); ++part)
      parts_[part].isolation = isolations[part];
  }

  /// Returns the number of components of the input; 0 if components may not vanish.
  std::size_t size() const { return parts_.size(); }
  const Part<N>& operator[](Index part) const { return parts_[part]; }
  /// Returns the component of a vertex; `none` if it had no faces.
  Index of(Index v) const { return part_[v]; }
  /// Is it certain that the component of a vertex stays?
  bool stays(Index v) const { return parts_.empty() || stays(parts_[part_[v]]); }
  static bool stays(const Part<N>& part) { return part.is_fixed || part.is_large; }

  /// A component is large from this fraction of the diagonal of the whole surface on.
  static constexpr double least_large = 1. / 20;

  /// Returns the components in which no vertex has faces.
  std::vector<Trace> gone(const TriangleComplex& complex, const Scale<N>& scale) const {
    std::vector<bool> is_left(parts_.size());
    for (Index v = 0; v < part_.size(); ++v)
      if (part_[v] != none && complex.has_faces(v))
        is_left[part_[v]] = true;
    std::vector<Trace> gone;
    for (std::size_t part = 0; part < parts_.size(); ++part)
      if (!is_left[part])
        gone.push_back(trace_of(parts_[part], scale));
    return gone;
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_columns(auto& self) { return std::tie(self.part_); }

private:
  // By size, and those that stay last.
  std::vector<Index> ranks() const {
    std::vector<Index> order(parts_.size()), rank(parts_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::pair(stays(parts_[a]), parts_[a].size) <
             std::pair(stays(parts_[b]), parts_[b].size);
    });
    for (Index place = 0; place < order.size(); ++place)
      rank[order[place]] = place;
    return rank;
  }

  // Maps the vertices that represent components to numbers.
  void number(const TriangleComplex& complex) {
    Array<Index> number(part_.size(), none);
    for (Index v = 0; v < part_.size(); ++v) {
      const Index root = part_[v];
      part_[v] = none;
      if (!complex.has_faces(v))
        continue;
      if (number[root] == none) {
        number[root] = static_cast<Index>(parts_.size());
        parts_.emplace_back();
      }
      part_[v] = number[root];
    }
  }

  template <class Visit>
  void for_each_vertex(Visit visit) {
    for (Index v = 0; v < part_.size(); ++v)
      if (part_[v] != none)
        visit(parts_[part_[v]], v);
  }

  Array<Index> part_; // of each vertex
  std::vector<Part<N>> parts_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_PARTS_H
