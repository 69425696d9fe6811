#ifndef QUADRILLE_INTERNAL_FILE_TILE_MERGE_H
#define QUADRILLE_INTERNAL_FILE_TILE_MERGE_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The name of the property of faces that stores the tile from which they are.
inline constexpr const char* tile_property = "quadrille_tile";

/// Merges several files, the tiles, into one surface: boundary vertices at exactly the same
/// position, in two tiles or more, become one vertex, the first of them, with the least of their
/// tolerances. Everything else stays as it was, in the order of the files. Memory: 24 bytes for
/// each face of a tile, one tile at a time, and 48 for each boundary vertex.
class TileMerge {
public:
  /// `tiles` are binary PLY, `names` are their names in messages. With `writes_tile_numbers`, faces
  /// get a property, by which TileSplit separates the tiles again.
  static void run(const std::vector<std::filesystem::path>& tiles,
                  const std::vector<std::filesystem::path>& names, const ScalarChoice& choice,
                  bool writes_tile_numbers, const std::filesystem::path& output) {
    TileMerge merger(tiles, names, choice);
    merger.find_merged();
    merger.write(output, writes_tile_numbers);
  }

private:
  using Place = std::array<double, 3>;
  struct BoundaryVertex {
    Place place;
    std::uint64_t tile, id; // among all vertices
    double tolerance;       // 0 if there are none
  };

