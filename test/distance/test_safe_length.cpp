#include <quadrille/internal/core/base/safe_length.h>

#include <catch2/catch.hpp>

#include <limits>

using quadrille::internal::safe_length;

TEST_CASE("lengths whose squares over- or underflow") {
  CHECK(safe_length(3, -4, 12) == 13);
  CHECK(safe_length(-12, 3, 4) == 13);
  CHECK(safe_length(4, 12, -3) == 13);
  CHECK(safe_length(0, 0, 0) == 0);
  CHECK(safe_length(0x3p1000, 0x4p1000, 0) == 0x5p1000);
  CHECK(safe_length(0, 0x3p-1070, 0x4p-1070) == 0x5p-1070);
  CHECK(safe_length(0, 0, (std::numeric_limits<double>::max)()) ==
        (std::numeric_limits<double>::max)());
}

TEST_CASE("lengths have the same bits with any standard library") {
  CHECK(safe_length(0.1, 0.2, 0.3) == 0x1.7f254dab9cc3bp-2);
  CHECK(safe_length(1.1, -2.3, 0.7) == 0x1.526a07f81b966p+1);
}
