// SPDX-License-Identifier: MIT

#include "report.h"

#include "../table.h"

#include <algorithm>
#include <ostream>
#include <utility>

namespace bench {
namespace {

struct Column {
  const char* heading; ///< in a table
  const char* name;    ///< in a CSV file
  double unit;         ///< by which a table divides
  double (*figure)(const AttributeQuality& quality);
};

const std::vector<Column>& columns(Kind kind) {
  static const Column distance{"RMS", "rms", 1e-4,
                               [](const AttributeQuality& q) { return q.distance.rms; }};
  static const Column farthest{"max", "hausdorff", 1e-4,
                               [](const AttributeQuality& q) { return q.distance.hausdorff; }};
  static const std::vector<Column> texture{
      distance,
      farthest,
      {"texture RMS", "texture_rms", 1e-4, [](const auto& q) { return q.texture.rms; }},
      {"texture 99 %", "texture_99", 1e-4, [](const auto& q) { return q.texture.percentile_99; }},
      {"texture max", "texture_max", 1e-4, [](const auto& q) { return q.texture.greatest; }},
      {"bleeding %", "bleeding", 1e-2, [](const auto& q) { return q.texture.bleeding; }},
      {"turned over %", "turned_over", 1e-2, [](const auto& q) { return q.texture.flipped; }}};
  static const std::vector<Column> color{
      distance,
      farthest,
      {"colour RMS", "color_rms", 1e-2, [](const auto& q) { return q.color.rms; }},
      {"colour in>out", "color_in_out", 1e-2, [](const auto& q) { return q.color.in_to_out; }},
      {"colour out>in", "color_out_in", 1e-2, [](const auto& q) { return q.color.out_to_in; }}};
  return kind == Kind::texture ? texture : color;
}

std::vector<std::string> headings(Kind kind) {
  std::vector<std::string> result{"contender",  "factor", "faces",   "ms",
                                  "min-max ms", "own ms", "wall ms", "peak MB"};
  for (const Column& column : columns(kind))
    result.push_back(column.heading);
  result.push_back("open edges");
  return result;
}

std::vector<std::string> cells(const AttributeRow& row, Kind kind) {
  if (!row.quality || row.runs.empty())
    return {row.contender, "", "failed"};
  const Spread time = spread(row.runs, &Run::seconds);
  std::vector<std::string> result{row.contender,
                                  text(row.factor, row.factor < 1 ? 1 : 0),
                                  std::to_string(row.quality->faces),
                                  text(time.median * 1e3, 1),
                                  text(time.low * 1e3, 1) + "-" + text(time.high * 1e3, 1),
                                  text(spread(row.runs, &Run::own_seconds).median * 1e3, 1),
                                  text(spread(row.runs, &Run::wall_seconds).median * 1e3, 1),
                                  text(row.peak_megabytes, 1)};
  for (const Column& column : columns(kind))
    result.push_back(three_digits(column.figure(*row.quality) / column.unit));
  result.push_back(std::to_string(row.quality->open_edges));
  return result;
}

} // namespace

void write_csv(const AttributeResult& result, std::ostream& out) {
  out << "model,input_faces,input_open_edges,target_faces,contender,options,factor,runs,faces,"
         "median_ms,min_ms,max_ms,own_median_ms,wall_median_ms,peak_mb";
  for (const Column& column : columns(result.kind))
    out << ',' << column.name;
  out << ",open_edges\n";
  out.precision(6);
  for (const AttributeRow& row : result.rows) {
    if (!row.quality || row.runs.empty())
      continue;
    const Spread time = spread(row.runs, &Run::seconds);
    out << result.model << ',' << result.input_faces << ',' << result.input_open_edges << ','
        << result.target_faces << ',' << quoted(row.contender) << ',' << quoted(row.options) << ','
        << row.factor << ',' << row.runs.size() << ',' << row.quality->faces << ','
        << time.median * 1e3 << ',' << time.low * 1e3 << ',' << time.high * 1e3 << ','
        << spread(row.runs, &Run::own_seconds).median * 1e3 << ','
        << spread(row.runs, &Run::wall_seconds).median * 1e3 << ',' << row.peak_megabytes;
    for (const Column& column : columns(result.kind))
      out << ',' << column.figure(*row.quality);
    out << ',' << row.quality->open_edges << '\n';
  }
}

void write_markdown(const AttributeResult& result, std::ostream& out) {
  std::vector<std::vector<std::string>> table{headings(result.kind)};
  std::size_t runs = 0;
  for (const AttributeRow& row : result.rows) {
    table.push_back(cells(row, result.kind));
    runs = std::max(runs, row.runs.size());
  }
  out << "### " << result.model << ", " << (result.kind == Kind::texture ? "texture" : "colours")
      << ": " << result.input_faces << " to " << result.target_faces << " faces\n\n";
  write_table(table, out);
  out << "\nMedian of " << runs << " alternating runs, each in a process of its own, on "
      << processor() << ". The input has " << result.input_open_edges
      << " edges of other than two faces. Columns: benchmark/README.md; " << result.samples
      << " samples on each surface.\n\nWhat each ran with:\n\n";
  for (const AttributeRow& row : result.rows)
    out << "- " << row.contender << ": " << row.options << '\n';
}

} // namespace bench
