#ifndef QUADRILLE_INTERNAL_CORE_ORDER_COST_REFRESH_H
#define QUADRILLE_INTERNAL_CORE_ORDER_COST_REFRESH_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/order/versioned_queue.h>
#include <quadrille/internal/core/order/waiting_pairs.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/order.h>

#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

namespace quadrille::internal {

/// The vertices around which the surface has become flatter than when their pairs were last costed:
/// these have become cheaper than the queue knows. They are gathered until there are enough to cost
/// their pairs together, which spares most of the waiting for memory.
class FlattenedVertices {
public:
  static constexpr std::size_t many = 64;

  /// A vertex is one of them when its unevenness has fallen by more than a factor `fall`.
  FlattenedVertices(std::size_t vertices, float fall, Arena* arena = nullptr)
      : unevenness_(vertices, 0, arena), fall_(fall) {
    found_.reserve(2 * many);
  }

  /// The pairs of a vertex cost now what the queue says.
  void note(Index v, double unevenness) { unevenness_[v] = static_cast<float>(unevenness); }
  /// The faces around a vertex may have changed.
  void look_at(Index v, double unevenness) {
    if (!(unevenness < static_cast<double>(fall_ * unevenness_[v])))
      return;
    unevenness_[v] = found;
    found_.push_back(v);
  }

  bool are_many() const { return found_.size() >= many; }
  /// Calls visit(v) for each of them that has not been noted since, and forgets them all.
  template <class Visit>
  void take(Visit visit) {
    for (Index v : found_)
      if (unevenness_[v] == found)
        visit(v);
    found_.clear();
  }

private:
  static constexpr float found = -std::numeric_limits<float>::infinity(); // nothing is below it

  Array<float> unevenness_; // of each vertex, when its pairs were last costed
  std::vector<Index> found_;
  float fall_;
};

/// Selects the pairs that are costed again because a contraction next to them has changed their
/// costs, for a cost that looks at the current surface: the pairs of flattened vertices.
template <class Policies>
class CostRefresh {
public:
  using Cost = typename Policies::Cost;

  CostRefresh(WorkingSurface<Policies>& surface, PairVersions& versions)
      : surface_(surface), versions_(versions),
        flattened_(looks_for_flattened ? versions.size() : 0, tolerated_fall<Cost>,
                   surface.complex().arena()) {
    for (Index v = 0; v < versions.size(); ++v)
      note(v);
  }

  /// The pairs of a vertex have just been costed.
  void note(Index v) {
    if constexpr (looks_for_flattened)
      flattened_.note(v, surface_.evaluator().terms().unevenness(v));
  }
  /// The faces around a vertex have changed.
  void look_at(Index v) {
    if constexpr (looks_for_flattened)
      flattened_.look_at(v, surface_.evaluator().terms().unevenness(v));
  }

  /// Once enough vertices are flattened, calls push(v, w, key) for their pairs, each once.
  template <class Push>
  void run(Push push) {
    if constexpr (looks_for_flattened)
      if (flattened_.are_many())
        push_flattened(push);
  }

private:
  static constexpr bool looks_for_flattened = measures_unevenness<Cost>;

  template <class Push>
  QUADRILLE_NOINLINE void push_flattened(Push push) {
    ring_.clear();
    versions_.advance(); // so that what was pushed before is outdated
    flattened_.take([this](Index v) {
      if (versions_.is_retired(v) || !surface_.complex().has_faces(v))
        return;
      note(v);
      if (surface_.complex().degree_bound(v) > WaitingPairs::few_faces)
        return;
      versions_.renew(v);
      ring_.push_back(v);
    });
    surface_.pairs().for_each_of(
        surface_.scratch(), ring_,
        [&](Index w, Index x) -> bool { return !versions_.is_new(x) | (w < x); }, push);
  }

  WorkingSurface<Policies>& surface_;
  PairVersions& versions_;
  FlattenedVertices flattened_;
  std::vector<Index> ring_; // vertices whose pairs are costed again
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_COST_REFRESH_H
