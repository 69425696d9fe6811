#ifndef QUADRILLE_EXAMPLES_GLTF_IMAGES_H
#define QUADRILLE_EXAMPLES_GLTF_IMAGES_H

#include "../text.h"
#include "base64.h"
#include "document.h"
#include "json.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The type of an image that browsers show, by its first bytes; nothing for others.
inline std::optional<std::string> image_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG"))
    return "image/png";
  if (bytes.starts_with("\xff\xd8\xff"))
    return "image/jpeg";
  if (bytes.starts_with("RIFF") &&
      bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WEBP"))
    return "image/webp";
  return std::nullopt;
}

/// The type of an image of a document: those, and such as extensions know.
inline std::optional<std::string> gltf_image_type(std::string_view bytes) {
  if (bytes.starts_with("\xabKTX 20\xbb"))
    return "image/ktx2";
  if (bytes.starts_with("DDS "))
    return "image/vnd-ms.dds";
  return image_type(bytes);
}

/// The folder that a file lies in.
inline std::filesystem::path folder_of(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().parent_path();
}

/// The files of images that a document names. They go into it, so that it is whole by itself.
class GltfImageFiles {
public:
  /// Is the image a file?
  static bool is_file(const Json& image) {
    const std::string uri = text_of(image, "uri");
    return !uri.empty() && !uri.starts_with("data:");
  }

  /// Puts the images beside `source` into a document that goes to another file: of .glb as bytes
  /// of its buffer; of .gltf into the text, but not in the same folder, where it finds them.
  /// Those that are not there stay as they are, and those that are no images, of which a remark is
  /// returned.
  static std::vector<std::string> take_in(GltfDocument& document,
                                          const std::filesystem::path& source,
                                          const std::filesystem::path& target,
                                          const std::string& extension) {
    std::vector<std::string> remarks;
    const bool is_binary = equal_ignoring_case(extension, ".glb");
    if (!is_binary && folder_of(source) == folder_of(target))
      return remarks;
    for (std::size_t i = 0; i < size_of(document.json, "images"); ++i) {
      const Json& image = element_of(document.json, "images", i);
      if (!is_file(image))
        continue;
      const std::string uri = text_of(image, "uri");
      const std::optional<std::string> bytes = bytes_of_file(uri, source);
      if (bytes && gltf_image_type(*bytes))
        take_in(document, document.json["images"][i], *bytes, is_binary);
      else if (bytes)
        remarks.push_back("the image " + in_quotes(uri, 100) +
                          " is of an unknown type: OUT refers to it as IN does");
    }
    return remarks;
  }

  /// A further image. Returns its number.
  static std::size_t add(GltfDocument& document, const std::string& name,
                         const std::string& bytes) {
    Json image;
    image["name"] = name;
    take_in(document, image, bytes, true);
    document.json["images"].push_back(std::move(image));
    return document.json["images"].size() - 1;
  }

  /// The same of one that stays a file.
  static std::size_t name(GltfDocument& document, const std::string& file) {
    document.json["images"].push_back({{"uri", encoded_uri(file)}});
    return document.json["images"].size() - 1;
  }

private:
  static std::optional<std::string> bytes_of_file(const std::string& uri,
                                                  const std::filesystem::path& source) {
    try {
      return bytes_of_uri(uri, source);
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
  }

  /// What must not stand in a URI is written as %20 and the like.
  static std::string encoded_uri(const std::string& file) {
    constexpr std::string_view digits = "0123456789ABCDEF", plain = "-._~/";
    std::string uri;
    for (const char c : file) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) || plain.find(c) != std::string_view::npos)
        uri += c;
      else
        uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    }
    return uri;
  }

  static void take_in(GltfDocument& document, Json& image, const std::string& bytes,
                      bool is_binary) {
    const std::optional<std::string> type = gltf_image_type(bytes);
    if (!type)
      throw std::runtime_error("an image of unknown type");
    if (!is_binary) {
      image["uri"] = "data:" + *type + ";base64," + encode_base64(bytes);
      return;
    }
    image.erase("uri");
    image["mimeType"] = *type;
    image["bufferView"] = add_view(document, bytes);
  }

  /// At the end of the first buffer, which is that of a .glb file.
  static std::size_t add_view(GltfDocument& document, const std::string& bytes) {
    if (document.buffers.empty()) {
      document.buffers.emplace_back();
      document.json["buffers"].push_back(Json::object());
    }
    std::string& buffer = document.buffers.front();
    buffer.resize((buffer.size() + 7) / 8 * 8, '\0');
    document.json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    return document.json["bufferViews"].size() - 1;
  }
};

} // namespace quadrille_examples

#endif
