#include "jobs.h"

#include <quadrille/distance.h>
#include <quadrille/verify.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

void measure_distance(const Work& work) {
  const quadrille_bag& bag = work.bag;
  const auto d = quadrille::surface_distance(
      bag.rows<double, 3>("a"), bag.rows<std::uint32_t, 3>("faces_a"), bag.rows<double, 3>("b"),
      bag.rows<std::uint32_t, 3>("faces_b"),
      {static_cast<std::size_t>(bag.numbers<std::uint64_t>("counts")[0]),
       bag.numbers<std::uint64_t>("counts")[1]});
  work.bag.give_numbers("distance", d.rms, d.hausdorff, d.rms_a_to_b, d.rms_b_to_a,
                        d.hausdorff_a_to_b, d.hausdorff_b_to_a);
}

/// Gives of each finding its claim, and promised, measured, error, whether it is held, and its
/// place.
void verify_result(const Work& work) {
  const quadrille_bag& bag = work.bag;
  quadrille::Claims claims;
  if (bag.has("distance"))
    claims.distance = bag.number("distance");
  if (bag.has("distance_both_ways"))
    claims.distance_both_ways = bag.number("distance_both_ways");
  if (bag.has("normal_deviation"))
    claims.normal_deviation = bag.number("normal_deviation");
  claims.no_self_intersection = bag.flag("no_self_intersection");
  claims.solid = bag.flag("solid");
  if (bag.has("tolerances")) {
    const auto tolerances = bag.numbers<double>("tolerances");
    claims.tolerances.assign(tolerances.begin(), tolerances.end());
  }
  if (bag.has("images")) {
    const auto images = bag.numbers<std::uint64_t>("images");
    claims.vertex_map.assign(images.begin(), images.end());
  }
  claims.progress = [&](double part) { return work.proceed(part); };
  const quadrille::Verdict told = quadrille::verify(
      bag.rows<double, 3>("points"), bag.rows<std::uint32_t, 3>("faces"),
      bag.rows<double, 3>("new_points"), bag.rows<std::uint32_t, 3>("new_faces"), claims);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> names;
  std::vector<std::array<double, 7>> rows;
  for (const auto& f : told.findings) {
    names.push_back(f.claim);
    const std::array<double, 3> place =
        f.place ? f.place->coordinates : std::array<double, 3>{none, none, none};
    rows.push_back(
        {f.promised, f.measured, f.error, f.is_met ? 1. : 0., place[0], place[1], place[2]});
  }
  work.bag.give_texts("claims", names);
  work.bag.give("findings", std::move(rows));
  work.bag.give_numbers("is_cancelled", told.is_cancelled);
}

} // namespace quadrille_examples
