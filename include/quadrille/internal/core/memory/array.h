#ifndef QUADRILLE_INTERNAL_CORE_MEMORY_ARRAY_H
#define QUADRILLE_INTERNAL_CORE_MEMORY_ARRAY_H

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

inline constexpr std::size_t page = std::size_t{1} << 12, large_page = std::size_t{1} << 21;

/// Asks the system for the pages of new memory at once. Else it is asked at the first touch of
/// each, which can take longer than all that is done with the page. Only a hint: what the system
/// does not do now, it does then.
inline void take_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
  const auto place = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (place + page - 1) / page * page;
  const std::uintptr_t end = (place + bytes) / page * page;
  if (begin + 8 * page <= end)
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_WRITE);
#endif
}

/// How many bytes a simplification needs at one time: as a rule no less than `least` and no more
/// than `most`.
struct MemoryNeeds {
  std::size_t least, most;
};

/// The arena of one simplification: one block of memory for its arrays, used by one thread, from
/// which each array takes a range and returns it. So the pages of released arrays serve later ones,
/// and the system can provide large pages. There is no block if it is not worthwhile, or if none is
/// available.
class Arena {
public:
  static constexpr std::size_t unit = 64; ///< blocks begin at multiples of it: a line of a cache

  explicit Arena(const MemoryNeeds& needs) {
    const std::size_t size = rounded_up(needs.most);
    if (is_checked || needs.least < large_page)
      return;
    begin_ = static_cast<std::byte*>(::operator new(size, alignment, std::nothrow));
    if (!begin_)
      return;
    end_ = begin_ + size;
#ifdef MADV_HUGEPAGE
    const std::size_t large = (needs.least + large_page / 8) / large_page * large_page;
    madvise(begin_, large, MADV_HUGEPAGE); // no page of which more than an eighth is left empty
#endif
    gaps_ = ::new (begin_) Gap{size, nullptr};
  }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() {
    ::operator delete(begin_, alignment);
  }

  /// Returns the smallest range of the block that fits; nullptr if there is none.
  void* allocate(std::size_t bytes) {
    const std::size_t size = rounded_up(bytes);
    Gap** best = nullptr;
    for (Gap** gap = &gaps_; *gap; gap = &(*gap)->next)
      if ((*gap)->size >= size && (!best || (*gap)->size < (*best)->size))
        best = gap;
    if (!best)
      return nullptr;
    Gap* const gap = *best;
    *best =
        gap->size == size ? gap->next : ::new (after(gap, size)) Gap{gap->size - size, gap->next};
    return gap;
  }

  /// Takes back what allocate(bytes) has given.
  void deallocate(void* block, std::size_t bytes) {
    Gap* before = nullptr;
    Gap* next = gaps_;
    for (; next && std::less<void*>()(next, block); next = next->next)
      before = next;
    Gap* const gap = ::new (block) Gap{rounded_up(bytes), next};
    (before ? before->next : gaps_) = gap;
    join_with_next(gap);
    if (before)
      join_with_next(before);
  }

  /// Does this belong to the block?
  bool owns(const void* block) const {
    return begin_ && !std::less<const void*>()(block, begin_) &&
           std::less<const void*>()(block, end_);
  }

private:
  // A gap between allocated ranges. The list of all gaps, in order, is stored in the gaps
  // themselves.
  struct Gap {
    std::size_t size;
    Gap* next;
  };

  // Sanitizers see no bounds inside of a block: there each array has one of its own.
#ifdef __SANITIZE_ADDRESS__
  static constexpr bool is_checked = true;
#elif defined(__has_feature)
  static constexpr bool is_checked = __has_feature(address_sanitizer);
#else
  static constexpr bool is_checked = false;
#endif

  static constexpr std::align_val_t alignment{large_page};

  static constexpr std::size_t rounded_up(std::size_t bytes) {
    return (std::max)(unit, (bytes + unit - 1) / unit * unit);
  }
  static void* after(Gap* gap, std::size_t size) {
    return reinterpret_cast<std::byte*>(gap) + size;
  }

  static void join_with_next(Gap* gap) {
    if (gap->next && after(gap, gap->size) == gap->next)
      *gap = {gap->size + gap->next->size, gap->next->next};
  }

  std::byte* begin_ = nullptr;
  std::byte* end_ = nullptr;
  Gap* gaps_ = nullptr;
};

/// Takes memory from a arena, where there is one and it has any left, or by itself; with its
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

  ArrayAllocator(Arena* arena = nullptr) : arena_(arena) {}
  template <class U, bool p>
  ArrayAllocator(const ArrayAllocator<U, p>& other) : arena_(other.arena()) {}
  friend bool operator==(const ArrayAllocator&, const ArrayAllocator&) = default;

  T* allocate(std::size_t count) {
    T* memory = nullptr;
    if (arena_ && alignof(T) <= Arena::unit)
      memory = static_cast<T*>(arena_->allocate(count * sizeof(T)));
    if (!memory)
      memory = std::allocator<T>().allocate(count);
    if constexpr (takes_pages)
      take_pages(memory, count * sizeof(T));
    return memory;
  }
  void deallocate(T* memory, std::size_t count) {
    if (arena_ && arena_->owns(memory))
      arena_->deallocate(memory, count * sizeof(T));
    else
      std::allocator<T>().deallocate(memory, count);
  }

  Arena* arena() const { return arena_; }

private:
  Arena* arena_;
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

/// An array with an element for each vertex, face or pair of a surface.
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

#endif // QUADRILLE_INTERNAL_CORE_MEMORY_ARRAY_H
