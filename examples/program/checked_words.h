#ifndef QUADRILLE_EXAMPLES_PROGRAM_CHECKED_WORDS_H
#define QUADRILLE_EXAMPLES_PROGRAM_CHECKED_WORDS_H

/// \file
/// Words of the command line that options take, with what is said of others.

#include "../amount.h"
#include "../mesh_io/text.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>
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

inline CLI::Validator count() {
  const auto is_count = [](const std::string& word) {
    const std::optional<std::int64_t> value = parse_integer(word);
    return value && *value >= 0;
  };
  return word_that(is_count, "a count; --keep takes a part of the faces");
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
  return amount("a distance: a number in the units of IN, or 0.1% for a part of the diagonal");
}

/// One of several words.
inline CLI::Option* take_one_of(CLI::Option* option, const std::vector<std::string>& words) {
  std::string type;
  for (const std::string& word : words)
    type += (type.empty() ? "" : "|") + word;
  return option->check(CLI::IsMember(words).description(""))->type_name(type);
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
