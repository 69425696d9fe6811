#ifndef QUADRILLE_COMPILED_PREPARED_SOUP_H
#define QUADRILLE_COMPILED_PREPARED_SOUP_H

#include <quadrille/compiled.h>
#include <quadrille/cut_handles.h>
#include <quadrille/manifold.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Preparations of a soup that add points and triangles: it is made manifold, and handles are cut.

namespace quadrille::internal {

/// Does the call ask for a preparation?
inline bool has_preparation(const SoupOptions& options) {
  return options.manifold || options.simplified_topology;
}

/// A soup that has been prepared, with all that its points and triangles have. An added point has
/// what the first of those has from which it comes; an added triangle what that has which is next
/// to it.
class PreparedSoup {
public:
  PreparedSoup(const SoupView& soup, const SoupOptions& options)
      : soup_(soup), options_(options), points_(soup.points.begin(), soup.points.end()),
        triangles_(soup.triangles.begin(), soup.triangles.end()) {
    validate();
    if (options.manifold)
      follow(make_manifold(points_, triangles_));
    if (options.simplified_topology)
      cut();
    give_values();
    options_.manifold = false;
    options_.simplified_topology.reset();
  }

  /// A view of this object's arrays.
  SoupView view() const {
    SoupView view{points_, triangles_, labels_, soup_.channels};
    for (std::size_t i = 0; i < view.channels.size(); ++i) {
      view.channels[i].values = channels_[i].values;
      view.channels[i].triangles = channels_[i].triangles;
    }
    return view;
  }
  const SoupOptions& options() const { return options_; }

  /// Makes a result one of the soup as it was.
  void restore(SoupResult& result) const {
    if (!sources_.empty())
      for (std::uint32_t& face : result.input_faces)
        face = static_cast<std::uint32_t>(sources_[face]);
    if (!result.vertex_map.empty())
      result.vertex_map.resize(soup_.points.size());
    Report& report = result.report;
    report.vertices_before -= points_.size() - soup_.points.size();
    report.faces_before -= triangles_.size() - soup_.triangles.size();
    report.cut_handles = handles_.cut_handles;
    report.split_components = handles_.split_components;
    report.components_before -= handles_.split_components;
  }

private:
  void validate() const {
    const auto reject_if = [](bool is_there, const char* with) {
      if (is_there)
        throw std::invalid_argument(
            std::string("quadrille::simplified_soup: manifold and simplified_topology add points "
                        "and triangles: they do not go with ") +
            with);
    };
    reject_if(options_.split_vertices, "split_vertices, which joins points that they part");
    reject_if(options_.recorder.has_value(), "a recorder, which is given the points of the input");
    reject_if(options_.topology == Topology::free || options_.pairs_closer_than,
              "free topology or pairs, which join sheets that they part");
  }

  // Nothing is cut at fixed points, and where a triangle is not selected.
  void cut() {
    std::vector<bool> is_kept(points_.size(), false);
    for (std::size_t v = 0; v < points_.size(); ++v)
      is_kept[v] = (!options_.fixed.empty() && options_.fixed[root(v)]) ||
                   (!options_.shared.empty() && options_.shared[root(v)]);
    for (std::size_t face = 0; face < triangles_.size() && !options_.selected.empty(); ++face)
      if (!options_.selected[source(face)])
        for (const std::uint32_t v : triangles_[face])
          is_kept[v] = true;
    handles_ = cut_handles(points_, triangles_, *options_.simplified_topology, is_kept,
                           options_.threads);
    follow(handles_);
  }

  void follow(const auto& changes) {
    for (const auto& origin : changes.origins)
      roots_.push_back(root(origin.front()));
    std::vector<std::size_t> sources;
    for (const std::size_t triangle : changes.triangles)
      sources.push_back(source(triangle));
    sources_ = std::move(sources);
  }
  // The point of the input from which one comes first.
  std::size_t root(std::size_t point) const {
    return point < soup_.points.size() ? point : roots_[point - soup_.points.size()];
  }
  std::size_t source(std::size_t triangle) const {
    return sources_.empty() ? triangle : sources_[triangle];
  }

  void give_values() {
    for (auto* values : {&options_.fixed, &options_.shared})
      add_points(*values);
    for (auto* values : {&options_.importance, &options_.tolerance})
      add_points(*values);
    if (!options_.selected.empty()) {
      std::vector<bool> selected;
      for (const std::size_t source : sources_)
        selected.push_back(options_.selected[source]);
      options_.selected = std::move(selected);
    }
    for (std::size_t face = 0; face < triangles_.size() && !soup_.labels.empty(); ++face)
      labels_.push_back(soup_.labels[source(face)]);
    for (const SoupChannelView& channel : soup_.channels)
      channels_.push_back(prepared(channel));
  }
  template <class Value>
  void add_points(std::vector<Value>& values) const {
    if (values.empty())
      return;
    for (const std::size_t point : roots_)
      values.push_back(static_cast<Value>(values[point]));
  }

  SoupChannel prepared(const SoupChannelView& channel) const {
    SoupChannel result{channel.components, {channel.values.begin(), channel.values.end()}, {}};
    if (channel.triangles.empty()) {
      for (const std::size_t point : roots_)
        for (std::size_t k = 0; k < channel.components; ++k)
          result.values.push_back(channel.values[point * channel.components + k]);
      return result;
    }
    for (std::size_t face = 0; face < triangles_.size(); ++face) {
      std::array<std::uint32_t, 3>& values = result.triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        values[i] = channel.triangles[source(face)][corner(face, i)];
    }
    return result;
  }
  // The corner of its source at which a corner of a triangle is, or else at which the next one is.
  std::size_t corner(std::size_t face, std::size_t i) const {
    const auto& of_source = soup_.triangles[source(face)];
    for (std::size_t k = i; k < i + 3; ++k) {
      const auto at = std::find(of_source.begin(), of_source.end(), root(triangles_[face][k % 3]));
      if (at != of_source.end())
        return static_cast<std::size_t>(at - of_source.begin());
    }
    return i;
  }

  const SoupView& soup_;
  SoupOptions options_;
  SoupPoints points_;
  SoupTriangles triangles_;
  HandleChanges handles_;
  std::vector<std::size_t> roots_;   // of added points
  std::vector<std::size_t> sources_; // of all triangles; empty if they are as they were
  std::vector<std::uint32_t> labels_;
  std::vector<SoupChannel> channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_PREPARED_SOUP_H
