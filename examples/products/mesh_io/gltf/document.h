#ifndef QUADRILLE_EXAMPLES_GLTF_DOCUMENT_H
#define QUADRILLE_EXAMPLES_GLTF_DOCUMENT_H

/// \file
/// glTF 2.0 documents and the files that they are in.
///
/// A document stays the JSON text that it was, of which a program changes what it means to change:
/// so all the rest goes through, extensions and extras that nobody here knows as well. A library
/// that makes structs of a document and a document of structs drops what it has no field for.

#include "../text.h"
#include "base64.h"
#include "decompression.h"
#include "json.h"

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// What a document is made of: its text, and the bytes of its buffers.
struct GltfDocument {
  Json json;
  std::vector<std::string> buffers;
  std::string compression = {}; ///< how it was compressed: "meshopt" or "draco"; else empty

  /// How many bytes the buffers have.
  std::size_t size() const {
    std::size_t sum = 0;
    for (const std::string& buffer : buffers)
      sum += buffer.size();
    return sum;
  }
};

/// The parts of a binary file, .glb.
struct GlbChunks {
  std::string_view json, binary;
  bool has_others = false; ///< of types that glTF does not say
};

inline constexpr std::string_view glb_magic = "glTF";
inline constexpr std::string_view glb_json = "JSON";
inline constexpr std::string_view glb_binary{"BIN\0", 4};
inline constexpr std::size_t glb_header_size = 12;      // magic, version, length
inline constexpr std::size_t glb_chunk_header_size = 8; // length, type

inline GlbChunks glb_chunks(std::string_view bytes) {
  if (bytes.size() < glb_header_size)
    throw std::runtime_error("the file ends within its header");
  if (const auto version = little_endian_at<std::uint32_t>(bytes, 4); version != 2)
    throw std::runtime_error("GLB of version " + std::to_string(version) + ", not 2");
  const std::size_t length = little_endian_at<std::uint32_t>(bytes, 8);
  if (length > bytes.size())
    throw std::runtime_error("the file is cut off: it has " + std::to_string(bytes.size()) +
                             " of the " + std::to_string(length) +
                             " bytes that its header declares");
  GlbChunks chunks;
  for (std::size_t at = glb_header_size; at < length;) {
    if (length - at < glb_chunk_header_size)
      throw std::runtime_error("the file ends within the header of a chunk");
    const std::size_t size = little_endian_at<std::uint32_t>(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    at += glb_chunk_header_size;
    if (size > length - at)
      throw std::runtime_error("a chunk extends beyond the end of the file");
    if (type == glb_json && !chunks.json.data())
      chunks.json = bytes.substr(at, size);
    else if (type == glb_binary && !chunks.binary.data())
      chunks.binary = bytes.substr(at, size);
    else
      chunks.has_others = true;
    at += size;
  }
  return chunks;
}

/// The name of a file that a URI says, with %20 and the like as they are meant.
inline std::string decoded_uri(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto is_digit = [&](std::size_t k) {
      return k < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[k]));
    };
    if (uri[i] != '%' || !is_digit(i + 1) || !is_digit(i + 2)) {
      name += uri[i];
      continue;
    }
    name += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
    i += 2;
  }
  if (name.find('\0') != std::string::npos || name.find("://") != std::string::npos)
    throw std::runtime_error("the URI " + in_quotes(uri) + " does not name a file");
  return name;
}

/// What a URI stands for: the bytes that are in it, or a file beside the document.
inline std::string bytes_of_uri(const std::string& uri, const std::filesystem::path& document) {
  if (!uri.starts_with("data:"))
    return read_content(document.parent_path() / decoded_uri(uri));
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
    throw std::runtime_error("a data URI that is not base64");
  return decode_base64(std::string_view(uri).substr(comma + 1));
}

/// Reads documents, with the bytes of all buffers, wherever these are, and uncompressed.
class GltfReader {
public:
  explicit GltfReader(const Source& source) : source_(source) {}

