#ifndef QUADRILLE_COMPILED_PREPARED_CHANNEL_H
#define QUADRILLE_COMPILED_PREPARED_CHANNEL_H

#include <quadrille/channel_options.h>
#include <quadrille/compiled.h>
#include <quadrille/cut_handles.h>
#include <quadrille/manifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// The values of a channel at points and triangles that preparations add.

namespace quadrille::internal {

/// The triangles that close one side of a cut: a fan around a point in the middle, which is the
/// last corner of each, or a single one.
struct CutCap {
  static constexpr auto none = static_cast<std::size_t>(-1);

  std::size_t first = 0, last = 0; ///< its triangles, of which the last one is not part
  std::size_t middle = none;       ///< a point; none of a single triangle
  /// The triangles that have the second and the third edge of a single triangle; or none.
  std::array<std::size_t, 2> neighbors{none, none};
};

/// The triangles that cut_handles() has added to a soup, cap by cap.
class CutCaps {
public:
  /// `triangles` are those after the cuts.
  CutCaps(const HandleChanges& changes, std::size_t points_before,
          std::span<const std::array<std::uint32_t, 3>> triangles)
      : changes_(changes), triangles_(triangles), points_before_(points_before),
        first_(triangles.size() - changes.neighbors.size()) {
    for (std::size_t i = 0; i < changes.origins.size(); ++i) {
      const auto [a, b] = changes.origins[i];
      originals_.push_back(a == b ? original(a) : points_before + i);
    }
    find_caps();
    find_neighbors();
  }

  const std::vector<CutCap>& all() const { return caps_; }
  const HandleChanges& changes() const { return changes_; }
  const std::array<std::uint32_t, 3>& triangle(std::size_t face) const { return triangles_[face]; }
  /// A triangle that has the first edge of an added one.
  std::size_t neighbor(std::size_t face) const { return changes_.neighbors[face - first_]; }
  std::size_t points_before() const { return points_before_; }

  /// The point of which one is a copy, or a copy of a copy, or itself.
  std::size_t original(std::size_t point) const {
    return point < points_before_ ? point : originals_[point - points_before_];
  }
  /// The corner of a triangle at a point or a copy of it.
  std::size_t corner_at(std::size_t face, std::size_t point) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (original(triangles_[face][i]) == original(point))
        return i;
    return 0;
  }

private:
  void find_caps() {
    std::vector<bool> is_known(changes_.origins.size(), false); // of points in the middle
    for (std::size_t face = first_; face < triangles_.size();) {
      CutCap cap{.first = face, .last = face + 1};
      const std::size_t apex = original(triangles_[face][2]);
      if (apex >= points_before_ && !is_known[apex - points_before_]) {
        is_known[apex - points_before_] = true;
        cap.middle = apex;
        while (!is_closed(cap) && cap.last < triangles_.size() &&
               original(triangles_[cap.last][2]) == apex)
          ++cap.last;
      }
      caps_.push_back(cap);
      face = cap.last;
    }
  }
  // Does the last triangle end where the first one begins?
  bool is_closed(const CutCap& cap) const {
    return original(triangles_[cap.last - 1][1]) == original(triangles_[cap.first][0]);
  }

  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void find_neighbors() {
    std::map<Edge, std::size_t*> wanted; // as their neighbours run along them
    for (CutCap& cap : caps_)
      for (std::size_t i = 0; i < 2 && cap.middle == CutCap::none; ++i) {
        const auto& t = triangles_[cap.first];
        wanted[{t[(i + 2) % 3], t[i + 1]}] = &cap.neighbors[i];
      }
    for (std::size_t face = 0; face < triangles_.size() && !wanted.empty(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto found = wanted.find({triangles_[face][i], triangles_[face][(i + 1) % 3]});
            found != wanted.end())
          *found->second = face;
  }

  const HandleChanges& changes_;
  std::span<const std::array<std::uint32_t, 3>> triangles_;
  std::size_t points_before_, first_;
  std::vector<std::size_t> originals_; // of added points
  std::vector<CutCap> caps_;
};

/// A channel whose values follow preparations. A point in the middle of others has the mean of
/// their values. A cap has the values that its neighbours have at their common edges; where these
/// are in several charts, it is cut into them, too.
class PreparedChannel {
public:
  explicit PreparedChannel(const SoupChannelView& channel)
      : view_(channel), components_(channel.components),
        values_(channel.values.begin(), channel.values.end()),
        triangles_(channel.triangles.begin(), channel.triangles.end()),
        is_of_points_(triangles_.empty()) {}

