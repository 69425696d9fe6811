#ifndef QUADRILLE_INTERNAL_VISIBILITY_FACE_RAYS_H
#define QUADRILLE_INTERNAL_VISIBILITY_FACE_RAYS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/visibility/ray_directions.h>
#include <quadrille/internal/visibility/ray_tree.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The rays that have left a face on each of its sides, and those that nothing was in the way of.
struct RayCounts {
  std::array<std::uint32_t, 2> rays{}, free{}; ///< the front and the back

  std::uint32_t all() const { return rays[0] + rays[1]; }
  std::uint32_t most_free() const { return (std::max)(free[0], free[1]); }
  /// Adds the rays of another face, which may be turned around.
  void add(const RayCounts& other, bool is_turned) {
    for (std::size_t side = 0; side < 2; ++side) {
      rays[side] += other.rays[is_turned ? 1 - side : side];
      free[side] += other.free[is_turned ? 1 - side : side];
    }
  }
  /// Returns the fraction of free rays, of the side that has more: from 0 to 1.
  double fraction() const {
    double most = 0;
    for (std::size_t side = 0; side < 2; ++side)
      if (rays[side] > 0)
        most = (std::max)(most, static_cast<double>(free[side]) / rays[side]);
    return most;
  }
};

/// How a face is looked at.
struct RayPlan {
  bool is_front_only = false; ///< do back sides count?
  /// A face is not looked at any longer once its fraction of free rays is certainly above that;
  /// with 1, it always gets all rays.
  double enough = 1;
};

/// Sends rays from faces. Each ray leaves from a point of its own, so that points and directions
/// are spread together.
///
/// A face that lies on its reverse is covered from behind: only its front counts.
class FaceRays {
public:
  FaceRays(const RayTree& tree, std::size_t directions, const RayPlan& plan)
      : tree_(tree), directions_(directions), plan_(plan), areas_(tree.size()),
        is_covered_(tree.size(), plan.is_front_only) {
    find_covered();
    double sum = 0;
    for (std::size_t slot = 0; slot < tree.size(); ++slot)
      sum += areas_[slot] = std::sqrt(squared_length(normal(slot)));
    unit_area_ = sum > 0 ? sum / (std::max)(static_cast<double>(tree.size()), fewest_units) : 1;
  }

  /// The sets of directions of a face with a unit of area: others get the more of them the larger
  /// they are.
  struct Sets {
    std::size_t first, count;
    std::size_t share = 1; ///< 4: only the first quarter of each
  };

  /// Sends rays from several faces, which should be near each other: all rays of some sets of
  /// directions, or as many as a face needs. `counts(slot)` is the one of a face; no other thread
  /// has it at the same time.
  template <class CountsOf>
  void look(std::span<const Index> slots, const Sets& sets, CountsOf counts) const {
    std::vector<Look> looks;
    for (const Index slot : slots)
      looks.push_back({slot, sets.first + sets.count * units(slot), normal(slot),
                       tree_.corners(slot), &counts(slot)});
    for (std::size_t round = sets.first; !looks.empty(); ++round) {
      const std::size_t size = directions_.size() / sets.share;
      for (std::size_t begin = 0; begin < size; begin += batch) {
        std::erase_if(looks, [&](const Look& look) { return is_enough(*look.counts); });
        const std::size_t end = (std::min)(begin + batch, size);
        for (std::size_t i = begin; i < end; ++i)
          send_along(i, round, looks);
      }
      std::erase_if(looks, [&](const Look& look) { return look.end == round + 1; });
    }
  }

  /// Has a face certainly more free rays than are enough?
  bool is_enough(const RayCounts& counts) const {
    return plan_.enough < 1 &&
           counts.most_free() >= certain + 2 * plan_.enough * static_cast<double>(counts.all());
  }

  /// Returns the normal of a face, of twice the length of its area.
  Vector<3> normal(std::size_t slot) const {
    const auto [a, b, c] = tree_.corners(slot);
    return cross(b - a, c - a);
  }

  /// Returns how many units of area a face has, at least one.
  std::size_t units(std::size_t slot) const {
    return static_cast<std::size_t>(
        std::clamp(std::round(areas_[slot] / unit_area_), 1.0, most_units));
  }
  double unit_area() const { return 0.5 * unit_area_; } // areas_ are doubled
  /// Does only its front count?
  bool is_covered(std::size_t slot) const { return is_covered_[slot]; }

