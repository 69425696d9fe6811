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
/// Guards of one's own: what stays true of the surface from the first contraction to the last.

namespace quadrille {

/// The surface as a guard sees it before the first contraction, in the mesh's units. Indices are
/// those of the input, as for filters (see FilterPolicy); what is no part of the surface, as an
/// unused vertex or a degenerate face, is left out.
struct GuardedSurface {
  /// A vertex, by its index in the input.
  struct Vertex {
    std::size_t index; ///< below vertex_count
    Vector<3> point;   ///< in the mesh's units
  };
  /// A face, by its index in the input. One with a back counts once.
  struct Face {
    std::size_t index;                   ///< below face_count
    std::array<std::size_t, 3> vertices; ///< their indices, in the order of the face
  };

  std::vector<Vertex> vertices; ///< in no order that is promised
  std::vector<Face> faces;      ///< in no order that is promised
  std::size_t vertex_count;     ///< of the input, unused ones counted
  std::size_t face_count;       ///< of the input, degenerate ones counted
};

namespace internal {

/// A contraction that has been done: what a filter sees before it, and which end is kept.
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

/// What the guard of a user makes to guard a surface with.
template <class Guard>
using GuardStateOf =
    decltype(std::declval<const Guard&>().begin(std::declval<const GuardedSurface&>()));

} // namespace internal

/// **Guard**: does something stay true that depends on what has been done before? A filter is asked
/// about one contraction; a guard also sees the surface before the first, and each that is done.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** of one's own. NoSelfIntersection, KeepSolid and NormalDeviation are arguments of
/// the same kind, which look at the engine's surface itself.
///
/// **Requirements**, for a constant `guard` and what it begins with, `auto state =
/// guard.begin(surface)`, where `surface` is a GuardedSurface; it is movable, and need not be
/// constant:
///
/// - `state.allows(contraction)`: a bool; `contraction` is as for a FilterPolicy. It may be asked
///   several times of one contraction, with several targets, and not all that it allows are done:
///   so it changes nothing. A pair that it refuses is asked about again once a face at one of its
///   ends has changed; see has_obstacles.
/// - `state.follow(contraction)`: that has been done, to its target(). The contraction shows what
///   it showed before: the old places of the ends, the faces that have changed and those that have
///   gone. `contraction.kept()` is the end whose index the new vertex has; the other one has no
///   vertex any more. A vertex of more than 128 faces that keeps its place is the one that is kept.
///
/// **Used where there**:
///
/// - `G::name`: a constant string that messages call it by.
/// - `G::cause`: the Rejection that counts where it says no; Rejection::filter without it.
/// - `G::works_in_passes`, true: several threads may ask the state at a time, and tell it of
///   contractions that have no face in common. Without it the guard is for GreedyOrder only.
/// - `G::works_in_parts`, true: what holds in each part of a file, where every phase begins anew,
///   holds in all of it. Without it `simplify_file` does not take the guard.
/// - `G::has_obstacles`, true: what it says no to depends on more than the faces around the pair.
///   Then ends of the pair are tried as well, and refused pairs have another turn once no others
///   are left, as long as that pays.
/// - `G::topology`: the Topology that it keeps. A call with another one throws; without a Topology
///   it is that one, whatever the pairs are.
/// - `G::asks_for_volume`, true: the surface is known to enclose a volume, which Report tells.
/// - `state.vanish(faces)`: a part is about to go whole; `faces` are the indices of its faces that
///   are left, a range. It has no say in that: ask for Topology::kept where parts have to stay.
/// - `state.end()`: the last contraction has been done. A guard tells its user what it found by a
///   pointer that it holds, as Report has no place for it.
/// - `guard.validate()`: throws if the guard makes no sense.
///
/// Where topology is free, faces that come to lie on the vertices of another one go without being
/// told of. Where a call has guards, vertices go to places that can be written to the mesh as they
/// are, so that what is allowed is what is written.
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

/// Guards a surface as the user's guard says.
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
  std::optional<GuardStateOf<Guard>> state_; // once it has begun
};

template <class Guard, std::size_t N>
struct MadeByUser {
  static_assert(GuardPolicy<Guard>,
                "What a guard begins with has members allows(contraction), a bool, and "
                "follow(contraction): see GuardPolicy in <quadrille/guard.h>.");

  static std::unique_ptr<SurfaceGuard<N>> make(const Guard& guard, const GuardRoom<N>& room) {
    return std::make_unique<UserGuard<Guard, N>>(guard, room);
  }
};

} // namespace internal

} // namespace quadrille

#endif // QUADRILLE_GUARD_H
