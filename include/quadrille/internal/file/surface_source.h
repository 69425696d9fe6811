#ifndef QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
#define QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/stl_weld.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille::internal {

/// The file that is simplified: PLY, or STL whose corners are made vertices first.
class SurfaceSource {
public:
  /// Throws for a file that is nothing that can be read in parts, as far as its beginning tells.
  SurfaceSource(const std::filesystem::path& path, bool positions_only)
      : path_(path), positions_only_(positions_only), is_stl_(has_extension(path, ".stl")) {
    JobKey key;
    key.add_file(InputFile(path));
    key.add_number(std::uint64_t{positions_only});
    key_ = key.value();
    if (is_stl_)
      StlWeld::require_readable(path);
    else
      open(path);
  }

  std::uint64_t key() const { return key_; } ///< of its content
  /// What vertices have beside their places, and goes along.
  VertexScalars scalars() const { return ply_ ? ply_->scalars() : VertexScalars(); }
  /// What is read over.
  std::vector<std::string> dropped() const {
    return ply_ ? ply_->dropped() : std::vector<std::string>();
  }

  /// Is there a surface that has been made of a soup?
  bool is_welded(const JobFolder& folder) const {
    return is_stl_ && std::filesystem::exists(folder.welded(key_));
  }
  /// The surface. Where it has to be welded, that is done now, if it has not been.
  const PlyInput& surface(const JobFolder& folder, std::uint64_t memory) {
    if (ply_)
      return *ply_;
    const std::filesystem::path welded = folder.welded(key_);
    if (!is_welded(folder))
      StlWeld::run(path_, welded, folder.welding(), memory);
    open(welded);
    return *ply_;
  }

private:
  static bool has_extension(const std::filesystem::path& path, const std::string& extension) {
    std::string own = path.extension().string();
    std::transform(own.begin(), own.end(), own.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return own == extension;
  }

  void open(const std::filesystem::path& path) {
    ply_ = std::make_unique<PlyInput>(path, positions_only_);
    if (!positions_only_ && !ply_->dropped().empty())
      fail_file(path, "has " + ply_->dropped().front() +
                          ", which can't go along in parts; 'positions only' leaves it out");
  }

  std::filesystem::path path_;
  bool positions_only_, is_stl_;
  std::uint64_t key_ = 0;
  std::unique_ptr<PlyInput> ply_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
