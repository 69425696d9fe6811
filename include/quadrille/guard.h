#ifndef QUADRILLE_GUARD_H
#define QUADRILLE_GUARD_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/core/policy/contraction_view.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// \file
/// User-defined guards: they keep a property of the surface from the first contraction to the last.

namespace quadrille {

/// The surface as a guard sees it before the first contraction, in the mesh's units. Indices are
/// those of the input, as for filters (see FilterPolicy); unused vertices and degenerate faces,
/// which do not belong to the surface, are left out.
struct GuardedSurface {
  /// A vertex, by its index in the input.
  struct Vertex {
    std::size_t index; ///< below vertex_count
    Vector<3> point;   ///< in the mesh's units
  };
  /// A face, by its index in the input. A double-sided face counts once.
  struct Face {
    std::size_t index;                   ///< below face_count
    std::array<std::size_t, 3> vertices; ///< their indices, in the order of the face
  };

  std::vector<Vertex> vertices; ///< in an unspecified order
  std::vector<Face> faces;      ///< in an unspecified order
  std::size_t vertex_count;     ///< vertices of the input, including unused ones
  std::size_t face_count;       ///< faces of the input, including degenerate ones
};

namespace internal {

/// A contraction that has been done: a FilterPolicy's view from before it, and the end that is
/// kept.
template <std::size_t N>
class FollowedContraction : public ContractionInMeshUnits<N> {
public:
  FollowedContraction(const IndexedContraction<N>& contraction, const Scale<N>& scale,
                      std::size_t kept)
      : ContractionInMeshUnits<N>(contraction, scale), kept_(kept) {}

  /// The end whose index the new vertex has.
  std::size_t kept() const { return kept_; }

private:
  std::size_t kept_;
};

/// The type of the state that a user's guard makes for a surface.
template <class Guard>
using GuardStateOf =
    decltype(std::declval<const Guard&>().begin(std::declval<const GuardedSurface&>()));

} // namespace internal

/// **Guard**: keeps a property that depends on earlier contractions. A filter sees one contraction;
/// a guard also sees the surface before the first contraction, and each contraction that is done.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** defined by users. NoSelfIntersection, KeepSolid and NormalDeviation are similar
/// arguments, which read the engine's surface directly.
///
/// **Requirements**, for a constant `guard` and its state `auto state = guard.begin(surface)`,
/// where `surface` is a GuardedSurface. The state is movable and need not be constant:
///
/// - `state.allows(contraction)`: a bool; `contraction` is as for a FilterPolicy. It may be called
///   several times for one contraction, with several targets, and an allowed contraction need not
///   be done. So it must not change the state. A rejected pair is tried again once a face at one of
///   its ends has changed; see has_obstacles.
/// - `state.follow(contraction)`: the contraction has been done, to its target(). It shows the same
///   view as before: the old positions of the ends, the changed faces and the removed faces.
///   `contraction.kept()` is the end whose index the new vertex has; the other index is no longer
///   used. A vertex of more than 128 faces that does not move is always the kept one.
///
/// **Used where there**:
///
/// - `G::name`: its name in messages, a constant string.
/// - `G::cause`: the Rejection that counts its rejections; without it Rejection::filter.
/// - `G::works_in_passes`, true: several threads may call the state concurrently, for contractions
///   that have no face in common. Without it the guard works with GreedyOrder only.
/// - `G::works_in_chunks`, true: a property that holds in each chunk of a file, where every phase
///   begins again, holds for the whole file. Without it `simplify_file` does not accept the guard.
/// - `G::has_obstacles`, true: its rejections depend on more than the faces around the pair. The
///   ends of the pair are then tried as targets as well, and rejected pairs are tried again when no
///   others are left, as long as this helps.
/// - `G::topology`: the Topology that it needs. A call with another one throws; a call without a
///   Topology uses this one, whatever the pairs are.
/// - `G::asks_for_volume`, true: the surface is known to enclose a volume, which Report contains.
/// - `state.vanish(faces)`: a component is about to be removed; `faces` is a range of the indices
///   of its remaining faces. The guard cannot reject this: use Topology::kept where components must
///   stay.
/// - `state.end()`: the last contraction has been done. A guard can pass its findings to the user
///   through a pointer, since Report has no field for them.
/// - `guard.validate()`: throws if the guard is invalid.
///
/// If topology is free, faces that come to have the same vertices as another face are removed
/// without notice. In a call with guards, vertices only move to positions that the mesh can
/// represent exactly, so that the written surface is the one that was allowed.
///
/// **The least model**:
/// ```cpp
/// struct AllowsAll {
///   struct State {
///     bool allows(const auto&) const { return true; }
///     void follow(const auto&) {}
///   };
///   State begin(const GuardedSurface&) const { return {}; }
/// };
/// ```
template <class G>
concept GuardPolicy = std::copy_constructible<G> && std::movable<internal::GuardStateOf<G>> &&
    requires(internal::GuardStateOf<G>& state,
             const internal::FollowedContraction<3>& contraction) {
  { state.allows(contraction) } -> std::convertible_to<bool>;
  state.follow(contraction);
};

namespace internal {

/// Guards a surface with the user's guard.
template <class Guard, std::size_t N>
class UserGuard final : public SurfaceGuard<N> {
public:
  UserGuard(const Guard& guard, const GuardRoom<N>& room) : guard_(guard), room_(room) {}

