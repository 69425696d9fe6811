#include "engine.h"
#include <quadrille/memoryless_quadric.h>

template void test::simplify_mesh(const Case&, Outcome&, const quadrille::ThinFeatureQuadric&);
