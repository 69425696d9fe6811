#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_TRIANGLE_COMPLEX_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_TRIANGLE_COMPLEX_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/reverse_faces.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The high-valence vertices of a surface, called high-valence vertices in this code. A
/// high-valence vertex that is contracted with an ordinary vertex stays in its place. Its faces
/// then do not change, and only those next to the other vertex are visited; otherwise each of the d
/// pairs of a high-valence vertex would take d steps.
///
/// Marks change where lists are built, merged or reviewed, by one thread; in a pass, others may
/// ask.
class HighValenceVertices {
public:
  static constexpr std::size_t most_faces = 128; // of a vertex that is none

  bool any() const { return !vertices_.empty(); }
  bool has(Index v) const { return any() && is_high_valence_[v] != 0; }
  /// The end of a pair that is a high-valence vertex, if the other is none; else `none`.
  Index of_pair(Index a, Index b) const {
    if (!any() || is_high_valence_[a] == is_high_valence_[b])
      return none;
    return is_high_valence_[a] != 0 ? a : b;
  }

  /// There are none from here on, however many faces a vertex has.
  void forget() {
    vertices_.clear();
    are_wanted_ = false;
  }

  /// Looks at the sizes of all lists.
  template <class Lists>
  void mark(const Lists& lists) {
    vertices_.clear();
    for (Index v = 0; v < lists.size(); ++v)
      note(v, lists[v].size, lists.size());
  }
  /// Notes how many faces a vertex has now, of a surface of `vertices` vertices.
  void note(Index v, std::size_t faces, std::size_t vertices) {
    if (faces > most_faces && are_wanted_ && !has(v))
      add(v, faces, vertices);
  }

  /// Has there been a contraction for every fourth of their faces since the last review? Then this
  /// calls count(v) for each, which returns how many faces it has, and after that visit(v), when it
  /// is known whether it is still a high-valence vertex.
  template <class Count, class Visit>
  void review(Count count, Visit visit) {
    if (!any() || 4 * ++contractions_ < faces_)
      return;
    contractions_ = faces_ = 0;
    const std::vector<Index> reviewed = vertices_;
    std::erase_if(vertices_, [&](Index v) {
      const std::size_t faces = count(v);
      is_high_valence_[v] = faces > most_faces;
      faces_ += is_high_valence_[v] != 0 ? faces : 0;
      return is_high_valence_[v] == 0;
    });
    for (Index v : reviewed)
      visit(v);
  }

private:
  QUADRILLE_NOINLINE void add(Index v, std::size_t faces, std::size_t vertices) {
    if (!any()) {
      is_high_valence_.assign(vertices, 0);
      contractions_ = faces_ = 0;
    }
    is_high_valence_[v] = 1;
    vertices_.push_back(v);
    faces_ += faces;
  }

  std::vector<unsigned char> is_high_valence_; // of each vertex, where there are any
  std::vector<Index> vertices_;
  std::size_t faces_ = 0;        // of all of them, when they were looked at
  std::size_t contractions_ = 0; // since the last review
  bool are_wanted_ = true;
};

/// Rejects a surface that has more vertices or faces than there may be.
[[noreturn]] inline void throw_too_large(std::size_t vertices, std::size_t faces,
                                         std::size_t most_vertices, std::size_t most_faces) {
  throw std::length_error(
      "quadrille::simplify: " + std::to_string(vertices) + " vertices and " +
      std::to_string(faces) + " faces do not fit into 32-bit indices (at most " +
      std::to_string(most_vertices) + " and " + std::to_string(most_faces) + ")");
}

/// Any set of triangles over any set of vertices, in flat arrays with 32-bit indices: incidence,
/// and nothing of positions or costs.
///
/// A *corner* is a face at one of its vertices, written 4·face + 0, 1 or 2. The corners at a vertex
/// lie next to each other in no particular order, in one pool for all vertices, so a walk around a
/// vertex does not wait for one face to find the next, and an edge of three faces is nothing
/// special. Merging two vertices writes their corners to the end of the pool; when that is full,
/// the lists are rebuilt. A face that has been removed stays in the lists of its corners until the
/// next walk along them drops it. The list of a high-valence vertex has free places after it for
/// the corners of vertices that are merged into it.
class TriangleComplex {
public:
  static constexpr std::size_t max_faces = std::size_t{1} << 30;
  static constexpr std::size_t max_vertices = none;

  using Triangle = std::array<Index, 3>;

  TriangleComplex() = default;

  /// Builds the lists in linear time; if `will_merge`, with room for as many more corners as there
  /// are faces. A triangle with two equal vertices is removed from the beginning.
  TriangleComplex(std::size_t vertex_count, Array<Triangle> triangles, bool will_merge = false)
      : TriangleComplex(vertex_count, std::move(triangles), will_merge, Threads()) {}
  TriangleComplex(std::size_t vertex_count, Array<Triangle> triangles, bool will_merge,
                  Threads threads);

  static void check_size(std::size_t vertices, std::size_t faces) {
    if (vertices >= max_vertices || faces >= max_faces)
      throw_too_large(vertices, faces, max_vertices - 1, max_faces - 1);
  }

