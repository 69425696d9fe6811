#include "engine.h"

template void test::simplify_mesh(const Case&, Outcome&, const quadrille::TextureQuadric&);
