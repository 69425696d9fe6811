#ifndef QUADRILLE_STOP_H
#define QUADRILLE_STOP_H

#include <quadrille/internal/policies.h>
#include <quadrille/report.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace quadrille {

/// Stops at `faces` faces: at exactly that many where parity and topology allow, else at the first
/// number below. On a surface without borders every contraction removes two faces.
struct FaceCount {
  std::size_t faces;

  bool operator()(const Status& status) const { return status.faces <= faces; }

  /// True of a surface that has gone beyond the target: the engine looks for another pair first.
  bool is_passed(const Status& status) const { return status.faces < faces; }
};

/// Stops when `ratio` of the input's faces are left. ratio lies in [0, 1].
struct FaceRatio {
  double ratio = 0.5;

  bool operator()(const Status& status) const { return target(status)(status); }
  bool is_passed(const Status& status) const { return target(status).is_passed(status); }

  /// Throws std::invalid_argument for a ratio that is not in [0, 1].
  void validate() const {
    if (!(ratio >= 0 && ratio <= 1))
      throw std::invalid_argument("quadrille::FaceRatio: the ratio " + std::to_string(ratio) +
                                  " is not in [0, 1]");
  }

private:
  FaceCount target(const Status& status) const {
    return {
        static_cast<std::size_t>(std::llround(ratio * static_cast<double>(status.initial_faces)))};
  }
};

/// Stops at `vertices` vertices.
struct VertexCount {
  std::size_t vertices;

  bool operator()(const Status& status) const { return status.vertices <= vertices; }
  bool is_passed(const Status& status) const { return status.vertices < vertices; }
};

} // namespace quadrille

#endif // QUADRILLE_STOP_H
