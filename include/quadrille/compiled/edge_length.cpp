#include <quadrille/compiled/engine_definitions.h>
#include <quadrille/edge_length.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, EdgeLength);
} // namespace quadrille::internal
