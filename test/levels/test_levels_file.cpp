// Levels in files: read again, by themselves, and what is broken is refused.
#include "folder.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;
using Catch::Contains;

template <class... Arguments>
Levels levels_of(const Textured& surface, const Arguments&... arguments) {
  std::vector<std::array<double, 3>> points;
  for (const Position& p : surface.soup.points)
    points.push_back(p.coordinates);
  auto triangles = surface.soup.triangles;
  auto [values, triples] = indexed(surface.texture);
  Levels levels;
  simplify(points, triangles, Texture{values, triples}, record_into(levels), arguments...);
  return levels;
}

void require_same(const Level& a, const Level& b) {
  REQUIRE(a.faces == b.faces);
  REQUIRE(a.vertices == b.vertices);
  REQUIRE(a.contractions == b.contractions);
  REQUIRE(a.error == b.error);
  REQUIRE(a.distance_bound == b.distance_bound);
  REQUIRE(a.hausdorff_bound == b.hausdorff_bound);
  REQUIRE(a.points == b.points);
  REQUIRE(a.triangles == b.triangles);
  REQUIRE(a.input_vertices == b.input_vertices);
  REQUIRE(a.input_faces == b.input_faces);
  REQUIRE(a.channels.size() == b.channels.size());
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    REQUIRE(a.channels[c].values == b.channels[c].values);
    REQUIRE(a.channels[c].triangles == b.channels[c].triangles);
  }
}

