#ifndef QUADRILLE_INTERNAL_CORE_STATE_COMPONENTS_H
#define QUADRILLE_INTERNAL_CORE_STATE_COMPONENTS_H

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
  Isolation(std::vector<Trace> components, std::vector<Index> ranks)
      : components_(std::move(components)), ranks_(std::move(ranks)), order_(components_.size()),
        tree_(components_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    sort_for_box_tree(order_.data(), order_.data() + order_.size(),
                      [&](Index component) { return as_floats(components_[component].centre); });
    for (std::size_t slot = 0; slot < order_.size(); ++slot) {
      const Trace& component = components_[order_[slot]];
      distances_.push_back(farthest * component.radius);
      tree_.put(slot, box_of(component, distances_.back()));
    }
    tree_.fit();
  }

  /// Measures a face of a component with this rank.
  void see(const std::array<Vector<3>, 3>& face, Index rank) {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& p : face)
      box.add(as_floats(p));
    tree_.for_each_meeting(box, [&](std::size_t slot, const FloatBox&) {
      const Trace& component = components_[order_[slot]];
      if (ranks_[order_[slot]] >= rank)
        return;
      const double distance =
          std::sqrt(squared_distance_to_triangle(component.centre, face[0], face[1], face[2]));
      if (distance < distances_[slot]) {
        distances_[slot] = distance;
        tree_.move(slot, box_of(component, distance));
      }
    });
  }

  /// Returns the value of each component, once all faces have been seen.
  std::vector<double> of_components() const {
    std::vector<double> result(components_.size(), 1);
    for (std::size_t slot = 0; slot < order_.size(); ++slot)
      if (const double radius = components_[order_[slot]].radius; radius > 0)
        result[order_[slot]] = (std::max)(1., distances_[slot] / radius);
    return result;
  }

private:
  // In which something nearer lies; nothing counts that is nearer than the radius.
  static FloatBox box_of(const Trace& component, double distance) {
    return distance > component.radius ? cube_around(component.centre, distance)
                                       : FloatBox::empty();
  }

  std::vector<Trace> components_;
  std::vector<Index> ranks_;
  std::vector<Index> order_; // of the slots of the tree
  BoxTree tree_;
  std::vector<double> distances_; // of slots
};

/// A connected component of a surface as it was in the input: a sphere around the centre of its
/// bounding box.
template <std::size_t N>
struct Component {
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
Trace trace_of(const Component<N>& component, const Scale<N>& scale) {
  return {space(component.centre), scale.length_from_mesh(component.radius)};
}

/// The component of each vertex. Contractions of edges keep it.
template <std::size_t N>
class Components {
public:
  Components() = default;
  /// Numbers components in the order of their first vertices, in linear time.
  Components(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale,
             double diagonal)
      : component_(component_roots(complex)) {
    number(complex);
    if (components_.size() == 1) { // it is the only one, and needs no measurement
      components_.front().is_large = true;
      return;
    }
    for_each_vertex([&](Component<N>& component, Index v) {
      component.box.add(geometry.position(v));
      component.is_fixed |= geometry.is_fixed(v);
    });
    for (Component<N>& component : components_) {
      component.centre = 0.5 * component.box.low + 0.5 * component.box.high;
      component.size = scale.length_of_mesh(component.box.diagonal());
      component.is_large = component.size >= least_large * diagonal;
    }
    for_each_vertex([&](Component<N>& component, Index v) {
      const Vector<N>& p = geometry.position(v);
      component.squared_radius =
          (std::max)(component.squared_radius, squared_distance(p, component.centre));
      const double squared = squared_distance(space(p), space(component.centre));
      component.radius = (std::max)(component.radius, scale.length_of_mesh(std::sqrt(squared)));
    });
  }

  /// Measures how far each component lies from all that is no smaller, if components may vanish.
  /// See Isolation.
  void measure_isolation(const TriangleComplex& complex, const Geometry<N>& geometry,
                         const Scale<N>& scale) {
    if (components_.size() < 2)
      return;
    std::vector<Trace> traces;
    for (const Component<N>& component : components_)
      traces.push_back(stays(component) ? Trace{space(component.centre), 0}
                                        : trace_of(component, scale));
    const std::vector<Index> ranks = this->ranks();
    Isolation isolation(std::move(traces), ranks);
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face)) {
        const auto [a, b, c] = complex.vertices(face);
        const auto at = [&](Index v) { return space(geometry.position(v)); };
        isolation.see({at(a), at(b), at(c)}, ranks[of(a)]);
      }
    const std::vector<double> isolations = isolation.of_components();
    for (Index component = 0; component < components_.size(); ++component)
      components_[component].isolation = isolations[component];
  }

  /// Returns the number of components of the input; 0 if components may not vanish.
  std::size_t size() const { return components_.size(); }
  const Component<N>& operator[](Index component) const { return components_[component]; }
  /// Returns the component of a vertex; `none` if it had no faces.
  Index of(Index v) const { return component_[v]; }
  /// Is it certain that the component of a vertex stays?
  bool stays(Index v) const { return components_.empty() || stays(components_[component_[v]]); }
  static bool stays(const Component<N>& component) {
    return component.is_fixed || component.is_large;
  }

  /// A component is large from this fraction of the diagonal of the whole surface on.
  static constexpr double least_large = 1. / 20;

  /// Returns the components in which no vertex has faces.
  std::vector<Trace> gone(const TriangleComplex& complex, const Scale<N>& scale) const {
    std::vector<bool> is_left(components_.size());
    for (Index v = 0; v < component_.size(); ++v)
      if (component_[v] != none && complex.has_faces(v))
        is_left[component_[v]] = true;
    std::vector<Trace> gone;
    for (std::size_t component = 0; component < components_.size(); ++component)
      if (!is_left[component])
        gone.push_back(trace_of(components_[component], scale));
    return gone;
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.component_); }

private:
  // By size, and those that stay last.
  std::vector<Index> ranks() const {
    std::vector<Index> order(components_.size()), rank(components_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::pair(stays(components_[a]), components_[a].size) <
             std::pair(stays(components_[b]), components_[b].size);
    });
    for (Index place = 0; place < order.size(); ++place)
      rank[order[place]] = place;
    return rank;
  }

  // Maps the vertices that represent components to numbers.
  void number(const TriangleComplex& complex) {
    Array<Index> number(component_.size(), none);
    for (Index v = 0; v < component_.size(); ++v) {
      const Index root = component_[v];
      component_[v] = none;
      if (!complex.has_faces(v))
        continue;
      if (number[root] == none) {
        number[root] = static_cast<Index>(components_.size());
        components_.emplace_back();
      }
      component_[v] = number[root];
    }
  }

  template <class Visit>
  void for_each_vertex(Visit visit) {
    for (Index v = 0; v < component_.size(); ++v)
      if (component_[v] != none)
        visit(components_[component_[v]], v);
  }

  Array<Index> component_; // of each vertex
  std::vector<Component<N>> components_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_COMPONENTS_H
