#ifndef QUADRILLE_INTERNAL_VISIBILITY_CLOSED_REMOVAL_H
#define QUADRILLE_INTERNAL_VISIBILITY_CLOSED_REMOVAL_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/visibility/face_rays.h>
#include <quadrille/internal/visibility/hidden_caps.h>
#include <quadrille/internal/visibility/ray_directions.h>
#include <quadrille/internal/visibility/ray_tree.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Removes hidden faces so that nothing is opened, and nothing that is seen gets hidden.
///
/// Each loop of edges between removed faces and others gets a cap. A component of the surface that
/// is not seen any longer behind the caps of other components is removed, too: it was seen through
/// openings that are closed now. A cap that hides what is seen is taken back: where most of the
/// rays that reach it from outside would go on to faces that stay, or through the surface, faces
/// around it stay, and if that does not help, all hidden faces that are connected with it.
class ClosedRemoval {
public:
  ClosedRemoval(const SurfaceView& surface, const std::vector<bool>& is_hidden,
                std::size_t directions, double threshold, bool is_front_only)
      : scale_(Box<3>(surface.points), true),
        points_(
            scale_.scaled(std::vector<Vector<3>>(surface.points.begin(), surface.points.end()))),
        caps_({points_, surface.triangles}, is_hidden), directions_(directions),
        threshold_(threshold), is_front_only_(is_front_only) {
    for (std::size_t round = 0;; ++round) {
      is_removed_ = caps_.is_removed();
      is_left_out_.assign(caps_.caps().size(), false);
      if (caps_.caps().empty())
        return;
      const Scene scene(caps_);
      remove_unseen_components(scene);
      const std::vector<std::size_t> hiding = hiding_caps(scene);
      if (hiding.empty())
        return;
      round < most_retreats ? caps_.retreat(hiding) : caps_.give_up(hiding);
    }
  }

  const HalfEdges& surface() const { return caps_.surface(); }
  const std::vector<bool>& is_removed() const { return is_removed_; }

  /// Calls visit(cap, middle) for each cap, with its added point in the unit of the surface.
  template <class Visit>
  void for_each_cap(Visit visit) const {
    for (std::size_t c = 0; c < caps_.caps().size(); ++c)
      if (!is_left_out_[c])
        visit(caps_.caps()[c], scale_.position_of_mesh(caps_.caps()[c].middle));
  }

private:
  static constexpr std::size_t most_retreats = 3, kinds = 16, refinement = 16;
  static constexpr std::size_t rays_of_cap = 512;

  /// The surface with all caps.
  struct Scene {
    explicit Scene(const HiddenCaps& caps)
        : faces(caps.surface().faces()), tree(view(caps)), slots(tree.size()) {
      for (Index slot = 0; slot < tree.size(); ++slot)
        slots[tree.face(slot)] = slot;
    }
    bool is_cap(Index slot) const { return tree.face(slot) >= faces; }
    std::size_t cap(Index slot) const { return cap_of[tree.face(slot) - faces]; }

    std::size_t faces; // of the surface; those of caps follow
    std::vector<std::size_t> cap_of;
    std::vector<Index> first_of; // of each cap, its first face
    RayTree tree;
    std::vector<Index> slots; // of faces

  private:
    TriangleSoup<> view(const HiddenCaps& caps) {
      TriangleSoup<> soup;
      const HalfEdges& surface = caps.surface();
      for (Index v = 0; v < surface.vertices(); ++v)
        soup.points.push_back(surface.point(v));
      for (Index face = 0; face < surface.faces(); ++face)
        soup.triangles.push_back(surface.triangle(face));
      for (std::size_t c = 0; c < caps.caps().size(); ++c) {
        const HiddenCap& cap = caps.caps()[c];
        first_of.push_back(static_cast<Index>(soup.triangles.size()));
        if (cap.has_middle)
          soup.points.push_back(cap.middle);
        for (const auto& triangle : cap.triangles) {
          auto& corners = soup.triangles.emplace_back();
          for (std::size_t k = 0; k < 3; ++k)
            corners[k] = triangle[k] < cap.sides.size()
                             ? surface.origin(cap.sides[triangle[k]])
                             : static_cast<Index>(soup.points.size() - 1);
          cap_of.push_back(c);
        }
      }
      first_of.push_back(static_cast<Index>(soup.triangles.size()));
      return soup;
    }
  };

