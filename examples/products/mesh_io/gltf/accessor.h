#ifndef QUADRILLE_EXAMPLES_GLTF_ACCESSOR_H
#define QUADRILLE_EXAMPLES_GLTF_ACCESSOR_H

#include "../text.h"
#include "document.h"
#include "json.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// How the components of elements are stored.
struct ComponentType {
  std::size_t code = 0, size = 0;
  double greatest = 0; ///< of integers
  bool is_signed = false, is_float = false;
};

inline constexpr ComponentType component_types[] = {
    {5120, 1, 127, true},          {5121, 1, 255},
    {5122, 2, 32767, true},        {5123, 2, 65535},
    {5125, 4, 4294967295., false}, {5126, 4, 0, true, true}};

inline const ComponentType& component_type(const Json& accessor) {
  const std::size_t code = count_of(accessor, "componentType");
  for (const ComponentType& type : component_types)
    if (type.code == code)
      return type;
  throw std::runtime_error("the component type " + std::to_string(code) + " is unknown");
}

/// The numbers of an element.
using Element = std::array<double, 4>;

/// What elements are: how many components they have, and how these are stored.
struct ElementType {
  explicit ElementType(const Json& accessor) : component(component_type(accessor)) {
    constexpr std::array<std::string_view, 4> names{"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::string name = text_of(accessor, "type");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw std::runtime_error("elements of type " + in_quotes(name) +
                               " are neither numbers nor vectors");
    components = static_cast<std::size_t>(found - names.begin()) + 1;
    const Json* const normalized = member(accessor, "normalized");
    is_normalized = normalized && *normalized == Json(true) && !component.is_float;
  }

  /// The same numbers of single precision, which mean themselves.
  ElementType as_floats() const {
    ElementType type = *this;
    type.component = *std::find_if(std::begin(component_types), std::end(component_types),
                                   [](const ComponentType& t) { return t.is_float; });
    type.is_normalized = false;
    return type;
  }

  std::size_t size() const { return components * component.size; }
  /// Are these numbers that can be in between others?
  bool is_continuous() const { return component.is_float || is_normalized; }

  /// A component as it is stored, at an offset.
  double stored_at(std::string_view bytes, std::size_t offset) const {
    switch (component.code) {
    case 5120:
      return static_cast<signed char>(bytes[offset]);
    case 5121:
      return static_cast<unsigned char>(bytes[offset]);
    case 5122:
      return little_endian_at<std::int16_t>(bytes, offset);
    case 5123:
      return little_endian_at<std::uint16_t>(bytes, offset);
    case 5125:
      return little_endian_at<std::uint32_t>(bytes, offset);
    default:
      return double{little_endian_at<float>(bytes, offset)};
    }
  }

  /// What a stored number means.
  double meaning(double stored) const {
    return is_normalized ? std::max(stored / component.greatest, -1.) : stored;
  }
  /// The nearest number that can be stored.
  double stored(double meant) const {
    if (component.is_float)
      return double{static_cast<float>(meant)};
    const double least = component.is_signed ? -component.greatest - !is_normalized : 0;
    return std::clamp(std::round(is_normalized ? meant * component.greatest : meant), least,
                      component.greatest);
  }

  /// Appends a number that can be stored.
  void append(double number, std::string& bytes) const {
    const std::uint32_t bits = component.is_float
                                   ? std::bit_cast<std::uint32_t>(static_cast<float>(number))
                                   : static_cast<std::uint32_t>(static_cast<std::int64_t>(number));
    for (std::size_t i = 0; i < component.size; ++i)
      bytes += static_cast<char>(bits >> (8 * i) & 255U);
  }

  ComponentType component;
  std::size_t components = 1;
  bool is_normalized = false; ///< integers that mean fractions
};

/// The bytes of a buffer that something names, as a buffer view does.
inline std::string_view bytes_of_range(const GltfDocument& document, const Json& view,
                                       const std::string& name) {
  const std::size_t buffer = count_of(view, "buffer");
  const std::size_t offset = count_of(view, "byteOffset", 0), length = count_of(view, "byteLength");
  if (buffer >= document.buffers.size() || offset > document.buffers[buffer].size() ||
      length > document.buffers[buffer].size() - offset)
    throw std::runtime_error(name + " is not within its buffer");
  return std::string_view(document.buffers[buffer]).substr(offset, length);
}

/// The bytes of a buffer view.
inline std::string_view bytes_of_view(const GltfDocument& document, std::size_t index) {
  return bytes_of_range(document, element_of(document.json, "bufferViews", index),
                        "buffer view " + std::to_string(index));
}

