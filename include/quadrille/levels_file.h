#ifndef QUADRILLE_LEVELS_FILE_H
#define QUADRILLE_LEVELS_FILE_H

#include <quadrille/internal/levels/bytes.h>
#include <quadrille/internal/levels/level_directory.h>
#include <quadrille/internal/levels/levels_file_writer.h>
#include <quadrille/internal/levels/segment_bytes.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file_options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

/// \file
/// Levels of detail in a file, from which each level can be read separately.
///
/// The file has a directory, then the segments of Levels, the coarsest first, then the input
/// indices in the same order. So any level takes two reads, of the directory and of one segment,
/// which is at most about twice as long as the level, and one more read for its input indices. The
/// beginning of a file is enough for its coarse levels. Each block has a checksum. Numbers are
/// little-endian. If the macro QUADRILLE_WITH_ZSTD is defined (link zstd), blocks are compressed; a
/// program without it can read uncompressed files only.

namespace quadrille {

/// Writes all levels to a file. An existing file is replaced once the new one is complete.
///
/// Throws std::logic_error if nothing has been recorded, and std::runtime_error if the file cannot
/// be written, or is to be compressed without zstd.
inline void write_levels(const std::filesystem::path& path, const Levels& levels,
                         const LevelsFileOptions& options = {});

/// Writes all levels to a binary, seekable stream, from its beginning. The caller must check the
/// state of the stream afterwards.
inline void write_levels(std::ostream& file, const Levels& levels,
                         const LevelsFileOptions& options = {}) {
  internal::LevelsFileWriter(levels, options).write(file);
}

/// A file of levels. Data is checked when it is read: a broken or foreign file is rejected with a
/// std::runtime_error that names the file and the problem, in the constructor or when a level is
/// read.
class LevelsFile {
  // Adds the name of the unreadable file to exceptions.
  template <class Task>
  decltype(auto) checked(Task task) {
    try {
      return task();
    } catch (const std::runtime_error& e) {
      throw std::runtime_error(path_.string() +
                               ": not a file of levels, or a damaged one: " + e.what());
    }
  }

public:
  /// Opens a file and reads its directory, but no level.
  explicit LevelsFile(const std::filesystem::path& path) : path_(path) {
    checked([&] { open(); });
  }

  const std::string& comment() const { return directory_.comment; } ///< as LevelsFileOptions says
  LevelInfo finest() const { return info_of(directory_.stages.front()); }  ///< the input
  LevelInfo coarsest() const { return info_of(directory_.stages.back()); } ///< the last one

  /// Does the same as Levels::at.
  template <class Stop>
  Level at(const Stop& stop) {
    return loaded(stop, true).at(stop);
  }
  /// Does the same as Levels::info.
  template <class Stop>
  LevelInfo info(const Stop& stop) {
    return loaded(stop, false).info(stop);
  }
  /// Does the same as Levels::extract.
  template <class Stop, class Points, class Triangles>
  LevelInfo extract(const Stop& stop, Points& points, Triangles& triangles) {
    return loaded(stop, false).extract(stop, points, triangles);
  }

  /// Reads all levels.
  Levels read() {
    return checked([&] {
      Levels levels = empty_levels();
      for (std::size_t s = 0; s < directory_.segments.size(); ++s) {
        levels.segments_.push_back(read_segment(s));
        levels.begins_.push_back(static_cast<std::size_t>(directory_.stages[s + 1].contractions));
      }
      read_inputs(0, levels);
      return levels;
    });
  }

private:
  using Stage = internal::LevelDirectory::Stage;

  void open() {
    std::error_code error;
    size_ = std::filesystem::file_size(path_, error);
    file_.open(path_, std::ios::binary);
    if (error || !file_)
      throw std::runtime_error("it cannot be opened");
    internal::Bytes header(internal::LevelDirectory::bytes_before);
    file_.read(reinterpret_cast<char*>(header.data()), static_cast<std::streamsize>(header.size()));
    if (!file_ || !std::equal(internal::LevelDirectory::magic.begin(),
                              internal::LevelDirectory::magic.end(), header.begin()))
      throw std::runtime_error("its first bytes are wrong");
    internal::ByteReader reader(
        std::span<const unsigned char>(header).subspan(internal::LevelDirectory::magic.size()));
    if (const auto version = reader.get<std::uint32_t>();
        version != internal::LevelDirectory::version)
      throw std::runtime_error("its version is " + std::to_string(version) +
                               ", and this library reads " +
                               std::to_string(internal::LevelDirectory::version));
    internal::FileBlock block{header.size(), reader.get<std::uint64_t>(), 0, 0, 0};
    block.raw = block.stored;
    block.checksum = reader.get<std::uint32_t>();
    directory_ = internal::LevelDirectory::read(block.read(file_, size_));
  }

  LevelInfo info_of(const Stage& stage) const {
    return internal::level_info(stage.faces, stage.vertices,
                                static_cast<std::size_t>(stage.contractions),
                                static_cast<double>(stage.error), directory_.knows_bounds,
                                directory_.are_bounds_both_ways, static_cast<double>(stage.bound));
  }

