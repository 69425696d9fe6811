// SPDX-License-Identifier: MIT
//
// The results of one model, as a table to read and as CSV to compute with.

#ifndef QUADRILLE_BENCHMARK_REPORT_H
#define QUADRILLE_BENCHMARK_REPORT_H

#include "child.h"
#include "measure.h"

#include <iosfwd>

namespace bench {

struct Row {
  std::string contender;
  std::string options;
  std::vector<Run> runs; ///< without their answers; empty when the contender failed
  std::optional<Quality> quality;
  double peak_megabytes = 0;
};

struct Result {
  std::string model;
  std::size_t input_faces;
  std::size_t target_faces;
  std::size_t samples;
  std::vector<Row> rows;
};

/// The contender whose median time is the unit of speed.
inline constexpr const char* reference = "CGAL GH plane";

void write_csv(const Result& result, std::ostream& out);
void write_markdown(const Result& result, std::ostream& out);

} // namespace bench

#endif
