// What a soup carries through the compiled library comes out as from the templates, bit for bit.
#include "soups.h"
#include "textured.h"

#include <boost/property_map/function_property_map.hpp>
#include <quadrille/channels.h>
#include <quadrille/compiled.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Kind = SoupChannelView::Kind;

template <std::size_t N>
using Values = std::vector<std::array<double, N>>;

// A soup with a texture and normals at corners; and with colours and four numbers of points.
struct Carrying {
  SoupPoints points;
  SoupTriangles triangles;
  std::vector<std::uint32_t> labels;
  Values<2> texture;
  SoupTriangles texture_triangles;
  Values<3> normals;
  SoupTriangles normal_triangles;
  Values<3> colors;
  Values<4> weights;

  friend bool operator==(const Carrying&, const Carrying&) = default;
};

Carrying carrying(const test::Textured& surface, std::uint64_t seed) {
  test::Random random(seed);
  Carrying result;
  result.triangles = surface.soup.triangles;
  for (const auto& p : surface.soup.points) {
    result.points.push_back(p.coordinates);
    const double x = random(0, 1);
    result.colors.push_back({x, 0.5, random(0, 1)});
    result.weights.push_back({x, 1 - x, 0, 0});
  }
  result.labels.assign(surface.labels.begin(), surface.labels.end());
  const auto texture = test::indexed(surface.texture);
  for (const auto& uv : texture.values)
    result.texture.push_back(uv.coordinates);
  result.texture_triangles = texture.triples;
  const auto normals =
      test::indexed(test::corner_values<3>(surface.soup, [&](std::size_t t, std::uint32_t v) {
        const double z = surface.labels[t] == 0 ? 0.6 : -0.6;
        return v % 2 == 0 ? test::Position{{0.8, 0, z}} : test::Position{{0, 0.8, z}};
      }));
  for (const auto& normal : normals.values)
    result.normals.push_back(normal.coordinates);
  result.normal_triangles = normals.triples;
  return result;
}

template <std::size_t N>
std::span<const double> numbers_of(const Values<N>& values) {
  return {values.empty() ? nullptr : values.front().data(), N * values.size()};
}
template <std::size_t N>
Values<N> values_of(const SoupChannel& channel) {
  REQUIRE(channel.components == N);
  Values<N> values(channel.values.size() / N);
  for (std::size_t i = 0; i < channel.values.size(); ++i)
    values[i / N][i % N] = channel.values[i];
  return values;
}

struct Channels {
  ChannelOptions texture = {}, normals = {}, colors = {.linear_light = true},
                 weights = {.importance = 0.5, .new_values = NewValues::weights};
};

SoupView view_of(const Carrying& soup, const Channels& options = {}) {
  SoupView view{soup.points, soup.triangles, soup.labels, {}};
  view.channels = {
      {Kind::texture, 2, numbers_of(soup.texture), soup.texture_triangles, options.texture},
      {Kind::normals, 3, numbers_of(soup.normals), soup.normal_triangles, options.normals},
      {Kind::colors, 3, numbers_of(soup.colors), {}, options.colors},
      {Kind::attributes, 4, numbers_of(soup.weights), {}, options.weights}};
  return view;
}

Carrying carrying(const SoupResult& result) {
  return {result.points,
          result.triangles,
          result.labels,
          values_of<2>(result.channels.at(0)),
          result.channels.at(0).triangles,
          values_of<3>(result.channels.at(1)),
          result.channels.at(1).triangles,
          values_of<3>(result.channels.at(2)),
          values_of<4>(result.channels.at(3))};
}

template <class... Policies>
Report simplify_by_templates(Carrying& soup, const Channels& options, const Policies&... policies) {
  const Report report =
      simplify(soup.points, soup.triangles, Labels{CGAL::make_property_map(soup.labels)},
               Texture{soup.texture, soup.texture_triangles, options.texture},
               Normals{soup.normals, soup.normal_triangles, options.normals},
               Colors{CGAL::make_property_map(soup.colors), options.colors},
               Attributes{CGAL::make_property_map(soup.weights), options.weights}, policies...);
  soup.labels.resize(soup.triangles.size());
  soup.colors.resize(soup.points.size());
  soup.weights.resize(soup.points.size());
  return report;
}

