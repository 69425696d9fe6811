// What the figures of the papers show, in numbers: see doc/figures.md.
#include "../examples/products/figures/figure_1.h"
#include "../examples/products/figures/figure_2.h"
#include "../examples/products/figures/figure_3.h"
#include "../examples/products/figures/figure_4.h"
#include "../examples/products/figures/figure_5.h"
#include "../examples/products/figures/figure_6.h"
#include "../examples/products/figures/figure_7.h"
#include "../examples/products/figures/figure_8.h"
#include "../examples/products/figures/figure_9.h"

#include <catch2/catch.hpp>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// The example, which has the same figures: compiled here, it takes nothing more.
namespace example {
#include "../examples/products/figures/figures.cpp"
}

using namespace figures;

namespace {

bool is_closed_and_valid(const Mesh& mesh) {
  return CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_closed(mesh);
}

CGAL::Bbox_3 box(const Soup& soup) {
  CGAL::Bbox_3 sum;
  for (const Point& p : soup.points)
    sum += p.bbox();
  return sum;
}

} // namespace

TEST_CASE("Figure 1: quadrics are far better on a cow, and better on a sphere") {
  const Figure1 figure(QUADRILLE_MODELS_DIR);
  REQUIRE(figure.rows.size() == 3);
  const Figure1::Row &cow = figure.rows[0], &small_cow = figure.rows[1], &sphere = figure.rows[2];
  CHECK(cow.faces_before == 5804);
  CHECK(cow.by_length.number_of_faces() == 2000);
  CHECK(cow.by_quadric.number_of_faces() == 2000);
  CHECK(small_cow.by_length.number_of_faces() == 500);
  CHECK(small_cow.by_quadric.number_of_faces() == 500);
  CHECK(sphere.faces_before == 1984);
  CHECK(sphere.by_length.number_of_faces() == 496);
  CHECK(sphere.by_quadric.number_of_faces() == 496);
  for (const Figure1::Row& row : figure.rows) {
    CAPTURE(row.model);
    CHECK(is_closed_and_valid(row.by_length));
    CHECK(is_closed_and_valid(row.by_quadric));
  }

  CHECK(cow.length_error.rms > 3 * cow.quadric_error.rms);
  CHECK(cow.length_error.hausdorff > 2 * cow.quadric_error.hausdorff);
  CHECK(small_cow.length_error.rms > 3 * small_cow.quadric_error.rms);
  CHECK(small_cow.length_error.hausdorff > 2 * small_cow.quadric_error.hausdorff);
  CHECK(sphere.length_error.rms > sphere.quadric_error.rms);
  CHECK(sphere.length_error.rms < 3 * sphere.quadric_error.rms);
  CHECK(sphere.length_error.hausdorff > sphere.quadric_error.hausdorff);
  CHECK(cow.quadric_error.rms / cow.diagonal == Approx(0.00045).epsilon(0.03));
  CHECK(small_cow.quadric_error.rms / small_cow.diagonal == Approx(0.00206).epsilon(0.03));
}

TEST_CASE("Figure 2: by pairs the bones of a foot grow together") {
  const Figure2 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.original.triangles.size() == 4204);
  CHECK(figure.by_edges.soup.triangles.size() == 250);
  CHECK(figure.by_pairs.soup.triangles.size() == 250);
  CHECK(figure.by_edges.report.components_before == 26);
  CHECK(figure.by_edges.report.components_after == 18);
  CHECK(figure.by_edges.report.non_edge_contractions == 0);
  CHECK(figure.by_pairs.report.components_after == 1);
  CHECK(figure.by_pairs.report.non_manifold_edges == 61); // as in the paper
  CHECK(figure.by_edges.error.hausdorff > 2.3 * figure.by_pairs.error.hausdorff);
  CHECK(figure.by_edges.error.rms > 1.2 * figure.by_pairs.error.rms);

  // Clustering joins the bones and loses their shape.
  CHECK(figure.clustering.faces_after + figure.clustering.doubled_faces == 262); // as in the paper
  CHECK(figure.by_clustering.soup.triangles.size() == 217);
  CHECK(figure.by_clustering.report.components_after == 1);
  CHECK(figure.by_clustering.report.non_manifold_edges == 62);
  CHECK(figure.by_clustering_with_quadrics.soup.triangles == figure.by_clustering.soup.triangles);
  CHECK(figure.by_clustering_with_quadrics.error.rms < figure.by_clustering.error.rms);
  CHECK(figure.by_clustering_with_quadrics.error.rms > 1.5 * figure.by_pairs.error.rms);
  CHECK(figure.by_clustering.error.hausdorff > 2.3 * figure.by_pairs.error.hausdorff);

  // The foot has the size of the paper's.
  const CGAL::Bbox_3 foot = box(figure.original);
  CHECK(foot.x_span() == Approx(11.27).margin(0.01));
  CHECK(foot.y_span() == Approx(3.72).margin(0.01));
  CHECK(foot.z_span() == Approx(4.25).margin(0.01));
}

