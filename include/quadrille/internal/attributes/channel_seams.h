#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_SEAMS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_SEAMS_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/attributes/channel_contraction.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/append_buffer.h>

#include <algorithm>
#include <span>

namespace quadrille::internal {

/// The seams of channels that are kept, as the SeamGraph of a surface asks for them.
class ChannelSeams {
public:
  ChannelSeams() = default;
  ChannelSeams(const TriangleComplex& complex, std::span<const Channel> channels)
      : complex_(&complex), channels_(channels) {}

  /// Are the seams of any channel kept?
  bool are_any_kept() const {
    return std::any_of(channels_.begin(), channels_.end(),
                       [](const Channel& channel) { return channel.are_seams_kept(); });
  }
  /// Is there one at the edge vw of two faces?
  bool are_at(Index face, Index other, Index v, Index w) const {
    return std::any_of(channels_.begin(), channels_.end(), [&](const Channel& channel) {
      return channel.are_seams_kept() && channel.ends_between(*complex_, face, other, v, w);
    });
  }
  /// Would the contraction of the pair ab close or open one?
  bool are_changed_by(const PairStar& star, Index a, Index b) const {
    return std::any_of(channels_.begin(), channels_.end(), [&](const Channel& channel) {
      return channel.are_seams_kept() && channel.has_seams() &&
             (ChannelContraction(channel, *complex_, {a, b, {}}).closes_seam(star) ||
              opens_seam(channel, star, a, b));
    });
  }

private:
  // When two edges to a vertex c become one, is that a seam though neither was, or none though one
  // was? Half seams can cause this, at which the channel is discontinuous at one end only.
  bool opens_seam(const Channel& channel, const PairStar& star, Index a, Index b) const {
    const auto face_with = [](const AppendBuffer<StarFace>& faces, Index c) {
      const auto f = std::find_if(faces.begin(), faces.end(),
                                  [c](const StarFace& face) { return face.has(c); });
      return f == faces.end() ? none : f->face;
    };
    return std::any_of(star.shared.begin(), star.shared.end(), [&](const StarFace& f) {
      const Index c = f.other_than(b);
      if (channel.has_one_wedge(c))
        return false;
      const Index at_a = face_with(star.first, c), at_b = face_with(star.second, c);
      if (at_a == none || at_b == none)
        return false;
      const auto differ = [&](Index face, Index other, Index v) {
        return channel.wedge(*complex_, face, v) != channel.wedge(*complex_, other, v);
      };
      const bool was = (differ(at_a, f.face, a) && differ(at_a, f.face, c)) ||
                       (differ(at_b, f.face, b) && differ(at_b, f.face, c));
      const bool is = differ(at_a, at_b, c) && (differ(at_a, f.face, a) || differ(at_b, f.face, b));
      return was != is;
    });
  }

  const TriangleComplex* complex_ = nullptr;
  std::span<const Channel> channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_SEAMS_H
