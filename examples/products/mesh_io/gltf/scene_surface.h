#ifndef QUADRILLE_EXAMPLES_GLTF_SCENE_SURFACE_H
#define QUADRILLE_EXAMPLES_GLTF_SCENE_SURFACE_H

#include "../attributes/mesh_channels.h"
#include "../mesh/bounding_box.h"
#include "../mesh/named_numbers.h"
#include "meetings.h"
#include "placement.h"
#include "scene_channels.h"
#include "surface.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The surfaces of all meshes as one soup in the units of the scene, so that one price decides
/// where faces go. Each mesh is there once, at its largest place; where borders of meshes meet
/// they are one (GltfMeetings).
class GltfSceneSurface {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// `placements` are those of all meshes of the document, by their numbers.
  GltfSceneSurface(std::vector<GltfSurface>& surfaces, const std::vector<GltfPlacement>& placements)
      : surfaces_(surfaces) {
    for (const GltfSurface& surface : surfaces)
      placements_.push_back(&placements[surface.mesh()]);
    number_points();
    add_faces();
  }

  const quadrille::SoupPoints& points() const { return points_; }
  const quadrille::SoupTriangles& triangles() const { return triangles_; }
  /// Where the points of a surface are.
  const std::vector<std::uint32_t>& numbers(std::size_t surface) const { return numbers_[surface]; }

  /// Are all points floats, as where no mesh is placed by its nodes?
  bool is_of_floats() const {
    return std::all_of(points_.begin(), points_.end(), [](const auto& p) {
      return std::all_of(p.begin(), p.end(),
                         [](double x) { return double{static_cast<float>(x)} == x; });
    });
  }

  /// What simplify() has made of them, as one soup.
  const quadrille::SoupResult& result() const { return result_; }

  /// Are there faces of several labels?
  bool has_labels() const { return !labels_.empty(); }

  /// With all attributes. Throws as `quadrille::simplified_soup` does.
  quadrille::Report simplify(quadrille::SoupOptions options, const ChannelChoices& choices) {
    if (!held_.empty())
      options.fixed.resize(points_.size());
    for (const std::uint32_t point : held_)
      options.fixed[point] = true;
    GltfSceneChannels channels(surfaces_, placements_);
    result_ = quadrille::simplified_soup(
        {points_, triangles_, labels_, channels.views(choices, largest_diagonal())}, options);
    const quadrille::SoupResult& result = result_;
    std::vector<std::vector<std::size_t>> faces(surfaces_.size()); // that are left
    for (std::size_t face = 0; face < result.triangles.size(); ++face)
      faces[surface_of(result.input_faces[face])].push_back(face);
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      GltfSurface::Rest rest = rest_of(s, faces[s], result);
      rest.values = channels.part(s, *placements_[s], faces[s], result.channels);
      surfaces_[s].take(std::move(rest));
    }
    return result.report;
  }

