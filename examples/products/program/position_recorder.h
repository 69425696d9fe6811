#ifndef QUADRILLE_EXAMPLES_PROGRAM_POSITION_RECORDER_H
#define QUADRILLE_EXAMPLES_PROGRAM_POSITION_RECORDER_H

#include <quadrille/levels.h>
#include <quadrille/record.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace quadrille_examples {

/// A recorder that tells levels of the positions only, whatever attributes vertices and corners
/// have.
class PositionRecorder {
public:
  explicit PositionRecorder(quadrille::Levels& levels) : levels_(levels) {}

  void begin(quadrille::RecordedSurface surface) {
    std::size_t end = 0;
    for (std::size_t v = 0; v < surface.values.size(); v += surface.width)
      for (std::size_t k = 0; k < dimension; ++k)
        surface.values[end++] = surface.values[v + k];
    surface.values.resize(end);
    surface.dimension = surface.width = dimension;
    surface.channels.clear();
    levels_.begin(std::move(surface));
  }
  void record(const quadrille::RecordedContraction& contraction) {
    quadrille::RecordedContraction of_positions = contraction;
    of_positions.values = contraction.values.first(std::min(dimension, contraction.values.size()));
    of_positions.wedges = {};
    levels_.record(of_positions);
  }
  void end() { levels_.end(); }

private:
  static constexpr std::size_t dimension = 3;
  quadrille::Levels& levels_;
};

} // namespace quadrille_examples

#endif
