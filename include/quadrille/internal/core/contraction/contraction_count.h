#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_CONTRACTION_COUNT_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_CONTRACTION_COUNT_H

#include <quadrille/concepts.h>
#include <quadrille/internal/core/complex/reverse_faces.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// Determines how many contractions a pass may do without asking the stop policy, and what each
/// counts as. With free topology, duplicate faces are removed too, and all faces at an edge, and
/// vertices that are isolated then: such a contraction counts as several. If faces have reverses,
/// these are removed with them.
class ContractionCount {
public:
  /// `reverse faces`: of the surface; it stays where it is.
  ContractionCount(bool is_topology_kept, const ReverseFaces& reverse_faces)
      : is_topology_kept_(is_topology_kept), reverse_faces_(reverse_faces) {}

  /// As many as `stop`, asked before each, would let pass in a row from `now` on.
  template <StopPolicy Stop>
  std::size_t contractions(const Stop& stop, const Status& now) const {
    const auto status_after = [&](std::size_t contractions) {
      Status after = now;
      after.faces -= (std::min)(after.faces, faces_each() * contractions);
      after.vertices -= contractions;
      after.edges -= (std::min)(after.edges, edges_each * contractions);
      after.contractions += contractions;
      after.next_error = after.next_cost = 0;
      return after;
    };
    std::size_t allowed = 0; // the first `allowed` are, `rejected` are not
    std::size_t rejected = now.vertices + 1;
    while (rejected - allowed > 1) {
      const std::size_t middle = allowed + (rejected - allowed) / 2;
      (stop(status_after(middle - 1)) ? rejected : allowed) = middle;
    }
    return allowed;
  }

  /// Returns how much of the target the removed faces, vertices and edges of a contraction count
  /// for.
  std::size_t used(std::size_t faces, std::size_t vertices, std::size_t edges) const {
    return (std::max)({vertices, (faces + faces_each() - 1) / faces_each(),
                       (edges + edges_each - 1) / edges_each});
  }

  /// May contracting the star take faces and vertices that count more than that?
  bool may_take_more(const PairStar& star, std::size_t quota) const {
    return !(is_topology_kept_ && star.shared.size() < quota) && most_used(star) > quota;
  }

private:
  std::size_t most_used(const PairStar& star) const {
    const auto [faces, vertices] = is_topology_kept_
                                       ? Loss{reverse_faces_.count_all(star.shared), 1}
                                       : most_loss(star, reverse_faces_);
    return used(faces, vertices, 0);
  }
  std::size_t faces_each() const {
    return (is_topology_kept_ ? 2 : 4) * (reverse_faces_.is_empty() ? std::size_t{1} : 2);
  }

  static constexpr std::size_t edges_each = 3;

  bool is_topology_kept_;
  const ReverseFaces& reverse_faces_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_CONTRACTION_COUNT_H
