#ifndef QUADRILLE_INTERNAL_ORDER_FLATTENED_VERTICES_H
#define QUADRILLE_INTERNAL_ORDER_FLATTENED_VERTICES_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/memory/array.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// The vertices around which the surface has become flatter than when their pairs were last costed:
/// these have become cheaper than the queue knows. They are gathered until there are enough to cost
/// their pairs together, which spares most of the waiting for memory.
class FlattenedVertices {
public:
  static constexpr std::size_t many = 64;

  /// A vertex is one of them when its unevenness has fallen by more than a factor `fall`.
  FlattenedVertices(std::size_t vertices, float fall, Workspace* workspace = nullptr)
      : unevenness_(vertices, 0, workspace), fall_(fall) {
    found_.reserve(2 * many);
  }

  /// The pairs of a vertex cost now what the queue says.
  void note(Index v, double unevenness) { unevenness_[v] = static_cast<float>(unevenness); }
  /// The faces around a vertex may have changed.
  void look_at(Index v, double unevenness) {
    if (!(unevenness < static_cast<double>(fall_ * unevenness_[v])))
      return;
    unevenness_[v] = found;
    found_.push_back(v);
  }

  bool are_many() const { return found_.size() >= many; }
  /// Calls visit(v) for each of them that has not been noted since, and forgets them all.
  template <class Visit>
  void take(Visit visit) {
    for (Index v : found_)
      if (unevenness_[v] == found)
        visit(v);
    found_.clear();
  }

private:
  static constexpr float found = -std::numeric_limits<float>::infinity(); // nothing is below it

  Array<float> unevenness_; // of each vertex, when its pairs were last costed
  std::vector<Index> found_;
  float fall_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_FLATTENED_VERTICES_H
