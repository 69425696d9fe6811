#ifndef QUADRILLE_RECORD_H
#define QUADRILLE_RECORD_H

#include <quadrille/internal/core/recording/record_writer.h>
#include <quadrille/recorded.h>

namespace quadrille {

/// An argument of `simplify` by which a recorder is told of all contractions. It has to be there as
/// long as the call.
///
/// RelaxedOrder contracts in many places at a time. Its contractions are told in an order in which
/// they could have been done one by one, which is the same for any number of threads: those of a
/// pass by their costs, as far as the order within each block allows it. After those of a stage of
/// a pass come its refusals, by block, and as they were in each.
template <ContractionRecorder R>
struct RecordInto {
  R* recorder; ///< not owned
};
/// The argument of `simplify` that tells a recorder of all contractions: see RecordInto.
template <ContractionRecorder R>
RecordInto<R> record_into(R& recorder) {
  return {&recorder};
}

} // namespace quadrille

#endif // QUADRILLE_RECORD_H
