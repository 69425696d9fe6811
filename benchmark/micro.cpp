// SPDX-License-Identifier: MIT
//
// The small steps that make up most of a simplification, one by one.

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/order/pair_queue.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <tuple>
#include <vector>

namespace {

using namespace quadrille;
using quadrille::internal::Array;
using quadrille::internal::Index;
using quadrille::internal::PairQueue;
using quadrille::internal::QueuedPair;
using quadrille::internal::TriangleComplex;

/// As many inputs as fit into the first-level cache, so that the arithmetic is measured.
constexpr std::size_t inputs = 64;

template <std::size_t N>
Vector<N> random_vector(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Vector<N> v;
  for (double& x : v.coordinates)
    x = coordinate(generator);
  return v;
}

/// Sums of enough planes to have a minimum.
template <std::size_t N>
std::vector<QuadricForm<N>> random_forms() {
  std::mt19937_64 generator(1);
  std::vector<QuadricForm<N>> forms(inputs);
  for (QuadricForm<N>& form : forms)
    for (std::size_t i = 0; i < 2 * N; ++i) {
      form += QuadricForm<N>::plane(random_vector<N>(generator), 1);
      form.move_origin(random_vector<N>(generator));
    }
  return forms;
}

void face_quadric(benchmark::State& state) {
  std::mt19937_64 generator(1);
  std::vector<Vector<3>> points;
  for (std::size_t i = 0; i < inputs + 2; ++i)
    points.push_back(random_vector<3>(generator));
  const Quadric quadric;
  for (auto _ : state)
    for (std::size_t i = 0; i < inputs; ++i)
      benchmark::DoNotOptimize(quadric.face(points[i], points[i + 1], points[i + 2]));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(inputs));
}
BENCHMARK(face_quadric);

template <std::size_t N>
void quadric_sum(benchmark::State& state) {
  const auto forms = random_forms<N>();
  for (auto _ : state)
    for (std::size_t i = 0; i + 1 < inputs; ++i)
      benchmark::DoNotOptimize(forms[i] + forms[i + 1]);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(inputs - 1));
}
BENCHMARK(quadric_sum<3>);
BENCHMARK(quadric_sum<6>);

template <std::size_t N>
void quadric_move_origin(benchmark::State& state) {
  const auto forms = random_forms<N>();
  std::mt19937_64 generator(2);
  const auto d = random_vector<N>(generator);
  for (auto _ : state)
    for (QuadricForm<N> form : forms) {
      form.move_origin(d);
      benchmark::DoNotOptimize(form);
    }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(inputs));
}
BENCHMARK(quadric_move_origin<3>);
BENCHMARK(quadric_move_origin<6>);

template <std::size_t N>
void quadric_value(benchmark::State& state) {
  const auto forms = random_forms<N>();
  std::mt19937_64 generator(2);
  const auto x = random_vector<N>(generator);
  for (auto _ : state)
    for (const QuadricForm<N>& form : forms)
      benchmark::DoNotOptimize(form(x));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(inputs));
}
BENCHMARK(quadric_value<3>);
BENCHMARK(quadric_value<6>);

template <std::size_t N>
void quadric_minimizer(benchmark::State& state) {
  const auto forms = random_forms<N>();
  for (auto _ : state)
    for (const QuadricForm<N>& form : forms)
      benchmark::DoNotOptimize(form.minimizer());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(inputs));
}
BENCHMARK(quadric_minimizer<3>);
BENCHMARK(quadric_minimizer<6>);

/// As a simplification uses the queue: while pairs are popped, twice as many come in at costs a
/// little above, and of all pairs in it two of three are outdated.
void queue(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  std::mt19937_64 generator(1);
  std::exponential_distribution<float> cost(1);
  std::vector<float> costs(3 * size);
  for (float& c : costs)
    c = cost(generator);
  const auto outdated = [](const QueuedPair& pair) { return pair.stamp % 3 != 0; };
  for (auto _ : state) {
    PairQueue queue(3 * size);
    std::uint32_t next = 0;
    for (; next < size; ++next)
      queue.push({costs[next], next, next + 1, next}, outdated);
    while (const auto pair = queue.pop(outdated)) {
      for (int i = 0; i < 2 && next < costs.size(); ++i, ++next)
        queue.push({pair->cost + costs[next], next, next + 1, next}, outdated);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(costs.size()));
}
BENCHMARK(queue)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// A torus of 2·n·n faces, so that every vertex has six.
Array<TriangleComplex::Triangle> torus(Index n) {
  Array<TriangleComplex::Triangle> triangles;
  const auto vertex = [n](Index i, Index j) { return i % n * n + j % n; };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return triangles;
}

void corner_lists_build(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const auto triangles = torus(n);
  for (auto _ : state)
    benchmark::DoNotOptimize(TriangleComplex(std::size_t{n} * n, triangles));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(triangles.size()));
}
BENCHMARK(corner_lists_build)->Arg(100)->Arg(700)->Unit(benchmark::kMillisecond);

