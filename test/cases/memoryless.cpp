#include "engine.h"

template void test::simplify_with(const Case&, Outcome&, const quadrille::MemorylessQuadric&);
