#ifndef QUADRILLE_INTERNAL_LEVELS_SEGMENT_BYTES_H
#define QUADRILLE_INTERNAL_LEVELS_SEGMENT_BYTES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/levels/bytes.h>
#include <quadrille/internal/levels/level_track.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

/// A segment of levels as bytes: counts, then arrays.
///
///     u32 contractions, faces; f32 error before, bound before; u8 bounds are known, 2 if both ways
///     [contractions] faces that go, as u8 after a 1, or as u32 after a 4
///     f32 [contractions] errors; bounds, if they are known
///     each track: u32 items, parents, changes; u8 bytes of a number, 4 or 8
///       u32 [faces] the corners, three arrays
///       f32 or f64 [items] the numbers, an array each
///       u32 [parents] what items become
///       [contractions] items that go; changes, both as the faces that go
///       u32 [changes] the items that change; f32 or f64 [changes] their numbers, an array each
class SegmentBytes {
public:
  /// Writes numbers as doubles, or as floats if that is requested or changes none of them.
  static Bytes write(const LevelSegment& segment, bool rounds_to_floats) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(segment.contractions()));
    writer.put(static_cast<std::uint32_t>(segment.faces()));
    writer.put(segment.error_before);
    writer.put(segment.bound_before);
    writer.put(static_cast<std::uint8_t>(segment.bounds.empty()         ? 0
                                         : segment.are_bounds_both_ways ? 2
                                                                        : 1));
    put_small(steps_down(segment.faces_after, segment.faces()), writer);
    writer.put_array(segment.errors);
    writer.put_array(segment.bounds);
    for (const LevelTrack& track : segment.tracks)
      write(track, rounds_to_floats, writer);
    return writer.take();
  }

  /// Throws std::runtime_error for bytes that are not a segment.
  static LevelSegment read(const Bytes& bytes, const std::vector<std::size_t>& widths) {
    ByteReader reader(bytes);
    LevelSegment segment;
    const auto contractions = reader.get<std::uint32_t>();
    const auto faces = reader.get<std::uint32_t>();
    segment.error_before = reader.get<float>();
    segment.bound_before = reader.get<float>();
    const auto known = reader.get<std::uint8_t>();
    segment.are_bounds_both_ways = known == 2;
    segment.faces_after = sums_down(get_small(contractions, reader), faces);
    segment.errors = reader.get_array<float>(contractions);
    segment.bounds = reader.get_array<float>(known != 0 ? contractions : 0);
    for (std::size_t width : widths)
      segment.tracks.push_back(read_track(width, contractions, faces, reader));
    require(reader.left() == 0, "a segment is longer than its header says");
    require_ascending(segment.errors, segment.error_before);
    require_ascending(segment.bounds, segment.bound_before);
    for (const LevelTrack& track : segment.tracks)
      require_parents(segment, track);
    require_steps(segment.tracks.front());
    return segment;
  }