template <class... Policies>
void check(const Carrying& soup, const Channels& channels, const SoupOptions& options,
           const Policies&... policies) {
  Carrying expected = soup;
  const Report of_templates = simplify_by_templates(expected, channels, policies...);
  const SoupResult result = simplified_soup(view_of(soup, channels), options);
  const bool is_same = carrying(result) == expected;
  CHECK(is_same);
  CHECK(result.report.contractions == of_templates.contractions);
  CHECK(result.report.contractions > 10);
  CHECK(result.report.stop == of_templates.stop);
  REQUIRE(result.input_faces.size() == result.triangles.size());
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    REQUIRE(result.labels[i] == soup.labels.at(result.input_faces[i]));
}

SoupOptions options_of(SoupOptions::Cost cost) {
  SoupOptions options;
  options.faces = 60;
  options.cost = cost;
  return options;
}

const test::Soup surface = test::random_with_boundaries(3); // with vertices of several fans
const Carrying in_charts = carrying(test::random_charts(surface, 5), 1);
const Carrying torn = carrying(test::random_corners(surface, 6), 2);

} // namespace

TEST_CASE("Each cost of the compiled library takes labels and channels along") {
  using Cost = SoupOptions::Cost;
  const FaceCount stop{60};
  for (const Carrying* soup : {&in_charts, &torn}) {
    check(*soup, {}, options_of(Cost::quadric), stop);
    check(*soup, {}, options_of(Cost::memoryless_quadric), MemorylessQuadric{}, stop);
  }
  check(in_charts, {}, options_of(Cost::thin_feature_quadric), ThinFeatureQuadric{}, stop);
  check(in_charts, {}, options_of(Cost::edge_length), EdgeLength{}, MidpointPlacement{}, stop);
}

TEST_CASE("Options of channels are those of the templates") {
  const Channels channels{{.importance = 3, .weights = {2, 0.5}, .chart_boundary_weight = 1},
                          {.seams = Seams::free, .new_values = NewValues::recomputed},
                          {.new_values = NewValues::existing},
                          {.seams = Seams::kept}};
  check(in_charts, channels, options_of(SoupOptions::Cost::quadric), FaceCount{60});
  const Channels others{{.seams = Seams::priced}, {.new_values = NewValues::existing}, {}, {}};
  check(torn, others, options_of(SoupOptions::Cost::quadric), FaceCount{60});
}

TEST_CASE("Passes, greedy order, creases and weights of borders are options") {
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.order = SoupOptions::Order::relaxed;
  options.share = 0.3;
  options.refresh = true;
  check(in_charts, {}, options, FaceCount{60}, RelaxedOrder{.share = 0.3, .refresh = true});
  options = options_of(SoupOptions::Cost::memoryless_quadric);
  check(in_charts, {}, options, FaceCount{60}, MemorylessQuadric{}, GreedyOrder{});
  options = options_of(SoupOptions::Cost::quadric);
  options.crease_degrees = 20;
  options.crease_weight = 7;
  check(in_charts, {}, options, FaceCount{60}, Quadric{.crease_weight = 7, .crease_degrees = 20});
}

TEST_CASE("Triangles are selected by an option") {
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  for (std::size_t f = 0; f < in_charts.triangles.size(); ++f)
    options.selected.push_back(f > in_charts.triangles.size() / 3);
  const std::vector<bool>& is_selected = options.selected;
  const auto map = boost::make_function_property_map<std::size_t>(
      [&](std::size_t f) -> bool { return is_selected[f]; });
  check(in_charts, {}, options, FaceCount{60}, parameters::face_is_selected_map(map));
  options.selected.pop_back();
  CHECK_THROWS_AS(simplified_soup(view_of(in_charts), options), std::invalid_argument);
}

TEST_CASE("The weight of borders between labels is an option") {
  Carrying expected = in_charts;
  simplify(expected.points, expected.triangles, FaceCount{60},
           Labels{CGAL::make_property_map(expected.labels), 30});
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.region_boundary_weight = 30;
  const SoupResult result =
      simplified_soup({in_charts.points, in_charts.triangles, in_charts.labels, {}}, options);
  CHECK(result.points == expected.points);
  CHECK(result.triangles == expected.triangles);
  CHECK(result.channels.empty());
}

