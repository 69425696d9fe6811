// Promises of the whole surface, of a file in parts.
#include <quadrille/file.h>
#include <quadrille/guards.h>
#include <quadrille/hull.h>
#include <quadrille/levels.h>

#include <cstddef>

namespace {

using namespace quadrille;

// As simplify_file does for its policies.
template <class Placement, class... Policies>
constexpr std::size_t size = sizeof(internal::ChunkRunner<Quadric, Placement, Policies...>);

#ifdef REMEDY
constexpr std::size_t of_remedy = size<OptimalPlacement>;
#else
constexpr std::size_t of_faces_apart = size<OptimalPlacement, NoSelfIntersection>; // mistake
constexpr std::size_t of_normals = size<OptimalPlacement, NormalDeviation>;        // mistake
constexpr std::size_t of_recorder = size<OptimalPlacement, RecordInto<Levels>>;    // mistake
constexpr std::size_t of_hull = size<OuterHull>;                                   // mistake
#endif

} // namespace
