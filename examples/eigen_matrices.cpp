// Simplifies matrices V and F, as libigl has them, to 1,000 faces.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <Eigen/Core>
#include <array>
#include <iostream>
#include <quadrille/simplify.h>
#include <vector>

int main(int argc, char* argv[]) {
  using namespace quadrille;

  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<int, 3>> triangles;
  if (!CGAL::IO::read_polygon_soup(input, points, triangles)) {
    std::cerr << "no triangles: " << input << '\n';
    return EXIT_FAILURE;
  }
  Eigen::MatrixXd V(points.size(), 3); // or MatrixXf, by rows or by columns
  Eigen::MatrixXi F(triangles.size(), 3);
  for (Eigen::Index i = 0; const auto& p : points)
    V.row(i++) << p.x(), p.y(), p.z();
  for (Eigen::Index i = 0; const auto& [a, b, c] : triangles)
    F.row(i++) << a, b, c;

  std::cout << simplify<Quadric, OptimalPlacement>(V, F, FaceCount{1000}) << '\n';
  std::cout << V.rows() << " rows of V, " << F.rows() << " rows of F\n";
}
