// Flat numbers that cannot be changed.
#include "surfaces.h"

#include <cstdint>

int main() {
  using namespace quadrille;
  std::vector<float> numbers;
#ifdef REMEDY
  std::vector<std::uint32_t> indices;
#else
  const std::vector<std::uint32_t> indices;
#endif
  simplify(numbers, indices, FaceCount{10}); // mistake
}
