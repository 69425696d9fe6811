#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_BOUNDARY_STRIPS_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_BOUNDARY_STRIPS_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/guards/distance/face_of_star.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// How far a point of a new face may be from the input, and from the faces before the contraction.
struct FaceDeviation {
  double from_input = 0, from_star = 0;

  void raise_to(const FaceDeviation& other) {
    from_input = (std::max)(from_input, other.from_input);
    from_star = (std::max)(from_star, other.from_star);
  }
};

/// The boundary of some faces around the pair ab, without the link: its edges at a or b, called
/// spokes. A contraction to x turns each spoke va or vb into an edge vx.
///
/// The area that the new faces cover beyond the old ones lies in strips between the new spokes and
/// the old boundary: each point of the boundary is matched with one of the new spoke, in the same
/// order from v on, and at the end the point of the boundary that is nearest to x with x. A strip
/// is compared with the boundary edge along which it lies, so a displacement along a straight
/// boundary costs nothing.
///
/// With orientation, as sums of signed areas in any plane: new faces = old faces + strips. So if no
/// new face is turned over, a point of one lies in an old face or in a strip that is not turned
/// over; and if no old face is, a point of one lies in a new face or in a strip that is.
class BoundaryStrips {
public:
  /// The origin of a strip: new faces that extend beyond the old boundary, or old ones that extend
  /// beyond the new one.
  enum class Side { of_new, of_old };

  struct Strip {
    FlatTriangle triangle; // to the left
    Vector<3> from, to;    // the edge of the boundary that is there on the other side
    double bound;          // of the faces at the boundary
    Index neighbour;       // of the pair, at which the new edge ends
  };

  void clear() {
    spokes_.clear();
    turns_between_ = 0;
    faces_between_ = 0;
    bound_ = 0;
  }

  /// The edges of a face at the ends, of which b is the second.
  void add(const FaceOfStar& f, Index b) {
    const auto& [end, second, third] = f.corners;
    if (!f.is_shared) {
      add_spoke(f.third, f.end, 1, third, f.bound);
      add_spoke(f.second, f.end, -1, second, f.bound);
    } else if (f.second == b) {
      add_between(1, f.bound);
      add_spoke(f.third, 0, 1, third, f.bound);
      add_spoke(f.third, 1, -1, third, f.bound);
    } else {
      add_between(-1, f.bound);
      add_spoke(f.second, 0, -1, second, f.bound);
      add_spoke(f.second, 1, 1, second, f.bound);
    }
  }

  /// Makes one of the spokes along the same edge, once all have been added.
  void sum_up() {
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& s, const Spoke& t) {
      return std::pair(s.neighbour, s.end) < std::pair(t.neighbour, t.end);
    });
    std::size_t count = 0;
    for (const Spoke& s : spokes_)
      if (count > 0 && s.neighbour == spokes_[count - 1].neighbour &&
          s.end == spokes_[count - 1].end)
        spokes_[count - 1].add(s);
      else
        spokes_[count++] = s;
    spokes_.erase(spokes_.begin() + static_cast<std::ptrdiff_t>(count), spokes_.end());
  }

  /// Keeps the edges of just one face, at ends that satisfy is_seen(end).
  template <class IsSeen>
  void keep_open_ones(IsSeen is_seen) {
    std::erase_if(spokes_, [&](const Spoke& s) { return s.faces != 1 || !is_seen(s.end); });
    if (faces_between_ != 1)
      turns_between_ = 0;
  }

  bool has(Index neighbour) const {
    return std::any_of(spokes_.begin(), spokes_.end(),
                       [&](const Spoke& s) { return s.neighbour == neighbour; });
  }

  /// Returns an upper limit of how far a contraction to x moves the points of the boundary.
  FaceDeviation deviation(const std::array<Vector<3>, 2>& ends, const Vector<3>& x) const {
    FaceDeviation deviation;
    for_each_path(ends, x, [&](const Path& path) {
      double t = 0, most = squared_distance(path.points[path.size - 1], x);
      for (std::size_t i = 1; i + 1 < path.size; ++i) {
        t = (std::max)(t, nearest_on_segment(path.points[i], path.points[0], x));
        most = (std::max)(most, squared_distance(path.points[i], between(path.points[0], x, t)));
      }
      deviation.from_star = (std::max)(deviation.from_star, std::sqrt(most));
      deviation.from_input = (std::max)(deviation.from_input, path.bound + std::sqrt(most));
    });
    return deviation;
  }

  /// The strips of a contraction of the two ends to x, but for those that are narrower than this:
  /// they are roundings of none.
  template <Side side = Side::of_new, class Flatten>
  const std::vector<Strip>& strips(const std::array<Vector<3>, 2>& ends, const FlatPoint& x,
                                   double narrowest, Flatten flatten) {
    strips_.clear();
    narrowest_ = narrowest;
    std::erase_if(spokes_, [](const Spoke& s) { return s.turn == 0; });
    for_each_path(ends, x.point, [&](const Path& path) { add_strip<side>(path, x, flatten); });
    return strips_;
  }