TEST_CASE("Figure 3: by pairs a hundred cubes become one block") {
  const Figure3 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.original.triangles.size() == 1200);
  CHECK(figure.by_edges.soup.triangles.size() == 840);
  CHECK(figure.by_edges.report.components_after == 100);
  CHECK(figure.by_pairs.soup.triangles.size() == 840);
  CHECK(figure.by_pairs.report.components_before == 100);
  CHECK(figure.by_pairs.report.components_after == 1);
  CHECK(figure.by_pairs.soup.points.size() == 11 * 11 * 2);

  // Every corner lies in the middle of those that have become it.
  CHECK(figure.by_pairs.error.hausdorff == Approx(Figure3::gap / std::sqrt(2.0)));
  CHECK(figure.by_edges.error.hausdorff > 5 * figure.by_pairs.error.hausdorff);
  CHECK(box(figure.by_pairs.soup) == box(figure.original));
}

TEST_CASE("Figure 4: the lines of boundary edges keep the borders in place") {
  const Figure4 figure(QUADRILLE_MODELS_DIR);
  const Border before(figure.original, Figure4::height), with(figure.with, Figure4::height),
      without(figure.without, Figure4::height);
  CHECK(figure.original.number_of_faces() == 7960);
  CHECK(figure.with.number_of_faces() == 2460);
  CHECK(figure.without.number_of_faces() == 2460);
  CHECK(before.length == Approx(2 * 199 * 2 * std::sin(std::numbers::pi / 199)));
  CHECK(before.distance < 1e-12);
  CHECK(with.length == Approx(before.length).epsilon(1e-4));
  CHECK(with.distance < 3e-4);
  CHECK(without.distance > 0.08);
}

TEST_CASE("Figure 5: colours in the quadric stay at least twice as true as interpolated ones") {
  const Figure5 figure(QUADRILLE_MODELS_DIR);
  REQUIRE(figure.rows.size() == 3);
  const Figure5::Row &globe = figure.rows[0], &room = figure.rows[1], &small_room = figure.rows[2];
  CHECK(globe.faces_before == 18'000);
  CHECK(room.faces_before == 73'728);
  for (const auto& [row, faces] :
       {std::pair(&globe, 1000U), std::pair(&room, 20'000U), std::pair(&small_room, 3000U)}) {
    CAPTURE(row->model, faces);
    CHECK(row->by_quadric.mesh.number_of_faces() == faces);
    CHECK(row->by_color_quadric.mesh.number_of_faces() == faces);
    CHECK(row->by_color_quadric.color_rms < 0.5 * row->by_quadric.color_rms);
  }
  CHECK(globe.by_color_quadric.color_rms < 6);
  CHECK(room.by_color_quadric.color_rms < 1.5);
  CHECK(small_room.by_color_quadric.color_rms < 1.5);

  // What that costs in shape.
  CHECK(globe.by_color_quadric.rms < 1.7 * globe.by_quadric.rms);
  CHECK(room.by_color_quadric.rms < 1e-6);
  CHECK(small_room.by_color_quadric.rms < 1e-6);
}

TEST_CASE("Figure 6: texture coordinates in the quadric slide less") {
  const Figure6 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.original.number_of_faces() == 3872);
  CHECK(figure.by_quadric.mesh.number_of_faces() == 53);
  CHECK(figure.by_texture_quadric.mesh.number_of_faces() == 53);
  CHECK(figure.by_texture_quadric.texture_rms < 0.83 * figure.by_quadric.texture_rms);
  CHECK(figure.by_texture_quadric.rms < 1.25 * figure.by_quadric.rms);
}

TEST_CASE("Figure 7: the bunny to 100 faces") {
  const Figure7 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.report.faces_before == 75'408);
  CHECK(figure.mesh.number_of_faces() == 100);
  CHECK(CGAL::is_valid_polygon_mesh(figure.mesh));
  CHECK(figure.rms < 0.0105);
}

TEST_CASE("Figure 8: quadrics are thin across the surface and wide along it") {
  const Figure8 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.mesh.number_of_faces() == 1000);
  CHECK(figure.ellipsoids.triangles.size() == 256 * figure.mesh.number_of_vertices());
  CHECK(figure.across < 1.1 * figure.level);
  CHECK(figure.along > 4 * figure.level);
}

TEST_CASE("Figure 9: the bones of a foot lie close to each other") {
  const Figure9 figure(QUADRILLE_MODELS_DIR);
  CHECK(figure.count(true) == 6306); // 3/2 of the faces: all parts are closed
  CHECK(figure.count(false) == 7826);
}

TEST_CASE("The example of the figures says how it is called") {
  char name[] = "figures";
  char* arguments[] = {name, nullptr};
  CHECK(example::main(1, arguments) == 2);
}
