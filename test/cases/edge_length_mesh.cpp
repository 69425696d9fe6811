#include "engine.h"
#include <quadrille/edge_length.h>

template void test::simplify_mesh(const Case&, Outcome&, const quadrille::EdgeLength&);
