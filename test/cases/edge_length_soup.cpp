#include "engine.h"
#include <quadrille/edge_length.h>

template void test::simplify_soup(const Case&, Outcome&, const quadrille::EdgeLength&);
