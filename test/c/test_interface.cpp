// The interface of C: equal to the bit with the call of C++, and every error is a code and a text.
#include <quadrille/compiled.h>
#include <quadrille/compiled/option_setting.h>
#include <quadrille/level_maps.h>
#include <quadrille/level_splits.h>
#include <quadrille/levels.h>
#include <quadrille/quadrille.h>

#include <hard_surfaces.h>
#include <random_surfaces.h>
#include <soups.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

namespace {

using namespace quadrille;

struct Delete {
  void operator()(quadrille_call* call) const { quadrille_call_delete(call); }
  void operator()(quadrille_levels* levels) const { quadrille_levels_delete(levels); }
  void operator()(quadrille_level* level) const { quadrille_level_delete(level); }
  void operator()(quadrille_splits* splits) const { quadrille_splits_delete(splits); }
};
using Call = std::unique_ptr<quadrille_call, Delete>;
using LevelsHandle = std::unique_ptr<quadrille_levels, Delete>;
using LevelHandle = std::unique_ptr<quadrille_level, Delete>;

SoupPoints coordinates_of(const test::Soup& soup) {
  SoupPoints points;
  for (const test::Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

template <class T>
quadrille_array array_of(const std::vector<T>& numbers, std::size_t columns, std::int32_t type) {
  return {numbers.data(), numbers.size() / columns, columns, 0, type};
}
template <std::size_t n, class T>
quadrille_array array_of(const std::vector<std::array<T, n>>& rows, std::int32_t type) {
  return {rows.data(), rows.size(), n, 0, type};
}

/// A call of a surface, which has to live as long.
Call call_of(const SoupPoints& points, const SoupTriangles& triangles) {
  Call call(quadrille_call_new());
  const quadrille_array p = array_of(points, QUADRILLE_FLOAT64);
  const quadrille_array t = array_of(triangles, QUADRILLE_UINT32);
  REQUIRE(quadrille_set_array(call.get(), "points", &p) == QUADRILLE_OK);
  REQUIRE(quadrille_set_array(call.get(), "triangles", &t) == QUADRILLE_OK);
  return call;
}

template <class T>
std::vector<T> result_of(const Call& call, const char* name, std::size_t channel = 0) {
  quadrille_array view;
  REQUIRE(quadrille_result(call.get(), name, channel, &view) == QUADRILLE_OK);
  const auto* begin = static_cast<const T*>(view.data);
  return {begin, begin + view.rows * view.columns};
}

template <std::size_t n, class T>
std::vector<T> flat(const std::vector<std::array<T, n>>& rows) {
  std::vector<T> numbers;
  for (const auto& row : rows)
    numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

void run(const Call& call) {
  INFO(quadrille_error(call.get()));
  REQUIRE(quadrille_simplify(call.get()) == QUADRILLE_OK);
}

void require_equal(const Call& call, const SoupResult& expected) {
  CHECK(result_of<double>(call, "points") == flat(expected.points));
  CHECK(result_of<std::uint32_t>(call, "triangles") == flat(expected.triangles));
  CHECK(result_of<std::uint32_t>(call, "input_faces") == expected.input_faces);
  const auto vertex_map = result_of<std::int64_t>(call, "vertex_map");
  CHECK(std::vector<std::size_t>(vertex_map.begin(), vertex_map.end()) == expected.vertex_map);
}

} // namespace

TEST_CASE("A call of C has the bits of the call of C++, whatever the types of its arrays") {
  for (const auto& kind : test::surface_kinds()) {
    CAPTURE(kind.name);
    test::Random random(3);
    const test::Soup soup = kind.make(3, random);
    const SoupPoints points = coordinates_of(soup);
    const SoupResult expected = simplified_soup({points, soup.triangles}, {.ratio = 0.3});
    Call call = call_of(points, soup.triangles);
    REQUIRE(quadrille_set_double(call.get(), "ratio", 0.3) == QUADRILLE_OK);
    run(call);
    require_equal(call, expected);
    // The same in rows with gaps, and with indices of 64 bits.
    std::vector<std::array<double, 5>> wide;
    for (const auto& [x, y, z] : points)
      wide.push_back({x, y, z, NAN, NAN});
    std::vector<std::array<std::int64_t, 3>> indices;
    for (const auto& [a, b, c] : soup.triangles)
      indices.push_back({a, b, c});
    const quadrille_array p{wide.data(), wide.size(), 3, sizeof(wide[0]), QUADRILLE_FLOAT64};
    const quadrille_array t = array_of(indices, QUADRILLE_INT64);
    REQUIRE(quadrille_set_array(call.get(), "points", &p) == QUADRILLE_OK);
    REQUIRE(quadrille_set_array(call.get(), "triangles", &t) == QUADRILLE_OK);
    run(call);
    require_equal(call, expected);
  }
}

TEST_CASE("Options, channels and labels of C are those of C++") {
  const test::Soup soup = test::torus(12, 20);
  const SoupPoints points = coordinates_of(soup);
  std::vector<double> uv;
  std::vector<float> uv_floats;
  std::vector<std::uint32_t> labels;
  for (const auto& p : points)
    for (const double x : {p[0], p[1]}) {
      uv_floats.push_back(static_cast<float>(x));
      uv.push_back(uv_floats.back());
    }
  for (const auto& t : soup.triangles)
    labels.push_back(points[t[0]][0] > 0 ? 7 : 0);
  SoupView view{points, soup.triangles, labels, {}};
  view.channels.push_back({.values = uv});
  view.channels.back().options.importance = 2;
  view.channels.back().options.seams = Seams::free;
  SoupOptions options;
  options.faces = 150;
  options.cost = SoupOptions::Cost::memoryless_quadric;
  options.placement = SoupOptions::Placement::endpoint;
  options.boundary_weight = 3;
  options.fixed.assign(points.size(), false);
  options.fixed[5] = true;
  const SoupResult expected = simplified_soup(view, options);

  Call call = call_of(points, soup.triangles);
  std::vector<std::uint8_t> fixed(points.size(), 0);
  fixed[5] = 1;
  const quadrille_array values = array_of(uv_floats, 2, QUADRILLE_FLOAT32);
  const quadrille_array flags = array_of(fixed, 1, QUADRILLE_UINT8);
  const quadrille_array numbers = array_of(labels, 1, QUADRILLE_UINT32);
  REQUIRE(quadrille_add_channel(call.get(), "texture", &values, nullptr) == QUADRILLE_OK);
  REQUIRE(quadrille_set_channel_double(call.get(), 0, "importance", 2) == QUADRILLE_OK);
  REQUIRE(quadrille_set_channel_text(call.get(), 0, "seams", "free") == QUADRILLE_OK);
  REQUIRE(quadrille_set_array(call.get(), "labels", &numbers) == QUADRILLE_OK);
  REQUIRE(quadrille_set_array(call.get(), "fixed", &flags) == QUADRILLE_OK);
  REQUIRE(quadrille_set_int(call.get(), "faces", 150) == QUADRILLE_OK);
  REQUIRE(quadrille_set_text(call.get(), "cost", "memoryless_quadric") == QUADRILLE_OK);
  REQUIRE(quadrille_set_text(call.get(), "placement", "endpoint") == QUADRILLE_OK);
  REQUIRE(quadrille_set_double(call.get(), "boundary_weight", 3) == QUADRILLE_OK);
  run(call);
  require_equal(call, expected);
  CHECK(result_of<std::uint32_t>(call, "labels") == expected.labels);
  CHECK(result_of<double>(call, "values") == expected.channels[0].values);
  CHECK(result_of<std::uint32_t>(call, "corners") == flat(expected.channels[0].triangles));
}

TEST_CASE("Errors of C name the option, its range and the value, and leave a call usable") {
  const test::Soup soup = test::torus(8, 8);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  const auto error = [&](std::int32_t code) {
    CHECK(code == QUADRILLE_INVALID);
    return std::string(quadrille_error(call.get()));
  };
  quadrille_call* const c = call.get();
  CHECK(error(quadrille_set_double(c, "ratio", 1.5)) == "ratio is 1.5, not in [0, 1]");
  CHECK(error(quadrille_set_double(c, "normal_flip", 0)) == "normal_flip is 0, not in (0, 180]");
  CHECK(error(quadrille_set_double(c, "error", NAN)) == "error is nan, not in [0, inf)");
  CHECK(error(quadrille_set_double(c, "error", INFINITY)) == "error is inf, not in [0, inf)");
  CHECK(error(quadrille_set_int(c, "faces", -1)) == "faces is -1, not in [0, 4294967295]");
  CHECK(error(quadrille_set_double(c, "faces", 1.5)) == "faces is 1.5, not an integer");
  CHECK(error(quadrille_set_double(c, "both_ways", 2)) == "both_ways is 2, not true or false");
  CHECK(error(quadrille_set_double(c, "cost", 1)) == "cost is a number, not a word");
  CHECK(error(quadrille_set_text(c, "faces", "many")) == "faces is a word, not an integer");
  CHECK(error(quadrille_set_text(c, "cost", "cheap")) ==
        "cost is \"cheap\", not one of quadric, memoryless_quadric, thin_feature_quadric, "
        "edge_length");
  CHECK(error(quadrille_set_double(c, "fases", 1)) == "there is no option fases");
  const std::vector<double> bad{1, -2};
  const quadrille_array numbers = array_of(bad, 1, QUADRILLE_FLOAT64);
  CHECK(error(quadrille_set_array(c, "importance", &numbers)) ==
        "importance[1] is -2, not in [0, inf)");
  CHECK(error(quadrille_set_array(c, "points", &numbers)) == "points has 1 columns, not 3");
  const quadrille_array unknown{bad.data(), 2, 1, 0, 99};
  CHECK(error(quadrille_set_array(c, "importance", &unknown)) ==
        "an array has the type 99, which is not a quadrille_type");
  const std::vector<std::array<std::int64_t, 3>> negative{{0, 1, 2}, {0, -1, 2}};
  const quadrille_array triangles = array_of(negative, QUADRILLE_INT64);
  REQUIRE(quadrille_set_array(c, "triangles", &triangles) == QUADRILLE_OK);
  CHECK(error(quadrille_simplify(c)) ==
        "triangles[1] has the number -1, which is not in [0, 4294967295]");
  CHECK(quadrille_set_channel_double(c, 3, "importance", 1) == QUADRILLE_OUT_OF_RANGE);
  const quadrille_array right = array_of(soup.triangles, QUADRILLE_UINT32);
  REQUIRE(quadrille_set_array(c, "triangles", &right) == QUADRILLE_OK);
  REQUIRE(quadrille_set_text(c, "hull", "outer") == QUADRILLE_OK);
  REQUIRE(quadrille_set_int(c, "keep_volume", 1) == QUADRILLE_OK);
  CHECK(error(quadrille_simplify(c)) == "hull does not go with keep_volume");
  REQUIRE(quadrille_set_int(c, "keep_volume", 0) == QUADRILLE_OK);
  run(call);
  CHECK(result_of<std::uint32_t>(call, "triangles").size() == 3 * soup.triangles.size() / 2);
}

namespace {

struct Asked {
  std::atomic<int> times = 0;
  std::int32_t answer = 0;
};

std::int32_t stop_at_100(void* data, const quadrille_status* status) {
  ++static_cast<Asked*>(data)->times;
  return status->faces <= 100 ? 1 : 0;
}
std::int32_t allow_few(void* data, const quadrille_contraction* contraction) {
  ++static_cast<Asked*>(data)->times;
  for (std::size_t i = 0; i < contraction->face_count; ++i)
    if (std::memcmp(contraction->faces[i].after, contraction->target, 3 * sizeof(double)) != 0)
      return -1;
  return contraction->highest_degree < 8 ? 1 : 0;
}
double cost_of_pair(void* data, const quadrille_pair* pair) {
  ++static_cast<Asked*>(data)->times;
  return pair->quadric;
}
std::int32_t answer(void* data, const quadrille_status*) {
  auto* const asked = static_cast<Asked*>(data);
  ++asked->times;
  return asked->answer;
}
double negative_cost(void*, const quadrille_pair*) {
  return -1;
}

} // namespace

TEST_CASE("Functions of the caller are policies of a call of C") {
  const test::Soup soup = test::torus(16, 16);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  Asked asked;
  SECTION("stop") {
    quadrille_set_stop(call.get(), stop_at_100, &asked);
    run(call);
    require_equal(call, simplified_soup({points, soup.triangles}, {.faces = 100}));
    CHECK(asked.times > 200);
  }
  SECTION("filter") {
    quadrille_set_filter(call.get(), allow_few, &asked);
    run(call);
    SoupOptions options;
    options.allows = [](const SoupContraction& c) { return c.highest_degree < 8; };
    require_equal(call, simplified_soup({points, soup.triangles}, options));
  }
  SECTION("cost") {
    quadrille_set_cost(call.get(), cost_of_pair, &asked);
    run(call);
    CHECK(asked.times > 500);
    CHECK(result_of<std::uint32_t>(call, "triangles").size() == 3 * 256);
  }
  SECTION("progress ends a call with what it has") {
    quadrille_set_progress(call.get(), answer, &asked);
    run(call);
    CHECK(asked.times > 0);
    CHECK(std::string(quadrille_report(call.get())).find("\"stop\": \"cancelled\"") !=
          std::string::npos);
  }
  SECTION("what fails ends a call without a result") {
    asked.answer = -1;
    quadrille_set_stop(call.get(), answer, &asked);
    CHECK(quadrille_simplify(call.get()) == QUADRILLE_FUNCTION_FAILED);
    CHECK(asked.times == 1);
    CHECK(std::string(quadrille_error(call.get())) == "the function stop has failed");
    CHECK(result_of<double>(call, "points").empty());
    quadrille_set_stop(call.get(), nullptr, nullptr);
    quadrille_set_cost(call.get(), negative_cost, nullptr);
    CHECK(quadrille_simplify(call.get()) == QUADRILLE_FUNCTION_FAILED);
  }
}

TEST_CASE("Levels of C are those of a recorder of C++") {
  const test::Soup soup = test::torus(16, 16);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  const LevelsHandle levels(quadrille_levels_new());
  std::array<char, 200> error{};
  quadrille_level_info info;
  CHECK(quadrille_levels_empty(levels.get()) == 1);
  CHECK(quadrille_levels_info(levels.get(), "faces", 9, &info, error.data(), error.size()) ==
        QUADRILLE_INVALID);
  CHECK(std::string(error.data()).find("nothing has been recorded") != std::string::npos);
  quadrille_set_levels(call.get(), levels.get());
  REQUIRE(quadrille_set_int(call.get(), "faces", 50) == QUADRILLE_OK);
  run(call);
  quadrille_level* made = nullptr;
  REQUIRE(quadrille_levels_at(levels.get(), "faces", 200, &made, nullptr, 0) == QUADRILLE_OK);
  const LevelHandle level(made);
  const SoupResult expected = simplified_soup({points, soup.triangles}, {.faces = 200});
  quadrille_array view;
  REQUIRE(quadrille_level_array(level.get(), "points", 0, &view) == QUADRILLE_OK);
  CHECK(std::memcmp(view.data, expected.points.data(), view.rows * 24) == 0);
  REQUIRE(quadrille_level_array(level.get(), "triangles", 0, &view) == QUADRILLE_OK);
  CHECK(view.rows == 200);
  CHECK(std::memcmp(view.data, expected.triangles.data(), view.rows * 12) == 0);
  CHECK(quadrille_level_array(level.get(), "values", 0, &view) == QUADRILLE_INVALID);
  REQUIRE(quadrille_levels_info(levels.get(), "coarsest", 0, &info, nullptr, 0) == QUADRILLE_OK);
  CHECK(info.faces == 50);
  REQUIRE(quadrille_levels_info(levels.get(), "finest", 0, &info, nullptr, 0) == QUADRILLE_OK);
  CHECK(info.faces == 512);
}

TEST_CASE("Results of C are copied as other types, and a report is JSON and numbers") {
  const test::Soup soup = test::torus(8, 8);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  run(call);
  const auto expected = result_of<double>(call, "points");
  std::vector<float> floats(expected.size() / 3 * 4, -1);
  REQUIRE(quadrille_copy_result(call.get(), "points", 0, floats.data(), QUADRILLE_FLOAT32, 16) ==
          QUADRILLE_OK);
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(floats[i / 3 * 4 + i % 3] == static_cast<float>(expected[i]));
  CHECK(floats[3] == -1);
  double number = 0;
  REQUIRE(quadrille_report_number(call.get(), "faces_after", &number) == QUADRILLE_OK);
  CHECK(number == 64);
  REQUIRE(quadrille_report_number(call.get(), "normal_bound_degrees", &number) == QUADRILLE_OK);
  CHECK(std::isinf(number));
  CHECK(quadrille_report_number(call.get(), "faces", &number) == QUADRILLE_INVALID);
  CHECK(std::string(quadrille_report(call.get())).starts_with("{\"faces_before\": 128, "));
  CHECK(std::string(quadrille_report_text(call.get())).starts_with("128 -> 64 faces"));
}

namespace {

template <class Field>
std::string text_of_default(const Field& field, [[maybe_unused]] const char* option,
                            [[maybe_unused]] std::span<const internal::OptionWord> words) {
  if constexpr (requires { field.has_value(); })
    return field ? text_of_default(*field, option, words) : "";
  else if constexpr (requires { field.empty(); })
    return field.empty() ? "" : "?";
  else if constexpr (std::is_same_v<Field, bool>)
    return field ? "true" : "false";
  else if constexpr (std::is_enum_v<Field>) {
    for (const internal::OptionWord& word : words)
      if (std::string_view(word.option) == option && word.value == static_cast<int>(field))
        return word.word;
    return "?";
  } else {
    return internal::text_of(static_cast<double>(field));
  }
}

} // namespace

TEST_CASE("The defaults of the table of options are those of the structures") {
  const auto check = [](auto options, std::int32_t of_channels) {
    const std::size_t count = quadrille_option_count(of_channels);
    CHECK(quadrille_option_at(of_channels, count) == nullptr);
    for (std::size_t i = 0; i < count; ++i) {
      const quadrille_option& row = *quadrille_option_at(of_channels, i);
      CAPTURE(row.name);
      CHECK(internal::with_option(options, row.name, [&](const auto&, const auto& field) {
        const auto words = internal::words_of<decltype(options)>();
        CHECK(text_of_default(field, row.name, words) == row.fallback);
      }));
      CHECK(std::strlen(row.sentence) > 0);
      CHECK((quadrille_word_at(of_channels, row.name, 0) != nullptr) ==
            (std::string_view(row.kind) == "word"));
    }
  };
  check(internal::SoupJob{}, 0);
  check(ChannelOptions{}, 1);
}

TEST_CASE("A call of C is cancelled from another thread") {
  const test::Soup soup = test::torus(8, 8);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  quadrille_set_stop(
      call.get(),
      [](void* data, const quadrille_status*) {
        std::thread([data] { quadrille_cancel(static_cast<quadrille_call*>(data)); }).join();
        return 0;
      },
      call.get());
  run(call);
  CHECK(std::string(quadrille_report(call.get())).find("cancelled") != std::string::npos);
}

namespace {

void require_equal(const Call& call, const std::string& name, const SparseRows& expected) {
  CHECK(result_of<std::int64_t>(call, (name + "_begins").c_str()) == expected.begins);
  CHECK(result_of<std::int64_t>(call, (name + "_indices").c_str()) == expected.indices);
  CHECK(result_of<double>(call, (name + "_weights").c_str()) == expected.weights);
}

template <class T>
std::vector<T> array_of_splits(const std::unique_ptr<quadrille_splits, Delete>& splits,
                               const char* name) {
  quadrille_array view;
  REQUIRE(quadrille_splits_array(splits.get(), name, &view) == QUADRILLE_OK);
  const auto* begin = static_cast<const T*>(view.data);
  return {begin, begin + view.rows * view.columns};
}

} // namespace

TEST_CASE("A call of C gives the sparse maps of its levels") {
  const test::Soup soup = test::with_noise(test::sphere(3), 3, 0.01);
  const SoupPoints points = coordinates_of(soup);
  Levels levels;
  simplified_soup({points, soup.triangles}, {.faces = 60, .recorder = record_into(levels)});
  const LevelsHandle own(quadrille_levels_new());
  for (const bool has_levels : {false, true}) {
    Call call = call_of(points, soup.triangles);
    REQUIRE(quadrille_set_int(call.get(), "faces", 60) == QUADRILLE_OK);
    run(call);
    CHECK(result_of<double>(call, "old_to_new_weights").empty()); // none without the option
    REQUIRE(quadrille_set_int(call.get(), "maps", 1) == QUADRILLE_OK);
    quadrille_set_levels(call.get(), has_levels ? own.get() : nullptr);
    run(call);
    require_equal(call, "old_to_new", old_to_new(levels, levels.coarsest()));
    require_equal(call, "new_to_old", new_to_old(levels, levels.coarsest()));
    quadrille_array view;
    CHECK(quadrille_result(call.get(), "old_to_new_width", 0, &view) == QUADRILLE_INVALID);
  }
  CHECK(quadrille_levels_empty(own.get()) == 0);
}

TEST_CASE("A calibrated call of C goes as far as measuring allows") {
  const test::Soup soup = test::with_noise(test::sphere(3), 3, 0.002);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  for (const char* option : {"both_ways", "calibrated"})
    REQUIRE(quadrille_set_int(call.get(), option, 1) == QUADRILLE_OK);
  CHECK(quadrille_simplify(call.get()) == QUADRILLE_INVALID);
  CHECK(std::string(quadrille_error(call.get())) ==
        "calibrated needs either error or relative_error, and both_ways");
  REQUIRE(quadrille_set_double(call.get(), "error", 0.05) == QUADRILLE_OK);
  run(call);
  const SoupResult by_sum =
      simplified_soup({points, soup.triangles}, {.error = 0.05, .both_ways = true});
  CHECK(4 * result_of<std::uint32_t>(call, "triangles").size() < 3 * 3 * by_sum.triangles.size());
  double bound = 0;
  REQUIRE(quadrille_report_number(call.get(), "hausdorff_bound", &bound) == QUADRILLE_OK);
  CHECK(bound <= 0.05);
  REQUIRE(quadrille_set_int(call.get(), "maps", 1) == QUADRILLE_OK);
  CHECK(quadrille_simplify(call.get()) == QUADRILLE_INVALID);
  REQUIRE(quadrille_set_int(call.get(), "maps", 0) == QUADRILLE_OK);
  REQUIRE(quadrille_set_text(call.get(), "hull", "outer") == QUADRILLE_OK);
  CHECK(quadrille_simplify(call.get()) == QUADRILLE_INVALID);
  CHECK(std::string(quadrille_error(call.get())) == "hull does not go with calibrated");
}

TEST_CASE("A preset leaves out what does not go with a placement of its own") {
  const test::Soup soup = test::cube(16);
  const SoupPoints points = coordinates_of(soup);
  Call call = call_of(points, soup.triangles);
  REQUIRE(quadrille_set_text(call.get(), "preset", "print") == QUADRILLE_OK);
  REQUIRE(quadrille_set_text(call.get(), "hull", "outer") == QUADRILLE_OK);
  run(call); // planes are kept by that preset, but not together with a hull
  CHECK(result_of<std::uint32_t>(call, "triangles").size() <= 3 * soup.triangles.size() / 2);
  REQUIRE(quadrille_set_double(call.get(), "keep_planes", 0.5) == QUADRILLE_OK);
  CHECK(quadrille_simplify(call.get()) == QUADRILLE_INVALID);
}

TEST_CASE("Maps of C are those of points, where several are one vertex, and of nothing") {
  const test::Soup grid = test::grid(10, 10);
  SoupPoints points; // each triangle has its own
  SoupTriangles triangles;
  for (const auto& triangle : grid.triangles) {
    for (const std::uint32_t v : triangle)
      points.push_back(grid.points[v].coordinates);
    const auto n = static_cast<std::uint32_t>(points.size());
    triangles.push_back({n - 3, n - 2, n - 1});
  }
  points.push_back({9, 9, 9}); // of no triangle
  Call call = call_of(points, triangles);
  for (const char* option : {"maps", "split_vertices"})
    REQUIRE(quadrille_set_int(call.get(), option, 1) == QUADRILLE_OK);
  REQUIRE(quadrille_set_int(call.get(), "faces", 20) == QUADRILLE_OK);
  run(call);
  const auto places = result_of<double>(call, "points");
  const auto begins = result_of<std::int64_t>(call, "old_to_new_begins");
  const auto indices = result_of<std::int64_t>(call, "old_to_new_indices");
  const auto weights = result_of<double>(call, "old_to_new_weights");
  REQUIRE(begins.size() == points.size() + 1);
  CHECK(begins[points.size() - 1] == begins[points.size()]);
  for (std::size_t row = 0; row + 1 < points.size(); ++row)
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (auto i = static_cast<std::size_t>(begins[row]);
           i < static_cast<std::size_t>(begins[row + 1]); ++i)
        sum += weights[i] * places[3 * static_cast<std::size_t>(indices[i]) + k];
      REQUIRE(sum == Approx(points[row][k]).margin(1e-12));
    }

  const SoupTriangles none;
  const quadrille_array t = array_of(none, QUADRILLE_UINT32);
  REQUIRE(quadrille_set_array(call.get(), "triangles", &t) == QUADRILLE_OK);
  run(call);
  CHECK(result_of<std::int64_t>(call, "old_to_new_begins") ==
        std::vector<std::int64_t>(points.size() + 1, 0));
  CHECK(result_of<std::int64_t>(call, "new_to_old_begins") == std::vector<std::int64_t>{0});
}

TEST_CASE("Splits of C are those of C++") {
  const test::Soup soup = test::torus(12, 8);
  const SoupPoints points = coordinates_of(soup);
  const LevelsHandle levels(quadrille_levels_new());
  char error[100];
  quadrille_splits* made = nullptr;
  CHECK(quadrille_levels_splits(levels.get(), &made, error, sizeof(error)) == QUADRILLE_INVALID);
  CHECK(std::string(error) == "quadrille::Levels: nothing has been recorded");
  Call call = call_of(points, soup.triangles);
  quadrille_set_levels(call.get(), levels.get());
  REQUIRE(quadrille_set_int(call.get(), "faces", 20) == QUADRILLE_OK);
  run(call);
  Levels own;
  simplified_soup({points, soup.triangles}, {.faces = 20, .recorder = record_into(own)});
  const VertexSplits expected = vertex_splits(own);
  REQUIRE(quadrille_levels_splits(levels.get(), &made, error, sizeof(error)) == QUADRILLE_OK);
  const std::unique_ptr<quadrille_splits, Delete> splits(made);
  CHECK(array_of_splits<double>(splits, "points") == flat(expected.points));
  CHECK(array_of_splits<std::uint32_t>(splits, "faces") == flat(expected.faces));
  CHECK(array_of_splits<std::uint32_t>(splits, "parents") == expected.parents);
  CHECK(array_of_splits<std::uint32_t>(splits, "corners") == expected.corners);
  CHECK(array_of_splits<double>(splits, "errors") == expected.errors);
  quadrille_array view;
  CHECK(quadrille_splits_array(splits.get(), "values", &view) == QUADRILLE_INVALID);
}
