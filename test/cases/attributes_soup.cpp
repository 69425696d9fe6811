#include "engine.h"

template void test::simplify_soup(const Case&, Outcome&, const quadrille::TextureQuadric&);
