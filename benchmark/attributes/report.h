// SPDX-License-Identifier: MIT
//
// The results of one model with attributes, as a table to read and as CSV to compute with.

#ifndef QUADRILLE_BENCHMARK_ATTRIBUTES_REPORT_H
#define QUADRILLE_BENCHMARK_ATTRIBUTES_REPORT_H

#include "../child.h"
#include "measure.h"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace bench {

struct AttributeRow {
  std::string contender;
  std::string options;
  double factor = 1;     ///< the best one
  std::vector<Run> runs; ///< without their answers; empty when the contender failed
  std::optional<AttributeQuality> quality;
  double peak_megabytes = 0;
};

struct AttributeResult {
  std::string model;
  Kind kind;
  std::size_t input_faces;
  std::size_t input_open_edges;
  std::size_t target_faces;
  std::size_t samples;
  std::vector<AttributeRow> rows;
};

void write_csv(const AttributeResult& result, std::ostream& out);
void write_markdown(const AttributeResult& result, std::ostream& out);

} // namespace bench

#endif
