#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, Quadric);
} // namespace quadrille::internal