  // Components have no vertex in common.
  void remove_unseen_components(const Scene& scene) {
    const std::vector<Index> component_of = components();
    const auto component = [&](std::size_t face) {
      return component_of[caps_.surface().triangle(static_cast<Index>(face))[0]];
    };
    const auto component_of_cap = [&](std::size_t cap) {
      return component_of[caps_.surface().origin(caps_.caps()[cap].sides.front())];
    };
    std::vector<std::vector<Index>> faces(component_of.size());
    std::vector<bool> has_cap(component_of.size(), false);
    for (std::size_t c = 0; c < caps_.caps().size(); ++c)
      has_cap[component_of_cap(c)] = true;
    for (Index face = 0; face < scene.faces; ++face)
      if (!caps_.is_removed()[face] && has_cap[component(face)])
        faces[component(face)].push_back(face);
    for (std::size_t p = 0; p < faces.size(); ++p) {
      const auto is_seen = [&](Index face) {
        return this->is_seen(scene, scene.slots[face], [&](std::size_t slot) {
          const auto s = static_cast<Index>(slot);
          return scene.is_cap(s) ? component_of_cap(scene.cap(s)) == p
                                 : caps_.is_removed()[scene.tree.face(s)];
        });
      };
      if (std::any_of(faces[p].begin(), faces[p].end(), is_seen))
        continue;
      for (const Index face : faces[p])
        is_removed_[face] = true;
      for (std::size_t c = 0; c < caps_.caps().size() && !faces[p].empty(); ++c)
        is_left_out_[c] = is_left_out_[c] || component_of_cap(c) == p;
    }
  }
  // Returns of each vertex one that stands for its component.
  std::vector<Index> components() const {
    std::vector<Index> parent(caps_.surface().vertices());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&](Index v) {
      while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for (Index face = 0; face < caps_.surface().faces(); ++face)
      if (!caps_.is_removed()[face])
        for (const Index v : caps_.surface().triangle(face))
          parent[root(v)] = root(caps_.surface().triangle(face)[0]);
    for (Index v = 0; v < parent.size(); ++v)
      parent[v] = root(v);
    return parent;
  }

  // Is a face seen between those that are not ignored?
  template <class Ignores>
  bool is_seen(const Scene& scene, Index slot, Ignores ignores) const {
    RayCounts counts;
    const std::size_t enough = 4 + static_cast<std::size_t>(threshold_ * 64);
    for (std::size_t round = 0; round <= refinement; ++round) {
      for_each_ray(scene, slot, round, [&](const Ray& ray, const Vector<3>&, std::size_t side) {
        Index recent = none;
        ++counts.rays[side];
        counts.free[side] +=
            scene.tree.is_blocked(
                ray, [&](std::size_t s) { return s == slot || ignores(s); }, recent)
                ? 0
                : 1;
      });
      if (counts.most_free() == 0)
        return false; // more rays are for those of which some are free
      if (round == 0 && counts.most_free() >= enough)
        return true;
    }
    return counts.fraction() > threshold_;
  }

  template <class Visit>
  void for_each_ray(const Scene& scene, Index slot, std::size_t round, Visit visit) const {
    const std::array<Vector<3>, 3> corners = scene.tree.corners(slot);
    const Vector<3> normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const Vector<3>& direction = directions_(kinds * round + slot % kinds, i);
      const std::size_t side = dot(direction, normal) < 0 ? 1 : 0;
      if (side == 1 && is_front_only_)
        continue;
      const Vector<3> point = FaceRays::point(corners, slot + round * directions_.size() + i);
      visit(Ray(point, direction), point, side);
    }
  }

  // Caps that most rays which reach them from outside would pass to faces that stay.
  std::vector<std::size_t> hiding_caps(const Scene& scene) const {
    std::vector<std::size_t> hiding;
    for (std::size_t c = 0; c < caps_.caps().size(); ++c)
      if (!is_left_out_[c] && hides(scene, c))
        hiding.push_back(c);
    return hiding;
  }
  bool hides(const Scene& scene, std::size_t cap) const {
    const auto is_cap = [&](std::size_t slot) { return scene.is_cap(static_cast<Index>(slot)); };
    const Index first = scene.first_of[cap], last = scene.first_of[cap + 1];
    std::size_t all = 0, free = 0, hidden = 0;
    for (std::size_t round = 0; all < rays_of_cap; ++round)
      for (Index face = first; face < last; ++face)
        for_each_ray(scene, scene.slots[face], round,
                     [&](const Ray& ray, const Vector<3>&, std::size_t) {
                       Index recent = none;
                       ++all;
                       if (scene.tree.is_blocked(ray, is_cap, recent))
                         return;
                       ++free;
                       const Index behind = scene.tree.nearest(ray.reversed(), is_cap);
                       hidden += behind != none && is_removed_[scene.tree.face(behind)] ? 1 : 0;
                     });
    const auto seen = static_cast<double>(free - hidden);
    return seen > threshold_ * static_cast<double>(all) && 2 * seen > static_cast<double>(free);
  }

  Scale<3> scale_;
  std::vector<Vector<3>> points_;
  HiddenCaps caps_;
  RayDirections directions_;
  double threshold_;
  bool is_front_only_;
  std::vector<bool> is_removed_;  // by faces
  std::vector<bool> is_left_out_; // by caps: their components are removed
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_CLOSED_REMOVAL_H
