// What surfaces in parts are made with, by brute force.

#include "folder.h"
#include "soups.h"
#include "surface_files.h"

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/chunk_cut.h>
#include <quadrille/internal/file/chunk_scatter.h>
#include <quadrille/internal/file/chunk_tree.h>
#include <quadrille/internal/file/cost_samples.h>
#include <quadrille/internal/file/id_index.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/job_watch.h>
#include <quadrille/internal/file/next_chunks.h>
#include <quadrille/internal/file/schedule.h>
#include <quadrille/internal/file/stl_weld.h>
#include <quadrille/internal/file/task_claims.h>
#include <quadrille/internal/file/true_boundaries.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace quadrille::internal;
using test::Folder;
using test::Random;
using test::Soup;

TEST_CASE("A checksum does not depend on the blocks, and on each byte") {
  Random random(1);
  std::string bytes;
  for (int i = 0; i < 1000; ++i)
    bytes += static_cast<char>(random.below(256));
  const auto checksum = [](const std::string& text, std::size_t block) {
    Checksum sum;
    for (std::size_t at = 0; at < text.size(); at += block)
      sum.add(text.data() + at, std::min(block, text.size() - at));
    return sum.value();
  };
  const std::uint64_t whole = checksum(bytes, bytes.size());
  for (const std::size_t block : {1U, 3U, 8U, 13U, 64U})
    CHECK(checksum(bytes, block) == whole);
  std::set<std::uint64_t> sums{whole};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] ^= 1;
    sums.insert(checksum(changed, 64));
    sums.insert(checksum(bytes.substr(0, i), 64));
  }
  CHECK(sums.size() == 2 * bytes.size() + 1);
  CHECK(checksum(bytes + '\0', 64) != whole);
}

