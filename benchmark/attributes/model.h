// SPDX-License-Identifier: MIT
//
// Surfaces with attributes: read, made, and brought into the form that a contender takes.

#ifndef QUADRILLE_BENCHMARK_ATTRIBUTES_MODEL_H
#define QUADRILLE_BENCHMARK_ATTRIBUTES_MODEL_H

#include "contender.h"

#include <string>

namespace bench {

struct Model {
  Kind kind;
  Soup soup; ///< points at the same place are one, as are equal values
};

/// Texture coordinates of a file, or colours, from 0 to 1, where it has none. Throws where it has
/// neither.
Model read_model(const std::string& file);

/// A sphere of 1280 faces. Its texture has one seam, from pole to pole.
Model sphere(Kind kind);

/// The weight of a channel by default: see quadrille::ChannelOptions.
double default_weight(const Model& model);

/// Makes points one for each place and value, so that triangles of points and of values are the
/// same.
void split_points(Soup& soup);

/// Leaves out points and values of no triangle; the triangles of points and values are the same.
void drop_unused_points(Soup& soup);

/// The inverse of split_points(): points at the same place are one, and so are equal values.
/// Triangles that collapse are left out.
void weld_points(Soup& soup);

} // namespace bench

#endif
