#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, MemorylessQuadric);
} // namespace quadrille::internal
