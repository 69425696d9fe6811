#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WRITER_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WRITER_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/attributes/channels.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/recording.h>
#include <quadrille/internal/core/recording/corners_by_input_face.h>
#include <quadrille/internal/core/recording/record_buffer.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/recorded.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A channel of the engine in the form that a recorder receives.
struct ReportedChannel {
  std::size_t number;   ///< the number of the channel of the call
  Index first_wedge;    ///< an offset that is added to the numbers of its wedges
  bool is_of_reverse;   ///< are its values those of reverse faces?
  bool has_wedges;      ///< or is its value a number of each vertex?
  std::size_t
      of_reverse; ///< which channel has the values of reverse faces; itself if they have the same
};

/// Returns all channels of a surface. If reverse faces have values of their own these are further
/// wedges of the channel. `reverse_channels`: see ReverseChannels; empty if there are no reverse
/// faces.
inline std::vector<ReportedChannel>
reported_channels(std::span<const Channel> channels,
                  const std::vector<std::size_t>& reverse_channels, std::size_t vertices) {
  std::vector<ReportedChannel> reported(channels.size());
  for (std::size_t c = 0; c < reported.size(); ++c)
    reported[c] = {c, 0, false, channels[c].has_seams(), c};
  for (std::size_t c = 0; c < reverse_channels.size(); ++c)
    if (const std::size_t reverse_faces = reverse_channels[c]; reverse_faces != c) {
      const auto wedges = static_cast<Index>(channels[c].wedge_count(vertices));
      reported[c].has_wedges = true;
      reported[c].of_reverse = reverse_faces;
      reported[reverse_faces] = {c, wedges, true, true, reverse_faces};
    }
  return reported;
}

/// Reports the changes of the channels of a surface to a recorder.
template <class Policies>
class ChannelWriter {
public:
  explicit ChannelWriter(const RecordingNeeds<Policies>& needs)
      : complex_(needs.state.complex), numbering_(needs.state.numbering),
        channels_(needs.state.appearance.channels()) {}

  /// Returns how many numbers of a vertex are values of channels.
  std::size_t begin() {
    reported_ = reported_channels(channels_.all(), channels_.reverse_channels(),
                                  complex_.vertex_capacity());
    std::size_t width = 0;
    for (std::size_t c = 0; c < reported_.size(); ++c)
      width += reported_[c].has_wedges ? 0 : channels_.all()[c].components();
    return width;
  }
  /// Returns the channels as a recorder receives them at the beginning.
  std::vector<RecordedChannel> recorded() {
    std::vector<RecordedChannel> recorded;
    for (const ReportedChannel& reported : reported_)
      if (!reported.is_of_reverse)
        recorded.push_back(read(reported));
    return recorded;
  }
  /// The numbers of a vertex that are values of channels.
  void append_values_of(Index v, std::vector<double>& values) {
    for (std::size_t c = 0; c < reported_.size(); ++c)
      if (!reported_[c].has_wedges)
        channels_.all()[c].append_final_values(v, values);
  }

  /// The wedges of the pair that meets, before they do.
  template <class Contraction>
  void before(const Contraction& contraction, RecordBuffer& buffer) {
    std::vector<RecordBuffer::Corner>& corners = buffer.corners;
    corners.clear();
    const auto channels = channels_.all();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (!reported_[c].has_wedges)
        continue;
      const auto note = [&](Index face, Index end) {
        Channel& channel = channels[c];
        if (reported_[c].is_of_reverse && !complex_.reverse_faces().has(face))
          return;
        corners.push_back(
            {c, channel.records().identity(channel.wedge(complex_, face, end)), face});
      };
      for (const StarFace& f : contraction.star().first)
        note(f.face, contraction.first());
      for (const StarFace& f : contraction.star().second)
        note(f.face, contraction.second());
    }
  }

  /// Reports that wedges have met and are one now: the lowest identity is left.
  void after(Index kept, RecordBuffer& buffer) {
    buffer.wedges.clear();
    buffer.joined.clear();
    buffer.wedge_values.clear();
    std::vector<std::pair<Index, Index>> renamed; // the wedge now, and an identity that it had
    const auto& corners = buffer.corners;
    for (auto begin = corners.begin(); begin != corners.end();) {
      const std::size_t c = begin->channel;
      Channel& channel = channels_.all()[c];
      renamed.clear();
      for (; begin != corners.end() && begin->channel == c; ++begin)
        renamed.emplace_back(channel.wedge(complex_, begin->face, kept), begin->identity);
      std::sort(renamed.begin(), renamed.end());
      renamed.erase(std::unique(renamed.begin(), renamed.end()), renamed.end());
      for (std::size_t i = 0; i < renamed.size(); ++i) {
        const auto [wedge, identity] = renamed[i];
        if (i > 0 && renamed[i - 1].first == wedge) {
          buffer.joined.push_back(reported_[c].first_wedge + identity);
          buffer.wedges.back().joined_end = buffer.joined.size();
          continue;
        }
        channel.records().identity(wedge) = identity;
        const std::size_t values_begin = buffer.wedge_values.size();
        if (!channel.append_final_values(wedge, buffer.wedge_values))
          buffer.wedge_values.resize(values_begin);
        buffer.wedges.push_back({reported_[c].number, reported_[c].first_wedge + identity,
                                 buffer.joined.size(), buffer.wedge_values.size()});
      }
    }
    buffer.view_wedges();
  }

private:
  RecordedChannel read(const ReportedChannel& reported) {
    Channel& forward = channels_.all()[reported.number];
    RecordedChannel recorded{forward.components(), {}, {}};
    if (!reported.has_wedges)
      return recorded;
    recorded.corners = corners_by_input_face(
        complex_, numbering_.faces, [&](Index face, std::size_t i, bool is_reverse) {
          const std::size_t c = is_reverse ? reported.of_reverse : reported.number;
          return reported_[c].first_wedge +
                 channels_.all()[c].wedge(complex_, face, complex_.vertices(face)[i]);
        });
    append_values(forward, recorded.values);
    if (reported.of_reverse != reported.number)
      append_values(channels_.all()[reported.of_reverse], recorded.values);
    return recorded;
  }
  void append_values(Channel& channel, std::vector<double>& values) const {
    channel.records().identify();
    for (Index wedge = 0; wedge < channel.wedge_count(complex_.vertex_capacity()); ++wedge)
      channel.append_final_values(wedge, values);
  }

  const TriangleComplex& complex_;
  const Numbering& numbering_;
  ChannelsOf<Policies>& channels_;
  std::vector<ReportedChannel> reported_; // of each channel
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WRITER_H
