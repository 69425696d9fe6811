#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_GUARD_LIST_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_GUARD_LIST_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// The guards of a surface, in the order of the call. If there are none, the only cost is the check
/// for that.
template <std::size_t N>
class GuardList {
public:
  GuardList(const GuardSet<N>& guards, const GuardRoom<N>& room) {
    for (const auto& entry : guards.entries())
      guards_.push_back({entry.maker->make(room), entry.cause});
  }

  bool empty() const { return guards_.empty(); }

  void begin(Report& report) {
    for (const Guarding& g : guards_)
      g.guard->begin(report);
  }
  void end(Report& report) {
    for (const Guarding& g : guards_)
      g.guard->end(report);
  }

  /// Why the ends of a contraction must not come to a target, if so.
  template <class Contraction>
  QUADRILLE_NOINLINE std::optional<Rejection> rejection(const Contraction& contraction,
                                                        const Vector<N>& target) const {
    const GuardedPair<N> pair = guarded(contraction, target);
    for (const Guarding& g : guards_)
      if (g.guard->rejects(pair))
        return g.cause;
    return std::nullopt;
  }

  /// The guard that rejects pairs for this cause because of other faces, if there is one.
  const SurfaceGuard<N>* with_obstacles(Rejection cause) const {
    for (const Guarding& g : guards_)
      if (g.cause == cause && g.guard->has_obstacles())
        return g.guard.get();
    return nullptr;
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) const {
    if (!guards_.empty()) [[unlikely]]
      follow(event.contraction, event.kept);
  }
  void vanished(const ComponentEvent& event) const {
    for (const Guarding& g : guards_)
      g.guard->forget(event.faces);
  }
  /// Faces that are removed are about to lose their numbers, in a pass.
  template <class IsLeft>
  void pack_if(IsLeft) const {
    for (const Guarding& g : guards_)
      g.guard->pack();
  }

private:
  struct Guarding {
    std::unique_ptr<SurfaceGuard<N>> guard;
    Rejection cause;
  };

  template <class Contraction>
  static GuardedPair<N> guarded(const Contraction& contraction, const Vector<N>& target) {
    return {contraction.star(),       contraction.first(),       contraction.second(),
            contraction.pair().first, contraction.pair().second, target};
  }

  template <class Contraction>
  QUADRILLE_NOINLINE void follow(const Contraction& contraction, Index kept) const {
    const GuardedPair<N> pair = guarded(contraction, contraction.target());
    for (const Guarding& g : guards_)
      g.guard->follow(pair, kept);
  }

  std::vector<Guarding> guards_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_GUARD_LIST_H
