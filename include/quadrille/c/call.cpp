#include <quadrille/c/call.h>
#include <quadrille/c/failures.h>
#include <quadrille/compiled/option_setting.h>
#include <quadrille/quadrille.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

namespace {

SoupChannelView::Kind kind_of(std::string_view word) {
  constexpr std::array<std::string_view, 4> kinds{"texture", "normals", "colors", "attributes"};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == word)
      return static_cast<SoupChannelView::Kind>(i);
  reject_value("kind", '"' + std::string(word) + '"',
               "one of texture, normals, colors, attributes");
}

// Copies the values of an option.
template <class Options>
void set_array_of(Options& options, const NamedArray& array) {
  set_array(options, array.name, [&]<class T>(T) {
    array.validate(array.array.rows > 0 ? 1 : 0);
    return array.numbers<T>();
  });
}

/// The arrays of a channel, and of a call, as the library reads them.
struct ReadChannel {
  explicit ReadChannel(const quadrille_call_channel& channel) : corners(channel.corners) {
    const NamedArray& array = channel.values;
    array.validate(0);
    view = {channel.kind, array.array.columns, {}, corners.rows(), channel.options};
    const std::size_t count = array.array.rows * array.array.columns;
    if (array.is_packed<double>()) {
      view.values = {static_cast<const double*>(array.array.data), count};
    } else {
      converted = array.numbers<double>();
      view.values = converted;
    }
  }

  ReadRows<std::uint32_t, 3> corners;
  std::vector<double> converted;
  SoupChannelView view;
};

struct ReadSoup {
  explicit ReadSoup(const quadrille_call& call)
      : points(call.points), triangles(call.triangles), labels(call.labels) {
    channels.reserve(call.channels.size());
    for (const quadrille_call_channel& channel : call.channels)
      channels.emplace_back(channel);
  }

  SoupView view() const {
    SoupView soup{points.rows(), triangles.rows(), labels.numbers(), {}};
    for (const ReadChannel& channel : channels)
      soup.channels.push_back(channel.view);
    return soup;
  }

  ReadRows<double, 3> points;
  ReadRows<std::uint32_t, 3> triangles;
  ReadRows<std::uint32_t, 1> labels;
  std::vector<ReadChannel> channels;
};

void forget_result(quadrille_call& call) {
  call.result = {};
  call.vertex_map.clear();
  call.old_to_new = {};
  call.new_to_old = {};
  call.report.clear();
  call.report_text.clear();
}

// Makes policies of the functions of the caller, which are those of the call.
void set_functions(const quadrille_call& call, SoupJob& job, CallProgress& progress) {
  job.proceed = [&](const Status& status) { return progress(status); };
  if (call.stop)
    job.stop = [&](const Status& status) { return answer_of(call.stop, "stop", view_of(status)); };
  if (call.filter)
    job.allows = [&](const SoupContraction& contraction) {
      return answer_of(call.filter, "filter", view_of(contraction));
    };
  if (call.cost)
    job.cost_function = [&](const SoupPair& pair) { return cost_of(call.cost, pair); };
}

void run(quadrille_call& call, const SimplifyJob& simplify) {
  forget_result(call);
  if (!call.points.is_given() || !call.triangles.is_given())
    throw std::invalid_argument("points or triangles are missing");
  call.is_cancelled = false;
  SoupJob job = call.job;
  if (call.points.array.type == QUADRILLE_FLOAT32)
    job.coordinates_are_floats = true;
  CallProgress progress(call.progress, call.is_cancelled);
  set_functions(call, job, progress);
  Levels of_maps;
  Levels& levels = call.levels ? call.levels->levels : of_maps;
  if (call.levels || job.maps)
    job.recorder = record_into(levels);
  const ReadSoup soup(call);
  call.result = simplify(soup.view(), job);
  if (job.maps)
    set_maps(call, soup.view(), levels);
  call.vertex_map.assign(call.result.vertex_map.begin(), call.result.vertex_map.end());
  call.result.vertex_map.clear();
  call.result.prepared = {};
}

} // namespace

std::int32_t run_call(quadrille_call& call, const SimplifyJob& simplify) {
  const std::int32_t code = code_of(call.error, [&] { run(call, simplify); });
  if (code != QUADRILLE_OK)
    forget_result(call);
  return code;
}

} // namespace quadrille::internal

using namespace quadrille::internal;

extern "C" {

quadrille_call* quadrille_call_new(void) {
  return new (std::nothrow) quadrille_call;
}

void quadrille_call_delete(quadrille_call* call) {
  delete call;
}

const char* quadrille_error(const quadrille_call* call) {
  return call->error.c_str();
}

int32_t quadrille_set_array(quadrille_call* call, const char* name, const quadrille_array* array) {
  return code_of(call->error, [&] {
    const std::string_view word = name;
    NamedArray named{name, *array};
    if (word == "points" || word == "triangles" || word == "labels") {
      named.validate(word == "labels" ? 1 : 3);
      (word == "points"      ? call->points
       : word == "triangles" ? call->triangles
                             : call->labels) = std::move(named);
    } else {
      set_array_of(call->job, named);
    }
  });
}

int32_t quadrille_set_double(quadrille_call* call, const char* name, double value) {
  return code_of(call->error, [&] { set_number(call->job, name, value); });
}

int32_t quadrille_set_int(quadrille_call* call, const char* name, int64_t value) {
  return quadrille_set_double(call, name, static_cast<double>(value));
}

int32_t quadrille_set_text(quadrille_call* call, const char* name, const char* word) {
  return code_of(call->error, [&] { set_word(call->job, name, word); });
}

int32_t quadrille_add_channel(quadrille_call* call, const char* kind, const quadrille_array* values,
                              const quadrille_array* corners) {
  return code_of(call->error, [&] {
    const std::string name = "channel " + std::to_string(call->channels.size());
    quadrille_call_channel channel{kind_of(kind), {name, *values}, {}, {}};
    channel.values.validate(0);
    if (corners) {
      channel.corners = {"the corners of " + name, *corners};
      channel.corners.validate(3);
    }
    call->channels.push_back(std::move(channel));
  });
}

int32_t quadrille_set_channel_double(quadrille_call* call, size_t channel, const char* name,
                                     double value) {
  return code_of(call->error, [&] { set_number(call->channel(channel).options, name, value); });
}

int32_t quadrille_set_channel_text(quadrille_call* call, size_t channel, const char* name,
                                   const char* word) {
  return code_of(call->error, [&] { set_word(call->channel(channel).options, name, word); });
}

int32_t quadrille_set_channel_array(quadrille_call* call, size_t channel, const char* name,
                                    const quadrille_array* array) {
  return code_of(call->error, [&] {
    set_array_of(call->channel(channel).options, NamedArray{name, *array});
  });
}

void quadrille_set_progress(quadrille_call* call, quadrille_progress_function function,
                            void* data) {
  call->progress = {function, data};
}

void quadrille_set_stop(quadrille_call* call, quadrille_stop_function function, void* data) {
  call->stop = {function, data};
}

void quadrille_set_filter(quadrille_call* call, quadrille_filter_function function, void* data) {
  call->filter = {function, data};
}

void quadrille_set_cost(quadrille_call* call, quadrille_cost_function function, void* data) {
  call->cost = {function, data};
}

void quadrille_set_levels(quadrille_call* call, quadrille_levels* levels) {
  call->levels = levels;
}

void quadrille_cancel(quadrille_call* call) {
  call->is_cancelled = true;
}

int32_t quadrille_simplify(quadrille_call* call) {
  return run_call(*call, simplified_by_job);
}

} // extern "C"
