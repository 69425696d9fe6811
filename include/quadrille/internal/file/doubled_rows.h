#ifndef QUADRILLE_INTERNAL_FILE_DOUBLED_ROWS_H
#define QUADRILLE_INTERNAL_FILE_DOUBLED_ROWS_H

#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <set>
#include <vector>

namespace quadrille::internal {

/// Returns the corners in cyclic order with the least one first: the result is equal for faces on
/// the same vertices with the same orientation.
template <class Corners>
Corners from_least_corner(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Counts the faces of a chunk that occur again, on the same vertices with the same orientation.
/// Such faces are all in the same chunk. It takes eight bytes for each face.
inline std::uint64_t count_doubled_rows(const std::filesystem::path& path) {
  const InputFile file(path);
  ByteStream stream(file, 0);
  std::vector<std::uint64_t> keys;
  keys.reserve(static_cast<std::size_t>(file.size() / sizeof(FaceRow)));
  while (const char* const bytes = stream.next(sizeof(FaceRow))) {
    FaceRow face;
    std::memcpy(face.data(), bytes, sizeof(face));
    const auto [a, b, c] = from_least_corner(face);
    const std::uint64_t key = (std::uint64_t{a} << 32 | b) * 0x9E3779B97F4A7C15U;
    // two different keys collide once in 2^64
    keys.push_back((key ^ key >> 29) + c * 0xD1B54A32D192ED03U);
  }
  std::sort(keys.begin(), keys.end());
  return static_cast<std::uint64_t>(keys.end() - std::unique(keys.begin(), keys.end()));
}

/// Keeps only the first one, with its label, of faces on the same vertices with the same
/// orientation.
template <class Face>
void remove_doubled(std::vector<Face>& faces, std::vector<std::uint32_t>& labels) {
  std::set<Face> seen;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (seen.insert(from_least_corner(faces[f])).second) {
      faces[kept] = faces[f];
      if (!labels.empty())
        labels[kept] = labels[f];
      ++kept;
    }
  faces.resize(kept);
  labels.resize((std::min)(labels.size(), kept));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_DOUBLED_ROWS_H
