#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINE(template, TextureQuadric, false);
} // namespace quadrille::internal
