// Each property notices what it is there for: a right result is changed, and it alone complains.
#include "meshes.h"
#include "properties.h"

#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace quadrille;
using test::Asked;
using test::Position;
using test::Result;

/// Two spheres, of which a third of the faces is left: so few that distances are measured.
struct Run {
  Asked asked;
  Result result;

  Run() {
    asked.soup = test::joined(test::sphere(1), test::sphere(2), {{3, 0, 0}});
    asked.is_at_endpoints = true;
    asked.stop = FaceRatio{0.3};
    test::PointSoup soup(asked.soup);
    result.report =
        simplify<Quadric, EndpointPlacement>(soup.points, soup.triangles, FaceRatio{0.3});
    for (const auto& p : soup.points)
      result.soup.points.push_back(test::to_position(p));
    result.soup.triangles = soup.triangles;
  }
};

/// With labels, tolerances and limits, as the right result of a run that has done nothing.
struct Untouched {
  Asked asked;
  Result result;

  Untouched() {
    asked.soup = result.soup = test::sphere(2);
    const std::size_t faces = asked.soup.triangles.size(), points = asked.soup.points.size();
    asked.distance = asked.distance_both_ways = 0.01;
    asked.tolerances.assign(points, 0.01);
    for (std::size_t f = 0; f < faces; ++f)
      asked.labels.push_back(asked.soup.points[asked.soup.triangles[f][0]][0] > 0);
    result.labels = asked.labels;
    asked.smallest_angle = 10;
    asked.longest_edge = 1;
    asked.degree = 6;
    for (std::uint32_t v = 0; v < points; ++v)
      result.images.push_back(v);
    for (std::uint32_t f = 0; f < faces; ++f)
      result.input_faces.push_back(f);
    result.report.distance_bound = result.report.hausdorff_bound = 0;
  }
};

template <class Made>
std::string complaint(const std::function<void(Made&)>& change,
                      std::span<const test::Property> properties) {
  Made made;
  REQUIRE(test::broken(made.asked, made.result, properties) == "");
  change(made);
  const std::string text = test::broken(made.asked, made.result, properties);
  return text.substr(0, text.find(':'));
}

} // namespace

TEST_CASE("Each property of results notices what it is there for") {
  const auto complaint_of = [](const std::function<void(Run&)>& change) {
    return complaint<Run>(change, test::properties_of_results());
  };
  CHECK(complaint_of([](Run& r) { r.result.soup.points[7][1] = std::nan(""); }) == "valid");
  CHECK(complaint_of([](Run& r) { r.result.soup.triangles[3][1] = 1000; }) == "valid");
  CHECK(complaint_of([](Run& r) { r.asked.attributes.resize(r.asked.soup.points.size()); }) ==
        "valid");
  CHECK(complaint_of([](Run& r) {
          r.result.soup.triangles.push_back(r.result.soup.triangles[0]);
        }) == "clean");
  CHECK(complaint_of([](Run& r) { r.result.soup.points.push_back({}); }) == "clean");
  CHECK(complaint_of([](Run& r) {
          r.result.soup.triangles[3][0] = r.result.soup.triangles[3][1];
        }) == "clean");
  CHECK(complaint_of([](Run& r) { ++r.result.report.faces_after; }) == "counts");
  CHECK(complaint_of([](Run& r) { ++r.result.report.components_after; }) == "counts");
  CHECK(complaint_of([](Run& r) { r.result.report.non_edge_contractions = 1; }) == "counts");
  CHECK(complaint_of([](Run& r) { r.asked.stop = FaceCount{10}; }) == "target");
  CHECK(complaint_of([](Run& r) { r.asked.contractions = 3; }) == "target");
  CHECK(complaint_of([](Run& r) { r.result.report.stop = StopReason::cancelled; }) == "target");
  CHECK(complaint_of([](Run& r) {
          r.result.report.distance_bound = 0.2;
          for (Position& p : r.result.soup.points)
            p[2] += 0.3;
        }) == "distance_bound");
  CHECK(complaint_of([](Run& r) { r.asked.is_fixed.assign(r.asked.soup.points.size(), true); }) ==
        "constraints");
  CHECK(complaint_of([](Run& r) {
          for (const auto& [a, b, c] : r.asked.soup.triangles)
            r.asked.kept.push_back({a, b});
        }) == "constraints");
  CHECK(complaint_of([](Run& r) { r.result.report.vanished_components = 1; }) == "topology");
  CHECK(complaint_of([](Run& r) {
          std::swap(r.result.soup.triangles[5][0], r.result.soup.triangles[5][1]);
        }) == "topology");
  CHECK(complaint_of([](Run& r) {
          r.asked.topology = Topology::components_may_vanish;
          r.result.report.vanished_components = 1;
        }) == "topology");
  CHECK(complaint_of([](Run& r) { r.result.soup.points[5][0] += 1e-12; }) == "endpoints");
}

TEST_CASE("Each property of levels and files notices what it is there for") {
  const auto of_level = [](const std::function<void(Untouched&)>& change) {
    return complaint<Untouched>(change, test::properties_of_levels());
  };
  const auto of_file = [](const std::function<void(Untouched&)>& change) {
    return complaint<Untouched>(change, test::properties_of_files());
  };
  const auto dent = [](double depth) {
    return [=](Untouched& u) { u.result.soup.points[20] *= 1 - depth; };
  };
  CHECK(of_level([](Untouched& u) { // a needle
          const test::Triangle t = u.result.soup.triangles[0];
          u.result.soup.points[t[0]] =
              0.98 * u.result.soup.points[t[1]] + 0.02 * u.result.soup.points[t[0]];
        }) == "smallest angle");
  CHECK(of_level([&](Untouched& u) {
          u.asked.smallest_angle.reset();
          u.asked.longest_edge = 0.1;
          dent(0.5)(u);
        }) == "longest edge");
  CHECK(of_level([](Untouched& u) {
          u.asked.longest_edge.reset();
          u.asked.degree = 3;
          u.result.images.assign(u.result.images.size(), 1000);
        }) == "degree");
  CHECK(of_level(dent(0.02)) == "limits");
  CHECK(of_level([](Untouched& u) { u.result.report.distance_bound = 0.02; }) == "limits");
  CHECK(of_level([](Untouched& u) { u.result.report.hausdorff_bound = 0.02; }) == "limits");
  CHECK(of_file([](Untouched& u) {
          u.result.soup.triangles.pop_back();
          u.result.labels.pop_back();
        }) == "topology");
  CHECK(of_file([](Untouched& u) { u.result.labels.pop_back(); }) == "regions");
  CHECK(of_file([](Untouched& u) { u.result.labels[40] = 2; }) == "regions");
  CHECK(of_file([](Untouched& u) {
          for (std::int32_t& label : u.result.labels)
            label = 1;
        }) == "regions");
  CHECK(of_file([&](Untouched& u) {
          u.asked.distance.reset();
          u.asked.distance_both_ways.reset();
          dent(0.02)(u);
        }) == "tolerances");
}
