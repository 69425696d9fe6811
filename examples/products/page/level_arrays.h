#ifndef QUADRILLE_EXAMPLES_PAGE_LEVEL_ARRAYS_H
#define QUADRILLE_EXAMPLES_PAGE_LEVEL_ARRAYS_H

#include "attribute_recorder.h"
#include "track.h"

#include <quadrille/level_steps.h>
#include <quadrille/levels.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace quadrille_examples {

/// The box of a model, and its unit in a page: half of the diagonal.
struct PageFrame {
  quadrille::Vector<3> center{};
  double unit = 1;

  explicit PageFrame(const quadrille::Level& level) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low, high, half{};
    low.fill(infinity);
    high.fill(-infinity);
    for (const auto& triangle : level.triangles)
      for (const std::uint32_t v : triangle)
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], level.points[v][k]);
          high[k] = std::max(high[k], level.points[v][k]);
        }
    for (std::size_t k = 0; k < 3 && !level.triangles.empty(); ++k) {
      center[k] = low[k] / 2 + high[k] / 2;
      half[k] = high[k] / 2 - low[k] / 2;
    }
    if (const double length = std::hypot(half[0], half[1], half[2]); length > 0)
      unit = length;
  }

  quadrille::Vector<3> operator()(const std::array<double, 3>& point) const {
    quadrille::Vector<3> result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = point[k] / unit - center[k] / unit;
    return result;
  }
  /// Of the diagonal.
  double part(double length) const { return length / unit / 2; }
};

/// Of each vertex, the planes of the input's faces that have gone into it, weighted by area: the
/// same whatever cost has chosen the contractions.
class VertexErrors {
public:
  VertexErrors(const quadrille::Level& level, const PageFrame& frame)
      : planes_(level.points.size()) {
    for (const auto& [a, b, c] : level.triangles) {
      const auto plane = quadrille::Quadric{}.face(frame(level.points[a]), frame(level.points[b]),
                                                   frame(level.points[c]));
      for (const std::uint32_t v : {a, b, c})
        planes_[v] += plane;
    }
  }

  /// The root mean square distance of a vertex to its planes, as a part of the diagonal.
  double contract(const quadrille::LevelStep& step, const PageFrame& frame) {
    const quadrille::Vector<3> kept = frame(step.kept_before);
    const quadrille::Vector<3> after = frame(step.after) - kept;
    auto& planes = planes_[step.kept];
    planes = quadrille::QuadricForm<3>::sum_about_first(planes, planes_[step.gone],
                                                        frame(step.gone_before) - kept);
    planes.move_origin(after);
    const double weight = planes.trace();
    return weight > 0 ? std::sqrt(std::max(0., planes.constant()) / weight) / 2 : 0;
  }

private:
  std::vector<quadrille::QuadricForm<3>> planes_;
};

/// All that a page holds of levels, the finest of at most so many faces. A vertex has its position,
/// from the centre of the box in halves of its diagonal, its error as a part of the diagonal, and
/// the recorded attributes.
struct LevelArrays {
  Track vertices;
  Track textures;                         ///< width 0: there are none, or they are at vertices
  std::vector<std::uint32_t> faces_after; ///< of each contraction: how many are left
  std::vector<float> errors; ///< of each level: LevelInfo::error as a part of the diagonal
  std::vector<std::uint32_t> input_faces;
  std::size_t faces = 0; ///< of the finest level
};

/// Makes them of a recording, in linear time.
class LevelArraysBuilder {
public:
  LevelArraysBuilder(const quadrille::Levels& levels, const RecordedAttributes& attributes)
      : attributes_(attributes), finest_(levels.at(quadrille::AfterContractions{0})),
        frame_(finest_), errors_(finest_, frame_), steps_(levels) {}

  const PageFrame& frame() const { return frame_; }

  LevelArrays build(std::size_t most_faces) {
    begin();
    std::size_t first = 0; // contraction of the page
    std::size_t faces = finest_.faces;
    while (steps_.coarsen()) {
      take_step();
      if (faces > most_faces) {
        faces = arrays_.faces_after.back();
        ++first;
      }
    }
    take_textures();
    begin_after(first, faces);
    return std::move(arrays_);
  }

private:
  void begin() {
    Track& vertices = arrays_.vertices;
    vertices.width = 4 + attributes_.width();
    vertices.corners = finest_.triangles;
    vertices.add_items(finest_.points.size());
    for (std::size_t v = 0; v < finest_.points.size(); ++v)
      append(frame_(finest_.points[v]), 0, attributes_.values, finest_.input_vertices[v],
             vertices.values);
    arrays_.errors.push_back(static_cast<float>(frame_.part(finest_.error)));
  }

  void append(const quadrille::Vector<3>& position, double error,
              const std::vector<float>& attributes, std::size_t place,
              std::vector<float>& values) const {
    for (std::size_t k = 0; k < 3; ++k)
      values.push_back(static_cast<float>(position[k]));
    values.push_back(static_cast<float>(error));
    const auto from = attributes.begin() + static_cast<std::ptrdiff_t>(place * attributes_.width());
    values.insert(values.end(), from, from + static_cast<std::ptrdiff_t>(attributes_.width()));
  }

  void take_step() {
    const quadrille::LevelStep& step = steps_.last_step();
    Track& vertices = arrays_.vertices;
    const std::size_t contraction = arrays_.faces_after.size();
    for (std::size_t v = step.coarser_vertices; v < step.finer_vertices; ++v)
      vertices.end_item(v, contraction, v == step.gone ? step.kept : Track::none);
    if (step.kept != quadrille::not_recorded) {
      vertices.changed.push_back(step.kept);
      append(frame_(step.after), errors_.contract(step, frame_), attributes_.changed_values,
             pairs_++, vertices.changed_values);
    }
    vertices.end_contraction();
    arrays_.faces_after.push_back(static_cast<std::uint32_t>(step.coarser_faces));
    arrays_.errors.push_back(static_cast<float>(frame_.part(steps_.info().error)));
  }

  /// By the faces of the levels instead of those of the input.
  void take_textures() {
    if (attributes_.textures.width == 0)
      return;
    arrays_.textures = attributes_.textures;
    arrays_.textures.corners.clear();
    for (const std::uint32_t face : finest_.input_faces)
      arrays_.textures.corners.push_back(attributes_.textures.corners[face]);
    arrays_.textures.number_by_end();
  }

  void begin_after(std::size_t contractions, std::size_t faces) {
    const auto cut = [&](auto& values, std::size_t count) {
      values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    arrays_.vertices.begin_after(contractions, faces);
    if (arrays_.textures.width > 0)
      arrays_.textures.begin_after(contractions, faces);
    cut(arrays_.faces_after, contractions);
    cut(arrays_.errors, contractions);
    arrays_.input_faces = finest_.input_faces;
    arrays_.input_faces.resize(faces);
    arrays_.faces = faces;
  }

  const RecordedAttributes& attributes_;
  quadrille::Level finest_;
  PageFrame frame_;
  VertexErrors errors_;
  quadrille::LevelSteps steps_;
  std::size_t pairs_ = 0; // contracted so far
  LevelArrays arrays_;
};

} // namespace quadrille_examples

#endif
