#ifndef QUADRILLE_EXAMPLES_PAGE_FILE_H
#define QUADRILLE_EXAMPLES_PAGE_FILE_H

#include "../mesh_io/gltf/base64.h"
#include "../mesh_io/json_object.h"
#include "attribute_recorder.h"
#include "level_arrays.h"
#include "page_parts.h"
#include "shown_mesh.h"
#include "track.h"

#include <quadrille/levels.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The finest level that a page holds has at most so many faces, unless there is none as coarse:
/// that is a page of 6 MB, in which the slider moves smoothly. doc/manual/page.md says how
/// smoothly.
inline constexpr std::size_t most_faces_of_page = 100'000;

/// What a page is made of.
struct PageSource {
  std::string name; ///< of the file that is shown, in UTF-8
  quadrille::Levels levels;
  RecordedAttributes attributes;
  PageMaterials looks;
};

/// Arrays of numbers of 32 bits, one behind the other.
class PageData {
public:
  void add(std::string_view name, const std::vector<std::uint32_t>& numbers) {
    add(name, "u32", numbers.data(), numbers.size());
  }
  void add(std::string_view name, const std::vector<float>& numbers) {
    add(name, "f32", numbers.data(), numbers.size());
  }
  void add(const std::string& name, const Track& track) {
    add(name + ".corners", "u32", track.corners.data()->data(), 3 * track.corners.size());
    add(name + ".values", track.values);
    add(name + ".parents", track.parents);
    add(name + ".ends", track.ends);
    add(name + ".changeEnds", track.change_ends);
    add(name + ".changed", track.changed);
    add(name + ".changedValues", track.changed_values);
  }

  /// Of each: its type, where it begins and how many numbers it has.
  const JsonObject& places() const { return places_; }
  std::string base64() const { return encode_base64(bytes_); }
  const std::string& bytes() const { return bytes_; }

private:
  template <class T>
  void add(std::string_view name, const char* type, const T* numbers, std::size_t count) {
    places_.add_raw(name, "[" + JsonObject::json_of(type) + "," +
                              JsonObject::json_of(bytes_.size()) + "," +
                              JsonObject::json_of(count) + "]");
    for (std::size_t i = 0; i < count; ++i) {
      const auto bits = std::bit_cast<std::uint32_t>(numbers[i]);
      for (unsigned shift = 0; shift < 32; shift += 8)
        bytes_ += static_cast<char>(bits >> shift & 255U);
    }
  }

  JsonObject places_;
  std::string bytes_;
};

inline std::string escaped_for_html(std::string_view text) {
  std::string html;
  for (const char c : text)
    switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    default:
      html += c;
    }
  return html;
}

inline JsonObject json_object(const PageMaterial& material) {
  JsonObject json;
  json.add("color", material.color);
  if (material.image)
    json.add("image", *material.image);
  if (material.cutoff > 0)
    json.add("cutoff", material.cutoff);
  return json;
}

/// The header: see viewer.js.
inline std::string page_header(const PageSource& source, const LevelArrays& arrays,
                               const PageFrame& frame, const PageData& data) {
  const RecordedAttributes& attributes = source.attributes;
  const std::size_t color = attributes.has_colors ? 4 : 0;
  const std::size_t texture = attributes.has_textures ? 4 + (color > 0 ? 3U : 0U) : 0;
  JsonObject places;
  places.add("color", color);
  places.add("texture", texture);
  const bool is_colored =
      attributes.has_colors || source.looks.materials != std::vector<PageMaterial>{PageMaterial{}};
  std::vector<JsonObject> materials;
  for (const PageMaterial& material : source.looks.materials)
    materials.push_back(json_object(material));
  JsonObject header;
  header.add("name", source.name);
  header.add("inputFaces", source.levels.finest().faces);
  header.add("faces", arrays.faces);
  header.add("width", arrays.vertices.width);
  header.add("places", places);
  header.add("isColored", is_colored);
  header.add("materials", materials);
  header.add("images", source.looks.images);
  header.add("notes", source.looks.notes);
  header.add("center", frame.center.coordinates);
  header.add("unit", frame.unit);
  header.add("arrays", data.places());
  return header.text();
}

/// What the viewer shows.
struct PageContent {
  std::string header; ///< JSON
  PageData data;
  std::size_t faces = 0; ///< of the finest level
};

inline PageContent page_content(const PageSource& source) {
  LevelArraysBuilder builder(source.levels, source.attributes);
  const LevelArrays arrays = builder.build(most_faces_of_page);
  PageData data;
  data.add("facesAfter", arrays.faces_after);
  data.add("errors", arrays.errors);
  data.add("vertices", arrays.vertices);
  if (arrays.textures.width > 0)
    data.add("textures", arrays.textures);
  if (source.looks.materials.size() > 1) {
    std::vector<std::uint32_t> materials;
    for (const std::uint32_t face : arrays.input_faces)
      materials.push_back(source.looks.of_faces[face]);
    data.add("materials", materials);
  }
  std::string header = page_header(source, arrays, builder.frame(), data);
  return {std::move(header), std::move(data), arrays.faces};
}

struct EncodedPage {
  std::string content;   ///< of a file
  std::size_t faces = 0; ///< of the finest level
};

inline EncodedPage encode_page(const PageSource& source) {
  const PageContent content = page_content(source);
  std::string page(page_parts[0]);
  page += escaped_for_html(source.name);
  page += page_parts[1];
  page += content.header;
  page += page_parts[2];
  page += content.data.base64();
  page += page_parts[3];
  return {std::move(page), content.faces};
}

} // namespace quadrille_examples

#endif
