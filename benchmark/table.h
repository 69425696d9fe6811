// SPDX-License-Identifier: MIT
//
// What tables and CSV files are made of.

#ifndef QUADRILLE_BENCHMARK_TABLE_H
#define QUADRILLE_BENCHMARK_TABLE_H

#include "child.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace bench {

struct Spread {
  double low, median, high;
};

/// Of a figure of some runs; there is one at least.
Spread spread(const std::vector<Run>& runs, double Run::*figure);

std::string text(double value, int decimals);
std::string three_digits(double value); ///< three significant digits, whatever the size
std::string quoted(const std::string& cell);

/// Writes rows of cells in Markdown, the first one as headings. Cells that a row lacks are empty.
void write_table(const std::vector<std::vector<std::string>>& table, std::ostream& out);

/// The name of the processor, where the system tells it.
std::string processor();

} // namespace bench

#endif
