#ifndef QUADRILLE_EXAMPLES_PROGRAM_EXCLUSIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_EXCLUSIONS_H

/// \file
/// Options that do not go with each other, and why.

#include "option_names.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace quadrille_examples {

struct Exclusion {
  const char* option;
  const char* other;
  const char* reason;
};
inline constexpr const char* reason_of_levels =
    "each level has its own target: 50%, 1000 or error=0.1%";
inline constexpr Exclusion exclusions[] = {
    {"--tolerance", "--error",
     "both limit how far a face may be from OUT: put the smaller limit into the scalar"},
    {"--levels", "--faces", reason_of_levels},
    {"--levels", "--keep", reason_of_levels},
    {"--levels", "--vertices", reason_of_levels},
    {"--levels", "--error", reason_of_levels},
    {"--record", "--levels", "a record contains all levels, and --from reads each of them"},
    {"--verbose", "--quiet", "one prints more, the other nothing"},
    {"--drop-parts", "--keep-parts", "small components may either vanish or stay"},
    {"--from", "--verify",
     "a record does not contain IN to compare OUT with: use --verify in the run that "
     "writes the record"},
    {"--from", "--measure",
     "a record does not contain IN to compare OUT with: use --measure in the run that "
     "writes the record"}};

/// The options that belong to the run that has made a record, beside those of the table.
inline constexpr const char* options_of_recorded_runs[] = {
    "--record",       "--drop-parts", "--levels", "--weld",  "--orient",
    "--keep-partial", "--region",     "--labels", "--hidden"};

/// The options of the table that choose a level.
inline constexpr std::string_view options_of_levels[] = {"faces", "ratio", "vertices", "error"};

/// Calls visit(name) for each option of the program that is in the table and not in a list.
template <class Visit>
void for_others(std::span<const std::string_view> list, const Visit& visit) {
  const auto visit_others = [&](std::span<const Option> rows) {
    for (const Option& row : rows)
      if (is_in_program(row) && std::find(list.begin(), list.end(), row.name) == list.end())
        visit(name_of(row));
  };
  visit_others(quadrille::internal::call_options);
  visit_others(quadrille::internal::channel_options);
}

/// Throws if an option is there that does not go with another one, with the reason.
inline void reject_with(const CLI::App& app, const Exclusion& exclusion) {
  if (app.get_option(exclusion.option)->count() > 0)
    throw CLI::ValidationError(exclusion.option, std::string("does not go with ") +
                                                     exclusion.other + ": " + exclusion.reason);
}

/// Throws for two options that do not go together, with the reason.
inline void require_compatible(const CLI::App& app) {
  const auto refuse = [&](const Exclusion& exclusion) {
    if (app.get_option(exclusion.other)->count() > 0)
      reject_with(app, exclusion);
  };
  for (const Exclusion& exclusion : exclusions)
    refuse(exclusion);
  const auto refuse_with_record = [&](const std::string& option) {
    refuse(
        {"--from", option.c_str(), "a level of a record is already simplified, and is only read"});
  };
  for (const char* const option : options_of_recorded_runs)
    refuse_with_record(option);
  for_others(options_of_levels, refuse_with_record);
}

} // namespace quadrille_examples

#endif
