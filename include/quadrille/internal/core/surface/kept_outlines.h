#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_OUTLINES_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_OUTLINES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/kept_planes.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A line of points and a segment: does a point that walks along one stay within a distance of
/// another that walks along the other, if each may wait but neither turn back? The distance is that
/// of Fréchet, which bounds the Hausdorff distance both ways. O(points). Source: Alt and Godau,
/// Computing the Fréchet distance between two polygonal curves, 1995.
inline bool is_walk_within(std::span<const Vector<3>> line, const Vector<3>& from,
                           const Vector<3>& to, double distance) {
  const double limit = distance * distance;
  if (squared_distance(line.front(), from) > limit || squared_distance(line.back(), to) > limit)
    return false;
  const Vector<3> along = to - from;
  const double length = squared_length(along);
  double reached = 0; // on the segment
  for (const Vector<3>& p : line) {
    const double middle = length > 0 ? dot(p - from, along) / length : 0;
    const double off = squared_distance(p, from + middle * along);
    if (off > limit)
      return false;
    const double half = length > 0 ? std::sqrt((limit - off) / length) : 1;
    reached = (std::max)(reached, middle - half);
    if (reached > (std::min)(1.0, middle + half))
      return false;
  }
  return true;
}

/// The outlines of plane regions: how far each vertex on them is from the outlines of the input,
/// and between which points of these it lies. See KeepPlanes.
///
/// A vertex on an outline accumulates the squared distances to the lines of its edges in the input,
/// each weighted with the square of its length, as the quadrics of its faces are accumulated.
/// Between two such vertices lies a *chain*: the points of an outline of the input that one edge
/// stands for now. Chains are there only if there is a limit.
class KeptOutlines {
public:
  KeptOutlines() = default;
  /// Positions are in the engine's unit.
  template <std::size_t N>
  KeptOutlines(const PlanesOfInput& input, const Array<Vector<N>>& positions, const Scale<N>& scale,
               Arena* arena)
      : corner_of_(arena) {
    if (input.outlines.empty())
      return;
    corner_of_.resize(positions.size(), none);
    if (input.outline_limit)
      limit_ = scale.length_from_mesh(*input.outline_limit);
    for (const auto& [v, w] : input.outlines)
      add(corner_at(v, space(positions[v])), corner_at(w, space(positions[w])));
    double size = 0;
    for (const Corner& c : corners_)
      size = (std::max)(size, std::abs(c.place[0]) + std::abs(c.place[1]) + std::abs(c.place[2]));
    limit_ += 8 * scale.rounding(size);
  }

  bool empty() const { return corner_of_.empty(); }
  /// Is the pair at an outline?
  bool has(Index v, Index w) const { return corner_of_[v] != none || corner_of_[w] != none; }

  /// Returns the cost of a pair's target, the weighted squared distance to the lines at its ends,
  /// times the power of their weight that makes it a cost of this degree, to the next half.
  double cost(Index v, Index w, const Vector<3>& target, double degree) const {
    double squares = 0, weight = 0;
    for (Index corner : corners_of(v, w)) {
      const Corner& c = corners_[corner];
      squares += c.lines(target - c.place);
      weight += c.lines.trace() / 2; // a line has two planes
    }
    if (!(squares > 0))
      return 0;
    return distance_weight * squares * power(weight, degree - 4);
  }

  /// Returns the target that is nearest to the lines of a pair; of several, one next to x.
  std::optional<Vector<3>> nearest(Index v, Index w, const Vector<3>& x) const {
    QuadricForm<3> sum;
    for (Index corner : corners_of(v, w)) {
      QuadricForm<3> lines = corners_[corner].lines;
      lines.move_origin(x - corners_[corner].place);
      sum += lines;
    }
    std::optional<Vector<3>> y = sum.minimizer_near({}, 1e-9 * sum.trace());
    if (y)
      *y += x;
    return y;
  }

  /// Are all edges of outlines within the limit if the pair is contracted to this target?
  bool admit(Index v, Index w, const Vector<3>& target) const {
    if (limit_ == no_limit || !has(v, w))
      return true;
    const std::optional<Change> change = change_to(v, w, target);
    if (!change)
      return true;
    return std::all_of(change->chains.begin(), change->chains.end(), [&](const Chain& chain) {
      return is_walk_within(chain.points, end_of(chain, 0, *change, target),
                            end_of(chain, 1, *change, target), limit_);
    });
  }

