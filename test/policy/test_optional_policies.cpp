// A std::optional of a policy is the policy that it holds; one that holds nothing is not there.
#include "meshes.h"

#include <quadrille/distance_limits.h>
#include <quadrille/file.h>
#include <quadrille/levels.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplified.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <CGAL/Bbox_3.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace quadrille;

namespace {

const test::Soup surface = test::with_noise(test::sphere(3), 1, 0.05);

template <class... Policies>
std::pair<test::Soup, Report> simplified_by(const Policies&... policies) {
  std::pair<test::Soup, Report> result{surface, {}};
  result.second = simplify(result.first.points, result.first.triangles, policies...);
  return result;
}

bool are_same(const std::pair<test::Soup, Report>& a, const std::pair<test::Soup, Report>& b) {
  return a.first.points == b.first.points && a.first.triangles == b.first.triangles &&
         a.second.error == b.second.error && a.second.rejections == b.second.rejections;
}

// Beside other arguments, a policy is the same as a std::optional of it, an empty one the same as
// none, and these two differ.
template <class Policy, class... Others>
void check_optional(const Policy& policy, const Others&... others) {
  const auto with = simplified_by(policy, others...);
  const auto without = simplified_by(others...);
  CHECK_FALSE(are_same(with, without));
  CHECK(are_same(with, simplified_by(std::optional(policy), others...)));
  CHECK(are_same(without, simplified_by(std::optional<Policy>(), others...)));
}

struct RejectsAll {
  static constexpr Rejection cause = Rejection::shape;
  bool allows(const auto&) const { return false; }
};
struct Cancels : Visitor {
  bool proceed(const Status&) { return false; }
};
struct Listener {
  std::size_t contractions = 0, ends = 0;
  void begin(RecordedSurface) {}
  void record(const RecordedContraction&) { ++contractions; }
  void end() { ++ends; }
};

template <class Value>
auto map_of(std::vector<Value>& values) {
  return CGAL::make_property_map(values);
}

} // namespace

TEST_CASE("A std::optional of a policy is that policy, or as if it were not there") {
  const FaceCount count{100};
  check_optional(count);
  check_optional(DistanceLimit(0.05));
  check_optional([](const Status& status) { return status.contractions == 10; });
  check_optional(ThresholdPairs(0.5), count);
  check_optional(RelaxedOrder{}, count);
  check_optional(AnyOrder(RelaxedOrder{}), count);
  check_optional(RejectsAll{}, count);
  check_optional(NormalFlip(10), count); // and 90 degrees without one
  check_optional(Topology::free, FaceCount{2});
  CHECK(are_same(simplified_by(std::optional(GreedyOrder{}), count), simplified_by(count)));
}

TEST_CASE("What a std::optional holds has to make sense, and is validated") {
  CHECK_THROWS_AS(simplified_by(std::optional(FaceRatio{2})), std::invalid_argument);
  CHECK_THROWS_AS(simplified_by(std::optional(NormalFlip(-1))), std::invalid_argument);
  CHECK_THROWS_AS(simplified_by(std::optional(RelaxedOrder{.share = 0})), std::invalid_argument);
  CHECK_THROWS_AS(simplified_by(std::optional(ThresholdPairs(-1))), std::invalid_argument);
}

TEST_CASE("A recorder may be a std::optional") {
  Listener listener;
  std::optional<RecordInto<Listener>> into;
  simplified_by(FaceCount{100}, into);
  CHECK(listener.ends == 0);
  into = record_into(listener);
  const Report report = simplified_by(FaceCount{100}, into).second;
  CHECK(listener.ends == 1);
  CHECK(listener.contractions == report.contractions);
}

