#include <quadrille/compiled/engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, ThinFeatureQuadric);
} // namespace quadrille::internal
