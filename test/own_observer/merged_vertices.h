#ifndef QUADRILLE_INTERNAL_CONTRACTION_MERGED_VERTICES_H
#define QUADRILLE_INTERNAL_CONTRACTION_MERGED_VERTICES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <tuple>
#include <vector>

/// What a part of the test has counted, for the test to look at when the surface is gone.
struct Counted {
  std::vector<int> vertices, faces;
};
inline Counted counted;

namespace quadrille::internal {

/// How many vertices of the input have become each vertex, and how often each face has changed; 0
/// and -1 of those that are gone.
class MergedVertices {
public:
  explicit MergedVertices(const TriangleComplex& complex)
      : count_(complex.vertex_capacity(), 1, complex.arena()),
        changes_(complex.face_capacity(), 0, complex.arena()) {}
  MergedVertices(const MergedVertices&) = delete;
  MergedVertices& operator=(const MergedVertices&) = delete;
  ~MergedVertices() {
    counted.vertices.assign(count_.begin(), count_.end());
    counted.faces.assign(changes_.begin(), changes_.end());
  }

  static auto vertex_arrays(auto& self) { return std::tie(self.count_); }

  template <class Event>
  void after(const Event& event) {
    count_[event.kept] += count_[event.gone];
    count_[event.gone] = 0;
    const auto& star = event.contraction.star();
    star.for_each_changed([this](const auto& f) { ++changes_[f.face]; });
    for (const auto& f : star.shared)
      changes_[f.face] = -1;
  }

  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(changes_, is_left);
  }

private:
  Array<int> count_, changes_; // of each vertex, of each face
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_MERGED_VERTICES_H
