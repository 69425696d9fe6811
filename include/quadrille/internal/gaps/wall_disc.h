#ifndef QUADRILLE_INTERNAL_GAPS_WALL_DISC_H
#define QUADRILLE_INTERNAL_GAPS_WALL_DISC_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace quadrille::internal {

/// Faces that hang together by edges, and the loop around them if they form a disc.
class WallDisc {
public:
  /// The faces that are reached across edges from the first one, through faces that `may_take`
  /// allows. The first one is not asked for.
  template <class MayTake>
  WallDisc(const HalfEdges& surface, Index first, MayTake may_take)
      : surface_(surface), faces_{first} {
    std::unordered_set<Index> seen{first};
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (Index h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h)
        if (const Index twin = surface.twin(h); twin != none)
          if (const Index face = HalfEdges::face(twin); !seen.contains(face) && may_take(face)) {
            seen.insert(face);
            faces_.push_back(face);
          }
    find_loop(seen);
  }

  const std::vector<Index>& faces() const { return faces_; }
  /// The half-edges around the faces, each beginning where the one before it ends; empty if they do
  /// not form a disc.
  const std::vector<Index>& loop() const { return loop_; }

  double radius(const Vector<3>& centre) const {
    double squared = 0;
    for (const Index face : faces_)
      for (const Index v : surface_.triangle(face))
        squared = (std::max)(squared, squared_distance(surface_.point(v), centre));
    return std::sqrt(squared);
  }

private:
  // Faces form a disc if one loop passes each vertex at their boundary once, and Euler's number is
  // 1.
  void find_loop(const std::unordered_set<Index>& seen) {
    std::unordered_map<Index, Index> side_from;
    std::unordered_set<Index> vertices;
    std::vector<Index> sides;
    for (const Index face : faces_)
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        vertices.insert(surface_.origin(h));
        const Index twin = surface_.twin(h);
        if (twin != none && seen.contains(HalfEdges::face(twin)))
          continue;
        side_from[surface_.origin(h)] = h;
        sides.push_back(h);
      }
    if (sides.empty() || side_from.size() != sides.size() ||
        2 * vertices.size() != faces_.size() + sides.size() + 2)
      return;
    Index h = sides.front();
    do {
      loop_.push_back(h);
      h = side_from.at(surface_.target(h));
    } while (h != loop_.front());
    if (loop_.size() != sides.size())
      loop_.clear();
  }

  const HalfEdges& surface_;
  std::vector<Index> faces_, loop_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_WALL_DISC_H
