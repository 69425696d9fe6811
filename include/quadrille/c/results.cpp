#include <quadrille/c/arrays.h>
#include <quadrille/c/call.h>
#include <quadrille/c/failures.h>
#include <quadrille/c/report_members.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadrille.h>
#include <quadrille/report.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace quadrille::internal {

namespace {

// --- Members of a report as JSON

std::string json(std::size_t count) {
  return std::to_string(count);
}
std::string json(bool flag) {
  return flag ? "true" : "false";
}
std::string json(double number) {
  return std::isfinite(number) ? text_of(number) : "null";
}
std::string json(StopReason reason) {
  return '"' + std::string(to_string(reason)) + '"';
}
std::string json(const std::optional<double>& number) {
  return number ? json(*number) : "null";
}
std::string json(const std::optional<Report::UsedTolerance>& used) {
  if (!used)
    return "null";
  const auto& [x, y, z] = used->place;
  return '[' + json(used->fraction) + ", [" + json(x) + ", " + json(y) + ", " + json(z) + "]]";
}
std::string json(const std::optional<Report::SelfIntersections>& counts) {
  return counts ? '[' + json(counts->before) + ", " + json(counts->after) + ']' : "null";
}
std::string json(const std::array<std::size_t, rejection_causes>& rejections) {
  std::string members;
  for (std::size_t cause = 0; cause < rejections.size(); ++cause)
    if (rejections[cause] > 0)
      members += (members.empty() ? "\"" : ", \"") +
                 std::string(to_string(static_cast<Rejection>(cause))) +
                 "\": " + json(rejections[cause]);
  return '{' + members + '}';
}
std::string json(const Report::Seconds& seconds) {
  return "{\"read\": " + json(seconds.read) + ", \"prepare\": " + json(seconds.prepare) +
         ", \"contract\": " + json(seconds.contract) + ", \"write\": " + json(seconds.write) + '}';
}

// --- Numbers of a report

std::optional<double> number(std::size_t count) {
  return static_cast<double>(count);
}
std::optional<double> number(bool flag) {
  return flag ? 1 : 0;
}
std::optional<double> number(double value) {
  return value;
}
std::optional<double> number(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::infinity());
}
std::optional<double> number(const Report::Seconds& seconds) {
  return seconds.total();
}
template <class Other>
std::optional<double> number(const Other&) {
  return std::nullopt;
}

// --- Arrays of a result

// Returns an array of a sparse map, or nothing if no name begins like that.
std::optional<quadrille_array> array_of(const SparseRows& rows, std::string_view map,
                                        std::string_view name) {
  if (!name.starts_with(map))
    return std::nullopt;
  const std::string_view suffix = name.substr(map.size());
  if (suffix == "_begins")
    return view_of(rows.begins);
  if (suffix == "_indices")
    return view_of(rows.indices);
  if (suffix == "_weights")
    return view_of(rows.weights);
  return std::nullopt;
}

quadrille_array array_of(const quadrille_call& call, std::string_view name, std::size_t channel) {
  const SoupResult& result = call.result;
  if (const auto found = array_of(call.old_to_new, "old_to_new", name))
    return *found;
  if (const auto found = array_of(call.new_to_old, "new_to_old", name))
    return *found;
  if (name == "points")
    return view_of(result.points);
  if (name == "triangles")
    return view_of(result.triangles);
  if (name == "labels")
    return view_of(result.labels);
  if (name == "input_faces")
    return view_of(result.input_faces);
  if (name == "vertex_map")
    return view_of(call.vertex_map);
  if (name != "values" && name != "corners")
    throw std::invalid_argument("a result has no array " + std::string(name));
  if (channel >= result.channels.size())
    throw std::out_of_range("the channel is " + std::to_string(channel) + ", but the result has " +
                            std::to_string(result.channels.size()) + ", numbered from 0");
  const SoupChannel& found = result.channels[channel];
  return name == "values" ? view_of(found.values, found.components) : view_of(found.triangles);
}

} // namespace

std::string json_of(const Report& report) {
  std::string members;
  visit_members(report, [&](const char* name, const auto& member) {
    members += (members.empty() ? "\"" : ", \"") + std::string(name) + "\": " + json(member);
  });
  return '{' + members + '}';
}

} // namespace quadrille::internal

using namespace quadrille::internal;

extern "C" {

int32_t quadrille_result(quadrille_call* call, const char* name, size_t channel,
                         quadrille_array* view) {
  return code_of(call->error, [&] { *view = array_of(*call, name, channel); });
}

int32_t quadrille_copy_result(quadrille_call* call, const char* name, size_t channel, void* to,
                              int32_t type, ptrdiff_t row_stride) {
  return code_of(call->error,
                 [&] { copy_array(array_of(*call, name, channel), to, type, row_stride); });
}

const char* quadrille_report(quadrille_call* call) {
  code_of(call->error, [&] { call->report = json_of(call->result.report); });
  return call->report.c_str();
}

int32_t quadrille_report_number(quadrille_call* call, const char* name, double* value) {
  return code_of(call->error, [&] {
    bool is_found = false;
    visit_members(call->result.report, [&](std::string_view member, const auto& of_report) {
      if (member != name)
        return;
      if (const std::optional<double> found = number(of_report)) {
        *value = *found;
        is_found = true;
      }
    });
    if (!is_found)
      throw std::invalid_argument("a report has no number " + std::string(name));
  });
}

const char* quadrille_report_text(quadrille_call* call) {
  code_of(call->error, [&] {
    std::ostringstream text;
    text << call->result.report;
    call->report_text = std::move(text).str();
  });
  return call->report_text.c_str();
}

} // extern "C"
