#ifndef QUADRILLE_INTERNAL_CORE_BASE_ASSERT_H
#define QUADRILLE_INTERNAL_CORE_BASE_ASSERT_H

/// \file
/// QUADRILLE_ASSERT(condition) ends the program, with a message of the C++ library's, if the
/// condition is false: a fault of Quadrille's, never of the user's input, which gets exceptions. It
/// is enabled if QUADRILLE_ASSERTIONS is defined, as in the presets that say so, and costs nothing
/// otherwise: not even in a user's debug build, unless the user asks for it.

#ifdef QUADRILLE_ASSERTIONS
#ifdef NDEBUG
#error QUADRILLE_ASSERTIONS needs the assert of the C++ library: do not define NDEBUG
#endif
#include <cassert>
#define QUADRILLE_ASSERT(condition) assert(condition)
#else
#define QUADRILLE_ASSERT(condition) static_cast<void>(0)
#endif

#endif // QUADRILLE_INTERNAL_CORE_BASE_ASSERT_H
