#ifndef QUADRILLE_RECORD_H
#define QUADRILLE_RECORD_H

#include <quadrille/internal/core/recording/record_writer.h>
#include <quadrille/recorded.h>

namespace quadrille {

/// An argument of `simplify` that passes all contractions to a recorder. The recorder must outlive
/// the call.
///
/// RelaxedOrder contracts in many places at a time. It reports its contractions in an order in
/// which they could have been done one by one, and which is the same for any number of threads:
/// those of a pass by their costs, as far as the order within each block allows it. The rejections
/// of each stage of a pass follow its contractions, block by block, in their order within each
/// block.
template <ContractionRecorder R>
struct RecordInto {
  R* recorder; ///< not owned
};
/// Makes the argument of `simplify` that passes all contractions to a recorder: see RecordInto.
template <ContractionRecorder R>
RecordInto<R> record_into(R& recorder) {
  return {&recorder};
}

} // namespace quadrille

#endif // QUADRILLE_RECORD_H
