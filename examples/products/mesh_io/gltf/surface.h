#ifndef QUADRILLE_EXAMPLES_GLTF_SURFACE_H
#define QUADRILLE_EXAMPLES_GLTF_SURFACE_H

#include "../attributes/value_seams.h"
#include "../mesh/surface_joining.h"
#include "channels.h"
#include "primitive.h"
#include "skeleton.h"
#include "skin.h"
#include "tangents.h"
#include "transform.h"

#include <quadrille/compiled.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// What a face is in and stays in: a primitive, and the values of its corners that are labels.
struct GltfLabel {
  std::size_t primitive;
  std::vector<Element> values; ///< by attribute, then by corner

  friend bool operator<(const GltfLabel& a, const GltfLabel& b) {
    return std::tie(a.primitive, a.values) < std::tie(b.primitive, b.values);
  }
};

/// The triangles of all primitives of a mesh as one surface: vertices at one place are one point
/// wherever edges of their faces meet (SurfaceJoining), of whatever primitive and with whatever
/// attributes they are.
class GltfSurface {
public:
  using Triangle = std::array<std::uint32_t, 3>;
  using Point = std::array<float, 3>;

  std::vector<Point> points; // in single precision, as they are written
  std::vector<Triangle> triangles;

  /// Throws for primitives that differ in what joints and weights they have.
  explicit GltfSurface(std::vector<GltfPrimitive> primitives)
      : primitives_(std::move(primitives)), parts_of_(primitives_.size()) {
    GltfSkin::require_one_kind(primitives_);
    std::vector<std::vector<std::size_t>> first_values;
    for (std::size_t i = 0; i < primitives_.size(); ++i)
      first_values.push_back(add_values(i));
    const Vertices vertices = join_vertices();
    std::vector<Triangle> corners; // of the faces, by vertices
    for (std::size_t i = 0; i < primitives_.size(); ++i)
      add_faces(i, first_values[i], vertices, corners);
    add_charts(vertices, corners);
    tangents_ = GltfTangents(primitives_);
  }

  const std::vector<GltfPrimitive>& primitives() const { return primitives_; }
  /// Positions that are whole numbers, as of KHR_mesh_quantization, become floats: new places are
  /// not among those that the numbers can tell.
  void write_positions_as_floats() {
    for (GltfPrimitive& primitive : primitives_)
      primitive.attributes.front().written = primitive.attributes.front().written.as_floats();
  }
  /// Were its positions integers that are written as floats?
  bool has_become_floats() const {
    return std::any_of(primitives_.begin(), primitives_.end(), [](const GltfPrimitive& primitive) {
      const GltfAttribute& position = primitive.attributes.front();
      return position.written.component.is_float && !position.elements.type().component.is_float;
    });
  }
  bool has(AttributeKind kind) const { return channels_.has(kind); }

  /// The number of the mesh of which the surface is.
  std::size_t mesh() const { return primitives_.front().mesh; }
  /// Makes it the surface of another mesh, of the same primitives.
  void belong_to(std::size_t mesh) {
    for (GltfPrimitive& primitive : primitives_)
      primitive.mesh = mesh;
  }

