// SPDX-License-Identifier: MIT

#include "table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <ostream>

namespace bench {
namespace {

std::string padded(const std::string& cell, std::size_t width, bool left) {
  const std::string space(width - cell.size(), ' ');
  return left ? cell + space : space + cell;
}

} // namespace

Spread spread(const std::vector<Run>& runs, double Run::*figure) {
  std::vector<double> values;
  for (const Run& run : runs)
    values.push_back(run.*figure);
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return {values.front(), (values[(n - 1) / 2] + values[n / 2]) / 2, values.back()};
}

std::string text(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

std::string three_digits(double value) {
  return text(value, value < 1 ? 3 : value < 10 ? 2 : value < 100 ? 1 : 0);
}

std::string quoted(const std::string& cell) {
  return '"' + cell + '"';
}

void write_table(const std::vector<std::vector<std::string>>& table, std::ostream& out) {
  std::vector<std::size_t> width(table.front().size(), 0);
  for (const auto& row : table)
    for (std::size_t i = 0; i < row.size(); ++i)
      width[i] = std::max(width[i], row[i].size());
  const auto write_row = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < width.size(); ++i)
      out << "| " << padded(i < row.size() ? row[i] : "", width[i], i == 0) << ' ';
    out << "|\n";
  };
  write_row(table.front());
  for (std::size_t i = 0; i < width.size(); ++i)
    out << '|' << std::string(width[i] + 1, '-') << (i == 0 ? "-" : ":");
  out << "|\n";
  std::for_each(table.begin() + 1, table.end(), write_row);
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

} // namespace bench
