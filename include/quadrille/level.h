#ifndef QUADRILLE_LEVEL_H
#define QUADRILLE_LEVEL_H

#include <quadrille/recorded.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille {

/// The coarsest level whose error is at most a distance in the mesh's units: see Report::error.
struct ErrorAtMost {
  double error; ///< at least 0
};
/// The coarsest level no point of which is known to be further from the input than a distance in
/// the mesh's units: see Report::distance_bound. For recordings with a stop policy that asks for
/// distances, as ErrorLimit.
struct DistanceAtMost {
  double distance; ///< at least 0
};
/// The level after that many contractions.
struct AfterContractions {
  std::size_t contractions; ///< 0: the input
};

/// What is known of a level.
struct LevelInfo {
  std::size_t faces = 0;        ///< of the level
  std::size_t vertices = 0;     ///< of the level
  std::size_t contractions = 0; ///< that lead to it
  double error = 0;             ///< as Report::error; rounded up to a float
  /// As Report::distance_bound, or more: it never falls from a level to a coarser one.
  double distance_bound = std::numeric_limits<double>::infinity();
  /// The same of Report::hausdorff_bound; distance_bound is no less then. For recordings with a
  /// stop policy that asks both ways, as HausdorffLimit; else infinite, but for the input.
  double hausdorff_bound = std::numeric_limits<double>::infinity();
};

/// The values of a channel at a level.
struct LevelChannel {
  std::size_t components = 0; ///< how many numbers a value has
  std::vector<double> values; ///< one value after the other
  /// Of each triangle, the values of its corners; empty: a value has the index of its point.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A surface at a level of detail, as a soup. Of two levels of one recording the coarser one has
/// the first faces and the first vertices of the finer one, by input indices.
struct Level : LevelInfo {
  std::vector<std::array<double, 3>> points;           ///< in the mesh's units
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  /// The attributes that the cost reads, if it reads any; then the channels, in the order of the
  /// call. Values are numbers of the user's unit, not yet rounded to the user's type.
  std::vector<LevelChannel> channels;
  /// Of each point, which one of the input it is; of a mesh by the order of vertices(mesh).
  std::vector<std::uint32_t> input_vertices;
  /// Of each triangle, which face of the input it is; of a mesh by the order of faces(mesh). So a
  /// label or a colour of a face is found.
  std::vector<std::uint32_t> input_faces;
};

/// The same level with its points and triangles in the order of the input, as `simplify` leaves
/// them; channels too where a value has the index of its point. Takes O(n log n) time.
inline Level in_input_order(const Level& level) {
  const auto ordered = [](const std::vector<std::uint32_t>& inputs) {
    std::vector<std::uint32_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return inputs[i] < inputs[j]; });
    return order;
  };
  Level sorted = level;
  const std::vector<std::uint32_t> vertices = ordered(level.input_vertices);
  std::vector<std::uint32_t> place(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    place[vertices[i]] = i;
    sorted.points[i] = level.points[vertices[i]];
    sorted.input_vertices[i] = level.input_vertices[vertices[i]];
  }
  const std::vector<std::uint32_t> faces = ordered(level.input_faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      sorted.triangles[i][k] = place[level.triangles[faces[i]][k]];
    sorted.input_faces[i] = level.input_faces[faces[i]];
  }
  for (std::size_t c = 0; c < sorted.channels.size(); ++c) {
    LevelChannel& channel = sorted.channels[c];
    const LevelChannel& old = level.channels[c];
    for (std::size_t i = 0; i < channel.triangles.size(); ++i)
      channel.triangles[i] = old.triangles[faces[i]];
    for (std::size_t i = 0; i < vertices.size() && channel.triangles.empty(); ++i)
      std::copy_n(&old.values[vertices[i] * channel.components], channel.components,
                  &channel.values[i * channel.components]);
  }
  return sorted;
}

/// Where the vertices of the input are at a level: members[i] are those that have become its vertex
/// i, in ascending order.
class LevelMembers {
public:
  /// Of what Levels::images says of a level, and how many vertices that has. Linear time.
  LevelMembers(const std::vector<std::uint32_t>& images, std::size_t vertices)
      : begin_(vertices + 1, 0) {
    for (std::uint32_t image : images)
      if (image != not_recorded)
        ++begin_[image + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    members_.resize(begin_.back());
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t v = 0; v < images.size(); ++v)
      if (images[v] != not_recorded)
        members_[end[images[v]]++] = v;
  }
  std::size_t size() const { return begin_.size() - 1; } ///< how many vertices the level has
  /// The vertices of the input, by number, that have become vertex i.
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(members_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> members_;
};

} // namespace quadrille

#endif // QUADRILLE_LEVEL_H
