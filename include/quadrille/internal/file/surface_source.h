#ifndef QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
#define QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H

#include <quadrille/internal/file/chunk_cut.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/job_estimate.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/ply_conversion.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/stl_weld.h>
#include <quadrille/internal/file/tile_merge.h>
#include <quadrille/internal/file/vertex_weld.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The file that is simplified: binary PLY of triangles; or a file that is converted to it first,
/// which is PLY of another kind or STL, whose corners become vertices; or tiles of these kinds,
/// which are merged into one surface first.
class SurfaceSource {
public:
  /// Throws for a file that cannot be simplified in chunks, as far as its beginning shows. With
  /// `welds`, vertices at exactly the same position are merged, whatever the kind of the file.
  SurfaceSource(std::vector<std::filesystem::path> paths, ScalarChoice choice, bool keeps_tiles,
                bool welds)
      : paths_(std::move(paths)), choice_(std::move(choice)), keeps_tiles_(keeps_tiles),
        welds_(welds) {
    if (paths_.empty() || paths_.size() > most_chunks)
      throw std::invalid_argument("quadrille::simplify_file: " + std::to_string(paths_.size()) +
                                  " files were given, but a surface has from 1 to " +
                                  std::to_string(most_chunks) + " tiles");
    kinds_.resize(paths_.size());
    JobKey key;
    for (const std::filesystem::path& path : paths_)
      key.add_file(InputFile(path));
    key.add_number(std::uint64_t{choice_.positions_only});
    key.add_text(choice_.tolerance);
    if (is_tiled())
      key.add_number(std::uint64_t{keeps_tiles});
    if (welds)
      key.add_number(std::uint64_t{welds});
    key_ = key.value();
    std::uint64_t making = 0;
    for (std::size_t i = paths_.size(); i-- > 0;) // the first one stays open
      making = (std::max)(making, add_file(i));
    end_size(making);
    if (ply_)
      dropped_ = ply_->dropped();
    if (keeps_tiles)
      tiles_in(""); // throws if two names are the same
  }

  /// Reads only the shape of the files, and a scalar of tolerances, if it has a name.
  static SurfaceSource shape_of(std::vector<std::filesystem::path> paths,
                                const std::string& tolerance = {}) {
    SurfaceSource source(std::move(paths), {true, tolerance}, false, false);
    source.is_shape_ = true;
    return source;
  }

  std::uint64_t key() const { return key_; } ///< the key of its content
  /// The size as far as it is known before anything is read.
  const InputSize& size() const { return size_; }
  /// The numbers of vertices in addition to their positions, which are simplified with them.
  VertexScalars scalars() const { return ply_ ? ply_->scalars() : VertexScalars(); }
  /// The data that is skipped.
  const std::vector<std::string>& dropped() const { return dropped_; }

  /// Does a surface exist that has been made from the input?
  bool is_made(const JobFolder& folder) const {
    return has_to_be_made() && std::filesystem::exists(folder.welded(key_));
  }
  /// Returns the surface. If it has to be made and has not been, it is made now. `ask()` is called
  /// now and then, and may throw.
  template <class Ask>
  const PlyInput& surface(const JobFolder& folder, std::uint64_t memory, const Ask& ask) {
    if (has_to_be_made())
      make_surface(folder, memory, ask);
    if (is_shape_)
      ply_->read_shape_only();
    return *ply_;
  }

  /// Returns the paths of the kept tiles. Throws if two have the same name.
  std::vector<std::filesystem::path> tiles_in(const std::filesystem::path& folder) const {
    std::vector<std::filesystem::path> result;
    for (const std::filesystem::path& path : paths_)
      result.push_back(folder / path.filename().replace_extension(".ply"));
    std::vector<std::filesystem::path> sorted = result;
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::adjacent_find(sorted.begin(), sorted.end());
    if (same != sorted.end())
      throw std::invalid_argument("quadrille::simplify_file: two tiles would be written to " +
                                  same->string() + " in the folder of the output");
    return result;
  }

private:
  // The kind of a file. Vertices of a soup have to be merged, because each face has its own, or
  // because the user asked for it; other PLY is text, or has polygons.
  enum class Kind { ready, other_ply, soup, other_soup, stl };

