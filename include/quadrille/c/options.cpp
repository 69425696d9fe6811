#include <quadrille/quadrille.h>
#include <quadrille/version.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace quadrille::internal {

namespace {

constexpr quadrille_option options_of_calls[] = {
#define QUADRILLE_OPTION(kind, name, ...) {#name, #kind, __VA_ARGS__},
#define QUADRILLE_JOB_OPTION(kind, name, ...) {#name, #kind, __VA_ARGS__},
#include <quadrille/compiled/options.def>
};
constexpr quadrille_option options_of_channels[] = {
#define QUADRILLE_CHANNEL_OPTION(kind, name, ...) {#name, #kind, __VA_ARGS__},
#include <quadrille/compiled/options.def>
};

struct WordOfOption {
  std::string_view option;
  quadrille_word word;
};
constexpr WordOfOption words_of_calls[] = {
#define QUADRILLE_WORD(option, word, short_form, sentence) {#option, {#word, sentence}},
#define QUADRILLE_JOB_WORD(option, word, short_form, sentence) {#option, {#word, sentence}},
#include <quadrille/compiled/options.def>
};
constexpr WordOfOption words_of_channels[] = {
#define QUADRILLE_CHANNEL_WORD(option, word, short_form, sentence) {#option, {#word, sentence}},
#include <quadrille/compiled/options.def>
};

std::span<const quadrille_option> options_of(std::int32_t of_channels) {
  if (of_channels != 0)
    return options_of_channels;
  return options_of_calls;
}

std::span<const WordOfOption> words_of(std::int32_t of_channels) {
  if (of_channels != 0)
    return words_of_channels;
  return words_of_calls;
}

// Returns a number of the version as text.
#define QUADRILLE_TEXT_OF(number) #number
#define QUADRILLE_NUMBER_TEXT(number) QUADRILLE_TEXT_OF(number)

} // namespace

} // namespace quadrille::internal

using namespace quadrille::internal;

extern "C" {

int32_t quadrille_c_version(void) {
  return QUADRILLE_C_VERSION;
}

const char* quadrille_version(void) {
  return QUADRILLE_NUMBER_TEXT(QUADRILLE_VERSION_MAJOR) "." QUADRILLE_NUMBER_TEXT(
      QUADRILLE_VERSION_MINOR) "." QUADRILLE_NUMBER_TEXT(QUADRILLE_VERSION_PATCH);
}

int32_t quadrille_has_threads(void) {
#ifdef QUADRILLE_WITH_TBB
  return 1;
#else
  return 0;
#endif
}

size_t quadrille_option_count(int32_t of_channels) {
  return options_of(of_channels).size();
}

const quadrille_option* quadrille_option_at(int32_t of_channels, size_t index) {
  const auto options = options_of(of_channels);
  return index < options.size() ? &options[index] : nullptr;
}

const quadrille_word* quadrille_word_at(int32_t of_channels, const char* option, size_t index) {
  for (const WordOfOption& known : words_of(of_channels))
    if (known.option == option && index-- == 0)
      return &known.word;
  return nullptr;
}

} // extern "C"
