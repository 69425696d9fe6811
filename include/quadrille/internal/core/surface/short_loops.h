#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_SHORT_LOOPS_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_SHORT_LOOPS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A closed path along edges: half-edges, each of which begins where the one before it ends.
struct EdgeLoop {
  std::vector<Index> half_edges;
  double length = 0;
};

/// Searches the surroundings of a vertex for short loops through them that bound no disc there.
///
/// A tree of shortest paths from the vertex spans its surroundings. Each edge off the tree closes a
/// loop. The faces there, joined across the edges off the tree, form a tree that hangs at what lies
/// beyond, if they form a disc: taking away leaf after leaf then leaves nothing. Where the
/// surroundings are a tube, or have a handle, edges are left. Source: Erickson and Har-Peled,
/// Optimally cutting a surface into a disk, 2004.
class ShortLoops {
public:
  explicit ShortLoops(const HalfEdges& surface) : surface_(surface) {}

  /// Calls accept(loop) for loops in the surroundings of a vertex, the shortest first, until one is
  /// accepted. Once a loop is not, those that differ from it by a disc only are not tried. Loops
  /// that go further than `radius` from the vertex are not found. Returns whether one was accepted.
  template <class Accept>
  bool search(Index base, double radius, Accept accept) {
    span(base, radius);
    gather_faces();
    for (const Index face : faces_)
      take_leaves(face);
    find_edges();
    for (const auto& [length, h] : edges_) {
      if (!is_open(h))
        continue;
      if (accept(loop_through(h)))
        return true;
      take(h);
      take_leaves(HalfEdges::face(h));
      take_leaves(HalfEdges::face(surface_.twin(h)));
    }
    return false;
  }

  /// Visits the vertices up to a distance from the last base.
  template <class Visit>
  void for_each_within(double distance, Visit visit) const {
    for (const Index v : reached_) {
      if (distance_[v] > distance)
        return;
      visit(v);
    }
  }

private:
  using Entry = std::pair<double, Index>;

  void span(Index base, double radius) {
    ++now_;
    time_.resize(surface_.vertices(), 0);
    distance_.resize(surface_.vertices());
    arrival_.resize(surface_.vertices());
    reached_.clear();
    offer(base, 0, none);
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      const auto [distance, v] = heap_.back();
      heap_.pop_back();
      if (distance > distance_[v])
        continue; // it was reached on a shorter way
      reached_.push_back(v);
      surface_.for_each_out(v, [&, d = distance](Index h) {
        if (const double there = d + surface_.length(h);
            there <= radius && surface_.is_inside(surface_.target(h)))
          offer(surface_.target(h), there, h);
      });
    }
  }
  void offer(Index v, double distance, Index arrival) {
    if (is_reached(v) && distance_[v] <= distance)
      return;
    time_[v] = now_;
    distance_[v] = distance;
    arrival_[v] = arrival;
    heap_.emplace_back(distance, v);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
  bool is_reached(Index v) const { return time_[v] == now_; }

  // The faces of which all corners are reached.
  void gather_faces() {
    time_of_face_.resize(surface_.faces(), 0);
    open_sides_.resize(surface_.faces());
    faces_.clear();
    for (const Index v : reached_)
      surface_.for_each_out(v, [&](Index h) {
        if (h % 3 != 0 || !is_reached(surface_.target(h)) || !is_reached(surface_.origin(h + 2)))
          return;
        const Index face = HalfEdges::face(h);
        time_of_face_[face] = now_;
        open_sides_[face] = 0;
        for (unsigned side = 0; side < 3; ++side)
          if (!is_in_tree(h + side))
            open_sides_[face] |= static_cast<unsigned char>(1U << side);
        faces_.push_back(face);
      });
  }
  bool is_here(Index face) const { return time_of_face_[face] == now_; }
  bool is_in_tree(Index h) const {
    return arrival_[surface_.target(h)] == h || arrival_[surface_.origin(h)] == surface_.twin(h);
  }
  // Is the half-edge of a face here off the tree, and not yet taken away?
  bool is_open(Index h) const { return (open_sides_[HalfEdges::face(h)] >> h % 3 & 1) != 0; }

  // Takes the edge away between the faces at it.
  void take(Index h) {
    for (const Index side : {h, surface_.twin(h)})
      if (const Index face = HalfEdges::face(side); is_here(face))
        open_sides_[face] &= static_cast<unsigned char>(~(1U << side % 3));
  }
  void take_leaves(Index face) {
    while (is_here(face) && std::has_single_bit(open_sides_[face])) {
      const Index h = 3 * face + static_cast<Index>(std::countr_zero(open_sides_[face]));
      take(h);
      face = HalfEdges::face(surface_.twin(h));
    }
  }

  // Lists the edges that are left, by the length of the loop that each closes.
  void find_edges() {
    edges_.clear();
    for (const Index face : faces_)
      for (Index h = 3 * face; open_sides_[face] != 0 && h < 3 * face + 3; ++h) {
        const Index twin = surface_.twin(h);
        if (is_open(h) && (h < twin || !is_here(HalfEdges::face(twin))))
          edges_.emplace_back(length_of_loop(h), h);
      }
    std::sort(edges_.begin(), edges_.end());
  }
  // The common beginning of both paths does not count.
  double length_of_loop(Index h) const {
    Index a = surface_.origin(h), b = surface_.target(h);
    const double length = distance_[a] + surface_.length(h) + distance_[b];
    while (a != b) {
      const bool is_b = arrival_[a] == none || (arrival_[b] != none && distance_[a] < distance_[b]);
      Index& further = is_b ? b : a;
      further = surface_.origin(arrival_[further]);
    }
    return length - 2 * distance_[a];
  }

  // Leaves out the path that goes there and back.
  EdgeLoop loop_through(Index h) const {
    std::vector<Index> there = path_to(surface_.origin(h)), back = path_to(surface_.target(h));
    while (!there.empty() && !back.empty() && there.back() == back.back()) {
      there.pop_back();
      back.pop_back();
    }
    EdgeLoop loop{{there.rbegin(), there.rend()}, 0};
    loop.half_edges.push_back(h);
    for (const Index arriving : back)
      loop.half_edges.push_back(surface_.twin(arriving));
    for (const Index edge : loop.half_edges)
      loop.length += surface_.length(edge);
    return loop;
  }
  // From its end to the base.
  std::vector<Index> path_to(Index v) const {
    std::vector<Index> path;
    for (Index h = arrival_[v]; h != none; h = arrival_[surface_.origin(h)])
      path.push_back(h);
    return path;
  }

  const HalfEdges& surface_;
  std::uint32_t now_ = 0; // the number of the search, by which entries of the arrays are of it
  std::vector<std::uint32_t> time_, time_of_face_;
  std::vector<double> distance_;
  std::vector<Index> arrival_;            // the half-edge by which a vertex is reached
  std::vector<unsigned char> open_sides_; // of each face a bit for each
  std::vector<Entry> heap_, edges_;
  std::vector<Index> reached_, faces_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_SHORT_LOOPS_H
