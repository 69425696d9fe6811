#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_TABLE_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_TABLE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A few wedges.
using WedgeList = boost::container::small_vector<Index, 8>;

/// The wedges of a channel: corners around a vertex with one value. The first wedge of a vertex has
/// its number; others follow. A table of one wedge per vertex stores nothing.
class WedgeTable {
public:
  using Corners = std::array<Index, 3>;

  explicit WedgeTable(Arena* arena) : corners_(arena), next_(arena) {}

  /// Has any vertex ever had several wedges?
  bool has_seams() const { return !corners_.empty(); }
  bool has_one(Index vertex) const { return !has_seams() || next_[vertex] == none; }

  /// Makes wedges of corners: those around a vertex that are connected by edges at which
  /// are_equal(value_at(face, i), value_at(face', j)) is true of both corners at v, or all of them,
  /// if it is true of all. Calls found(wedge, value) with the value of a corner of each wedge.
  template <class ValueAt, class AreEqual, class Found>
  void build(const TriangleComplex& complex, ValueAt value_at, AreEqual are_equal, Found found) {
    const auto are_one = [&](Index face, Index i, Index other, Index j) {
      return are_equal(value_at(face, i), value_at(other, j));
    };
    corners_.reserve(complex.face_capacity());
    for (Index face = 0; face < complex.face_capacity(); ++face)
      corners_.push_back(complex.vertices(face)); // the first wedges
    next_.assign(complex.vertex_capacity(), none);
    const Array<Index> values = sole_values(complex, value_at);
    Fans fans;
    for (Index v = 0; v < complex.vertex_capacity(); ++v) {
      if (values[v] < several) {
        found(v, values[v]);
        continue;
      }
      fans.gather(complex, v, are_one);
      Index last = none;
      fans.for_each([&](const auto& corners) {
        const Index wedge = last == none ? v : append_after(last);
        last = wedge;
        for (const auto& [face, i] : corners)
          corners_[face][i] = wedge;
        found(wedge, value_at(corners.front().first, corners.front().second));
      });
    }
  }
  /// Stores nothing, if there are only as many wedges as vertices.
  void simplify_if_possible(std::size_t vertices) {
    if (next_.size() == vertices) {
      corners_ = Array<Corners>(corners_.get_allocator());
      next_ = Array<Index>(next_.get_allocator());
    }
  }

  /// How many wedges have a number, of that many vertices.
  std::size_t size(std::size_t vertices) const { return has_seams() ? next_.size() : vertices; }

  /// The wedge of a face's corner i, which is at a vertex.
  Index at(Index face, std::size_t i, Index vertex) const {
    return has_seams() ? corners_[face][i] : vertex;
  }
  /// The wedge of a face at one of its vertices.
  Index at(const TriangleComplex& complex, Index face, Index vertex) const {
    return has_one(vertex) ? vertex : corners_[face][place(complex.vertices(face), vertex)];
  }

  /// All wedges of a vertex, the first one first.
  void append_all(WedgeList& wedges, Index vertex) const {
    for_each(vertex, [&](Index wedge) { wedges.push_back(wedge); });
  }
  /// Calls visit(wedge) for them.
  template <class Visit>
  void for_each(Index vertex, Visit visit) const {
    visit(vertex);
    if (has_seams())
      for (Index w = next_[vertex]; w != none; w = next_[w])
        visit(w);
  }

  /// Calls visit(wedge at a, wedge at b) for each face of both.
  template <class Visit>
  void for_each_shared(const TriangleComplex& complex, Index a, Index b, Visit visit) const {
    complex.for_each_corner(a, [&](Index face, Index i) {
      if (star_face_at(complex, face, i).has(b))
        visit(at(face, i, a), at(complex, face, b));
    });
  }

  /// The wedges that a vertex has now: `wedges`, the first of which is its own.
  void chain(const WedgeList& wedges) {
    for (std::size_t k = 0; k < wedges.size(); ++k)
      next_[wedges[k]] = k + 1 < wedges.size() ? wedges[k + 1] : none;
  }
  /// The corner of a face at a vertex belongs to another wedge now: renamed(old wedge).
  template <class Rename>
  void rename_corner(const TriangleComplex& complex, Index face, Index vertex, Rename renamed) {
    Index& wedge = corners_[face][place(complex.vertices(face), vertex)];
    wedge = renamed(wedge);
  }