  /// Returns the arena of its arrays, which other arrays may use.
  Arena* arena() const { return faces_.get_allocator().arena(); }

  std::size_t vertex_capacity() const { return lists_.size(); }
  std::size_t face_capacity() const { return faces_.size(); }
  /// Counts those that have not been removed, and their reverse faces.
  std::size_t count_faces() const {
    std::size_t count = 0;
    for (Index face = 0; face < faces_.size(); ++face)
      count += is_removed(face) ? 0 : reverse_faces_.count(face);
    return count;
  }
  /// Counts those that have faces.
  std::size_t count_vertices() const {
    return static_cast<std::size_t>(std::count_if(lists_.begin(), lists_.end(), has_corners));
  }

  /// Which vertices have very many faces. Their lists shrink in review_high_valence(), if not
  /// before.
  const HighValenceVertices& high_valence_vertices() const { return high_valence_vertices_; }
  /// From here on, none counts as such.
  void forget_high_valence() { high_valence_vertices_.forget(); }
  /// This must be called after each contraction. Once contractions may have removed a certain
  /// fraction of the faces of the high-valence vertices, it drops the removed ones, and calls
  /// visit(v) for each vertex that has been a high-valence vertex.
  template <class Visit>
  void review_high_valence(Visit visit);

  bool is_removed(Index face) const { return faces_[face][0] == none; }
  const Triangle& vertices(Index face) const { return faces_[face]; }
  /// Which faces have one. Contractions do not look at them.
  const ReverseFaces& reverse_faces() const { return reverse_faces_; }
  void set_reverse_faces(ReverseFaces reverse_faces) { reverse_faces_ = std::move(reverse_faces); }
  /// At most this many faces are at a vertex.
  std::size_t degree_bound(Index vertex) const { return lists_[vertex].size; }
  /// A face that has been removed counts until a walk drops it.
  bool has_faces(Index vertex) const { return has_corners(lists_[vertex]); }

  /// Calls visit(face, i) for each face at `vertex`, i being the place of the vertex in the face.
  template <class Visit>
  void for_each_corner(Index vertex, Visit visit) const {
    const List& list = lists_[vertex];
    for (Index i = 0; i < list.size; ++i)
      if (const Index corner = pool_[list.begin + i]; !is_removed(corner >> 2))
        visit(corner >> 2, corner & 3);
  }
  /// Visits these corners, and drops those of removed faces on its way, so that its cost is repaid
  /// by the faces that were removed.
  template <class Visit>
  void prune_corners(Index vertex, Visit visit) {
    List& list = lists_[vertex];
    Index* const corners = pool_.data() + list.begin;
    const Index size = list.size;
    Index left = 0;
    for (Index i = 0; i < size; ++i) {
      const Index corner = corners[i];
      if (is_removed(corner >> 2))
        continue;
      corners[left++] = corner;
      visit(corner >> 2, corner & 3);
    }
    list.size = left;
  }
  void prune_corners(Index vertex) {
    prune_corners(vertex, [](Index, Index) {});
  }
  /// Drops corners of removed faces until the first is none of these, or none is left; the others
  /// may get another order.
  void prune_first_corners(Index vertex) {
    List& list = lists_[vertex];
    while (list.size > 0 && is_removed(pool_[list.begin] >> 2)) {
      Index& last = pool_[list.begin + --list.size];
      pool_[list.begin] = last;
      last = none;
    }
  }

  /// Does is(face, i) hold for any of them? Stops at the first.
  template <class Is>
  bool any_corner(Index vertex, Is is) const {
    const Index* const corners = pool_.data() + lists_[vertex].begin;
    return std::any_of(corners, corners + lists_[vertex].size, [&](Index corner) {
      return !is_removed(corner >> 2) && is(corner >> 2, corner & 3);
    });
  }

  /// Calls visit(vertices) for each face that has a vertex in a range.
  template <class R, class Visit>
  void for_each_face_at(const R& range, Visit visit) const {
    const auto is_in_range = [&](Index v) { return range.contains(v); };
    for (const Triangle& face : faces_)
      if (face[0] != none && std::any_of(face.begin(), face.end(), is_in_range))
        visit(face);
  }

  void remove_face(Index face) { faces_[face] = {none, none, none}; }

