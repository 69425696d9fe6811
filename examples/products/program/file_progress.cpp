#include "file_progress.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace quadrille_examples {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const quadrille::FileEstimate& estimate) {
  return {{"faces", estimate.faces},
          {"seconds", estimate.seconds},
          {"memory", estimate.memory},
          {"scratch", estimate.scratch},
          {"output", estimate.output > 0 ? Json(estimate.output) : Json(nullptr)}};
}

// As one line that is there at once, for whoever reads along.
void put_line(std::ofstream& file, const Json& json) {
  file << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

} // namespace

void FileProgress::write(const quadrille::FileStatus& status, Clock::time_point now) {
  Json json = {{"seconds", passed()},        {"stage", to_string(status.stage)},
               {"phase", status.phase},      {"phases", status.phases},
               {"chunks", status.chunks},    {"chunks_done", status.chunks_done},
               {"progress", status.progress}};
  if (const std::optional<double> seconds = to_go(status))
    json["seconds_left"] = *seconds;
  if (!last_) {
    json["input"] = options_.input;
    json["output"] = options_.output;
    json["estimate"] = json_of(status.estimate);
  }
  put_line(file_, json);
  written_ = now;
}

void FileProgress::end(const std::string& how, std::optional<std::size_t> faces_after,
                       const std::string& message) {
  if (!file_.is_open())
    return;
  Json json = {{"seconds", passed()}, {"stage", how}};
  if (!options_.step.empty())
    json["step"] = options_.step;
  if (faces_after)
    json["faces"] = *faces_after;
  if (!message.empty())
    json["message"] = message;
  put_line(file_, json);
}

} // namespace quadrille_examples
