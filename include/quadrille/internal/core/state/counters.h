#ifndef QUADRILLE_INTERNAL_CORE_STATE_COUNTERS_H
#define QUADRILLE_INTERNAL_CORE_STATE_COUNTERS_H

#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace quadrille::internal {

/// Counters of what contractions have done since the counters were last added up.
struct Counters {
  std::size_t faces = 0, vertices = 0; // that are gone
  std::size_t edges = 0;               // the same, where they are counted: see CountedEdges
  std::size_t contractions = 0, non_edge_contractions = 0;
  // Pairs that a pass leaves to the greedy order after it: nearly all if attributes are noise.
  std::size_t left = 0;
  std::size_t doubled_faces = 0, doubled_labels = 0, vanished_components = 0; // see Report
  std::array<std::size_t, rejection_causes> rejections{};
  double error = 0;          // the greatest
  double vanished_size = 0;  // of components
  std::uint64_t moved = 0;   // see Displacement
  bool loses_points = false; // of the input, which ReverseDeviation finds no face for

  void count_contraction(double its_error, std::uint64_t its_displacement) {
    ++contractions;
    ++vertices;
    error = (std::max)(error, its_error);
    moved += its_displacement;
  }
  void count_component(const ComponentEvent& component, std::size_t its_faces) {
    faces += its_faces;
    vertices += component.vertices.size();
    ++vanished_components;
    loses_points = true;
    error = (std::max)(error, component.radius);
    vanished_size = (std::max)(vanished_size, component.size);
  }
  void reject(Rejection cause) { ++rejections[static_cast<std::size_t>(cause)]; }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_COUNTERS_H
