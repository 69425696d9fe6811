#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_DOUBLED_FACES_OF_STAR_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_DOUBLED_FACES_OF_STAR_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// Faces of a star that have the same corners once it is contracted: all but one may go, see
/// Cleanup, and leave their points to it.
class DoubledFacesOfStar {
public:
  /// Of those that a contraction changes, in the order of the star, the one that is left gets the
  /// greatest of their bounds.
  void join(const PairStar& star, std::vector<float>& bounds) {
    doubled_.clear();
    star.for_each_changed([&](const StarFace& f) {
      const auto& [p, q] = std::minmax(f.second, f.third);
      doubled_.push_back({p, q, f.face, doubled_.size()});
    });
    std::sort(doubled_.begin(), doubled_.end());
    for (std::size_t i = 1, first = 0; i < doubled_.size(); ++i) {
      const auto& [p, q, face, position] = doubled_[i];
      const auto& [first_p, first_q, first_face, left] = doubled_[first];
      if (p == first_p && q == first_q) // the one that is left has the least number
        bounds[left] = (std::max)(bounds[left], bounds[position]);
      else
        first = i;
    }
  }

private:
  std::vector<std::tuple<Index, Index, Index, std::size_t>> doubled_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_DOUBLED_FACES_OF_STAR_H
