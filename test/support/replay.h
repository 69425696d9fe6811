#ifndef QUADRILLE_TEST_REPLAY_H
#define QUADRILLE_TEST_REPLAY_H

#include "soups.h"

#include <quadrille/record.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// \file
/// A recorder that keeps what it is told, and a surface on which that is done again, step by step,
/// by the simplest means: nothing of the engine.

namespace test {

struct KeptContraction {
  std::uint32_t kept, gone;
  std::vector<double> values;
  double error, bound;
  std::vector<std::uint32_t> removed;
};

/// A recorder.
struct Log {
  std::size_t width = 0;
  std::vector<double> values;
  std::vector<Triangle> triangles;
  std::vector<KeptContraction> contractions;
  int ends = 0;

  void begin(quadrille::RecordedSurface surface) {
    width = surface.width;
    values = std::move(surface.values);
    triangles = std::move(surface.triangles);
    contractions.clear();
  }
  void record(const quadrille::RecordedContraction& c) {
    contractions.push_back({c.kept,
                            c.gone,
                            {c.values.begin(), c.values.end()},
                            c.error,
                            c.distance_bound,
                            {c.removed_faces.begin(), c.removed_faces.end()}});
  }
  void end() { ++ends; }

  friend bool operator==(const Log& a, const Log& b) {
    return a.values == b.values && a.triangles == b.triangles &&
           std::equal(a.contractions.begin(), a.contractions.end(), b.contractions.begin(),
                      b.contractions.end(), [](const KeptContraction& c, const KeptContraction& d) {
                        return c.kept == d.kept && c.gone == d.gone && c.values == d.values &&
                               c.error == d.error && c.bound == d.bound && c.removed == d.removed;
                      });
  }
};

/// A surface on which contractions are done, by input indices.
class Replay {
public:
  explicit Replay(const Log& log) : log_(log), values_(log.values) {
    for (std::uint32_t face = 0; face < log.triangles.size(); ++face)
      if (log.triangles[face][0] != quadrille::not_recorded)
        faces_[face] = log.triangles[face];
    for (std::uint32_t v = 0; v < values_.size() / log.width; ++v)
      images_.push_back(v);
  }

  std::size_t steps() const { return step_; }
  const std::map<std::uint32_t, Triangle>& faces() const { return faces_; }
  std::set<std::uint32_t> vertices() const {
    std::set<std::uint32_t> vertices;
    for (const auto& [face, corners] : faces_)
      vertices.insert(corners.begin(), corners.end());
    return vertices;
  }
  std::vector<double> values(std::uint32_t v) const {
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(v * log_.width);
    return {begin, begin + static_cast<std::ptrdiff_t>(log_.width)};
  }
  /// What an input vertex has become, whether or not it has a face.
  std::uint32_t image(std::uint32_t v) const { return images_[v]; }

  /// Does the next contraction. False if it does not leave what it says: faces of three vertices,
  /// each once where `unique` says so.
  bool step() {
    const KeptContraction& c = log_.contractions[step_++];
    bool is_right = c.gone < images_.size() && images_[c.gone] == c.gone && c.kept != c.gone;
    for (std::uint32_t& image : images_)
      if (image == c.gone)
        image = c.kept;
    for (std::uint32_t face : c.removed)
      is_right = faces_.count(face) == 1 && is_right;
    for (auto& [face, corners] : faces_)
      for (std::uint32_t& v : corners)
        if (v == c.gone)
          v = c.kept;
    for (std::uint32_t face : c.removed)
      faces_.erase(face);
    for (const auto& [face, corners] : faces_)
      is_right = is_right && corners[0] != corners[1] && corners[1] != corners[2] &&
                 corners[2] != corners[0];
    std::copy(c.values.begin(), c.values.end(),
              values_.begin() + static_cast<std::ptrdiff_t>(c.kept * log_.width));
    return is_right;
  }

private:
  const Log& log_;
  std::vector<double> values_;
  std::map<std::uint32_t, Triangle> faces_;
  std::vector<std::uint32_t> images_;
  std::size_t step_ = 0;
};

} // namespace test

#endif // QUADRILLE_TEST_REPLAY_H