  /// A view of this object's arrays.
  SoupChannelView view() const {
    SoupChannelView view = view_;
    view.values = values_;
    view.triangles = triangles_;
    return view;
  }

  /// Follows changes by which triangles are fragments of others, or have an edge with them in
  /// common: a cut into sheets, and joins across gaps. `before` are the triangles as they were.
  template <class Changes>
  void follow(const Changes& changes, std::size_t points_before,
              std::span<const std::array<std::uint32_t, 3>> before,
              std::span<const std::array<std::uint32_t, 3>> after) {
    if (is_of_points_) {
      for (const auto& [a, b] : changes.origins)
        add_mean({a, b});
      return;
    }
    Middles middles;
    SoupTriangles triangles;
    for (std::size_t face = 0; face < after.size(); ++face) {
      const std::size_t source = changes.triangles[face];
      const auto value_at = [&](std::size_t point, auto& self) -> std::size_t {
        const auto& corners = before[source];
        const auto at = std::find(corners.begin(), corners.end(), point);
        if (at != corners.end())
          return triangles_[source][static_cast<std::size_t>(at - corners.begin())];
        if (point < points_before)
          return no_value;
        const auto [a, b] = changes.origins[point - points_before];
        return middle_of(self(a, self), self(b, self), middles);
      };
      std::array<std::size_t, 3> values{};
      for (std::size_t i = 0; i < 3; ++i)
        values[i] = value_at(after[face][i], value_at);
      triangles.push_back(without_gaps(values));
    }
    triangles_ = std::move(triangles);
  }

  /// Follows cuts of handles.
  void follow(const CutCaps& caps) {
    if (is_of_points_)
      for (const auto& [a, b] : caps.changes().origins)
        add_mean({a, b});
    else
      triangles_.resize(triangles_.size() + caps.changes().neighbors.size());
    for (const CutCap& cap : caps.all())
      if (cap.middle == CutCap::none)
        close_by_triangle(caps, cap);
      else
        close_by_fan(caps, cap);
    for (std::size_t i = 0; i < caps.changes().origins.size() && is_of_points_; ++i)
      copy(caps.original(caps.points_before() + i), caps.points_before() + i);
  }

private:
  using Middles = std::map<std::pair<std::size_t, std::size_t>, std::uint32_t>;
  static constexpr auto no_value = static_cast<std::size_t>(-1);

  // The value in the middle between two, which is the same one for all triangles there.
  std::size_t middle_of(std::size_t a, std::size_t b, Middles& middles) {
    if (a == b || a == no_value || b == no_value)
      return a == b ? a : no_value;
    const auto [low, high] = std::minmax(a, b);
    const auto [place, is_new] = middles.try_emplace({low, high}, 0);
    if (is_new)
      place->second = add_mean({low, high});
    return place->second;
  }
  // A corner at the other wall of a gap has the value of the next one that is at this wall.
  static std::array<std::uint32_t, 3> without_gaps(const std::array<std::size_t, 3>& values) {
    std::array<std::uint32_t, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = i + 3; k-- > i;)
        if (values[k % 3] != no_value)
          result[i] = static_cast<std::uint32_t>(values[k % 3]);
    return result;
  }

  std::size_t value_at(const CutCaps& caps, std::size_t face, std::size_t point) const {
    return is_of_points_ ? point : triangles_[face][caps.corner_at(face, point)];
  }