  /// Returns the i-th point of an evenly spread sequence over a triangle. Source: Roberts, The
  /// unreasonable effectiveness of quasirandom sequences, 2018.
  static Vector<3> point(const std::array<Vector<3>, 3>& corners, std::size_t i) {
    constexpr double x_step = 0.7548776662466927, y_step = 0.5698402909980532;
    const auto fraction = [&](double step) {
      const double x = 0.5 + static_cast<double>(i) * step;
      return x - std::floor(x);
    };
    double s = fraction(x_step), t = fraction(y_step);
    if (s + t > 1)
      s = 1 - s, t = 1 - t;
    return (1 - s - t) * corners[0] + s * corners[1] + t * corners[2];
  }

private:
  static constexpr std::size_t batch = 16;
  static constexpr std::size_t kinds = 16;    // faces of different kinds take different sets
  static constexpr std::uint32_t certain = 4; // free rays
  // Surfaces of few faces get as many rays in all as those of more.
  static constexpr double fewest_units = 1 << 12, most_units = 1 << 10;

  /// A face that is being looked at.
  struct Look {
    Index slot;
    std::size_t end; // the last set of directions, plus one
    Vector<3> normal;
    std::array<Vector<3>, 3> corners;
    RayCounts* counts;
  };

  // Sends the rays with the same number in all sets. Those of a set are parallel, and near each
  // other, so that they meet the same faces: this takes half the time of one face after another.
  void send_along(std::size_t i, std::size_t round, std::vector<Look>& looks) const {
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const Vector<3>& direction = directions_(kinds * round + kind, i);
      Index recent = none;
      for (const Look& look : looks)
        if (look.slot / EightBoxes::width % kinds == kind)
          send(look, direction, round * directions_.size() + i, recent);
    }
  }

  void send(const Look& look, const Vector<3>& direction, std::size_t number, Index& recent) const {
    RayCounts& counts = *look.counts;
    const std::size_t side = dot(direction, look.normal) < 0 ? 1 : 0;
    if (side == 1 && is_covered_[look.slot])
      return;
    ++counts.rays[side];
    const auto is_own = [&](std::size_t slot) { return slot == look.slot; };
    const Ray ray(point(look.corners, look.slot + number), direction);
    counts.free[side] += tree_.is_blocked(ray, is_own, recent) ? 0 : 1;
  }

  // Finds faces that have a reverse: the same corners in the other order.
  void find_covered() {
    struct Face {
      RayTree::Triangle corners; // ascending
      bool is_odd;               // is their order in the face another one?
      Index slot;
    };
    std::vector<Face> faces;
    for (Index slot = 0; slot < tree_.size(); ++slot) {
      const auto [a, b, c] = tree_.triangle(slot);
      Face face{{a, b, c}, ((a < b) != (b < c)) != (c < a), slot};
      std::sort(face.corners.begin(), face.corners.end());
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
      return std::tie(a.corners, a.is_odd, a.slot) < std::tie(b.corners, b.is_odd, b.slot);
    });
    for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
      while (end < faces.size() && faces[end].corners == faces[begin].corners)
        ++end;
      if (faces[begin].is_odd != faces[end - 1].is_odd)
        for (std::size_t i = begin; i < end; ++i)
          is_covered_[faces[i].slot] = true;
    }
  }

  const RayTree& tree_;
  RayDirections directions_;
  RayPlan plan_;
  std::vector<double> areas_;
  std::vector<bool> is_covered_; // do only their fronts count?
  double unit_area_ = 1;
};

/// Work on many faces, on some threads, with the word of a caller who may end it.
class FaceWork {
public:
  FaceWork(Threads threads, const std::function<bool(double)>& progress)
      : threads_(threads), progress_(progress) {}

  /// Calls work(some) for all parts of a list. Reports the progress from `begin` to `end`. Returns
  /// false if the caller has ended it.
  template <class Work>
  bool operator()(std::span<const Index> slots, double begin, double end, const Work& work) {
    bool goes_on = report(begin);
    with_threads(threads_, [&] {
      const std::size_t blocks = (slots.size() + block - 1) / block,
                        stride = blocks_at_once * threads_;
      for (std::size_t first = 0; first < blocks && goes_on; first += stride) {
        const std::size_t last = (std::min)(first + stride, blocks);
        parallel_for(threads_, last - first, [&](std::size_t b, std::size_t) {
          const std::size_t from = (first + b) * block;
          work(slots.subspan(from, (std::min)(block, slots.size() - from)));
        });
        const double done = static_cast<double>(last) / static_cast<double>(blocks);
        goes_on = report(begin + done * (end - begin));
      }
    });
    return goes_on;
  }

private:
  static constexpr std::size_t block = 1024;       // faces
  static constexpr std::size_t blocks_at_once = 8; // for each thread

  bool report(double fraction) const { return !progress_ || progress_(fraction); }

  Threads threads_;
  const std::function<bool(double)>& progress_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_FACE_RAYS_H
