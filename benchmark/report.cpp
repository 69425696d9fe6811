// SPDX-License-Identifier: MIT

#include "report.h"
#include "table.h"

#include <CGAL/version.h>

#include <algorithm>
#include <ostream>

namespace bench {
namespace {

std::optional<double> reference_seconds(const Result& result) {
  for (const Row& row : result.rows)
    if (row.contender == reference && !row.runs.empty())
      return spread(row.runs, &Run::seconds).median;
  return {};
}

std::string per_ten_thousand(double value) {
  return three_digits(value * 1e4);
}

std::string speed(const Result& result, const Row& row) {
  const auto unit = reference_seconds(result);
  return unit ? three_digits(*unit / spread(row.runs, &Run::seconds).median) : "";
}

std::vector<std::string> cells(const Result& result, const Row& row) {
  if (!row.quality || row.runs.empty())
    return {row.contender, "failed"};
  const Quality& q = *row.quality;
  const Spread time = spread(row.runs, &Run::seconds);
  return {row.contender,
          std::to_string(q.faces),
          text(time.median * 1e3, 1),
          text(time.low * 1e3, 1) + "-" + text(time.high * 1e3, 1),
          text(spread(row.runs, &Run::own_seconds).median * 1e3, 1),
          text(spread(row.runs, &Run::wall_seconds).median * 1e3, 1),
          speed(result, row),
          text(row.peak_megabytes, 1),
          per_ten_thousand(q.distance.rms),
          per_ten_thousand(q.distance.rms_a_to_b),
          per_ten_thousand(q.distance.rms_b_to_a),
          per_ten_thousand(q.distance.hausdorff_a_to_b),
          per_ten_thousand(q.distance.hausdorff_b_to_a),
          std::to_string(q.flipped_faces),
          std::to_string(q.non_manifold_edges),
          std::to_string(q.highest_degree),
          text(q.smallest_angle, 1),
          text(q.low_angle, 1)};
}

const std::vector<std::string> headings{
    "contender",  "faces",   "ms",           "min-max ms", "own ms",     "wall ms",
    "speed",      "peak MB", "RMS",          "RMS in>out", "RMS out>in", "max in>out",
    "max out>in", "flipped", "non-manifold", "degree",     "angle",      "1% angle"};

std::size_t run_count(const Result& result) {
  std::size_t count = 0;
  for (const Row& row : result.rows)
    count = std::max(count, row.runs.size());
  return count;
}

} // namespace

void write_csv(const Result& result, std::ostream& out) {
  out << "model,input_faces,target_faces,contender,options,runs,faces,median_ms,min_ms,max_ms,"
         "own_median_ms,wall_median_ms,speed,peak_mb,rms,rms_in_out,rms_out_in,hausdorff,hausdorff_"
         "in_out,"
         "hausdorff_out_in,flipped_faces,non_manifold_edges,highest_degree,smallest_angle,low_"
         "angle\n";
  out.precision(6);
  for (const Row& row : result.rows) {
    if (!row.quality || row.runs.empty())
      continue;
    const Quality& q = *row.quality;
    const Spread time = spread(row.runs, &Run::seconds);
    out << result.model << ',' << result.input_faces << ',' << result.target_faces << ','
        << quoted(row.contender) << ',' << quoted(row.options) << ',' << row.runs.size() << ','
        << q.faces << ',' << time.median * 1e3 << ',' << time.low * 1e3 << ',' << time.high * 1e3
        << ',' << spread(row.runs, &Run::own_seconds).median * 1e3 << ','
        << spread(row.runs, &Run::wall_seconds).median * 1e3 << ',' << speed(result, row) << ','
        << row.peak_megabytes << ',' << q.distance.rms << ',' << q.distance.rms_a_to_b << ','
        << q.distance.rms_b_to_a << ',' << q.distance.hausdorff << ','
        << q.distance.hausdorff_a_to_b << ',' << q.distance.hausdorff_b_to_a << ','
        << q.flipped_faces << ',' << q.non_manifold_edges << ',' << q.highest_degree << ','
        << q.smallest_angle << ',' << q.low_angle << '\n';
  }
}

void write_markdown(const Result& result, std::ostream& out) {
  std::vector<std::vector<std::string>> table{headings};
  for (const Row& row : result.rows)
    table.push_back(cells(result, row));
  out << "### " << result.model << ": " << result.input_faces << " to " << result.target_faces
      << " faces\n\n";
  write_table(table, out);
  out << "\nMedian of " << run_count(result)
      << " alternating runs, each in a process of its own, on " << processor() << ".\n\n"
      << "- `ms`: processor time, which differs from the wall clock (`wall ms`) only where other "
      << "programs run; all are single-threaded. From Surface_mesh to Surface_mesh; `own ms`: "
      << "without the conversions. `speed`: times that of " << reference << ".\n"
      << "- `peak MB`: the most memory held, beyond the input mesh and the program itself; in a\n"
      << "  run of its own, in which malloc() maps large blocks one by one.\n"
      << "- `RMS`, and `max`, the Hausdorff distance: in 1e-4 of the bounding-box diagonal, from "
      << result.samples << " samples on each surface.\n"
      << "- `flipped`: faces folded over a neighbour and looking against the input. "
      << "`non-manifold`: edges of three faces or more. `degree`: the highest of a vertex.\n"
      << "- `angle`: the smallest of all faces, in degrees; `1% angle`: 1 % of the faces have a "
      << "smaller one.\n\n"
      << "What each ran with:\n\n";
  for (const Row& row : result.rows)
    out << "- " << row.contender << ": " << row.options << '\n';
  out << "\nCGAL " << CGAL_STR(CGAL_VERSION) << ", Simple_cartesian<double>.\n";
}

} // namespace bench
