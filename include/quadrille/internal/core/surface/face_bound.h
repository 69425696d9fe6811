#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H

namespace quadrille::internal {

/// How far the points of a face are from the input at most, and the input points that have come to
/// lie in it from the face, in the engine's unit: see DistanceBounds. With a tolerance both are
/// parts of that. Where it is written to a file it is these bytes.
struct FaceBound {
  float from_input = 0, to_input = 0;
  float tolerance = 0; ///< the least of what the face stands for, see Tolerances; 0 without any
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_FACE_BOUND_H
