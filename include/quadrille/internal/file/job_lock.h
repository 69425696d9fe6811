#ifndef QUADRILLE_INTERNAL_FILE_JOB_LOCK_H
#define QUADRILLE_INTERNAL_FILE_JOB_LOCK_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/job_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace quadrille::internal {

/// The folders that had to be made for a job, and that are removed with it: those up to the scratch
/// folder, and the job's own. The record is written to the marker, which identifies a folder as a
/// job's.
struct JobMarker {
  unsigned levels = 0;
  bool has_folder = false;

  void write(const std::filesystem::path& path) const {
    const std::string text = magic + "levels " + std::to_string(levels) + " folder " +
                             std::to_string(has_folder ? 1 : 0) + "\n";
    WholeFile file = WholeFile::by_any_process(path);
    file.write(text.data(), text.size());
    file.finish();
  }

  static JobMarker read(const std::filesystem::path& path) {
    const InputFile file(path);
    std::string text(static_cast<std::size_t>((std::min<std::uint64_t>)(file.size(), 512)), '\0');
    file.read(0, text.data(), text.size());
    JobMarker marker;
    std::istringstream words(text.substr((std::min)(text.size(), magic.size())));
    std::string levels, folder, more;
    if (text.rfind(magic, 0) != 0 ||
        !(words >> levels >> marker.levels >> folder >> marker.has_folder) || levels != "levels" ||
        folder != "folder" || words >> more)
      fail_file(path, "was changed after it was written, so the owner of this folder is unknown");
    return marker;
  }

private:
  static inline const std::string magic = "quadrille job 1\n";
};

/// The exclusive right to drive a job: one process has it at a time, as long as the object exists.
/// The object makes the folder of the job, and holds a lock that the system releases when the
/// process ends, however it ends (flock(2), which Linux supports on NFS, too). The lock file names
/// the host and the process. If a file system has no locks, the lock is taken over if that process
/// belonged to this host and no longer exists.
class JobLock {
public:
  /// Throws std::runtime_error if another process drives a job there, or if the folder contains
  /// anything that is not a job's.
  explicit JobLock(const JobFolder& folder) : folder_(folder) {
    // Another process that is about to end may remove the folder, or the file, in between.
    for (int tries = 0; !take(); ++tries) {
      if (tries == most_tries)
        fail_file(folder_.scratch(), "another process uses it");
      std::this_thread::sleep_for(a_moment);
    }
  }
  ~JobLock() { close(); }
  JobLock(const JobLock&) = delete;
  JobLock& operator=(const JobLock&) = delete;

  /// Removes what the job has made, and nothing else.
  void remove_job() {
    folder_.remove_phases();
    folder_.remove_welded();
    remove_files_only_if(folder_.path(), [&](const std::string& name) { // files of killed runs
      return name != folder_.marker().filename() && is_job_file(name, {"job", "labels"});
    });
    ::unlink(folder_.lock().c_str());
    ::unlink(folder_.marker().c_str());
    remove_folders();
  }

private:
  static constexpr int most_tries = 100;
  static constexpr std::chrono::milliseconds a_moment{10};
  static inline const std::string owner_begin = "process ";

  // Returns false if the caller should try again.
  bool take() {
    made_ = {};
    make_folders();
    std::error_code error;
    if (!std::filesystem::exists(folder_.path(), error))
      return false;
    require_own();
    descriptor_ = ::open(folder_.lock().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == ENOENT)
      return false;
    if (descriptor_ < 0)
      undo(folder_.lock(), std::string("cannot be opened: ") + std::strerror(errno));
    if (!is_taken()) {
      const std::string owner = read_owner();
      close();
      if (!owner.empty())
        fail_file(folder_.scratch(), owner + " uses it for an unfinished job");
      return false; // it is about to write its name
    }
    if (is_at_its_place())
      return write_owner(), true;
    close();
    return false;
  }

  void make_folders() {
    std::error_code error;
    std::filesystem::path level = folder_.scratch();
    for (; !level.empty() && !std::filesystem::exists(level, error); level = level.parent_path())
      ++made_.levels;
    std::filesystem::create_directories(folder_.scratch(), error);
    if (error)
      undo(folder_.scratch(), "cannot be made: " + error.message());
    made_.has_folder = ::mkdir(folder_.path().c_str(), 0777) == 0;
    if (!made_.has_folder && errno != EEXIST && errno != ENOENT)
      undo(folder_.path(), std::string("cannot be made: ") + std::strerror(errno));
    if (!made_.has_folder)
      return;
    try {
      made_.write(folder_.marker());
    } catch (const std::exception&) {
      remove_folders();
      throw;
    }
  }

