#ifndef QUADRILLE_INTERNAL_CONTRACTION_RECORD_SCRATCH_H
#define QUADRILLE_INTERNAL_CONTRACTION_RECORD_SCRATCH_H

#include <quadrille/internal/contraction/record_buffer.h>
#include <quadrille/internal/contraction/refusals.h>

namespace quadrille::internal {

/// What a thread has done in a pass and a recorder is not told of yet.
struct RecordScratch {
  RecordBuffer contractions;
  Refusals refusals; // where a recorder wants to know
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_RECORD_SCRATCH_H
