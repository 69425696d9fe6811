#ifndef QUADRILLE_EXAMPLES_PROGRAM_LAUNCH_H
#define QUADRILLE_EXAMPLES_PROGRAM_LAUNCH_H

/// \file
/// Several processes of the program that mpirun, mpiexec or srun has started together.

#ifdef QUADRILLE_WITH_MPI
#include <quadrille/mpi.h>
#else
#include <quadrille/file_report.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>

namespace quadrille_examples {

/// How many there are, as launchers tell it in the environment; 1 if nobody does.
inline std::size_t launched_processes() {
  const auto number = [](std::initializer_list<const char*> names) -> std::size_t {
    for (const char* const name : names)
      if (const char* const value = std::getenv(name); value && *value != '\0')
        return std::strtoull(value, nullptr, 10);
    return 0;
  };
  // Open MPI; MPICH and what descends from it, srun --mpi=pmi2; MVAPICH; IBM.
  std::size_t told =
      number({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", "JSM_NAMESPACE_SIZE"});
  if (told == 0 && std::getenv("PMIX_RANK")) // srun --mpi=pmix, prun
    told = std::getenv("SLURM_STEP_NUM_TASKS") ? number({"SLURM_STEP_NUM_TASKS"})
                                               : number({"PMIX_RANK"}) + 1;
  return told > 0 ? told : 1;
}

[[noreturn]] inline void reject_launch(const std::string& why) {
  throw std::runtime_error("--out-of-core: " + std::to_string(launched_processes()) +
                           " processes of this program were started together, as mpirun does, " +
                           why);
}

/// The ranks among which a run by parts is shared out, from here on to its end. Throws a sentence
/// where they cannot be: each would do the whole job, in the same folder.
class Launch {
public:
#ifdef QUADRILLE_WITH_MPI
  Launch() {
    int processes = 1;
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &processes);
    if (static_cast<std::size_t>(processes) == launched_processes())
      return;
    const std::string library = name_of_library();
    MPI_Finalize();
    reject_launch("by a different MPI from the one that it was built with, " + library);
  }
  ~Launch() {
    MPI_Finalize();
  }
#else
  Launch() {
    reject_launch(
        "but it was built without MPI, so they cannot share a job: start one process, or see "
        "--step");
  }
  ~Launch() = default;
#endif
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  /// Only that one tells the user anything.
  bool is_first() const {
    return rank_ == 0;
  }

#ifdef QUADRILLE_WITH_MPI
  /// Runs a check on the first rank. If it throws there, it does on all.
  template <class Check>
  void on_first(const Check& check) const {
    quadrille::internal::Ranks(MPI_COMM_WORLD).run([&] {
      if (is_first())
        check();
    });
  }
  template <class Stop, class Cost, class... Policies>
  quadrille::FileReport simplify_file(const quadrille::SurfaceFiles& input,
                                      const std::string& output, const Stop& stop,
                                      const quadrille::OutOfCore& how, const Cost& cost,
                                      const Policies&... policies) const {
    return quadrille::simplify_file(MPI_COMM_WORLD, input, output, stop, how, cost, policies...);
  }
#else
  template <class Check>
  void on_first(const Check&) const {}
  template <class... Arguments>
  quadrille::FileReport simplify_file(const Arguments&...) const {
    return {};
  }
#endif

private:
#ifdef QUADRILLE_WITH_MPI
  static std::string name_of_library() {
    std::string text(MPI_MAX_LIBRARY_VERSION_STRING, '\0');
    int size = 0;
    MPI_Get_library_version(text.data(), &size);
    text.resize(static_cast<std::size_t>(size));
    text.resize((std::min)(text.find_first_of(",\n"), text.size()));
    return text;
  }
#endif

  int rank_ = 0;
};

} // namespace quadrille_examples

#endif
