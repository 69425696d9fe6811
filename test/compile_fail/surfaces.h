#ifndef TEST_COMPILE_FAIL_SURFACES_H
#define TEST_COMPILE_FAIL_SURFACES_H

// A mesh and a soup to call simplify with.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <array>
#include <quadrille/simplify.h>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
inline CGAL::Surface_mesh<Point> mesh;
inline std::vector<Point> points;
inline std::vector<std::array<int, 3>> triangles;

#endif // TEST_COMPILE_FAIL_SURFACES_H