  // A folder without a marker must be empty, except for a lock, and gets a marker.
  void require_own() const {
    if (has_marker())
      return static_cast<void>(JobMarker::read(folder_.marker()));
    std::error_code error;
    if (!std::filesystem::is_directory(folder_.path(), error))
      fail_file(folder_.path(),
                "is not a folder, but has the name of a job's folder; move it, or choose another "
                "scratch folder");
    for (std::filesystem::directory_iterator i(folder_.path(), error), end; !error && i != end;
         i.increment(error))
      if (!is_job_file(i->path().filename().string(), {"job"}) && !is_lock(i->path()))
        fail_file(folder_.path(), "does not belong to a job, and has " +
                                      i->path().filename().string() +
                                      " in it; move it, or choose another scratch folder");
    made_.write(folder_.marker());
  }

  // Another process that has just made the folder may be about to write the marker.
  bool has_marker() const {
    std::error_code error;
    for (int tries = 0; tries < 3; ++tries) {
      if (std::filesystem::exists(folder_.marker(), error))
        return true;
      std::this_thread::sleep_for(a_moment);
    }
    return false;
  }

  bool is_lock(const std::filesystem::path& path) const {
    if (path != folder_.lock())
      return false;
    const InputFile file(path);
    std::string text(owner_begin.size(), '\0');
    return file.read_some(0, text.data(), text.size()) == text.size() && text == owner_begin;
  }

  bool is_taken() const {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0)
      return true;
    if (errno == EWOULDBLOCK || errno == EINTR)
      return false;
    return !is_alive(read_owner()); // the file system has no locks
  }

  static bool is_alive(const std::string& owner) {
    std::istringstream words(owner);
    std::string process, of, host;
    ::pid_t number = 0;
    if (!(words >> process >> number >> of >> host) || host != host_name())
      return !owner.empty();
    return number != ::getpid() && (::kill(number, 0) == 0 || errno == EPERM);
  }

  // Its previous owner may have removed the file.
  bool is_at_its_place() const {
    struct ::stat own = {}, there = {};
    return ::fstat(descriptor_, &own) == 0 && ::stat(folder_.lock().c_str(), &there) == 0 &&
           own.st_ino == there.st_ino && own.st_dev == there.st_dev;
  }

  // Returns its first line, once there is one.
  std::string read_owner() const {
    std::array<char, 512> text{};
    const ::ssize_t got = ::pread(descriptor_, text.data(), text.size(), 0);
    const std::string owner(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    const std::size_t end = owner.find('\n');
    return end == std::string::npos ? "" : owner.substr(0, end);
  }

  static std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "this host";
  }

  void write_owner() {
    const std::string owner =
        owner_begin + std::to_string(::getpid()) + " of " + host_name() + "\n";
    if (::ftruncate(descriptor_, 0) != 0 || ::pwrite(descriptor_, owner.data(), owner.size(), 0) !=
                                                static_cast<::ssize_t>(owner.size()))
      undo(folder_.lock(), std::string("cannot be written in full: ") + std::strerror(errno));
    if (!std::filesystem::exists(folder_.marker()))
      made_.write(folder_.marker());
    made_ = JobMarker::read(folder_.marker());
  }

  // Removes what has been made so far.
  [[noreturn]] void undo(const std::filesystem::path& path, const std::string& what) const {
    if (made_.has_folder) {
      ::unlink(folder_.marker().c_str());
      ::unlink(folder_.lock().c_str());
    }
    remove_folders();
    fail_file(path, what);
  }
  void remove_folders() const {
    if (made_.has_folder)
      ::rmdir(folder_.path().c_str());
    std::filesystem::path level = folder_.scratch();
    for (unsigned i = 0; i < made_.levels; ++i, level = level.parent_path())
      ::rmdir(level.c_str());
  }

  void close() {
    if (descriptor_ >= 0)
      ::close(std::exchange(descriptor_, -1));
  }

  JobFolder folder_;
  JobMarker made_;
  int descriptor_ = -1;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_LOCK_H
