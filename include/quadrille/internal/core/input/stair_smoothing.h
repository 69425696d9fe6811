#ifndef QUADRILLE_INTERNAL_CORE_INPUT_STAIR_SMOOTHING_H
#define QUADRILLE_INTERNAL_CORE_INPUT_STAIR_SMOOTHING_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The vertices around each vertex of a surface whose mean decides whether it is smooth there. On a
/// line where other than two faces meet, or two labels, these are its neighbours on the line.
template <std::size_t N>
class SmoothNeighbours {
public:
  explicit SmoothNeighbours(const SurfaceInput<N>& input) : begin_(input.positions.size() + 1, 0) {
    std::vector<Side> sides = sides_of(input);
    std::vector<unsigned char> is_on_line(input.positions.size(), 0);
    for_each_edge(sides, [&](Index v, Index w, bool is_line) {
      if (is_line)
        is_on_line[v] = is_on_line[w] = 1;
    });
    const auto for_each_arc = [&](auto visit) {
      for_each_edge(sides, [&](Index v, Index w, bool is_line) {
        if (is_line || !is_on_line[v])
          visit(v, w);
        if (is_line || !is_on_line[w])
          visit(w, v);
      });
    };
    for_each_arc([&](Index v, Index) { ++begin_[v + 1]; });
    for (std::size_t v = 1; v < begin_.size(); ++v)
      begin_[v] += begin_[v - 1];
    others_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for_each_arc([&](Index v, Index w) { others_[next[v]++] = w; });
    is_on_line_ = std::move(is_on_line);
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::size_t count(std::size_t v) const { return begin_[v + 1] - begin_[v]; }
  bool is_on_line(std::size_t v) const { return is_on_line_[v] != 0; }
  template <class Visit>
  void for_each(std::size_t v, Visit visit) const {
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i)
      visit(others_[i]);
  }

private:
  struct Side {
    Index low, high, label;
  };

  static std::vector<Side> sides_of(const SurfaceInput<N>& input) {
    std::vector<Side> sides;
    sides.reserve(3 * input.triangles.size());
    for (Index face = 0; face < input.triangles.size(); ++face) {
      const auto& corners = input.triangles[face];
      const Index input_face = input.input_faces.empty() ? face : input.input_faces[face];
      const Index label = input.labels.empty() ? 0 : input.labels[input_face];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax({corners[i], corners[i == 2 ? 0 : i + 1]});
        if (low != high)
          sides.push_back({low, high, label});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    return sides;
  }

  // Calls visit(v, w, is_line) for each edge.
  template <class Visit>
  static void for_each_edge(const std::vector<Side>& sides, Visit visit) {
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      const Side& first = sides[begin];
      bool is_line = false;
      for (; end < sides.size() && sides[end].low == first.low && sides[end].high == first.high;
           ++end)
        is_line |= sides[end].label != first.label;
      visit(first.low, first.high, is_line || end - begin != 2);
    }
  }

  std::vector<std::size_t> begin_; // of the list of each vertex
  std::vector<Index> others_;
  std::vector<unsigned char> is_on_line_;
};

/// Smooths the staircases of a surface that was made of voxels: no vertex moves by more than half a
/// voxel along any axis, which is all that is known of the surface.
///
/// It minimizes the squared distances of vertices from the means of their neighbours, the energy of
/// a thin plate, plus μ times the squared distances from where vertices were. The second term is
/// for vertices at steps: a surface passes through its steps, but anywhere through the terraces
/// between them. Without it, a terrace of the height of a voxel would count as a flat. Source: the
/// bounds: Gibson, Constrained elastic surface nets, 1998; the minimization: Beck and Teboulle, A
/// fast iterative shrinkage-thresholding algorithm, 2009, restarted as O'Donoghue and Candès do.
template <std::size_t N>
class StairSmoothing {
public:
  StairSmoothing(SurfaceInput<N>& input, double voxel_size)
      : input_(input), unit_(1 / voxel_size), neighbours_(input), weight_(steps(input)) {
    for (const Vector<N>& p : input.positions)
      given_.push_back(unit_ * space(p));
  }

