#ifndef QUADRILLE_INTERNAL_COST_LOCAL_TERMS_H
#define QUADRILLE_INTERNAL_COST_LOCAL_TERMS_H

#include <quadrille/internal/complex/edge_star.h>
#include <quadrille/internal/complex/link_condition.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// What both ends of a pair see, about the first: the faces of the edge, and the edge itself if it
/// is on the boundary.
template <class Cost>
class SharedCurrent {
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

/// What the faces of a vertex say, if they are few, and what it shares with each of its neighbours.
template <class Cost>
class CurrentStar {
public:
  using Current = typename Cost::Current;
  static_assert(std::is_trivially_copyable_v<Current>,
                "quadrille: Cost::Current is no plain value");
  static constexpr std::size_t most_faces = 16;

  CurrentStar() {} // of no vertex

  template <class Positions>
  CurrentStar(Index v, const Cost& cost, const Positions& positions,
              const TriangleComplex& complex) {
    gather(v, cost, positions, complex);
  }

  void clear() { v_ = none; }

  template <class Positions, class Complex>
  void gather(Index v, const Cost& cost, const Positions& positions, Complex& complex) {
    v_ = v;
    size_ = 0;
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex, face, i);
      second_[size_] = f.second;
      third_[size_] = f.third;
      ::new (&faces_[size_++]) // in its place: a copy would wait until all of it has been written
          Current(cost.current_face(positions[v], positions[f.second], positions[f.third]));
    });
  }

  Index vertex() const { return v_; }

  /// Calls visit(second, third, current) for each face.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (std::size_t i = 0; i < size_; ++i)
      visit(second_[i], third_[i], faces_[i]);
  }

  /// See SharedCurrent.
  template <class Positions>
  Current shared_with(Index w, const Cost& cost, const Positions& positions) const {
    SharedCurrent<Cost> shared;
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

/// The same for any number of faces. It marks the neighbours.
template <class Cost>
class CurrentHub {
public:
  template <class Positions>
  CurrentHub(Index v, const Cost& cost, const Positions& positions, const TriangleComplex& complex,
             Marks& marks)
      : v_(v), marks_(marks) {
    marks.clear(2 * complex.degree_bound(v));
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex, face, i);
      const auto now = cost.current_face(positions[v], positions[f.second], positions[f.third]);
      at(f.second).add(now, f.third);
      at(f.third).add(now, f.second);
    });
  }

  template <class Positions>
  typename Cost::Current shared_with(Index w, const Cost& cost, const Positions& positions) const {
    if (!marks_.is_marked(w))
      return {}; // no edge
    return shared_[marks_[w]].sum(v_, w, cost, positions);
  }

private:
  SharedCurrent<Cost>& at(Index w) {
    if (!marks_.is_marked(w)) {
      marks_.set(w, static_cast<Index>(shared_.size()));
      shared_.emplace_back();
    }
    return shared_[marks_[w]];
  }

  Index v_;
  Marks& marks_;
  std::vector<SharedCurrent<Cost>> shared_; // by the mark
};

/// What each vertex knows of the surface as it is now, for a cost that asks for that: the sum over
/// its faces and boundary edges, kept up to date through contractions.
template <class Cost>
class CurrentMemories {
public:
  using Position = Vector<Cost::dimension>;
  using Positions = Array<Position>;
  using Current = typename Cost::Current;