void corner_lists_walk(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  TriangleComplex complex(std::size_t{n} * n, torus(n));
  for (auto _ : state)
    for (Index v = 0; v < n * n; ++v)
      complex.for_each_corner(v, [](Index face, Index i) { benchmark::DoNotOptimize(face + i); });
  state.SetItemsProcessed(state.iterations() * n * n);
}
BENCHMARK(corner_lists_walk)->Arg(100)->Arg(700)->Unit(benchmark::kMillisecond);

/// Merges every other vertex into its neighbour, killing the two faces of their edge.
void corner_lists_merge(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const TriangleComplex before(std::size_t{n} * n, torus(n));
  for (auto _ : state) {
    state.PauseTiming();
    TriangleComplex complex = before;
    state.ResumeTiming();
    for (Index v = 0; v + 1 < n * n; v += 2) {
      complex.for_each_corner(v, [&](Index face, Index) {
        for (Index w : complex.vertices(face))
          if (w == v + 1)
            return complex.remove_face(face);
      });
      complex.merge(v, v + 1);
    }
    benchmark::DoNotOptimize(complex);
  }
  state.SetItemsProcessed(state.iterations() * n * n / 2);
}
BENCHMARK(corner_lists_merge)->Arg(100)->Arg(700)->Unit(benchmark::kMillisecond);

// --- Levels
// ----------------------------------------------------------------------------------------

struct Soup {
  std::vector<std::array<double, 3>> points;
  std::vector<TriangleComplex::Triangle> triangles;
};

/// A bumpy torus of about that many faces.
Soup bumpy_torus(std::size_t faces) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto n = static_cast<Index>(std::sqrt(static_cast<double>(faces) / 2));
  Soup soup;
  const auto triangles = torus(n);
  soup.triangles.assign(triangles.begin(), triangles.end());
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double u = turn * i / n, v = turn * j / n;
      const double r =
          0.4 + 0.02 * std::sin(13 * u) * std::cos(9 * v) + 0.005 * std::sin(71 * u + 33 * v);
      soup.points.push_back({(1 + r * std::cos(v)) * std::cos(u),
                             (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v)});
    }
  return soup;
}

/// A recorder that does nothing.
struct NoLevels {
  void begin(const RecordedSurface&) {}
  void record(const RecordedContraction&) {}
  void end() {}
};

template <class... Recorder>
void simplify_recorded(benchmark::State& state) {
  const Soup soup = bumpy_torus(200'000);
  for (auto _ : state) {
    Soup copy = soup;
    std::tuple<Recorder...> recorders;
    std::apply(
        [&](auto&... recorder) {
          simplify<MemorylessQuadric, OptimalPlacement>(copy.points, copy.triangles,
                                                        FaceRatio{0.01}, record_into(recorder)...);
        },
        recorders);
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(simplify_recorded<>)->Unit(benchmark::kMillisecond);
BENCHMARK(simplify_recorded<NoLevels>)->Unit(benchmark::kMillisecond);
BENCHMARK(simplify_recorded<Levels>)->Unit(benchmark::kMillisecond);

/// A level of so many faces, of a surface of half as many again. An item is a face of the level.
void extract_level(benchmark::State& state) {
  const auto faces = static_cast<std::size_t>(state.range(0));
  Soup soup = bumpy_torus(3 * faces / 2);
  Levels levels;
  simplify(soup.points, soup.triangles, FaceCount{faces * 9 / 10}, RelaxedOrder{},
           record_into(levels));
  for (auto _ : state)
    levels.extract(FaceCount{faces}, soup.points, soup.triangles);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(extract_level)->RangeMultiplier(10)->Range(1'000, 10'000'000);

} // namespace

BENCHMARK_MAIN();