private:
  static void require(bool is_right, const char* what) {
    if (!is_right)
      throw std::runtime_error(what);
  }

  // Returns the decrease of an array from each number to the next, which is small.
  static std::vector<Index> steps_down(const std::vector<Index>& array, std::size_t before) {
    std::vector<Index> steps;
    steps.reserve(array.size());
    auto last = static_cast<Index>(before);
    for (Index value : array) {
      steps.push_back(last - value);
      last = value;
    }
    return steps;
  }
  static std::vector<Index> sums_down(std::vector<Index> steps, std::size_t before) {
    auto last = static_cast<Index>(before);
    for (Index& step : steps) {
      require(step <= last, "a count falls below 0");
      step = last -= step;
    }
    return steps;
  }
  static std::vector<Index> steps_up(const std::vector<Index>& array) {
    std::vector<Index> steps;
    steps.reserve(array.size());
    Index last = 0;
    for (Index value : array) {
      steps.push_back(value - last);
      last = value;
    }
    return steps;
  }
  static std::vector<Index> sums_up(std::vector<Index> steps, std::size_t most) {
    std::size_t sum = 0;
    for (Index& step : steps) {
      sum += step;
      require(sum <= most, "there are fewer changes than the header says");
      step = static_cast<Index>(sum);
    }
    return steps;
  }

  // Writes small numbers, in a byte each if that is enough.
  static void put_small(const std::vector<Index>& array, ByteWriter& writer) {
    const bool are_bytes =
        std::all_of(array.begin(), array.end(), [](Index value) { return value < 256; });
    writer.put(static_cast<std::uint8_t>(are_bytes ? 1 : 4));
    if (are_bytes)
      writer.put_array(std::vector<std::uint8_t>(array.begin(), array.end()));
    else
      writer.put_array(array);
  }
  static std::vector<Index> get_small(std::size_t count, ByteReader& reader) {
    if (reader.get<std::uint8_t>() != 1)
      return reader.get_array<Index>(count);
    const std::vector<std::uint8_t> bytes = reader.get_array<std::uint8_t>(count);
    return {bytes.begin(), bytes.end()};
  }

  static bool are_floats(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  }

  template <class T>
  static void write_numbers(const std::vector<double>& values, std::size_t width,
                            ByteWriter& writer) {
    for (std::size_t k = 0; k < width; ++k) {
      std::vector<T> array;
      array.reserve(values.size() / width);
      for (std::size_t i = k; i < values.size(); i += width)
        array.push_back(static_cast<T>(values[i]));
      writer.put_array(array);
    }
  }
  template <class T>
  static std::vector<double> read_numbers(std::size_t count, std::size_t width,
                                          ByteReader& reader) {
    require(count <= reader.left() / width, "it ends too early");
    std::vector<double> values(count * width);
    for (std::size_t k = 0; k < width; ++k) {
      const std::vector<T> array = reader.get_array<T>(count);
      for (std::size_t i = 0; i < count; ++i) {
        values[i * width + k] = static_cast<double>(array[i]);
        require(std::isfinite(array[i]), "a number is not finite");
      }
    }
    return values;
  }

  static void write(const LevelTrack& track, bool rounds_to_floats, ByteWriter& writer) {
    const bool as_floats =
        rounds_to_floats || (are_floats(track.values) && are_floats(track.changed_values));
    const auto write_all = [&](const std::vector<double>& values) {
      if (as_floats)
        write_numbers<float>(values, track.width, writer);
      else
        write_numbers<double>(values, track.width, writer);
    };
    writer.put(static_cast<std::uint32_t>(track.items()));
    writer.put(static_cast<std::uint32_t>(track.parents.size()));
    writer.put(static_cast<std::uint32_t>(track.changed.size()));
    writer.put(static_cast<std::uint8_t>(as_floats ? 4 : 8));
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Index> array;
      array.reserve(track.corners.size());
      for (const auto& corners : track.corners)
        array.push_back(corners[k]);
      writer.put_array(array);
    }
    write_all(track.values);
    writer.put_array(track.parents);
    put_small(steps_down(track.items_after, track.items()), writer);
    put_small(steps_up(track.change_ends), writer);
    writer.put_array(track.changed);
    write_all(track.changed_values);
  }

  static LevelTrack read_track(std::size_t width, std::size_t contractions, std::size_t faces,
                               ByteReader& reader) {
    LevelTrack track;
    track.width = width;
    const auto items = reader.get<std::uint32_t>();
    const auto parents = reader.get<std::uint32_t>();
    const auto changes = reader.get<std::uint32_t>();
    const auto bytes = reader.get<std::uint8_t>();
    require(bytes == 4 || bytes == 8, "its numbers have an unknown size");
    const auto read_all = [&](std::size_t count) {
      return bytes == 4 ? read_numbers<float>(count, width, reader)
                        : read_numbers<double>(count, width, reader);
    };
    std::array<std::vector<Index>, 3> arrays;
    for (auto& array : arrays)
      array = reader.get_array<Index>(faces);
    track.corners.resize(faces);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t f = 0; f < faces; ++f) {
        require((track.corners[f][k] = arrays[k][f]) < items, "a corner is out of range");
      }
    track.values = read_all(items);
    track.parents = reader.get_array<Index>(parents);
    track.items_after = sums_down(get_small(contractions, reader), items);
    track.change_ends = sums_up(get_small(contractions, reader), changes);
    track.changed = reader.get_array<Index>(changes);
    track.changed_values = read_all(changes);
    require_consistent(track);
    return track;
  }

  static void require_consistent(const LevelTrack& track) {
    const std::size_t first = track.items_at(track.items_after.size());
    require(track.items() - first == track.parents.size(), "its items do not add up");
    require((track.change_ends.empty() ? 0 : track.change_ends.back()) == track.changed.size(),
            "its changes do not add up");
    for (std::size_t i = 0; i < track.parents.size(); ++i)
      require(track.parents[i] == none || track.parents[i] < first + i,
              "an item is replaced by one that was removed");
    for (Index item : track.changed)
      require(item < track.items(), "a change is out of range");
  }

  static void require_ascending(const std::vector<float>& array, float before) {
    for (float value : array) {
      require(value >= before, "an error decreases"); // false for a NaN
      before = value;
    }
  }

  // Requires that the corners of a face exist as long as the face.
  static void require_parents(const LevelSegment& segment, const LevelTrack& track) {
    const std::size_t first = track.items() - track.parents.size();
    std::vector<Index> last(track.items()); // the item that each one finally becomes
    for (Index i = 0; i < last.size(); ++i)
      last[i] = i < first || track.parents[i - first] == none ? i : last[track.parents[i - first]];
    std::vector<Index> end(track.items(), static_cast<Index>(segment.contractions()));
    std::vector<Index> face_end(segment.faces(), static_cast<Index>(segment.contractions()));
    for (std::size_t i = segment.contractions(); i-- > 0;) {
      for (std::size_t v = track.items_after[i]; v < track.items_at(i); ++v)
        end[v] = static_cast<Index>(i);
      for (std::size_t f = segment.faces_after[i]; f < segment.faces_at(i); ++f)
        face_end[f] = static_cast<Index>(i);
    }
    for (std::size_t f = 0; f < segment.faces(); ++f)
      for (Index item : track.corners[f])
        require(end[last[item]] >= face_end[f], "a face loses a corner");
  }

  // Requires that a contraction that changes a vertex merges the last remaining vertex into it, and
  // that other vertices removed with it become none. LevelSteps recognizes contractions by this.
  static void require_steps(const LevelTrack& vertices) {
    const std::size_t first = vertices.items() - vertices.parents.size();
    std::size_t begin = 0;
    for (std::size_t i = 0; i < vertices.change_ends.size(); ++i) {
      const std::size_t end = vertices.change_ends[i];
      std::size_t there = vertices.items_at(i);
      bool is_step = end - begin <= 1;
      if (is_step && end > begin)
        is_step = there > vertices.items_after[i] &&
                  vertices.parents[--there - first] == vertices.changed[begin];
      while (there > vertices.items_after[i])
        is_step = vertices.parents[--there - first] == none && is_step;
      require(is_step, "a contraction does not have two vertices");
      begin = end;
    }
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_SEGMENT_BYTES_H
