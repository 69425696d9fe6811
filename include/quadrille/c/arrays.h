#ifndef QUADRILLE_C_ARRAYS_H
#define QUADRILLE_C_ARRAYS_H

#include <quadrille/quadrille.h>

#include <quadrille/internal/core/base/text.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// Arrays of C are read as spans or vectors of the types of the library, and vectors are viewed as
/// arrays of C.

namespace quadrille::internal {

/// Calls visit(T{}) with the type of the numbers of an array. Throws std::invalid_argument for an
/// unknown type.
template <class Visit>
auto with_type(std::int32_t type, const Visit& visit) {
  switch (type) {
  case QUADRILLE_FLOAT64:
    return visit(double{});
  case QUADRILLE_FLOAT32:
    return visit(float{});
  case QUADRILLE_UINT8:
    return visit(std::uint8_t{});
  case QUADRILLE_UINT32:
    return visit(std::uint32_t{});
  case QUADRILLE_INT32:
    return visit(std::int32_t{});
  case QUADRILLE_UINT64:
    return visit(std::uint64_t{});
  case QUADRILLE_INT64:
    return visit(std::int64_t{});
  default:
    throw std::invalid_argument("an array has the type " + std::to_string(type) +
                                ", which is not a quadrille_type");
  }
}

/// An array of the caller with its name.
struct NamedArray {
  std::string name;
  quadrille_array array{};

  bool is_given() const { return !name.empty(); }

  /// Throws std::invalid_argument if it can't be read, or has another number of columns; 0 stands
  /// for any.
  void validate(std::size_t columns) const {
    with_type(array.type, [](auto) {});
    if (!array.data && array.rows > 0)
      throw std::invalid_argument(name + " has " + std::to_string(array.rows) +
                                  " rows, but no data");
    if (columns > 0 && array.columns != columns && array.rows > 0)
      throw std::invalid_argument(name + " has " + std::to_string(array.columns) +
                                  " columns, not " + std::to_string(columns));
  }

  /// Returns whether it is a packed array of a type, or of integers of the same size.
  template <class T>
  bool is_packed() const {
    const bool has_type = with_type(array.type, [](auto given) {
      using Given = decltype(given);
      return std::is_floating_point_v<T> == std::is_floating_point_v<Given> &&
             sizeof(T) == sizeof(Given);
    });
    const auto packed = static_cast<std::ptrdiff_t>(array.columns * sizeof(T));
    return has_type && (array.row_stride == 0 || array.row_stride == packed);
  }

  /// Returns its numbers as another type, row by row. Throws std::invalid_argument for a number
  /// that the type does not have.
  template <class T>
  std::vector<T> numbers() const {
    return with_type(array.type, [&]<class Given>(Given) {
      std::vector<T> result;
      result.reserve(array.rows * array.columns);
      const auto packed = static_cast<std::ptrdiff_t>(array.columns * sizeof(Given));
      const std::ptrdiff_t stride = array.row_stride == 0 ? packed : array.row_stride;
      const auto* row = static_cast<const char*>(array.data);
      for (std::size_t i = 0; i < array.rows; ++i, row += stride)
        for (std::size_t k = 0; k < array.columns; ++k) {
          Given number;
          std::memcpy(&number, row + k * sizeof(Given), sizeof(Given));
          result.push_back(converted<T>(number, i));
        }
      return result;
    });
  }

private:
  template <class T, class Given>
  T converted(Given number, std::size_t row) const {
    if constexpr (std::is_same_v<T, bool>) {
      return number != Given{};
    } else if constexpr (std::is_integral_v<T>) {
      if constexpr (std::is_floating_point_v<Given>)
        throw std::invalid_argument(name + " has real numbers, not integers");
      else if (number < 0 || static_cast<std::uint64_t>(number) > (std::numeric_limits<T>::max)())
        throw std::invalid_argument(name + "[" + std::to_string(row) + "] has the number " +
                                    std::to_string(number) + ", which is not in [0, " +
                                    std::to_string((std::numeric_limits<T>::max)()) + "]");
    }
    return static_cast<T>(number);
  }
};

/// An array of the caller as the library reads it: in place, or converted.
template <class T, std::size_t columns>
class ReadRows {
public:
  using Row = std::array<T, columns>;

  /// Reads rows of `columns` numbers.
  explicit ReadRows(const NamedArray& array) {
    if (!array.is_given())
      return;
    array.validate(columns);
    if (array.template is_packed<T>()) {
      rows_ = {reinterpret_cast<const Row*>(array.array.data), array.array.rows};
    } else {
      numbers_ = array.template numbers<T>();
      rows_ = {reinterpret_cast<const Row*>(numbers_.data()), array.array.rows};
    }
  }
  ReadRows(ReadRows&&) noexcept = default;

  std::span<const Row> rows() const { return rows_; }
  std::span<const T> numbers() const {
    return {reinterpret_cast<const T*>(rows_.data()), rows_.size() * columns};
  }

private:
  static_assert(sizeof(Row) == columns * sizeof(T));
  std::vector<T> numbers_;
  std::span<const Row> rows_;
};

template <class T>
constexpr std::int32_t type_of() {
  if constexpr (std::is_same_v<T, double>)
    return QUADRILLE_FLOAT64;
  else if constexpr (std::is_same_v<T, std::uint32_t>)
    return QUADRILLE_UINT32;
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return QUADRILLE_UINT8;
  else
    return QUADRILLE_INT64;
}

/// Returns a view of a vector as an array of rows.
template <class T>
quadrille_array view_of(const std::vector<T>& numbers, std::size_t columns = 1) {
  return {numbers.data(), columns > 0 ? numbers.size() / columns : 0, columns, 0, type_of<T>()};
}
template <class T, std::size_t n>
quadrille_array view_of(const std::vector<std::array<T, n>>& rows) {
  return {rows.data(), rows.size(), n, 0, type_of<T>()};
}

/// Copies an array into memory of the caller. Reals are rounded to integers of the other type.
inline void copy_array(const quadrille_array& from, void* to, std::int32_t type,
                       std::ptrdiff_t row_stride) {
  const NamedArray named{"the array", from};
  with_type(type, [&]<class To>(To) {
    with_type(from.type, [&]<class From>(From) {
      const auto packed = static_cast<std::ptrdiff_t>(from.columns * sizeof(To));
      auto* row = static_cast<char*>(to);
      const auto* number = static_cast<const From*>(from.data);
      for (std::size_t i = 0; i < from.rows; ++i, row += row_stride == 0 ? packed : row_stride)
        for (std::size_t k = 0; k < from.columns; ++k, ++number) {
          const To value = static_cast<To>(*number);
          std::memcpy(row + k * sizeof(To), &value, sizeof(To));
        }
    });
  });
}

} // namespace quadrille::internal

#endif // QUADRILLE_C_ARRAYS_H
