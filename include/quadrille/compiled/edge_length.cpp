#include <quadrille/compiled/engines.h>
#include <quadrille/distance_limits.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, EdgeLength);
} // namespace quadrille::internal