TEST_CASE("Levels that the compiled library records are those of the templates") {
  for (const double error : {0.0, 0.2}) {
    Levels of_templates, levels;
    Carrying expected = in_charts;
    SoupOptions options = options_of(SoupOptions::Cost::quadric);
    options.recorder = record_into(levels);
    if (error > 0) {
      options.error = error;
      simplify_by_templates(expected, {}, AnyOf{FaceCount{60}, DistanceLimit{error}},
                            record_into(of_templates));
    } else {
      simplify_by_templates(expected, {}, FaceCount{60}, record_into(of_templates));
    }
    const SoupResult result = simplified_soup(view_of(in_charts), options);
    const bool is_same = carrying(result) == expected;
    CHECK(is_same);
    REQUIRE(levels.coarsest().contractions == result.report.contractions);
    for (std::size_t n : {std::size_t{0}, std::size_t{20}, result.report.contractions}) {
      const Level level = levels.at(AfterContractions{n});
      const Level other = of_templates.at(AfterContractions{n});
      CHECK(level.points == other.points);
      CHECK(level.triangles == other.triangles);
      CHECK(level.error == other.error);
      CHECK(level.distance_bound == other.distance_bound);
      REQUIRE(level.channels.size() == 4);
      for (std::size_t c = 0; c < 4; ++c) {
        CHECK(level.channels[c].values == other.channels[c].values);
        CHECK(level.channels[c].triangles == other.channels[c].triangles);
      }
    }
  }
}

TEST_CASE("Of a soup without triangles nothing is left") {
  const std::vector<double> texture = {0, 0, 1, 0, 0, 1, 1, 1};
  SoupView soup{in_charts.points, {}, {}, {{.values = texture}}};
  soup.channels.push_back(
      {.kind = Kind::colors, .components = 3, .values = numbers_of(in_charts.colors)});
  const SoupResult result = simplified_soup(soup);
  CHECK(result.points.empty());
  REQUIRE(result.channels.size() == 2);
  for (const SoupChannel& channel : result.channels) {
    CHECK(channel.values.empty());
    CHECK(channel.triangles.empty());
  }
  CHECK(result.channels[1].components == 3);
  CHECK(result.vertex_map.size() == in_charts.points.size());
}

TEST_CASE("Parts of a soup with labels may vanish in the compiled library, recorded or not") {
  SoupPoints points = in_charts.points;
  SoupTriangles triangles = in_charts.triangles;
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const auto& [x, y, z] : {std::array{0., 0., 9.}, {0.01, 0., 9.}, {0., 0.01, 9.}})
    points.push_back({x, y, z});
  triangles.push_back({first, first + 1, first + 2});
  std::vector<std::uint32_t> labels = in_charts.labels;
  labels.push_back(labels.back());
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.topology = Topology::components_may_vanish;
  const SoupResult without = simplified_soup({points, triangles, labels, {}}, options);
  Levels levels;
  options.recorder = record_into(levels);
  const SoupResult with = simplified_soup({points, triangles, labels, {}}, options);
  CHECK(without.report.vanished_components == 1);
  CHECK(with.points == without.points);
  CHECK(levels.coarsest().faces == without.triangles.size());
}

TEST_CASE("A recorder of the user's own is told all by the compiled library") {
  struct Counter {
    std::size_t faces = 0, contractions = 0, ends = 0;
    StopReason reason = StopReason::cancelled;
    void begin(const RecordedSurface& recorded) { faces = recorded.triangles.size(); }
    void record(const RecordedContraction&) { ++contractions; }
    void stop(StopReason why) { reason = why; }
    void end() { ++ends; }
  } counter;
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.recorder = record_into(counter);
  const SoupResult result = simplified_soup({in_charts.points, in_charts.triangles}, options);
  CHECK(counter.faces == in_charts.triangles.size());
  CHECK(counter.contractions == result.report.contractions);
  CHECK(counter.reason == result.report.stop);
  CHECK(counter.ends == 1);
}

TEST_CASE("A soup that carries nothing has levels, and is the same with them and without") {
  SoupTriangles triangles = in_charts.triangles;
  for (std::size_t face = 0; face < triangles.size(); face += 7)
    std::swap(triangles[face][0], triangles[face][1]); // no seams where orientations differ
  const SoupView soup{in_charts.points, triangles};
  using Cost = SoupOptions::Cost;
  for (const Cost cost : {Cost::quadric, Cost::memoryless_quadric, Cost::edge_length}) {
    SoupOptions options = options_of(cost);
    const SoupResult without = simplified_soup(soup, options);
    Levels levels;
    options.recorder = record_into(levels);
    const SoupResult with = simplified_soup(soup, options);
    CHECK(with.points == without.points);
    CHECK(with.triangles == without.triangles);
    CHECK(with.vertex_map == without.vertex_map);
    const Level level = in_input_order(levels.at(FaceCount{60}));
    CHECK(level.points == with.points);
  }
}

