#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_SUMS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_SUMS_H

#include <quadrille/internal/attributes/wedge_records.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// \file
/// The faces of a wedge are summed up in rows of numbers, which are added two numbers at a time. A
/// row has the sum of the squares of the gradients (xx, yx, yy, zx, zy, zz), the weight
/// and 0; then for each two components of the attribute x, y and z of their gradients.

inline constexpr std::size_t squares_in_row = 8; // with the weight

/// The row of a face: the gradients of a channel in lengths. `known_twos`: how many times two
/// components there are; 0, if only the run of the program shows.
template <std::size_t known_twos>
class FaceGradients {
public:
  explicit FaceGradients(std::size_t components) {
    if constexpr (known_twos == 0)
      row_.resize(squares_in_row + 6 * ((components + 1) / 2));
  }

  std::size_t size() const { return row_.size(); }
  const double* data() const { return row_.data(); }

  /// Computes the gradients on a face between wedges. `first_direction`, `second_direction`: the
  /// gradients of what is 1 at the second wedge, or at the third, and 0 at the others. Returns the
  /// sum of the squares of the gradients' lengths.
  QUADRILLE_ALWAYS_INLINE double set(const WedgeRecords& records,
                                     const std::array<Index, 3>& wedges,
                                     const Vector<3>& first_direction,
                                     const Vector<3>& second_direction) {
    const std::size_t twos = (size() - squares_in_row) / 6;
    const auto values = [&](std::size_t i) { return records.values(wedges[i], 2 * twos); };
    SymmetricMatrix<3, Lanes> squares;
    for (std::size_t two = 0; two < twos; ++two) {
      const Lanes start = load_two(values(0) + 2 * two);
      const Lanes lengths = load_two(records.lengths() + 2 * two);
      const Lanes first = lengths * (load_two(values(1) + 2 * two) - start);
      const Lanes second = lengths * (load_two(values(2) + 2 * two) - start);
      Vector<3, Lanes> gradient;
      for (std::size_t i = 0; i < 3; ++i) {
        gradient[i] = first_direction[i] * first + second_direction[i] * second;
        store_two(&row_[squares_in_row + 6 * two + 2 * i], gradient[i]);
      }
      squares += SymmetricMatrix<3, Lanes>::outer_product(gradient, Lanes{1, 1});
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        row_[k++] = squares(i, j)[0] + squares(i, j)[1];
    row_[k] = 1;
    return row_[0] + row_[2] + row_[5];
  }
  QUADRILLE_ALWAYS_INLINE void weigh(double weight) {
    for (std::size_t k = 0; k < size(); k += 2)
      store_two(&row_[k], weight * load_two(&row_[k]));
  }

private:
  std::conditional_t<known_twos == 0, std::vector<double>,
                     std::array<double, squares_in_row + 6 * known_twos>>
      row_{};
};

/// The rows of wedges. The mean gradient of a wedge, weighted, is that of its map; what the faces
/// have in addition to its square is what they disagree about.
template <std::size_t known_twos>
class WedgeSums {
public:
  using Row = FaceGradients<known_twos>;

  WedgeSums(std::size_t wedges, std::size_t components, Arena* arena)
      : size_(Row(components).size()), rows_(arena) {
    rows_.resize(wedges * size_);
  }

  /// Begins the sum of a wedge.
  QUADRILLE_ALWAYS_INLINE void clear(Index wedge) {
    double* const row = &rows_[wedge * size()];
    for (std::size_t k = 0; k < size(); k += 2)
      store_two(row + k, Lanes{});
  }
  QUADRILLE_ALWAYS_INLINE void add(Index wedge, const Row& face) {
    double* const row = &rows_[wedge * face.size()];
    for (std::size_t k = 0; k < face.size(); k += 2)
      store_two(row + k, load_two(row + k) + load_two(face.data() + k));
  }
  /// Gives the wedge its map. Returns what its faces disagree about.
  SymmetricMatrix<3> resolve(Index wedge, WedgeRecords& records) const {
    const double* const row = &rows_[wedge * size()];
    const double weight = row[squares_in_row - 2];
    const double inverse = weight > 0 ? 1 / weight : 0;
    SymmetricMatrix<3, Lanes> squares;
    const auto mean_of_two = [&](std::size_t k) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      if (k >= size())
        return Vector<3, Lanes>();
      const Vector<3, Lanes> sum{{load_two(row + k), load_two(row + k + 2), load_two(row + k + 4)}};
      squares += SymmetricMatrix<3, Lanes>::outer_product(sum, Lanes{inverse, inverse});
      return Vector<3, Lanes>{{inverse * sum[0], inverse * sum[1], inverse * sum[2]}};
    };
    for (std::size_t four = 0; four < records.fours(); ++four) {
      const std::size_t k = squares_in_row + 12 * four;
      const Vector<3, Lanes> low = mean_of_two(k);
      records.set_gradients(wedge, four, low, mean_of_two(k + 6));
    }
    records.set_weight(wedge, weight);
    SymmetricMatrix<3> difference;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        difference.set(i, j, row[k++] - (squares(i, j)[0] + squares(i, j)[1]));
    return difference;
  }

private:
  // The size of a row.
  std::size_t size() const { return known_twos == 0 ? size_ : squares_in_row + 6 * known_twos; }

  std::size_t size_;
  UninitializedArray<double> rows_;
};

/// Calls compute(sums) with sums for the wedges of a channel.
template <class Compute>
void with_wedge_sums(std::size_t wedges, std::size_t components, Arena* arena, Compute compute) {
  if (components <= 2)
    compute(WedgeSums<1>(wedges, components, arena));
  else if (components <= 4)
    compute(WedgeSums<2>(wedges, components, arena));
  else
    compute(WedgeSums<0>(wedges, components, arena));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_SUMS_H
