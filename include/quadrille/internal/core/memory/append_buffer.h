#ifndef QUADRILLE_INTERNAL_CORE_MEMORY_APPEND_BUFFER_H
#define QUADRILLE_INTERNAL_CORE_MEMORY_APPEND_BUFFER_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// A list whose length is set without a look at its values: what is written by loops that can't
/// afford to branch.
template <class T>
class AppendBuffer {
public:
  explicit AppendBuffer(Arena* arena = nullptr) : values_(arena) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }

  /// The place after the last element, for at most `count` values more.
  T* extend(std::size_t count) {
    if (values_.size() < size_ + count)
      grow((std::max)(values_.size() + values_.size() / 4, size_ + count));
    return values_.data() + size_;
  }
  /// Reports that `count` more elements have been written.
  void add(std::size_t count) { size_ += count; }
  /// Writes a value, and lets it stay or not: without a branch.
  void add_if(bool stays, const T& value) {
    *extend(1) = value;
    add(stays);
  }

  /// Gives its memory back.
  void release() {
    values_ = UninitializedArray<T>(values_.get_allocator());
    size_ = 0;
  }

  /// To no more than it has.
  void resize(std::size_t size) { size_ = size; }

  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  const T& front() const { return values_.front(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  const T* data() const { return values_.data(); }

private:
  QUADRILLE_NOINLINE void grow(std::size_t size) { // seldom
    if (empty())
      release();           // two at a time take more memory
    values_.reserve(size); // resize() takes twice as much as it had
    values_.resize(size);
  }

  UninitializedArray<T> values_;
  std::size_t size_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_MEMORY_APPEND_BUFFER_H
