#include <quadrille/compiled/presets.h>
#include <quadrille/compiled/soup_job.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace quadrille::internal {

namespace {

// Throws std::invalid_argument if two options are given that choose the engine.
void require_one_engine(const SoupJob& job) {
  const std::array<std::pair<bool, std::string_view>, 4> asked{
      {{job.hull.has_value(), "hull"},
       {job.keep_volume, "keep_volume"},
       {job.calibrated, "calibrated"},
       {static_cast<bool>(job.cost_function), "a function as cost"}}};
  std::string_view first;
  for (const auto& [is_asked, name] : asked)
    if (is_asked) {
      if (!first.empty())
        throw std::invalid_argument(std::string(first) + " does not go with " + std::string(name));
      first = name;
    }
}

// Throws std::invalid_argument for options that do not go with a hull or a constant volume.
void check_star_placement(const SoupJob& job) {
  const std::string name = job.hull ? "hull" : "keep_volume";
  if (job.cost != SoupOptions::Cost::quadric && job.cost != SoupOptions::Cost::memoryless_quadric)
    throw std::invalid_argument(name + " needs the cost memoryless_quadric");
  if (job.order != SoupOptions::Order::greedy)
    throw std::invalid_argument(name + " needs the order greedy");
  if (job.placement)
    throw std::invalid_argument(name + " has its own placement, and does not go with another one");
}

} // namespace

SoupResult simplified_by_job(const SoupView& soup, const SoupJob& given) {
  require_one_engine(given);
  SoupJob job = given;
  if (job.recorder)
    static_cast<SoupOptions&>(job) = options_of_levels(given, soup);
  if (job.cost_function)
    return soup_by_cost(soup, job, job.cost_function);
  if (job.calibrated)
    return calibrated_soup(soup, job);
  if (!job.hull && !job.keep_volume)
    return simplified_soup(soup, job);
  check_star_placement(job);
  SoupJob memoryless = job;
  static_cast<SoupOptions&>(memoryless) = with_preset(job, soup);
  memoryless.keep_planes = job.keep_planes; // what a preset has does not go with these placements
  if (job.hull)
    memoryless.topology = job.topology;
  memoryless.cost = SoupOptions::Cost::memoryless_quadric;
  if (job.keep_volume)
    return soup_of_same_volume(soup, memoryless);
  return hull_of_soup(soup, memoryless, *job.hull == SoupJob::Hull::outer);
}

} // namespace quadrille::internal
