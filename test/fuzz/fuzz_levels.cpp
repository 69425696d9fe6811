// Bytes are a file of levels: it is refused with an exception, or each of its levels is a surface,
// by itself as among all, and the file is written again as it was read. Its checksums are made
// right before, so that what is behind them is reached.
#include "../support/folder.h"

#include <quadrille/level_steps.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using internal::Bytes;
using internal::LevelDirectory;

void require(bool holds, const char* what) {
  if (holds)
    return;
  std::cerr << what << '\n';
  std::abort();
}

Bytes part(const Bytes& bytes, std::size_t begin, std::size_t size) {
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
  return {first, first + static_cast<std::ptrdiff_t>(size)};
}
void put(Bytes& bytes, std::size_t begin, const auto& content) {
  std::copy(content.begin(), content.end(), bytes.begin() + static_cast<std::ptrdiff_t>(begin));
}

Bytes directory_with_checksums(const Bytes& file, const Bytes& bytes) {
  try {
    LevelDirectory directory = LevelDirectory::read(bytes);
    for (auto* blocks : {&directory.segments, &directory.inputs})
      for (internal::FileBlock& block : *blocks)
        if (block.offset <= file.size() && block.stored <= file.size() - block.offset)
          block.checksum = internal::checksum_of(part(file, block.offset, block.stored));
    const Bytes written = directory.write();
    return written.size() == bytes.size() ? written : bytes;
  } catch (const std::runtime_error&) {
    return bytes;
  }
}

Bytes with_checksums(Bytes file) {
  constexpr std::size_t before = LevelDirectory::bytes_before;
  if (file.size() < before)
    return file;
  std::uint64_t size = 0;
  std::memcpy(&size, file.data() + before - 12, sizeof size);
  if (size > file.size() - before)
    return file;
  const Bytes directory = directory_with_checksums(file, part(file, before, size));
  put(file, before, directory);
  put(file, before - 4, internal::little_endian<unsigned char>(internal::checksum_of(directory)));
  return file;
}

void require_valid(const Level& level) {
  require(level.points.size() == level.vertices && level.triangles.size() == level.faces,
          "a level of another size");
  for (const auto& triangle : level.triangles)
    for (const std::uint32_t corner : triangle)
      require(corner < level.vertices, "an index of no point");
  for (const LevelChannel& channel : level.channels)
    for (const auto& triangle : channel.triangles)
      for (const std::uint32_t corner : triangle)
        require(corner < channel.values.size() / channel.components, "an index of no value");
  require(in_input_order(level).faces == level.faces, "faces are lost in order");
}

void require_same(const Level& a, const Level& b) {
  require(a.contractions == b.contractions && a.points == b.points && a.triangles == b.triangles &&
              a.input_vertices == b.input_vertices && a.input_faces == b.input_faces,
          "another level by itself");
}

void walk(const Levels& levels) {
  LevelSteps steps(levels);
  std::size_t count = 0;
  const auto step = [&](bool is_done) {
    for (const auto& triangle : steps.triangles())
      for (const std::uint32_t corner : triangle)
        require(corner < steps.points().size(), "a step to an index of no point");
    return is_done;
  };
  while (step(steps.coarsen()))
    ++count;
  while (step(steps.refine()))
    --count;
  require(count == 0, "more steps in one direction");
}

void check(const std::filesystem::path& path) {
  LevelsFile file(path);
  const Levels levels = file.read();
  const std::size_t last = file.coarsest().contractions;
  for (std::size_t i = 0; i <= last; i += last / 32 + 1) {
    const Level level = file.at(AfterContractions{i});
    require_valid(level);
    require_same(level, levels.at(AfterContractions{i}));
    require_valid(file.at(FaceCount{level.faces / 2}));
    require_valid(file.at(VertexCount{level.vertices / 2}));
    require_valid(file.at(ErrorAtMost{level.error / 2}));
    for (const std::uint32_t image : levels.vertex_map(levels.finest(), level))
      require(image < level.vertices || image == not_recorded, "an image that is not there");
  }
  walk(levels);
  write_levels(path, levels, {.is_compressed = false, .comment = file.comment()});
  require_same(read_levels(path).at(FaceCount{0}), levels.at(FaceCount{0}));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::Folder folder;
  const std::filesystem::path path = folder.path("levels.qlv");
  const Bytes bytes = with_checksums(Bytes(data, data + size));
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  try {
    check(path);
  } catch (const std::runtime_error& error) { // refused, in one line
    require(std::string(error.what()).find('\n') == std::string::npos, "more than one line");
  }
  return 0;
}
