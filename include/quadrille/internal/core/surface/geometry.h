#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_GEOMETRY_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_GEOMETRY_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The positions of the vertices of a surface, their one-ring radii, and which of them are fixed.
template <std::size_t N>
class Geometry {
public:
  using Position = Vector<N>;

  /// `is_fixed` is empty if no vertex is fixed.
  Geometry(const TriangleComplex& complex, Array<Position> positions, std::vector<bool> is_fixed,
           Threads threads)
      : positions_(std::move(positions)),
        squared_ring_radius_(positions_.size(), 0, complex.arena()),
        displacements_(positions_.size(), not_thin, complex.arena()),
        is_fixed_(std::move(is_fixed)) {
    for_each_range(threads, positions_.size(), [&](const auto& range, std::size_t) {
      this->measure_ring_radius(complex, range);
    });
  }

  const Array<Position>& positions() const { return positions_; }
  const Position& position(Index v) const { return positions_[v]; }
  /// The square of the distance to the farthest neighbour, as it was when the vertex took its
  /// place. It stays as it is while neighbours move: the cost of a pair depends on nothing that can
  /// change while the pair waits in the queue.
  float squared_ring_radius(Index v) const { return squared_ring_radius_[v]; }
  /// Was an edge very close to another, as in thin features, when the vertex took its place?
  bool is_thin(Index v) const { return displacements_[v] != not_thin; }
  /// An upper limit of the distance from places in thin features that have been contracted to the
  /// vertex to the faces around it: see feature_loss_of.
  double feature_loss(Index v) const {
    return static_cast<double>((std::max)(0.0f, displacements_[v]));
  }
  bool is_fixed(Index v) const { return !is_fixed_.empty() && is_fixed_[v]; }
  void fix(Index v) {
    is_fixed_.resize(positions_.size(), false);
    is_fixed_[v] = true;
  }
  bool is_any_fixed() const { return !is_fixed_.empty(); }

  static auto vertex_arrays(auto& self) {
    return std::tie(self.positions_, self.squared_ring_radius_, self.displacements_,
                    self.is_fixed_);
  }

  /// Asks for what costs need of a vertex.
  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const {
    internal::prefetch(&positions_[v]);
    internal::prefetch(&squared_ring_radius_[v]);
  }

  /// The vertex that a contraction has left takes its place.
  template <class Event>
  void contract(const Event& event) {
    positions_[event.kept] = event.contraction.target();
    const bool is_high_valence =
        event.contraction.star().high_valence == event.kept; // it keeps other neighbours
    float farthest = is_high_valence ? squared_ring_radius_[event.kept] : 0;
    float nearest = std::numeric_limits<float>::infinity();
    event.contraction.star().for_each_changed([&](const StarFace& f) {
      const float second = squared_length_of(event.kept, f.second);
      const float third = squared_length_of(event.kept, f.third);
      farthest = (std::max)(farthest, (std::max)(second, third));
      nearest = (std::min)(nearest, second); // most neighbours are the second of one face
    });
    squared_ring_radius_[event.kept] = farthest;
    const bool is_any_thin = event.feature_loss.displacement > 0 || is_thin(nearest, farthest);
    displacements_[event.kept] =
        is_any_thin ? static_cast<float>(event.feature_loss.displacement) : not_thin;
  }

  /// The positions, which are no longer here then.
  Array<Position> take_positions() { return std::move(positions_); }

private:
  template <class R>
  void measure_ring_radius(const TriangleComplex& complex, const R& range) {
    complex.for_each_face_at(range, [&](const TriangleComplex::Triangle& corners) {
      const auto [p, q, r] = corners;
      const float pq = squared_length_of(p, q), qr = squared_length_of(q, r),
                  rp = squared_length_of(r, p);
      const auto extend = [&](Index v, float a, float b) {
        if (range.contains(v))
          squared_ring_radius_[v] = (std::max)(squared_ring_radius_[v], (std::max)(a, b));
      };
      extend(p, pq, rp);
      extend(q, pq, qr);
      extend(r, qr, rp);
      if (is_thin((std::min)((std::min)(pq, qr), rp), (std::max)((std::max)(pq, qr), rp)))
        for (Index v : corners)
          if (range.contains(v))
            displacements_[v] = 0;
    });
  }

  static constexpr float not_thin = -1;
  static bool is_thin(float squared_edge, float squared_other) {
    return 256 * squared_edge < squared_other;
  }

  float squared_length_of(Index v, Index w) const {
    return static_cast<float>(squared_distance(space(positions_[v]), space(positions_[w])));
  }

  Array<Position> positions_;
  Array<float> squared_ring_radius_;
  Array<float> displacements_; // see feature_loss
  std::vector<bool> is_fixed_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_GEOMETRY_H
