#include <quadrille/compiled/soup_run.h>
#include <quadrille/levels.h>

#include <utility>

namespace quadrille::internal {

void SoupRecorder::begin(RecordedSurface surface) {
  if (levels_)
    levels_->begin(std::move(surface));
}
void SoupRecorder::record(const RecordedContraction& contraction) {
  if (levels_)
    levels_->record(contraction);
}
void SoupRecorder::end() {
  if (levels_)
    levels_->end();
}

} // namespace quadrille::internal
