#ifndef QUADRILLE_INTERNAL_PLANAR_PATCH_REMESHER_H
#define QUADRILLE_INTERNAL_PLANAR_PATCH_REMESHER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/planar/patch_boundaries.h>
#include <quadrille/internal/planar/patch_growth.h>
#include <quadrille/internal/planar/patch_triangulation.h>
#include <quadrille/internal/planar/remeshed_surface.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Triangulates all patches again between their kept vertices.
///
/// If that fails for a patch, all vertices of its boundary are restored, also for the adjacent
/// patches; if it still fails, its faces stay as they are. It fails if the patch can't be
/// triangulated, if its topology would change, or if one of its new edges has the same ends as
/// another edge.
class PatchRemesher {
public:
  /// The amount of a patch that stays.
  enum class Kept : unsigned char { corners, boundary, all };

  PatchRemesher(std::span<const Vector<3>> positions, const SurfaceSides& sides,
                std::vector<PlanarPatch> patches, const std::vector<Index>& patch_of,
                PatchBoundaries& boundaries)
      : sides_(sides), patches_(std::move(patches)), patch_of_(patch_of), boundaries_(boundaries),
        triangulation_(positions, sides, boundaries), states_(patches_.size()),
        is_waiting_(patches_.size(), 1) {
    for (Index corner : boundaries.closed_sectors()) {
      State& state = states_[patch_of[SurfaceSides::face(corner)]];
      ++state.closed_sectors;
      if (boundaries.is_kept(sides.to(corner)))
        state.inner.push_back(corner);
    }
    list_ends();
  }

  void remesh() {
    for (Index p = 0; p < patches_.size(); ++p)
      waiting_.push_back(p);
    do {
      while (!waiting_.empty()) {
        const Index patch = waiting_.back();
        waiting_.pop_back();
        is_waiting_[patch] = 0;
        remesh(patch);
      }
      separate();
    } while (!waiting_.empty());
  }

  Array<RemeshedFace> faces() const {
    Array<RemeshedFace> faces;
    for (Index p = 0; p < patches_.size(); ++p)
      append_faces(p, faces);
    std::sort(faces.begin(), faces.end(),
              [](const RemeshedFace& a, const RemeshedFace& b) { return a.input < b.input; });
    return faces;
  }
  std::size_t patch_count() const { return patches_.size(); }
  /// Returns the number of patches that kept this much because they could not be triangulated with
  /// less.
  std::size_t count(Kept kept) const {
    return static_cast<std::size_t>(std::count_if(
        states_.begin(), states_.end(), [&](const State& state) { return state.kept == kept; }));
  }

private:
  struct State {
    Kept kept = Kept::corners;
    std::size_t closed_sectors = 0;
    std::vector<Index> inner;             // the corners of kept vertices inside
    bool is_new = false;                  // otherwise the faces are as they were
    std::vector<PatchTriangle> triangles; // if it is
  };

  // Lists the boundary sides that lead to each vertex.
  void list_ends() {
    for (Index s = 0; s < sides_.size(); ++s)
      if (boundaries_.is_boundary(s))
        ends_.push_back({sides_.to(s), s});
    std::sort(ends_.begin(), ends_.end());
  }

  void remesh(Index patch) {
    State& state = states_[patch];
    state.is_new = false;
    state.triangles.clear();
    if (state.kept == Kept::all || has_all(patch))
      return;
    const std::vector<BoundarySection> boundary = boundary_of(patch);
    auto triangles = triangulation_.triangulate(patches_[patch].normal, boundary, state.inner);
    if (!triangles || !has_same_topology(patch, boundary.size(), triangles->size()))
      return keep_more(patch);
    state.is_new = true;
    state.triangles = std::move(*triangles);
  }

  template <class Visit>
  void for_each_side(Index patch, Visit visit) const {
    for (Index f : patches_[patch].faces)
      for (Index s = 3 * f; s < 3 * f + 3; ++s)
        visit(s);
  }

  // Are all vertices of the patch kept?
  bool has_all(Index patch) const {
    bool are_all = true;
    for_each_side(patch, [&](Index s) { are_all &= boundaries_.is_kept(sides_.to(s)); });
    return are_all;
  }

  std::vector<BoundarySection> boundary_of(Index patch) const {
    std::vector<BoundarySection> sections;
    for_each_side(patch, [&](Index s) {
      if (!boundaries_.is_boundary(s) || !boundaries_.is_kept(sides_.to(s)))
        return;
      Index end = boundaries_.next(s);
      while (!boundaries_.is_kept(sides_.to(end)))
        end = boundaries_.next(end);
      sections.push_back({s, end});
    });
    return sections;
  }

