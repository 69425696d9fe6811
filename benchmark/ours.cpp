// SPDX-License-Identifier: MIT
//
// Quadrille's modes.

#include "contender.h"

#include <quadrille/simplify.h>

namespace bench {
namespace {

template <class Cost>
Answer simplify(Mesh& mesh, std::size_t faces) {
  quadrille::simplify<Cost, quadrille::OptimalPlacement>(mesh, quadrille::FaceCount{faces});
  return {};
}

} // namespace

std::vector<Contender> our_contenders() {
  return {{"Quadrille", "Quadric, OptimalPlacement, greedy order, Surface_mesh",
           simplify<quadrille::Quadric>},
          {"Quadrille memoryless",
           "MemorylessQuadric, OptimalPlacement, greedy order, Surface_mesh",
           simplify<quadrille::MemorylessQuadric>}};
}

} // namespace bench
