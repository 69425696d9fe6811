#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H

namespace quadrille::internal {

/// Upper limits of the distance from the points of a face to the input, and from the input points
/// that have come to lie in the face to it, in the engine's unit: see DistanceBounds. With a
/// tolerance both are fractions of it. Files store these bytes.
struct FaceBound {
  float from_input = 0, to_input = 0;
  float tolerance = 0; ///< the least of what the face stands for, see Tolerances; 0 without any
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H