  // Returns the segment of a level: the first one that ends with a level that is coarse enough.
  std::size_t segment_of(const FaceCount& stop) const {
    return first_ending([&](const Stage& end) { return end.faces <= stop.faces; });
  }
  std::size_t segment_of(const VertexCount& stop) const {
    return first_ending([&](const Stage& end) { return end.vertices <= stop.vertices; });
  }
  std::size_t segment_of(const ErrorAtMost& stop) const {
    return first_ending(
        [&](const Stage& end) { return static_cast<double>(end.error) > stop.error; });
  }
  std::size_t segment_of(const DistanceAtMost& stop) const {
    return first_ending(
        [&](const Stage& end) { return static_cast<double>(end.bound) > stop.distance; });
  }
  std::size_t segment_of(const AfterContractions& stop) const {
    return first_ending([&](const Stage& end) { return end.contractions >= stop.contractions; });
  }
  template <class IsEnd>
  std::size_t first_ending(IsEnd is_end) const {
    std::size_t s = 0;
    while (s + 1 < directory_.segments.size() && !is_end(directory_.stages[s + 1]))
      ++s;
    return s;
  }

  // Returns Levels with only the segment of a level. The last segment that was read is cached.
  template <class Stop>
  const Levels& loaded(const Stop& stop, bool with_inputs) {
    const std::size_t segment = segment_of(stop);
    return checked([&]() -> const Levels& {
      if (loaded_.empty() || segment != loaded_segment_) {
        Levels loaded = empty_levels();
        loaded.segments_.push_back(read_segment(segment));
        loaded.begins_ = {static_cast<std::size_t>(directory_.stages[segment].contractions),
                          static_cast<std::size_t>(directory_.stages[segment + 1].contractions)};
        loaded_ = std::move(loaded);
        loaded_segment_ = segment;
      }
      if (with_inputs && loaded_.input_faces_.empty())
        read_inputs(segment, loaded_);
      return loaded_;
    });
  }

  Levels empty_levels() const {
    Levels levels;
    levels.begins_ = {0};
    levels.input_vertex_count_ = static_cast<std::size_t>(directory_.input_vertices);
    for (const auto& channel : directory_.channels)
      levels.channels_.push_back({channel.track, channel.offset, channel.components});
    return levels;
  }

  internal::LevelSegment read_segment(std::size_t s) {
    internal::LevelSegment segment =
        internal::SegmentBytes::read(directory_.segments[s].read(file_, size_), directory_.widths);
    const Stage &begin = directory_.stages[s], &end = directory_.stages[s + 1];
    const std::size_t contractions = segment.contractions();
    const auto& vertices = segment.tracks.front();
    if (begin.contractions + contractions != end.contractions || segment.faces() != begin.faces ||
        segment.faces_at(contractions) != end.faces || vertices.items() != begin.vertices ||
        vertices.items_at(contractions) != end.vertices ||
        (contractions > 0 && segment.bounds.empty() == directory_.knows_bounds))
      throw std::runtime_error("a segment does not match the directory");
    return segment;
  }

  // Reads the input indices of the faces and vertices at the beginning of a segment.
  void read_inputs(std::size_t segment, Levels& levels) {
    levels.input_faces_.clear();
    levels.input_vertices_.clear();
    for (std::size_t s = directory_.inputs.size(); s-- > segment;) {
      const internal::Bytes bytes = directory_.inputs[s].read(file_, size_);
      internal::ByteReader reader(bytes);
      for (auto* inputs : {&levels.input_faces_, &levels.input_vertices_}) {
        const auto array = reader.get_array<internal::Index>(reader.get<std::uint32_t>());
        inputs->insert(inputs->end(), array.begin(), array.end());
      }
      if (levels.input_faces_.size() != directory_.stages[s].faces ||
          levels.input_vertices_.size() != directory_.stages[s].vertices)
        throw std::runtime_error("the input indices do not match the directory");
    }
    for (internal::Index v : levels.input_vertices_)
      if (v >= directory_.input_vertices)
        throw std::runtime_error("an input index is out of range");
  }

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  internal::LevelDirectory directory_;
  Levels loaded_;
  std::size_t loaded_segment_ = 0;
};

/// Reads all levels of a file: see LevelsFile.
inline Levels read_levels(const std::filesystem::path& path) {
  return LevelsFile(path).read();
}

inline void write_levels(const std::filesystem::path& path, const Levels& levels,
                         const LevelsFileOptions& options) {
  internal::LevelsFileWriter writer(levels, options);
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  try {
    std::ofstream file(unfinished, std::ios::binary);
    writer.write(file);
    file.close();
    if (!file)
      throw std::runtime_error("it cannot be written");
    std::filesystem::rename(unfinished, path);
  } catch (const std::exception& e) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

} // namespace quadrille

#endif // QUADRILLE_LEVELS_FILE_H
