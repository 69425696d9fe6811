#ifndef QUADRILLE_INTERNAL_SCRATCH_H
#define QUADRILLE_INTERNAL_SCRATCH_H

#include <quadrille/internal/marks.h>
#include <quadrille/internal/star.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What contractions have done since they were last counted.
struct Tally {
  std::size_t faces = 0, vertices = 0; // that are gone
  std::size_t contractions = 0, non_edge_contractions = 0;
  std::array<std::size_t, rejection_causes> rejections{};
  double error = 0; // the greatest
};

struct VertexPair {
  Index first, second;
};

/// A list whose length is set without a look at its values: what is written by loops that can't
/// afford to branch.
template <class T>
class Room {
public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// The place behind the list, for at most `count` values more.
  T* extend(std::size_t count) {
    if (values_.size() < size_ + count)
      values_.resize(2 * (size_ + count));
    return values_.data() + size_;
  }
  /// So many of them have been written.
  void add(std::size_t count) { size_ += count; }
  /// Writes a value, and lets it stay or not: without a branch.
  void add_if(bool stays, const T& value) {
    *extend(1) = value;
    add(stays);
  }

  const T& operator[](std::size_t i) const { return values_[i]; }
  const T* data() const { return values_.data(); }

private:
  std::vector<T> values_;
  std::size_t size_ = 0;
};

/// What the steps of a contraction need beside the surface. Threads that work on parts of a surface
/// with no vertex in common have one each.
struct Scratch {
  explicit Scratch(std::size_t vertices) : marks(vertices) {}

  Marks marks;
  PairStar star; // of the pair that was gathered last
  std::vector<StarFace> faces;
  std::vector<float> bounds; // of the faces that the contraction changes, see DistanceBounds
  Room<VertexPair> pairs;
  Room<float> costs; // of these
  Tally tally;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_SCRATCH_H