  /// How many triangles of the primitives do not go through `simplify`: those of two equal corners,
  /// which are not among the triangles, and all but one of those of the same corners that run the
  /// same way round. To be asked before.
  std::size_t count_left_out() const {
    std::size_t count = 0;
    for (const GltfPrimitive& primitive : primitives_)
      count += primitive.triangles.size();
    std::set<Triangle> different;
    for (Triangle triangle : triangles) {
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                  triangle.end());
      different.insert(triangle);
    }
    return count - different.size();
  }

  Vector place(std::uint32_t point) const {
    return {double{points[point][0]}, double{points[point][1]}, double{points[point][2]}};
  }
  /// Numbers of what its faces are in and stay in, of so many.
  const std::vector<std::uint32_t>& labels() const { return label_of_; }
  std::size_t label_count() const { return labels_.size(); }
  const GltfChannels& channels() const { return channels_; }

  /// Where a point moves to when a skeleton bends; nothing if no joint moves it.
  std::vector<double> displacements(std::uint32_t point, const GltfSkeleton& skeleton) const {
    return skin_.displacements(primitives_, point, place(point), skeleton);
  }
  bool has_skin() const { return !skin_.empty(); }

  /// What a simplification has left of it.
  struct Rest {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> labels;          ///< of the triangles
    std::vector<quadrille::SoupChannel> values; ///< of channels()
    std::vector<std::size_t> image;             ///< of each point; others than those left: none
    std::vector<std::uint32_t> origins; ///< of points left that none has become: one from which
                                        ///< each comes; of all others anything; or empty
  };
  void take(Rest rest) {
    skin_.follow(primitives_, points, triangles, rest.image, rest.points, rest.origins);
    points = std::move(rest.points);
    triangles = std::move(rest.triangles);
    label_of_ = std::move(rest.labels);
    channels_.take(std::move(rest.values));
  }

  /// Keeps some faces, with whatever belongs to their corners, and all points.
  void keep_faces(const std::vector<std::size_t>& kept) {
    follow_triangles(triangles, kept);
    follow_triangles(label_of_, kept);
    channels_.keep_faces(kept);
  }

  /// The primitive that a face is in, by its number among those of the surface.
  std::size_t primitive_of(std::size_t face) const { return labels_[label_of_[face]].primitive; }

  /// What a corner of a face has of each attribute of its primitive.
  std::vector<Element> corner(std::size_t face, std::size_t i) const {
    const GltfLabel& label = labels_[label_of_[face]];
    const std::vector<GltfAttribute>& attributes = primitives_[label.primitive].attributes;
    std::vector<Element> elements(attributes.size());
    std::size_t place = i; // among the values of the label
    for (std::size_t a = 0; a < attributes.size(); ++a) {
      if (attributes[a].kind == AttributeKind::position)
        std::copy_n(points[triangles[face][i]].begin(), 3, elements[a].begin());
      else if (attributes[a].kind == AttributeKind::skin)
        elements[a] = skin_.value(primitives_, attributes[a].name, triangles[face][i]);
      else if (attributes[a].is_label)
        elements[a] = label.values[std::exchange(place, place + 3)];
      for (const ChannelPart& part : parts_of_[label.primitive][a])
        channels_.copy_to(elements[a], part, face, i);
    }
    tangents_.square(label.primitive, attributes, elements);
    return elements;
  }