  /// Throws `std::runtime_error` with one line.
  GltfDocument read() {
    const bool is_binary = source_.content.starts_with(glb_magic);
    const GlbChunks chunks =
        is_binary ? glb_chunks(source_.content) : GlbChunks{source_.content, {}, false};
    if (chunks.has_others)
      throw std::runtime_error("it has chunks of unknown types");
    GltfDocument document{parse_json(chunks.json), {}};
    const Json* const asset = member(document.json, "asset");
    if (!asset)
      throw std::runtime_error("not a glTF document: it has no 'asset'");
    if (const std::string version = text_of(*asset, "version"); !version.starts_with("2."))
      throw std::runtime_error("glTF of version " + in_quotes(version) + ", not 2");
    for_each_element(document.json, "buffers", [&](const Json& buffer) {
      document.buffers.push_back(bytes_of(buffer, chunks.binary, document.buffers.size()));
    });
    decompress(document);
    return document;
  }

private:
  /// Do compressed buffer views say what it holds? Where only these do, nothing needs to tell so.
  static bool is_filled_by_decoding(const Json& buffer) {
    const Json* const extensions = member(buffer, "extensions");
    return extensions && (member(*extensions, "EXT_meshopt_compression") ||
                          member(*extensions, "KHR_meshopt_compression"));
  }

  std::string bytes_of(const Json& buffer, std::string_view binary, std::size_t index) const {
    const std::string uri = text_of(buffer, "uri");
    const bool is_chunk = uri.empty() && index == 0 && binary.data();
    if (uri.empty() && !is_chunk && is_filled_by_decoding(buffer))
      return {};
    if (uri.empty() && !is_chunk)
      throw std::runtime_error("buffer " + std::to_string(index) + " has no bytes");
    std::string bytes = is_chunk ? std::string(binary) : bytes_of_uri(uri, source_.path);
    const std::size_t length = count_of(buffer, "byteLength");
    if (bytes.size() < length)
      throw std::runtime_error("buffer " + std::to_string(index) + " is cut off: it has " +
                               std::to_string(bytes.size()) + " of " + std::to_string(length) +
                               " bytes");
    bytes.resize(length);
    return bytes;
  }

  const Source& source_;
};

/// Buffers from `first` on go into the text.
inline std::string json_with_buffers(GltfDocument& document, std::size_t first) {
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    Json& buffer = document.json["buffers"][i];
    buffer["byteLength"] = document.buffers[i].size();
    buffer.erase("uri");
    if (i >= first)
      buffer["uri"] = "data:application/octet-stream;base64," + encode_base64(document.buffers[i]);
  }
  return document.json.dump();
}

/// A document as a text of its own: one file that is whole or not there, without another one beside
/// it that could be missing, or of another run.
inline std::string encode_gltf(GltfDocument document) {
  return json_with_buffers(document, 0) + '\n';
}

/// Makes all buffers one. Views of others than the first go to where their bytes are.
inline void unite_buffers(GltfDocument& document) {
  constexpr std::size_t alignment = 8; // that of what has the greatest components
  std::vector<std::size_t> offsets;
  std::string all;
  for (const std::string& buffer : document.buffers) {
    all.resize((all.size() + alignment - 1) / alignment * alignment, '\0');
    offsets.push_back(all.size());
    all += buffer;
  }
  for (std::size_t i = 0; i < size_of(document.json, "bufferViews"); ++i) {
    Json& view = document.json["bufferViews"][i];
    if (const std::size_t buffer = count_of(view, "buffer"); buffer > 0) {
      view["byteOffset"] = count_of(view, "byteOffset", 0) + offsets.at(buffer);
      view["buffer"] = 0;
    }
  }
  while (document.json["buffers"].size() > 1)
    document.json["buffers"].erase(document.json["buffers"].size() - 1);
  document.buffers = {std::move(all)};
}

/// A document as a binary file, whose buffers are one.
inline std::string encode_glb(GltfDocument document) {
  if (document.buffers.size() > 1)
    unite_buffers(document);
  const auto number = [](std::size_t value) {
    if (value > 0xFFFFFFFF)
      throw std::runtime_error("more bytes than a GLB file can contain");
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(value >> shift & 255U);
    return bytes;
  };
  const auto chunk = [&](std::string_view type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    return number(content.size()) + std::string(type) + content;
  };
  std::string chunks = chunk(glb_json, json_with_buffers(document, 1), ' ');
  if (!document.buffers.empty())
    chunks += chunk(glb_binary, std::move(document.buffers.front()), '\0');
  return std::string(glb_magic) + number(2) + number(glb_header_size + chunks.size()) + chunks;
}

/// As a file of an extension.
inline std::string encode_document(GltfDocument document, const std::string& extension) {
  return equal_ignoring_case(extension, ".glb") ? encode_glb(std::move(document))
                                                : encode_gltf(std::move(document));
}

} // namespace quadrille_examples

#endif
