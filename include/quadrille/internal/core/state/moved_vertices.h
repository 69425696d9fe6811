#ifndef QUADRILLE_INTERNAL_CORE_STATE_MOVED_VERTICES_H
#define QUADRILLE_INTERNAL_CORE_STATE_MOVED_VERTICES_H

#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/geometry.h>

#include <cstddef>
#include <tuple>
#include <utility>

namespace quadrille::internal {

/// Which vertices no longer lie where they were in the input.
template <std::size_t N>
class MovedVertices {
public:
  explicit MovedVertices(const Geometry<N>& geometry, Workspace* workspace)
      : geometry_(geometry), is_moved_(geometry.positions().size(), 0, workspace) {}

  static auto vertex_columns(auto& self) { return std::tie(self.is_moved_); }

  /// Before the vertex takes its place.
  template <class Event>
  void contract(const Event& event) {
    is_moved_[event.kept] |= event.contraction.target() != geometry_.position(event.kept);
  }

  /// All of it, which is no longer here then.
  Array<unsigned char> take() { return std::move(is_moved_); }

private:
  const Geometry<N>& geometry_;
  Array<unsigned char> is_moved_; // no bits: threads write to it
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_MOVED_VERTICES_H
