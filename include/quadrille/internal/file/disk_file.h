#ifndef QUADRILLE_INTERNAL_FILE_DISK_FILE_H
#define QUADRILLE_INTERNAL_FILE_DISK_FILE_H

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

/// \file
/// Access to files by POSIX calls, whose errors become sentences that begin with the file's name.

namespace quadrille::internal {

[[noreturn]] inline void fail_file(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

/// Owns an open file.
class FileDescriptor {
public:
  FileDescriptor(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0)
      fail_file(path, std::string("cannot be opened: ") + std::strerror(errno));
  }
  FileDescriptor(FileDescriptor&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FileDescriptor() { close(); }

  int get() const { return descriptor_; }
  /// Returns false if written data did not reach the file.
  bool close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

private:
  int descriptor_;
};

/// A file that any number of threads can read at any offset.
class InputFile {
public:
  explicit InputFile(const std::filesystem::path& path) : InputFile(path, path) {}
  /// Opens a file that was made from another one, by whose name the user knows it.
  InputFile(const std::filesystem::path& path, std::filesystem::path name)
      : path_(std::move(name)), file_(path, O_RDONLY) {
    struct ::stat status = {};
    if (::fstat(file_.get(), &status) != 0 || !S_ISREG(status.st_mode))
      fail_file(path_, "must be a regular file: it is read several times");
    size_ = static_cast<std::uint64_t>(status.st_size);
    changed_ = status.st_mtim.tv_sec * 1'000'000'000LL + status.st_mtim.tv_nsec;
  }

  const std::filesystem::path& path() const { return path_; } ///< the name that the user knows
  std::uint64_t size() const { return size_; }
  /// The time of the last change, in nanoseconds.
  std::int64_t changed() const { return changed_; }

  /// Reads `size` bytes from `offset` on, or throws.
  void read(std::uint64_t offset, void* to, std::size_t size) const {
    if (read_some(offset, to, size) != size)
      fail_file(path_, "ends at byte " + std::to_string(size_) +
                           ", before the end of the data to be read");
  }
  /// Reads as many bytes as there are.
  std::size_t read_some(std::uint64_t offset, void* to, std::size_t size) const {
    std::size_t done = 0;
    while (done < size) {
      const ::ssize_t got = ::pread(file_.get(), static_cast<char*>(to) + done, size - done,
                                    static_cast<::off_t>(offset + done));
      if (got < 0 && errno == EINTR)
        continue;
      if (got < 0)
        fail_file(path_, std::string("cannot be read: ") + std::strerror(errno));
      if (got == 0)
        break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

private:
  std::filesystem::path path_;
  FileDescriptor file_;
  std::uint64_t size_ = 0;
  std::int64_t changed_ = 0;
};

/// Writes all bytes to an open file, or throws.
inline void write_bytes(const FileDescriptor& file, const std::filesystem::path& path,
                        const void* bytes, std::size_t size) {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const ::ssize_t written = ::write(file.get(), from, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      fail_file(path, std::string("cannot be written in full: ") + std::strerror(errno));
    from += written;
    size -= static_cast<std::size_t>(written);
  }
}

/// Appends to the end of a file, and creates it if it does not exist.
inline void append_to_file(const std::filesystem::path& path, const void* bytes, std::size_t size) {
  FileDescriptor file(path, O_WRONLY | O_CREAT | O_APPEND);
  write_bytes(file, path, bytes, size);
  if (!file.close())
    fail_file(path, std::string("cannot be written in full: ") + std::strerror(errno));
}

/// Makes the written data of a file, or the names in a folder, survive a loss of power.
inline void sync_to_disk(const std::filesystem::path& path) {
  const FileDescriptor file(path, O_RDONLY);
  if (::fsync(file.get()) != 0 && errno != EINVAL && errno != ENOTSUP)
    fail_file(path, std::string("cannot be written in full: ") + std::strerror(errno));
}

/// A file that exists completely or not at all: it is written under a temporary name in the same
/// folder, synced, and renamed. A file that was not finished, because the process was killed, is
/// overwritten the next time.
class WholeFile {
public:
  explicit WholeFile(std::filesystem::path path) : WholeFile(std::move(path), ".unfinished") {}

  /// Returns a file that several processes may be writing.
  static WholeFile by_any_process(std::filesystem::path path) {
    return WholeFile(std::move(path), ".unfinished-" + std::to_string(std::random_device{}()));
  }
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile() {
    if (!is_done_)
      ::unlink(unfinished_.c_str());
  }

  void write(const void* bytes, std::size_t size) {
    write_bytes(file_, unfinished_, bytes, size);
    written_ += size;
  }
  /// Overwrites the beginning.
  void write_at_begin(const void* bytes, std::size_t size) {
    if (::pwrite(file_.get(), bytes, size, 0) != static_cast<::ssize_t>(size))
      fail_file(unfinished_, std::string("cannot be written in full: ") + std::strerror(errno));
  }
  std::uint64_t written() const { return written_; }
  /// The path of the file until it is finished.
  const std::filesystem::path& unfinished() const { return unfinished_; }

  /// Puts the finished file in its place.
  void finish() {
    if ((::fsync(file_.get()) != 0 && errno != EINVAL && errno != ENOTSUP) || !file_.close())
      fail_file(path_, std::string("cannot be written in full: ") + std::strerror(errno));
    if (::rename(unfinished_.c_str(), path_.c_str()) != 0)
      fail_file(path_, std::string("cannot be written: ") + std::strerror(errno));
    is_done_ = true;
    sync_to_disk(path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."));
  }

private:
  WholeFile(std::filesystem::path path, const std::string& suffix)
      : path_(std::move(path)), unfinished_(path_.string() + suffix),
        file_(unfinished_, O_WRONLY | O_CREAT | O_TRUNC) {}

  std::filesystem::path path_, unfinished_;
  FileDescriptor file_;
  std::uint64_t written_ = 0;
  bool is_done_ = false;
};

/// Throws, with the name of the file, if it cannot be written; at the end of hours this would be
/// too late.
inline void require_writable(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    fail_file(path, std::string("cannot be written: ") + std::strerror(EISDIR));
  const auto unfinished = path.string() + ".unfinished-" + std::to_string(std::random_device{}());
  const int descriptor = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0)
    fail_file(path, std::string("cannot be written: ") + std::strerror(errno));
  ::close(descriptor);
  ::unlink(unfinished.c_str());
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_DISK_FILE_H