private:
  static constexpr auto none = static_cast<std::uint32_t>(-1);

  void number_points() {
    const GltfMeetings meetings = GltfMeetingFinder::find(surfaces_, placements_);
    for (const GltfSurface& surface : surfaces_)
      numbers_.emplace_back(surface.points.size(), none);
    std::vector<std::vector<std::uint32_t>> groups(surfaces_.size()); // of points, or none
    for (std::size_t s = 0; s < surfaces_.size(); ++s)
      groups[s].assign(surfaces_[s].points.size(), none);
    for (std::size_t g = 0; g < meetings.joined.size(); ++g)
      for (const auto& [surface, point] : meetings.joined[g])
        groups[surface][point] = static_cast<std::uint32_t>(g);
    std::vector<std::uint32_t> of_groups(meetings.joined.size(), none);
    for (std::size_t s = 0; s < surfaces_.size(); ++s)
      for (std::uint32_t v = 0; v < numbers_[s].size(); ++v) {
        std::uint32_t& number = groups[s][v] == none ? numbers_[s][v] : of_groups[groups[s][v]];
        if (number == none) {
          number = static_cast<std::uint32_t>(points_.size());
          points_.push_back(placements_[s]->largest(surfaces_[s].place(v)));
        }
        numbers_[s][v] = number;
      }
    for (const auto& [surface, point] : meetings.held)
      held_.push_back(numbers_[surface][point]);
  }

  /// The faces of a mirrored mesh are the other way round.
  void add_faces() {
    std::uint32_t first_label = 0;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      first_faces_.push_back(triangles_.size());
      for (const Triangle& triangle : surfaces_[s].triangles) {
        Triangle corners{};
        for (std::size_t i = 0; i < 3; ++i)
          corners[i] = numbers_[s][triangle[i]];
        if (placements_[s]->is_mirrored())
          std::swap(corners[1], corners[2]);
        triangles_.push_back(corners);
      }
      for (const std::uint32_t label : surfaces_[s].labels())
        labels_.push_back(first_label + label);
      first_label += static_cast<std::uint32_t>(surfaces_[s].label_count());
    }
    if (first_label < 2) // one tells nothing apart
      labels_.clear();
  }

  std::size_t surface_of(std::size_t face) const {
    return static_cast<std::size_t>(
        std::upper_bound(first_faces_.begin(), first_faces_.end(), face) - first_faces_.begin() -
        1);
  }

  double largest_diagonal() const {
    double largest = 0;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const auto end = s + 1 < surfaces_.size() ? first_faces_[s + 1] : triangles_.size();
      const quadrille::SoupTriangles part(triangles_.begin() +
                                              static_cast<std::ptrdiff_t>(first_faces_[s]),
                                          triangles_.begin() + static_cast<std::ptrdiff_t>(end));
      largest = std::max(largest, diagonal(points_, part));
    }
    return largest;
  }

  GltfSurface::Rest rest_of(std::size_t s, const std::vector<std::size_t>& faces,
                            const quadrille::SoupResult& result) const {
    std::vector<std::uint32_t> left; // points of the result, in their order
    for (const std::size_t face : faces)
      left.insert(left.end(), result.triangles[face].begin(), result.triangles[face].end());
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    const auto local = [&](std::size_t point) {
      const auto found = std::lower_bound(left.begin(), left.end(), point);
      return found != left.end() && *found == point ? static_cast<std::size_t>(found - left.begin())
                                                    : static_cast<std::size_t>(-1);
    };
    GltfSurface::Rest rest;
    for (const std::size_t face : faces) {
      Triangle corners = result.triangles[face];
      for (std::uint32_t& corner : corners)
        corner = static_cast<std::uint32_t>(local(corner));
      if (placements_[s]->is_mirrored())
        std::swap(corners[1], corners[2]);
      rest.triangles.push_back(corners);
      rest.labels.push_back(surfaces_[s].labels()[result.input_faces[face] - first_faces_[s]]);
    }
    for (const std::uint32_t number : numbers_[s])
      rest.image.push_back(local(result.vertex_map[number]));
    rest.points = places_of(s, left, rest.image, result);
    const quadrille::PreparedSurface& prepared = result.prepared;
    if (prepared.origins.empty())
      return rest;
    rest.origins.resize(left.size());
    std::vector<std::uint32_t> of_numbers(points_.size(), none); // the points of the surface
    for (std::uint32_t v = 0; v < numbers_[s].size(); ++v)
      of_numbers[numbers_[s][v]] = v;
    for (std::size_t i = 0; i < prepared.origins.size(); ++i) {
      const std::uint32_t v = of_numbers[prepared.origins[i]];
      const std::size_t image = local(prepared.vertex_map[points_.size() + i]);
      if (v == none || image >= left.size())
        continue;
      rest.origins[image] = v;
      if (result.points[left[image]] == points_[numbers_[s][v]]) // a copy that has not moved
        rest.points[image] = surfaces_[s].points[v];
    }
    return rest;
  }

  /// Those that have not moved keep their bits.
  std::vector<GltfSurface::Point> places_of(std::size_t s, const std::vector<std::uint32_t>& left,
                                            const std::vector<std::size_t>& image,
                                            const quadrille::SoupResult& result) const {
    std::vector<GltfSurface::Point> places;
    for (const std::uint32_t point : left) {
      const auto [x, y, z] = placements_[s]->inverse(result.points[point]);
      places.push_back({nearest_float(x), nearest_float(y), nearest_float(z)});
    }
    for (std::size_t v = 0; v < image.size(); ++v)
      if (image[v] < left.size() && points_[numbers_[s][v]] == result.points[left[image[v]]])
        places[image[v]] = surfaces_[s].points[v];
    return places;
  }

  std::vector<GltfSurface>& surfaces_;
  std::vector<const GltfPlacement*> placements_;    // of the surfaces
  std::vector<std::vector<std::uint32_t>> numbers_; // of the points of each surface
  std::vector<std::uint32_t> held_;
  quadrille::SoupPoints points_;
  quadrille::SoupResult result_;
  quadrille::SoupTriangles triangles_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::size_t> first_faces_; // of the surfaces
};

} // namespace quadrille_examples

#endif
