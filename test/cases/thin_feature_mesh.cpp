#include "engine.h"
#include <quadrille/thin_feature_quadric.h>

template void test::simplify_mesh(const Case&, Outcome&, const quadrille::ThinFeatureQuadric&);