/// `count` elements of `size` bytes, one behind the other, that a buffer view has at the
/// `byteOffset` of `place`.
inline std::string packed_elements(const GltfDocument& document, const Json& place,
                                   std::size_t size, std::size_t count) {
  const std::size_t index = count_of(place, "bufferView");
  const std::string_view bytes = bytes_of_view(document, index);
  const std::size_t offset = count_of(place, "byteOffset", 0);
  const std::size_t stride =
      count_of(element_of(document.json, "bufferViews", index), "byteStride", size);
  if (stride < size)
    throw std::runtime_error("buffer view " + std::to_string(index) +
                             " has a stride below the size of its elements");
  if (count == 0 || offset > bytes.size() || bytes.size() - offset < size ||
      (bytes.size() - offset - size) / stride < count - 1)
    throw std::runtime_error(std::to_string(count) + " elements are not within buffer view " +
                             std::to_string(index));
  std::string packed;
  packed.reserve(count * size);
  for (std::size_t i = 0; i < count; ++i)
    packed += bytes.substr(offset + i * stride, size);
  return packed;
}

/// The elements of an accessor.
class Elements {
public:
  /// As many as `needed` says, if it says any. What an accessor without a buffer view has are
  /// zeros, but for those that are sparse; there a large count alone is no reason to believe it.
  Elements(const GltfDocument& document, std::size_t index, std::size_t needed = 0)
      : Elements(document, element_of(document.json, "accessors", index), index, needed) {}

  const ElementType& type() const { return type_; }
  std::size_t size() const { return count_; }
  std::size_t index() const { return index_; }
  std::string name() const { return "accessor " + std::to_string(index_); }

  double stored(std::size_t i, std::size_t component) const {
    return type_.stored_at(bytes_, i * type_.size() + component * type_.component.size);
  }
  /// Of fewer than four components, the others are 0.
  Element operator[](std::size_t i) const {
    Element element{};
    for (std::size_t c = 0; c < type_.components; ++c)
      element[c] = type_.meaning(stored(i, c));
    return element;
  }

  void require_finite() const {
    for (std::size_t i = 0; i < count_ && type_.component.is_float; ++i)
      for (std::size_t c = 0; c < type_.components; ++c)
        if (!std::isfinite(stored(i, c)))
          throw std::runtime_error("element " + std::to_string(i) + " of " + name() +
                                   " is not finite");
  }

private:
  Elements(const GltfDocument& document, const Json& accessor, std::size_t index,
           std::size_t needed)
      : index_(index), type_(accessor), count_(count_of(accessor, "count")) {
    if (needed > 0 && count_ != needed)
      throw std::runtime_error(name() + " has " + std::to_string(count_) + " elements and not " +
                               std::to_string(needed));
    const bool has_view = member(accessor, "bufferView") != nullptr;
    if (!has_view && needed == 0 && count_ > most_without_bytes)
      throw std::runtime_error(name() + " has " + std::to_string(count_) +
                               " elements and no buffer view");
    bytes_ = has_view ? packed_elements(document, accessor, type_.size(), count_)
                      : std::string(count_ * type_.size(), '\0');
    if (const Json* const sparse = member(accessor, "sparse"))
      overwrite(document, *sparse);
  }

  static constexpr std::size_t most_without_bytes = std::size_t{1} << 24U;

  /// Puts the elements that a sparse accessor says in place of others.
  void overwrite(const GltfDocument& document, const Json& sparse) {
    const std::size_t count = count_of(sparse, "count");
    const Json* const indices = member(sparse, "indices");
    const Json* const values = member(sparse, "values");
    if (!indices || !values)
      throw std::runtime_error(name() + " is sparse and has no indices or no values");
    Json numbers = *indices;
    numbers["type"] = "SCALAR";
    const ElementType number(numbers);
    const std::string places = packed_elements(document, numbers, number.size(), count);
    const std::string elements = packed_elements(document, *values, type_.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const double place = number.stored_at(places, i * number.size());
      if (!(place >= 0 && place < static_cast<double>(count_)))
        throw std::runtime_error(name() + " is sparse and has an index out of range");
      bytes_.replace(static_cast<std::size_t>(place) * type_.size(), type_.size(), elements,
                     i * type_.size(), type_.size());
    }
  }

  std::size_t index_;
  ElementType type_;
  std::size_t count_;
  std::string bytes_;
};

} // namespace quadrille_examples

#endif
