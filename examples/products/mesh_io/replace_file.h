#ifndef QUADRILLE_EXAMPLES_MESH_IO_REPLACE_FILE_H
#define QUADRILLE_EXAMPLES_MESH_IO_REPLACE_FILE_H

/// \file
/// Writing a file as a whole or not at all, on POSIX systems.

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// Gives a file a new content: all of it or, throwing `std::runtime_error`, nothing.
///
/// The content is written beside the file, and then takes its place: with its mode and owner, and
/// where a symbolic link leads. Where that can't be, since the folder takes no new file or this
/// user can't give the owner, it is written into the file itself, once there is room for all of
/// it. Standard output, a pipe or a device, which has no content to lose, is just written to.
class FileReplacement {
public:
  /// Throws where its folder is missing, and for a file that may not be written to, unless that is
  /// `forced`. Root may write to any:
  /// a file that its mode lets nobody write to is protected from root as well.
  explicit FileReplacement(std::filesystem::path path, bool is_forced = false);

  void write(std::string_view content) const;

private:
  bool is_regular() const { return exists_ && S_ISREG(status_.st_mode); }

  void write_straight(std::string_view content) const;
  /// False, with nothing done, if this is not possible here, but may be in place.
  bool write_beside(std::string_view content) const;
  void write_in_place(std::string_view content) const;

  std::filesystem::path path_;
  std::filesystem::path target_;
  struct ::stat status_ = {};
  bool exists_ = false;
};

/// May a file be written? Throws `std::runtime_error`, "FILE: what", if not.
void require_replaceable(const std::filesystem::path& path, bool is_forced);

/// Gives a file a content: see FileReplacement.
void replace_file(const std::filesystem::path& path, const std::string& content,
                  bool is_forced = false);

} // namespace quadrille_examples

#endif
