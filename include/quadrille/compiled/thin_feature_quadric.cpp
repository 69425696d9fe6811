#include <quadrille/compiled/engine_definitions.h>
#include <quadrille/thin_feature_quadric.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, ThinFeatureQuadric);
} // namespace quadrille::internal
