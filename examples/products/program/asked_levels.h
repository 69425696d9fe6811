#ifndef QUADRILLE_EXAMPLES_PROGRAM_ASKED_LEVELS_H
#define QUADRILLE_EXAMPLES_PROGRAM_ASKED_LEVELS_H

/// \file
/// The levels of detail that the program is asked for in one run: --levels 50%,25%,1000, or by
/// their distances from the input, --levels error=0.1%,error=0.5%.

#include "../mesh_io/text.h"
#include "target.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

/// A part of the faces, a count of them, or a distance from the input, as it was written.
struct AskedLevel {
  std::string word;
  Target target;
};
using AskedLevels = std::vector<AskedLevel>;

inline constexpr std::string_view word_of_error = "error=";

/// Nothing for a word that is none of them.
inline std::optional<Target> target_of_level(const std::string& word) {
  if (word.starts_with(word_of_error)) {
    const std::optional<Amount> error = parse_amount(word.substr(word_of_error.size()));
    return error ? std::optional(Target{.error = error}) : std::nullopt;
  }
  if (word.ends_with('%')) {
    const std::optional<Amount> part = parse_amount(word);
    if (!part || part->value > 1)
      return std::nullopt;
    return Target{.ratio = part->value};
  }
  const std::optional<std::int64_t> count = parse_integer(word);
  if (!count || *count < 0)
    return std::nullopt;
  return Target{.faces = static_cast<std::size_t>(*count)};
}

inline std::vector<std::string> words_between_commas(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

/// What is wrong with a list of levels; empty if nothing is.
inline std::string complaint_of_levels(const std::string& list) {
  for (const std::string& word : words_between_commas(list))
    if (!target_of_level(word))
      return in_quotes(word) +
             " is not a percentage of the faces, a count of faces, or error= with a distance";
  return "";
}

/// Of a list of which there is no complaint.
inline AskedLevels asked_levels(const std::string& list) {
  AskedLevels levels;
  for (const std::string& word : words_between_commas(list))
    levels.push_back({word, target_of_level(word).value()});
  return levels;
}

/// How many faces a level shall have, of a surface of so many; no whole number as a rule.
inline double wanted_faces(const Target& target, std::size_t faces) {
  return target.ratio ? *target.ratio * static_cast<double>(faces)
                      : static_cast<double>(target.faces.value());
}

/// Is a level coarser than another one? Nothing where they are of different kinds. A surface of
/// none has levels of none.
inline std::optional<bool> is_coarser(const Target& level, const Target& before,
                                      std::size_t faces) {
  if (!level.error && !before.error)
    return faces == 0 || wanted_faces(level, faces) < wanted_faces(before, faces);
  if (!level.error || !before.error || level.error->is_percentage != before.error->is_percentage)
    return std::nullopt;
  return level.error->value > before.error->value;
}

/// Throws for a level that is not coarser than the one before it, of a surface of so many faces.
inline void require_descending(const AskedLevels& levels, std::size_t faces) {
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const auto fail = [&](const std::string& complaint) {
      throw std::runtime_error("--levels: " + levels[i].word + complaint + levels[i - 1].word +
                               " before it (IN has " + std::to_string(faces) + " faces)");
    };
    const std::optional<bool> is_right = is_coarser(levels[i].target, levels[i - 1].target, faces);
    if (!is_right)
      fail(" is not of the same kind as ");
    if (!*is_right)
      fail(" is not coarser than ");
  }
}

/// The file of a level, counted from 1: OUT-1.ext of OUT.ext.
inline std::string file_of_level(const std::string& output, std::size_t number) {
  const std::filesystem::path path(output);
  const std::string name =
      path.stem().string() + "-" + std::to_string(number) + path.extension().string();
  return (path.parent_path() / name).string();
}

} // namespace quadrille_examples

#endif
