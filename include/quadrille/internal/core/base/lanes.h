#ifndef QUADRILLE_INTERNAL_CORE_BASE_LANES_H
#define QUADRILLE_INTERNAL_CORE_BASE_LANES_H

#include <quadrille/internal/core/base/compiler.h>

#include <cstddef>

namespace quadrille::internal {

#if QUADRILLE_VECTOR_EXTENSIONS

/// Two doubles that are computed with at once, with what every 64-bit machine has for that.
using Lanes = double __attribute__((vector_size(16)));

/// The result of a comparison of Lanes.
using LaneMask = decltype(Lanes{} < Lanes{});

/// Returns in each lane `a` if the condition is true, else `b`.
inline Lanes select(LaneMask condition, Lanes a, Lanes b) {
  return condition ? a : b;
}

#else

/// The result of a comparison of Lanes.
struct LaneMask {
  bool first, second;

  friend LaneMask operator&(LaneMask a, LaneMask b) {
    return {a.first && b.first, a.second && b.second};
  }
  friend LaneMask operator|(LaneMask a, LaneMask b) {
    return {a.first || b.first, a.second || b.second};
  }
};

/// Two doubles, one after the other, to the same bits.
struct Lanes {
  double first, second;

  double operator[](std::size_t i) const { return i == 0 ? first : second; }

  friend Lanes operator-(Lanes a) { return {-a.first, -a.second}; }
  friend Lanes operator+(Lanes a, Lanes b) { return {a.first + b.first, a.second + b.second}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.first - b.first, a.second - b.second}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.first * b.first, a.second * b.second}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.first / b.first, a.second / b.second}; }
  friend Lanes operator+(double a, Lanes b) { return Lanes{a, a} + b; }
  friend Lanes operator*(double a, Lanes b) { return Lanes{a, a} * b; }
  friend Lanes operator/(double a, Lanes b) { return Lanes{a, a} / b; }
  friend Lanes& operator+=(Lanes& a, Lanes b) { return a = a + b; }
  friend Lanes& operator-=(Lanes& a, Lanes b) { return a = a - b; }
  friend Lanes& operator*=(Lanes& a, Lanes b) { return a = a * b; }

  friend LaneMask operator>(Lanes a, Lanes b) { return {a.first > b.first, a.second > b.second}; }
  friend LaneMask operator<=(Lanes a, Lanes b) {
    return {a.first <= b.first, a.second <= b.second};
  }
};

inline Lanes select(LaneMask condition, Lanes a, Lanes b) {
  return {condition.first ? a.first : b.first, condition.second ? a.second : b.second};
}

#endif

/// This function of one number, so that one formula serves numbers and lanes.
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}

/// Is a condition false for all numbers, so that the rest can be skipped? This is not checked for
/// lanes: continuing costs less.
constexpr bool is_nowhere(bool condition) {
  return !condition;
}
constexpr bool is_nowhere(const LaneMask&) {
  return false;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_LANES_H
