#ifndef QUADRILLE_INTERNAL_STAR_H
#define QUADRILLE_INTERNAL_STAR_H

#include <quadrille/internal/triangle_complex.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// A face at a vertex: its other two vertices, in the order of the face.
struct StarFace {
  Index face, second, third;

  StarFace() {} // a new one is not written to before it is used
  StarFace(Index f, Index s, Index t) : face(f), second(s), third(t) {}
};

/// The faces around a pair of vertices: those of one end only, which a contraction changes, and
/// those of both, which it removes.
struct PairStar {
  std::vector<StarFace> first, second; // the faces of one end only
  std::vector<StarFace> shared;        // the faces of both, seen from the first end

  void gather(TriangleComplex& complex, Index a, Index b) {
    first.resize(complex.degree_bound(a));
    shared.resize(first.size());
    second.resize(complex.degree_bound(b));
    std::size_t ours = 0, both = 0, theirs = 0;
    complex.for_each_corner(a, [&](Index face, Index i) { // without a branch: it is hard to guess
      const StarFace f = star_face(complex, face, i);
      const bool is_shared = (f.second == b) | (f.third == b);
      first[ours] = shared[both] = f;
      both += is_shared;
      ours += !is_shared;
    });
    complex.for_each_corner(b, [&](Index face, Index i) {
      const StarFace f = second[theirs] = star_face(complex, face, i);
      theirs += (f.second != a) & (f.third != a);
    });
    first.resize(ours);
    shared.resize(both);
    second.resize(theirs);
  }

  static StarFace star_face(const TriangleComplex& complex, Index face, Index i) {
    const auto& v = complex.vertices(face);
    return {face, v[i == 2 ? 0 : i + 1], v[i == 0 ? 2 : i - 1]};
  }
};

/// A face that a contraction changes: its moving corner before and after, and its two others.
struct ChangedFace {
  Vector<3> before, after, second, third;
};

/// What a filter sees of a contraction that is about to be done.
template <std::size_t N>
class ContractionView {
public:
  ContractionView(const PairStar& star, const std::vector<Vector<N>>& positions,
                  const Vector<N>& first, const Vector<N>& second, const Vector<N>& target)
      : star_(star), positions_(positions), first_(first), second_(second), target_(target) {}

  class Faces {
  public:
    explicit Faces(const ContractionView& view) : view_(view) {}
    class Iterator {
    public:
      Iterator(const ContractionView& view, std::size_t i) : view_(view), i_(i) {}
      ChangedFace operator*() const { return view_.face(i_); }
      Iterator& operator++() { return ++i_, *this; }
      friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }

    private:
      const ContractionView& view_;
      std::size_t i_;
    };
    Iterator begin() const { return {view_, 0}; }
    Iterator end() const { return {view_, size()}; }
    std::size_t size() const { return view_.star_.first.size() + view_.star_.second.size(); }

  private:
    const ContractionView& view_;
  };

  /// The faces that stay, as ChangedFace, in the engine's unit of length.
  Faces faces() const { return Faces(*this); }
  const Vector<N>& target() const { return target_; }

  /// How many faces the end with more of them has before.
  std::size_t highest_degree() const {
    return std::max(star_.first.size(), star_.second.size()) + star_.shared.size();
  }

private:
  ChangedFace face(std::size_t i) const {
    const std::size_t n = star_.first.size();
    const StarFace& f = i < n ? star_.first[i] : star_.second[i - n];
    return {space(i < n ? first_ : second_), space(target_), space(positions_[f.second]),
            space(positions_[f.third])};
  }

  const PairStar& star_;
  const std::vector<Vector<N>>& positions_;
  const Vector<N>&first_, second_, target_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_STAR_H