TEST_CASE("Numbers are found, and ranked") {
  Random random(2);
  for (const std::size_t range : {10U, 1000U, 4'000'000'000U}) {
    std::set<VertexId> ids;
    for (int i = 0; i < 300; ++i)
      ids.insert(random.below(range));
    ids.insert(7);
    const std::vector<VertexId> list(ids.begin(), ids.end());
    const IdIndex index(list);
    for (std::size_t i = 0; i < list.size(); ++i)
      CHECK(index.find(list[i]) == i);
    for (int i = 0; i < 300; ++i)
      if (const VertexId id = random.below(range); ids.count(id) == 0)
        CHECK(index.find(id) == list.size());
  }
  CHECK(IdIndex({}).find(3) == 0);
  IdSet set(5000);
  std::set<VertexId> plain;
  for (int i = 0; i < 700; ++i) {
    const VertexId id = random.below(5000);
    set.add(id);
    plain.insert(id);
  }
  const IdRanks ranks(set);
  CHECK(ranks.size() == plain.size());
  std::uint64_t rank = 0;
  for (const VertexId id : plain)
    CHECK(ranks(id) == rank++);
}

TEST_CASE("Space is cut into parts of as many vertices") {
  const Soup soup = test::with_noise(test::torus(200, 80), 3, 0.01);
  FileBox box;
  for (const test::Position& p : soup.points)
    box.add(p);
  CellCounts cells(CellGridOfBox(box, 6));
  for (const test::Position& p : soup.points)
    cells.add(p);
  for (const double fraction : {0.5, 0.36, 0.62}) {
    const ChunkCut cut(cells, 1500, fraction);
    std::vector<std::uint64_t> sizes(cut.size());
    for (const test::Position& p : soup.points)
      ++sizes[cut.chunk_of(p)];
    CHECK(sizes == cut.sizes());
    CHECK(*std::max_element(sizes.begin(), sizes.end()) <= 1500);
    CHECK(*std::min_element(sizes.begin(), sizes.end()) >= 400);
  }
  const ChunkCut whole(cells, 16'000, 0.5);
  CHECK(whole.size() == 1);
  CHECK(whole.chunk_of({{9, 9, 9}}) == 0);
}

TEST_CASE("Where a cell is crowded, it is cut by itself") {
  std::vector<test::Position> points;
  const Soup soup = test::with_noise(test::torus(100, 40), 3, 0.01);
  for (const double size : {1e-7, 1e-3, 1.0}) // the larger one has the smaller ones in a cell
    for (const test::Position& p : soup.points)
      points.push_back({{size * p[0], size * p[1], size * p[2] + 3 * size}});
  points.push_back({{1000, 0, 0}});
  const auto tree_of = [](const std::vector<test::Position>& list) {
    FileBox box;
    for (const test::Position& p : list)
      box.add(p);
    return ChunkTree(box, list.size(), 500, 0.5, [&](auto take) {
      for (const test::Position& p : list)
        take(p);
    });
  };
  const ChunkTree tree = tree_of(points);
  std::vector<std::uint64_t> sizes(tree.size());
  for (const test::Position& p : points)
    ++sizes[tree.chunk_of(p)];
  CHECK(sizes == tree.sizes());
  CHECK(*std::max_element(sizes.begin(), sizes.end()) <= 1000);
  CHECK(sizes.size() > 24);
  CHECK(sizes.size() < 120);
  CHECK(tree.chunk_of({{1e-7, 0, 3e-7}}) != tree.chunk_of({{-1e-7, 0, 3e-7}}));
  const std::vector<test::Position> together(3000, test::Position{{1, 2, 3}});
  CHECK(tree_of(together).sizes() == std::vector<std::uint64_t>{3000});
}

TEST_CASE("Requests come once each, by vertex") {
  Random random(4);
  Requests requests;
  std::set<std::pair<VertexId, ChunkNumber>> plain;
  for (int i = 0; i < 2000; ++i) {
    const Request r{random.below(100), static_cast<ChunkNumber>(random.below(9))};
    requests.add(r);
    if (r.vertex % 3 != 0) // others are not asked for
      plain.insert({r.vertex, r.chunk});
  }
  requests.sort();
  std::set<std::pair<VertexId, ChunkNumber>> got;
  std::size_t count = 0;
  for (VertexId v = 0; v < 100; ++v)
    if (v % 3 != 0)
      requests.for_chunks(v, [&](ChunkNumber part) {
        got.insert({v, part});
        ++count;
      });
  CHECK(got == plain);
  CHECK(count == plain.size());
}

TEST_CASE("Corners that lie at one place are made one, in whatever memory") {
  const Folder folder;
  Soup soup = test::as_floats(test::with_noise(test::sphere(4), 5, 0.01));
  soup.points[3] = {{0, 0.5, -0.25}};
  const std::string content = test::stl_of(test::shuffled(soup, 6));
  std::string zero;
  for (const float x : {0.0F, 0.5F, -0.25F})
    test::put_number(zero, x);
  std::string with_minus = content;
  with_minus[with_minus.find(zero) + 3] = '\x80'; // −0 at one of its corners
  const auto stl = folder.file("in.stl", with_minus);
  for (const std::uint64_t memory : {1'000'000U, 4'000U}) { // in one run, and in many
    StlWeld::run(stl, folder.path("out.ply"), folder.path("scratch"), memory, false, [] {});
    const Soup welded = test::read_ply(folder.path("out.ply"));
    const auto topology = test::topology_of(welded);
    CHECK(topology.is_closed());
    CHECK(topology.is_manifold);
    CHECK(topology.is_oriented);
    CHECK(welded.points.size() == soup.points.size());
    CHECK(welded.triangles.size() == soup.triangles.size());
    const bool is_the_same = test::stl_of(welded) == content;
    CHECK(is_the_same);
  }
  CHECK(folder.size() == 2);
}

TEST_CASE("Edges of one face, over all parts") {
  const Folder folder;
  const JobFolder job(folder.path("scratch"));
  job.begin_phase(1);
  IdSet shared(10);
  for (const VertexId v : {1U, 2U, 3U, 4U})
    shared.add(v);
  const FaceRow faces[] = {{1, 2, 3}, {2, 1, 0}, {2, 4, 3}, {3, 4, 5}};
  AppendedFiles files({job.faces(1, 0), job.faces(1, 1)}, 100);
  for (std::size_t i = 0; i < 4; ++i)
    files.add(i % 2, &faces[i], sizeof(FaceRow));
  files.finish();
  const FileContent content = TrueBoundaries::write(job, 1, 2, shared);
  const auto edges = read_rows<std::uint64_t>(job.boundaries(1), content);
  CHECK(edges ==
        std::vector<std::uint64_t>{std::uint64_t{1} << 32 | 3, std::uint64_t{2} << 32 | 4});
}

/// Vertices with what they remember as doubles; what is given may be missing.
Survivors remembering(const std::vector<VertexRow>& vertices, const std::vector<double>& states,
                      const std::vector<std::uint64_t>& given,
                      const std::vector<double>& given_states) {
  Survivors s{vertices, {}};
  s.given = given;
  const auto put = [](std::vector<char>& bytes, const std::vector<double>& from) {
    bytes.resize(from.size() * sizeof(double));
    std::memcpy(bytes.data(), from.data(), bytes.size());
  };
  put(s.states, states);
  put(s.given_states, given_states);
  return s;
}

TEST_CASE(
    "what shared vertices remember is what they were given, and what they gain in each part") {
  const AddState add = [](void* total, const void* gained) {
    double a = 0, b = 0;
    std::memcpy(&a, total, sizeof(a));
    std::memcpy(&b, gained, sizeof(b));
    a += b;
    std::memcpy(total, &a, sizeof(a));
  };
  SharedStates states(sizeof(double), add);
  states.add(remembering({{3, 1, {}}, {4, 0, {}}, {7, 1, {}}}, {1, 50, 2}, {0, 2}, {100, 200}));
  states.add(remembering({{3, 1, {}}, {8, 1, {}}}, {4, 8}, {0}, {100}));
  states.add(remembering({{3, 1, {}}, {7, 1, {}}, {8, 1, {}}}, {16, 32, 64}, {0, 1}, {100, 200}));
  states.sum_up();
  const auto total = [&](VertexId id) {
    double value = 0;
    std::memcpy(&value, states.total(id), sizeof(value));
    return value;
  };
  CHECK(total(3) == 100 + 1 + 4 + 16);
  CHECK(total(7) == 200 + 2 + 32);
  CHECK(total(8) == 8 + 64); // after the first phase nobody has been given anything
}

TEST_CASE("Phases aim at four and two times the target, by steps that are not too large") {
  const auto counts = [](std::uint64_t faces, std::uint64_t target, std::uint64_t part) {
    const Schedule schedule(faces, target, part);
    std::vector<std::uint64_t> result;
    for (std::size_t i = 0; i < schedule.size(); ++i)
      result.push_back(schedule.wanted(i, target));
    return result;
  };
  using Counts = std::vector<std::uint64_t>;
  CHECK(counts(1000, 500, 100).empty());
  CHECK(counts(1000, 250, 100) == Counts{500});
  CHECK(counts(1000, 100, 100) == Counts{400, 200});
  CHECK(counts(1'000'000, 100'000, 33'000) == Counts{200'000}); // four times are much
  CHECK(counts(1'000'000, 100'000, 31'000) == Counts{400'000, 200'000});
  CHECK(counts(1'000'000, 50'000, 2'000'000) == Counts{200'000, 100'000});
  CHECK(counts(1'000'000'000, 10'000'000, 2'000'000) == Counts{40'000'000, 20'000'000});
  CHECK(counts(64'000, 640, 500) == Counts{16'000, 4'000, 2'560, 1'280});
  CHECK(Schedule(100, 0, 10).wanted(0, 0) <= 25);
}

TEST_CASE("Faces that are too many are shared out by the sizes of parts") {
  const std::uint64_t faces[] = {100, 333, 0, 500, 67};
  std::uint64_t begin = 0, sum = 0;
  for (const std::uint64_t own : faces) {
    const std::uint64_t share = Schedule::share(41, begin, begin + own, 1000);
    CHECK(std::abs(static_cast<double>(share) - 0.041 * static_cast<double>(own)) <= 2.1);
    CHECK((share % 2 == 0 || own == 67));
    begin += own;
    sum += share;
  }
  CHECK(sum == 41);
  CHECK(Schedule::can_share(1250, 1000));
  CHECK_FALSE(Schedule::can_share(1000, 1000));
  CHECK_FALSE(Schedule::can_share(1251, 1000)); // labels, or hubs, hold what is left
}

TEST_CASE("Tasks are run once each, and the first failure is told") {
  for (const unsigned threads : {1U, 4U}) {
    std::vector<std::atomic<int>> runs(50);
    ChunkThreads::run(
        50, threads, [&](std::size_t i) { ++runs[i]; }, [] {});
    CHECK(std::all_of(runs.begin(), runs.end(), [](const auto& n) { return n == 1; }));
    CHECK_THROWS_WITH(ChunkThreads::run(
                          50, threads,
                          [](std::size_t i) {
                            if (i >= 7)
                              throw std::runtime_error(std::to_string(i));
                          },
                          [] {}),
                      "7");
  }
}

TEST_CASE("A sample tells the cost at which as many faces are left") {
  LoadedChunk part;
  part.ids.resize(40);
  part.is_shared.resize(40);
  for (std::uint32_t i = 0; i < 40; ++i) {
    part.triangles.push_back({i, (i + 1) % 40, (i + 2) % 40});
    part.triangles.push_back({i, (i + 3) % 40, (i + 2) % 40});
  }
  CHECK(SampleCounts(part).free_faces == 80);
  for (std::size_t i = 0; i < 10; ++i)
    part.is_shared[i] = true;
  CHECK(SampleCounts(part).free_faces == 60);
  CostHistogram costs;
  for (int i = 0; i < 30; ++i)
    costs.add(static_cast<float>(i + 1), 2); // all 60 of them
  CostSamples samples(1000);
  samples.add(1000, SampleCounts(part).free_faces, costs);
  CHECK(samples.limit(510) == Approx(15).epsilon(0.04));
  CHECK(samples.limit(910) == Approx(3).epsilon(0.04));
  CHECK(samples.limit(0) == Approx(30).epsilon(0.04));
  CHECK(CostSamples(10).limit(5) > 1e30F);
}

TEST_CASE("Each task is claimed once, by whichever process is free") {
  const Folder here;
  const auto folder = here.path("");
  constexpr std::size_t tasks = 60, processes = 4;
  std::vector<std::vector<std::size_t>> got(processes);
  TaskClaims slow(folder, tasks, 0, processes);
  got[0].push_back(slow.next().value()); // and asks no more until the others have all
  {
    std::vector<std::jthread> others;
    for (std::size_t p = 1; p < processes; ++p)
      others.emplace_back([&, p] {
        TaskClaims claims(folder, tasks, p, processes);
        while (const auto task = claims.next())
          got[p].push_back(*task);
      });
  }
  CHECK_FALSE(slow.next());
  CHECK(got[0] == std::vector<std::size_t>{0});
  std::multiset<std::size_t> all;
  for (const auto& of_one : got)
    all.insert(of_one.begin(), of_one.end());
  CHECK(all.size() == tasks);
  CHECK(std::set<std::size_t>(all.begin(), all.end()).size() == tasks);
}

TEST_CASE("Processes begin with tasks of their own, and end at a word") {
  const Folder folder;
  TaskClaims first(folder.path(""), 5, 0, 2), second(folder.path(""), 5, 1, 2);
  CHECK(first.next() == 0U);
  CHECK(second.next() == 1U);
  CHECK(second.next() == 3U);
  CHECK(second.next() == 4U); // the last one of the other
  second.end();
  CHECK_FALSE(first.next()); // though 2 is left
  CHECK_THROWS_WITH(TaskClaims(folder.path("none"), 5, 0, 1).next(),
                    Catch::Contains("none/0: cannot be made"));
}

} // namespace
