// Bytes are a surface and policies; what must hold of the result does.
#include "../cases/cases.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::Case input = test::make_case(test::Bytes({data, size}));
  const std::string violation = test::violation(input);
  if (violation.empty())
    return 0;
  std::cerr << violation << '\n' << input;
  std::abort();
}
