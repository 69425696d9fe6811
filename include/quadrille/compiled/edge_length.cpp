#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, EdgeLength);
} // namespace quadrille::internal
