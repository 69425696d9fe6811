#ifndef TEST_SUPPORT_HARD_SURFACES_H
#define TEST_SUPPORT_HARD_SURFACES_H

#include "soups.h"

#include <cstdint>

/// \file
/// Surfaces that come close to themselves, or of which the faces are hard to compute with.

namespace test {

/// A closed wall that winds around so many times, with so much space between its turns, and three
/// times as thick.
Soup spiral_wall(double turns, int steps, int height);

/// A closed bar with thin teeth, closer to each other than they are thick.
Soup comb(int teeth, int length, int height);

/// Two tori that go through each other's holes.
Soup tori_in_each_other(std::uint32_t n);

/// Two wavy sheets, one over the other, so far apart.
Soup close_sheets(std::uint32_t n, double gap);

/// A sphere with spikes at some of its points.
Soup spiked(int level, std::uint64_t seed);

/// A flat disc of slivers around its middle, in rings.
Soup flat_fan(std::uint32_t sectors, std::uint32_t rings);

/// Cubes on a lattice, each there or not by the seed, of which some touch along an edge or at a
/// point: a closed surface, which need not be manifold.
Soup random_cubes(int n, std::uint64_t seed);

} // namespace test

#endif // TEST_SUPPORT_HARD_SURFACES_H
