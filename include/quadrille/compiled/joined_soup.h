#ifndef QUADRILLE_COMPILED_JOINED_SOUP_H
#define QUADRILLE_COMPILED_JOINED_SOUP_H

#include <quadrille/compiled.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

/// \file
/// A soup with SoupOptions::split_vertices as one in which each place has one point.

namespace quadrille::internal {

/// A soup of which the triangles have the first point at each place. Values of points become values
/// of corners. Points that no triangle has any more stay where they are.
class JoinedSoup {
public:
  JoinedSoup(const SoupView& soup, const SoupOptions& options) : soup_(soup), options_(options) {
    join_points();
    triangles_.reserve(soup.triangles.size());
    for (const auto& [a, b, c] : soup.triangles)
      triangles_.push_back({first(a), first(b), first(c)});
    options_.split_vertices = false;
    share(options_.fixed, [](bool a, bool b) { return a || b; });
    share(options_.shared, [](bool a, bool b) { return a || b; });
    share(options_.importance, [](double a, double b) { return (std::max)(a, b); });
    share(options_.tolerance, [](double a, double b) { return (std::min)(a, b); });
  }

  /// A view of this object's triangles and the arrays of the caller.
  SoupView view() const {
    SoupView view = soup_;
    view.triangles = triangles_;
    for (SoupChannelView& channel : view.channels)
      if (channel.triangles.empty())
        channel.triangles = soup_.triangles;
    return view;
  }
  const SoupOptions& options() const { return options_; }

  /// Gives a result a point for each side of a seam of values that were of points.
  void restore(SoupResult& result) const {
    std::map<std::vector<double>, std::uint32_t> numbers; // of points, by their number and values
    SoupPoints points;
    std::vector<std::vector<double>> values(result.channels.size());
    SoupTriangles triangles = result.triangles;
    for (std::size_t face = 0; face < triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& point = triangles[face][i];
        std::vector<double> key{static_cast<double>(point)};
        for (std::size_t c = 0; c < values.size(); ++c)
          if (is_of_points(c)) {
            const auto value = value_at(result.channels[c], face, i);
            key.insert(key.end(), value.begin(), value.end());
          }
        const auto [place, is_new] =
            numbers.try_emplace(std::move(key), static_cast<std::uint32_t>(points.size()));
        if (is_new)
          points.push_back(result.points[point]);
        for (std::size_t c = 0; c < values.size() && is_new; ++c)
          if (is_of_points(c)) {
            const auto value = value_at(result.channels[c], face, i);
            values[c].insert(values[c].end(), value.begin(), value.end());
          }
        point = place->second;
      }
    for (std::size_t c = 0; c < values.size(); ++c)
      if (is_of_points(c)) {
        result.channels[c].values = std::move(values[c]);
        result.channels[c].triangles.clear();
      }
    result.points = std::move(points);
    result.triangles = std::move(triangles);
    result.vertex_map.clear();
    result.prepared = {};
  }

private:
  bool is_of_points(std::size_t channel) const { return soup_.channels[channel].triangles.empty(); }

  static std::span<const double> value_at(const SoupChannel& channel, std::size_t face,
                                          std::size_t i) {
    return std::span(channel.values)
        .subspan(channel.components * channel.triangles[face][i], channel.components);
  }

  // An index of no point stays, and is reported later.
  std::uint32_t first(std::uint32_t v) const { return v < firsts_.size() ? firsts_[v] : v; }

  void join_points() {
    std::map<std::array<double, 3>, std::uint32_t> firsts;
    for (std::uint32_t v = 0; v < soup_.points.size(); ++v)
      firsts_.push_back(firsts.try_emplace(soup_.points[v], v).first->second);
  }

  template <class Value, class Join>
  void share(std::vector<Value>& values, Join join) const {
    for (std::size_t v = 0; v < values.size() && v < firsts_.size(); ++v)
      values[firsts_[v]] = join(values[firsts_[v]], values[v]);
  }

  const SoupView& soup_;
  SoupOptions options_;
  std::vector<std::uint32_t> firsts_; // of each point, the first one at its place
  SoupTriangles triangles_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_JOINED_SOUP_H
