#ifndef QUADRILLE_COMPILED_SOUP_RUN_H
#define QUADRILLE_COMPILED_SOUP_RUN_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_arrays.h>
#include <quadrille/record.h>

#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// A call on its way to the source that is compiled for its cost.

namespace quadrille::internal {

struct SoupRun {
  const SoupView& soup;
  const SoupOptions& options;
  SoupPointArray points;
  SoupTriangleArray triangles;
  std::vector<SoupChannel> channels; ///< empty until they are rewritten
  std::vector<std::size_t> image;
};

/// Levels of detail, or nobody.
class SoupRecorder {
public:
  explicit SoupRecorder(Levels* levels) : levels_(levels) {}

  bool is_listening() const { return levels_ != nullptr; }
  void begin(RecordedSurface surface);
  void record(const RecordedContraction& contraction);
  void end();

private:
  Levels* levels_;
};

// For each cost, of soups that carry nothing, and of all.
Report simplify_by_quadric(SoupRun&);
Report simplify_by_memoryless_quadric(SoupRun&);
Report simplify_by_thin_feature_quadric(SoupRun&);
Report simplify_by_edge_length(SoupRun&);
Report simplify_carrying_by_quadric(SoupRun&);
Report simplify_carrying_by_memoryless_quadric(SoupRun&);
Report simplify_carrying_by_thin_feature_quadric(SoupRun&);
Report simplify_carrying_by_edge_length(SoupRun&);

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_RUN_H