  bool is_tiled() const { return paths_.size() > 1 || keeps_tiles_; }
  bool has_to_be_made() const { return is_tiled() || is_any_made(); }
  bool is_any_made() const {
    return std::any_of(kinds_.begin(), kinds_.end(), [](Kind k) { return k != Kind::ready; });
  }

  // Returns the number of bytes on the disk while the file is prepared.
  std::uint64_t add_file(std::size_t i) {
    const std::filesystem::path& path = paths_[i];
    if (has_extension(path, ".stl") != has_extension(paths_.front(), ".stl"))
      fail_file(path, "cannot be a tile of the same surface as " + paths_.front().string() +
                          ": all tiles have to be PLY, or all STL");
    return has_extension(path, ".stl") ? add_stl(i) : add_ply(i);
  }
  std::uint64_t add_stl(std::size_t i) {
    kinds_[i] = Kind::stl;
    if (!choice_.tolerance.empty())
      fail_without_tolerance(paths_[i], {});
    StlWeld::require_readable(paths_[i], choice_.positions_only);
    const std::uint64_t faces = StlWeld::faces(paths_[i]);
    size_.faces += faces;
    size_.vertices += faces / 2 + 2;
    return StlWeld::bytes_of_face * faces;
  }
  std::uint64_t add_ply(std::size_t i) {
    open(paths_[i]);
    const bool is_ready = ply_->is_ready(), is_loose = VertexWeld::is_soup(*ply_);
    const bool is_soup = is_loose || (welds_ && !is_tiled()); // tiles are merged before
    kinds_[i] = is_soup    ? is_ready ? Kind::soup : Kind::other_soup
                : is_ready ? Kind::ready
                           : Kind::other_ply;
    const std::uint64_t faces = is_ready ? ply_->faces() : PlyConversion::triangles(*ply_);
    size_.faces += faces;
    size_.vertices += is_loose ? faces / 2 + 2 : ply_->vertices();
    return (is_ready ? 0 : bytes_of(faces, ply_->vertices())) +
           (is_soup ? weld_bytes(ply_->vertices()) : 0);
  }

  // The size of a file that is made.
  std::uint64_t bytes_of(std::uint64_t faces, std::uint64_t vertices) const {
    std::uint64_t row = 12, face = 13;
    if (ply_) {
      row = 3 * (ply_->has_doubles() ? 8 : 4);
      for (const PlyProperty& p : ply_->scalars().properties())
        row += p.type.size;
      for (const PlyProperty& p : ply_->labels())
        face += p.type.size;
    }
    return faces * (keeps_tiles_ ? face + 4 : face) + vertices * row;
  }

  std::uint64_t weld_bytes(std::uint64_t vertices) const {
    return VertexWeld::bytes_of_vertex(ply_ && ply_->has_doubles()) * vertices;
  }

  // `making` is the greatest size of files while one is prepared.
  void end_size(std::uint64_t making) {
    size_.has_labels = keeps_tiles_ || (ply_ && !ply_->labels().empty());
    if (ply_) {
      size_.scalars = ply_->scalars().size();
      size_.row = bytes_of(0, 1);
    }
    if (!has_to_be_made())
      return;
    size_.made = bytes_of(size_.faces, size_.vertices);
    size_.making = making;
    if (is_tiled())
      size_.making =
          (std::max)(size_.making + size_.made, is_any_made() ? 2 * size_.made : size_.made);
    if (is_tiled() && welds_)
      size_.making = (std::max)(size_.making, size_.made + weld_bytes(size_.vertices));
    size_.keeps_tiles = keeps_tiles_;
  }

  template <class Ask>
  void make_surface(const JobFolder& folder, std::uint64_t memory, const Ask& ask) {
    const std::filesystem::path made = folder.welded(key_);
    if (!is_made(folder) && is_tiled())
      make_tiled(made, folder, memory, ask);
    else if (!is_made(folder))
      make_ready(0, made, folder, memory, ask);
    const bool is_welded = is_tiled() || (kinds_[0] != Kind::ready && kinds_[0] != Kind::other_ply);
    ply_ = PlyInput::made(made, paths_.front(), is_welded);
  }

