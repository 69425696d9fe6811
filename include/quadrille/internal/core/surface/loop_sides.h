#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_LOOP_SIDES_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_LOOP_SIDES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/core/surface/short_loops.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// The kinds of loops, by the result of a cut along them.
enum class LoopKind {
  handle, ///< both sides are one part, which has a handle there
  neck,   ///< they are two parts, both wide, with a tunnel between them
  limb    ///< they are two parts, of which one is narrow, or is joined to the other by a limb
};

/// How much the normals of the faces next to a loop lean towards its middle: positive round a
/// tunnel, and negative round a limb, on a surface that is oriented outwards.
inline double inward_lean(const HalfEdges& surface, const EdgeLoop& loop) {
  Vector<3> middle{};
  for (const Index h : loop.half_edges)
    middle += surface.point(surface.origin(h));
  middle = 1. / static_cast<double>(loop.half_edges.size()) * middle;
  double lean = 0;
  for (const Index h : loop.half_edges) {
    const Vector<3> inwards =
        middle - 0.5 * (surface.point(surface.origin(h)) + surface.point(surface.target(h)));
    for (const Index side : {h, surface.twin(h)}) {
      const auto& [a, b, c] = surface.triangle(HalfEdges::face(side));
      const Vector<3> normal =
          double_area_vector(surface.point(a), surface.point(b), surface.point(c));
      const double length = std::sqrt(squared_length(normal));
      lean += length > 0 ? dot(normal, inwards) / length : 0;
    }
  }
  return lean;
}

/// The width of a loop, which is the side of a square and the diameter of a circle: four times the
/// area inside over the length, as that of a tube, but at least a quarter of the length.
inline double width_of(const HalfEdges& surface, const EdgeLoop& loop) {
  const Vector<3>& origin = surface.point(surface.origin(loop.half_edges.front()));
  Vector<3> doubled_area{};
  for (const Index h : loop.half_edges)
    doubled_area += double_area_vector(origin, surface.point(surface.origin(h)),
                                       surface.point(surface.target(h)));
  return (std::max)(loop.length / 4, 2 * std::sqrt(squared_length(doubled_area)) / loop.length);
}

/// The parts of a surface on both sides of loops.
///
/// Both sides are searched at the same time, the one of which less has been seen first, until they
/// meet or one has been seen entirely. So it takes no longer than seeing the smaller part takes, or
/// what lies around a handle. Parts that were found to be discs are kept in mind: a loop in them
/// is no handle.
class LoopSides {
public:
  explicit LoopSides(const HalfEdges& surface) : surface_(surface) {
    grow();
    double volume = 0;
    for (Index face = 0; face < surface.faces(); ++face)
      if (component_[face] == none) {
        add_component(face);
        volume += shapes_.back().volume;
      }
    is_inside_out_ = volume < 0;
  }

  /// Does a loop run round a tunnel, and not round a limb? What encloses less than it leaves out is
  /// taken for a surface of which the inside is out.
  bool is_round_tunnel(const EdgeLoop& loop) const {
    const double lean = inward_lean(surface_, loop);
    return is_inside_out_ ? lean < 0 : lean > 0;
  }

  /// `width`: a part that is wider counts as wide. The width of a part is four times its volume
  /// over its area, as that of a long tube.
  LoopKind kind(const EdgeLoop& loop, double width) {
    const bool is_round = is_round_tunnel(loop);
    if (!is_round && is_in_disc(loop))
      return LoopKind::limb;
    grow();
    flood(loop);
    if (have_met_)
      return LoopKind::handle;
    smaller_ = is_done(0) ? 0 : 1;
    if (is_round) {
      measure(loop);
      if (small_.width() > width && rest_.width() > width)
        return LoopKind::neck;
    }
    if (euler_number(sides_[smaller_]) == 1)
      mark_disc(sides_[smaller_]);
    return LoopKind::limb;
  }

  /// Is one side of the loop in a part that was found to be a disc?
  bool is_in_disc(const EdgeLoop& loop) {
    grow();
    const auto is_side_in_disc = [&](auto face_at) {
      const Index disc = disc_[face_at(loop.half_edges.front())];
      return disc != 0 && std::all_of(loop.half_edges.begin(), loop.half_edges.end(),
                                      [&](Index h) { return disc_[face_at(h)] == disc; });
    };
    return is_side_in_disc([&](Index h) { return HalfEdges::face(h); }) ||
           is_side_in_disc([&](Index h) { return HalfEdges::face(surface_.twin(h)); });
  }

  /// The surface is cut along a neck: the smaller of its sides is a part of its own from now on.
  void split(const EdgeLoop& neck) {
    flood(neck);
    smaller_ = is_done(0) ? 0 : 1;
    measure(neck);
    shapes_[component_[sides_[smaller_].front()]] = rest_;
    for (const Index face : sides_[smaller_])
      component_[face] = static_cast<Index>(shapes_.size());
    shapes_.push_back(small_);
  }

private:
  struct Shape {
    Vector<3> origin{};
    double volume = 0, area = 0; // of the cones from the origin over the faces, and of the faces
    Vector<3> doubled_area{};    // the sum of the vectors of the faces, zero without a boundary

    double volume_about(const Vector<3>& p) const {
      return volume - dot(p - origin, doubled_area) / 6;
    }
    double width() const { return area > 0 ? 4 * std::abs(volume) / area : 0; }
  };

