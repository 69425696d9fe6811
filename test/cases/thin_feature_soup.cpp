#include "engine.h"
#include <quadrille/thin_feature_quadric.h>

template void test::simplify_soup(const Case&, Outcome&, const quadrille::ThinFeatureQuadric&);
