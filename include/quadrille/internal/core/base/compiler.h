#ifndef QUADRILLE_INTERNAL_CORE_BASE_COMPILER_H
#define QUADRILLE_INTERNAL_CORE_BASE_COMPILER_H

/// \file
/// Features that compilers have in common but spell differently: g++, clang and their descendants,
/// and Microsoft's. On any other compiler the macros are empty, and the library works without them.

// Microsoft's compiler reports its standard in a macro of its own.
#ifdef _MSVC_LANG
#define QUADRILLE_CXX_STANDARD _MSVC_LANG
#else
#define QUADRILLE_CXX_STANDARD __cplusplus
#endif
#if QUADRILLE_CXX_STANDARD <= 201703L
#error Quadrille needs C++20: compile with -std=c++20, or /std:c++20 with MSVC
#endif

// QUADRILLE_ALWAYS_INLINE begins the declaration of a function, after `template <...>`.
// QUADRILLE_ALWAYS_INLINE_LAMBDA stands between a lambda's parameters and its body.
// QUADRILLE_NOINLINE begins the declaration of a function that is called seldom.
#if defined(__GNUC__) || defined(__clang__)
#define QUADRILLE_ALWAYS_INLINE [[gnu::always_inline]]
#define QUADRILLE_ALWAYS_INLINE_LAMBDA __attribute__((always_inline))
#define QUADRILLE_NOINLINE [[gnu::noinline]]
#elif defined(_MSC_VER)
#define QUADRILLE_ALWAYS_INLINE [[msvc::forceinline]]
#define QUADRILLE_ALWAYS_INLINE_LAMBDA [[msvc::forceinline]]
#define QUADRILLE_NOINLINE [[msvc::noinline]]
#else
#define QUADRILLE_ALWAYS_INLINE
#define QUADRILLE_ALWAYS_INLINE_LAMBDA
#define QUADRILLE_NOINLINE
#endif

// QUADRILLE_NO_UNIQUE_ADDRESS begins the declaration of a member that may be empty. Microsoft's
// compiler ignores the standard's name for it, to keep old layouts.
#ifdef _MSC_VER
#define QUADRILLE_NO_UNIQUE_ADDRESS [[msvc::no_unique_address]]
#else
#define QUADRILLE_NO_UNIQUE_ADDRESS [[no_unique_address]]
#endif

// QUADRILLE_PREFETCH(address) asks for the line of the cache at an address.
#if defined(__GNUC__) || defined(__clang__)
#define QUADRILLE_PREFETCH(address) __builtin_prefetch(address)
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <xmmintrin.h>
#define QUADRILLE_PREFETCH(address) _mm_prefetch((address), _MM_HINT_T0)
#elif defined(_MSC_VER) && defined(_M_ARM64)
#include <intrin.h>
#define QUADRILLE_PREFETCH(address) __prefetch(address)
#else
#define QUADRILLE_PREFETCH(address) static_cast<void>(address)
#endif

// Are there vectors of numbers, as g++ and clang have them? A program that defines
// QUADRILLE_NO_VECTOR_EXTENSIONS does without, in all of its translation units.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(QUADRILLE_NO_VECTOR_EXTENSIONS)
#define QUADRILLE_VECTOR_EXTENSIONS 1
#else
#define QUADRILLE_VECTOR_EXTENSIONS 0
#endif

#endif // QUADRILLE_INTERNAL_CORE_BASE_COMPILER_H
