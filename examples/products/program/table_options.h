#ifndef QUADRILLE_EXAMPLES_PROGRAM_TABLE_OPTIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_TABLE_OPTIONS_H

/// \file
/// The options of the table (options.def) in the command line. What an option takes follows from
/// the kind and the unit of its row; own_forms has what the program does in another way.

#include "checked_words.h"
#include "option_names.h"
#include "options.h"

#include <quadrille/compiled/option_setting.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace quadrille_examples {

using quadrille::internal::OptionKind;
using quadrille::internal::OptionValue;

/// A number of a unit as the command line has it.
struct NumberForm {
  std::string_view unit; ///< as in the table
  const char* type;      ///< in the help
  const char* noun;      ///< in messages
  const char* help;      ///< is added
  bool takes_percentage;
};
inline constexpr std::string_view unit_of_lengths = "unit of the points";
inline constexpr NumberForm number_forms[] = {
    {unit_of_lengths, "D|P%",
     "a distance, which is a number in the units of IN, or a percentage of the diagonal such as "
     "0.1%",
     "; in the units of IN or as a percentage of the diagonal of its bounding box", true},
    {"faces of the input", "FRACTION", "a fraction such as 0.1 or 10%", ", such as 0.1 or 10%",
     true},
    {"degrees", "DEGREES", "an angle in degrees", "", false},
    {"weight", "WEIGHT", "a weight", "", false},
    {"", "NUMBER", "a number", "", false}}; // of all other units

/// Arrays have no more, but files can.
inline constexpr std::string_view range_of_counts = "[0, 4294967295]";

inline const NumberForm& form_of(std::string_view unit) {
  return *std::find_if(std::begin(number_forms), std::end(number_forms) - 1,
                       [&](const NumberForm& form) { return form.unit == unit; });
}

/// The part of an option that does not follow from its row.
struct OwnForm {
  std::string_view option;
  const char* note = "";                                            ///< is added to the help
  const char* fallback = nullptr;                                   ///< the default in the help
  const char* type = nullptr;                                       ///< in the help
  const char* noun = nullptr;                                       ///< in messages, of is_good
  bool (*is_good)(const std::string& word) = nullptr;               ///< checks a word
  void (*set)(Options& options, const std::string& word) = nullptr; ///< instead of the field
  std::span<const char* const> words = {};                          ///< beside those of the table
};

inline bool is_weight_or_lock(const std::string& word) {
  const std::optional<Amount> value = parse_amount(word);
  return word == "lock" || (value && !value->is_percentage);
}

inline void set_boundary(Options& options, const std::string& word) {
  options.locks_boundaries = word == "lock";
  if (!options.locks_boundaries)
    options.soup.boundary_weight = amount_of(word).value;
}

inline bool is_noise_of_normals(const std::string& word) {
  const std::optional<Amount> value = parse_amount(word);
  return value && !value->is_percentage && value->value < 90;
}

inline void set_normal_noise(Options& options, const std::string& word) {
  options.soup.normal_noise = std::tan(amount_of(word).value * std::numbers::pi / 180);
}

inline constexpr const char* costs_of_attributes[] = {"color", "texture"};
inline constexpr OwnForm own_forms[] = {
    {.option = "error",
     .note = " (see --measure)",
     .set = [](Options& o, const std::string& word) { o.target.error = amount_of(word); }},
    {.option = "tolerance",
     .note = "; PLY files have such scalars of vertices",
     .set = [](Options& o, const std::string& word) { o.target.tolerance = word; }},
    {.option = "cost",
     .note = ", or color or texture, which are quadric with colours or texture coordinates as the "
             "only attributes that count",
     .fallback = "quadric, with all attributes of IN",
     .set = [](Options& o, const std::string& word) { o.cost = word; },
     .words = costs_of_attributes},
    {.option = "threads",
     .note = "; with --out-of-core, of chunks at a time",
     .fallback = "all",
     .set =
         [](Options& o, const std::string& word) {
           o.threads = static_cast<unsigned>(*parse_integer(word));
         }},
    {.option = "boundary_weight",
     .note = ": a weight, or lock, which keeps each of their vertices in place",
     .type = "WEIGHT|lock",
     .noun = "a weight or lock",
     .is_good = is_weight_or_lock,
     .set = set_boundary},
    {.option = "normal_noise",
     .note = ", as a standard deviation",
     .type = "DEGREES",
     .noun = "an angle from 0 to less than 90 degrees",
     .is_good = is_noise_of_normals,
     .set = set_normal_noise},
    {.option = "importance", .note = "; PLY files have such scalars of vertices"},
    {.option = "topology",
     .note = "; small components of glTF, OBJ and PLY may vanish by default, see --keep-parts"}};

/// Returns a form without members for options that have none of their own.
inline OwnForm own_form_of(const Option& row) {
  for (const OwnForm& form : own_forms)
    if (form.option == row.name)
      return form;
  return {};
}

/// Returns whether the program can take all options that are to be in it.
constexpr bool have_forms() {
  for (const Option& row : quadrille::internal::call_options)
    if (is_in_program(row) && row.kind == OptionKind::face_flags)
      return false;
  return true;
}
static_assert(have_forms(),
              "The command line has no form of flags of faces: write an option of its "
              "own as --region.");

