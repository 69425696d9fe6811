#ifndef QUADRILLE_INTERNAL_UNINITIALIZED_H
#define QUADRILLE_INTERNAL_UNINITIALIZED_H

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Leaves what a vector grows by without a value, where the type allows that.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };

  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) > 0 || !std::is_trivially_copyable_v<U>)
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose new values must be written before they are read: each by the thread that works on
/// it, so that none waits for the system to hand out the memory of all.
template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_UNINITIALIZED_H
