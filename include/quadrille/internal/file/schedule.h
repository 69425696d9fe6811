#ifndef QUADRILLE_INTERNAL_FILE_SCHEDULE_H
#define QUADRILLE_INTERNAL_FILE_SCHEDULE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// The number of faces that each phase aims at, and the fraction at which its chunks are cut.
///
/// Vertices that chunks share stay for a phase. A chunk of V vertices that keeps a fraction r of
/// them has about 2 / (r √V) shared vertices among the remaining ones, since a compact patch has 4
/// √V around it; so no phase keeps less than 40 / √V, and 5 % of the vertices are shared then. The
/// schedule ends with four times and two times the target, then the whole surface; it omits four
/// times the target if that would be more than a fifth of the input and chunks are large enough. If
/// the whole does not fit into memory, it aims a little above the target, because samples do not
/// determine the limit exactly, and all chunks share the few faces that are too many then.
class Schedule {
public:
  Schedule(std::uint64_t faces, std::uint64_t target, std::uint64_t chunk_vertices) {
    const double n = static_cast<double>(std::max<std::uint64_t>(target, 1));
    const double least_fraction = (std::min)(
        0.25, 40 / std::sqrt(static_cast<double>(std::max<std::uint64_t>(chunk_vertices, 1))));
    double count = static_cast<double>(faces);
    while (count * least_fraction > 4 * n)
      add(count *= least_fraction);
    const bool is_much = 4 * n > most_left * static_cast<double>(faces);
    if (count > 5.6 * n && !(is_much && 2 * n >= 0.9 * least_fraction * count))
      add(count = 4 * n);
    if (count > 2.8 * n)
      add(2 * n);
  }

  /// The number of phases before the target itself.
  std::size_t size() const { return wanted_.size(); }
  /// Returns the aim of phase `step`, from 0 on; from size() on it is the target.
  std::uint64_t wanted(std::size_t step, std::uint64_t target) const {
    return step < wanted_.size() ? wanted_[step] : target + target / 25;
  }
  /// If the whole does not fit into memory: is it close enough after phase `step`, which began with
  /// `before` faces and left `after`? The phase is repeated up to four times, as long as each
  /// removes more than two in a hundred faces.
  bool is_enough(std::size_t step, std::uint64_t before, std::uint64_t after,
                 std::uint64_t target) const {
    if (step < wanted_.size())
      return false;
    const std::size_t times = step - wanted_.size() + 1;
    return after <= target + target / 12 || times >= 4 || (times >= 2 && is_still(before, after));
  }
  /// If distances are limited: does the limit stop the simplification, so that a phase has left
  /// many more faces than it aimed at?
  static bool is_met(std::uint64_t after, std::uint64_t wanted) {
    return after > wanted + wanted / 4;
  }
  /// Has a phase removed almost nothing?
  static bool is_still(std::uint64_t before, std::uint64_t after) {
    return after > before - before / 50;
  }
  /// Are there some faces too many, but so few that a count would not destroy chunks that cannot
  /// give their share?
  static bool can_share(std::uint64_t faces, std::uint64_t target) {
    return faces > target && faces <= target + target / 4;
  }
  /// Returns how many of the excess faces a chunk contributes that has the faces from `begin` to
  /// `end` of all: a proportional share, and an even number, since inside a surface a contraction
  /// takes two; the last chunk gives an odd rest.
  static std::uint64_t share(std::uint64_t too_many, std::uint64_t begin, std::uint64_t end,
                             std::uint64_t all) {
    const auto given_before = [&](std::uint64_t faces) {
      const double fraction = static_cast<double>(faces) / static_cast<double>(all);
      return faces == all
                 ? too_many
                 : static_cast<std::uint64_t>(fraction * static_cast<double>(too_many)) / 2 * 2;
    };
    return given_before(end) - given_before(begin);
  }

  /// The fraction at which the chunks of phase k, from 1 on, are cut.
  static double fraction(unsigned k) {
    constexpr std::array fractions{0.5, 0.36, 0.62, 0.44, 0.56, 0.4};
    return fractions[(k - 1) % fractions.size()];
  }

private:
  void add(double count) { wanted_.push_back(static_cast<std::uint64_t>(count)); }

  // A fraction of the input. Four times the target would be on the disk twice when chunks are made
  // again.
  static constexpr double most_left = 0.2;

  std::vector<std::uint64_t> wanted_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SCHEDULE_H
