#ifndef QUADRILLE_INTERNAL_LEVELS_LEVEL_DIRECTORY_H
#define QUADRILLE_INTERNAL_LEVELS_LEVEL_DIRECTORY_H

#include <quadrille/internal/levels/bytes.h>
#include <quadrille/levels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// The position of a block in a file, its stored size, and its size after decompression.
struct FileBlock {
  std::uint64_t offset = 0, stored = 0, raw = 0;
  std::uint32_t checksum = 0; // of the stored bytes
  std::uint8_t is_compressed = 0;

  void put(ByteWriter& writer) const {
    writer.put(offset);
    writer.put(stored);
    writer.put(raw);
    writer.put(checksum);
    writer.put(is_compressed);
  }
  static FileBlock get(ByteReader& reader) {
    FileBlock block;
    block.offset = reader.get<std::uint64_t>();
    block.stored = reader.get<std::uint64_t>();
    block.raw = reader.get<std::uint64_t>();
    block.checksum = reader.get<std::uint32_t>();
    block.is_compressed = reader.get<std::uint8_t>();
    return block;
  }

  /// Reads the block from a file of the given size.
  Bytes read(std::istream& file, std::uint64_t size) const {
    constexpr std::uint64_t best_compression = 100'000; // a greater ratio is invalid
    if (offset > size || stored > size - offset || raw / best_compression > stored ||
        (is_compressed == 0 && raw != stored))
      throw std::runtime_error("a block lies outside the file");
    Bytes bytes(stored);
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(stored));
    if (!file)
      throw std::runtime_error("it cannot be read");
    if (checksum_of(bytes) != checksum)
      throw std::runtime_error("a block is damaged: its checksum differs");
    return is_compressed == 0 ? bytes : decompressed(bytes, raw);
  }
  /// Writes a block to the end of a file.
  static FileBlock write(const Bytes& bytes, bool compresses, std::ostream& file,
                         std::uint64_t offset) {
    const Bytes stored = compresses ? compressed(bytes) : bytes;
    file.write(reinterpret_cast<const char*>(stored.data()),
               static_cast<std::streamsize>(stored.size()));
    return {offset, stored.size(), bytes.size(), checksum_of(stored), compresses};
  }
};

/// The header of a file of levels, in front of its blocks.
struct LevelDirectory {
  static constexpr std::array<unsigned char, 8> magic{0x89, 'Q', 'L', 'V', '\r', '\n', 0x1a, '\n'};
  static constexpr std::uint32_t version = 1;
  static constexpr std::size_t bytes_before = 8 + 4 + 8 + 4; // magic, version, size, checksum

  struct Channel {
    std::uint32_t track, offset, components;
  };
  /// A level at the beginning of a segment, or the coarsest one.
  struct Stage {
    std::uint64_t contractions;
    std::uint32_t faces, vertices;
    float error, bound;
  };

  std::string comment;
  std::uint64_t input_vertices = 0;
  bool knows_bounds = false, are_bounds_both_ways = false;
  std::vector<std::size_t> widths; // of the tracks
  std::vector<Channel> channels;
  std::vector<Stage> stages;
  std::vector<FileBlock> segments, inputs; // the finest first

  Bytes write() const {
    ByteWriter writer;
    writer.put_text(comment);
    writer.put(input_vertices);
    writer.put(static_cast<std::uint8_t>(knows_bounds + (knows_bounds && are_bounds_both_ways)));
    writer.put(static_cast<std::uint32_t>(widths.size()));
    for (std::size_t width : widths)
      writer.put(static_cast<std::uint32_t>(width));
    writer.put(static_cast<std::uint32_t>(channels.size()));
    for (const Channel& channel : channels)
      for (std::uint32_t number : {channel.track, channel.offset, channel.components})
        writer.put(number);
    writer.put(static_cast<std::uint32_t>(segments.size()));
    for (const Stage& stage : stages) {
      writer.put(stage.contractions);
      writer.put(stage.faces);
      writer.put(stage.vertices);
      writer.put(stage.error);
      writer.put(stage.bound);
    }
    for (const auto* blocks : {&segments, &inputs})
      for (const FileBlock& block : *blocks)
        block.put(writer);
    return writer.take();
  }

  static LevelDirectory read(const Bytes& bytes) {
    ByteReader reader(bytes);
    LevelDirectory directory;
    directory.comment = reader.get_text();
    directory.input_vertices = reader.get<std::uint64_t>();
    const auto known = reader.get<std::uint8_t>();
    directory.knows_bounds = known != 0;
    directory.are_bounds_both_ways = known == 2;
    for (auto left = reader.get<std::uint32_t>(); left > 0; --left)
      directory.widths.push_back(reader.get<std::uint32_t>());
    for (auto left = reader.get<std::uint32_t>(); left > 0; --left) {
      const auto track = reader.get<std::uint32_t>(), offset = reader.get<std::uint32_t>();
      directory.channels.push_back({track, offset, reader.get<std::uint32_t>()});
    }
    const auto segments = reader.get<std::uint32_t>();
    for (std::size_t i = 0; i <= segments; ++i) {
      Stage stage{};
      stage.contractions = reader.get<std::uint64_t>();
      stage.faces = reader.get<std::uint32_t>();
      stage.vertices = reader.get<std::uint32_t>();
      stage.error = reader.get<float>();
      stage.bound = reader.get<float>();
      directory.stages.push_back(stage);
    }
    for (auto* blocks : {&directory.segments, &directory.inputs})
      for (std::size_t i = 0; i < segments; ++i)
        blocks->push_back(FileBlock::get(reader));
    directory.require_consistent();
    return directory;
  }

private:
  void require_consistent() const {
    const auto require = [](bool is_right) {
      if (!is_right)
        throw std::runtime_error("its directory is invalid");
    };
    require(!segments.empty() && !widths.empty() && widths[0] >= 3);
    for (std::size_t width : widths)
      require(width > 0 && width < 1 << 16);
    for (const Channel& channel : channels)
      require(channel.components > 0 && channel.track < widths.size() &&
              std::uint64_t{channel.offset} + channel.components <= widths[channel.track] &&
              (channel.track == 0 || channel.components == widths[channel.track]));
    for (std::size_t i = 1; i < stages.size(); ++i)
      require(stages[i].contractions >= stages[i - 1].contractions &&
              stages[i].faces <= stages[i - 1].faces &&
              stages[i].vertices <= stages[i - 1].vertices &&
              stages[i].error >= stages[i - 1].error && stages[i].bound >= stages[i - 1].bound);
    require(stages[0].vertices <= input_vertices && input_vertices <= 0xFFFFFFFF);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_LEVEL_DIRECTORY_H
