#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINE(template, ColorQuadric, false);
} // namespace quadrille::internal