/// A number of a range as "[0, 180]".
inline CLI::Validator number_in(const char* range, const std::string& noun, bool takes_percentage) {
  const auto is_good = [=](const std::string& word) {
    const std::optional<Amount> value = parse_amount(word);
    return value && (takes_percentage || !value->is_percentage) &&
           quadrille::internal::is_in_range(value->value, range);
  };
  const bool is_any = range == std::string_view("[0, inf)");
  return word_that(is_good, noun + (is_any ? "" : " in " + std::string(range)));
}

/// Adds the options of the table to the command line.
class TableOptions {
public:
  static void add(CLI::App& app, Options& options) {
    TableOptions adder(app, options);
    using Row = Option;
#define QUADRILLE_GROUP(heading) adder.group_ = heading;
#define QUADRILLE_OPTION(kind, field, ...)                                                         \
  adder.add<quadrille::SoupOptions>(Row{OptionKind::kind, #field, __VA_ARGS__}, options.soup.field);
#define QUADRILLE_JOB_OPTION QUADRILLE_OPTION
#define QUADRILLE_CHANNEL_OPTION(kind, field, ...)                                                 \
  adder.add<quadrille::ChannelOptions>(Row{OptionKind::kind, #field, __VA_ARGS__},                 \
                                       options.textures.field);
#include <quadrille/compiled/options.def>
  }

private:
  using SetWord = std::function<void(Options&, const std::string&)>;

  TableOptions(CLI::App& app, Options& options) : app_(app), options_(options) {}

  template <class Owner>
  void add(const Option& row, auto& field) {
    using Value = OptionValue<std::remove_reference_t<decltype(field)>>;
    if (!is_in_program(row))
      return;
    if constexpr (std::is_same_v<Value, bool>)
      app_.add_flag(names_of(row), field, help_of<Owner>(row))->group(group_);
    else if constexpr (std::is_enum_v<Value>)
      add_word<Owner>(row, field);
    else if constexpr (std::is_arithmetic_v<Value>)
      add_number<Owner>(row, field);
    else
      add_option<Owner>(
          row, own_or(row, [name = row.name](Options& o,
                                             const std::string& word) { o.scalars[name] = word; }))
          ->type_name("NAME");
  }

  /// Returns what the own form of an option sets, or else this.
  static SetWord own_or(const Option& row, const SetWord& set) {
    const OwnForm own = own_form_of(row);
    return own.set ? SetWord(own.set) : set;
  }

  template <class Owner>
  CLI::Option* add_option(const Option& row, const SetWord& set) {
    const auto set_options = [&options = options_, set](const std::string& word) {
      set(options, word);
    };
    return app_.add_option_function<std::string>(names_of(row), set_options, help_of<Owner>(row))
        ->group(group_);
  }

  template <class Owner, class Field>
  void add_number(const Option& row, Field& field) {
    const bool is_length = row.unit == unit_of_lengths;
    const auto set = [&field, is_length, name = row.name](Options& o, const std::string& word) {
      if (is_length)
        o.lengths[name] = amount_of(word);
      else
        field = static_cast<OptionValue<Field>>(amount_of(word).value);
    };
    CLI::Option* const option = add_option<Owner>(row, own_or(row, set));
    const OwnForm own = own_form_of(row);
    const bool is_count = row.kind == OptionKind::count;
    const NumberForm& form = form_of(row.unit);
    option->type_name(own.type ? own.type : is_count ? "N" : form.type);
    if (is_count)
      option->check(count());
    if (own.is_good)
      option->check(word_that(own.is_good, own.noun));
    else if (row.range != range_of_counts)
      option->check(number_in(row.range, is_count ? "a count" : form.noun, form.takes_percentage));
  }

  template <class Owner>
  void add_word(const Option& row, auto& field) {
    using Word = OptionValue<std::remove_reference_t<decltype(field)>>;
    std::map<std::string, Word> values;
    std::vector<std::string> words;
    Synonyms synonyms;
    for (const OptionWord& word : words_of<Owner>(row)) {
      words.push_back(name_of(word));
      values[words.back()] = static_cast<Word>(word.value);
      synonyms[with_dashes(word.word)] = words.back();
    }
    const OwnForm own = own_form_of(row);
    words.insert(words.end(), std::begin(own.words), std::end(own.words));
    const auto set = [&field, values, own](Options& o, const std::string& word) {
      if (const auto found = values.find(word); found != values.end())
        field = found->second;
      if (own.set)
        own.set(o, word);
    };
    take_one_of(add_option<Owner>(row, set), words, synonyms);
  }

  template <class Owner>
  static std::vector<OptionWord> words_of(const Option& row) {
    std::vector<OptionWord> words;
    for (const OptionWord& word : quadrille::internal::words_of<Owner>())
      if (word.option == std::string_view(row.name))
        words.push_back(word);
    return words;
  }

  template <class Owner>
  static std::string help_of(const Option& row) {
    const OwnForm own = own_form_of(row);
    std::string help = row.sentence, before = ": ";
    for (const OptionWord& word : words_of<Owner>(row)) {
      help += before + name_of(word) + " (" + word.sentence + ")";
      before = ", ";
    }
    help += own.note;
    if (row.kind == OptionKind::number && !own.type)
      help += form_of(row.unit).help;
    const std::string fallback = own.fallback ? own.fallback : with_dashes(row.fallback);
    if (row.kind != OptionKind::flag && !fallback.empty())
      help += " (default: " + fallback + ")";
    return in_words_of_command_line(help);
  }

  CLI::App& app_;
  Options& options_;
  const char* group_ = "";
};

} // namespace quadrille_examples

#endif
