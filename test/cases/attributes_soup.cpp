#include "engine.h"
#include <quadrille/attribute_quadric.h>

template void test::simplify_soup(const Case&, Outcome&, const quadrille::TextureQuadric&);
