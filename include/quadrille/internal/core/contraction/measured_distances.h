#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_MEASURED_DISTANCES_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_MEASURED_DISTANCES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/report.h>

#include <memory>
#include <vector>

namespace quadrille::internal {

template <class Policies>
class PairEvaluator;
template <class Policies>
class Checks;
struct FaceBound;

/// How far a surface is from the input, for stop policies that need to know. It is compiled for
/// calls with such a policy only: see DistanceCheck, which <quadrille/distance_limits.h> brings.
/// Any number of threads may ask at once, each with a Scratch of its own.
template <class Policies>
class MeasuredDistances {
public:
  using Candidate = internal::Candidate<typename Policies::Cost>;
  using Contraction = internal::Contraction<typename Policies::Cost>;

  virtual ~MeasuredDistances() = default;

  /// Would a contraction take the surface so far from the input that the stop policy stops? If not,
  /// the status receives the distance. The contraction may get another position.
  virtual bool is_too_far(Contraction& contraction, Status& status) = 0;
  /// Is it certain, by a look at one of very many faces? Then the star need not be gathered.
  virtual bool is_beyond_high_valence(const Candidate& candidate, const Scratch& scratch,
                                      const Status& status) = 0;
  /// How far the contraction that was measured last, with this scratch, takes its faces and the
  /// input points in them, in the mesh's unit.
  virtual double bound_of(const Contraction& contraction) const = 0;
  /// A contraction has been done.
  virtual void follow(const Contraction& contraction) = 0;
  /// Faces that are removed are about to lose their numbers, in a pass.
  virtual void pack() = 0;
  /// Reports the known distances of the current surface. Does each point of the input have a place
  /// on it?
  virtual void write_to(Report& report, bool has_all_points) const = 0;
  /// Reports the known distance of each face, by its number in the input.
  virtual void write_bounds(std::vector<FaceBound>& bounds) const = 0;
};

/// The input of such measurements: a box in the mesh's unit, and tolerances of vertices if there
/// are any.
template <class Policies>
struct DistanceNeeds {
  const SurfaceState<Policies>& state;
  const PairEvaluator<Policies>& evaluator;
  const Checks<Policies>& checks;
  const Box<Policies::Cost::dimension>& box;
  const std::vector<double>& tolerances;
};

/// The measured distances of a surface, as an observer of its contractions, if a policy asks for
/// them.
template <class Policies>
class OptionalDistances {
public:
  void measure(const DistanceNeeds<Policies>& needs) {
    distances_ = needs.state.policies.optional.make_distances(needs);
  }

  MeasuredDistances<Policies>* operator->() const { return distances_.get(); }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) const {
    if (distances_) [[unlikely]]
      distances_->follow(event.contraction);
  }
  template <class IsLeft>
  void pack_if(IsLeft) const {
    if (distances_)
      distances_->pack();
  }

private:
  std::unique_ptr<MeasuredDistances<Policies>> distances_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_MEASURED_DISTANCES_H
