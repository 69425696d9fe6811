#ifndef QUADRILLE_INTERNAL_FILE_PLY_INPUT_H
#define QUADRILLE_INTERNAL_FILE_PLY_INPUT_H

#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/label_table.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/ply_rows.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/vertex_scalars.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Which scalars of a file are read in addition to positions, corners and labels.
struct ScalarChoice {
  bool positions_only = false; ///< no numbers of vertices,
  std::string tolerance = {};  ///< except the scalar of this name
};

/// A PLY file whose vertices and faces are read one after another, as often as needed, if it is
/// binary and has triangles only. It is never in memory as a whole.
///
/// In addition to positions and corners it has scalars of vertices, labels of faces, and other
/// data, which dropped() lists; scalars are among these if only positions are to be read. Functions
/// throw std::runtime_error with the file's name and the number of the item.
class PlyInput {
public:
  explicit PlyInput(const std::filesystem::path& path, const ScalarChoice& choice = {})
      : PlyInput(InputFile(path), choice) {}
  /// Opens a file that was made from another one, by whose name the user knows it. `is_welded` says
  /// that it was made from a soup, whose corners at one position are one vertex.
  static std::unique_ptr<PlyInput> made(const std::filesystem::path& path,
                                        const std::filesystem::path& from, bool is_welded) {
    std::unique_ptr<PlyInput> input(new PlyInput(InputFile(path, from), {}));
    input->is_welded_ = is_welded;
    return input;
  }
  /// From now on labels are skipped, and vertices that no other face has are accepted.
  void read_shape_only() {
    labels_.clear();
    is_welded_ = true;
  }
  PlyInput(const PlyInput&) = delete;
  PlyInput& operator=(const PlyInput&) = delete;

  const InputFile& file() const { return file_; }
  bool is_welded() const { return is_welded_; }
  /// Can for_vertices() and for_faces() read it? Otherwise it is text, or has faces that are not
  /// triangles, or lists before the data to be read: see PlyConversion.
  bool is_ready() const { return is_placed_ && has_triangles_only(); }
  const PlyFileHeader& header() const { return header_; }
  const PlyElement& vertex_element() const { return *vertices_; }
  const PlyElement& face_element() const { return *faces_; }
  std::size_t corners_property() const { return corners_; } ///< its index in the element
  std::uint64_t vertices() const { return vertices_->count; }
  std::uint64_t faces() const { return faces_->count; }
  bool has_doubles() const { return coordinates_[0].type.size == 8; }
  /// The numbers of vertices in addition to their positions.
  const VertexScalars& scalars() const { return scalars_; }
  /// The integers of faces, which are their labels, except the flags of MeshLab.
  const std::vector<PlyProperty>& labels() const { return labels_; }
  /// The properties and elements that are skipped.
  const std::vector<std::string>& dropped() const { return dropped_; }

  /// Is a property of faces a component of their colour?
  static bool is_color(std::string_view name) {
    return name == "red" || name == "green" || name == "blue" || name == "alpha";
  }

  /// Calls take(id, position), or take(id, position, scalars), for each vertex in turn. Returns a
  /// checksum of all that was read, which is the same the next time if the file is.
  template <class Take>
  std::uint64_t for_vertices(Take take) const {
    return header_.is_swapped() ? for_vertices_as<true>(take) : for_vertices_as<false>(take);
  }

  /// Calls take(number, corners, values of labels) for each face in turn.
  template <class Take>
  std::uint64_t for_faces(Take take) const {
    return header_.is_swapped() ? for_faces_as<true>(take) : for_faces_as<false>(take);
  }

private:
  PlyInput(InputFile file, const ScalarChoice& choice) : file_(std::move(file)), header_(file_) {
    place_elements();
    place_coordinates(choice);
    place_corners(choice.positions_only);
  }

  struct Placed {
    PlyType type;
    std::size_t offset = 0; // in the row
  };

