#ifndef QUADRILLE_INTERNAL_CORE_POLICY_CONTRACTION_VIEW_H
#define QUADRILLE_INTERNAL_CORE_POLICY_CONTRACTION_VIEW_H

#include <quadrille/internal/core/complex/star_face.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace quadrille::internal {

class TriangleComplex; // who only asks whether a class models a concept needs no more of it

/// A face that a contraction changes: its moving corner before and after, and its two others.
struct ChangedFace {
  Vector<3> before, after, second, third;
};

/// The faces that a contraction changes, of a view of it.
template <class View>
class ChangedFaces {
public:
  explicit ChangedFaces(const View& view) : view_(view) {}
  class Iterator {
  public:
    Iterator(const View& view, std::size_t i) : view_(view), i_(i) {}
    auto operator*() const { return view_.face(i_); }
    Iterator& operator++() { return ++i_, *this; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }

  private:
    const View& view_;
    std::size_t i_;
  };
  Iterator begin() const { return {view_, 0}; }
  Iterator end() const { return {view_, size()}; }
  std::size_t size() const { return view_.face_count(); }

private:
  const View& view_;
};

/// The view that a filter has of a contraction that is about to be done, in the engine's units; a
/// user's filter sees an IndexedContraction.
template <std::size_t N, class Complex = TriangleComplex>
class ContractionView {
public:
  template <class Star>
  ContractionView(const Star& star, const Complex& complex, const Vector<N>* positions,
                  const Vector<N>& first, const Vector<N>& second, const Vector<N>& target)
      : first_faces_(star.first.begin(), star.first.end()),
        second_faces_(star.second.begin(), star.second.end()), shared_(star.shared.size()),
        high_valence_(star.high_valence), complex_(complex), positions_(positions), first_(first),
        second_(second), target_(target) {}

  /// Returns the faces that stay. At a high-valence vertex, which stays in its place, these are the
  /// faces next to the other end only.
  ChangedFaces<ContractionView> faces() const { return ChangedFaces(*this); }
  std::size_t face_count() const { return first_faces_.size() + second_faces_.size(); }
  ChangedFace face(std::size_t i) const {
    const StarFace& f = star_face(i);
    return {space(i < first_faces_.size() ? first_ : second_), space(target_),
            space(positions_[f.second]), space(positions_[f.third])};
  }
  const Vector<N>& target() const { return target_; }

  /// How many faces the end with more of them has before.
  std::size_t highest_degree() const {
    if (high_valence_ != none)
      return complex_.degree_bound(high_valence_);
    return (std::max)(first_faces_.size(), second_faces_.size()) + shared_;
  }

  /// Would a face be folded like the middle of a letter Z, as it is not now? Then it is turned by
  /// more than 90 degrees from one neighbour over a ridge, and from another over a valley: no sharp
  /// feature of a surface looks like that.
  ///
  /// Only faces that would look away from the mean of all by more than 60 degrees are looked at,
  /// and none around vertices of very many faces.
  bool makes_fold_over() const {
    if (faces().size() > many_faces)
      return false;
    Vector<3> sum{};
    for (const ChangedFace& f : faces())
      sum += normal_after(f);
    for (std::size_t i = 0; i < faces().size(); ++i)
      if (!is_within(0.25, normal_after(face(i)), sum) && is_new_fold_over(i))
        return true;
    return false;
  }

protected:
  /// The corners, before it, of a face of both ends.
  std::array<Vector<3>, 3> shared_corners(const StarFace& f, Index second) const {
    const auto place = [&](Index v) { return space(v == second ? second_ : positions_[v]); };
    return {space(first_), place(f.second), place(f.third)};
  }
  const StarFace& star_face(std::size_t i) const {
    const std::size_t n = first_faces_.size();
    return i < n ? first_faces_[i] : second_faces_[i - n];
  }

private:
  static constexpr std::size_t many_faces = 128;

  // Is the angle between them acute, and its cosine squared above this?
  static bool is_within(double squared_cosine, const Vector<3>& a, const Vector<3>& b) {
    const double product = dot(a, b);
    return product > 0 &&
           product * product > squared_cosine * squared_length(a) * squared_length(b);
  }

