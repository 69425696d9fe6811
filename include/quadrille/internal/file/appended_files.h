#ifndef QUADRILLE_INTERNAL_FILE_APPENDED_FILES_H
#define QUADRILLE_INTERNAL_FILE_APPENDED_FILES_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The size and checksum that a file must have to be the one that was written.
struct FileContent {
  std::uint64_t size = 0, checksum = 0;

  friend bool operator==(const FileContent&, const FileContent&) = default;
};

/// Files that grow at their ends in turn, one for each chunk. They are open only while a buffer is
/// written to the disk, so there may be more of them than a process may have open.
class AppendedFiles {
public:
  /// The files must not exist yet. `memory` is for all buffers together.
  AppendedFiles(std::vector<std::filesystem::path> paths, std::uint64_t memory)
      : paths_(std::move(paths)), states_(paths_.size()),
        buffer_(static_cast<std::size_t>(std::clamp<std::uint64_t>(
            memory / std::max<std::size_t>(paths_.size(), 1), 1 << 12, 1 << 20))) {}

  void add(std::size_t file, const void* bytes, std::size_t size) {
    std::vector<char>& buffer = states_[file].buffer;
    if (buffer.capacity() == 0)
      buffer.reserve(buffer_ + 256);
    const char* const from = static_cast<const char*>(bytes);
    buffer.insert(buffer.end(), from, from + size);
    if (buffer.size() >= buffer_)
      flush(file);
  }

  /// Writes the remaining buffers and syncs all files, including empty ones. Returns the size and
  /// checksum that each must have.
  std::vector<FileContent> finish() {
    std::vector<FileContent> contents;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      flush(i);
      sync_to_disk(paths_[i]);
      contents.push_back({states_[i].size, states_[i].checksum.value()});
      states_[i].buffer = {};
    }
    return contents;
  }

private:
  struct State {
    std::vector<char> buffer;
    Checksum checksum;
    std::uint64_t size = 0;
  };

  void flush(std::size_t file) {
    State& state = states_[file];
    append_to_file(paths_[file], state.buffer.data(), state.buffer.size());
    state.checksum.add(state.buffer.data(), state.buffer.size());
    state.size += state.buffer.size();
    state.buffer.clear();
  }

  std::vector<std::filesystem::path> paths_;
  std::vector<State> states_;
  std::size_t buffer_;
};

/// Reads a whole file; throws if it does not have the given size and checksum.
template <class Row>
std::vector<Row> read_rows(const std::filesystem::path& path, const FileContent& content) {
  const InputFile file(path);
  if (file.size() != content.size || content.size % sizeof(Row) != 0)
    fail_file(path, "has " + std::to_string(file.size()) + " bytes instead of the " +
                        std::to_string(content.size) + " that were written");
  std::vector<Row> rows(static_cast<std::size_t>(content.size / sizeof(Row)));
  file.read(0, rows.data(), rows.size() * sizeof(Row));
  Checksum checksum;
  checksum.add(rows.data(), rows.size() * sizeof(Row));
  if (checksum.value() != content.checksum)
    fail_file(path, "was changed after it was written: its checksum differs");
  return rows;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_APPENDED_FILES_H
