#ifndef QUADRILLE_EXAMPLES_GLTF_SKIN_H
#define QUADRILLE_EXAMPLES_GLTF_SKIN_H

#include "../attributes/nearest_vertices.h"
#include "closest_on_triangle.h"
#include "primitive.h"
#include "skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The joints and weights of a mesh's points. A point that is left where no vertex was has those of
/// the surface at the nearest place of the triangles that became its own.
class GltfSkin {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// How much a joint says about a point.
  struct Influence {
    std::size_t joint;
    double weight;
  };
  using Influences = std::vector<Influence>; ///< the greatest first

  /// Throws if a value cannot go from one primitive to another one as it is stored.
  static void require_one_kind(const std::vector<GltfPrimitive>& primitives) {
    for (const GltfPrimitive& primitive : primitives)
      if (types(primitive) != types(primitives.front()))
        throw std::runtime_error(
            "the primitives of a mesh differ in their joints and weights, or in the types of "
            "these");
  }

  /// Takes a vertex of a primitive in. Of several ones at a point the first tells, lest the surface
  /// tear where it moves.
  void add(std::uint32_t point, const GltfPrimitive& primitive, std::size_t number,
           std::size_t vertex) {
    if (point == sources_.size() && !types(primitive).empty())
      sources_.push_back({number, vertex, {}});
  }

  bool empty() const { return sources_.empty(); }

  Influences influences(const std::vector<GltfPrimitive>& primitives, std::uint32_t point) const {
    const Source& source = sources_[point];
    if (!source.blended.empty())
      return source.blended;
    std::map<std::size_t, double> weights; // by joints
    const GltfPrimitive& primitive = primitives[source.primitive];
    for (std::size_t set = 0; const GltfAttribute* const joints = find(primitive, "JOINTS_", set);
         ++set)
      if (const GltfAttribute* const values = find(primitive, "WEIGHTS_", set))
        for (std::size_t i = 0; i < 4; ++i)
          weights[static_cast<std::size_t>(joints->elements[source.vertex][i])] +=
              values->elements[source.vertex][i];
    return sorted(weights);
  }

  /// Where a point moves to in the poses of a skeleton, seen from where it is.
  std::vector<double> displacements(const std::vector<GltfPrimitive>& primitives,
                                    std::uint32_t point, const Vector& place,
                                    const GltfSkeleton& skeleton) const {
    std::vector<double> result(3 * GltfSkeleton::poses);
    for (const auto& [joint, weight] : influences(primitives, point))
      for (std::size_t pose = 0; pose < GltfSkeleton::poses && joint < skeleton.size(); ++pose) {
        const Vector moved = skeleton.displacement(joint, pose, place);
        for (std::size_t i = 0; i < 3; ++i)
          result[3 * pose + i] += weight * moved[i];
      }
    return result;
  }

  /// Turns to the points that are left; `triangles` are of those before. `fallbacks` are points
  /// before, for those left that none of them has become; or empty.
  template <class Point>
  void follow(const std::vector<GltfPrimitive>& primitives, const std::vector<Point>& before,
              const std::vector<Triangle>& triangles, const std::vector<std::size_t>& images,
              const std::vector<Point>& left, const std::vector<std::uint32_t>& fallbacks) {
    if (sources_.empty())
      return;
    const std::vector<std::uint32_t> nearest = nearest_vertices(before, images, left, fallbacks);
    const std::vector<Place> places = nearest_places(before, triangles, images, left);
    std::vector<Source> sources;
    for (std::size_t i = 0; i < left.size(); ++i) {
      sources.push_back(sources_[nearest[i]]);
      if (before[nearest[i]] != left[i] && places[i].triangle != none)
        sources.back().blended =
            blended(primitives, triangles[places[i].triangle], places[i].coordinates);
    }
    sources_ = std::move(sources);
  }

  Element value(const std::vector<GltfPrimitive>& primitives, const std::string& name,
                std::uint32_t point) const {
    const Source& source = sources_[point];
    const GltfPrimitive& primitive = primitives[source.primitive];
    const bool is_joint = name.starts_with("JOINTS_");
    const std::size_t set = set_of(name);
    if (!source.blended.empty() && set < sets(primitive)) {
      const std::vector<double> weights =
          stored_weights(source.blended, find(primitive, "WEIGHTS_", set)->elements.type());
      Element element{};
      for (std::size_t i = 0; i < 4 && 4 * set + i < weights.size(); ++i)
        if (const std::size_t at = 4 * set + i; weights[at] > 0)
          element[i] = is_joint ? static_cast<double>(source.blended[at].joint) : weights[at];
      return element;
    }
    for (const GltfAttribute& attribute : primitive.attributes)
      if (attribute.kind == AttributeKind::skin && attribute.name == name)
        return attribute.elements[source.vertex];
    return {};
  }

private:
  static constexpr auto none = static_cast<std::size_t>(-1);

