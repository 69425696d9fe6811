#ifndef QUADRILLE_INTERNAL_BASE_THREADS_H
#define QUADRILLE_INTERNAL_BASE_THREADS_H

#include <stdexcept>
#include <string>

/// Some translation units of a program may have oneTBB, and others not. What depends on that has it
/// in its name: functions by the type of their number of threads or of the policies, the others by
/// the inline namespace QUADRILLE_THREADING. So no function has two definitions.

#ifdef QUADRILLE_WITH_TBB
#define QUADRILLE_THREADING with_tbb
#else
#define QUADRILLE_THREADING without_tbb
#endif

namespace quadrille::internal {

/// How many threads a call may use: at least one, and no more without oneTBB.
template <bool has_tbb>
class Threads {
public:
  explicit constexpr Threads(unsigned count = 1) : count_(count) {}

  constexpr operator unsigned() const { return count_; }

  /// Throws std::invalid_argument for threads that there can't be.
  void validate() const {
    if (!has_tbb && count_ > 1)
      throw std::invalid_argument("quadrille::RelaxedOrder: " + std::to_string(count_) +
                                  " threads need oneTBB: link quadrille::parallel");
  }

private:
  unsigned count_;
};

using OneThread = Threads<false>;

inline namespace QUADRILLE_THREADING {
#ifdef QUADRILLE_WITH_TBB
using ThreadsHere = Threads<true>;
#else
using ThreadsHere = OneThread;
#endif
} // namespace QUADRILLE_THREADING

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_THREADS_H