private:
  /// Returns where the values of each channel begin; 0 for those that the primitive has not.
  std::vector<std::size_t> add_values(std::size_t number) {
    std::vector<std::size_t> first_values;
    for (const GltfAttribute& attribute : primitives_[number].attributes) {
      parts_of_[number].push_back(channels_.components_of(attribute));
      for (const ChannelPart& part : parts_of_[number].back()) {
        first_values.resize(std::max(first_values.size(), part.channel + 1));
        first_values[part.channel] = channels_.add(attribute, part);
      }
    }
    return first_values;
  }

  /// The vertices of all primitives, one primitive behind the other.
  struct Vertices {
    std::vector<std::uint32_t> points;
    std::vector<std::size_t> firsts; // of the primitives
  };

  /// Finds the points of vertices; those that are one have the bits of the first.
  Vertices join_vertices() {
    Vertices vertices;
    std::vector<quadrille_examples::Point> places;
    std::vector<Triangle> corners;
    for (const GltfPrimitive& primitive : primitives_) {
      vertices.firsts.push_back(places.size());
      const Elements& positions = primitive.attributes.front().elements;
      for (std::size_t v = 0; v < positions.size(); ++v) {
        const Point p = rounded(positions[v]);
        places.emplace_back(double{p[0]}, double{p[1]}, double{p[2]});
      }
      for (const Triangle& triangle : primitive.triangles)
        corners.push_back(moved_by(vertices.firsts.back(), triangle));
    }
    const std::vector<std::uint32_t> one = SurfaceJoining::first_vertices(places, corners);
    for (std::size_t i = 0, vertex = 0; i < primitives_.size(); ++i)
      for (std::size_t v = 0; v < primitives_[i].attributes.front().elements.size(); ++v) {
        const bool is_first = one[vertex] == vertex;
        vertices.points.push_back(is_first ? static_cast<std::uint32_t>(points.size())
                                           : vertices.points[one[vertex]]);
        if (is_first)
          points.push_back(rounded(primitives_[i].attributes.front().elements[v]));
        skin_.add(vertices.points.back(), primitives_[i], i, v);
        ++vertex;
      }
    return vertices;
  }

  static Point rounded(const Element& position) {
    Point point;
    for (std::size_t c = 0; c < 3; ++c)
      point[c] = static_cast<float>(position[c]);
    return point;
  }

  /// Those that have three corners at different places.
  void add_faces(std::size_t number, const std::vector<std::size_t>& first_values,
                 const Vertices& vertices, std::vector<Triangle>& corners_of_faces) {
    const GltfPrimitive& primitive = primitives_[number];
    for (const Triangle& corners : primitive.triangles) {
      const Triangle of_all = moved_by(vertices.firsts[number], corners);
      const auto [a, b, c] = of_all;
      const Triangle triangle = {vertices.points[a], vertices.points[b], vertices.points[c]};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        continue;
      triangles.push_back(triangle);
      corners_of_faces.push_back(of_all);
      channels_.add_face([&](std::size_t channel) {
        const bool has = channel < first_values.size() && first_values[channel] > 0;
        return has ? moved_by(first_values[channel], corners) : Triangle{};
      });
      label_of_.push_back(number_of(label(number, corners)));
    }
  }

  /// Where colours or numbers of vertices at one point differ, the parts that these seams divide
  /// are charts, which hold their borders: two constants disagree about nothing, so their border
  /// would wander.
  void add_charts(const Vertices& vertices, const std::vector<Triangle>& corners) {
    std::set<std::string> names;
    for (const GltfPrimitive& primitive : primitives_)
      for (const GltfAttribute& attribute : primitive.attributes)
        if (has_charts(attribute))
          names.insert(attribute.name);
    if (names.empty())
      return;
    ValueNumbers numbers(points.size());
    std::vector<std::optional<std::uint32_t>> values(vertices.points.size());
    IndexedMesh mesh;
    for (std::size_t face = 0; face < corners.size(); ++face) {
      Triangle& triangle = mesh.value_triangles.emplace_back();
      const std::size_t primitive = primitive_of(face);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = corners[face][i];
        if (!values[v])
          values[v] = numbers.number(vertices.points[v], row(primitives_[primitive], names,
                                                             v - vertices.firsts[primitive]));
        triangle[i] = *values[v];
      }
    }
    if (mesh.value_triangles == triangles)
      return;
    mesh.triangles = triangles;
    for (std::uint32_t point = 0; point < points.size(); ++point) {
      const auto [x, y, z] = place(point);
      mesh.points.emplace_back(x, y, z);
    }
    channels_.add_charts(SeamPatches(mesh).charts());
  }

  static bool has_charts(const GltfAttribute& attribute) {
    return !attribute.target &&
           (attribute.kind == AttributeKind::color || attribute.kind == AttributeKind::number);
  }

  /// The numbers of a vertex under such names; ones where the primitive has none, as of colours.
  static std::vector<double> row(const GltfPrimitive& primitive, const std::set<std::string>& names,
                                 std::size_t vertex) {
    std::vector<double> row;
    for (const std::string& name : names) {
      Element element{1, 1, 1, 1};
      for (const GltfAttribute& attribute : primitive.attributes)
        if (has_charts(attribute) && attribute.name == name)
          for (std::size_t c = 0; c < attribute.elements.type().components; ++c)
            element[c] = attribute.elements[vertex][c];
      row.insert(row.end(), element.begin(), element.end());
    }
    return row;
  }

  static Triangle moved_by(std::size_t first, Triangle corners) {
    for (std::uint32_t& corner : corners)
      corner += static_cast<std::uint32_t>(first);
    return corners;
  }

  GltfLabel label(std::size_t number, const Triangle& corners) const {
    GltfLabel label{number, {}};
    for (const GltfAttribute& attribute : primitives_[number].attributes)
      for (const std::uint32_t corner : corners)
        if (attribute.is_label)
          label.values.push_back(attribute.elements[corner]);
    return label;
  }

  std::uint32_t number_of(const GltfLabel& label) {
    const auto [place, is_new] =
        label_numbers_.try_emplace(label, static_cast<std::uint32_t>(labels_.size()));
    if (is_new)
      labels_.push_back(label);
    return place->second;
  }

  std::vector<GltfPrimitive> primitives_;
  std::vector<std::vector<std::vector<ChannelPart>>> parts_of_; // each attribute of each primitive
  GltfChannels channels_;
  GltfSkin skin_;
  GltfTangents tangents_;
  std::vector<GltfLabel> labels_;
  std::vector<std::uint32_t> label_of_; // each face
  std::map<GltfLabel, std::uint32_t> label_numbers_;
};

} // namespace quadrille_examples

#endif
