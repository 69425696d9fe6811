#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_RECENT_FACES_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_RECENT_FACES_H

#include <quadrille/internal/core/complex/triangle_complex.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Faces for which a condition was true recently, so that it may be true again: they are tested
/// first. A face for which it is false moves to the end.
class RecentFaces {
public:
  /// Is is(face, i) true for one of them that is at the vertex, in place i of its corners?
  template <class Is>
  bool any_at(const TriangleComplex& complex, Index vertex, Is is) {
    for (std::size_t n = 0; n < faces_.size(); ++n)
      for (Index i = 0; i < 3; ++i)
        if (complex.vertices(faces_[n])[i] == vertex && is(faces_[n], i)) {
          std::swap(faces_[n], faces_[n / 2]);
          return true;
        }
    return false;
  }

  void add(Index face) {
    if (faces_.size() < most)
      faces_.push_back(face);
    else
      faces_[most / 2 + last_++ % (most / 2)] = face; // in the half that is asked last
  }

private:
  static constexpr std::size_t most = 256;

  std::vector<Index> faces_;
  std::size_t last_ = 0; // of those that were replaced
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_RECENT_FACES_H