private:
  struct Spoke {
    Vector<3> position;
    double bound;
    Index neighbour;
    std::size_t end;
    int turn;
    std::size_t faces;

    void add(const Spoke& other) {
      turn += other.turn;
      faces += other.faces;
      bound = (std::max)(bound, other.bound);
    }
  };
  // The boundary point that is nearest to x.
  struct Nearest {
    Vector<3> point;
    const Spoke* spoke; // null on the edge ab
  };
  // The path along the boundary from the start of a spoke to the point that is nearest to x.
  struct Path {
    std::array<Vector<3>, 4> points;
    std::size_t size;
    bool is_left; // of the new spoke
    double bound; // of all faces at the boundary
    Index neighbour;
  };

  // Adds the edge of a face from a neighbour to an end of the pair (turn 1), or the other way (−1).
  // Edges of two faces in opposite directions are no boundary.
  void add_spoke(Index neighbour, std::size_t end, int turn, const Vector<3>& position,
                 double bound) {
    spokes_.push_back({position, bound, neighbour, end, turn, 1});
  }

  // Adds the strip of an edge from a to b (turn 1) or in reverse.
  void add_between(int turn, double bound) {
    turns_between_ += turn;
    ++faces_between_;
    bound_ = (std::max)(bound_, bound);
  }

  template <class Visit>
  void for_each_path(const std::array<Vector<3>, 2>& ends, const Vector<3>& x, Visit visit) const {
    if (turns_between_ != 0) {
      for_each_path(ends, {true, true}, x, visit);
    } else {
      for_each_path(ends, {true, false}, x, visit);
      for_each_path(ends, {false, true}, x, visit);
    }
  }

  // Visits the boundary edges at one end, or at both if the edge ab is one of them.
  template <class Visit>
  void for_each_path(const std::array<Vector<3>, 2>& ends, const std::array<bool, 2>& are_seen,
                     const Vector<3>& x, Visit visit) const {
    const auto is_seen = [&](const Spoke& s) { return are_seen[s.end]; };
    if (std::none_of(spokes_.begin(), spokes_.end(), is_seen))
      return;
    const Nearest nearest = nearest_to(x, ends, are_seen);
    double bound = are_seen[0] && are_seen[1] ? bound_ : 0;
    for (const Spoke& s : spokes_)
      if (is_seen(s))
        bound = (std::max)(bound, s.bound);
    for (const Spoke& s : spokes_) {
      if (!is_seen(s))
        continue;
      Path path{{s.position}, 1, s.turn > 0, bound, s.neighbour};
      if (&s != nearest.spoke) {
        path.points[path.size++] = ends[s.end];
        if (nearest.spoke && nearest.spoke->end != s.end)
          path.points[path.size++] = ends[nearest.spoke->end];
      }
      path.points[path.size++] = nearest.point;
      visit(path);
    }
  }

  Nearest nearest_to(const Vector<3>& x, const std::array<Vector<3>, 2>& ends,
                     const std::array<bool, 2>& are_seen) const {
    Nearest nearest{ends[are_seen[0] ? 0 : 1], nullptr};
    double least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const Vector<3>& p, const Vector<3>& q, const Spoke* spoke) {
      const Vector<3> y = between(p, q, nearest_on_segment(x, p, q));
      const double squared = squared_distance(x, y);
      if (squared < least) {
        least = squared;
        nearest = {y, spoke};
      }
    };
    if (are_seen[0] && are_seen[1])
      look_at(ends[0], ends[1], nullptr);
    for (const Spoke& s : spokes_)
      if (are_seen[s.end])
        look_at(s.position, ends[s.end], &s);
    return nearest;
  }

  // Adds the strip between the path along the boundary and the new spoke.
  template <Side side, class Flatten>
  void add_strip(const Path& path, const FlatPoint& x, Flatten flatten) {
    const FlatPoint begin = flatten(path.points[0]);
    FlatPoint old = begin, match = begin;
    double t = 0;
    for (std::size_t i = 1; i < path.size; ++i) {
      const FlatPoint next = flatten(path.points[i]);
      t = (std::max)(t, nearest_on_segment(next.point, begin.point, x.point));
      const FlatPoint next_match = i + 1 == path.size ? x
                                                      : FlatPoint{between(begin.point, x.point, t),
                                                                  begin.u + t * (x.u - begin.u),
                                                                  begin.v + t * (x.v - begin.v)};
      const auto& [from, to] = side == Side::of_new ? std::array{old.point, next.point}
                                                    : std::array{begin.point, x.point};
      add_triangle<side>({old, match, next_match}, path, from, to);
      add_triangle<side>({old, next_match, next}, path, from, to);
      old = next;
      match = next_match;
    }
  }

  template <Side side>
  void add_triangle(FlatTriangle t, const Path& path, const Vector<3>& from, const Vector<3>& to) {
    if (path.is_left == (side == Side::of_old))
      std::swap(t[1], t[2]);
    const double area = flat_area(t);
    const double length = squared_flat_length(t[0], t[2]) + squared_flat_length(t[0], t[1]);
    if (area > 0 && area * area > narrowest_ * narrowest_ * length)
      strips_.push_back({t, from, to, path.bound, path.neighbour});
  }

  static double squared_flat_length(const FlatPoint& p, const FlatPoint& q) {
    return (q.u - p.u) * (q.u - p.u) + (q.v - p.v) * (q.v - p.v);
  }

  std::vector<Spoke> spokes_;
  int turns_between_ = 0;         // of the edge ab
  std::size_t faces_between_ = 0; // at it
  double bound_ = 0;              // of these
  std::vector<Strip> strips_;
  double narrowest_ = 0; // of them
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_BOUNDARY_STRIPS_H