  TileMerge(const std::vector<std::filesystem::path>& tiles,
            const std::vector<std::filesystem::path>& names, const ScalarChoice& choice)
      : tiles_(tiles), names_(names), choice_(choice), first_(tiles.front(), choice),
        tolerance_(first_.scalars().tolerance()) {
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      const PlyInput tile = open(t);
      require_as_first(tile, t);
      begins_.push_back(vertices_);
      vertices_ += tile.vertices();
      made_ += tile.header().made;
      faces_ += tile.faces();
    }
  }

  // One file is open at a time: there may be more than a process may have open.
  PlyInput open(std::size_t t) const { return PlyInput(tiles_[t], choice_); }

  void require_as_first(const PlyInput& tile, std::size_t t) const {
    const auto same = [](const std::vector<PlyProperty>& a, const std::vector<PlyProperty>& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
        return p.name == q.name && p.type == q.type;
      });
    };
    if (!same(tile.scalars().properties(), first_.scalars().properties()) ||
        !same(tile.labels(), first_.labels()) || tile.has_doubles() != first_.has_doubles())
      fail_file(names_[t], "has other properties, or other types of them, than " +
                               names_[0].string() + ", which belongs to the same surface");
  }

  // How the faces of a tile use a vertex.
  enum class Use : unsigned char { unused, inner, boundary };

  static std::vector<Use> uses_of(const PlyInput& tile) {
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * static_cast<std::size_t>(tile.faces()));
    std::vector<Use> uses(static_cast<std::size_t>(tile.vertices()), Use::unused);
    tile.for_faces([&](std::uint64_t, const FaceRow& face, const LabelValues&) {
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
        return;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = face[i], b = face[(i + 1) % 3];
        edges.push_back(std::uint64_t{(std::min)(a, b)} << 32 | (std::max)(a, b));
        uses[a] = Use::inner;
      }
    });
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
      for (end = i + 1; end < edges.size() && edges[end] == edges[i];)
        ++end;
      if (end == i + 1)
        uses[edges[i] >> 32] = uses[edges[i] & 0xFFFFFFFFU] = Use::boundary;
    }
    return uses;
  }

  void add_boundary(std::size_t t, std::vector<BoundaryVertex>& boundary) const {
    const PlyInput tile = open(t);
    const std::vector<Use> uses = uses_of(tile);
    tile.for_vertices([&](VertexId v, const Vector<3>& p, const std::vector<double>& scalars) {
      if (uses[v] == Use::unused)
        return;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]) ||
          !std::all_of(scalars.begin(), scalars.end(), [](double x) { return std::isfinite(x); }))
        fail_file(names_[t], "vertex " + std::to_string(v) + " has a value that is not finite");
      if (uses[v] == Use::boundary)
        boundary.push_back({{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}, // turns -0 into 0
                            t,
                            begins_[t] + v,
                            tolerance_ ? scalars[*tolerance_] : 0});
    });
  }

  // The first of several vertices at one position is kept. If all of them are of one tile, they
  // stay separate, as the user made them.
  void find_merged() {
    std::vector<BoundaryVertex> boundary;
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      add_boundary(t, boundary);
    std::sort(boundary.begin(), boundary.end(),
              [](const BoundaryVertex& a, const BoundaryVertex& b) {
                return a.place != b.place ? a.place < b.place : a.id < b.id;
              });
    for (std::size_t i = 0, end = 0; i < boundary.size(); i = end) {
      for (end = i + 1; end < boundary.size() && boundary[end].place == boundary[i].place;)
        ++end;
      if (boundary[end - 1].tile != boundary[i].tile)
        merge({boundary.data() + i, end - i});
    }
    std::sort(merged_.begin(), merged_.end());
    std::sort(lowered_.begin(), lowered_.end());
    if (vertices_ - merged_.size() > most_vertex_ids)
      fail_file(names_[0], "and the other tiles have " +
                               std::to_string(vertices_ - merged_.size()) +
                               " vertices, more than the indices of faces can express");
  }

  void merge(std::span<const BoundaryVertex> same) {
    double least = same.front().tolerance;
    for (const BoundaryVertex& other : same.subspan(1)) {
      merged_.emplace_back(other.id, same.front().id);
      least = (std::min)(least, other.tolerance);
    }
    if (least < same.front().tolerance)
      lowered_.emplace_back(same.front().id, least);
  }

  std::vector<std::pair<std::uint64_t, std::uint64_t>>::const_iterator
  found(std::uint64_t id) const {
    return std::lower_bound(merged_.begin(), merged_.end(), std::pair(id, std::uint64_t{0}));
  }
  bool is_merged(std::uint64_t id) const {
    const auto at = found(id);
    return at != merged_.end() && at->first == id;
  }
  // Returns the number of the vertex that a vertex has become.
  std::uint64_t number(std::uint64_t id) const {
    auto at = found(id);
    if (at != merged_.end() && at->first == id) {
      id = at->second;
      at = found(id);
    }
    return id - static_cast<std::uint64_t>(at - merged_.begin());
  }

  void write(const std::filesystem::path& output, bool writes_tile_numbers) const {
    WholeFile file(output);
    PlyBytes bytes(file);
    std::vector<PlyProperty> of_faces = first_.labels();
    if (writes_tile_numbers)
      of_faces.push_back({tile_property, {4, true, true}, {}});
    bytes.put_text(ply_header(vertices_ - merged_.size(), first_.has_doubles(),
                              first_.scalars().properties(), faces_, of_faces, made().comment()));
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      put_vertices(t, bytes);
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      put_faces(t, writes_tile_numbers, bytes);
    bytes.flush();
    file.finish();
  }

  MadeCounts made() const {
    MadeCounts made = made_;
    made.welded += merged_.size();
    return made;
  }

  void put_vertices(std::size_t t, PlyBytes& bytes) const {
    const std::vector<PlyProperty>& properties = first_.scalars().properties();
    const PlyType number{first_.has_doubles() ? std::size_t{8} : std::size_t{4}, false, true};
    auto lowered = std::lower_bound(lowered_.begin(), lowered_.end(), std::pair(begins_[t], 0.0));
    open(t).for_vertices([&](VertexId v, const Vector<3>& p, const std::vector<double>& scalars) {
      if (is_merged(begins_[t] + v))
        return;
      const bool is_lowered = lowered != lowered_.end() && lowered->first == begins_[t] + v;
      for (std::size_t i = 0; i < 3; ++i)
        bytes.put_as(number, p[i]);
      for (std::size_t i = 0; i < scalars.size(); ++i)
        bytes.put_as(properties[i].type,
                     is_lowered && i == *tolerance_ ? lowered->second : scalars[i]);
      lowered += is_lowered ? 1 : 0;
    });
  }

  void put_faces(std::size_t t, bool writes_tile_numbers, PlyBytes& bytes) const {
    const std::vector<PlyProperty>& labels = first_.labels();
    open(t).for_faces([&](std::uint64_t, const FaceRow& face, const LabelValues& values) {
      bytes.put_corners({number(begins_[t] + face[0]), number(begins_[t] + face[1]),
                         number(begins_[t] + face[2])});
      for (std::size_t i = 0; i < values.size(); ++i)
        bytes.put_integer(labels[i].type, values[i]);
      if (writes_tile_numbers)
        bytes.put(static_cast<std::uint32_t>(t));
    });
  }

  const std::vector<std::filesystem::path>&tiles_, &names_;
  const ScalarChoice& choice_;
  PlyInput first_;
  std::optional<std::size_t> tolerance_; // its index among the scalars of a vertex
  std::vector<std::uint64_t> begins_;    // for each tile, the index of its first vertex among all
  std::uint64_t vertices_ = 0, faces_ = 0;
  MadeCounts made_; // of the tiles
  // a vertex, and the one that it has become
  std::vector<std::pair<std::uint64_t, std::uint64_t>> merged_;
  std::vector<std::pair<std::uint64_t, double>> lowered_; // vertices with another's tolerance
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_TILE_MERGE_H