  CurrentMemories() = default;
  /// is_interior(v) tells of vertices that have no boundary edge for certain.
  template <class IsInterior>
  CurrentMemories(const Cost& cost, const Positions& positions, TriangleComplex& complex,
                  Marks& marks, IsInterior is_interior)
      : current_(positions.size(), positions.get_allocator()) {
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      if (complex.is_dead(face))
        continue;
      const auto [p, q, r] = complex.vertices(face);
      const Current now = cost.current_face(positions[p], positions[q], positions[r]);
      for (Index v : {p, q, r})
        current_[v] += now;
    }
    for (Index v = 0; v < positions.size(); ++v)
      if (!is_interior(v))
        add_boundary(v, cost, positions, complex, marks);
  }

  const Current& operator[](Index v) const { return current_[v]; }

  /// See SharedCurrent.
  static Current shared(Index a, Index b, const Cost& cost, const Positions& positions,
                        const TriangleComplex& complex) {
    SharedCurrent<Cost> shared;
    complex.for_each_corner(a, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex, face, i);
      if (f.second == b || f.third == b)
        shared.add(cost.current_face(positions[a], positions[f.second], positions[f.third]),
                   f.second == b ? f.third : f.second);
    });
    return shared.sum(a, b, cost, positions);
  }

  /// Takes the faces that a contraction changes or removes out of the vertices around it for which
  /// is_wanted(v) holds.
  template <class IsWanted>
  void forget(const PairStar& star, Index a, Index b, const Cost& cost, const Positions& positions,
              IsWanted is_wanted) {
    const auto forget_all = [&](const Room<StarFace>& faces, Index corner) {
      for (const StarFace& f : faces) {
        const Current old =
            cost.current_face(positions[corner], positions[f.second], positions[f.third]);
        for (Index v : {f.second, f.third})
          if (is_wanted(v))
            current_[v] -= old;
      }
    };
    forget_all(star.first, a);
    forget_all(star.second, b);
    forget_all(star.shared, a);
  }

  /// Puts the faces that a contraction has left into its vertex and those around it.
  void learn(Index kept, const Cost& cost, const Positions& positions, TriangleComplex& complex) {
    Current sum{};
    const auto add = [&](Index second, Index third, const Current& now) {
      sum += now;
      current_[second] += now;
      current_[third] += now;
    };
    if (complex.degree_bound(kept) <= CurrentStar<Cost>::most_faces) {
      learned_.gather(kept, cost, positions, complex);
      learned_.for_each_face(add);
    } else {
      learned_.clear();
      complex.for_each_corner(kept, [&](Index face, Index i) {
        const StarFace f = PairStar::star_face(complex, face, i);
        add(f.second, f.third,
            cost.current_face(positions[kept], positions[f.second], positions[f.third]));
      });
    }
    current_[kept] = sum;
  }

  /// Puts the faces that a contraction in a pass has left into the vertices around it for which
  /// is_wanted(v) holds.
  template <class IsWanted>
  void learn_around(const PairStar& star, Index kept, const Cost& cost, const Positions& positions,
                    const TriangleComplex& complex, IsWanted is_wanted) {
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces) {
        if (complex.is_dead(f.face))
          continue;
        const Current now =
            cost.current_face(positions[kept], positions[f.second], positions[f.third]);
        for (Index v : {f.second, f.third})
          if (is_wanted(v))
            current_[v] += now;
      }
  }

  /// Of the vertex that was learned last, if its faces are few: as they are now.
  const CurrentStar<Cost>& learned() const { return learned_; }

  void recompute(Index v, const Cost& cost, const Positions& positions, TriangleComplex& complex,
                 Marks& marks) {
    Current& sum = current_[v] = {};
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex, face, i);
      sum += cost.current_face(positions[v], positions[f.second], positions[f.third]);
    });
    add_boundary(v, cost, positions, complex, marks);
  }

private:
  void add_boundary(Index v, const Cost& cost, const Positions& positions, TriangleComplex& complex,
                    Marks& marks) {
    for (const EdgeAt& edge : edges_.gather(complex, v, marks))
      if (edge.faces == 1)
        current_[v] +=
            cost.current_boundary(positions[v], positions[edge.other], positions[edge.opposite[0]]);
  }

  Array<Current> current_;
  CurrentStar<Cost> learned_;
  EdgeStar edges_;
};

/// For a cost that does not ask.
struct NoCurrentMemories {};

template <class Cost>
struct CurrentMemoriesOf {
  using type = NoCurrentMemories;
  static constexpr std::size_t bytes_a_vertex = 0;
};
template <class Cost>
requires asks_for_current<Cost>
struct CurrentMemoriesOf<Cost> {
  using type = CurrentMemories<Cost>;
  static constexpr std::size_t bytes_a_vertex = sizeof(typename Cost::Current);
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COST_LOCAL_TERMS_H