  struct Source {
    std::size_t primitive, vertex;
    Influences blended; ///< instead of those of the vertex, if there are any
  };

  /// On a triangle of the surface as it was.
  struct Place {
    std::size_t triangle = none;
    Vector coordinates{}; ///< barycentric
    double distance = std::numeric_limits<double>::infinity();
  };

  template <class Point>
  static std::vector<Place>
  nearest_places(const std::vector<Point>& before, const std::vector<Triangle>& triangles,
                 const std::vector<std::size_t>& images, const std::vector<Point>& left) {
    const auto vector = [](const Point& p) {
      return Vector{double{p[0]}, double{p[1]}, double{p[2]}};
    };
    std::vector<Place> places(left.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& [a, b, c] = triangles[t];
        const std::size_t image = images[triangles[t][i]];
        if (image >= left.size())
          continue;
        const auto [coordinates, distance] = closest_on_triangle(
            vector(left[image]), {vector(before[a]), vector(before[b]), vector(before[c])});
        if (distance < places[image].distance)
          places[image] = {t, coordinates, distance};
      }
    return places;
  }

  Influences blended(const std::vector<GltfPrimitive>& primitives, const Triangle& corners,
                     const Vector& coordinates) const {
    std::map<std::size_t, double> weights;
    for (std::size_t i = 0; i < 3; ++i)
      for (const auto& [joint, weight] : influences(primitives, corners[i]))
        weights[joint] += coordinates[i] * weight;
    Influences result = sorted(weights);
    const std::size_t most = 4 * sets(primitives[sources_[corners[0]].primitive]);
    result.resize(std::min(result.size(), most), {0, 0});
    double sum = 0;
    for (const Influence& influence : result)
      sum += influence.weight;
    for (Influence& influence : result)
      influence.weight /= sum;
    return result;
  }

  static Influences sorted(const std::map<std::size_t, double>& weights) {
    Influences result;
    for (const auto& [joint, weight] : weights)
      if (weight > 0)
        result.push_back({joint, weight});
    std::stable_sort(result.begin(), result.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    return result;
  }

  /// Weights that are stored as integers have the sum that means 1: what rounding down leaves goes
  /// to those that have lost most by it.
  static std::vector<double> stored_weights(const Influences& influences, const ElementType& type) {
    std::vector<double> weights;
    std::vector<std::pair<double, std::size_t>> lost;
    const double one = type.component.greatest;
    double rest = one;
    for (const Influence& influence : influences) {
      weights.push_back(influence.weight);
      if (type.component.is_float)
        continue;
      const double whole = std::floor(influence.weight * one);
      lost.emplace_back(whole - influence.weight * one, weights.size() - 1);
      weights.back() = whole / one;
      rest -= whole;
    }
    std::sort(lost.begin(), lost.end());
    for (std::size_t i = 0; i < lost.size() && rest > 0.5; ++i, --rest)
      weights[lost[i].second] += 1 / one;
    return weights;
  }

  static std::size_t set_of(const std::string& name) {
    std::size_t set = 0;
    for (const char digit : name.substr(name.find('_') + 1))
      set = digit >= '0' && digit <= '9' && set < 1000
                ? 10 * set + static_cast<std::size_t>(digit - '0')
                : none;
    return set;
  }

  /// How many sets of joints have weights, from the first one on.
  static std::size_t sets(const GltfPrimitive& primitive) {
    std::size_t count = 0;
    while (find(primitive, "JOINTS_", count) && find(primitive, "WEIGHTS_", count))
      ++count;
    return count;
  }

  static const GltfAttribute* find(const GltfPrimitive& primitive, const char* semantic,
                                   std::size_t set) {
    const std::string name = semantic + std::to_string(set);
    for (const GltfAttribute& attribute : primitive.attributes)
      if (attribute.kind == AttributeKind::skin && attribute.name == name)
        return &attribute;
    return nullptr;
  }

  /// The component types of joints and weights by their names.
  static std::map<std::string, std::size_t> types(const GltfPrimitive& primitive) {
    std::map<std::string, std::size_t> types;
    for (const GltfAttribute& attribute : primitive.attributes)
      if (attribute.kind == AttributeKind::skin)
        types[attribute.name] = attribute.elements.type().component.code;
    return types;
  }

  std::vector<Source> sources_; // of each point; none without joints
};

} // namespace quadrille_examples

#endif
