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
         "--boundary,--boundary-weight",
         [&](const std::string& word) {
           options.locks_boundaries = word == "lock";
           if (!options.locks_boundaries)
             options.boundary_weight = amount_of(word).value;
         },
         "how firmly boundaries are kept: a weight (default: 100), or lock, which keeps each "
         "of their vertices in place")
      ->check(word_that(is_weight_or_lock, "a weight or lock"))
      ->type_name("WEIGHT|lock")
      ->group("Policies");
}

inline void add_cost(CLI::App& app, Options& options) {
  take_one_of(
      app.add_option(
          "--cost", options.cost,
          "which pair is contracted first, by distance to: the planes of all input faces "
          "(quadric), the current faces (memoryless), the current faces and thin features that "
          "are already lost (thin-features), or the planes of all input faces with colours or "
          "texture coordinates as the only attributes that count (color, texture); or the "
          "shortest edge (length); default: quadric, with all attributes of IN"),
      {"quadric", "memoryless", "thin-features", "color", "texture", "length"},
      {{"memoryless-quadric", "memoryless"},
       {"thin-feature-quadric", "thin-features"},
       {"color-quadric", "color"},
       {"colour", "color"},
       {"texture-quadric", "texture"},
       {"edge-length", "length"}})
      ->group("Policies");
  take_one_of(app.add_option(
                  "--placement", options.placement,
                  "where the new vertex goes (default: optimal, or midpoint with --cost length)"),
              {"optimal", "endpoint", "midpoint"},
              {{"optimal-placement", "optimal"},
               {"endpoint-placement", "endpoint"},
               {"midpoint-placement", "midpoint"}})
      ->group("Policies");
  const auto is_angle = [](double degrees) { return degrees <= 180; };
  app.add_option(
         "--crease,--crease-degrees", options.crease_degrees,
         "keep edges like boundaries where the angle between the normals of their two faces "
         "is greater (with --cost quadric, color or texture)")
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
      "--lines,--line-weight",
      [&](const std::string& word) { options.line_weight = amount_of(word).value; },
      "how firmly vertices are kept to the lines along their normals: 0.001 gives better "
      "triangles at a slightly larger distance, 0.01 much better ones at a larger one "
      "(default: 0, with --cost quadric)",
      number_that(is_weight, "a weight"), "WEIGHT");
  const auto is_angle = [](double degrees) { return degrees < 90; };
  add(
      "--normal-noise",
      [&](const std::string& word) { options.normal_noise = amount_of(word).value; },
      "the standard deviation of the errors in the normals of IN (with --cost quadric)",
      number_that(is_angle, "an angle from 0 to less than 90 degrees"), "DEGREES");
  add(
      "--noise,--position-noise",
      [&](const std::string& word) { options.position_noise = amount_of(word); },
      "the standard deviation of the errors in the positions of IN, in its units or as a "
      "percentage of the diagonal (with --cost quadric)",
      distance(), "D|P%");
  app.add_flag("--squared-areas", options.weighs_squared_area,
               "weight faces by the squares of their areas (with --cost quadric)")
      ->group("Policies");
  app.add_option(
         "--importance", options.importance,
         "keep more faces where this scalar of the vertices of IN is larger: about twice as "
         "many for 8 times the value; values are at least 0")
      ->type_name("NAME")
      ->group("Policies");
}

inline void add_region(CLI::App& app, Options& options) {
  app.add_option(
         "--region", options.region,
         "simplify only these faces, leave all others as they are, and count only these for "
         "the target: names of objects, groups or materials (head,arm), or scalars of faces "
         "with a value or not 0 (label=3,label=7)")
      ->check(word_that([](const std::string& list) { return !list.empty(); }, "a list of names"))
      ->type_name("LIST")
      ->group("Policies");
}

inline void add_labels(CLI::App& app, Options& options) {
  app.add_option("--labels", options.labels,
                 "keep the regions of these integer attributes of a glTF file, as those of its "
                 "materials: names such as _PART,_LAYER; other integer attributes have no effect")
      ->delimiter(',')
      ->type_name("LIST")
      ->group("Policies");
}

inline void add_preset(CLI::App& app, Options& options) {
  take_one_of(app.add_option("--preset", options.preset,
                             "the options of a kind of surface, where others are not given: see "
                             "the manual, or -v, which prints them"),
              {"generated", "scan", "voxels", "print", "cad", "terrain", "game"})
      ->group("Policies");
}

inline void add_topology(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--pairs,--pairs-closer-than",
         [&](const std::string& word) { options.pairs = amount_of(word); },
         "also contract vertices without an edge between them that are closer than this, in "
         "the units of IN or as a percentage of the diagonal")
      ->check(distance())
      ->type_name("T|T%")
      ->group("Policies");
  take_one_of(
      app.add_option(
          "--topology", options.topology,
          "may holes close and components join? (default: kept, except that small components "
          "may vanish, see --keep-parts; free with --pairs)"),
      {"kept", "free"})
      ->group("Policies");
  app.add_option_function<std::string>(
         "--cut-handles,--simplified-topology",
         [&](const std::string& word) { options.handles = amount_of(word); },
         "tunnels and handles no wider than this, in units of IN or, with %, in parts of the "
         "diagonal, are cut first and closed there; the rest of the topology is kept")
      ->check(distance())
      ->type_name("SIZE|SIZE%")
      ->group("Policies");
  CLI::Option* const drops = app.add_flag(
      "--drop-parts", options.drops_components,
      "small components may be removed where that is the cheapest step; the rest of the "
      "topology is kept. This is the default for glTF, OBJ and PLY");
  CLI::Option* const keeps =
      app.add_flag("--keep-parts", options.keeps_components,
                   "no component vanishes. This is the default for other formats");
  drops->group("Policies");
  keeps->group("Policies");
}

/// What is kept of the surface beside its topology.
inline void add_promises(CLI::App& app, Options& options) {
  app.add_flag(
         "--no-self-intersection", options.forbids_intersections,
         "no faces of OUT intersect that did not intersect in IN; takes several times as long")
      ->group("Policies");
  const auto is_angle = [](double degrees) { return degrees > 0 && degrees < 180; };
  app.add_option(
         "--normals,--normal-deviation", options.normal_degrees,
         "no normal of OUT deviates by more than this from the normals of IN that it replaces")
      ->check(number_that(is_angle, "an angle above 0 and below 180 degrees"))
      ->type_name("DEGREES")
      ->group("Policies");
  app.add_flag("--solid,--keep-solid", options.keeps_solid,
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
  take_one_of(
      app.add_option_function<std::string>(
          "--seams", set_seams,
          "may seams of a texture vanish? never (kept), at a cost for everything that becomes "
          "visible (soft), at the cost of the jump in the values (priced), or at no cost "
          "(free) (default: soft)"),
      {"kept", "soft", "priced", "free"})
      ->group("Policies");
}

inline void add_order(CLI::App& app, Options& options) {
  const auto set_order = [&](const std::string& order) { options.is_relaxed = order == "relaxed"; };
  take_one_of(
      app.add_option_function<std::string>(
          "--order", set_order,
          "contract one pair after another by a queue, or many in each pass, which is faster "
          "(default: greedy)"),
      {"greedy", "relaxed"}, {{"greedy-order", "greedy"}, {"relaxed-order", "relaxed"}})
      ->group("Policies");
  app.add_option("--threads", options.threads,
                 "the number of threads for the passes of --order relaxed or the chunks of "
                 "--out-of-core; the result is the same for any number (default: all)")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->group("Policies");
}

} // namespace quadrille_examples

#endif
