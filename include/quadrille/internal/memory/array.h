#ifndef QUADRILLE_INTERNAL_MEMORY_ARRAY_H
#define QUADRILLE_INTERNAL_MEMORY_ARRAY_H

#include <quadrille/internal/memory/workspace.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Takes memory from a workspace, where there is one and it has any left, or by itself; with its
/// pages, if `takes_pages`. Goes along when arrays are moved, copied or swapped.
template <class T, bool takes_pages = true>
class ArrayAllocator {
public:
  using value_type = T;
  using is_always_equal = std::false_type;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  template <class U>
  struct rebind {
    using other = ArrayAllocator<U, takes_pages>;
  };

  ArrayAllocator(Workspace* workspace = nullptr) : workspace_(workspace) {}
  template <class U, bool p>
  ArrayAllocator(const ArrayAllocator<U, p>& other) : workspace_(other.workspace()) {}
  friend bool operator==(const ArrayAllocator&, const ArrayAllocator&) = default;

  T* allocate(std::size_t count) {
    T* memory = nullptr;
    if (workspace_ && alignof(T) <= Workspace::unit)
      memory = static_cast<T*>(workspace_->allocate(count * sizeof(T)));
    if (!memory)
      memory = std::allocator<T>().allocate(count);
    if constexpr (takes_pages)
      take_pages(memory, count * sizeof(T));
    return memory;
  }
  void deallocate(T* memory, std::size_t count) {
    if (workspace_ && workspace_->owns(memory))
      workspace_->deallocate(memory, count * sizeof(T));
    else
      std::allocator<T>().deallocate(memory, count);
  }

  Workspace* workspace() const { return workspace_; }

private:
  Workspace* workspace_;
};

/// Leaves what an array grows by without a value, where the type allows that.
template <class T>
struct UninitializedAllocator : ArrayAllocator<T> {
  using ArrayAllocator<T>::ArrayAllocator;
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

/// What each vertex, face or pair of a surface has.
template <class T>
using Array = std::vector<T, ArrayAllocator<T>>;

/// An array of which not all that is reserved will be used.
template <class T>
using SparseArray = std::vector<T, ArrayAllocator<T, false>>;

/// An array whose new values are written before they are read, each by the thread that works on
/// it.
template <class T>
using UninitializedArray = std::vector<T, UninitializedAllocator<T>>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_MEMORY_ARRAY_H
