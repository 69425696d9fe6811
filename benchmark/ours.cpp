// SPDX-License-Identifier: MIT
//
// Quadrille's modes.

#include "contender.h"

#include <quadrille/simplify.h>

namespace bench {
namespace {

Answer greedy(Mesh& mesh, std::size_t faces) {
  quadrille::simplify<quadrille::Quadric, quadrille::OptimalPlacement>(mesh,
                                                                       quadrille::FaceCount{faces});
  return {};
}

} // namespace

std::vector<Contender> our_contenders() {
  return {{"Quadrille", "Quadric, OptimalPlacement, greedy order, Surface_mesh", greedy}};
}

} // namespace bench
