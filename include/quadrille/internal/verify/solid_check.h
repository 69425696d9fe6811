#ifndef QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H
#define QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/matched_components.h>
#include <quadrille/internal/verify/solid_components.h>
#include <quadrille/internal/verify/umbrellas_of_solid.h>
#include <quadrille/verdict.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Compares a result, component by component, with the solid that it was made from. Neither has to
/// bound a volume: the result has to be what the input is.
class SolidCheck {
public:
  SolidCheck(const SurfaceView& input, const SurfaceView& result, CheckProgress& progress)
      : unit_(unit_of(input, result)), input_(scaled(input)), result_(scaled(result)),
        progress_(progress) {}

  /// Returns a finding for each property that a solid keeps. Throws std::invalid_argument for an
  /// input with open edges.
  std::vector<Finding> look() {
    UmbrellasOfSolid before(input_), after(result_);
    if (before.open_edges() > 0)
      throw std::invalid_argument(
          "quadrille::verify: the input is not closed, so no result can be the same solid: "
          "number of edges with different numbers of faces on both sides: " +
          std::to_string(before.open_edges()));
    add("open edges", 0, after.open_edges(), result_.points[after.open_at()]);
    look_at_doubled_faces();
    if (after.open_edges() == 0) {
      before_ = solid_components(input_, before, progress_);
      after_ = solid_components(result_, after, progress_);
      compare();
    }
    return std::move(findings_);
  }

private:
  using Place = std::optional<Vector<3>>;

  /// Lengths are divided by this power of two, so that no product of them overflows or underflows.
  static int unit_of(const SurfaceView& a, const SurfaceView& b) {
    double greatest = 0;
    for (const SurfaceView* surface : {&a, &b})
      for (const Vector<3>& p : surface->points)
        greatest = (std::max)({greatest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    return greatest > 0 ? std::ilogb(greatest) : 0;
  }
  TriangleSoup<> scaled(const SurfaceView& surface) const {
    TriangleSoup<> copy{{}, {surface.triangles.begin(), surface.triangles.end()}};
    copy.points.reserve(surface.points.size());
    for (const Vector<3>& p : surface.points)
      copy.points.push_back(
          {{std::ldexp(p[0], -unit_), std::ldexp(p[1], -unit_), std::ldexp(p[2], -unit_)}});
    return copy;
  }

  void look_at_doubled_faces() {
    std::size_t at = 0, face = 0;
    const std::size_t before = count_doubled_faces(input_, at);
    const std::size_t after = count_doubled_faces(result_, face);
    add("duplicate faces", before, after, result_.points[result_.triangles[face][0]],
        after <= before);
  }

  void compare() {
    const std::vector<std::size_t> matches = MatchedComponents(before_, after_).match();
    const bool are_as_many = before_.size() == after_.size();
    add("components", before_.size(), after_.size(), are_as_many ? Place() : place_of_odd(matches));
    add_components("components with a different number of handles", matches, [&](auto i, auto j) {
      return before_[i].euler_number == after_[j].euler_number;
    });
    add_components("components turned inside out, or without volume", matches, [&](auto i, auto j) {
      return before_[i].shape.orientation() == after_[j].shape.orientation();
    });
    add_components("components inside other components than before", matches, [&](auto i, auto j) {
      std::vector<std::size_t> around;
      for (const std::size_t other : before_[i].around)
        if (matches[other] != MatchedComponents::none)
          around.push_back(matches[other]);
      std::sort(around.begin(), around.end());
      return around == known(after_[j].around, matches);
    });
  }

  /// Returns the components that a component before has become.
  static std::vector<std::size_t> known(std::vector<std::size_t> components,
                                        const std::vector<std::size_t>& matches) {
    std::erase_if(components, [&](std::size_t component) {
      return std::find(matches.begin(), matches.end(), component) == matches.end();
    });
    return components;
  }

  /// Returns the place of a component that is new or gone.
  Place place_of_odd(const std::vector<std::size_t>& matches) const {
    for (std::size_t i = 0; i < matches.size(); ++i)
      if (matches[i] == MatchedComponents::none)
        return before_[i].shape.place();
    for (std::size_t j = 0; j < after_.size(); ++j)
      if (std::find(matches.begin(), matches.end(), j) == matches.end())
        return after_[j].shape.place();
    return std::nullopt;
  }

  template <class AreAlike>
  void add_components(const char* claim, const std::vector<std::size_t>& matches,
                      AreAlike are_alike) {
    std::size_t count = 0;
    Place place;
    for (std::size_t i = 0; i < matches.size(); ++i)
      if (matches[i] != MatchedComponents::none && !are_alike(i, matches[i]) && count++ == 0)
        place = after_[matches[i]].shape.place();
    add(claim, 0, count, place);
  }

  void add(const char* claim, std::size_t promised, std::size_t measured, const Place& place) {
    add(claim, promised, measured, place, measured == promised);
  }
  void add(const char* claim, std::size_t promised, std::size_t measured, const Place& place,
           bool is_met) {
    Finding finding{claim, static_cast<double>(promised), static_cast<double>(measured), 0, is_met};
    if (place && !is_met)
      finding.place = std::ldexp(1.0, unit_) * *place;
    findings_.push_back(std::move(finding));
  }

  int unit_;
  TriangleSoup<> input_, result_;
  CheckProgress& progress_;
  std::vector<SolidComponent> before_, after_;
  std::vector<Finding> findings_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_SOLID_CHECK_H
