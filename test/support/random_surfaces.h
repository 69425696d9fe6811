#ifndef TEST_SUPPORT_RANDOM_SURFACES_H
#define TEST_SUPPORT_RANDOM_SURFACES_H

/// \file
/// Surfaces to hold properties on: equal seeds are equal surfaces.

#include "soups.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace test {

/// A surface and its name.
struct Surface {
  std::string name;
  Soup soup;
};

/// A kind of surface: a test that goes over seeds takes one after the other.
struct SurfaceKind {
  const char* name;
  Soup (*make)(std::uint64_t seed, Random& random);
};
std::span<const SurfaceKind> surface_kinds();

/// The kind of the seed, or one of the models where that is a surface with borders; with noise,
/// turned, on a lattice, in another unit, far from the origin, by the seed.
Surface surface_of(std::uint64_t seed, const std::vector<Surface>& models);

} // namespace test

#endif // TEST_SUPPORT_RANDOM_SURFACES_H
