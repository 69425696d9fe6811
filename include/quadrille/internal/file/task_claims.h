#ifndef QUADRILLE_INTERNAL_FILE_TASK_CLAIMS_H
#define QUADRILLE_INTERNAL_FILE_TASK_CLAIMS_H

#include <quadrille/internal/file/disk_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Distributes tasks 0 to n − 1 among processes that see one folder: the process that creates the
/// file of a task has it. This requires an answer of the file system but none of another process,
/// however busy these are.
///
/// Each process begins with its own tasks, every p-th of p processes, and then takes the last ones
/// of the others; so two processes ask for the same file only at the end.
class TaskClaims {
public:
  /// The folder must exist, with nothing but claims of these tasks; process < processes.
  TaskClaims(std::filesystem::path folder, std::size_t tasks, std::size_t process,
             std::size_t processes)
      : folder_(std::move(folder)), is_taken_(tasks) {
    for (std::size_t k = 0; k < processes; ++k) {
      const std::size_t begin = order_.size();
      for (std::size_t i = (process + k) % processes; i < tasks; i += processes)
        order_.push_back(i);
      if (k > 0)
        std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.end());
    }
  }

  /// Returns a task that no other process has, or gets; nothing if there is none.
  std::optional<std::size_t> next() {
    while (next_ < order_.size() && !is_ended()) {
      const std::size_t task = order_[next_++];
      if (is_taken_[task])
        continue;
      if (makes(std::to_string(task)))
        return task;
      find_taken();
    }
    return std::nullopt;
  }

  /// After this call no process begins another task.
  void end() const { makes(ended); }

private:
  static constexpr const char* ended = "ended";

  bool is_ended() const {
    std::error_code ignored;
    return std::filesystem::exists(folder_ / ended, ignored);
  }

  bool makes(const std::string& name) const {
    const std::filesystem::path path = folder_ / name;
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST)
      fail_file(path, std::string("cannot be made: ") + std::strerror(errno));
    if (descriptor >= 0)
      ::close(descriptor); // nothing was written, so nothing can be lost
    return descriptor >= 0;
  }

  // Listing the folder is faster than asking for each task.
  void find_taken() {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      std::size_t task = is_taken_.size();
      std::from_chars(name.data(), name.data() + name.size(), task);
      if (task < is_taken_.size())
        is_taken_[task] = true;
    }
  }

  std::filesystem::path folder_;
  std::vector<bool> is_taken_;     // as far as is known
  std::vector<std::size_t> order_; // in which this process asks
  std::size_t next_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_TASK_CLAIMS_H
