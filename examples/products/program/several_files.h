#ifndef QUADRILLE_EXAMPLES_PROGRAM_SEVERAL_FILES_H
#define QUADRILLE_EXAMPLES_PROGRAM_SEVERAL_FILES_H

/// \file
/// Words of the command line beside those that CLI11 knows, and runs of several files.

#include "../mesh_io/amount.h"
#include "../mesh_io/text.h"
#include "options.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The words of the command line as CLI11 takes them, from the last to the first. --weld has a
/// value there: the word behind it if that is an amount, else 0. IN and OUT with options go where
/// they stand without.
class CommandWords {
public:
  static std::vector<std::string> of(int argc, char** argv) {
    CommandWords words;
    for (int i = 1; i < argc; ++i)
      words.add(argv[i], i + 1 < argc ? argv[i + 1] : nullptr, i);
    if (!words.input_.empty())
      words.words_.insert(words.words_.begin(), words.input_);
    if (!words.output_.empty()) {
      words.words_.emplace_back("--"); // lest an option take it
      words.words_.push_back(words.output_);
    }
    std::reverse(words.words_.begin(), words.words_.end());
    return std::move(words.words_);
  }

private:
  void add(const std::string& word, const char* next, int& i) {
    if (word == "--weld") {
      const bool has_value = next && parse_amount(next);
      words_.push_back("--weld=" + std::string(has_value ? next : "0"));
      i += has_value;
    } else if (next && is_one_of(word, {"-i", "--in", "--input"})) {
      input_ = next;
      ++i;
    } else if (next && is_one_of(word, {"-o", "--out", "--output"})) {
      output_ = next;
      ++i;
    } else {
      words_.push_back(word);
    }
  }

  static bool is_one_of(const std::string& word, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), word) != names.end();
  }

  std::vector<std::string> words_;
  std::string input_, output_;
};

/// The options of each of several files: its result has its name in the folder, with the extension
/// of --out-format, if there is one. Throws for what would overwrite something.
inline std::vector<Options> options_of_files(const Options& options,
                                             const std::vector<std::string>& others) {
  namespace fs = std::filesystem;
  if (!options.report.empty() || !options.record.empty() || !options.from.empty() ||
      !options.scratch.empty())
    throw std::runtime_error(
        "--into writes several results: --report, --record, --from and --out-of-core do not "
        "go with it");
  std::vector<std::string> files = {options.input};
  if (!options.output.empty())
    files.push_back(options.output);
  files.insert(files.end(), others.begin(), others.end());
  std::vector<Options> result;
  std::set<fs::path> outputs;
  for (const std::string& file : files) {
    fs::path output = fs::path(options.folder) / fs::path(file).filename();
    if (!options.output_format.empty())
      output.replace_extension(options.output_format);
    if (!outputs.insert(output).second)
      throw std::runtime_error(file + ": two results would be written to " + output.string());
    std::error_code none;
    if (fs::equivalent(file, output, none))
      throw std::runtime_error(file + ": it is in the folder of --into, so its result would " +
                               "replace it");
    result.push_back(options);
    result.back().input = file;
    result.back().output = output.string();
  }
  return result;
}

} // namespace quadrille_examples

#endif
