#include <quadrille/compiled/engine_definitions.h>
#include <quadrille/memoryless_quadric.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, ThinFeatureQuadric);
} // namespace quadrille::internal
