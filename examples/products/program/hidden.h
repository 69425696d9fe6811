#ifndef QUADRILLE_EXAMPLES_PROGRAM_HIDDEN_H
#define QUADRILLE_EXAMPLES_PROGRAM_HIDDEN_H

/// \file
/// Faces of IN that are not seen from outside: --hidden.

#include "../mesh_io/amount.h"
#include "../mesh_io/mesh/indexed_mesh.h"

#include <quadrille/compiled.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quadrille_examples {

struct Options;
class ProgressLine;

/// The value of --hidden: a mode, and the fraction of directions up to which a face is hidden.
struct HiddenChoice {
  std::string mode; ///< drop, report or weight; empty: nobody looks for hidden faces
  std::optional<double> threshold = {};

  bool is_given() const { return !mode.empty(); }
  bool drops() const { return mode == "drop"; }
};

/// Reads `drop`, `report` or `weight`; for the first two a threshold may follow, as in `drop=0.2%`.
inline std::optional<HiddenChoice> parse_hidden(const std::string& word) {
  const std::size_t equals = word.find('=');
  HiddenChoice choice{word.substr(0, equals)};
  const bool takes_threshold = choice.mode == "drop" || choice.mode == "report";
  if (!takes_threshold && choice.mode != "weight")
    return std::nullopt;
  if (equals == std::string::npos)
    return choice;
  const std::optional<Amount> amount = parse_amount(word.substr(equals + 1));
  if (!takes_threshold || !amount || !(amount->value < 1))
    return std::nullopt;
  choice.threshold = amount->value;
  return choice;
}

/// Figures of the hidden faces of IN.
struct HiddenSummary {
  struct Group {
    std::string kind;
    std::size_t faces;
    double area, volume, diagonal;
  };
  std::string mode;
  double threshold = 0;
  std::size_t faces = 0, hidden = 0; ///< of IN
  double area_fraction = 0;          ///< the hidden area as a fraction of the whole one
  std::size_t cut_edges = 0;
  std::size_t dropped = 0;        ///< faces
  std::size_t caps = 0;           ///< loops that were closed
  std::vector<Group> groups = {}; ///< the largest area first
};

/// The answer to --hidden for a surface.
struct HiddenAnswer {
  std::optional<HiddenSummary> summary = {};
  std::vector<bool> is_dropped = {};    ///< empty, or a value for each face
  std::vector<double> importances = {}; ///< empty, or a factor for each point
};

/// Looks for hidden faces if --hidden asks for it, and prints what it finds; those to drop leave
/// edges open. Throws Interrupted.
HiddenAnswer find_hidden(const Options& options, const quadrille::SoupPoints& points,
                         const quadrille::SoupTriangles& triangles, ProgressLine& progress);

/// Does what --hidden asks for: drops hidden faces, with whatever belongs to them, and closes the
/// surface where that opens it, or only reports
/// them, or gives vertices the more importance the more they are seen. Throws Interrupted.
std::optional<HiddenSummary> prepare_hidden(Options& options, IndexedMesh& mesh,
                                            ProgressLine& progress);

} // namespace quadrille_examples

#endif
