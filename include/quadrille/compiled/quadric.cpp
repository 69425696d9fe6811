#include <quadrille/compiled/engine_definitions.h>
#include <quadrille/quadric.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, Quadric);
} // namespace quadrille::internal