TEST_CASE("Labels may be a std::optional, and are written where they are given") {
  const auto labels_of = [](bool is_given) {
    test::Soup soup = surface;
    std::vector<int> labels(soup.triangles.size());
    for (std::size_t i = 0; i < labels.size(); ++i)
      labels[i] = soup.points[soup.triangles[i][0]][2] > 0;
    std::optional<Labels<decltype(map_of(labels))>> given;
    if (is_given)
      given = Labels{map_of(labels), 10.0};
    const Report report = simplify(soup.points, soup.triangles, FaceCount{100}, given);
    CHECK((report.rejected(Rejection::seam) > 0) == is_given);
    return std::pair(soup, labels);
  };
  const auto without = labels_of(false);
  CHECK(without.first.points == simplified_by(FaceCount{100}).first.points);

  test::Soup soup = surface;
  std::vector<int> labels(soup.triangles.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = soup.points[soup.triangles[i][0]][2] > 0;
  simplify(soup.points, soup.triangles, FaceCount{100}, Labels{map_of(labels), 10.0});
  const auto with = labels_of(true);
  CHECK(with.first.points == soup.points);
  CHECK(with.second == labels);
}

TEST_CASE("Maps, a box and a visitor of named parameters may be a std::optional") {
  namespace np = CGAL::parameters;
  const std::size_t points = surface.points.size();
  std::vector<int> is_chosen(points), is_selected(surface.triangles.size());
  std::vector<double> numbers(points, 0.05);
  for (std::size_t i = 0; i < points / 2; ++i)
    is_chosen[i] = 1, numbers[i] = 0.02;
  for (std::size_t i = 0; i < is_selected.size() / 2; ++i)
    is_selected[i] = 1;
  const auto check = [](const auto& make, const auto& map, const auto&... others) {
    using Map = std::remove_cvref_t<decltype(map)>;
    const auto with = simplified_by(make(map), others...);
    CHECK_FALSE(are_same(with, simplified_by(others...)));
    CHECK(are_same(with, simplified_by(make(std::optional(map)), others...)));
    CHECK(are_same(simplified_by(others...), simplified_by(make(std::optional<Map>()), others...)));
  };
  const FaceRatio half{0.5};
  check([](const auto& map) { return np::vertex_is_constrained_map(map); }, map_of(is_chosen),
        half);
  check([](const auto& map) { return parameters::face_is_selected_map(map); }, map_of(is_selected),
        half);
  check([](const auto& map) { return parameters::vertex_importance_map(map); }, map_of(numbers),
        half);
  check([](const auto& map) { return np::visitor(map); }, Cancels{}, half);
  // Tolerances go with their limit.
  const std::optional<decltype(map_of(numbers))> tolerances = map_of(numbers);
  CHECK(simplified_by(ToleranceLimit{}, parameters::vertex_tolerance_map(tolerances))
            .second.contractions > 0);
}

TEST_CASE("Maps over the edges of a mesh may be a std::optional, and follow into a copy") {
  test::Mesh mesh = test::make_mesh(surface);
  auto is_fixed = mesh.add_property_map<test::Mesh::Edge_index, bool>("e:fixed", true).first;
  std::optional<decltype(is_fixed)> map;
  const auto contractions = [&] {
    return simplified(mesh, CGAL::parameters::edge_is_constrained_map(map)).report.contractions;
  };
  CHECK(contractions() > 0);
  map = is_fixed;
  CHECK(contractions() == 0);
}

TEST_CASE("AnyOf and AllOf pass over what is not there") {
  const std::optional<FaceCount> faces, some = FaceCount{100};
  const std::optional<VertexCount> vertices = VertexCount{200};
  CHECK(simplified_by(AnyOf{faces, vertices}).second.vertices_after == 200);
  CHECK(simplified_by(AllOf{faces, vertices}).second.vertices_after == 200);
  CHECK(simplified_by(AnyOf{some, vertices}).second.vertices_after == 200);
  CHECK(simplified_by(AllOf{some, vertices}).second.faces_after == 100);
  CHECK(simplified_by(AnyOf{std::optional<DistanceLimit>(), FaceCount{100}}).second.faces_after ==
        100);
  CHECK_THROWS_WITH(simplified_by(AnyOf{faces, std::optional<DistanceLimit>()}),
                    "quadrille: all stop policies of an AnyOf or AllOf are empty");
  CHECK_THROWS_AS(simplified_by(AllOf{faces}), std::invalid_argument);
}

TEST_CASE("What an empty std::optional could need is not needed") {
  const auto needs = [](const auto& stop) {
    return internal::pick_policies<internal::NotGiven, internal::NotGiven>(stop).stop.needs();
  };
  CHECK(needs(std::optional<DistanceLimit>()) == Needs{});
  CHECK(needs(std::optional(DistanceLimit(1))) == Needs{.distance = true});
  CHECK(needs(AnyOf{std::optional<HausdorffLimit>(), CostLimit(1)}) == Needs{.cost = true});
  CHECK(needs(AnyOf{std::optional(HausdorffLimit(1)), FaceCount{1}}) ==
        Needs{.distance = true, .reverse_distance = true});
}
