#ifndef QUADRILLE_EXAMPLES_PROGRAM_POLICY_OPTIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_POLICY_OPTIONS_H

/// \file
/// The options that are policies: costs, boundaries, topology, order.

#include "checked_words.h"
#include "options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

inline void add_boundary(CLI::App& app, Options& options) {
  const auto is_weight_or_lock = [](const std::string& word) {
    const std::optional<Amount> value = parse_amount(word);
    return word == "lock" || (value && !value->is_percentage);
  };
  app.add_option_function<std::string>(
         "--boundary",
         [&](const std::string& word) {
           options.locks_boundaries = word == "lock";
           if (!options.locks_boundaries)
             options.boundary_weight = amount_of(word).value;
         },
         "how firmly boundaries hold: a weight, 100 by default, or lock, by which each of their "
         "vertices stays where it is")
      ->check(word_that(is_weight_or_lock, "a weight, nor lock"))
      ->type_name("WEIGHT|lock")
      ->group("Policies");
}

inline void add_cost(CLI::App& app, Options& options) {
  take_one_of(
      app.add_option("--cost", options.cost,
                     "which pair is contracted first: by distance to the planes of all faces so "
                     "far, of the current faces, the same and of lost thin parts, with colours or "
                     "texture coordinates as further dimensions, or the shortest (default: "
                     "quadric, with all attributes of IN)"),
      {"quadric", "memoryless", "thin-features", "color", "texture", "length"},
      {{"memoryless-quadric", "memoryless"},
       {"thin-feature-quadric", "thin-features"},
       {"color-quadric", "color"},
       {"colour", "color"},
       {"texture-quadric", "texture"},
       {"edge-length", "length"}})
      ->group("Policies");
  take_one_of(app.add_option("--placement", options.placement,
                             "where the vertex goes (default: optimal, or midpoint with --cost "
                             "length)"),
              {"optimal", "endpoint", "midpoint"},
              {{"optimal-placement", "optimal"},
               {"endpoint-placement", "endpoint"},
               {"midpoint-placement", "midpoint"}})
      ->group("Policies");
  const auto is_angle = [](double degrees) { return degrees <= 180; };
  app.add_option("--crease", options.crease_degrees,
                 "edges with a greater angle between the normals of their two faces hold like "
                 "boundaries, with --cost quadric, color or texture")
      ->check(number_that(is_angle, "an angle from 0 to 180 degrees"))
      ->type_name("DEGREES")
      ->group("Policies");
}

/// What quadrics have beside planes, and where more faces stay.
inline void add_quadric(CLI::App& app, Options& options) {
  const auto add = [&](const char* name, auto function, const char* help,
                       const CLI::Validator& check, const char* type) {
    app.add_option_function<std::string>(name, function, help)
        ->check(check)
        ->type_name(type)
        ->group("Policies");
  };
  const auto is_weight = [](double) { return true; };
  add(
      "--lines", [&](const std::string& word) { options.line_weight = amount_of(word).value; },
      "how firmly vertices keep to the lines along their normals: 0.001 gives better triangles for "
      "a little more distance, 0.01 much better ones for more, with --cost quadric; 0 by default",
      number_that(is_weight, "a weight"), "WEIGHT");
  const auto is_angle = [](double degrees) { return degrees < 90; };
  add(
      "--normal-noise",
      [&](const std::string& word) { options.normal_noise = amount_of(word).value; },
      "the normals of IN are wrong by so much, as a standard deviation, with --cost quadric",
      number_that(is_angle, "an angle from 0 to less than 90 degrees"), "DEGREES");
  add(
      "--noise", [&](const std::string& word) { options.position_noise = amount_of(word); },
      "so are the vertices of IN, in its units or, with %, in parts of the diagonal", distance(),
      "D|P%");
  app.add_flag("--squared-areas", options.weighs_squared_area,
               "faces count as the squares of their areas, with --cost quadric")
      ->group("Policies");
  app.add_option("--importance", options.importance,
                 "more faces stay where the vertices of IN have greater values of this scalar, "
                 "which are at least 0: for 8 times the value about twice as many")
      ->type_name("NAME")
      ->group("Policies");
}

