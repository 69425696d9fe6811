#ifndef QUADRILLE_INTERNAL_CORE_BASE_LANES_H
#define QUADRILLE_INTERNAL_CORE_BASE_LANES_H

#include <quadrille/internal/core/base/compiler.h>

#include <array>
#include <cstddef>
#include <cstring>

namespace quadrille::internal {

#if QUADRILLE_VECTOR_EXTENSIONS

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector) && __has_builtin(__builtin_convertvector)
#define QUADRILLE_SHUFFLES
#endif
#endif

/// Two doubles that are computed with at once, with what every 64-bit machine has for that.
using Lanes = double __attribute__((vector_size(16)));

/// Four floats that are computed with at once.
using FourFloats = float __attribute__((vector_size(16)));

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

/// Four floats, one after the other, to the same bits.
struct FourFloats {
  std::array<float, 4> floats;

  float operator[](std::size_t i) const { return floats[i]; }

  friend FourFloats operator+(FourFloats a, const FourFloats& b) {
    for (std::size_t i = 0; i < 4; ++i)
      a.floats[i] += b.floats[i];
    return a;
  }
  friend FourFloats operator-(FourFloats a, const FourFloats& b) {
    for (std::size_t i = 0; i < 4; ++i)
      a.floats[i] -= b.floats[i];
    return a;
  }
  friend FourFloats operator*(float factor, FourFloats a) {
    for (float& x : a.floats)
      x *= factor;
    return a;
  }
};

#endif

/// Reads two or four numbers that need not be aligned, or writes them.
QUADRILLE_ALWAYS_INLINE inline Lanes load_two(const double* numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}
QUADRILLE_ALWAYS_INLINE inline void store_two(double* numbers, Lanes lanes) {
  std::memcpy(numbers, &lanes, sizeof lanes);
}
QUADRILLE_ALWAYS_INLINE inline FourFloats load_four(const float* numbers) {
  FourFloats four;
  std::memcpy(&four, numbers, sizeof four);
  return four;
}
QUADRILLE_ALWAYS_INLINE inline void store_four(float* numbers, const FourFloats& four) {
  std::memcpy(numbers, &four, sizeof four);
}
/// Returns the floats of two fours as doubles: the first two in lanes, then the second, and so on.
QUADRILLE_ALWAYS_INLINE inline std::array<Lanes, 4> in_lanes(const FourFloats& a,
                                                             const FourFloats& b) {
#ifdef QUADRILLE_SHUFFLES // else compilers convert one number after the other
  using TwoFloats = float __attribute__((vector_size(8)));
  const TwoFloats first = __builtin_shufflevector(a, b, 0, 4);
  const TwoFloats second = __builtin_shufflevector(a, b, 1, 5);
  const TwoFloats third = __builtin_shufflevector(a, b, 2, 6);
  const TwoFloats fourth = __builtin_shufflevector(a, b, 3, 7);
  return {__builtin_convertvector(first, Lanes), __builtin_convertvector(second, Lanes),
          __builtin_convertvector(third, Lanes), __builtin_convertvector(fourth, Lanes)};
#else
  const auto both = [&](std::size_t i) {
    return Lanes{static_cast<double>(a[i]), static_cast<double>(b[i])};
  };
  return {both(0), both(1), both(2), both(3)};
#endif
}
QUADRILLE_ALWAYS_INLINE inline FourFloats four_floats(Lanes low, Lanes high) {
  return FourFloats{static_cast<float>(low[0]), static_cast<float>(low[1]),
                    static_cast<float>(high[0]), static_cast<float>(high[1])};
}

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