  /// Makes room for merge(kept, gone): all lists may be rebuilt. It must be called before faces are
  /// removed whose vertices are queried: in new lists these may have no faces.
  void reserve_for_merge(Index kept, Index gone) {
    if (high_valence_vertices_.has(kept))
      make_room_after(kept, lists_[gone].size);
    else
      reserve_corners(lists_[kept].size + lists_[gone].size);
  }
  /// Moves all faces of `gone` to `kept`, whose list is then free of removed ones unless it is a
  /// high-valence vertex. Faces with both vertices must have been removed already.
  void merge(Index kept, Index gone) {
    reserve_for_merge(kept, gone); // no walk may see the pool move
    if (high_valence_vertices_.has(kept)) {
      append_to_high_valence(kept, gone);
      return;
    }
    const std::size_t most = lists_[kept].size + lists_[gone].size;
    const std::size_t begin = pool_.size();
    pool_.resize(begin + most);
    Index* end = pool_.data() + begin;
    const auto append = [&](Index vertex) { // without a branch, which would be hard to predict
      for (Index i = 0; i < lists_[vertex].size; ++i) {
        const Index corner = *end = pool_[lists_[vertex].begin + i];
        const Index face = corner >> 2;
        faces_[face][corner & 3] = is_removed(face) ? none : kept;
        end += !is_removed(face);
      }
    };
    append(kept);
    append(gone);
    lists_[kept] = {static_cast<Index>(begin), static_cast<Index>(end - (pool_.data() + begin))};
    lists_[gone].size = 0;
    pool_.resize(begin + lists_[kept].size);
    high_valence_vertices_.note(kept, lists_[kept].size, lists_.size());
  }

  /// Relabels faces, which enter the list of `kept` only when build_lists() is called. Writes to
  /// nothing but these faces and the list of `gone`.
  void relabel(Index kept, Index gone) {
    prune_corners(gone, [&](Index face, Index i) { faces_[face][i] = kept; });
    lists_[gone].size = 0;
  }

  /// Rebuilds all lists, in linear time, each in the order of its faces.
  void build_lists(Threads threads = Threads());

  /// Returns the vertices that have faces, according to has_faces(), in the order of their numbers:
  /// the argument of pack().
  Array<Index> left_vertices() const { return indices_of(lists_, has_corners); }
  /// The faces that have not been removed.
  Array<Index> left_faces() const {
    return indices_of(faces_, [](const Triangle& face) { return face[0] != none; });
  }
  /// Drops all other vertices and the faces that have been removed, and renumbers the rest as 0, 1,
  /// …. No walk is possible before fill_lists() is called.
  void pack(const Array<Index>& vertices);
  /// Fills the lists, of which the sizes are known, each in the order of its faces.
  void fill_lists(Threads threads = Threads());

  /// Gives memory back: of the lists, and of what has been left out. After that no walk is
  /// possible; has_faces() still is.
  void release() {
    pool_ = Array<Index>();
    faces_.shrink_to_fit();
    lists_.shrink_to_fit();
  }

  /// Ask for what a walk around a vertex will read, one after the other and some time before it:
  /// where its corners are, the corners, the faces.
  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const { internal::prefetch(&lists_[vertex]); }
  QUADRILLE_ALWAYS_INLINE void prefetch_corners(Index vertex) const {
    internal::prefetch(pool_.data() + lists_[vertex].begin);
  }
  QUADRILLE_ALWAYS_INLINE void prefetch_faces(Index vertex) const {
    const List& list = lists_[vertex];
    const Index size = (std::min)(list.size, most_prefetched);
    for (Index i = 0; i < size; ++i) // few lie in two lines: to ask for both takes longer
      internal::prefetch(&faces_[pool_[list.begin + i] >> 2].front());
  }
  /// Calls visit(w) for the next vertex of each face at a vertex, or of the first of very many:
  /// for what is to be asked for of the neighbours.
  template <class Visit>
  QUADRILLE_ALWAYS_INLINE void for_each_next(Index vertex, Visit visit) const {
    const List& list = lists_[vertex];
    const Index size = (std::min)(list.size, most_prefetched);
    for (Index i = 0; i < size; ++i) {
      const Index corner = pool_[list.begin + i];
      const Index w = faces_[corner >> 2][(corner & 3) == 2 ? 0 : (corner & 3) + 1];
      if (w != none) // else the face has been removed
        visit(w);
    }
  }

private:
  struct List {
    Index begin, size; // in the pool
  };
  static constexpr Index most_prefetched = 64; // of a vertex: more would push each other out
  static constexpr auto has_corners = [](const List& list) { return list.size != 0; };

  // At the end of the pool; if need be, for many a merge more, which repay the new lists.
  void reserve_corners(std::size_t corners) {
    if (pool_.size() + corners <= pool_.capacity())
      return;
    build_lists();
    const std::size_t more = faces_.size() / 2;
    pool_.reserve(pool_.size() + (corners > more ? corners + more : more));
  }

  bool are_lists_right() const;

  // Is there room after the list of a high-valence vertex for so many corners?
  bool has_room_after(Index high_valence, std::size_t corners) const;
  void make_room_after(Index high_valence, std::size_t corners);
  void append_to_high_valence(Index high_valence, Index gone);

  Array<Triangle> faces_;
  Array<Index> pool_;
  Array<List> lists_; // of each vertex
  HighValenceVertices high_valence_vertices_;
  ReverseFaces reverse_faces_;
};

/// Calls visit(face) for each face that is left.
template <class Visit>
void for_each_face(const TriangleComplex& complex, Visit visit) {
  for (Index face = 0; face < complex.face_capacity(); ++face)
    if (!complex.is_removed(face))
      visit(face);
}

} // namespace quadrille::internal

#include <quadrille/internal/core/complex/corner_lists.h>

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_TRIANGLE_COMPLEX_H