  // Faces that cuts have added are of the part of a neighbour.
  void grow() {
    const std::size_t old = component_.size();
    component_.resize(surface_.faces(), none);
    disc_.resize(surface_.faces(), 0);
    mark_.resize(surface_.faces(), 0);
    is_in_loop_.resize(3 * surface_.faces(), 0);
    for (auto face = static_cast<Index>(old); old > 0 && face < component_.size(); ++face)
      component_[face] = component_[HalfEdges::face(surface_.twin(3 * face))];
  }

  // All that hangs together with a face.
  void add_component(Index face) {
    const auto component = static_cast<Index>(shapes_.size());
    std::vector<Index>& seen = sides_[0];
    seen.assign(1, face);
    component_[face] = component;
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (Index h = 3 * seen[i]; h < 3 * seen[i] + 3; ++h)
        if (const Index twin = surface_.twin(h);
            twin != none && component_[HalfEdges::face(twin)] == none) {
          component_[HalfEdges::face(twin)] = component;
          seen.push_back(HalfEdges::face(twin));
        }
    shapes_.push_back(shape_of(seen, surface_.point(surface_.triangle(face)[0])));
    if (euler_number(seen) == 2) // no loop on a sphere is a handle
      mark_disc(seen);
  }

  Shape shape_of(const std::vector<Index>& faces, const Vector<3>& origin) const {
    Shape shape{origin};
    for (const Index face : faces) {
      const auto& [a, b, c] = surface_.triangle(face);
      const Vector<3> p = surface_.point(a);
      const Vector<3> normal = double_area_vector(p, surface_.point(b), surface_.point(c));
      shape.volume += dot(p - origin, normal) / 6;
      shape.area += std::sqrt(squared_length(normal)) / 2;
      shape.doubled_area += normal;
    }
    return shape;
  }

  // Counts the vertices of the faces, and not the sheets at them.
  long euler_number(const std::vector<Index>& faces) {
    ++now_;
    time_of_vertex_.resize(surface_.vertices(), 0);
    long vertices = 0, twice_edges = 0;
    for (const Index face : faces)
      mark_[face] = now_;
    for (const Index face : faces)
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        vertices += time_of_vertex_[surface_.origin(h)] != now_;
        time_of_vertex_[surface_.origin(h)] = now_;
        const Index twin = surface_.twin(h);
        twice_edges += twin != none && mark_[HalfEdges::face(twin)] == now_ ? 1 : 2;
      }
    return vertices - twice_edges / 2 + static_cast<long>(faces.size());
  }
  void mark_disc(const std::vector<Index>& faces) {
    ++discs_;
    for (const Index face : faces)
      disc_[face] = discs_;
  }
  void flood(const EdgeLoop& loop) {
    now_ += 2;
    have_met_ = false;
    for (const Index h : loop.half_edges)
      is_in_loop_[h] = is_in_loop_[surface_.twin(h)] = now_;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      sides_[side].clear();
      next_[side] = 0;
      for (const Index h : loop.half_edges)
        see(HalfEdges::face(side == 0 ? h : surface_.twin(h)), side);
    }
    while (!have_met_ && !is_done(0) && !is_done(1))
      go_on(sides_[1].size() < sides_[0].size());
  }
  bool is_done(std::size_t side) const { return next_[side] == sides_[side].size(); }
  void see(Index face, std::size_t side) {
    const auto label = static_cast<std::uint32_t>(now_ - side);
    have_met_ |= mark_[face] == (side == 0 ? now_ - 1 : now_);
    if (mark_[face] == label)
      return;
    mark_[face] = label;
    sides_[side].push_back(face);
  }
  void go_on(std::size_t side) {
    const Index face = sides_[side][next_[side]++];
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      if (const Index twin = surface_.twin(h); twin != none && is_in_loop_[h] != now_)
        see(HalfEdges::face(twin), side);
  }

  // About a point of the cut the faces that close it have hardly any volume.
  void measure(const EdgeLoop& loop) {
    const std::vector<Index>& side = sides_[smaller_];
    const Shape& all = shapes_[component_[side.front()]];
    const Vector<3> p = surface_.point(surface_.origin(loop.half_edges.front()));
    small_ = shape_of(side, p);
    rest_ = {p, all.volume_about(p) - small_.volume, all.area - small_.area,
             all.doubled_area - small_.doubled_area};
  }

  const HalfEdges& surface_;
  std::vector<Index> component_;              // of each face
  std::vector<Shape> shapes_;                 // of each part
  std::vector<std::uint32_t> disc_;           // of each face, 0 for none
  std::vector<std::uint32_t> mark_;           // of each face: now_, or one less on the second side
  std::vector<std::uint32_t> is_in_loop_;     // of each half-edge: now_, if so
  std::vector<std::uint32_t> time_of_vertex_; // now_, if it has been counted
  std::uint32_t now_ = 1, discs_ = 0;
  std::array<std::vector<Index>, 2> sides_; // faces
  std::array<std::size_t, 2> next_{};       // of these, to look around at
  std::size_t smaller_ = 0;
  Shape small_, rest_; // of its sides, at the last neck
  bool have_met_ = false, is_inside_out_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_LOOP_SIDES_H