std::vector<char> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
void write_bytes(const std::filesystem::path& path, const std::vector<char>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

TEST_CASE("levels are read as they were written") {
  const Folder folder;
  const std::filesystem::path path = folder.path("torus.qlv");
  for (const bool is_compressed : {false, true}) {
    if (is_compressed && !internal::has_zstd)
      continue;
    const Levels levels = levels_of(textured_torus(24, 15), FaceCount{30});
    write_levels(path, levels, {.is_compressed = is_compressed, .comment = "a torus"});
    const Levels all = read_levels(path);
    LevelsFile file(path);
    CHECK(file.comment() == "a torus");
    CHECK(file.finest().faces == 720);
    CHECK(file.coarsest().faces == levels.coarsest().faces);
    for (std::size_t faces = 740; faces > 10; faces -= 10) {
      CAPTURE(faces);
      const Level level = levels.at(FaceCount{faces});
      require_same(all.at(FaceCount{faces}), level);
      require_same(file.at(FaceCount{faces}), level);
      require_same(file.at(VertexCount{faces / 2}), levels.at(VertexCount{faces / 2}));
      require_same(file.at(AfterContractions{faces / 2}), levels.at(AfterContractions{faces / 2}));
      require_same(file.at(ErrorAtMost{level.error}), levels.at(ErrorAtMost{level.error}));
      require_same(file.at(ErrorAtMost{level.error / 2}), levels.at(ErrorAtMost{level.error / 2}));
      CHECK(all.vertex_map(level) == levels.vertex_map(level));
    }
    CHECK_THROWS_AS(file.at(DistanceAtMost{1}), std::logic_error);
  }
}

TEST_CASE("bounds are read as they were written") {
  const Folder folder;
  const std::filesystem::path path = folder.path("bounds.qlv");
  const Levels levels = levels_of(textured_torus(24, 15), HausdorffLimit{0.05});
  write_levels(path, levels, {.is_compressed = false});
  LevelsFile file(path);
  for (double d = 0; d < 0.06; d += 0.001)
    require_same(file.at(DistanceAtMost{d}), levels.at(DistanceAtMost{d}));
}

TEST_CASE("floats take less place") {
  const Folder folder;
  Textured torus = textured_torus(24, 15);
  const Levels levels = levels_of(torus, FaceCount{30});
  write_levels(folder.path("doubles.qlv"), levels, {.is_compressed = false});
  write_levels(folder.path("floats.qlv"), levels,
               {.is_compressed = false, .rounds_to_floats = true});
  CHECK(std::filesystem::file_size(folder.path("floats.qlv")) * 5 <
        std::filesystem::file_size(folder.path("doubles.qlv")) * 4);
  const Level rounded = read_levels(folder.path("floats.qlv")).at(FaceCount{100});
  const Level level = levels.at(FaceCount{100});
  CHECK(rounded.triangles == level.triangles);
  for (std::size_t v = 0; v < level.vertices; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(rounded.points[v][k] == static_cast<double>(static_cast<float>(level.points[v][k])));
}

TEST_CASE("files that cannot be read or written are refused in a sentence") {
  const Folder folder;
  const std::filesystem::path path = folder.path("levels.qlv");
  CHECK_THROWS_WITH(LevelsFile(path), Contains(path.string()) && Contains("it cannot be opened"));
  write_bytes(path, {'O', 'F', 'F', '\n'});
  CHECK_THROWS_WITH(LevelsFile(path), Contains("its first bytes are wrong"));
  CHECK_THROWS_AS(write_levels(path, Levels()), std::logic_error);
  CHECK(bytes_of(path).size() == 4); // it is left as it was
  const Levels levels = levels_of(textured_torus(6, 5), FaceCount{30});
  CHECK_THROWS_WITH(write_levels(folder.path("no/such/folder.qlv"), levels),
                    Contains("no/such/folder.qlv"));
  if (!internal::has_zstd)
    CHECK_THROWS_WITH(write_levels(path, levels, {.is_compressed = true}), Contains("zstd"));
  write_levels(path, levels, {.is_compressed = false});
  std::vector<char> newer = bytes_of(path);
  newer[8] = 2;
  write_bytes(path, newer);
  CHECK_THROWS_WITH(LevelsFile(path), Contains("its version is 2, and this library reads 1"));
}

TEST_CASE("a file that is damaged anywhere is refused") {
  const Folder folder;
  const std::filesystem::path path = folder.path("levels.qlv");
  write_levels(path, levels_of(textured_torus(5, 3), FaceCount{20}), {.is_compressed = false});
  const std::vector<char> bytes = bytes_of(path);
  for (std::size_t i = 0; i < bytes.size(); i += i < 600 ? 1 : 7) {
    CAPTURE(i);
    std::vector<char> damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    write_bytes(path, damaged);
    REQUIRE_THROWS_WITH(read_levels(path), Contains(path.string()));
  }
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    write_bytes(path, {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    REQUIRE_THROWS_WITH(read_levels(path), Contains(path.string()));
  }
}

// What LevelSteps needs, and levels as such do not.
TEST_CASE("a segment of which a contraction is none of two vertices is refused") {
  internal::LevelSegment segment;
  segment.faces_after = {2, 1};
  segment.errors = {0, 0};
  internal::LevelTrack& vertices = segment.tracks.emplace_back();
  vertices.width = 3;
  vertices.corners = {{0, 1, 2}, {0, 2, 1}, {1, 3, 4}};
  vertices.values.assign(15, 0.);
  vertices.parents = {2, internal::none}; // of 3 and 4
  vertices.items_after = {4, 3};
  vertices.change_ends = {0,
                          1}; // the first removes a face, and with it 4; in the second 3 becomes 2
  vertices.changed = {2};
  vertices.changed_values.assign(3, 1.);
  const auto read = [](const internal::LevelSegment& s) {
    return internal::SegmentBytes::read(internal::SegmentBytes::write(s, false), {3});
  };
  CHECK(read(segment).tracks.front().parents == vertices.parents);
  const auto check_rejected = [&](auto change) {
    internal::LevelSegment changed = segment;
    change(changed.tracks.front());
    CHECK_THROWS_WITH(read(changed), "a contraction does not have two vertices");
  };
  check_rejected([](internal::LevelTrack& track) { track.changed = {1}; });
  check_rejected([](internal::LevelTrack& track) { track.parents[1] = 2; });
  check_rejected([](internal::LevelTrack& track) { track.change_ends = {1, 1}; });
  check_rejected([](internal::LevelTrack& track) { track.items_after = {3, 3}; });
  check_rejected([](internal::LevelTrack& track) {
    track.changed = {2, 2};
    track.changed_values.assign(6, 1.);
    track.change_ends = {0, 2};
  });
}

// What a file says may be wrong although its checksums are right.
TEST_CASE("a segment that makes no sense is refused") {
  const Levels levels = levels_of(textured_torus(6, 5), FaceCount{30});
  const Folder folder;
  const std::filesystem::path path = folder.path("levels.qlv");
  write_levels(path, levels, {.is_compressed = false});
  const std::vector<char> bytes = bytes_of(path);
  std::uint64_t directory_size = 0;
  std::copy_n(bytes.begin() + 12, 8, reinterpret_cast<char*>(&directory_size));
  const auto at = [&](std::size_t i) { return bytes.begin() + static_cast<std::ptrdiff_t>(i); };
  const internal::FileBlock block =
      internal::LevelDirectory::read({at(24), at(24 + directory_size)}).segments.front();
  std::size_t refused = 0, read = 0;
  bool is_in_range = true;
  Random random(3);
  for (int run = 0; run < 3000; ++run) {
    internal::Bytes segment(at(block.offset), at(block.offset + block.stored));
    for (std::uint32_t changes = random.below(3) + 1; changes > 0; --changes)
      segment[random.below(segment.size())] = static_cast<unsigned char>(random.below(256));
    try {
      const internal::LevelSegment left = internal::SegmentBytes::read(segment, {3, 2});
      for (std::size_t i = 0; i <= left.contractions(); ++i)
        for (const internal::LevelTrack& track : left.tracks)
          for (const auto& corners : track.corners_at(i, left.faces_at(i)))
            for (std::uint32_t corner : corners)
              is_in_range = is_in_range && corner < track.items_at(i);
      ++read;
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  CHECK(is_in_range);
  CHECK(refused > 100);
  CHECK(read + refused == 3000);
}

} // namespace