  /// Leaves out the data of faces for which is_left is false and of vertices that are not in an
  /// ascending list. Returns the old numbers of the rest, by the new ones.
  template <class IsLeft>
  Array<Index> pack(const Array<Index>& vertices, IsLeft is_left) {
    Array<Index> old(vertices.begin(), vertices.end(), vertices.get_allocator());
    if (!has_seams())
      return old;
    Array<Index> new_number(next_.size(), none, next_.get_allocator());
    Array<Index> next(vertices.size(), none, next_.get_allocator());
    for (Index v = 0; v < vertices.size(); ++v) {
      new_number[vertices[v]] = v;
      Index last = v;
      for (Index w = next_[vertices[v]]; w != none; w = next_[w]) {
        new_number[w] = next[last] = static_cast<Index>(old.size());
        last = new_number[w];
        next.push_back(none);
        old.push_back(w);
      }
    }
    next_ = std::move(next);
    pack_if(corners_, is_left);
    for (Corners& corners : corners_)
      for (Index& wedge : corners)
        wedge = new_number[wedge];
    return old;
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const {
    if (has_seams())
      internal::prefetch(&next_[vertex]);
  }

private:
  static std::size_t place(const TriangleComplex::Triangle& vertices, Index vertex) {
    return vertices[0] == vertex ? 0 : vertices[1] == vertex ? 1 : 2;
  }

  static constexpr Index several = none - 1;

  // The value that all corners of a vertex have; `several` if they have several, none if it has no
  // corners.
  template <class ValueAt>
  static Array<Index> sole_values(const TriangleComplex& complex, ValueAt value_at) {
    Array<Index> values(complex.vertex_capacity(), none, complex.arena());
    for_each_face(complex, [&](Index face) {
      const auto& vertices = complex.vertices(face);
      for (Index i = 0; i < 3; ++i) {
        Index& value = values[vertices[i]];
        const Index here = value_at(face, i);
        value = value == none || value == here ? here : several;
      }
    });
    return values;
  }

  Index append_after(Index last) {
    const auto wedge = static_cast<Index>(next_.size());
    next_.push_back(none);
    next_[last] = wedge;
    return wedge;
  }

  // The corners around a vertex, in groups that are connected by edges.
  class Fans {
  public:
    using Corner = std::pair<Index, Index>; // face, place

    template <class AreOne>
    void gather(const TriangleComplex& complex, Index v, AreOne are_one) {
      corners_.clear();
      complex.for_each_corner(v, [&](Index face, Index i) { corners_.push_back({face, i}); });
      is_one_ = std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
        return are_one(corners_[0].first, corners_[0].second, c.first, c.second);
      });
      if (is_one_)
        return;
      sides_.clear();
      for (Index corner = 0; corner < corners_.size(); ++corner) {
        const StarFace f = star_face_at(complex, corners_[corner].first, corners_[corner].second);
        sides_.push_back({f.second, corner});
        sides_.push_back({f.third, corner});
      }
      parent_.resize(corners_.size());
      std::iota(parent_.begin(), parent_.end(), Index{0});
      std::sort(sides_.begin(), sides_.end());
      for (std::size_t s = 0; s < sides_.size(); ++s)
        for (std::size_t t = s + 1; t < sides_.size() && sides_[t].first == sides_[s].first; ++t) {
          const auto [face, i] = corners_[sides_[s].second];
          const auto [other, j] = corners_[sides_[t].second];
          if (are_one(face, i, other, j))
            join(sides_[s].second, sides_[t].second);
        }
    }

    // Calls visit(corners) for each group, in the order of its first corner.
    template <class Visit>
    void for_each(Visit visit) {
      if (is_one_ && !corners_.empty())
        visit(corners_);
      if (is_one_)
        return;
      order_.clear();
      for (Index c = 0; c < corners_.size(); ++c)
        order_.push_back({root(c), c});
      std::sort(order_.begin(), order_.end());
      for (auto begin = order_.begin(); begin != order_.end();) {
        component_.clear();
        const Index component = begin->first;
        for (; begin != order_.end() && begin->first == component; ++begin)
          component_.push_back(corners_[begin->second]);
        visit(component_);
      }
    }

  private:
    Index root(Index c) {
      while (parent_[c] != c)
        c = parent_[c] = parent_[parent_[c]];
      return c;
    }
    void join(Index c, Index d) { // the lower one is the root
      const Index one = root(c), other = root(d);
      parent_[(std::max)(one, other)] = (std::min)(one, other);
    }

    std::vector<Corner> corners_, component_;
    std::vector<std::pair<Index, Index>> sides_; // the other end of an edge, the corner
    std::vector<std::pair<Index, Index>> order_; // the group, the corner
    std::vector<Index> parent_;
    bool is_one_ = false; // do all corners have one value?
  };

  Array<Corners> corners_; // of each face
  Array<Index> next_;      // of each wedge, the next one of its vertex
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_TABLE_H
