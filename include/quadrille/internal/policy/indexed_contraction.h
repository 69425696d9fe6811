#ifndef QUADRILLE_INTERNAL_POLICY_INDEXED_CONTRACTION_H
#define QUADRILLE_INTERNAL_POLICY_INDEXED_CONTRACTION_H

#include <quadrille/internal/complex/star_face.h>
#include <quadrille/internal/policy/contraction_view.h>
#include <quadrille/internal/surface/numbering.h>

#include <cstddef>
#include <span>

namespace quadrille::internal {

/// A face that a contraction changes, with its index in the input.
struct IndexedFace : ChangedFace {
  std::size_t index;
};

/// The indices in the input of the faces that a contraction removes.
class RemovedFaces {
public:
  RemovedFaces(std::span<const StarFace> faces, const InputIndices& indices)
      : faces_(faces), indices_(indices) {}
  class Iterator {
  public:
    Iterator(const StarFace* face, const InputIndices& indices) : face_(face), indices_(indices) {}
    std::size_t operator*() const { return indices_[face_->face]; }
    Iterator& operator++() { return ++face_, *this; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.face_ == b.face_; }

  private:
    const StarFace* face_;
    const InputIndices& indices_;
  };
  Iterator begin() const { return {faces_.data(), indices_}; }
  Iterator end() const { return {faces_.data() + faces_.size(), indices_}; }
  std::size_t size() const { return faces_.size(); }

private:
  std::span<const StarFace> faces_;
  const InputIndices& indices_;
};

/// A contraction as filters beside NormalFlip see it: they may ask which vertices and faces of the
/// input it is about.
template <std::size_t N>
class IndexedContraction : public ContractionView<N> {
public:
  template <class Star>
  IndexedContraction(const ContractionView<N>& view, const Star& star, Index first, Index second,
                     const Numbering& numbering)
      : ContractionView<N>(view), first_(first), second_(second),
        shared_(star.shared.begin(), star.shared.end()), numbering_(numbering) {}

  /// The ends. A vertex that others have become part of still has an index of its own.
  std::size_t first() const { return numbering_.vertices[first_]; }
  std::size_t second() const { return numbering_.vertices[second_]; }

  ChangedFaces<IndexedContraction> faces() const { return ChangedFaces(*this); }
  IndexedFace face(std::size_t i) const {
    return {ContractionView<N>::face(i), numbering_.faces[this->star_face(i).face]};
  }
  /// Those of both ends.
  RemovedFaces removed_faces() const { return {shared_, numbering_.faces}; }

private:
  Index first_, second_;
  std::span<const StarFace> shared_;
  const Numbering& numbering_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_INDEXED_CONTRACTION_H
