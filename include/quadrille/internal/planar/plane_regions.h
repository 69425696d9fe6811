#ifndef QUADRILLE_INTERNAL_PLANAR_PLANE_REGIONS_H
#define QUADRILLE_INTERNAL_PLANAR_PLANE_REGIONS_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/surface/kept_planes.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/planar/flatness.h>
#include <quadrille/internal/planar/patch_growth.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A plane region of a surface: connected faces in a plane.
struct PlaneRegion {
  std::vector<Index> faces;
  RegionPlane plane;
  double area = 0; // doubled
};

/// Finds the plane regions of a surface, as remesh_planar_patches() finds patches, and their
/// planes. Lengths are in the unit of the positions.
class PlaneRegionFinder {
public:
  /// `height`: the greatest distance of the vertices of a region from its plane.
  PlaneRegionFinder(std::span<const Vector<3>> positions, const SurfaceSides& sides, double height)
      : surface_{positions, sides, no_channels_}, height_(height) {}

  /// Returns the regions that are at least so large, those in planes perpendicular to an axis
  /// first, and the larger ones before the smaller.
  std::vector<PlaneRegion> regions(double least_area) const {
    std::vector<PlaneRegion> regions;
    PatchGrowth growth(surface_, FlatLimits{height_, least_cosine, 0, height_},
                       [](Index) { return true; });
    growth.for_each_patch([&](PlanarPatch patch) {
      double area = 0;
      for (Index f : patch.faces)
        area += std::sqrt(squared_length(surface_.area_vector(f)));
      if (area >= 2 * least_area && squared_length(patch.normal) > 0) {
        const RegionPlane plane = plane_of(patch);
        regions.push_back({std::move(patch.faces), plane, area});
      }
    });
    std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
      return std::pair(!a.plane.axis, -a.area) < std::pair(!b.plane.axis, -b.area);
    });
    return regions;
  }

private:
  static constexpr double least_cosine = 0.7; // of the normals of a face and of its plane

  RegionPlane plane_of(const PlanarPatch& patch) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> values = values_of(patch, [axis](const Vector<3>& p) { return p[axis]; });
      const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
      if (std::abs(patch.normal[axis]) < least_cosine || *greatest - *least > 2 * height_)
        continue;
      Vector<3> normal{};
      normal[axis] = 1;
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), middle, values.end()); // a coordinate of the input
      return {normal, *middle, axis};
    }
    const std::vector<double> heights =
        values_of(patch, [&](const Vector<3>& p) { return dot(patch.normal, p); });
    const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
    return {patch.normal, *least + 0.5 * (*greatest - *least)};
  }

  template <class Value>
  std::vector<double> values_of(const PlanarPatch& patch, Value value) const {
    std::vector<double> values;
    for (Index f : patch.faces)
      for (Index side = 3 * f; side < 3 * f + 3; ++side)
        values.push_back(value(surface_.position(side)));
    return values;
  }

  std::vector<ChannelInput> no_channels_;
  PatchSurface surface_;
  double height_;
};

/// Keeps the regions of an input in their planes: moves their vertices into these, and makes each
/// region one of labels, so that its outline stays.
///
/// A vertex at several regions lies in all of their planes. If it would have to move further than
/// these allow, or is fixed elsewhere, the faces of the smallest region around it leave that.
template <std::size_t N>
class RegionsInPlanes {
public:
  RegionsInPlanes(SurfaceInput<N>& input, double least_area, double height)
      : input_(input), scale_(input.box(), true), height_(scale_.length_from_mesh(height)),
        region_of_(input.triangles.size(), none) {
    for (const Vector<N>& p : input.positions)
      positions_.push_back(space(scale_.position_from_mesh(p)));
    rounding_ = 8 * rounding_of(positions_);
    height_ = (std::max)(height_, rounding_);
    const SurfaceSides sides(input.triangles);
    const double unit = scale_.length_from_mesh(1);
    regions_ = PlaneRegionFinder(positions_, sides, height_).regions(least_area * unit * unit);
    for (Index region = 0; region < regions_.size(); ++region)
      for (Index face : regions_[region].faces)
        region_of_[face] = region;
  }

  /// Changes the input, if it has a region.
  void apply() {
    if (regions_.empty())
      return;
    while (!places_all())
      ++rounds_;
    PlanesOfInput& planes = input_.planes;
    planes.regions = regions_.size();
    for (const Placed& placed : placed_)
      place(placed);
    for (PlanesOfInput::Set& set : planes.sets)
      set.convert_lengths([this](double length) { return scale_.length_of_mesh(length); });
    find_outlines();
    label();
  }

private:
  static constexpr int most_rounds = 8;      // in which regions lose single faces
  static constexpr double farthest_move = 8; // in heights

  struct Placed {
    Index vertex, set;
    Vector<3> place;
  };

  // Finds the place of each vertex in its planes. Returns false if faces have left regions.
  bool places_all() {
    placed_.clear();
    numbers_.clear();
    input_.planes.sets.assign(1, {});
    const std::vector<std::pair<Index, Index>> incident = vertices_with_regions();
    bool are_all_there = true;
    for (std::size_t begin = 0, end = 0; begin < incident.size(); begin = end) {
      std::vector<Index> regions;
      for (; end < incident.size() && incident[end].first == incident[begin].first; ++end)
        regions.push_back(incident[end].second);
      if (!finds_place(incident[begin].first, regions))
        are_all_there = false;
    }
    return are_all_there;
  }

