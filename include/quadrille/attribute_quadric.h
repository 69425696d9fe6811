#ifndef QUADRILLE_ATTRIBUTE_QUADRIC_H
#define QUADRILLE_ATTRIBUTE_QUADRIC_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace quadrille {

/// The quadric of Garland and Heckbert in 3 + N dimensions: position and N attributes of a vertex
/// are one point, a face is a triangle of such points, and the quadric of a vertex is the sum of
/// the squared distances to the planes of its triangles in that space. The contracted vertex gets
/// the position and the attributes that together cost least.
///
/// An attribute counts as a length: its difference times its weight. By default all N have the
/// weight
///
///     importance · (diagonal of the bounding box) / (largest range of the N attributes)
///
/// (1 if the attributes are constant), so a step across their whole range counts as much as a step
/// of `importance` times the size of the model. By default that is 0.2 for texture coordinates,
/// whose range usually spans the model once, and 0.02 for others, which may span their range
/// between two adjacent vertices: a higher value degrades the shape and hardly improves the colours
/// (see doc/design/quadrics-and-costs.md).
/// Memory: the (N + 4)(N + 5) / 2 doubles of a QuadricForm<3 + N> a vertex: 28 for colours.
///
/// Source: Garland and Heckbert, Simplifying Surfaces with Color and Texture using Quadric Error
/// Metrics, 1998, sections 3 and 4.
template <std::size_t N, Attribute A = Attribute::any>
struct AttributeQuadric {
  /// Three coordinates of space, and the attributes.
  static constexpr std::size_t dimension = 3 + N;
  using ScaleFree = AttributeQuadric;             ///< scale-invariant: see
                                                  ///< CostPolicy
  using TieBreak = AttributeQuadric;              ///< has the scale of this class's values
  static constexpr Attribute attribute = A;       ///< the source of the attributes
  using Position = Vector<dimension>;   ///< a point with its attributes times their weights
  using State = QuadricForm<dimension>; ///< a quadric in all dimensions

  double importance = A == Attribute::texture ? 0.2 : 0.02; ///< above 0
  /// The weight of each attribute, in mesh units per unit of the attribute; by default as above.
  std::optional<Vector<N>> weights = {};
  double boundary_weight = 100;             ///< as in Quadric
  Weighting weighting = Weighting::by_area; ///< as in Quadric, but not by_squared_area

  /// Returns the power of lengths with which the cost grows. Attributes times their weights count
  /// as lengths.
  double degree() const { return weighting == Weighting::by_area ? 4 : 2; }

  /// Returns the weights for attributes that range from `low` to `high`: see above.
  Vector<N> attribute_weights(const Vector<N>& low, const Vector<N>& high, double diagonal) const {
    if (weights)
      return *weights;
    const Vector<N> ranges = high - low;
    const double range = *std::max_element(ranges.coordinates.begin(), ranges.coordinates.end());
    const double weight = range > 0 && diagonal > 0 ? importance * diagonal / range : 1;
    Vector<N> result;
    result.coordinates.fill(weight);
    return result;
  }

  /// Returns the quadric of the plane of the triangle pqr in all dimensions, about p: A = I − e₁e₁ᵀ
  /// − e₂e₂ᵀ, where e₁ and e₂ are an orthonormal basis of the triangle. It is zero for a face
  /// without a normal in space.
  State face(const Position& p, const Position& q, const Position& r) const {
    const double doubled_area =
        std::sqrt(squared_length(normal_vector(space(p), space(q), space(r))));
    if (!(doubled_area > 0))
      return {};
    const double weight = weighting == Weighting::by_area ? doubled_area / 2 : 1;
    const Position e1 = unit(q - p);
    const Position side = unit(r - p); // a unit vector first: it keeps e₂ perpendicular to e₁
    const Position e2 = unit(side - dot(side, e1) * e1);
    State state = State::point(weight);
    state += State::plane(e1, -weight);
    state += State::plane(e2, -weight);
    return state;
  }
  /// The plane of a face is the same at all its corners.
  static constexpr bool face_is_alike_at_corners = true;

  /// Returns the quadric of the line of the boundary edge pq of a face pqr, in space: see Quadric.
  State boundary(const Position& p, const Position& q, const Position& r) const {
    return in_all_dimensions(
        Quadric::constraint_line(space(p), space(q), space(r), boundary_weight));
  }

  /// Returns the sum of the weighted squared distances of x to the planes accumulated at both ends.
  double operator()(const auto& pair, const Position& x) const {
    return pair.state(x - pair.first);
  }

  /// Orders pairs of equal cost: see CostPolicy.
  double tie_break(const auto& pair, const Position& x) const {
    return tie_break_of(pair)(x - pair.first);
  }

  /// Returns the position of least cost with its attributes, if it exists.
  std::optional<Position> minimizer(const auto& pair) const {
    std::optional<Position> x = tie_break_of(pair).minimizer(pair.state);
    if (x)
      *x += pair.first;
    return x;
  }

  /// Returns the square of the root mean square distance to the planes. Attributes times their
  /// weights are included.
  double squared_error(const auto& pair, double cost) const {
    const double weight = pair.state.trace() / (dimension - 2); // a plane leaves N + 1 directions
    return weight > 0 ? cost / weight : 0;
  }

  /// Throws std::invalid_argument for a weight that is negative, infinite or not a number.
  void validate() const {
    internal::require_weight("quadrille::AttributeQuadric", "boundary_weight", boundary_weight);
    if (weighting == Weighting::by_squared_area)
      throw std::invalid_argument(
          "quadrille::AttributeQuadric: Weighting::by_squared_area needs Quadric");
    if (!(importance > 0) || !std::isfinite(importance))
      throw std::invalid_argument("quadrille::AttributeQuadric: importance " +
                                  internal::text_of(importance) + " is not above 0 and finite");
    if (weights)
      for (double weight : weights->coordinates)
        if (!(weight > 0) || !std::isfinite(weight))
          throw std::invalid_argument("quadrille::AttributeQuadric: an attribute's weight is " +
                                      internal::text_of(weight) + ", not above 0 and finite");
  }

private:
  static internal::TieBreak<dimension> tie_break_of(const auto& pair) {
    return {pair.state.trace(), pair.second - pair.first};
  }

  static State in_all_dimensions(const QuadricForm<3>& form) {
    SymmetricMatrix<dimension> matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        matrix.set(i, j, form.matrix()(i, j));
    return State(matrix);
  }

  static Position unit(const Position& v) { return (1 / std::sqrt(squared_length(v))) * v; }
};

/// Position and red, green, blue: the 6D quadric. The colours come from the named parameter
/// `vertex_color_map`.
using ColorQuadric = AttributeQuadric<3, Attribute::color>;

/// Position and texture coordinates u, v: the 5D quadric. They come from `vertex_texture_map`.
using TextureQuadric = AttributeQuadric<2, Attribute::texture>;

/// Position and normal; the results are unit vectors. The normals come from `vertex_normal_map`.
using NormalQuadric = AttributeQuadric<3, Attribute::normal>;

} // namespace quadrille

#ifdef QUADRILLE_WITH_COMPILED
#include <quadrille/internal/core/call/compiled_engines.h>

namespace quadrille::internal {
QUADRILLE_ENGINE(extern template, ColorQuadric, false);
QUADRILLE_ENGINE(extern template, TextureQuadric, false);
} // namespace quadrille::internal
#endif

#endif // QUADRILLE_ATTRIBUTE_QUADRIC_H
