#ifndef QUADRILLE_INTERNAL_FILE_CHUNKED_DISTANCE_H
#define QUADRILLE_INTERNAL_FILE_CHUNKED_DISTANCE_H

#include <quadrille/internal/file/chunked_surface.h>
#include <quadrille/internal/verify/allowed_faces.h>
#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/greatest_excess.h>
#include <quadrille/quadric_form.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Measures the greatest distance between two out-of-core surfaces, in both directions, beyond the
/// tolerances of the input, as CheckedDistance does for surfaces in memory. A chunk is measured
/// against the faces of the other surface within a margin of it: if no point is further away than
/// the margin, no other face would be nearer. If faces allow a distance, this holds for an excess
/// up to the margin minus the greatest allowed distance.
class ChunkedDistance {
public:
  /// Both surfaces are in the frame. `expected` is about the distance that they may have, in the
  /// unit of the files: it affects only the speed. At most `most` faces are measured against at a
  /// time, if possible.
  ChunkedDistance(const ChunkedSurface& input, const ChunkedSurface& result,
                  const DistanceFrame& frame, double diagonal, double expected, std::size_t most,
                  CheckProgress& progress)
      : input_(input), result_(result), frame_(frame), diagonal_(diagonal),
        expected_(frame.to(expected)), most_(most), progress_(progress) {}

  double diagonal_of_both() const { return diagonal_; }
  double least_tolerance() const { return frame_.from(input_.least_allowance()); }

  struct Measured {
    double distance;
    Vector<3> place; ///< the point at which it was found
  };
  /// Returns the greatest distance of a point of the input to the result; beyond the tolerance of
  /// its face, if that has one. The value is at most the true one and less than it by at most
  /// `error`.
  Measured of_input(double error) const { return Search(*this, result_, error).look_at(input_); }
  /// Returns the greatest distance of a point of the result to the input, likewise.
  Measured of_result(double error) const { return Search(*this, input_, error).look_at(result_); }

private:
  using Faces = std::vector<AllowedFaces::Face>;

  class Search {
  public:
    Search(const ChunkedDistance& distance, const ChunkedSurface& to, double error)
        : distance_(distance), to_(to), error_((std::max)(distance.frame_.to(error), 0x1p-40)),
          margin_(1.1 * (std::max)(distance.expected_, error_)),
          slack_(distance.input_.greatest_allowance() > 0 ? error_ / 2 : 0) {}

    Measured look_at(const ChunkedSurface& from) {
      for (std::size_t p = 0; p < from.size(); ++p) {
        distance_.progress_.at(static_cast<double>(p) / static_cast<double>(from.size()));
        look_at(from.faces(p), margin_);
      }
      const DistancePoint place = distance_.frame_.from(place_);
      return {distance_.frame_.from(greatest_), {{place.x(), place.y(), place.z()}}};
    }

  private:
    void look_at(Faces faces, double margin) {
      CGAL::Bbox_3 box;
      for (const AllowedFaces::Face& face : faces)
        box += face.triangle.bbox();
      while (!faces.empty() && !measure(faces, box, margin)) {
        if (is_split_) {
          auto [lower, upper] = halves(faces, box);
          faces = {};
          if (!lower.empty())
            look_at(std::move(lower), margin);
          if (!upper.empty())
            look_at(std::move(upper), margin);
          return;
        }
        margin *= 4;
      }
    }

    // Returns false if a point is further away than the margin, or if there are too many faces
    // within it. With tolerances, a tiny excess is ignored if the result may be less by that much;
    // otherwise all that the tolerances allow would have to be within the margin.
    bool measure(const Faces& faces, const CGAL::Bbox_3& box, double margin) {
      const bool can_be_split = longest(box) > margin;
      std::optional<Faces> near = to_.near(grown(box, margin), distance_.most_);
      is_split_ = !near && can_be_split;
      if (is_split_)
        return false;
      if (!near)
        near = to_.near(grown(box, margin), (std::numeric_limits<std::size_t>::max)());
      if (near->empty())
        return false;
      const double certain = margin - to_.greatest_allowance() - greatest_allowance(faces);
      const double most = (std::max)(certain, greatest_ + slack_);
      const AllowedFaces tree(std::move(*near), distance_.progress_);
      GreatestExcess excess(tree, error_ - slack_, distance_.progress_, greatest_);
      for (const AllowedFaces::Face& face : faces)
        excess.look_at_corners(face.triangle, face.allowance);
      for (std::size_t i = 0; i < faces.size() && excess.greatest() <= most; ++i)
        excess.look_at(faces[i].triangle, faces[i].allowance);
      if (excess.greatest() > greatest_ && excess.greatest() <= certain) {
        greatest_ = excess.greatest();
        place_ = excess.place();
      }
      return excess.greatest() <= most;
    }

    static double greatest_allowance(const Faces& faces) {
      double greatest = 0;
      for (const AllowedFaces::Face& face : faces)
        greatest = (std::max)(greatest, face.allowance);
      return greatest;
    }

    static double longest(const CGAL::Bbox_3& box) {
      double length = 0;
      for (int i = 0; i < 3; ++i)
        length = (std::max)(length, (box.max)(i) - (box.min)(i));
      return length;
    }

    // Separates the faces on one side of the middle from those on the other. A face that is longer
    // than half of the box is itself halved, so that boxes become smaller in any case.
    static std::pair<Faces, Faces> halves(const Faces& faces, const CGAL::Bbox_3& box) {
      int axis = 0;
      for (int i = 1; i < 3; ++i)
        if ((box.max)(i) - (box.min)(i) > (box.max)(axis) - (box.min)(axis))
          axis = i;
      const double middle = 0.5 * ((box.min)(axis) + (box.max)(axis));
      std::pair<Faces, Faces> result;
      const auto give = [&](const DistanceTriangle& t, double allowance) {
        const double center = (t[0][axis] + t[1][axis] + t[2][axis]) / 3;
        (center < middle ? result.first : result.second).push_back({t, allowance});
      };
      for (const auto& [t, allowance] : faces)
        if (longest(t.bbox()) > longest(box) / 2)
          for (const DistanceTriangle& half : halves(t))
            give(half, allowance);
        else
          give(t, allowance);
      return result;
    }

    // Halves a triangle across its longest side.
    static std::array<DistanceTriangle, 2> halves(const DistanceTriangle& t) {
      int side = 0;
      const auto length = [&](int i) { return CGAL::squared_distance(t[i], t[(i + 1) % 3]); };
      for (int i = 1; i < 3; ++i)
        if (length(i) > length(side))
          side = i;
      const DistancePoint middle = CGAL::midpoint(t[side], t[(side + 1) % 3]);
      const DistancePoint& opposite = t[(side + 2) % 3];
      return {DistanceTriangle(t[side], middle, opposite),
              DistanceTriangle(middle, t[(side + 1) % 3], opposite)};
    }

    const ChunkedDistance& distance_;
    const ChunkedSurface& to_;
    double error_, margin_, slack_, greatest_ = 0;
    DistancePoint place_{0, 0, 0};
    bool is_split_ = false;
  };

  const ChunkedSurface &input_, &result_;
  DistanceFrame frame_;
  double diagonal_, expected_;
  std::size_t most_;
  CheckProgress& progress_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNKED_DISTANCE_H