  void close_by_triangle(const CutCaps& caps, const CutCap& cap) {
    if (is_of_points_)
      return; // it has the values of its points
    const auto [a, b, c] = caps.triangle(cap.first);
    const std::size_t neighbor = caps.neighbor(cap.first);
    const std::size_t of_a = value_at(caps, neighbor, a), of_b = value_at(caps, neighbor, b);
    std::size_t of_c = CutCap::none;
    for (const auto& [face, point, value] :
         {std::tuple{cap.neighbors[0], b, of_b}, std::tuple{cap.neighbors[1], a, of_a}})
      if (of_c == CutCap::none && face < cap.first && are_equal(value_at(caps, face, point), value))
        of_c = value_at(caps, face, c);
    if (of_c == CutCap::none)
      of_c = add_mean({of_a, of_b});
    set(cap.first, {of_a, of_b, of_c});
  }

  void close_by_fan(const CutCaps& caps, const CutCap& cap) {
    std::vector<std::array<std::size_t, 2>> edges; // values of the triangles at the loop
    for (std::size_t face = cap.first; face < cap.last; ++face) {
      const auto& t = caps.triangle(face);
      edges.push_back(
          {value_at(caps, caps.neighbor(face), t[0]), value_at(caps, caps.neighbor(face), t[1])});
    }
    const std::size_t n = edges.size();
    const auto is_seam = [&](std::size_t i) { // between the i-th triangle and the one before it
      return !are_equal(edges[(i + n - 1) % n][1], edges[i % n][0]);
    };
    std::size_t begin = 0; // of a chart
    while (begin + 1 < n && !is_seam(begin))
      ++begin;
    for (std::size_t done = 0, end = 0; done < n; done = end) {
      std::vector<std::size_t> around;
      for (end = done; end == done || (end < n && !is_seam(begin + end)); ++end)
        around.insert(around.end(), edges[(begin + end) % n].begin(),
                      edges[(begin + end) % n].end());
      if (is_of_points_) {
        set_mean(cap.middle, around);
        continue;
      }
      const std::uint32_t middle = add_mean(around);
      for (std::size_t i = done; i < end; ++i) {
        const auto [a, b] = edges[(begin + i) % n];
        set(cap.first + (begin + i) % n, {a, b, middle});
      }
    }
  }

  void set(std::size_t face, const std::array<std::size_t, 3>& values) {
    for (std::size_t i = 0; i < 3; ++i)
      triangles_[face][i] = static_cast<std::uint32_t>(values[i]);
  }

  bool are_equal(std::size_t a, std::size_t b) const {
    const double* const first = values_.data() + a * components_;
    return std::equal(first, first + components_, values_.data() + b * components_);
  }
  void copy(std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < components_; ++k)
      values_[to * components_ + k] = values_[from * components_ + k];
  }

  std::uint32_t add_mean(const std::vector<std::size_t>& of) {
    const std::size_t index = values_.size() / components_;
    values_.resize(values_.size() + components_);
    set_mean(index, of);
    return static_cast<std::uint32_t>(index);
  }
  // There is nothing between existing values; the mean of normals has their length.
  void set_mean(std::size_t index, const std::vector<std::size_t>& of) {
    copy(of.front(), index);
    const bool are_all_equal = std::all_of(
        of.begin(), of.end(), [&](std::size_t value) { return are_equal(value, of.front()); });
    if (are_all_equal || view_.options.new_values == NewValues::existing)
      return;
    std::vector<double> mean(components_, 0.);
    for (const std::size_t value : of)
      for (std::size_t k = 0; k < components_; ++k)
        mean[k] += values_[value * components_ + k] / static_cast<double>(of.size());
    if (view_.kind == SoupChannelView::Kind::normals) {
      const double length = std::hypot(mean[0], mean[1], mean[2]);
      if (!(length > 1e-6))
        return;
      for (double& component : mean)
        component /= length;
    }
    std::copy(mean.begin(), mean.end(),
              values_.begin() + static_cast<std::ptrdiff_t>(index * components_));
  }

  SoupChannelView view_;
  std::size_t components_;
  std::vector<double> values_;
  SoupTriangles triangles_;
  bool is_of_points_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_PREPARED_CHANNEL_H