TEST_CASE("Points that are split at seams are one vertex in the compiled library, too") {
  const test::Textured textured = test::textured_cube(6);
  const auto split = test::split(textured.soup, textured.texture);
  SoupPoints points;
  Values<2> uv;
  for (const auto& p : split.soup.points)
    points.push_back(p.coordinates);
  for (const auto& value : std::get<0>(split.values))
    uv.push_back(value.coordinates);
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.split_vertices = true;
  const SoupView view{points, split.soup.triangles, {}, {{.values = numbers_of(uv)}}};
  const SoupResult result = simplified_soup(view, options);
  SoupPoints left = points;
  SoupTriangles triangles = split.soup.triangles;
  simplify(left, triangles, FaceCount{60}, SplitVertices{}, Texture{CGAL::make_property_map(uv)});
  uv.resize(left.size());
  CHECK(result.points == left);
  CHECK(result.triangles == triangles);
  CHECK(values_of<2>(result.channels.at(0)) == uv);
  CHECK(result.vertex_map.empty());
  CHECK(result.report.contractions > 10);
}

TEST_CASE("A soup that is cancelled at once comes back whole") {
  SoupOptions options = options_of(SoupOptions::Cost::quadric);
  options.proceed = [](const Status&) { return false; };
  const SoupResult result = simplified_soup(view_of(torn), options);
  CHECK(result.report.stop == StopReason::cancelled);
  const bool is_same = carrying(result) == torn;
  CHECK(is_same);
  REQUIRE(result.input_faces.size() == torn.triangles.size());
  CHECK(result.input_faces.back() == torn.triangles.size() - 1);
  CHECK(result.vertex_map.back() == torn.points.size() - 1);
}

TEST_CASE("What is wrong with a soup is told by its name") {
  const auto refused = [](const SoupView& view, const SoupOptions& options, const char* what) {
    CHECK_THROWS_WITH(simplified_soup(view, options), Catch::Contains(what));
    CHECK_THROWS_AS(simplified_soup(view, options), std::invalid_argument);
  };
  const SoupOptions options = options_of(SoupOptions::Cost::quadric);
  const auto channel_is_rejected = [&](std::size_t c, auto change, const char* what) {
    SoupView view = view_of(torn);
    change(view.channels[c]);
    refused(view, options, what);
  };
  channel_is_rejected(
      0, [](auto& c) { c.components = 3; },
      "channel 0 has 3 components, which its kind does not allow");
  channel_is_rejected(
      3, [](auto& c) { c.components = 0; }, "channel 3 has 0 components");
  channel_is_rejected(
      2, [](auto& c) { c.values = c.values.first(4); }, "channel 2 has 4 numbers");
  channel_is_rejected(
      2, [](auto& c) { c.values = c.values.first(3); }, "channel 2 has 1 values for");
  channel_is_rejected(
      1, [](auto& c) { c.triangles = c.triangles.first(2); }, "channel 1 has index triples for 2");
  channel_is_rejected(
      1, [](auto& c) { c.values = c.values.first(3); }, "names value 1 of 1 of a channel");
  channel_is_rejected(
      0, [](auto& c) { c.options.weights = {1}; }, "channel 0 has 2 components and 1 weights");
  channel_is_rejected(
      0, [](auto& c) { c.options.new_values = NewValues::existing; }, "would tear");
  channel_is_rejected(
      0, [](auto& c) { c.options.new_values = NewValues::recomputed; }, "does not contain normals");
  channel_is_rejected(
      0, [](auto& c) { c.options.new_values = NewValues::weights; }, "does not contain attributes");
  channel_is_rejected(
      0, [](auto& c) { c.options.linear_light = true; }, "does not contain colours");
  channel_is_rejected(
      0, [](auto& c) { c.options.importance = 0; }, "importance");
  Carrying infinite = torn;
  infinite.colors[7][1] = std::numeric_limits<double>::infinity();
  refused(view_of(infinite), options, "value 7 of a channel is not finite");

  SoupView view = view_of(torn);
  view.labels = view.labels.first(4);
  refused(view, options, "labels has 4 values for");
  SoupOptions wrong = options;
  wrong.threads = 2;
  refused(view_of(torn), wrong, "relaxed order");
  wrong = options_of(SoupOptions::Cost::memoryless_quadric);
  wrong.crease_degrees = 20;
  refused(view_of(torn), wrong, "crease_degrees needs the cost quadric");
}
