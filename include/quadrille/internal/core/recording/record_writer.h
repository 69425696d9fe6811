#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_WRITER_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_WRITER_H

#include <quadrille/internal/core/base/digit_sort.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/recording.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/recording/corners_by_input_face.h>
#include <quadrille/internal/core/recording/record_buffer.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/recorded.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The rejections of a thread in a stage of a pass, block by block.
class RejectionLog {
public:
  /// Rejections belong to that block from here on.
  void begin_block(std::size_t number) { blocks_.push_back({number, rejections_.size()}); }
  void add(const RecordedRejection& rejection) {
    rejections_.push_back(rejection);
    blocks_.back().end = rejections_.size();
  }
  void clear() {
    rejections_.clear();
    blocks_.clear();
  }

  using OfBlock = std::pair<std::size_t, std::span<const RecordedRejection>>;
  void append_to(std::vector<OfBlock>& by_block) const {
    std::size_t begin = 0;
    for (const Block& block : blocks_) {
      by_block.emplace_back(block.number, std::span(rejections_).subspan(begin, block.end - begin));
      begin = block.end;
    }
  }

private:
  struct Block {
    std::size_t number;
    std::size_t end; // from where those of the block before it end
  };

  std::vector<RecordedRejection> rejections_;
  std::vector<Block> blocks_;
};

/// The contractions of a thread in a pass that have not yet been reported to a recorder.
struct RecordScratch {
  RecordBuffer contractions;
  RejectionLog rejections; // where a recorder wants to know
};

/// Reports all rejections of threads in a stage, by block, and clears them. Each block belongs to
/// one thread.
template <class Recorder>
void report_rejections(const Recorder& recorder, std::vector<RecordScratch>& scratches) {
  std::vector<RejectionLog::OfBlock> blocks;
  for (const RecordScratch& scratch : scratches)
    scratch.rejections.append_to(blocks);
  std::sort(blocks.begin(), blocks.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, rejections] : blocks)
    for (const RecordedRejection& rejection : rejections)
      recorder.reject(rejection);
  for (RecordScratch& scratch : scratches)
    scratch.rejections.clear();
}

/// The place at which a contraction of a stage is recorded, and its cost.
struct RecordPlace {
  std::size_t block;
  float cost;
  std::uint32_t thread;
  Index number;
};

/// The contractions that threads have recorded in a stage, by cost and then by block. By block
/// first, so that ties of costs, which no float of at least 0 orders otherwise than its bits do,
/// are too.
inline std::vector<RecordPlace>
places_in_order_of_cost(const std::vector<RecordScratch>& scratches) {
  std::vector<RecordPlace> places;
  for (std::uint32_t thread = 0; thread < scratches.size(); ++thread) {
    const RecordBuffer& buffer = scratches[thread].contractions;
    std::size_t i = 0;
    for (const RecordBuffer::Block& block : buffer.blocks)
      for (; i < block.end; ++i)
        places.push_back({block.number, buffer.costs[i], thread, static_cast<Index>(i)});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const RecordPlace& a, const RecordPlace& b) { return a.block < b.block; });
  std::vector<RecordPlace> next(places.size());
  for (int shift = 0; shift < 32; shift += 8) {
    sort_by_digit<8>(places.data(), places.size(), next.data(), [shift](const RecordPlace& place) {
      return std::bit_cast<std::uint32_t>(place.cost) >> shift & 255;
    });
    places.swap(next);
  }
  return places;
}

/// Reports the changes of channels to a recorder: see channel_writer.h.
template <class Policies>
class ChannelWriter;
/// Does nothing, for a surface without channels.
struct NoChannelWriter {
  template <class Policies>
  explicit NoChannelWriter(const RecordingNeeds<Policies>&) {}
  std::size_t begin() { return 0; }
  std::vector<RecordedChannel> recorded() const { return {}; }
  void append_values_of(Index, std::vector<double>&) const {}
  template <class Contraction>
  void before(const Contraction&, RecordBuffer&) {}
  void after(Index, RecordBuffer&) {}
};

/// Reports the changes of a surface to a recorder, by input indices and in the mesh's units.
template <class Policies>
class RecordWriter : public Recording<Policies> {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Contraction = internal::Contraction<Cost>;
  using Channels =
      std::conditional_t<Policies::has_channels, ChannelWriter<Policies>, NoChannelWriter>;

  explicit RecordWriter(const RecordingNeeds<Policies>& needs)
      : state_(needs.state), channels_(needs), distances_(needs.distances),
        scratches_(needs.state.policies.threads) {}

  void begin() override {
    const std::size_t vertices = state_.numbering.vertices.input_count();
    width_ = dimension + channels_.begin();
    RecordedSurface surface{dimension,
                            width_,
                            std::vector<double>(width_ * vertices),
                            {},
                            {},
                            state_.policies.stop.needs().distance,
                            state_.policies.stop.needs().reverse_distance};
    std::vector<double> memory;
    for (Index v = 0; v < state_.complex.vertex_capacity(); ++v) {
      const Vector<dimension> position = state_.scale.position_of_mesh(state_.geometry.position(v));
      const std::span<const double> of_vertex = values_of(v, position, memory);
      std::copy(of_vertex.begin(), of_vertex.end(),
                surface.values.begin() +
                    static_cast<std::ptrdiff_t>(width_ * state_.numbering.vertices[v]));
    }
    surface.triangles = corners_by_input_face(
        state_.complex, state_.numbering.faces, [this](Index face, std::size_t i, bool) {
          return state_.numbering.vertices[state_.complex.vertices(face)[i]];
        });
    surface.channels = channels_.recorded();
    state_.policies.recorder->begin(std::move(surface));
    for (RecordScratch& scratch : scratches_)
      scratch.contractions.list = empty_list();
  }

