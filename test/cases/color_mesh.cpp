#include "engine.h"
#include <quadrille/attribute_quadric.h>

template void test::simplify_mesh(const Case&, Outcome&, const quadrille::ColorQuadric&);