  // Over what a face turns back from its neighbours, by more than 90.5 degrees: right angles are
  // no folds, whatever they are rounded to.
  struct Bends {
    bool over_ridge = false, over_valley = false;

    // to_apex leads from the common edge into the neighbour.
    void see(const Vector<3>& normal, const Vector<3>& neighbour, const Vector<3>& to_apex) {
      if (is_within(0x1p-14, normal, -1.0 * neighbour))
        (dot(normal, to_apex) < 0 ? over_ridge : over_valley) = true;
    }
    bool is_fold_over() const { return over_ridge && over_valley; }
  };

  bool is_new_fold_over(std::size_t i) const {
    const ChangedFace f = face(i);
    const StarFace& ids = star_face(i);
    Bends before, after;
    for (std::size_t j = 0; j < faces().size(); ++j) {
      const StarFace& neighbour = star_face(j);
      if (neighbour.second != ids.third && neighbour.third != ids.second)
        continue;
      const ChangedFace g = face(j);
      const Vector<3> edge =
          neighbour.second == ids.third ? g.third - f.third : g.second - f.second;
      before.see(normal_before(f), normal_before(g), edge);
      after.see(normal_after(f), normal_after(g), edge);
    }
    if (complex_.degree_bound(ids.second) <= many_faces)
      complex_.for_each_corner(ids.second, [&](Index face, Index corner) {
        const StarFace g = star_face_at(complex_, face, corner);
        if (g.third != ids.third) // a neighbour has the edge the other way round
          return;
        const Vector<3> apex = space(positions_[g.second]);
        const Vector<3> normal = double_area_vector(f.second, apex, f.third);
        before.see(normal_before(f), normal, apex - f.second);
        after.see(normal_after(f), normal, apex - f.second);
      });
    return after.is_fold_over() && !before.is_fold_over();
  }

  static Vector<3> normal_before(const ChangedFace& f) {
    return double_area_vector(f.before, f.second, f.third);
  }
  static Vector<3> normal_after(const ChangedFace& f) {
    return double_area_vector(f.after, f.second, f.third);
  }

  std::span<const StarFace> first_faces_, second_faces_;
  std::size_t shared_;
  Index high_valence_; // of which not all faces are here, or none
  const Complex& complex_;
  const Vector<N>* positions_;
  const Vector<N>&first_, &second_, &target_;
};

/// A face that a contraction changes, with its index in the input.
struct IndexedFace : ChangedFace {
  std::size_t index;
};

/// A face that a contraction removes: its corners before it, in its order, and its index in the
/// input.
struct GoneFace {
  std::array<Vector<3>, 3> corners;
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

/// The view that filters other than NormalFlip have of a contraction: they may ask which vertices
/// and faces of the input it involves.
template <std::size_t N>
class IndexedContraction : public ContractionView<N> {
public:
  template <class Star>
  IndexedContraction(const ContractionView<N>& view, const Star& star, Index first, Index second,
                     const Numbering& numbering)
      : ContractionView<N>(view), first_(first), second_(second),
        shared_(star.shared.begin(), star.shared.end()), numbering_(numbering) {}

  /// The ends. A vertex that others were merged into still has an index of its own.
  std::size_t first() const { return numbering_.vertices[first_]; }
  std::size_t second() const { return numbering_.vertices[second_]; }

  ChangedFaces<IndexedContraction> faces() const { return ChangedFaces(*this); }
  IndexedFace face(std::size_t i) const {
    return {ContractionView<N>::face(i), numbering_.faces[this->star_face(i).face]};
  }
  /// Returns the faces of both ends.
  RemovedFaces removed_faces() const { return {shared_, numbering_.faces}; }
  /// Calls visit(GoneFace) for each of these faces, with its corners.
  template <class Visit>
  void for_each_gone(Visit visit) const {
    for (const StarFace& f : shared_)
      visit(GoneFace{this->shared_corners(f, second_), numbering_.faces[f.face]});
  }

private:
  Index first_, second_;
  std::span<const StarFace> shared_;
  const Numbering& numbering_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_CONTRACTION_VIEW_H
