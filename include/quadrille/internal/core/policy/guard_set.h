#ifndef QUADRILLE_INTERNAL_CORE_POLICY_GUARD_SET_H
#define QUADRILLE_INTERNAL_CORE_POLICY_GUARD_SET_H

#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille {

struct GuardedSurface; // is in <quadrille/guard.h>: include that to write a guard

namespace internal {

template <std::size_t N>
class SurfaceGuard;
template <std::size_t N>
struct GuardRoom;

/// Makes what guards a surface for a guard of the user's: is in <quadrille/guard.h>.
template <class Guard, std::size_t N>
struct MadeByUser;

/// Is it a guard of the library's? Each has a header of its own.
template <class T>
concept IsOwnGuard = requires(const T guard, const GuardRoom<3>& room) {
  guard.make_guard(room);
};

/// Is it a guard, of the library's or of the user's?
template <class T>
concept IsGuard = IsOwnGuard<T> || requires(const T guard, const GuardedSurface& surface) {
  guard.begin(surface);
};

template <class T>
inline constexpr bool is_guard = IsGuard<Contained<T>>;

/// May several threads query it and report contractions to it? If not, it needs GreedyOrder.
template <class Guard>
inline constexpr bool works_in_passes = requires {
  requires Contained<Guard>::works_in_passes;
};

/// Does a guard that holds in each chunk of a file, in each phase, hold for the whole file?
template <class Guard>
inline constexpr bool works_in_chunks = requires {
  requires Contained<Guard>::works_in_chunks;
};

/// Makes what guards a surface, of a guard of any type.
template <std::size_t N>
class GuardMaker {
public:
  virtual ~GuardMaker() = default;
  virtual std::unique_ptr<SurfaceGuard<N>> make(const GuardRoom<N>& room) const = 0;
};

template <class Guard, std::size_t N>
class GuardMakerOf final : public GuardMaker<N> {
public:
  explicit GuardMakerOf(const Guard& guard) : guard_(guard) {}

  std::unique_ptr<SurfaceGuard<N>> make(const GuardRoom<N>& room) const override {
    if constexpr (IsOwnGuard<Guard>)
      return guard_.make_guard(room);
    else
      return MadeByUser<Guard, N>::make(guard_, room);
  }

private:
  Guard guard_;
};

/// The type-erased guards of a call. A call without guards compiles none, and has none to ask.
template <std::size_t N>
class GuardSet {
public:
  struct Entry {
    std::shared_ptr<const GuardMaker<N>> maker;
    Rejection cause;
  };

  template <class Guard>
  void add(const Guard& guard) {
    validate(guard);
    entries_.push_back({std::make_shared<const GuardMakerOf<Guard, N>>(guard), cause_of<Guard>});
    if (!internal::works_in_passes<Guard>)
      needs_greedy_order_ = name<Guard>();
    asks_for_volume_ |= internal::asks_for_volume<Guard>;
    if constexpr (requires { Guard::topology; }) {
      topology_ = Guard::topology;
      keeps_topology_ = name<Guard>();
    }
  }

  bool empty() const { return entries_.empty(); }
  /// In the order of the call.
  const std::vector<Entry>& entries() const { return entries_; }
  /// Does one of them know that the surface encloses a volume, which must be reported?
  bool asks_for_volume() const { return asks_for_volume_; }

  /// Throws if one of them needs GreedyOrder, where the order of a call has passes.
  void require_greedy_order(bool has_passes) const {
    if (has_passes && needs_greedy_order_)
      throw std::invalid_argument(needs_greedy_order_ +
                                  std::string(" needs GreedyOrder, since the blocks of a pass do "
                                              "not see each other"));
  }
  /// Returns the topology of a call with these guards. Throws if the call asks for another than
  /// they keep.
  std::optional<Topology> topology_with(std::optional<Topology> topology) const {
    if (!topology_)
      return topology;
    if (topology.value_or(*topology_) != *topology_)
      throw std::invalid_argument(keeps_topology_ +
                                  std::string(" keeps the topology: pass no Topology::free or "
                                              "Topology::components_may_vanish with it"));
    return topology_;
  }

private:
  template <class Guard>
  static constexpr const char* name() {
    if constexpr (requires { Guard::name; })
      return Guard::name;
    else
      return "a guard of this call of quadrille::simplify";
  }

  std::vector<Entry> entries_;
  bool asks_for_volume_ = false;
  const char* needs_greedy_order_ = nullptr; // the name of one that does
  const char* keeps_topology_ = nullptr;     // the same
  std::optional<Topology> topology_;
};

} // namespace internal

} // namespace quadrille

#endif // QUADRILLE_INTERNAL_CORE_POLICY_GUARD_SET_H