inline void add_region(CLI::App& app, Options& options) {
  app.add_option("--region", options.region,
                 "simplify these faces only, to the target that counts them alone, and leave all "
                 "others as they are: names of objects, groups or materials, or scalars of faces "
                 "with their values or not 0, as head,arm or label=3,label=7")
      ->check(word_that([](const std::string& list) { return !list.empty(); }, "a list of names"))
      ->type_name("LIST")
      ->group("Policies");
}

inline void add_labels(CLI::App& app, Options& options) {
  app.add_option("--labels", options.labels,
                 "regions of these attributes of integers of a glTF file stay, as its materials "
                 "do: names as _PART,_LAYER; other such attributes hold nothing")
      ->delimiter(',')
      ->type_name("LIST")
      ->group("Policies");
}

inline void add_topology(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--pairs", [&](const std::string& word) { options.pairs = amount_of(word); },
         "contract also vertices without an edge, if they are closer than this, in units of IN or, "
         "with %, in parts of the diagonal")
      ->check(distance())
      ->type_name("T|T%")
      ->group("Policies");
  take_one_of(
      app.add_option(
          "--topology", options.topology,
          "may holes close and components join? (default: kept except for small components, "
          "see --keep-parts, or free with --pairs)"),
      {"kept", "free"})
      ->group("Policies");
  CLI::Option* const drops =
      app.add_flag("--drop-parts", options.drops_parts,
                   "small components may be removed where that is the cheapest step; else "
                   "topology is kept. So it is of glTF, OBJ and PLY by default");
  CLI::Option* const keeps = app.add_flag("--keep-parts", options.keeps_parts,
                                          "no component vanishes: the default for other formats");
  drops->group("Policies");
  keeps->group("Policies");
}

/// What is kept of the surface beside its topology.
inline void add_promises(CLI::App& app, Options& options) {
  app.add_flag("--no-self-intersection", options.forbids_intersections,
               "no faces of OUT intersect that do not in IN; takes several times as long")
      ->group("Policies");
  const auto is_angle = [](double degrees) { return degrees > 0 && degrees < 180; };
  app.add_option("--normals", options.normal_degrees,
                 "no normal of OUT is further from those of IN that it stands for")
      ->check(number_that(is_angle, "an angle above 0 and below 180 degrees"))
      ->type_name("DEGREES")
      ->group("Policies");
  app.add_flag("--solid", options.keeps_solid,
               "OUT is a closed solid, as IN has to be: no faces intersect, and topology is kept; "
               "takes several times as long")
      ->group("Policies");
}

inline void add_seams(CLI::App& app, Options& options) {
  using quadrille::Seams;
  const auto set_seams = [&](const std::string& word) {
    options.seams = word == "kept"     ? Seams::kept
                    : word == "priced" ? Seams::priced
                    : word == "free"   ? Seams::free
                                       : Seams::soft;
  };
  take_one_of(app.add_option_function<std::string>(
                  "--seams", set_seams,
                  "do charts of a texture stay, or may their seams vanish: for the price of all "
                  "that this shows (soft), of the jump of the values (priced), or for none? "
                  "(default: soft)"),
              {"kept", "soft", "priced", "free"})
      ->group("Policies");
}

inline void add_order(CLI::App& app, Options& options) {
  const auto set_order = [&](const std::string& order) { options.is_relaxed = order == "relaxed"; };
  take_one_of(app.add_option_function<std::string>(
                  "--order", set_order,
                  "one pair after the other by a queue, or faster, in passes of many (default: "
                  "greedy)"),
              {"greedy", "relaxed"}, {{"greedy-order", "greedy"}, {"relaxed-order", "relaxed"}})
      ->group("Policies");
  app.add_option(
         "--threads", options.threads,
         "how many threads passes use, with --order relaxed, or parts, with --out-of-core; the "
         "result is the same for any number (default: all)")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->group("Policies");
}

} // namespace quadrille_examples

#endif
