#ifndef QUADRILLE_INTERNAL_CORE_COST_LOCAL_STAR_H
#define QUADRILLE_INTERNAL_CORE_COST_LOCAL_STAR_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

/// \file
/// The local terms of a star: what its faces say, as they are now, to a cost that asks for that.

namespace quadrille::internal {

/// The local terms that both ends of a pair share, about the first: the faces of the edge, and the
/// edge itself if it is on the boundary.
template <class Cost>
class SharedTerms {
public:
  void add(const typename Cost::Current& face, Index opposite) {
    sum_ += face;
    opposite_ = opposite;
    ++faces_;
  }

  template <class Positions>
  typename Cost::Current sum(Index a, Index b, const Cost& cost, const Positions& positions) const {
    if (faces_ != 1)
      return sum_;
    auto sum = cost.current_boundary(positions[a], positions[b], positions[opposite_]);
    return sum += sum_;
  }

private:
  typename Cost::Current sum_{};
  std::size_t faces_ = 0;
  Index opposite_ = none;
};

/// The local terms of a vertex, if its faces are few, and the terms that it shares with each of its
/// neighbours.
template <class Cost>
class LocalStar {
public:
  using Current = typename Cost::Current;
  static_assert(std::is_trivially_copyable_v<Current>,
                "quadrille: Cost::Current is not trivially copyable");
  static constexpr std::size_t most_faces = 16;

  LocalStar() {} // of no vertex

  template <class Positions>
  LocalStar(Index v, const Cost& cost, const Positions& positions, const TriangleComplex& complex) {
    clear(v);
    complex.for_each_corner(
        v, [&](Index face, Index i) { add(star_face_at(complex, face, i), cost, positions); });
  }

  /// Prepares for the faces of a vertex, or of none.
  void clear(Index v = none) {
    v_ = v;
    size_ = 0;
  }
  template <class Positions>
  void add(const StarFace& f, const Cost& cost, const Positions& positions) {
    second_[size_] = f.second;
    third_[size_] = f.third;
    ::new (&faces_[size_++]) // in its place: a copy would wait until all of it has been written
        Current(cost.current_face(positions[v_], positions[f.second], positions[f.third]));
  }

  Index vertex() const { return v_; }

  /// Calls visit(second, third, current) for each face.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (std::size_t i = 0; i < size_; ++i)
      visit(second_[i], third_[i], faces_[i]);
  }

  /// See SharedTerms.
  template <class Positions>
  Current shared_with(Index w, const Cost& cost, const Positions& positions) const {
    SharedTerms<Cost> shared;
    for (std::size_t i = 0; i < size_; ++i)
      if (second_[i] == w || third_[i] == w)
        shared.add(faces_[i], second_[i] == w ? third_[i] : second_[i]);
    return shared.sum(v_, w, cost, positions);
  }

private:
  Index v_ = none;
  std::size_t size_ = 0;
  std::array<Index, most_faces> second_, third_;
  union { // so that it is not filled before it is used
    std::array<Current, most_faces> faces_;
  };
};

/// Computes these terms for any number of faces. It labels the neighbours.
template <class Cost>
class LocalHighValence {
public:
  template <class Positions>
  LocalHighValence(Index v, const Cost& cost, const Positions& positions,
                   const TriangleComplex& complex, VertexLabels& labels)
      : v_(v), labels_(labels) {
    labels.clear(2 * complex.degree_bound(v));
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex, face, i);
      const auto now = cost.current_face(positions[v], positions[f.second], positions[f.third]);
      at(f.second).add(now, f.third);
      at(f.third).add(now, f.second);
    });
  }

  template <class Positions>
  typename Cost::Current shared_with(Index w, const Cost& cost, const Positions& positions) const {
    if (!labels_.is_labelled(w))
      return {}; // no edge
    return shared_[labels_[w]].sum(v_, w, cost, positions);
  }

private:
  SharedTerms<Cost>& at(Index w) {
    if (!labels_.is_labelled(w)) {
      labels_.set(w, static_cast<Index>(shared_.size()));
      shared_.emplace_back();
    }
    return shared_[labels_[w]];
  }

  Index v_;
  VertexLabels& labels_;
  std::vector<SharedTerms<Cost>> shared_; // by the label
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COST_LOCAL_STAR_H