  // Each vertex with each region at it, in order.
  std::vector<std::pair<Index, Index>> vertices_with_regions() const {
    std::vector<std::pair<Index, Index>> incident;
    for (Index face = 0; face < region_of_.size(); ++face)
      if (region_of_[face] != none)
        for (Index v : input_.triangles[face])
          incident.push_back({v, region_of_[face]});
    std::sort(incident.begin(), incident.end());
    incident.erase(std::unique(incident.begin(), incident.end()), incident.end());
    return incident;
  }

  bool finds_place(Index v, std::vector<Index> regions) {
    const Index set = number_of(regions);
    const CommonPoints& points = input_.planes.sets[set].points;
    const Vector<3>& p = positions_[v];
    const bool is_there = points.distance(p) <= rounding_;
    const Vector<3> place = is_there || is_fixed(v) ? p : points.nearest(p);
    const double distance = points.distance(place), most = farthest_move * height_;
    if (distance <= rounding_ && squared_distance(place, p) <= most * most) {
      double& slack = input_.planes.sets[set].slack;
      slack = (std::max)(slack, distance);
      placed_.push_back({v, set, place});
      return true;
    }
    leave(v, regions.back());
    return false;
  }
  bool is_fixed(Index v) const { return !input_.is_fixed.empty() && input_.is_fixed[v]; }

  // The faces of a region at a vertex leave it; all of its faces, if there have been many rounds.
  void leave(Index v, Index region) {
    for (Index face : regions_[region].faces) {
      const auto& corners = input_.triangles[face];
      if (rounds_ >= most_rounds || std::find(corners.begin(), corners.end(), v) != corners.end())
        region_of_[face] = none;
    }
  }

  Index number_of(const std::vector<Index>& regions) {
    const auto [at, is_new] =
        numbers_.try_emplace(regions, static_cast<Index>(input_.planes.sets.size()));
    if (is_new) {
      std::vector<RegionPlane> planes;
      for (Index region : regions)
        planes.push_back(regions_[region].plane);
      input_.planes.sets.push_back({regions, CommonPoints(std::move(planes))});
    }
    return at->second;
  }

  void place(const Placed& placed) {
    PlanesOfInput& planes = input_.planes;
    planes.set_of_vertex.resize(input_.positions.size(), 0);
    planes.set_of_vertex[placed.vertex] = placed.set;
    if (planes.sets[placed.set].points.rank() == 3)
      input_.fix(placed.vertex);
    if (placed.place == positions_[placed.vertex])
      return;
    input_.moved.push_back(placed.vertex);
    for (std::size_t i = 0; i < 3; ++i)
      input_.positions[placed.vertex][i] = scale_.length_of_mesh(placed.place[i]);
  }

  // The edges of a face of a region that are not between two of its faces.
  void find_outlines() {
    if (placed_.empty())
      return; // all faces have left their regions
    struct EdgeOfRegion {
      std::array<Index, 2> ends;
      Index region;
    };
    std::vector<EdgeOfRegion> sides;
    const auto is_in_plane = [&](Index v) { return input_.planes.set_of_vertex[v] != 0; };
    for (Index face = 0; face < region_of_.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& corners = input_.triangles[face];
        const auto [low, high] = std::minmax({corners[i], corners[i == 2 ? 0 : i + 1]});
        if (low != high && is_in_plane(low) && is_in_plane(high))
          sides.push_back({{low, high}, region_of_[face]});
      }
    std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
      return std::tie(a.ends, a.region) < std::tie(b.ends, b.region);
    });
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].ends == sides[begin].ends)
        ++end;
      if (sides[begin].region != sides[end - 1].region ||
          (end == begin + 1 && sides[begin].region != none))
        input_.planes.outlines.push_back(sides[begin].ends);
    }
  }

  // Faces of different regions get different labels, in addition to those of the user.
  void label() {
    std::map<std::pair<Index, Index>, Index> labels;
    const auto input_face = [&](Index face) {
      return input_.input_faces.empty() ? face : input_.input_faces[face];
    };
    if (input_.labels.empty()) {
      Index last = 0;
      for (Index face = 0; face < region_of_.size(); ++face)
        last = (std::max)(last, input_face(face));
      input_.labels.resize(last + 1, 0);
    }
    for (Index face = 0; face < region_of_.size(); ++face) {
      Index& label = input_.labels[input_face(face)];
      label = labels.try_emplace({label, region_of_[face]}, static_cast<Index>(labels.size()))
                  .first->second;
    }
  }

  SurfaceInput<N>& input_;
  Scale<N> scale_; // between the mesh's unit and that of everything here
  double height_, rounding_ = 0;
  std::vector<Vector<3>> positions_;
  std::vector<PlaneRegion> regions_;
  std::vector<Index> region_of_;                // of each face
  std::map<std::vector<Index>, Index> numbers_; // of sets of regions
  std::vector<Placed> placed_;
  int rounds_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PLANE_REGIONS_H
