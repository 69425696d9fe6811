#ifndef QUADRILLE_INTERNAL_FILE_PLY_CONVERSION_H
#define QUADRILLE_INTERNAL_FILE_PLY_CONVERSION_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/ply_rows.h>
#include <quadrille/internal/core/surface/polygon_cut.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/written_vertices.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille::internal {

/// Converts a PLY file that is text, has polygons, or has lists in unsuitable places to binary PLY
/// of triangles, in the order of the file. It reads the file twice; for quadrilaterals and larger
/// polygons it also reads some of the written vertices. Faces with fewer than three different
/// corners are left out, as in memory.
class PlyConversion {
public:
  /// `ask()` is called about once a second or more often, and may throw.
  template <class Ask>
  static void run(const PlyInput& input, const std::filesystem::path& output, std::uint64_t memory,
                  const Ask& ask) {
    WholeFile file(output);
    PlyConversion conversion(input, file, memory);
    conversion.put_header();
    conversion.put_vertices(ask);
    conversion.put_faces(ask);
    file.finish();
  }

  /// Estimates the number of triangles from some of the first faces.
  static std::uint64_t triangles(const PlyInput& input) {
    constexpr std::uint64_t looked_at = 1000;
    std::uint64_t faces = 0, triangles = 0;
    rows(input).for_items(input.face_element(),
                          [&](std::uint64_t, const PlyRows::Row& row, const auto&) {
                            const std::size_t corners = row[input.corners_property()].size();
                            triangles += corners < 3 ? 0 : corners - 2;
                            return ++faces < looked_at;
                          });
    return faces == 0 ? 0
                      : static_cast<std::uint64_t>(static_cast<double>(input.faces()) *
                                                   static_cast<double>(triangles) /
                                                   static_cast<double>(faces));
  }

private:
  PlyConversion(const PlyInput& input, WholeFile& file, std::uint64_t memory)
      : input_(input), file_(file), bytes_(file), memory_(memory) {
    const auto places = [](const PlyElement& element, const std::vector<PlyProperty>& properties) {
      std::vector<std::size_t> result;
      for (const PlyProperty& p : properties)
        result.push_back(*element.find({p.name}));
      return result;
    };
    const PlyType number{input.has_doubles() ? std::size_t{8} : std::size_t{4}, false, true};
    row_ = {{"x", number, {}}, {"y", number, {}}, {"z", number, {}}};
    const std::vector<PlyProperty>& scalars = input.scalars().properties();
    row_.insert(row_.end(), scalars.begin(), scalars.end());
    row_places_ = places(input.vertex_element(), row_);
    label_places_ = places(input.face_element(), input.labels());
  }

  static PlyRows rows(const PlyInput& input) { return {input.file(), input.header()}; }

  // The header has the same length for any number of faces, which is not known before the end.
  std::string header() const {
    constexpr std::uint64_t any = 999'999'999'999;
    std::string text =
        ply_header(input_.vertices(), input_.has_doubles(), input_.scalars().properties(), any,
                   input_.labels(), made_.comment());
    const std::string digits = std::to_string(faces_);
    const std::string place = std::to_string(any);
    text.replace(text.find(place), place.size(),
                 std::string(place.size() - digits.size(), '0') + digits);
    return text;
  }
  void put_header() {
    bytes_.put_text(header());
    vertices_begin_ = header().size();
  }

  template <class Ask>
  void put_vertices(const Ask& ask) {
    rows(input_).for_items(input_.vertex_element(),
                           [&](std::uint64_t v, const PlyRows::Row& row, const auto&) {
                             if (v % often == 0)
                               ask();
                             for (std::size_t i = 0; i < row_.size(); ++i)
                               bytes_.put_as(row_[i].type, row[row_places_[i]][0]);
                             return true;
                           });
    bytes_.flush();
    std::size_t size = 0;
    for (const PlyProperty& p : row_)
      size += p.type.size;
    written_ = std::make_unique<WrittenVertices>(file_.unfinished(), vertices_begin_, size,
                                                 input_.has_doubles(), memory_ / 2);
  }

  template <class Ask>
  void put_faces(const Ask& ask) {
    rows(input_).for_items(input_.face_element(),
                           [&](std::uint64_t f, const PlyRows::Row& row, const auto& fail) {
                             if (f % often == 0)
                               ask();
                             take_corners(row[input_.corners_property()], fail);
                             if (corners_.size() >= 3)
                               put_polygon(row);
                             else
                               ++made_.short_faces;
                             return true;
                           });
    bytes_.flush();
    const std::string text = header();
    file_.write_at_begin(text.data(), text.size());
  }

  // Takes the corners without those that repeat the one before.
  template <class Fail>
  void take_corners(const std::vector<double>& list, const Fail& fail) {
    corners_.clear();
    for (const double corner : list) {
      if (!(corner >= 0 && corner < static_cast<double>(input_.vertices())))
        fail("has vertex " + std::to_string(static_cast<std::int64_t>(corner)) + " of " +
             std::to_string(input_.vertices()));
      const auto v = static_cast<VertexId>(corner);
      if (corners_.empty() || corners_.back() != v)
        corners_.push_back(v);
    }
    while (corners_.size() > 1 && corners_.front() == corners_.back())
      corners_.pop_back();
  }

  void put_polygon(const PlyRows::Row& row) {
    places_.clear();
    for (const VertexId v : corners_)
      places_.push_back(corners_.size() == 3 ? Vector<3>{} : written_->position(v));
    for (const auto& [a, b, c] : PolygonCut::triangles(places_, &made_.fans)) {
      bytes_.put_corners({corners_[a], corners_[b], corners_[c]});
      for (std::size_t i = 0; i < label_places_.size(); ++i)
        bytes_.put_integer(input_.labels()[i].type,
                           static_cast<std::int64_t>(row[label_places_[i]][0]));
      ++faces_;
    }
  }

  // The number of items between two calls of `ask`.
  static constexpr std::uint64_t often = 1 << 16;

  const PlyInput& input_;
  WholeFile& file_;
  PlyBytes bytes_;
  std::uint64_t memory_, faces_ = 0, vertices_begin_ = 0;
  MadeCounts made_;
  std::vector<PlyProperty> row_; // of a vertex
  std::vector<std::size_t> row_places_, label_places_;
  std::unique_ptr<WrittenVertices> written_;
  std::vector<VertexId> corners_; // of a polygon
  std::vector<Vector<3>> places_; // of these corners
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_CONVERSION_H