  void begin(Report&) override { state_.emplace(guard_.begin(surface())); }

  bool rejects(const GuardedPair<N>& pair) override {
    return !state_->allows(ContractionInMeshUnits<N>(indexed(pair), room_.scale));
  }

  void follow(const GuardedPair<N>& pair, Index kept) override {
    state_->follow(
        FollowedContraction<N>(indexed(pair), room_.scale, room_.numbering.vertices[kept]));
  }

  bool has_obstacles() const override {
    return requires {
      requires Guard::has_obstacles;
    };
  }

  void forget(std::span<const Index> faces) override {
    if constexpr (requires { state_->vanish(std::span<const std::size_t>()); }) {
      std::vector<std::size_t> indices;
      for (const Index face : faces)
        indices.push_back(room_.numbering.faces[face]);
      state_->vanish(std::span<const std::size_t>(indices));
    }
  }

  void end(Report&) override {
    if constexpr (requires { state_->end(); })
      state_->end();
  }

private:
  GuardedSurface surface() const {
    const InputIndices &vertices = room_.numbering.vertices, &faces = room_.numbering.faces;
    GuardedSurface surface{{}, {}, vertices.input_count(), faces.input_count()};
    for (Index v = 0; v < room_.complex.vertex_capacity(); ++v)
      if (room_.complex.has_faces(v))
        surface.vertices.push_back(
            {vertices[v], space(room_.scale.position_of_mesh(room_.geometry.position(v)))});
    for (Index face = 0; face < room_.complex.face_capacity(); ++face)
      if (!room_.complex.is_removed(face)) {
        const auto& [a, b, c] = room_.complex.vertices(face);
        surface.faces.push_back({faces[face], {vertices[a], vertices[b], vertices[c]}});
      }
    return surface;
  }

  IndexedContraction<N> indexed(const GuardedPair<N>& pair) const {
    const ContractionView<N> view(pair.star, room_.complex, room_.geometry.positions().data(),
                                  pair.first_place, pair.second_place, pair.target);
    return {view, pair.star, pair.first, pair.second, room_.numbering};
  }

  Guard guard_;
  GuardRoom<N> room_;
  std::optional<GuardStateOf<Guard>> state_; // after begin()
};

template <class Guard, std::size_t N>
struct MadeByUser {
  static_assert(
      GuardPolicy<Guard>,
      "The result of a guard's begin() has to have the members allows(contraction), which "
      "returns bool, and follow(contraction): see GuardPolicy in <quadrille/guard.h>.");

  static std::unique_ptr<SurfaceGuard<N>> make(const Guard& guard, const GuardRoom<N>& room) {
    return std::make_unique<UserGuard<Guard, N>>(guard, room);
  }
};

} // namespace internal

} // namespace quadrille

#endif // QUADRILLE_GUARD_H
