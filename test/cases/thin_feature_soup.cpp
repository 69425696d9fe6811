#include "engine.h"
#include <quadrille/memoryless_quadric.h>

template void test::simplify_soup(const Case&, Outcome&, const quadrille::ThinFeatureQuadric&);
