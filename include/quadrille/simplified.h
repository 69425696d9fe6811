#ifndef QUADRILLE_SIMPLIFIED_H
#define QUADRILLE_SIMPLIFIED_H

#include <quadrille/internal/core/base/function_name.h>
#include <quadrille/internal/core/call/maps_of_copy.h>
#include <quadrille/simplify.h>

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

/// \file
/// Simplified copies: `auto [coarse, report] = simplified(mesh, FaceCount{1000});`

namespace quadrille {

/// The result of `simplified` for a mesh.
template <class Mesh>
struct Simplified {
  Mesh mesh;     ///< the simplified copy
  Report report; ///< the report of the call
};
/// The result of `simplified` for a soup.
template <class Points, class Triangles>
struct SimplifiedSoup {
  Points points;       ///< the points of the simplified copy
  Triangles triangles; ///< the triangles of the simplified copy
  Report report;       ///< the report of the call
};

namespace internal {

/// The type of the copy of a container: for a span a vector.
template <class Container>
struct CopyOf : std::type_identity<Container> {
  static Container of(const Container& container) { return container; }
};
template <class T, std::size_t N>
struct CopyOf<std::span<T, N>> : std::type_identity<std::vector<std::remove_const_t<T>>> {
  static typename CopyOf::type of(std::span<T, N> numbers) {
    return {numbers.begin(), numbers.end()};
  }
};
/// The type of the copy of a matrix view, such as a map: the plain matrix.
template <class View>
requires requires {
  requires MatrixView<View>;
  typename View::PlainObject;
}
struct CopyOf<View> : std::type_identity<typename View::PlainObject> {
  static typename CopyOf::type of(const View& view) { return view; }
};
template <class Container>
using Copy = typename CopyOf<Container>::type;

template <class Points, class Triangles>
concept CopiedSoup = BufferedSoup<Points, Triangles> ||
    (PointContainer<Points>&& TriangleContainer<Triangles>);

/// Removes elements that a mesh has only marked as removed.
template <class Mesh>
void tidy_up([[maybe_unused]] Mesh& mesh) {
  if constexpr (requires { mesh.collect_garbage(); })
    mesh.collect_garbage(); // Surface_mesh
  else if constexpr (requires { mesh.garbage_collection(); })
    mesh.garbage_collection(); // OpenMesh
}

} // namespace internal

inline namespace QUADRILLE_THREADING {

/// Returns a simplified copy of a triangle mesh, with its report; `mesh` is not changed. The
/// arguments are those of `simplify`.
///
/// The copy has exactly the remaining vertices and faces, in their order, and all properties that a
/// copy of the mesh has. A mesh that marks removed elements is compacted, so that vertices and
/// faces have other numbers than in `mesh`.
///
/// Maps over `mesh` are applied to the copy where possible: properties of a Surface_mesh, including
/// channels (`simplified(mesh, Texture{uv})` writes the copy's property of the same name), and maps
/// without state, which read the element itself. If vertices have the same numbers in a copy
/// (Surface_mesh, OpenMesh), this includes all other maps that are only read: constraints, creases,
/// labels, indices. Other maps do not compile, nor do vertex_to_vertex_map, face_to_face_map,
/// vertex_quadric_map and duplicate_output_iterator: there copy the mesh and call `simplify`.
///
/// Throws whatever `simplify` or copying throws.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::FaceGraph<Mesh> Simplified<Mesh> simplified(const Mesh& mesh,
                                                               const Arguments&... arguments) {
  Simplified<Mesh> result{mesh, {}};
  result.report = internal::in_name_of("simplified", [&] {
    return quadrille::simplify<Cost, Placement>(result.mesh,
                                                internal::of_copy(arguments, mesh, result.mesh)...);
  });
  internal::tidy_up(result.mesh);
  return result;
}

/// A simplified copy of a soup, with its report: `auto [points, triangles, report] =
/// simplified(points, triangles)`, of containers, flat numbers and matrices, as for `simplify`. Of
/// a std::span, also of constant numbers, the copy is a std::vector, of a map of Eigen a matrix.
///
/// Maps and vectors of channels and labels are the caller's, and are written as by `simplify`, at
/// the new indices: pass those of a copy. All named parameters have the meaning that they have
/// there.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::CopiedSoup<internal::Copy<Points>, internal::Copy<Triangles>> &&
    (!internal::is_position_attribute<Points>)
        SimplifiedSoup<internal::Copy<Points>, internal::Copy<Triangles>> simplified(
            const Points& points, const Triangles& triangles, const Arguments&... arguments) {
  SimplifiedSoup<internal::Copy<Points>, internal::Copy<Triangles>> result{
      internal::CopyOf<Points>::of(points), internal::CopyOf<Triangles>::of(triangles), {}};
  result.report = internal::in_name_of("simplified", [&] {
    return quadrille::simplify<Cost, Placement>(result.points, result.triangles, arguments...);
  });
  return result;
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_SIMPLIFIED_H
