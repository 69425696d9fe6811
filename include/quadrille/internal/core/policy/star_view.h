#ifndef QUADRILLE_INTERNAL_CORE_POLICY_STAR_VIEW_H
#define QUADRILLE_INTERNAL_CORE_POLICY_STAR_VIEW_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <cstddef>

namespace quadrille::internal {

/// The faces around a pair, those of one end and those of both, as a placement sees them: in the
/// engine's units.
template <std::size_t N>
class StarView {
public:
  using Face = std::array<Vector<3>, 3>;

  StarView(const PairStar& star, Index first, Index second, const Vector<N>* positions,
           const Scale<N>& scale)
      : star_(star), first_(first), second_(second), positions_(positions), scale_(scale) {}

  std::size_t size() const {
    return star_.first.size() + star_.second.size() + star_.shared.size();
  }

  /// Calls visit(p, q, r) with the corners of each face, the first of which is an end of the pair.
  template <class Visit>
  void for_each_face(Visit visit) const {
    visit_all(star_.first, first_, visit);
    visit_all(star_.second, second_, visit);
    visit_all(star_.shared, first_, visit);
  }
  /// Does holds(p, q, r) return true for each? Stops at the first that does not.
  template <class Predicate>
  bool all_faces(Predicate predicate) const {
    return all(star_.first, first_, predicate) && all(star_.second, second_, predicate) &&
           all(star_.shared, first_, predicate);
  }

  /// Returns a position as it will be once it has been written to the user's mesh.
  Vector<N> as_written(const Vector<N>& x) const { return scale_.as_written(x); }
  /// By how much writing moves a coordinate of that size at most.
  double rounding(double coordinate) const { return scale_.rounding(coordinate); }

private:
  Vector<3> at(Index v) const { return space(positions_[v]); }

  template <class Visit>
  void visit_all(const AppendBuffer<StarFace>& faces, Index corner, Visit& visit) const {
    for (const StarFace& f : faces)
      visit(at(corner), at(f.second), at(f.third));
  }
  template <class Predicate>
  bool all(const AppendBuffer<StarFace>& faces, Index corner, Predicate& predicate) const {
    for (const StarFace& f : faces)
      if (!predicate(at(corner), at(f.second), at(f.third)))
        return false;
    return true;
  }

  const PairStar& star_;
  Index first_, second_;
  const Vector<N>* positions_;
  const Scale<N>& scale_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_STAR_VIEW_H