  // Determines where vertices and faces begin, if the data before them determines that.
  void place_elements() {
    std::optional<std::uint64_t> offset = header_.size;
    if (header_.is_text)
      offset.reset();
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex" && !vertices_) {
        vertices_ = &element;
        vertices_begin_ = offset.value_or(0);
      } else if (element.name == "face" && !faces_) {
        faces_ = &element;
        faces_begin_ = offset.value_or(0);
      } else if (element.count > 0) {
        dropped_.push_back("element " + element.name);
      }
      is_placed_ = is_placed_ && offset;
      const auto size = &element == faces_ ? triangle_size(element) : element.row_size();
      if (!(vertices_ && faces_))
        offset = offset && size ? std::optional(*offset + element.count * *size) : std::nullopt;
    }
    if (!vertices_ || !faces_)
      fail_file(file_.path(), "has no elements 'vertex' and 'face'");
    if (!vertices_->row_size())
      fail_file(file_.path(), "its vertices have lists");
    if (vertices_->count > most_vertex_ids)
      fail_file(file_.path(), "has " + std::to_string(vertices_->count) +
                                  " vertices, more than the indices of faces can express");
    if (is_placed_)
      require_size();
  }

  // The size of a face if its corners are its only list; a face without exactly three corners is
  // rejected later.
  static std::optional<std::size_t> triangle_size(const PlyElement& faces) {
    std::size_t size = 0;
    for (const PlyProperty& p : faces.properties)
      if (is_corners(p))
        size += p.count_type->size + 3 * p.type.size;
      else if (p.is_list())
        return std::nullopt;
      else
        size += p.type.size;
    return size;
  }

  // The size of the file if all faces are triangles, as far as it is known.
  std::optional<std::uint64_t> size_with_triangles() const {
    std::uint64_t size = header_.size;
    for (const PlyElement& element : header_.elements) {
      const auto row = &element == faces_ ? triangle_size(element) : element.row_size();
      if (!row)
        return std::nullopt;
      size += element.count * *row;
    }
    return size;
  }

  // The size of the file usually decides. Otherwise faces are read up to the first that is not a
  // triangle; its faults are reported later.
  bool has_triangles_only() const {
    if (size_with_triangles() == file_.size())
      return true;
    bool is_so = true;
    try {
      PlyRows(file_, header_)
          .for_items(*faces_, [&](std::uint64_t, const PlyRows::Row& row, auto&) {
            return is_so = row[corners_].size() == 3;
          });
    } catch (const std::runtime_error&) {
    }
    return is_so;
  }

  static bool is_corners(const PlyProperty& p) {
    return (p.name == "vertex_indices" || p.name == "vertex_index") && p.is_list();
  }

  // Data that is certainly missing is reported at once, not after hours.
  void require_size() const {
    const std::uint64_t vertices_end = vertices_begin_ + vertices_->count * *vertices_->row_size();
    const std::uint64_t least = (std::max)(vertices_end, faces_begin_ + faces_->count);
    if (file_.size() < least)
      fail_file(file_.path(), "ends at byte " + std::to_string(file_.size()) + "; with " +
                                  std::to_string(vertices_->count) + " vertices and " +
                                  std::to_string(faces_->count) +
                                  " faces it would have more than " + std::to_string(least));
  }

  void place_coordinates(const ScalarChoice& choice) {
    std::vector<PlyProperty> scalars;
    std::size_t offset = 0;
    std::size_t found = 0;
    for (const PlyProperty& p : vertices_->properties) {
      const bool is_coordinate = p.name == "x" || p.name == "y" || p.name == "z";
      if (is_coordinate) {
        coordinates_[static_cast<std::size_t>(p.name[0] - 'x')] = {p.type, offset};
        ++found;
      } else if (choice.positions_only && p.name != choice.tolerance) {
        dropped_.push_back("property " + p.name + " of vertices");
      } else {
        scalars.push_back(p);
        scalar_places_.push_back({p.type, offset});
      }
      offset += p.type.size;
    }
    scalars_ = VertexScalars(std::move(scalars));
    scalars_.set_tolerance(choice.tolerance);
    if (!choice.positions_only)
      scalars_.set_textures(header_.texture_comments());
    else
      for (const std::string& texture : header_.texture_comments())
        dropped_.push_back(texture);
    if (scalars_.channels() > VertexScalars::most_channels)
      fail_file(file_.path(), "its vertices have " + std::to_string(scalars_.channels()) +
                                  " different attributes; out of core, at most " +
                                  std::to_string(VertexScalars::most_channels) +
                                  " can be kept; 'positions only' leaves them out");
    if (found != 3)
      fail_file(file_.path(), "its vertices have no x, y and z");
    for (const Placed& c : coordinates_)
      if (c.type.is_integer || !(c.type == coordinates_[0].type))
        fail_file(file_.path(), "coordinates are neither all floats nor all doubles");
  }

  void place_corners(bool positions_only) {
    std::size_t number = 0;
    corners_ = faces_->properties.size();
    for (const PlyProperty& p : faces_->properties) {
      if (is_corners(p))
        corners_ = number;
      else if (is_label(p) && !(positions_only && is_color(p.name)))
        labels_.push_back(p);
      else
        dropped_.push_back("property " + p.name + " of faces");
      ++number;
    }
    if (corners_ == faces_->properties.size())
      fail_file(file_.path(), "its faces have no list vertex_indices");
    if (!faces_->properties[corners_].type.is_integer)
      fail_file(file_.path(), "its vertex_indices are not integers");
  }

  static bool is_label(const PlyProperty& p) {
    return !p.is_list() && p.type.is_integer && p.name != "flags";
  }
  bool takes_label(const PlyProperty& p) const {
    return std::any_of(labels_.begin(), labels_.end(),
                       [&](const PlyProperty& label) { return label.name == p.name; });
  }

  // Data after the faces and vertices is skipped, and then the file must be at its end.
  template <bool is_swapped>
  void require_end(ByteStream& stream) const {
    if (vertices_ < faces_)
      return require_end_after<is_swapped>(*faces_, stream);
    ByteStream after(file_, vertices_begin_ + vertices_->count * *vertices_->row_size());
    require_end_after<is_swapped>(*vertices_, after);
  }
  template <bool is_swapped>
  void require_end_after(const PlyElement& last, ByteStream& stream) const {
    for (const PlyElement* e = &last + 1; e < header_.elements.data() + header_.elements.size();
         ++e)
      for (std::uint64_t i = 0; i < e->count; ++i)
        for (const PlyProperty& p : e->properties)
          if (!skip<is_swapped>(stream, p))
            fail_short(e->name.c_str(), i, *e);
    if (stream.offset() != file_.size())
      fail_file(file_.path(), "goes on after the last element, from byte " +
                                  std::to_string(stream.offset()) + " on");
  }
  template <bool is_swapped>
  static bool skip(ByteStream& stream, const PlyProperty& p) {
    double count = 1;
    if (p.is_list()) {
      const char* const bytes = stream.next(p.count_type->size);
      if (!bytes)
        return false;
      count = ply_number<is_swapped>(*p.count_type, bytes);
    }
    for (; count > 0; --count)
      if (!stream.next(p.type.size))
        return false;
    return true;
  }

  template <bool is_swapped, class Take>
  std::uint64_t for_vertices_as(Take& take) const {
    ByteStream stream(file_, vertices_begin_);
    const std::size_t size = *vertices_->row_size();
    std::vector<double> scalars(scalar_places_.size());
    for (std::uint64_t v = 0; v < vertices_->count; ++v) {
      const char* const row = stream.next(size);
      if (!row)
        fail_short("vertex", v, *vertices_);
      Vector<3> position;
      for (std::size_t i = 0; i < 3; ++i)
        position[i] = ply_number<is_swapped>(coordinates_[i].type, row + coordinates_[i].offset);
      if constexpr (std::is_invocable_v<Take, VertexId, const Vector<3>&,
                                        const std::vector<double>&>) {
        for (std::size_t i = 0; i < scalars.size(); ++i)
          scalars[i] =
              ply_number<is_swapped>(scalar_places_[i].type, row + scalar_places_[i].offset);
        take(static_cast<VertexId>(v), position, scalars);
      } else {
        take(static_cast<VertexId>(v), position);
      }
    }
    return stream.checksum().value();
  }

  template <bool is_swapped, class Take>
  std::uint64_t for_faces_as(Take& take) const {
    ByteStream stream(file_, faces_begin_);
    FaceRow corners{};
    LabelValues labels;
    for (std::uint64_t f = 0; f < faces_->count; ++f) {
      labels.clear();
      for (std::size_t p = 0; p < faces_->properties.size(); ++p)
        read_property<is_swapped>(stream, f, p, corners, labels);
      take(f, corners, labels);
    }
    require_end<is_swapped>(stream);
    return stream.checksum().value();
  }

  template <bool is_swapped>
  void read_property(ByteStream& stream, std::uint64_t face, std::size_t number, FaceRow& corners,
                     LabelValues& labels) const {
    const PlyProperty& property = faces_->properties[number];
    std::size_t count = 1;
    if (property.is_list()) {
      const char* const bytes = taken(stream, property.count_type->size, face);
      const double reported = ply_number<is_swapped>(*property.count_type, bytes);
      if (number == corners_ ? reported != 3 : reported < 0)
        fail_file(file_.path(),
                  "face " + std::to_string(face) + " has " +
                      std::to_string(static_cast<std::int64_t>(reported)) +
                      (number == corners_
                           ? " corners, but by the size of the file all faces have three"
                           : " values in '" + property.name + "'"));
      count = static_cast<std::size_t>(reported);
    }
    if (number != corners_) {
      for (; count > 0; --count) {
        const char* const bytes = taken(stream, property.type.size, face);
        if (takes_label(property))
          labels.push_back(static_cast<std::int64_t>(ply_number<is_swapped>(property.type, bytes)));
      }
      return;
    }
    const char* const bytes = taken(stream, 3 * property.type.size, face);
    for (std::size_t i = 0; i < 3; ++i) {
      const double corner = ply_number<is_swapped>(property.type, bytes + i * property.type.size);
      if (!(corner >= 0 && corner < static_cast<double>(vertices_->count)))
        fail_file(file_.path(), "face " + std::to_string(face) + " has vertex " +
                                    std::to_string(static_cast<std::int64_t>(corner)) + " of " +
                                    std::to_string(vertices_->count));
      corners[i] = static_cast<VertexId>(corner);
    }
  }

  const char* taken(ByteStream& stream, std::size_t size, std::uint64_t face) const {
    const char* const bytes = stream.next(size);
    if (!bytes)
      fail_short("face", face, *faces_);
    return bytes;
  }

  [[noreturn]] void fail_short(const char* item, std::uint64_t number,
                               const PlyElement& element) const {
    fail_file(file_.path(), "ends at byte " + std::to_string(file_.size()) + ", within " + item +
                                " " + std::to_string(number) + " of " +
                                std::to_string(element.count));
  }

  InputFile file_;
  PlyFileHeader header_;
  const PlyElement* vertices_ = nullptr; // points into header_
  const PlyElement* faces_ = nullptr;
  std::uint64_t vertices_begin_ = 0, faces_begin_ = 0;
  std::array<Placed, 3> coordinates_;
  VertexScalars scalars_;
  std::vector<Placed> scalar_places_;
  bool is_placed_ = true;   // is it known where both begin?
  std::size_t corners_ = 0; // the index of the property
  std::vector<PlyProperty> labels_;
  std::vector<std::string> dropped_;
  bool is_welded_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_INPUT_H
