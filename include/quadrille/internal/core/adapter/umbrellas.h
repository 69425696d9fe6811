#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_UMBRELLAS_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_UMBRELLAS_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A directed side of a triangle. Sides 3f, 3f + 1, 3f + 2 run round face f; side 3f + k leads to
/// its corner k.
struct Side {
  Index from, to;
};

/// How the faces of a triangle set hang together when at most two may share an edge.
///
/// Sides of opposite directions along an edge become *mates*, in pairs; a side without a mate is on
/// the boundary. The corners that mates connect around a vertex form an *umbrella*, closed or open.
/// A halfedge mesh allows any number of open umbrellas at one vertex, or a single closed one, so
/// every further one gets a duplicate of the vertex: for the given mates, these are the fewest.
class Umbrellas {
public:
  explicit Umbrellas(Arena* arena = nullptr)
      : mate_(arena), vertex_(arena), boundary_(arena), duplicates_(arena) {}

  /// Builds all of it in linear time. Vertices are below vertex_count; duplicates are counted from
  /// there. Sides that satisfy were_mates(i, j) are mated before any others.
  template <class WereMates>
  void build(const Array<Side>& sides, std::size_t vertex_count, WereMates were_mates) {
    vertex_count_ = static_cast<Index>(vertex_count);
    match_sides(sides, were_mates);
    assign_vertices(sides);
  }

  Index mate(Index side) const { return mate_[side]; }         ///< or none
  /// The vertex of a corner, 3·face + k.
  Index vertex(Index corner) const { return vertex_[corner]; }
  bool is_on_boundary(Index vertex) const { return boundary_[vertex].first_out != none; }

  /// The vertex that each duplicate is one of: vertex_count + i duplicates duplicates()[i].
  const Array<Index>& duplicates() const { return duplicates_; }

  /// Returns pairs of sides: along the boundary, the other half of the first is followed by that of
  /// the second.
  const std::vector<std::pair<Index, Index>>& boundary_links() const { return boundary_links_; }

private:
  // Sides of the same two vertices are found by a counting sort by the lower one, and where a
  // vertex has many, by another sort by the higher one.
  template <class WereMates>
  void match_sides(const Array<Side>& sides, WereMates were_mates) {
    Array<Index> begin(vertex_count_ + 1, 0, mate_.get_allocator());
    for (const Side& s : sides)
      ++begin[lower(s) + 1];
    for (std::size_t v = 0; v < vertex_count_; ++v)
      begin[v + 1] += begin[v];
    Array<Index> sorted(sides.size(), mate_.get_allocator());
    Array<Index> end(begin.begin(), begin.end() - 1, mate_.get_allocator());
    for (Index i = 0; i < sides.size(); ++i)
      sorted[end[lower(sides[i])]++] = i;

    mate_.assign(sides.size(), none);
    for (std::size_t v = 0; v < vertex_count_; ++v) {
      const std::span<Index> at_v(sorted.data() + begin[v], begin[v + 1] - begin[v]);
      if (at_v.size() <= few_sides)
        match_sides_among(at_v, sides, were_mates);
      else
        for (std::span<Index> rest = sorted_by_higher(at_v, sides); !rest.empty();) {
          const auto last = std::find_if(rest.begin(), rest.end(), [&](Index i) {
            return higher(sides[i]) != higher(sides[rest.front()]);
          });
          const auto size = static_cast<std::size_t>(last - rest.begin());
          match_sides_among(rest.first(size), sides, were_mates);
          rest = rest.subspan(size);
        }
    }
  }

  static std::span<Index> sorted_by_higher(std::span<Index> indices, const Array<Side>& sides) {
    std::stable_sort(indices.begin(), indices.end(),
                     [&](Index i, Index j) { return higher(sides[i]) < higher(sides[j]); });
    return indices;
  }

  template <class WereMates>
  void match_sides_among(std::span<const Index> among, const Array<Side>& sides,
                         WereMates were_mates) {
    if (match_sides_without_choice(sides, among))
      return;
    for (Index i : among)
      mate_[i] = none;
    match_sides_if(sides, among, were_mates);
    match_sides_if(sides, among, [](Index, Index) { return true; });
  }