  template <class Ask>
  void make_ready(std::size_t i, const std::filesystem::path& output, const JobFolder& folder,
                  std::uint64_t memory, const Ask& ask) const {
    if (kinds_[i] == Kind::stl)
      return StlWeld::run(paths_[i], output, folder.welding(), memory, choice_.positions_only, ask);
    const PlyInput input(paths_[i], choice_);
    if (kinds_[i] == Kind::other_ply)
      return PlyConversion::run(input, output, memory, ask);
    if (kinds_[i] == Kind::soup)
      return VertexWeld::run(input, output, folder.welding(), memory, ask);
    const std::filesystem::path triangles = folder.welded_tile(paths_.size());
    PlyConversion::run(input, triangles, memory, ask);
    VertexWeld::run(*PlyInput::made(triangles, paths_[i], false), output, folder.welding(), memory,
                    ask);
    std::filesystem::remove(triangles);
  }

  template <class Ask>
  void make_tiled(const std::filesystem::path& output, const JobFolder& folder,
                  std::uint64_t memory, const Ask& ask) const {
    if (!welds_)
      return merge_tiles(output, folder, memory, ask);
    const std::filesystem::path merged = folder.welded_tile(paths_.size());
    merge_tiles(merged, folder, memory, ask);
    VertexWeld::run(*PlyInput::made(merged, paths_.front(), true), output, folder.welding(), memory,
                    ask);
    std::filesystem::remove(merged);
  }

  template <class Ask>
  void merge_tiles(const std::filesystem::path& output, const JobFolder& folder,
                   std::uint64_t memory, const Ask& ask) const {
    std::vector<std::filesystem::path> tiles = paths_;
    for (std::size_t i = 0; i < paths_.size(); ++i)
      if (kinds_[i] != Kind::ready) {
        tiles[i] = folder.welded_tile(i);
        make_ready(i, tiles[i], folder, memory, ask);
      }
    TileMerge::run(tiles, paths_, choice_, keeps_tiles_, output);
    for (std::size_t i = 0; i < paths_.size(); ++i)
      if (kinds_[i] != Kind::ready)
        std::filesystem::remove(tiles[i]);
  }

  static bool has_extension(const std::filesystem::path& path, const std::string& extension) {
    std::string own = path.extension().string();
    std::transform(own.begin(), own.end(), own.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return own == extension;
  }

  void open(const std::filesystem::path& path) {
    ply_ = std::make_unique<PlyInput>(path, choice_);
    if (!choice_.tolerance.empty() && !ply_->scalars().tolerance())
      fail_without_tolerance(path, ply_->scalars());
    if (!choice_.positions_only && !ply_->dropped().empty())
      fail_file(path, "has " + ply_->dropped().front() +
                          ", which cannot be kept out of core; 'positions only' leaves it out");
    if (is_tiled() && !ply_->scalars().textures().empty())
      fail_file(
          path,
          "refers to a texture, which cannot be kept with tiles; 'positions only' leaves it out");
  }

  [[noreturn]] void fail_without_tolerance(const std::filesystem::path& path,
                                           const VertexScalars& scalars) const {
    std::string names;
    for (const PlyProperty& p : scalars.properties())
      if (scalars.place_of(p.name))
        names += (names.empty() ? "" : ", ") + p.name;
    fail_file(path, "its vertices have no scalar " + choice_.tolerance + " for tolerances" +
                        (names.empty() ? "; they have none at all, but those of a PLY file can"
                                       : "; they have " + names));
  }

  std::vector<std::filesystem::path> paths_;
  std::vector<Kind> kinds_; // of the files
  ScalarChoice choice_;
  bool keeps_tiles_, welds_, is_shape_ = false;
  std::uint64_t key_ = 0;
  InputSize size_;
  std::unique_ptr<PlyInput> ply_;
  std::vector<std::string> dropped_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SURFACE_SOURCE_H