  // Checks that faces - edges + vertices, counted inside, is as before. A face has three sides, and
  // two sides form an edge inside.
  bool has_same_topology(Index patch, std::size_t boundary, std::size_t faces) const {
    std::size_t boundary_before = 0;
    for_each_side(patch, [&](Index s) { boundary_before += boundaries_.is_boundary(s); });
    const State& state = states_[patch];
    return boundary + 2 * state.inner.size() + patches_[patch].faces.size() ==
           boundary_before + 2 * state.closed_sectors + faces;
  }

  void keep_more(Index patch) {
    State& state = states_[patch];
    state.kept = state.kept == Kept::corners ? Kept::boundary : Kept::all;
    wait(patch);
    for_each_side(patch, [&](Index s) {
      const Index v = sides_.to(s);
      if (!boundaries_.is_boundary(s) || boundaries_.is_kept(v))
        return;
      boundaries_.keep(v);
      for (auto end = std::lower_bound(ends_.begin(), ends_.end(), End{v, 0});
           end != ends_.end() && end->first == v; ++end)
        wait(patch_of_[SurfaceSides::face(end->second)]);
    });
  }
  void wait(Index patch) {
    if (is_waiting_[patch])
      return;
    is_waiting_[patch] = 1;
    waiting_.push_back(patch);
  }

  // Keeps more of a patch if an edge inside has the same ends as another edge, or if its only
  // triangle has the same corners as another face.
  void separate() {
    std::vector<Index> unlike;
    std::vector<Named<2>> edges;
    std::vector<Named<3>> triangles;
    Array<RemeshedFace> faces;
    for (Index p = 0; p < patches_.size(); ++p) {
      faces.clear();
      append_faces(p, faces);
      const bool is_sole = states_[p].is_new && faces.size() == 1;
      for (std::size_t i = 0; i < faces.size(); ++i) {
        triangles.push_back({named(faces[i].corners), is_sole ? p : none});
        for (std::size_t k = 0; k < 3; ++k) {
          const Index v = faces[i].corners[k], w = faces[i].corners[(k + 2) % 3];
          const bool is_inside = states_[p].is_new && states_[p].triangles[i].mates[k] != none;
          if (!is_inside || sides_.to(v) < sides_.to(w)) // one side of each edge inside
            edges.push_back({named(std::array{v, w}), is_inside ? p : none});
        }
      }
    }
    add_doubled(edges, unlike);
    add_doubled(triangles, unlike);
    std::sort(unlike.begin(), unlike.end());
    unlike.erase(std::unique(unlike.begin(), unlike.end()), unlike.end());
    for (Index patch : unlike)
      keep_more(patch);
  }

  // Vertices in ascending order, and the patch that must keep more if they occur twice; or none.
  template <std::size_t n>
  struct Named {
    std::array<Index, n> vertices;
    Index patch;
    auto operator<=>(const Named&) const = default;
  };
  template <std::size_t n>
  std::array<Index, n> named(std::array<Index, n> corners) const {
    for (Index& corner : corners)
      corner = sides_.to(corner);
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  template <std::size_t n>
  static void add_doubled(std::vector<Named<n>>& all, std::vector<Index>& unlike) {
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].patch != none && ((i > 0 && all[i].vertices == all[i - 1].vertices) ||
                                   (i + 1 < all.size() && all[i].vertices == all[i + 1].vertices)))
        unlike.push_back(all[i].patch);
  }

  void append_faces(Index patch, Array<RemeshedFace>& faces) const {
    const State& state = states_[patch];
    if (!state.is_new) {
      for (Index f : patches_[patch].faces)
        faces.push_back({f, {3 * f, 3 * f + 1, 3 * f + 2}, {3 * f, 3 * f + 1, 3 * f + 2}});
      return;
    }
    std::vector<Index> free; // one side of each edge that was inside
    for_each_side(patch, [&](Index s) {
      if (!boundaries_.is_boundary(s) && s < sides_.mate(s))
        free.push_back(s);
    });
    const std::size_t begin = faces.size();
    for (std::size_t i = 0; i < state.triangles.size(); ++i) {
      const PatchTriangle& triangle = state.triangles[i];
      faces.push_back({patches_[patch].faces[i], triangle.corners, triangle.corners});
    }
    for (Index i = 0; i < state.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (const Index mate = state.triangles[i].mates[k]; mate != none && i < mate) {
          const auto& back = state.triangles[mate].mates;
          const auto at =
              static_cast<std::size_t>(std::find(back.begin(), back.end(), i) - back.begin());
          faces[begin + i].sides[k] = free.back();
          faces[begin + mate].sides[at] = sides_.mate(free.back());
          free.pop_back();
        }
  }

  using End = std::pair<Index, Index>; // a vertex, and a boundary side that leads to it

  const SurfaceSides& sides_;
  std::vector<PlanarPatch> patches_;
  const std::vector<Index>& patch_of_;
  PatchBoundaries& boundaries_;
  PatchTriangulation triangulation_;
  std::vector<State> states_;
  std::vector<unsigned char> is_waiting_;
  std::vector<Index> waiting_;
  std::vector<End> ends_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PATCH_REMESHER_H
