#ifndef QUADRILLE_EXAMPLES_GLTF_JSON_H
#define QUADRILLE_EXAMPLES_GLTF_JSON_H

/// \file
/// JSON as glTF has it: what is read is checked before it is used, and complaints are
/// `std::runtime_error`s of one line, without the name of the file.

#include "../text.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// Members stay in the order in which they were read.
using Json = nlohmann::ordered_json;

/// Reads a text. Deep nesting is refused, since to write it takes a stack as deep.
inline Json parse_json(std::string_view text) {
  constexpr int deepest = 200;
  const auto require_flat = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest)
      throw std::runtime_error("the JSON text is nested too deeply");
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), require_flat);
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("not valid JSON: ") + error.what());
  }
}

/// Null if the value is no object, or has no such member.
inline const Json* member(const Json& object, std::string_view key) {
  if (!object.is_object())
    return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

/// A member that is an integer of at least 0. Throws if it is something else, or if it is not there
/// and there is no default.
inline std::size_t count_of(const Json& object, const char* key,
                            std::optional<std::size_t> by_default = std::nullopt) {
  const Json* const value = member(object, key);
  if (!value && by_default)
    return *by_default;
  if (!value || !value->is_number_integer() || *value < 0)
    throw std::runtime_error("'" + std::string(key) + "' is " +
                             (value ? "not a count" : "missing"));
  return value->get<std::size_t>();
}

/// A member that is a text; empty if it is not there.
inline std::string text_of(const Json& object, const char* key) {
  const Json* const value = member(object, key);
  if (value && !value->is_string())
    throw std::runtime_error("'" + std::string(key) + "' is not a string");
  return value ? value->get<std::string>() : std::string();
}

/// How many elements an array among the members has; none if it is not there.
inline std::size_t size_of(const Json& object, const char* key) {
  const Json* const array = member(object, key);
  if (array && !array->is_array())
    throw std::runtime_error("'" + std::string(key) + "' is not an array");
  return array ? array->size() : 0;
}

/// An element of an array among the members, which must be an object.
inline const Json& element_of(const Json& object, const char* key, std::size_t index) {
  if (index >= size_of(object, key))
    throw std::runtime_error(
        out_of_range(key, static_cast<std::int64_t>(index), size_of(object, key)));
  const Json& element = object.find(key)->at(index);
  if (!element.is_object())
    throw std::runtime_error("an element of '" + std::string(key) + "' is not an object");
  return element;
}

/// Calls visit(element) for each element of an array among the members, none if it is not there.
template <class Visit>
void for_each_element(const Json& object, const char* key, Visit visit) {
  for (std::size_t i = 0; i < size_of(object, key); ++i)
    visit(element_of(object, key, i));
}

} // namespace quadrille_examples

#endif
