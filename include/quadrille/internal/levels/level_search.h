#ifndef QUADRILLE_INTERNAL_LEVELS_LEVEL_SEARCH_H
#define QUADRILLE_INTERNAL_LEVELS_LEVEL_SEARCH_H

#include <quadrille/internal/levels/level_track.h>
#include <quadrille/level.h>
#include <quadrille/stop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

/// What is known of a level; of its bound only if distances have been recorded.
inline LevelInfo level_info(std::size_t faces, std::size_t vertices, std::size_t contractions,
                            double error, bool knows_bounds, bool are_both_ways, double bound) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const double known = contractions == 0 ? 0 : knows_bounds ? bound : unknown;
  return {faces, vertices, contractions,
          error, known,    contractions == 0 || are_both_ways ? known : unknown};
}

/// That many contractions into a segment.
struct LevelPlace {
  std::size_t segment, contractions;
};

/// Finds levels in segments, of which there is one at least, in logarithmic time.
class LevelSearch {
public:
  /// `before`: how many contractions come before the first segment.
  LevelSearch(const std::vector<LevelSegment>& segments, std::size_t before)
      : segments_(segments), before_(before) {}

  LevelPlace find(const FaceCount& stop) const {
    return first([&](const LevelSegment& segment, std::size_t i) {
      return segment.faces_at(i) <= stop.faces;
    });
  }
  LevelPlace find(const VertexCount& stop) const {
    return first([&](const LevelSegment& segment, std::size_t i) {
      return segment.tracks.front().items_at(i) <= stop.vertices;
    });
  }
  LevelPlace find(const ErrorAtMost& stop) const {
    return last([&](const LevelSegment& segment, std::size_t i) {
      return segment.error_at(i) <= stop.error;
    });
  }
  LevelPlace find(const DistanceAtMost& stop) const {
    const LevelSegment& segment = segments_.front();
    if (segment.contractions() > 0 && segment.bounds.empty())
      throw std::logic_error("quadrille::Levels: distances have not been recorded: simplify with a "
                             "stop policy that asks for them, as ErrorLimit");
    return last(
        [&](const LevelSegment& s, std::size_t i) { return s.bound_at(i) <= stop.distance; });
  }
  LevelPlace find(const AfterContractions& stop) const {
    std::size_t s = 0, left = stop.contractions - (std::min)(stop.contractions, before_);
    for (; s + 1 < segments_.size() && left > segments_[s].contractions(); ++s)
      left -= segments_[s].contractions();
    return {s, (std::min)(left, segments_[s].contractions())};
  }

private:
  // The first level of which is_enough(segment, contractions) holds, which it does of all coarser
  // ones; else the coarsest.
  template <class IsEnough>
  LevelPlace first(IsEnough is_enough) const {
    std::size_t s = 0;
    while (s + 1 < segments_.size() && !is_enough(segments_[s], segments_[s].contractions()))
      ++s;
    std::size_t low = 0, high = segments_[s].contractions();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (is_enough(segments_[s], middle))
        high = middle;
      else
        low = middle + 1;
    }
    return {s, low};
  }
  // The last one of which is_within(segment, contractions) holds, which it does of all finer ones;
  // else the finest.
  template <class IsWithin>
  LevelPlace last(IsWithin is_within) const {
    const LevelPlace place = first([&](const LevelSegment& segment, std::size_t contractions) {
      return !is_within(segment, contractions);
    });
    if (place.contractions == 0 || is_within(segments_[place.segment], place.contractions))
      return place; // the first of the first segment, or the last of all
    return {place.segment, place.contractions - 1};
  }

  const std::vector<LevelSegment>& segments_;
  std::size_t before_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_LEVEL_SEARCH_H
