#include "replace_file.h"

#include "text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

namespace {

/// A file that is open for writing.
class OpenFile {
public:
  OpenFile(const std::filesystem::path& path, int flags, mode_t mode = 0)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, mode)) {}
  ~OpenFile() {
    if (is_open())
      ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  /// Makes sure that there is room, where the system can. False if there is none; the file then
  /// has its old size.
  bool reserve(std::size_t size) {
    struct ::stat before = {};
    if (size == 0 || ::fstat(descriptor_, &before) != 0 ||
        !is_lack_of_room(::posix_fallocate(descriptor_, 0, static_cast<off_t>(size))))
      return true;
    static_cast<void>(::ftruncate(descriptor_, before.st_size) == 0);
    return false;
  }

  static bool is_lack_of_room(int error) {
    return error == ENOSPC || error == EDQUOT || error == EFBIG;
  }

  /// False if not all of it could be written.
  bool write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR)
        continue;
      if (written <= 0)
        return false;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  bool truncate(std::size_t size) {
    return ::ftruncate(descriptor_, static_cast<off_t>(size)) == 0;
  }

  /// Takes over owner, group and mode of a file. False if this user may not.
  bool look_like(const struct ::stat& file) {
    struct ::stat own = {};
    if (::fstat(descriptor_, &own) != 0)
      return false;
    const bool is_alike = own.st_uid == file.st_uid && own.st_gid == file.st_gid;
    return (is_alike || ::fchown(descriptor_, file.st_uid, file.st_gid) == 0) &&
           ::fchmod(descriptor_, file.st_mode & 07777U) == 0;
  }

  /// False if something that was written did not reach the file.
  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

private:
  int descriptor_;
};

/// Where a chain of symbolic links leads, be there a file or not.
std::filesystem::path end_of_links(std::filesystem::path path) {
  for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(path)); ++links) {
    if (links == 40)
      throw std::runtime_error("is a symbolic link that leads to itself");
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

void write_to_standard_output(std::string_view content) {
  std::cout.write(content.data(), static_cast<std::streamsize>(content.size()));
  if (!std::cout.flush())
    throw std::runtime_error("cannot be written in full");
}

} // namespace

FileReplacement::FileReplacement(std::filesystem::path path, bool is_forced)
    : path_(std::move(path)) {
  if (is_standard_output(path_))
    return;
  exists_ = ::stat(path_.c_str(), &status_) == 0;
  if (exists_ && S_ISDIR(status_.st_mode))
    throw std::runtime_error("is a folder");
  target_ = exists_ && !is_regular() ? path_ : end_of_links(path_);
  if (const std::filesystem::path folder = target_.parent_path();
      !folder.empty() && !std::filesystem::is_directory(folder))
    throw std::runtime_error("there is no folder " + folder.string());
  const bool is_protected =
      is_regular() && ((status_.st_mode & 0222U) == 0 || ::access(target_.c_str(), W_OK) != 0);
  if (is_protected && !is_forced)
    throw std::runtime_error("is read-only; --force replaces it");
}

void FileReplacement::write(std::string_view content) const {
  if (is_standard_output(path_))
    write_to_standard_output(content);
  else if (exists_ && !is_regular())
    write_straight(content);
  else if (!write_beside(content))
    write_in_place(content);
}

void FileReplacement::write_straight(std::string_view content) const {
  OpenFile file(target_, 0);
  if (!file.is_open())
    throw std::runtime_error("cannot be opened for writing");
  if (!file.write(content) || !file.close())
    throw std::runtime_error("cannot be written in full");
}

bool FileReplacement::write_beside(std::string_view content) const {
  const std::filesystem::path beside =
      target_.parent_path() / (".part" + std::to_string(std::random_device{}()));
  OpenFile file(beside, O_CREAT | O_EXCL, exists_ ? 0600 : 0666);
  if (!file.is_open())
    return exists_ ? false : throw std::runtime_error("cannot be opened for writing");
  const bool is_written = file.write(content);
  const bool is_alike = !exists_ || file.look_like(status_);
  const bool is_done =
      file.close() && is_written && is_alike && ::rename(beside.c_str(), target_.c_str()) == 0;
  if (!is_done)
    ::unlink(beside.c_str());
  if (!is_written)
    throw std::runtime_error("cannot be written in full");
  if (!is_done && !exists_)
    throw std::runtime_error("cannot be opened for writing");
  return is_done;
}

void FileReplacement::write_in_place(std::string_view content) const {
  OpenFile file(target_, 0);
  if (!file.is_open())
    throw std::runtime_error("cannot be opened for writing");
  if (!file.reserve(content.size()) || !file.write(content) || !file.truncate(content.size()) ||
      !file.close())
    throw std::runtime_error("cannot be written in full");
}

void require_replaceable(const std::filesystem::path& path, bool is_forced) {
  try {
    FileReplacement(path, is_forced);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

void replace_file(const std::filesystem::path& path, const std::string& content, bool is_forced) {
  try {
    FileReplacement(path, is_forced).write(content);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

} // namespace quadrille_examples
