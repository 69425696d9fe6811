#ifndef QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
#define QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/job_estimate.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/part_cut.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/stl_weld.h>
#include <quadrille/internal/file/tile_sewing.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The file that is simplified: PLY, or STL whose corners are made vertices first; or tiles of
/// these, which are made one surface first.
class SurfaceSource {
public:
  /// Throws for a file that is nothing that can be read in parts, as far as its beginning tells.
  SurfaceSource(std::vector<std::filesystem::path> paths, bool positions_only, bool keeps_tiles)
      : paths_(std::move(paths)), positions_only_(positions_only), keeps_tiles_(keeps_tiles) {
    if (paths_.empty() || paths_.size() > most_parts)
      throw std::invalid_argument("quadrille::simplify_file: " + std::to_string(paths_.size()) +
                                  " files are no surface; from 1 to " + std::to_string(most_parts) +
                                  " may be tiles of one");
    is_stl_ = has_extension(paths_.front(), ".stl");
    JobKey key;
    for (const std::filesystem::path& path : paths_)
      key.add_file(InputFile(path));
    key.add_number(std::uint64_t{positions_only});
    if (is_tiled())
      key.add_number(std::uint64_t{keeps_tiles});
    key_ = key.value();
    std::uint64_t largest = 0;
    for (std::size_t i = paths_.size(); i-- > 0;) // the first one stays open
      largest = (std::max)(largest, add_size(paths_[i]));
    end_size(largest);
    if (ply_)
      dropped_ = ply_->dropped();
    if (keeps_tiles)
      tiles_in(""); // throws where names are the same
  }

  /// Files of which nothing counts but the shape.
  static SurfaceSource shape_of(std::vector<std::filesystem::path> paths) {
    SurfaceSource source(std::move(paths), true, false);
    source.is_shape_ = true;
    return source;
  }

  std::uint64_t key() const { return key_; } ///< of its content
  /// As far as it is known before anything is read.
  const InputSize& size() const { return size_; }
  /// What vertices have beside their places, and goes along.
  VertexScalars scalars() const { return ply_ ? ply_->scalars() : VertexScalars(); }
  /// What is read over.
  const std::vector<std::string>& dropped() const { return dropped_; }

  /// Is there a surface that has been made of a soup?
  bool is_welded(const JobFolder& folder) const {
    return (is_stl_ || is_tiled()) && std::filesystem::exists(folder.welded(key_));
  }
  /// The surface. Where it has to be welded, that is done now, if it has not been.
  /// `ask()` is called now and then, and may throw.
  template <class Ask>
  const PlyInput& surface(const JobFolder& folder, std::uint64_t memory, const Ask& ask) {
    if (is_stl_ || is_tiled())
      make_surface(folder, memory, ask);
    if (is_shape_)
      ply_->read_shape_only();
    return *ply_;
  }

  /// Where tiles go that are kept. Throws if two have the same name.
  std::vector<std::filesystem::path> tiles_in(const std::filesystem::path& folder) const {
    std::vector<std::filesystem::path> result;
    for (const std::filesystem::path& path : paths_)
      result.push_back(folder / path.filename().replace_extension(".ply"));
    std::vector<std::filesystem::path> sorted = result;
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::adjacent_find(sorted.begin(), sorted.end());
    if (same != sorted.end())
      throw std::invalid_argument("quadrille::simplify_file: two tiles would be " + same->string() +
                                  " in the folder of the output");
    return result;
  }

private:
  bool is_tiled() const { return paths_.size() > 1 || keeps_tiles_; }

  // Returns the faces of this file.
  std::uint64_t add_size(const std::filesystem::path& path) {
    require_readable(path);
    const std::uint64_t faces = is_stl_ ? StlWeld::faces(path) : ply_->faces();
    size_.faces += faces;
    size_.vertices += is_stl_ ? faces / 2 + 2 : ply_->vertices();
    return faces;
  }

  void end_size(std::uint64_t largest) {
    size_.has_labels = keeps_tiles_ || (ply_ && !ply_->labels().empty());
    if (ply_) {
      size_.scalars = ply_->scalars().size();
      size_.row = 3 * (ply_->has_doubles() ? 8 : 4);
      for (const PlyProperty& p : ply_->scalars().properties())
        size_.row += p.type.size;
    }
    if (!is_stl_ && !is_tiled())
      return;
    size_.made = size_.faces * (size_.has_labels ? 17 : 13) + size_.vertices * size_.row;
    size_.making = is_stl_ ? StlWeld::bytes_of_face * largest : 0;
    if (is_tiled())
      size_.making = (std::max)(size_.making + size_.made, is_stl_ ? 2 * size_.made : size_.made);
    size_.keeps_tiles = keeps_tiles_;
  }

  void require_readable(const std::filesystem::path& path) {
    if (has_extension(path, ".stl") != is_stl_)
      fail_file(path, "is no tile of a surface with " + paths_.front().string() +
                          ": all have to be PLY, or all STL");
    if (is_stl_)
      StlWeld::require_readable(path, positions_only_);
    else
      open(path);
    if (is_tiled() && ply_ && !ply_->scalars().textures().empty())
      fail_file(path, "names a texture, which can't go along with tiles; 'positions only' leaves "
                      "it out");
  }

  template <class Ask>
  void make_surface(const JobFolder& folder, std::uint64_t memory, const Ask& ask) {
    const std::filesystem::path welded = folder.welded(key_);
    if (!is_welded(folder) && is_tiled())
      sew_tiles(welded, folder, memory, ask);
    else if (!is_welded(folder))
      StlWeld::run(paths_.front(), welded, folder.welding(), memory, positions_only_, ask);
    ply_ = PlyInput::welded(welded, paths_.front());
  }

  template <class Ask>
  void sew_tiles(const std::filesystem::path& welded, const JobFolder& folder, std::uint64_t memory,
                 const Ask& ask) const {
    std::vector<std::filesystem::path> tiles;
    for (std::size_t i = 0; is_stl_ && i < paths_.size(); ++i) {
      tiles.push_back(folder.welded_tile(i));
      StlWeld::run(paths_[i], tiles[i], folder.welding(), memory, positions_only_, ask);
    }
    TileSewing::run(is_stl_ ? tiles : paths_, paths_, positions_only_, keeps_tiles_, welded);
    for (const std::filesystem::path& tile : tiles)
      std::filesystem::remove(tile);
  }

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

  std::vector<std::filesystem::path> paths_;
  bool positions_only_, keeps_tiles_, is_stl_ = false, is_shape_ = false;
  std::uint64_t key_ = 0;
  InputSize size_;
  std::unique_ptr<PlyInput> ply_;
  std::vector<std::string> dropped_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
