#ifndef QUADRILLE_EXAMPLES_GLTF_BUFFERS_H
#define QUADRILLE_EXAMPLES_GLTF_BUFFERS_H

#include "accessor.h"
#include "document.h"
#include "json.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// New bytes of buffer views, by their numbers.
using NewViewBytes = std::map<std::size_t, std::string>;

/// Puts a buffer together anew of what its buffer views refer to, which are told where that is. Old
/// views that overlap go on doing so.
class BufferPacking {
public:
  static void pack(GltfDocument& document, const NewViewBytes& new_bytes) {
    for (std::size_t i = 0; i < document.buffers.size(); ++i) {
      BufferPacking packing(document, i);
      packing.add_old_views(new_bytes);
      packing.add_new_views(new_bytes);
      if (packing.packed_.empty()) // a buffer has to have a byte
        packing.pad_to(alignment);
      document.buffers[i] = std::move(packing.packed_);
    }
  }

private:
  static constexpr std::size_t alignment = 8; // that of what has the greatest components

  BufferPacking(GltfDocument& document, std::size_t buffer)
      : document_(document), buffer_(buffer) {}

  Json& view(std::size_t index) { return document_.json["bufferViews"][index]; }
  bool is_here(std::size_t index) { return count_of(view(index), "buffer") == buffer_; }

  void add_old_views(const NewViewBytes& new_bytes) {
    std::vector<std::pair<std::size_t, std::size_t>> views; // offsets, numbers
    for (std::size_t i = 0; i < size_of(document_.json, "bufferViews"); ++i)
      if (is_here(i) && !new_bytes.contains(i))
        views.emplace_back(count_of(view(i), "byteOffset", 0), i);
    std::sort(views.begin(), views.end());
    const std::string& old = document_.buffers[buffer_];
    std::size_t end = 0; // in the old buffer, of what has been taken
    for (const auto& [offset, index] : views) {
      if (offset > end || packed_.empty()) {
        pad_to(offset % alignment);
        end = offset;
      }
      const std::size_t place = packed_.size() - (end - offset);
      const std::size_t view_end = offset + count_of(view(index), "byteLength");
      if (view_end > end) {
        packed_.append(old, end, view_end - end);
        end = view_end;
      }
      view(index)["byteOffset"] = place;
    }
  }

  void add_new_views(const NewViewBytes& new_bytes) {
    for (const auto& [index, bytes] : new_bytes) {
      if (!is_here(index))
        continue;
      pad_to(0);
      view(index)["byteOffset"] = packed_.size();
      view(index)["byteLength"] = bytes.size();
      packed_ += bytes;
    }
  }

  /// Goes on to the next place of such a remainder.
  void pad_to(std::size_t remainder) {
    if (remainder == alignment)
      packed_.resize(alignment, '\0');
    while (packed_.size() % alignment != remainder % alignment)
      packed_ += '\0';
  }

  GltfDocument& document_;
  std::size_t buffer_;
  std::string packed_;
};

} // namespace quadrille_examples

#endif