  void before(const Contraction& contraction) override {
    channels_.before(contraction, scratches_[contraction.scratch().number].contractions);
  }

  void after(const Contraction& contraction, Index kept, Index gone, double error,
             bool is_in_pass) override {
    Scratch& scratch = contraction.scratch();
    RecordBuffer& buffer = scratches_[scratch.number].contractions;
    const Vector<dimension> position = state_.scale.position_of_mesh(contraction.target());
    buffer.faces.clear();
    for (const StarFace& f : scratch.star.shared)
      add_inputs(f.face, buffer.faces);
    for (Index face : scratch.duplicates)
      add_inputs(face, buffer.faces);
    channels_.after(kept, buffer);
    const RecordedContraction recorded{state_.numbering.vertices[kept],
                                       state_.numbering.vertices[gone],
                                       values_of(kept, position, buffer.values),
                                       error,
                                       distance_bound(contraction),
                                       buffer.faces,
                                       buffer.views};
    if (is_in_pass)
      buffer.add(recorded, contraction.cost());
    else
      state_.policies.recorder->record(recorded);
  }

  void vanished(const ComponentEvent& event) override {
    std::vector<Index> faces;
    for (Index face : event.faces)
      add_inputs(face, faces);
    RecordedContraction removal;
    removal.error = event.radius;
    if (state_.policies.stop.needs().reverse_distance) // its points have no place left
      removal.distance_bound = std::numeric_limits<double>::infinity();
    removal.removed_faces = faces;
    state_.policies.recorder->record(removal);
  }

  void reject(const std::array<Index, 2>& ends, Rejection cause, double error) override {
    if (state_.policies.recorder->asks_for_rejections())
      state_.policies.recorder->reject(rejection(ends, cause, error));
  }
  void reject_in_pass(const std::array<Index, 2>& ends, Rejection cause, double error,
                      Scratch& scratch) override {
    if (state_.policies.recorder->asks_for_rejections())
      scratches_[scratch.number].rejections.add(rejection(ends, cause, error));
  }

  void begin_block(std::size_t number, Scratch& scratch) override {
    scratches_[scratch.number].contractions.begin_block(number);
    scratches_[scratch.number].rejections.begin_block(number);
  }
  void end_stage() override {
    std::vector<RecordedWedge> wedges;
    for (const RecordPlace& place : places_in_order_of_cost(scratches_))
      state_.policies.recorder->record(
          scratches_[place.thread].contractions.list.contraction(place.number, wedges));
    report_rejections(*state_.policies.recorder, scratches_);
    for (RecordScratch& scratch : scratches_) {
      scratch.contractions.list = empty_list();
      scratch.contractions.costs.clear();
      scratch.contractions.blocks.clear();
    }
  }

  void end(StopReason reason) override { state_.policies.recorder->end(reason); }

private:
  // By input indices.
  RecordedRejection rejection(const std::array<Index, 2>& ends, Rejection cause,
                              double error) const {
    return {input_vertex(ends[0]), input_vertex(ends[1]), cause, error};
  }
  Index input_vertex(Index v) const { return v == none ? none : state_.numbering.vertices[v]; }

  RecordList empty_list() const {
    return {width_, state_.policies.stop.needs().distance,
            state_.policies.stop.needs().reverse_distance};
  }

  // The numbers of a vertex at a position; in a memory, if there are more than the position's.
  std::span<const double> values_of(Index v, const Vector<dimension>& position,
                                    std::vector<double>& memory) {
    if (width_ == dimension)
      return position.coordinates;
    memory.assign(position.coordinates.begin(), position.coordinates.end());
    channels_.append_values_of(v, memory);
    return memory;
  }

  // The input index of a face, and that of its reverse.
  void add_inputs(Index face, auto& faces) const {
    faces.push_back(state_.numbering.faces[face]);
    if (state_.complex.reverse_faces().has(face))
      faces.push_back(state_.complex.reverse_faces().input_face(face));
  }

  double distance_bound(const Contraction& contraction) const {
    if (!state_.policies.stop.needs().distance)
      return 0;
    return distances_->bound_of(contraction);
  }

  const SurfaceState<Policies>& state_;
  Channels channels_;
  const OptionalDistances<Policies>& distances_;
  std::vector<RecordScratch> scratches_; // one for each thread
  std::size_t width_ = dimension;        // how many numbers a vertex has
};

/// For OptionalModules.
template <class Policies>
std::unique_ptr<Recording<Policies>> make_recording(const RecordingNeeds<Policies>& needs) {
  return std::make_unique<RecordWriter<Policies>>(needs);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_WRITER_H
