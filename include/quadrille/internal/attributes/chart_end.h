#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHART_END_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHART_END_H

#include <quadrille/internal/core/base/index.h>

namespace quadrille::internal {

/// An edge vw of a face at which its chart ends.
struct ChartEnd {
  Index v, w, face;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHART_END_H
