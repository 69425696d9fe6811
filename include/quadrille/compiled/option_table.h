#ifndef QUADRILLE_COMPILED_OPTION_TABLE_H
#define QUADRILLE_COMPILED_OPTION_TABLE_H

#include <quadrille/channel_options.h>
#include <quadrille/compiled/option_field.h>
#include <quadrille/compiled/soup_job.h>

#include <span>
#include <string_view>
#include <type_traits>

/// \file
/// The table of options.def as data, and the fields that it names.

namespace quadrille::internal {

/// The kind of the value of an option. Flags and numbers of points and of faces are arrays with a
/// value for each.
enum class OptionKind {
  count,
  number,
  flag,
  word,
  numbers,
  point_numbers,
  point_flags,
  face_flags
};

/// A row of the table. All texts end with a null character.
struct Option {
  OptionKind kind;
  const char* name;
  const char* range;      ///< as [0, inf); empty: any
  const char* fallback;   ///< the default; empty: none
  const char* unit;       ///< empty: none
  const char* places;     ///< the interfaces that have it
  const char* short_form; ///< the short form in the program; empty: none
  const char* sentence;
};

/// A value of an option whose kind is word.
struct OptionWord {
  const char* option;
  const char* word;
  const char* short_form; ///< the short form in the program; empty: none
  const char* sentence;
  int value; ///< the enumerator
};

/// The options of a call.
inline constexpr Option call_options[] = {
#define QUADRILLE_OPTION(kind, name, ...) {OptionKind::kind, #name, __VA_ARGS__},
#define QUADRILLE_JOB_OPTION(kind, name, ...) {OptionKind::kind, #name, __VA_ARGS__},
#include <quadrille/compiled/options.def>
};
/// The options of a channel.
inline constexpr Option channel_options[] = {
#define QUADRILLE_CHANNEL_OPTION(kind, name, ...) {OptionKind::kind, #name, __VA_ARGS__},
#include <quadrille/compiled/options.def>
};
/// The words of the options of a call.
inline constexpr OptionWord call_words[] = {
#define QUADRILLE_WORD(option, word, short_form, sentence)                                         \
  {#option, #word, short_form, sentence,                                                           \
   static_cast<int>(OptionValue<decltype(SoupJob::option)>::word)},
#define QUADRILLE_JOB_WORD(option, word, short_form, sentence)                                     \
  {#option, #word, short_form, sentence,                                                           \
   static_cast<int>(OptionValue<decltype(SoupJob::option)>::word)},
#include <quadrille/compiled/options.def>
};
/// The words of the options of a channel.
inline constexpr OptionWord channel_words[] = {
#define QUADRILLE_CHANNEL_WORD(option, word, short_form, sentence)                                 \
  {#option, #word, short_form, sentence,                                                           \
   static_cast<int>(OptionValue<decltype(ChannelOptions::option)>::word)},
#include <quadrille/compiled/options.def>
};

/// Returns the words of all options of a call or of a channel.
template <class Options>
constexpr std::span<const OptionWord> words_of() {
  if constexpr (std::is_same_v<Options, ChannelOptions>)
    return channel_words;
  else
    return call_words;
}

/// Calls visit(row, field) for the option of a name, and returns false if there is none. `options`
/// are SoupOptions, a SoupJob or ChannelOptions.
template <class Options, class Visit>
bool with_option(Options& options, std::string_view name, const Visit& visit) {
#define QUADRILLE_VISIT(kind, field, ...)                                                          \
  if (name == #field) {                                                                            \
    visit(Option{OptionKind::kind, #field, __VA_ARGS__}, options.field);                           \
    return true;                                                                                   \
  }
  if constexpr (std::is_same_v<Options, ChannelOptions>) {
#define QUADRILLE_CHANNEL_OPTION(kind, field, ...) QUADRILLE_VISIT(kind, field, __VA_ARGS__)
#include <quadrille/compiled/options.def>
  } else {
#define QUADRILLE_OPTION(kind, field, ...) QUADRILLE_VISIT(kind, field, __VA_ARGS__)
#include <quadrille/compiled/options.def>
    if constexpr (std::is_same_v<Options, SoupJob>) {
#define QUADRILLE_JOB_OPTION(kind, field, ...) QUADRILLE_VISIT(kind, field, __VA_ARGS__)
#include <quadrille/compiled/options.def>
    }
  }
#undef QUADRILLE_VISIT
  return false;
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_OPTION_TABLE_H
