#ifndef QUADRILLE_INTERNAL_SURFACE_GEOMETRY_H
#define QUADRILLE_INTERNAL_SURFACE_GEOMETRY_H

#include <quadrille/internal/base/ranges.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Where the vertices of a surface lie, how far their neighbours are, and which of them are fixed.
template <std::size_t N>
class Geometry {
public:
  using Position = Vector<N>;

  /// `is_fixed` is empty if no vertex is fixed.
  Geometry(const TriangleComplex& complex, Array<Position> positions, std::vector<bool> is_fixed,
           Threads threads)
      : positions_(std::move(positions)), squared_reach_(positions_.size(), 0, complex.workspace()),
        is_fixed_(std::move(is_fixed)) {
    for_each_range(threads, positions_.size(),
                   [&](const auto& range, std::size_t) { this->measure_reach(complex, range); });
  }

  const Array<Position>& positions() const { return positions_; }
  const Position& position(Index v) const { return positions_[v]; }
  /// The square of the distance to the farthest neighbour, as it was when the vertex took its
  /// place. It stays as it is while neighbours move: the cost of a pair depends on nothing that can
  /// change while the pair waits in the queue.
  float squared_reach(Index v) const { return squared_reach_[v]; }
  bool is_fixed(Index v) const { return !is_fixed_.empty() && is_fixed_[v]; }
  void fix(Index v) {
    is_fixed_.resize(positions_.size(), false);
    is_fixed_[v] = true;
  }
  bool is_any_fixed() const { return !is_fixed_.empty(); }

  static auto vertex_columns(auto& self) {
    return std::tie(self.positions_, self.squared_reach_, self.is_fixed_);
  }

  /// The vertex that a contraction has left takes its place.
  template <class Event>
  void after(const Event& event) {
    positions_[event.kept] = event.contraction.target();
    float reach = 0;
    event.contraction.star().for_each_changed([&](const StarFace& f) {
      for (Index w : {f.second, f.third})
        reach = (std::max)(reach, squared_length_of(event.kept, w));
    });
    squared_reach_[event.kept] = reach;
  }

  /// The positions, which are no longer here then.
  Array<Position> take_positions() { return std::move(positions_); }

private:
  template <class R>
  void measure_reach(const TriangleComplex& complex, const R& range) {
    complex.for_each_face_at(range, [&](const TriangleComplex::Triangle& corners) {
      const auto [p, q, r] = corners;
      const float pq = squared_length_of(p, q), qr = squared_length_of(q, r),
                  rp = squared_length_of(r, p);
      const auto reaches = [&](Index v, float a, float b) {
        if (range.contains(v))
          squared_reach_[v] = (std::max)({squared_reach_[v], a, b});
      };
      reaches(p, pq, rp);
      reaches(q, pq, qr);
      reaches(r, qr, rp);
    });
  }

  float squared_length_of(Index v, Index w) const {
    return static_cast<float>(squared_distance(space(positions_[v]), space(positions_[w])));
  }

  Array<Position> positions_;
  Array<float> squared_reach_;
  std::vector<bool> is_fixed_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_SURFACE_GEOMETRY_H
