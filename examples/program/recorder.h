#ifndef QUADRILLE_EXAMPLES_PROGRAM_RECORDER_H
#define QUADRILLE_EXAMPLES_PROGRAM_RECORDER_H

#include <quadrille/record.h>

namespace quadrille_examples {

/// A recorder of any kind, so that what tells it of contractions is compiled once.
class Recorder {
public:
  virtual ~Recorder() = default;
  virtual void begin(quadrille::RecordedSurface surface) = 0;
  virtual void record(const quadrille::RecordedContraction& contraction) = 0;
  virtual void end() = 0;
};

} // namespace quadrille_examples

#endif
