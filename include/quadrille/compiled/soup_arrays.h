#ifndef QUADRILLE_COMPILED_SOUP_ARRAYS_H
#define QUADRILLE_COMPILED_SOUP_ARRAYS_H

#include <quadrille/compiled.h>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

/// \file
/// Containers for `simplify` that refer to the arrays of a caller until `simplify` replaces them.

namespace quadrille::internal {

/// The points of a soup. The caller's points are never written: `simplify` makes new ones.
class SoupPointArray {
public:
  using Point = std::array<double, 3>;

  SoupPointArray() = default;
  explicit SoupPointArray(std::span<const Point> of_caller)
      : of_caller_(of_caller), is_own_(false) {}

  std::size_t size() const { return is_own_ ? own_.size() : of_caller_.size(); }
  const Point* begin() const { return is_own_ ? own_.data() : of_caller_.data(); }
  const Point* end() const { return begin() + size(); }
  const Point& operator[](std::size_t i) const { return begin()[i]; }
  Point& operator[](std::size_t i) { return const_cast<Point*>(begin())[i]; }
  void push_back(const Point& point) { own_.push_back(point); }

  SoupPoints take() && { return is_own_ ? std::move(own_) : SoupPoints(begin(), end()); }

private:
  std::span<const Point> of_caller_;
  SoupPoints own_;
  bool is_own_ = true;
};

/// A triangle with its index in the input.
struct NumberedTriangle {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t input = 0;

  std::size_t size() const { return 3; }
  const std::uint32_t* begin() const { return corners.data(); }
  const std::uint32_t* end() const { return begin() + 3; }
  std::uint32_t operator[](std::size_t i) const { return corners[i]; }
  std::uint32_t& operator[](std::size_t i) { return corners[i]; }
};

/// The triangles of a soup, as values.
class SoupTriangleArray {
public:
  SoupTriangleArray() = default;
  explicit SoupTriangleArray(std::span<const std::array<std::uint32_t, 3>> of_caller)
      : of_caller_(of_caller), is_own_(false) {}

  std::size_t size() const { return is_own_ ? own_.size() : of_caller_.size(); }
  NumberedTriangle operator[](std::size_t i) const {
    return is_own_ ? NumberedTriangle{own_[i], inputs_[i]}
                   : NumberedTriangle{of_caller_[i], static_cast<std::uint32_t>(i)};
  }
  void push_back(const NumberedTriangle& triangle) {
    own_.push_back(triangle.corners);
    inputs_.push_back(triangle.input);
  }

  class Iterator {
  public:
    using difference_type = std::ptrdiff_t;
    using value_type = NumberedTriangle;
    using iterator_concept = std::random_access_iterator_tag;

    Iterator() = default;
    Iterator(const SoupTriangleArray* array, difference_type place)
        : array_(array), place_(place) {}

    value_type operator*() const { return (*array_)[static_cast<std::size_t>(place_)]; }
    value_type operator[](difference_type n) const { return *(*this + n); }
    Iterator& operator+=(difference_type n) {
      place_ += n;
      return *this;
    }
    Iterator& operator-=(difference_type n) { return *this += -n; }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this -= 1; }
    Iterator operator++(int) { return std::exchange(*this, *this + 1); }
    Iterator operator--(int) { return std::exchange(*this, *this - 1); }
    friend Iterator operator+(Iterator i, difference_type n) { return i += n; }
    friend Iterator operator+(difference_type n, Iterator i) { return i += n; }
    friend Iterator operator-(Iterator i, difference_type n) { return i -= n; }
    friend difference_type operator-(const Iterator& i, const Iterator& j) {
      return i.place_ - j.place_;
    }
    friend bool operator==(const Iterator& i, const Iterator& j) { return i.place_ == j.place_; }
    friend auto operator<=>(const Iterator& i, const Iterator& j) { return i.place_ <=> j.place_; }

  private:
    const SoupTriangleArray* array_ = nullptr;
    difference_type place_ = 0;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, static_cast<std::ptrdiff_t>(size())}; }

  /// Returns the triangles and their indices in the input.
  std::pair<SoupTriangles, std::vector<std::uint32_t>> take() && {
    if (is_own_)
      return {std::move(own_), std::move(inputs_)};
    std::vector<std::uint32_t> inputs(of_caller_.size());
    std::iota(inputs.begin(), inputs.end(), std::uint32_t{0});
    return {SoupTriangles(of_caller_.begin(), of_caller_.end()), std::move(inputs)};
  }

private:
  std::span<const std::array<std::uint32_t, 3>> of_caller_;
  SoupTriangles own_;
  std::vector<std::uint32_t> inputs_;
  bool is_own_ = true;
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_ARRAYS_H
