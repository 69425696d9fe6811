// The headers are found, those of CGAL and Boost as well, and compile as C++20.
#include <CGAL/version_macros.h>
#include <boost/version.hpp>
#include <quadrille/quadric_form.h>

int main() {
  return quadrille::QuadricForm<3>::point(2)(quadrille::Vector<3>{{1, 0, 0}}) == 2 ? 0 : 1;
}
