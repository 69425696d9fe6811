#ifndef QUADRILLE_EXAMPLES_PAGE_MATERIALS_H
#define QUADRILLE_EXAMPLES_PAGE_MATERIALS_H

/// \file
/// What OBJ and PLY files say of the looks of faces: diffuse colours and images.

#include "../mesh_io/formats/material_library.h"
#include "../mesh_io/gltf/base64.h"
#include "../mesh_io/gltf/images.h"
#include "../mesh_io/mesh/indexed_mesh.h"
#include "../mesh_io/text.h"
#include "shown_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// Images of more bytes are not put into a page.
inline constexpr std::size_t most_bytes_of_images = std::size_t{1} << 24;

/// What read() returns; a complaint of it has no path, which a page must not tell everyone.
template <class Read>
std::string read_for_page(Read read) {
  try {
    return read();
  } catch (const std::runtime_error&) {
    throw std::runtime_error("it cannot be read");
  }
}

/// The images of a page, each of them once.
class PageImages {
public:
  explicit PageImages(PageMaterials& looks) : looks_(looks) {}

  /// The number of an image whose bytes read() gives, or nothing and a note.
  template <class Read>
  std::optional<std::size_t> add(const std::string& name, Read read) {
    if (const auto found = numbers_.find(name); found != numbers_.end())
      return found->second;
    return numbers_[name] = load(name, read);
  }

private:
  template <class Read>
  std::optional<std::size_t> load(const std::string& name, Read read) {
    try {
      const std::string bytes = read_for_page(read);
      const std::optional<std::string> type = image_type(bytes);
      if (!type)
        throw std::runtime_error("it is not PNG, JPEG or WebP");
      bytes_ += bytes.size();
      if (bytes_ > most_bytes_of_images)
        throw std::runtime_error("the images of a page may take at most " +
                                 std::to_string(most_bytes_of_images >> 20U) + " MiB in total");
      looks_.images.push_back("data:" + *type + ";base64," + encode_base64(bytes));
      return looks_.images.size() - 1;
    } catch (const std::runtime_error& error) {
      looks_.notes.push_back("The image " + name + " is not shown: " + error.what());
      return std::nullopt;
    }
  }

  PageMaterials& looks_;
  std::map<std::string, std::optional<std::size_t>> numbers_;
  std::size_t bytes_ = 0;
};

/// Reads materials of OBJ: of each `newmtl`, its Kd and map_Kd. A library or an image that is not
/// there becomes a note.
class ObjMaterials {
public:
  ObjMaterials(const std::filesystem::path& mesh, PageMaterials& looks)
      : folder_(mesh.parent_path()), looks_(looks), images_(looks) {}

  void read(const FaceParts& parts) {
    for (const std::string& library : parts.libraries)
      try {
        MaterialLibrary::read(read_for_page([&] { return read_content(folder_ / library); }),
                              materials_);
      } catch (const std::runtime_error& error) {
        looks_.notes.push_back("The materials of " + library + " are not shown: " + error.what());
      }
    if (materials_.empty())
      return;
    looks_.materials.clear();
    std::map<std::uint32_t, std::uint32_t> numbers; // by name
    for (std::size_t face = 0; face < parts.of_faces.size(); ++face) {
      const std::uint32_t name = parts.of(face).material;
      const auto [place, is_new] =
          numbers.try_emplace(name, static_cast<std::uint32_t>(looks_.materials.size()));
      if (is_new)
        looks_.materials.push_back(shown(materials_[parts.names[name]]));
      looks_.of_faces.push_back(place->second);
    }
    if (looks_.materials.empty())
      looks_.materials.emplace_back();
  }

private:
  /// Where there is an image, programs that write files put anything into Kd.
  PageMaterial shown(const ObjMaterial& material) {
    PageMaterial result{.color = material.color};
    if (!material.image.empty())
      result.image =
          images_.add(material.image, [&] { return read_content(folder_ / material.image); });
    if (result.image)
      result.color = {1, 1, 1};
    return result;
  }

  std::filesystem::path folder_;
  PageMaterials& looks_;
  PageImages images_;
  std::map<std::string, ObjMaterial> materials_;
};

/// The image that a PLY file names, if it names one: "comment TextureFile a.png".
inline void read_ply_image(const std::filesystem::path& path, const IndexedMesh& mesh,
                           PageMaterials& looks) {
  if (mesh.texture_comments.size() > 1)
    looks.notes.push_back("Images are not shown: the file has several");
  if (mesh.texture_comments.size() != 1)
    return;
  std::istringstream words(mesh.texture_comments.front());
  std::string keyword, name;
  words >> keyword;
  std::getline(words >> std::ws, name);
  if (equal_ignoring_case(keyword, "TextureFile"))
    looks.materials.front().image =
        PageImages(looks).add(name, [&] { return read_content(path.parent_path() / name); });
}

} // namespace quadrille_examples

#endif
