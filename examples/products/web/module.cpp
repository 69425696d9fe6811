// What index.js of the package calls: simplified_soup() and Levels by functions of C, whose
// arguments and results are numbers and addresses in the memory of the module. None of them throws.
// Names of functions are those that JavaScript sees.

#include "call.h"
#include "json.h"
#include "options.h"
#include "proceed.h"

#include <quadrille/levels.h>
#include <quadrille/stop.h>
#include <quadrille/version.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>

namespace quadrille_examples {

namespace {

/// Levels, and the one that was asked for last.
struct RecordedLevels {
  quadrille::Levels levels;
  quadrille::Level level;
  Call answers; // its text and view
};

/// Calls task(stop) with the one that a name and a number say.
template <class Task>
void with_stop(std::string_view name, double number, Task task) {
  const auto count = [number] { return static_cast<std::size_t>(number); };
  if (name == "faces")
    task(quadrille::FaceCount{count()});
  else if (name == "vertices")
    task(quadrille::VertexCount{count()});
  else if (name == "error")
    task(quadrille::ErrorAtMost{number});
  else if (name == "distance")
    task(quadrille::DistanceAtMost{number});
  else if (name == "contractions")
    task(quadrille::AfterContractions{count()});
  else
    reject_option(name);
}

template <class Answer>
const ArrayView* text_view(Answer& answer) {
  answer.view = {answer.text.data(), static_cast<std::uint32_t>(answer.text.size())};
  return &answer.view;
}

} // namespace

extern "C" {

QUADRILLE_EXPORT(version) std::uint32_t version() {
  return 10000 * QUADRILLE_VERSION_MAJOR + 100 * QUADRILLE_VERSION_MINOR + QUADRILLE_VERSION_PATCH;
}

// --- A call: made, filled, run, read, deleted

QUADRILLE_EXPORT(newCall) Call* new_call() {
  return new (std::nothrow) Call;
}
QUADRILLE_EXPORT(deleteCall) void delete_call(Call* call) {
  delete call;
}
/// Room for a name of so many bytes, which calls below read.
QUADRILLE_EXPORT(nameRoom) char* name_room(Call* call, std::size_t bytes) {
  return call->succeeds([&] { call->text.assign(bytes, ' '); }) ? call->text.data() : nullptr;
}
/// Room for an array of the input. The name is read before.
QUADRILLE_EXPORT(inputRoom) void* input_room(Call* call, std::size_t count) {
  void* room = nullptr;
  call->succeeds([&] { room = room_for_input(*call, std::string(call->text), count); });
  return room;
}
/// Adds a channel of a kind.
QUADRILLE_EXPORT(addChannel) bool add_channel(Call* call, std::size_t components) {
  return call->succeeds([&] {
    const auto kind = chosen(kinds, "kind", std::string(call->text));
    call->channels.push_back({kind, components, {}, {}, {}});
  });
}
/// Room for the values of the last channel, or for the indices of its corners.
QUADRILLE_EXPORT(channelRoom)
void* channel_room(Call* call, bool is_of_corners, std::size_t count) {
  void* room = nullptr;
  CallChannel& channel = call->channels.back();
  call->succeeds([&] {
    room = is_of_corners ? room_in(channel.triangles, count) : room_in(channel.values, count);
  });
  return room;
}
/// Sets an option of the call, or of the last channel.
QUADRILLE_EXPORT(setNumber) bool set_number_of(Call* call, bool is_of_channel, double value) {
  return call->succeeds([&] {
    const std::string name = call->text;
    is_of_channel ? set_number(call->channels.back().options, name, value)
                  : set_number(call->options, name, value);
  });
}
/// The text is "name=value".
QUADRILLE_EXPORT(setChoice) bool set_choice_of(Call* call, bool is_of_channel) {
  return call->succeeds([&] {
    const std::string text = call->text;
    const std::string_view all = text, name = all.substr(0, all.find('='));
    const std::string_view value = all.substr(name.size() + 1);
    is_of_channel ? set_choice(call->channels.back().options, name, value)
                  : set_choice(call->options, name, value);
  });
}
QUADRILLE_EXPORT(run) bool run(Call* call, RecordedLevels* levels, bool reports_progress) {
  return call->succeeds([&] {
    if (reports_progress)
      call->options.proceed = proceed;
    call->run(levels ? &levels->levels : nullptr);
    call->text = json_of(call->result.report);
  });
}
/// The report, or what was wrong.
QUADRILLE_EXPORT(text) const ArrayView* text(Call* call) {
  return text_view(*call);
}
QUADRILLE_EXPORT(output) const ArrayView* output(Call* call, std::size_t channel) {
  call->view = view_of_output(call->result, call->text, channel);
  return &call->view;
}

// --- Levels

QUADRILLE_EXPORT(newLevels) RecordedLevels* new_levels() {
  return new (std::nothrow) RecordedLevels;
}
QUADRILLE_EXPORT(deleteLevels) void delete_levels(RecordedLevels* levels) {
  delete levels;
}
QUADRILLE_EXPORT(levelNameRoom) char* level_name_room(RecordedLevels* levels, std::size_t bytes) {
  return name_room(&levels->answers, bytes);
}
/// Finds the level of a stop, whose name has been written; reads it, or tells of it only.
QUADRILLE_EXPORT(findLevel)
bool find_level(RecordedLevels* levels, double number, bool with_surface) {
  Call& answers = levels->answers;
  return answers.succeeds([&] {
    with_stop(std::string(answers.text), number, [&](const auto& stop) {
      if (with_surface)
        levels->level = levels->levels.at(stop);
      answers.text = json_of(with_surface ? levels->level : levels->levels.info(stop));
    });
  });
}
QUADRILLE_EXPORT(levelText) const ArrayView* level_text(RecordedLevels* levels) {
  return text_view(levels->answers);
}
QUADRILLE_EXPORT(levelOutput)
const ArrayView* level_output(RecordedLevels* levels, std::size_t channel) {
  levels->answers.view = view_of_output(levels->level, levels->answers.text, channel);
  return &levels->answers.view;
}
/// Gives back the memory of the level that was read.
QUADRILLE_EXPORT(forgetLevel) void forget_level(RecordedLevels* levels) {
  levels->level = {};
}

} // extern "C"

} // namespace quadrille_examples
