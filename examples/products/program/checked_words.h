#ifndef QUADRILLE_EXAMPLES_PROGRAM_CHECKED_WORDS_H
#define QUADRILLE_EXAMPLES_PROGRAM_CHECKED_WORDS_H

/// \file
/// Words of the command line that options take, with what is said of others.

#include "../mesh_io/amount.h"
#include "../mesh_io/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace quadrille_examples {

/// A check of a word by what it complains of; CLI11's own let nan through, and -1 as a large count.
template <class IsGood>
CLI::Validator word_that(IsGood is_good, const std::string& what) {
  const auto complaint = [=](const std::string& word) {
    return is_good(word) ? "" : in_quotes(word) + " is not " + what;
  };
  return {complaint, ""};
}

/// The count that a word with commas or a unit means, as 1,000 or 1.5k; nothing for others.
inline std::optional<std::int64_t> meant_count(std::string word) {
  std::erase_if(word, [](char c) { return c == ',' || c == '_' || c == '\''; });
  double unit = 1;
  const char last = word.empty() ? ' ' : word.back();
  if (last == 'k' || last == 'K' || last == 'm' || last == 'M') {
    unit = last == 'k' || last == 'K' ? 1e3 : 1e6;
    word.pop_back();
  }
  const std::optional<double> number = parse_number(word);
  if (!number || !(*number >= 0) || !(*number * unit < 1e15) ||
      *number * unit != std::floor(*number * unit))
    return std::nullopt;
  return static_cast<std::int64_t>(*number * unit);
}

inline CLI::Validator count() {
  const auto complaint = [](const std::string& word) -> std::string {
    const std::optional<std::int64_t> value = parse_integer(word);
    if (value && *value >= 0)
      return "";
    if (const std::optional<std::int64_t> meant = meant_count(word))
      return in_quotes(word) + " is not a count in digits only: did you mean " +
             std::to_string(*meant) + "?";
    return in_quotes(word) + " is not a count; --keep takes a fraction of the faces";
  };
  return {complaint, ""};
}

inline CLI::Validator amount(const std::string& what,
                             double most = std::numeric_limits<double>::infinity()) {
  const auto is_good = [=](const std::string& word) {
    const std::optional<Amount> value = parse_amount(word);
    return value && value->value <= most;
  };
  return word_that(is_good, what);
}

inline CLI::Validator distance() {
  return amount("a distance, which is a number in the units of IN, or a percentage of the diagonal "
                "such as 0.1%");
}

/// What the library, or Python, calls a word.
using Synonyms = std::map<std::string, std::string>;

/// One of several words, in any case of letters, or by another name.
inline CLI::Option* take_one_of(CLI::Option* option, const std::vector<std::string>& words,
                                const Synonyms& synonyms = {}) {
  std::string type, list;
  for (const std::string& word : words) {
    type += (type.empty() ? "" : "|") + word;
    list += (list.empty() ? "" : ", ") + word;
  }
  const auto choose = [=](std::string& word) -> std::string {
    std::string plain = CLI::detail::to_lower(word);
    std::replace(plain.begin(), plain.end(), '_', '-');
    if (const auto found = synonyms.find(plain); found != synonyms.end())
      plain = found->second;
    if (std::find(words.begin(), words.end(), plain) == words.end())
      return in_quotes(word) + " is not one of " + list;
    word = plain;
    return "";
  };
  return option->transform(CLI::Validator(choose, ""))->type_name(type);
}

/// A number, at least 0 and no percentage, of which `is_good` says that it is one.
template <class IsGood>
CLI::Validator number_that(IsGood is_good, const std::string& what) {
  const auto is_good_word = [=](const std::string& word) {
    const std::optional<Amount> value = parse_amount(word);
    return value && !value->is_percentage && is_good(value->value);
  };
  return word_that(is_good_word, what);
}

inline Amount amount_of(const std::string& word) {
  return parse_amount(word).value();
}

} // namespace quadrille_examples

#endif
