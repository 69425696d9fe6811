#ifndef QUADRILLE_COMPILED_PREPARED_SOUP_H
#define QUADRILLE_COMPILED_PREPARED_SOUP_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/prepared_channel.h>
#include <quadrille/cut_handles.h>
#include <quadrille/join_gaps.h>
#include <quadrille/manifold.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Preparations of a soup that add points and triangles: it is made manifold, components are joined
/// across gaps, and handles are cut.

namespace quadrille::internal {

/// Does the call ask for a preparation?
inline bool has_preparation(const SoupOptions& options) {
  return options.manifold || options.join_gaps || options.simplified_topology;
}

/// A soup that has been prepared, with all that its points and triangles have. A point in the
/// middle of others lies between them in what it has; a copy has what its original has; an added
/// triangle is as the one next to it.
class PreparedSoup {
public:
  PreparedSoup(const SoupView& soup, const SoupOptions& options)
      : soup_(soup), options_(options), points_(soup.points.begin(), soup.points.end()),
        triangles_(soup.triangles.begin(), soup.triangles.end()), sources_(triangles_.size()),
        channels_(soup.channels.begin(), soup.channels.end()) {
    validate();
    std::iota(sources_.begin(), sources_.end(), std::size_t{0});
    if (options.manifold)
      split();
    if (options.join_gaps)
      join();
    if (options.simplified_topology)
      cut();
    for (const std::size_t source : sources_) {
      if (!soup.labels.empty())
        labels_.push_back(soup.labels[source]);
      if (!options.selected.empty())
        selected_.push_back(options.selected[source]);
    }
    options_.selected = std::move(selected_);
    options_.manifold = false;
    options_.join_gaps.reset();
    options_.simplified_topology.reset();
    if (options_.order != SoupOptions::Order::relaxed)
      options_.threads = 1; // only the search for loops shared them
  }

  /// A view of this object's arrays.
  SoupView view() const {
    SoupView view{points_, triangles_, labels_, {}};
    for (const PreparedChannel& channel : channels_)
      view.channels.push_back(channel.view());
    return view;
  }
  const SoupOptions& options() const { return options_; }

  /// Makes a result one of the soup as it was. To be called once, at the end.
  void restore(SoupResult& result) {
    for (std::uint32_t& face : result.input_faces)
      face = static_cast<std::uint32_t>(sources_[face]);
    Report& report = result.report;
    report.vertices_before -= points_.size() - soup_.points.size();
    report.faces_before = soup_.triangles.size();
    report.cut_handles = handles_.cut_handles;
    report.split_components = handles_.split_components;
    report.components_before += gaps_.joined_gaps - handles_.split_components;
    report.joined_gaps = gaps_.joined_gaps;
    report.open_gaps = gaps_.open_gaps;
    report.cut_distance = handles_.distance;
    report.split_vertices = splits_.split_vertices;
    report.split_edges = splits_.split_edges;
    result.prepared = {std::move(points_), std::move(triangles_), std::move(roots_),
                       result.vertex_map};
    result.vertex_map.resize(soup_.points.size());
  }

private:
  void validate() const {
    const auto reject_if = [](bool is_there, const char* with) {
      if (is_there)
        throw std::invalid_argument(
            std::string("quadrille::simplified_soup: manifold, join_gaps and simplified_topology "
                        "add points and triangles: they do not go with ") +
            with);
    };
    reject_if(options_.topology == Topology::free || options_.pairs_closer_than,
              "free topology or pairs, which join sheets that they part");
    reject_if(options_.simplified_topology && options_.keep_solid,
              "keep_solid: both sides of a cut touch, which a solid does not");
  }

  void split() {
    const SoupTriangles before = triangles_;
    const std::size_t points_before = points_.size();
    splits_ = make_manifold(points_, triangles_);
    for (PreparedChannel& channel : channels_)
      channel.follow(splits_, points_before, before, triangles_);
    follow(splits_);
  }

  void join() {
    const SoupTriangles before = triangles_;
    const std::size_t points_before = points_.size();
    gaps_ = quadrille::join_gaps(points_, triangles_, *options_.join_gaps, kept_points());
    for (PreparedChannel& channel : channels_)
      channel.follow(gaps_, points_before, before, triangles_);
    follow(gaps_);
  }

  // Nothing is joined or cut at fixed points, and where a triangle is not selected.
  std::vector<bool> kept_points() const {
    std::vector<bool> is_kept(points_.size(), false);
    for (std::size_t v = 0; v < points_.size(); ++v)
      is_kept[v] = (!options_.fixed.empty() && options_.fixed[v]) ||
                   (!options_.shared.empty() && options_.shared[v]);
    for (std::size_t face = 0; face < triangles_.size() && !options_.selected.empty(); ++face)
      if (!options_.selected[sources_[face]])
        for (const std::uint32_t v : triangles_[face])
          is_kept[v] = true;
    return is_kept;
  }

  void cut() {
    const std::size_t points_before = points_.size();
    handles_ = cut_handles(points_, triangles_, *options_.simplified_topology, kept_points(),
                           options_.threads);
    const CutCaps caps(handles_, points_before, triangles_);
    for (PreparedChannel& channel : channels_)
      channel.follow(caps);
    follow(handles_);
  }

  void follow(const auto& changes) {
    for (const std::array<std::size_t, 2>& ends : changes.origins) {
      roots_.push_back(root(ends[0]));
      const auto append = [&](auto& values, auto between) {
        if (!values.empty())
          values.push_back(between(values[ends[0]], values[ends[1]]));
      };
      const auto are_both = [](bool of_a, bool of_b) { return of_a && of_b; };
      append(options_.fixed, are_both);
      append(options_.shared, are_both);
      append(options_.importance, [](double of_a, double of_b) { return (of_a + of_b) / 2; });
      append(options_.tolerance, [](double of_a, double of_b) { return (std::min)(of_a, of_b); });
    }
    std::vector<std::size_t> sources;
    for (const std::size_t triangle : changes.triangles)
      sources.push_back(sources_[triangle]);
    sources_ = std::move(sources);
  }
  // The point of the input from which one comes first.
  std::uint32_t root(std::size_t point) const {
    return point < soup_.points.size() ? static_cast<std::uint32_t>(point)
                                       : roots_[point - soup_.points.size()];
  }

  const SoupView& soup_;
  SoupOptions options_;
  SoupPoints points_;
  SoupTriangles triangles_;
  ManifoldChanges splits_;
  GapChanges gaps_;
  HandleChanges handles_;
  std::vector<std::uint32_t> roots_; // of added points
  std::vector<std::size_t> sources_; // of all triangles
  std::vector<std::uint32_t> labels_;
  std::vector<bool> selected_;
  std::vector<PreparedChannel> channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_PREPARED_SOUP_H
