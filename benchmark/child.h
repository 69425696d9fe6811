// SPDX-License-Identifier: MIT
//
// One run of one contender, in a process of its own.

#ifndef QUADRILLE_BENCHMARK_CHILD_H
#define QUADRILLE_BENCHMARK_CHILD_H

#include "contender.h"

namespace bench {

struct Run {
  double seconds = 0;        ///< processor time, conversions included
  double own_seconds = 0;    ///< the same without conversions
  double wall_seconds = 0;   ///< on the wall clock, conversions included
  double peak_megabytes = 0; ///< the most memory held at a time, beyond the input mesh
  Soup answer;
};

/// What a run is for. Memory is measured where malloc() maps every large block by itself and gives
/// it back at once, so that what a program holds counts and not the holes that others have left;
/// that takes time.
enum class Purpose { time, memory };

/// What is done in a run, one after the other.
struct Work {
  std::function<void()> prepare; ///< is not measured
  /// Is measured. Returns processor time without conversions, where there are any.
  std::function<std::optional<double>()> simplify;
  std::function<Soup()> answer; ///< is not measured
};

/// Works in a child process, so that its memory can be measured, none of it is left for the next
/// one, and a crash costs one row. Empty when the child crashed, ran out of memory or took longer
/// than `limit` seconds.
std::optional<Run> run_in_child(const Work& work, double limit, Purpose purpose);

/// The work of a contender.
std::optional<Run> run_in_child(const Contender& contender, const Mesh& mesh, std::size_t faces,
                                double limit, Purpose purpose);

} // namespace bench

#endif