  // The usual case: no side has more than one to choose from. False if one has.
  bool match_sides_without_choice(const Array<Side>& sides, std::span<const Index> among) {
    for (auto i = among.begin(); i != among.end(); ++i)
      for (auto j = among.begin(); j != i; ++j) {
        if (!are_opposed(sides[*i], sides[*j]))
          continue;
        if (mate_[*i] != none || mate_[*j] != none)
          return false;
        mate_[*i] = *j;
        mate_[*j] = *i;
      }
    return true;
  }

  template <class Accept>
  void match_sides_if(const Array<Side>& sides, std::span<const Index> among, Accept accept) {
    for (Index i : among)
      for (Index j : among) {
        if (mate_[i] != none || j == i)
          break; // i has its mate; of two sides the later one looks for the earlier
        if (mate_[j] == none && are_opposed(sides[i], sides[j]) && accept(i, j)) {
          mate_[i] = j;
          mate_[j] = i;
        }
      }
  }

  static bool are_opposed(const Side& a, const Side& b) { return a.from == b.to && a.to == b.from; }

  static Index lower(const Side& s) { return s.from < s.to ? s.from : s.to; }
  static Index higher(const Side& s) { return s.from < s.to ? s.to : s.from; }

  static Index side_after(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index side_before(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  void assign_vertices(const Array<Side>& sides) {
    vertex_.assign(sides.size(), none);
    boundary_.assign(vertex_count_, {});
    std::vector<bool> is_taken(vertex_count_, false); // by a closed umbrella
    for (Index corner = 0; corner < sides.size(); ++corner)
      if (vertex_[corner] == none)
        assign_umbrella(corner, sides[corner].to, is_taken);
    for (const Boundary& boundary : boundary_)
      if (boundary.first_out != none)
        boundary_links_.emplace_back(boundary.last_in, boundary.first_out);
  }

  // The corner after this one, turning about the vertex through the side that leads to it.
  Index turn(Index corner) const {
    return mate_[corner] == none ? none : side_before(mate_[corner]);
  }

  // Finds the first corner of the umbrella, or the given one if it is closed, and labels all of it.
  void assign_umbrella(Index corner, Index vertex, std::vector<bool>& is_taken) {
    Index first = corner;
    while (mate_[side_after(first)] != none) {
      first = mate_[side_after(first)];
      if (first == corner)
        break;
    }
    const bool is_closed = mate_[side_after(first)] != none;
    const Index label =
        is_closed ? vertex_for_closed(vertex, is_taken) : vertex_for_open(vertex, is_taken);
    Index last = first;
    for (Index c = first; c != none && vertex_[c] == none; c = turn(c)) {
      vertex_[c] = label;
      last = c;
    }
    if (!is_closed)
      link_boundary(label, side_after(first), last);
  }

  Index vertex_for_closed(Index vertex, std::vector<bool>& is_taken) {
    if (is_taken[vertex] || is_on_boundary(vertex))
      return add_duplicate(vertex);
    is_taken[vertex] = true;
    return vertex;
  }

  // All open umbrellas of a vertex share one.
  Index vertex_for_open(Index vertex, const std::vector<bool>& is_taken) {
    if (!is_taken[vertex])
      return vertex;
    Index& shared = boundary_[vertex].duplicate;
    if (shared == none) {
      const Index added = add_duplicate(vertex);
      boundary_[vertex].duplicate = added;
      return added;
    }
    return shared;
  }

  Index add_duplicate(Index vertex) {
    duplicates_.push_back(vertex);
    boundary_.push_back({});
    return vertex_count_ + static_cast<Index>(duplicates_.size() - 1);
  }

  // The boundary reaches the vertex along the open side that leaves it, and continues along the
  // open side that leads to it; between two umbrellas it goes from one to the other.
  void link_boundary(Index vertex, Index in, Index out) {
    Boundary& boundary = boundary_[vertex];
    if (boundary.first_out == none)
      boundary.first_out = out;
    else
      boundary_links_.emplace_back(boundary.last_in, out);
    boundary.last_in = in;
  }

  struct Boundary {
    Index first_out = none, last_in = none; // sides
    Index duplicate = none;                 // for open umbrellas, if a closed one has the vertex
  };

  static constexpr std::size_t few_sides = 64;

  Index vertex_count_ = 0;
  Array<Index> mate_;
  Array<Index> vertex_;
  Array<Boundary> boundary_; // of each vertex and duplicate
  Array<Index> duplicates_;
  std::vector<std::pair<Index, Index>> boundary_links_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_UMBRELLAS_H
