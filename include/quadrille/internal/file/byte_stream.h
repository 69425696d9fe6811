#ifndef QUADRILLE_INTERNAL_FILE_BYTE_STREAM_H
#define QUADRILLE_INTERNAL_FILE_BYTE_STREAM_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace quadrille::internal {

/// The bytes of a file from a given offset on, read in blocks. They are read by read() and not by
/// mmap, because mapped pages would count as memory of the process.
class ByteStream {
public:
  ByteStream(const InputFile& file, std::uint64_t offset, std::size_t block = std::size_t{1} << 20)
      : file_(&file), offset_(offset), buffer_(block) {}

  /// Returns the next `count` bytes, which stay valid until the next call; nullptr if the file ends
  /// before.
  const char* next(std::size_t count) {
    if (end_ - begin_ < count && !fill(count))
      return nullptr;
    const char* const bytes = buffer_.data() + begin_;
    begin_ += count;
    return bytes;
  }

  /// The offset of the next byte in the file.
  std::uint64_t offset() const { return offset_ - (end_ - begin_); }
  /// The checksum of all bytes that were read, including those that have not been requested yet.
  const Checksum& checksum() const { return checksum_; }

private:
  bool fill(std::size_t count) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (buffer_.size() < count)
      buffer_.resize(count);
    const std::size_t got = file_->read_some(offset_, buffer_.data() + end_, buffer_.size() - end_);
    checksum_.add(buffer_.data() + end_, got);
    offset_ += got;
    end_ += got;
    return end_ >= count;
  }

  const InputFile* file_;
  std::uint64_t offset_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  Checksum checksum_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_BYTE_STREAM_H
