#ifndef QUADRILLE_EXAMPLES_PROGRAM_SUGGESTION_H
#define QUADRILLE_EXAMPLES_PROGRAM_SUGGESTION_H

/// \file
/// What to say of words of the command line that no option takes.

#include "../mesh_io/amount.h"
#include "../mesh_io/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// How many letters have to be put in, taken out, changed or swapped to make one word the other.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        rows[i][j] = i + j;
        continue;
      }
      const std::size_t changed = rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      rows[i][j] = std::min({changed, rows[i - 1][j] + 1, rows[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  return rows[a.size()][b.size()];
}

/// The option whose name is one letter off, or of long ones two, as "--name"; empty if there is
/// none.
inline std::string closest_option(const CLI::App& app, std::string_view word) {
  std::size_t least = word.size() < 9 ? 2 : 3; // with the hyphens
  std::string closest;
  for (const CLI::Option* const option : app.get_options())
    for (const std::string& name : option->get_lnames())
      if (const std::size_t distance = edit_distance("--" + name, word); distance < least) {
        least = distance;
        closest = "--" + name;
      }
  return closest;
}

/// What an option of other programs is called here; nothing for others.
inline std::string option_of_others(const std::string& name) {
  static constexpr std::pair<const char*, const char*> names[] = {
      {"--percent", "--keep takes the fraction of the faces to keep, such as 10%"},
      {"--percentage", "--keep takes the fraction of the faces to keep, such as 10%"},
      {"--reduction",
       "--keep takes the fraction of the faces to keep, such as 10% for a reduction of 0.9"},
      {"--target-reduction",
       "--keep takes the fraction of the faces to keep, such as 10% for a reduction of 0.9"},
      {"--target", "--faces takes a count of faces, --keep a fraction of them"},
      {"--target-count", "--faces takes a count of faces, --keep a fraction of them"},
      {"--triangles", "--faces takes a count of faces, --keep a fraction of them"},
      {"--count", "--faces takes a count of faces, --keep a fraction of them"},
      {"--max-error", "--error takes a distance, such as 0.1% of the diagonal"},
      {"--tolerance-distance", "--error takes a distance, such as 0.1% of the diagonal"},
      {"--preserve-border", "--boundary lock keeps boundaries in place"},
      {"--preserve-boundary", "--boundary lock keeps boundaries in place"},
      {"--lock-border", "--boundary lock keeps boundaries in place"},
      {"--preserve-topology", "--topology kept does so, and is the default"},
      {"--merge", "--weld TOLERANCE merges vertices that nearly touch"}};
  for (const auto& [other, answer] : names)
    if (name == other)
      return answer;
  return "";
}

/// Of a word that stands alone behind IN and OUT.
inline std::string complaint_of_further(const std::string& word) {
  const std::optional<Amount> amount = parse_amount(word);
  if (amount && (amount->is_percentage || amount->value < 1))
    return in_quotes(word) + ": unexpected argument; did you mean --keep " + word +
           "? Separate the items of a list by commas";
  if (amount)
    return in_quotes(word) + ": unexpected argument; did you mean --faces " + word + "?";
  return in_quotes(word) +
         ": unexpected argument after IN and OUT; --into FOLDER simplifies several files";
}

/// Of the first of the words that is written like an option, else of the first.
inline std::string complaint_of_unknown(const CLI::App& app,
                                        const std::vector<std::string>& words) {
  const auto is_option = [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  };
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option == words.end())
    return complaint_of_further(words.front());
  const std::string name = option->substr(0, option->find('='));
  if (const std::string answer = option_of_others(name); !answer.empty())
    return "there is no option " + name + "; " + answer;
  const std::string closest = closest_option(app, name);
  return "there is no option " + name +
         (closest.empty() ? "; --help lists all options" : "; did you mean " + closest + "?");
}

} // namespace quadrille_examples

#endif
