#ifndef QUADRILLE_INTERNAL_LEVELS_LEVELS_FILE_WRITER_H
#define QUADRILLE_INTERNAL_LEVELS_LEVELS_FILE_WRITER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/levels/bytes.h>
#include <quadrille/internal/levels/level_directory.h>
#include <quadrille/internal/levels/segment_bytes.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file_options.h>

#include <cstddef>
#include <cstdint>
#include <ios>
#include <ostream>
#include <vector>

namespace quadrille::internal {

/// Writes levels to a file: see write_levels.
class LevelsFileWriter {
public:
  LevelsFileWriter(const Levels& levels, const LevelsFileOptions& options)
      : levels_(levels), options_(options) {
    levels.require_any();
    directory_.comment = options.comment;
    directory_.input_vertices = levels.input_vertex_count_;
    directory_.knows_bounds = !levels.segments_.front().bounds.empty();
    directory_.are_bounds_both_ways = levels.segments_.front().are_bounds_both_ways;
    for (const auto& track : levels.segments_.front().tracks)
      directory_.widths.push_back(track.width);
    for (const auto& channel : levels.channels_)
      directory_.channels.push_back({static_cast<std::uint32_t>(channel.track),
                                     static_cast<std::uint32_t>(channel.offset),
                                     static_cast<std::uint32_t>(channel.components)});
    for (std::size_t s = 0; s < levels.segments_.size(); ++s)
      add_stage(levels.begin_of(s));
    add_stage(levels.end_of(levels.segments_.size() - 1));
    directory_.segments.resize(levels.segments_.size());
    directory_.inputs.resize(levels.segments_.size());
  }

  void write(std::ostream& file) {
    std::uint64_t offset = 0;
    const auto put = [&](const Bytes& bytes) {
      const auto block = FileBlock::write(bytes, options_.is_compressed, file, offset);
      offset += block.stored;
      return block;
    };
    write_header(file); // of its final length
    offset = static_cast<std::uint64_t>(file.tellp());
    for (std::size_t s = levels_.segments_.size(); s-- > 0;)
      directory_.segments[s] =
          put(SegmentBytes::write(levels_.segments_[s], options_.rounds_to_floats));
    for (std::size_t s = levels_.segments_.size(); s-- > 0;)
      directory_.inputs[s] = put(inputs(s));
    file.seekp(0);
    write_header(file);
  }

private:
  void add_stage(const Levels::Place& place) {
    const auto& segment = levels_.segments_[place.segment];
    const LevelInfo info = levels_.info(place);
    const bool knows = directory_.knows_bounds;
    directory_.stages.push_back(
        {info.contractions, static_cast<std::uint32_t>(info.faces),
         static_cast<std::uint32_t>(info.vertices),
         static_cast<float>(segment.error_at(place.contractions)),
         knows ? static_cast<float>(segment.bound_at(place.contractions)) : 0});
  }

  void write_header(std::ostream& file) const {
    const Bytes directory = directory_.write();
    ByteWriter header;
    for (unsigned char c : LevelDirectory::magic)
      header.put(c);
    header.put(LevelDirectory::version);
    header.put(std::uint64_t{directory.size()});
    header.put(checksum_of(directory));
    for (const Bytes& bytes : {header.bytes(), directory})
      file.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  }

  // Returns the input indices of the items that are removed in a segment, and for the last segment
  // also of those at its end.
  Bytes inputs(std::size_t s) const {
    const bool is_last = s + 1 == levels_.segments_.size();
    const Stage &begin = directory_.stages[s], &end = directory_.stages[s + 1];
    ByteWriter writer;
    const auto put = [&](const std::vector<Index>& inputs, std::size_t from, std::size_t to) {
      const std::vector<Index> slice(inputs.begin() + static_cast<std::ptrdiff_t>(from),
                                     inputs.begin() + static_cast<std::ptrdiff_t>(to));
      writer.put(static_cast<std::uint32_t>(slice.size()));
      writer.put_array(slice);
    };
    put(levels_.input_faces_, is_last ? 0 : end.faces, begin.faces);
    put(levels_.input_vertices_, is_last ? 0 : end.vertices, begin.vertices);
    return writer.take();
  }

  using Stage = LevelDirectory::Stage;

  const Levels& levels_;
  const LevelsFileOptions& options_;
  LevelDirectory directory_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_LEVELS_FILE_WRITER_H
