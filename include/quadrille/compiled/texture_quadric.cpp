#include <quadrille/compiled/engines.h>
#include <quadrille/distance_limits.h>

namespace quadrille::internal {
QUADRILLE_ENGINE(template, TextureQuadric, false);
} // namespace quadrille::internal