  /// The target of a contraction takes the place of both ends.
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void contract(const Event& event) {
    if (!empty()) [[unlikely]]
      contract(event.kept, event.gone, space(event.contraction.target()));
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.corner_of_); }

private:
  static constexpr double distance_weight = 10;
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  // Returns x to the power of half of `degrees`, which are rounded to halves: the same bits with
  // any C library.
  static double power(double x, double degrees) {
    const double root = std::sqrt(std::sqrt(x));
    double result = 1;
    for (long i = std::lround(2 * std::abs(degrees)); i > 0; --i)
      result *= root;
    return degrees < 0 ? 1 / result : result;
  }

  // A vertex on an outline.
  struct Corner {
    Vector<3> place;
    QuadricForm<3> lines; // about the place
    std::vector<Index> chains = {};
  };
  // The points of an outline of the input that an edge stands for, from its first end to its last.
  struct Chain {
    std::array<Index, 2> ends; // corners
    std::vector<Vector<3>> points;
  };
  // The chains at the ends of a pair after a contraction. The corner `left` takes the target's
  // place.
  struct Change {
    Index left;
    std::vector<Index> numbers; // of chains
    std::vector<Chain> chains;  // with these numbers, then
    Index gone = none;          // a corner
    Index joined = none;        // the chain between both corners
  };

  // The corners at the ends of a pair, at most two.
  struct CornersOfPair {
    std::array<Index, 2> corners;
    std::size_t size = 0;
    const Index* begin() const { return corners.data(); }
    const Index* end() const { return corners.data() + size; }
  };
  CornersOfPair corners_of(Index v, Index w) const {
    CornersOfPair pair;
    for (Index corner : {corner_of_[v], corner_of_[w]})
      if (corner != none)
        pair.corners[pair.size++] = corner;
    return pair;
  }

  Index corner_at(Index v, const Vector<3>& place) {
    if (corner_of_[v] == none) {
      corner_of_[v] = static_cast<Index>(corners_.size());
      corners_.push_back({place, {}});
    }
    return corner_of_[v];
  }

  void add(Index a, Index b) {
    const Vector<3> edge = corners_[b].place - corners_[a].place;
    QuadricForm<3> line = QuadricForm<3>::point(squared_length(edge));
    line += QuadricForm<3>::plane(edge, -1); // but along the edge
    corners_[a].lines += line;
    corners_[b].lines += line;
    if (limit_ == no_limit)
      return;
    for (Index corner : {a, b})
      corners_[corner].chains.push_back(static_cast<Index>(chains_.size()));
    chains_.push_back({{a, b}, {corners_[a].place, corners_[b].place}});
  }

  static void move(Corner& corner, const Vector<3>& target) {
    corner.lines.move_origin(target - corner.place);
    corner.place = target;
  }

  // The place of an end of a chain after a change.
  const Vector<3>& end_of(const Chain& chain, std::size_t end, const Change& change,
                          const Vector<3>& target) const {
    return chain.ends[end] == change.left ? target : corners_[chain.ends[end]].place;
  }

  QUADRILLE_NOINLINE void contract(Index kept, Index gone, const Vector<3>& target) {
    if (!has(kept, gone))
      return;
    Index left = corner_of_[kept], other = corner_of_[gone];
    if (left == none)
      std::swap(left, other);
    if (limit_ != no_limit)
      if (std::optional<Change> change = change_to(kept, gone, target)) {
        left = change->left, other = change->gone;
        apply(std::move(*change));
      }
    move(corners_[left], target);
    if (other != none) {
      move(corners_[other], target);
      corners_[left].lines += corners_[other].lines;
    }
    corner_of_[kept] = left;
  }

  // The points of a chain from or to a corner.
  std::vector<Vector<3>> points_from(Index corner, Index chain) const {
    std::vector<Vector<3>> points = chains_[chain].points;
    if (chains_[chain].ends[0] != corner)
      std::reverse(points.begin(), points.end());
    return points;
  }
  Index other_end(Index corner, Index chain) const {
    const auto& [a, b] = chains_[chain].ends;
    return a == corner ? b : a;
  }
  static void append(std::vector<Vector<3>>& points, const std::vector<Vector<3>>& more) {
    points.insert(points.end(), more.begin() + 1, more.end());
  }

  // None if the chains stay as they are: at a vertex where other than two of them end, which is
  // fixed.
  std::optional<Change> change_to(Index v, Index w, const Vector<3>& target) const {
    const Index a = corner_of_[v] != none ? corner_of_[v] : corner_of_[w];
    const Index b = corner_of_[v] != none ? corner_of_[w] : none;
    if (b == none)
      return is_on_line(a) ? std::optional(split({a, {}, {}}, a, a, none, target)) : std::nullopt;
    const Index between = common_chain(a, b);
    if (between == none)
      return std::nullopt; // the pair is no edge of an outline, so it is never contracted
    Change change{a, {}, {}, b, between};
    if (is_on_line(a) && is_on_line(b))
      return split(std::move(change), a, b, between, target);
    if (!is_on_line(a))
      return is_on_line(b) ? std::optional(joined(std::move(change), a, b, between)) : std::nullopt;
    change.left = b;
    change.gone = a;
    return joined(std::move(change), b, a, between);
  }

  bool is_on_line(Index corner) const { return corners_[corner].chains.size() == 2; }
  // None if there are several, or none.
  Index common_chain(Index a, Index b) const {
    Index common = none;
    for (Index chain : corners_[a].chains)
      if (other_end(a, chain) == b) {
        if (common != none)
          return none;
        common = chain;
      }
    return common;
  }
  Index other_chain(Index corner, Index chain) const {
    const std::vector<Index>& chains = corners_[corner].chains;
    return chains[0] == chain ? chains[1] : chains[0];
  }

  // The corner that stays gets the chains between it and the other neighbour of the one that goes.
  Change joined(Change change, Index stays, Index goes, Index between) const {
    const Index next = other_chain(goes, between);
    Chain chain{{stays, other_end(goes, next)}, points_from(stays, between)};
    append(chain.points, points_from(goes, next));
    change.numbers = {next};
    change.chains = {std::move(chain)};
    return change;
  }

  // The chains from the neighbour of a to that of b are cut where they are nearest to the target.
  Change split(Change change, Index a, Index b, Index between, const Vector<3>& target) const {
    const Index before = between != none ? other_chain(a, between) : corners_[a].chains[0];
    const Index after = between != none ? other_chain(b, between) : corners_[b].chains[1];
    std::vector<Vector<3>> points = points_from(other_end(a, before), before);
    if (between != none)
      append(points, points_from(a, between));
    append(points, points_from(b, after));
    auto [first, second] = cut_next_to(target, points);
    change.numbers = {before, after};
    change.chains = {{{other_end(a, before), change.left}, std::move(first)},
                     {{change.left, other_end(b, after)}, std::move(second)}};
    return change;
  }

  static std::array<std::vector<Vector<3>>, 2> cut_next_to(const Vector<3>& target,
                                                           const std::vector<Vector<3>>& points) {
    std::size_t segment = 0;
    Vector<3> nearest = points.front();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vector<3> along = points[i + 1] - points[i];
      const double length = squared_length(along);
      const double t =
          length > 0 ? std::clamp(dot(target - points[i], along) / length, 0.0, 1.0) : 0;
      const Vector<3> p = points[i] + t * along;
      if (i == 0 || squared_distance(p, target) < squared_distance(nearest, target))
        segment = i, nearest = p;
    }
    const auto cut = points.begin() + static_cast<std::ptrdiff_t>(segment) + 1;
    std::vector<Vector<3>> before(points.begin(), cut), after{nearest};
    before.push_back(nearest);
    after.insert(after.end(), cut, points.end());
    return {std::move(before), std::move(after)};
  }

  void apply(Change change) {
    std::vector<Index> at_left;
    for (Index chain : corners_[change.left].chains)
      if (chain != change.joined)
        at_left.push_back(chain);
    for (std::size_t i = 0; i < change.numbers.size(); ++i) {
      chains_[change.numbers[i]] = std::move(change.chains[i]);
      if (std::find(at_left.begin(), at_left.end(), change.numbers[i]) == at_left.end())
        at_left.push_back(change.numbers[i]);
    }
    if (change.joined != none)
      chains_[change.joined] = {};
    if (change.gone != none)
      corners_[change.gone].chains.clear();
    corners_[change.left].chains = std::move(at_left);
  }

  Array<Index> corner_of_; // of each vertex; empty if there are no outlines
  std::vector<Corner> corners_;
  std::vector<Chain> chains_;
  double limit_ = no_limit;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_KEPT_OUTLINES_H
