#ifndef QUADRILLE_INTERNAL_NORMALS_NORMAL_CHECK_H
#define QUADRILLE_INTERNAL_NORMALS_NORMAL_CHECK_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/vector.h>

namespace quadrille::internal {

/// What knows the normals of the input that each face of a surface stands for. It is compiled for
/// calls with NormalDeviation only: see FaceCones. Any number of threads may ask at once, and
/// follow contractions of stars that have no face in common.
class NormalCheck {
public:
  virtual ~NormalCheck() = default;

  /// The surface is as it is before the first contraction.
  virtual void begin() = 0;
  /// Would a normal be too far from one of those, if this pair, of which one end is given,
  /// came together at a target?
  virtual bool is_too_far(const PairStar& star, Index second, const Vector<3>& target) const = 0;
  /// That has been done, or is being done: the star is as it was before.
  virtual void follow(const PairStar& star, Index second) = 0;
  /// Faces that are removed are about to lose their numbers.
  virtual void pack() = 0;
  /// How far the normal of a face that is left is from one of those, at most, in degrees.
  virtual double greatest_degrees() const = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_NORMALS_NORMAL_CHECK_H
