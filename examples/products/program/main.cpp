// The program quadrille: reads a mesh, simplifies it and writes it. See doc/manual/tool.md.
//
// Exit status: 0 done; 1 the target was not reached, OUT holds how far it went; 2 bad usage or
// file, or nothing to simplify, OUT is as it was; 3 what was promised is not kept, as --verify has
// found, OUT is written; 130 interrupted, OUT is as it was.

#include "../mesh_io/gltf/compression.h"
#include "../mesh_io/replace_file.h"
#include "command_line.h"
#include "interruption.h"
#include "options.h"
#include "progress_line.h"
#include "runs.h"
#include "several_files.h"
#include "suggestion.h"
#include "verification.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace quadrille_examples;

/// As many as the machine has, if none are asked for; one where the program was built without
/// oneTBB.
unsigned threads_of(const Options& options) {
#ifdef QUADRILLE_WITH_TBB
  return options.threads > 0 ? options.threads
                             : std::clamp(std::thread::hardware_concurrency(), 1U, 1024U);
#else
  if (options.threads > 1)
    throw std::runtime_error(
        "--threads: this program was built without oneTBB, so it has one thread only");
  return 1;
#endif
}

bool run(Options options, ProgressLine& progress) {
  require_consistency(options);
  options.threads = threads_of(options);
  options.soup.proceed = [&](const quadrille::Status& status) {
    progress.show(status);
    return !Interruption::is_asked();
  };
  if (options.verifies && is_page(output_extension(options)))
    throw std::runtime_error(options.output + ": --verify checks mesh files, not pages");
  if (options.target.is_calibrated && is_page(output_extension(options)))
    throw std::runtime_error(
        options.output + ": a page shows a single recorded run, and --calibrated needs several");
  if (!options.report.empty() && !is_standard_output(options.report))
    require_replaceable(options.report, options.is_forced);
  const bool writes_gltf = is_gltf(output_extension(options)) && options.scratch.empty();
  if (!options.compression.empty() && !writes_gltf)
    throw std::runtime_error(options.output + ": --compress needs an OUT that is .glb or .gltf");
  compression_of(options.compression); // throws if it cannot be done
  if (options.weld && options.from.empty() && is_gltf(extension_of(options.input, options)))
    throw std::runtime_error(options.input +
                             ": --weld does not go with glTF, where vertices are merged " +
                             "anyway where edges of faces coincide");
  if (!options.scratch.empty())
    return run_out_of_core(options, progress);
  if (is_page(output_extension(options)))
    return run_page(options, progress);
  if (!options.from.empty() && writes_gltf)
    throw std::runtime_error(options.output + ": a level of a record cannot be written as glTF");
  if (!options.from.empty())
    return run_from_record(options, progress);
  const bool stays_gltf = writes_gltf && is_gltf(extension_of(options.input, options));
  if (stays_gltf && options.orients)
    throw std::runtime_error(options.input +
                             ": --orient does not go with glTF, where the winding " +
                             "says which side of a face is visible");
  if (!stays_gltf && !options.labels.empty())
    throw std::runtime_error(options.input +
                             ": --labels is for glTF that is written as glTF; in other " +
                             "files, names and integers of faces are always labels");
  if (!stays_gltf)
    return run_mesh(options, progress);
  if (!options.record.empty())
    throw std::runtime_error(options.input + ": --record does not go with glTF");
  if (!options.scalars.empty() || !options.target.tolerance.empty())
    throw std::runtime_error(
        options.input + ": " +
        spelled(options.scalars.empty() ? "tolerance" : options.scalars.begin()->first) +
        " needs vertices with named scalars (.ply), which " + "glTF does not have");
  if (!options.region.empty())
    throw std::runtime_error(options.input + ": --region needs faces with names or " +
                             "scalars (.obj, .ply), which glTF does not have");
  return run_gltf(options, progress);
}

enum ExitStatus { done, target_not_reached, failure, promise_broken };

/// Runs, and tells what goes wrong. Returns the exit status.
int run_or_complain(const Options& options, ProgressLine& progress) {
  const auto complain = [&](const std::string& complaint) {
    progress.clear();
    std::cerr << complaint << '\n';
  };
  try {
    return run(options, progress) ? done : target_not_reached;
  } catch (const Interrupted& interrupted) {
    complain("interrupted: " + options.output +
             (interrupted.is_output_there ? " is written, but its measurement was not finished"
              : options.scratch.empty()   ? " is as it was"
                                          : " is as it was; --restart resumes the job"));
    return Interruption::exit_status();
  } catch (const BrokenPromise& broken) {
    complain(broken.what());
    return promise_broken;
  } catch (const std::bad_alloc&) {
    complain(options.input + ": out of memory" +
             (options.scratch.empty() ? "; --out-of-core FOLDER needs less" : ""));
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return failure;
}

/// Of several files, the worst exit status of all. An interruption ends them.
int run_files(const Options& options, const std::vector<std::string>& others,
              ProgressLine& progress) {
  try {
    const std::vector<Options> files = options_of_files(options, others);
    std::filesystem::create_directories(options.folder);
    int worst = done;
    for (const Options& file : files) {
      const int status = run_or_complain(file, progress);
      if (status == Interruption::exit_status())
        return status;
      const auto rank = [](int s) { return s == failure ? 4 : s; };
      worst = rank(status) > rank(worst) ? status : worst;
    }
    return worst;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return failure;
  }
}

/// The words that CLI11 knows no use for.
std::vector<std::string> further_words(const CLI::App& app) {
  std::vector<std::string> words = app.remaining();
  std::erase(words, "--");
  return words;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Simplifies a triangle mesh by contracting vertex pairs.", "quadrille");
  Options options;
  add_options(app, options);
  app.allow_extras();
  try {
    app.parse(CommandWords::of(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (const std::vector<std::string> words = further_words(app);
        !words.empty() && error.get_exit_code() != 0) {
      std::cerr << complaint_of_unknown(app, words) << '\n';
      return failure;
    }
    return app.exit(error) == 0 ? done : failure; // --help is an error to CLI11, but not here
  }
  const std::vector<std::string> others = further_words(app);
  const bool has_unknown = std::any_of(others.begin(), others.end(), [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  });
  if (!others.empty() && (has_unknown || options.folder.empty())) {
    std::cerr << complaint_of_unknown(app, others) << '\n';
    return failure;
  }
  Interruption::watch();
  ProgressLine progress(!options.is_quiet && ::isatty(STDERR_FILENO) == 1);
  return options.folder.empty() ? run_or_complain(options, progress)
                                : run_files(options, others, progress);
}
