#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_REVERSE_FACES_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_REVERSE_FACES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// Which faces have a reverse face: another face of the input on the same vertices, the other way
/// round. Only the forward face is in the surface, and its reverse goes wherever it goes.
///
/// Corner i of a reverse face is at corner (p − i) mod 3 of its forward face, for a p of 0, 1 or 2,
/// and as long as that is there: contractions keep the order of its corners.
class ReverseFaces {
public:
  ReverseFaces() = default; ///< No face has a reverse.
  /// `of` has for each face 4·r + p, where r is the input index of its reverse; or none.
  explicit ReverseFaces(Array<Index> of) : of_(std::move(of)) {}

  bool is_empty() const { return of_.empty(); }
  bool has(Index face) const { return !is_empty() && of_[face] != none; }
  /// Returns the input index of the reverse that a face has.
  Index input_face(Index face) const { return of_[face] >> 2; }
  /// Returns where a corner of the face is in its reverse, and the other way round.
  std::size_t opposite(Index face, std::size_t corner) const {
    return ((of_[face] & 3) + 3 - corner) % 3;
  }

  /// How many faces of the input a face stands for.
  std::size_t count(Index face) const { return has(face) ? 2 : 1; }
  /// And those of a star.
  template <class StarFaces>
  std::size_t count_all(const StarFaces& faces) const {
    std::size_t count = faces.size();
    if (!is_empty())
      for (const auto& f : faces)
        count += of_[f.face] != none;
    return count;
  }

  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    if (!is_empty())
      internal::pack_if(of_, is_left);
  }

private:
  Array<Index> of_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_REVERSE_FACES_H
