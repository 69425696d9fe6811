#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_HUBS_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_HUBS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The hubs of a surface: its vertices of very many faces. Where a hub is contracted with a vertex
/// that is none, it stays in its place. Then its faces do not change, and only those beside the
/// other vertex are looked at; else it would take d steps for each of the d pairs of a hub.
///
/// Marks change where lists are built, merged or reviewed, by one thread; in a pass, others may
/// ask.
class Hubs {
public:
  static constexpr std::size_t most_faces = 128; // of a vertex that is none

  bool any() const { return !vertices_.empty(); }
  bool has(Index v) const { return any() && is_hub_[v] != 0; }
  /// The end of a pair that is a hub, if the other is none; else `none`.
  Index of_pair(Index a, Index b) const {
    if (!any() || is_hub_[a] == is_hub_[b])
      return none;
    return is_hub_[a] != 0 ? a : b;
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

  /// Has there been a contraction for every fourth of their faces since the last time? Then calls
  /// count(v) for each, which tells how many faces it has, and after that visit(v), when it is
  /// known whether it still is a hub.
  template <class Count, class Visit>
  void review(Count count, Visit visit) {
    if (!any() || 4 * ++contractions_ < faces_)
      return;
    contractions_ = faces_ = 0;
    const std::vector<Index> reviewed = vertices_;
    std::erase_if(vertices_, [&](Index v) {
      const std::size_t faces = count(v);
      is_hub_[v] = faces > most_faces;
      faces_ += is_hub_[v] != 0 ? faces : 0;
      return is_hub_[v] == 0;
    });
    for (Index v : reviewed)
      visit(v);
  }

private:
  QUADRILLE_NOINLINE void add(Index v, std::size_t faces, std::size_t vertices) {
    if (!any()) {
      is_hub_.assign(vertices, 0);
      contractions_ = faces_ = 0;
    }
    is_hub_[v] = 1;
    vertices_.push_back(v);
    faces_ += faces;
  }

  std::vector<unsigned char> is_hub_; // of each vertex, where there are any
  std::vector<Index> vertices_;
  std::size_t faces_ = 0;        // of all of them, when they were looked at
  std::size_t contractions_ = 0; // since the last review
  bool are_wanted_ = true;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_HUBS_H