  void apply() {
    const std::vector<Vector<3>> places = minimum();
    for (Index v = 0; v < places.size(); ++v) {
      if (places[v] == given_[v])
        continue;
      input_.moved.push_back(v);
      for (std::size_t i = 0; i < 3; ++i)
        input_.positions[v][i] += (places[v][i] - given_[v][i]) / unit_;
    }
  }

private:
  using Vectors = std::vector<Vector<3>>;
  static constexpr int rounds = 100;
  static constexpr double step_weight = 0.04; // μ
  static constexpr double step = 0.22;        // below 1 / (the greatest eigenvalue + μ)
  static constexpr double half = 0.5;         // of a voxel
  static constexpr double flat_cosine = 0.999;

  Vectors minimum() const {
    Vectors x = given_, y = given_, differences(x.size()), gradient(x.size());
    double momentum = 1;
    for (int round = 0; round < rounds; ++round) {
      find_gradient(y, differences, gradient);
      double against = 0; // below 0 while the momentum helps
      for (std::size_t v = 0; v < x.size(); ++v) {
        const Vector<3> old = std::exchange(x[v], place(v, y[v] - step * gradient[v]));
        against += dot(y[v] - x[v], x[v] - old);
        gradient[v] = x[v] - old;
      }
      if (against > 0)
        momentum = 1;
      const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
      const double factor = (std::exchange(momentum, next) - 1) / next;
      for (std::size_t v = 0; v < x.size(); ++v)
        y[v] = x[v] + factor * gradient[v];
    }
    return x;
  }

  // Half of the gradient of the energy.
  void find_gradient(const Vectors& x, Vectors& differences, Vectors& gradient) const {
    for (std::size_t v = 0; v < x.size(); ++v) {
      Vector<3> sum{};
      neighbours_.for_each(v, [&](Index w) { sum += x[w]; });
      const std::size_t count = neighbours_.count(v);
      differences[v] = count > 0 ? x[v] - (1.0 / static_cast<double>(count)) * sum : Vector<3>{};
      gradient[v] = differences[v] + weight_[v] * (x[v] - given_[v]);
    }
    for (std::size_t v = 0; v < x.size(); ++v)
      if (const std::size_t count = neighbours_.count(v); count > 0) {
        const Vector<3> share = (1.0 / static_cast<double>(count)) * differences[v];
        neighbours_.for_each(v, [&](Index w) { gradient[w] -= share; });
      }
  }

  // The nearest place to which a vertex may move.
  Vector<3> place(std::size_t v, Vector<3> x) const {
    if (!input_.is_fixed.empty() && input_.is_fixed[v])
      return given_[v];
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = std::clamp(x[i], given_[v][i] - half, given_[v][i] + half);
    return x;
  }

  // The weight of the place of each vertex: 0 where the surface, or the line, is flat.
  std::vector<double> steps(const SurfaceInput<N>& input) const {
    std::vector<Vector<3>> normal(input.positions.size());
    std::vector<double> weights(input.positions.size(), 0);
    for (const auto& [a, b, c] : input.triangles) {
      const Vector<3> n =
          normal_vector(unit_ * space(input.positions[a]), unit_ * space(input.positions[b]),
                        unit_ * space(input.positions[c]));
      for (Index v : {a, b, c})
        if (squared_length(normal[v]) == 0)
          normal[v] = n;
        else if (!are_parallel(n, normal[v]))
          weights[v] = step_weight;
    }
    for (std::size_t v = 0; v < weights.size(); ++v)
      if (neighbours_.is_on_line(v))
        weights[v] = is_straight(input, v) ? 0 : step_weight;
    return weights;
  }

  // Do two neighbours lie in opposite directions?
  bool is_straight(const SurfaceInput<N>& input, std::size_t v) const {
    std::vector<Vector<3>> directions;
    neighbours_.for_each(v, [&](Index w) {
      directions.push_back(unit_ * (space(input.positions[w]) - space(input.positions[v])));
    });
    return directions.size() == 2 && are_parallel(directions[0], -1.0 * directions[1]);
  }

  static bool are_parallel(const Vector<3>& p, const Vector<3>& q) {
    return dot(p, q) >= flat_cosine * std::sqrt(squared_length(p) * squared_length(q));
  }

  SurfaceInput<N>& input_;
  double unit_; // voxels by length
  SmoothNeighbours<N> neighbours_;
  std::vector<double> weight_; // of the given place of each vertex
  Vectors given_;              // in voxels
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_INPUT_STAIR_SMOOTHING_H
