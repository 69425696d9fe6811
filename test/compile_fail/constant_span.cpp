// A span of constant numbers.
#include "surfaces.h"

#include <cstdint>
#include <span>

int main() {
  using namespace quadrille;
  std::vector<std::uint32_t> indices;
#ifdef REMEDY
  std::span<float> numbers;
#else
  std::span<const float> numbers;
#endif
  simplify(numbers, indices, FaceCount{10}); // mistake
}
