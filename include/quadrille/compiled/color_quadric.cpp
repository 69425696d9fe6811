#include <quadrille/attribute_quadric.h>
#include <quadrille/compiled/engine_definitions.h>

namespace quadrille::internal {
QUADRILLE_ENGINE(template, ColorQuadric, false);
} // namespace quadrille::internal
