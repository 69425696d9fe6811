#ifndef QUADRILLE_INTERNAL_APPEARANCE_BACK_VALUES_H
#define QUADRILLE_INTERNAL_APPEARANCE_BACK_VALUES_H

#include <quadrille/internal/appearance/channel_input.h>
#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/surface/numbering.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What backs have beside their fronts, told as labels and channels of the fronts.
class BackValues {
public:
  /// `labels`: of each input face; or empty.
  BackValues(const TriangleComplex& complex, const InputIndices& faces, Array<Index>& labels,
             std::vector<ChannelInput>& channels)
      : complex_(complex), faces_(faces), labels_(labels), channels_(channels) {}

  /// A label for both sides: where it changes, or where backs begin, there is a border.
  void join_labels() {
    if (labels_.empty() && !is_partial())
      return;
    std::map<std::pair<Index, Index>, Index> numbers;
    const auto label = [&](Index face) { return labels_.empty() ? Index{0} : labels_[face]; };
    Array<Index> joined(faces_.input_count(), Index{0}, complex_.workspace());
    for_each_front([&](Index face) {
      const Index front = faces_[face];
      const Index back =
          complex_.backs().has(face) ? label(complex_.backs().input_face(face)) : none;
      joined[front] = numbers.try_emplace({label(front), back}, static_cast<Index>(numbers.size()))
                          .first->second;
    });
    labels_ = std::move(joined);
  }

  /// Appends a channel of the values that backs have for each channel in which they differ from
  /// their fronts. Returns which channel these are, of each that there was; its own number where
  /// there is none.
  std::vector<std::size_t> add_channels() {
    std::vector<std::size_t> numbers;
    const std::size_t count = channels_.size();
    for (std::size_t c = 0; c < count; ++c) {
      std::optional<ChannelInput> backs = channel_of_backs(channels_[c]);
      numbers.push_back(backs ? channels_.size() : c);
      if (backs)
        channels_.push_back(*std::move(backs));
    }
    return numbers;
  }

private:
  template <class Visit>
  void for_each_front(Visit visit) const {
    for (Index face = 0; face < complex_.face_capacity(); ++face)
      if (!complex_.is_removed(face))
        visit(face);
  }

  // Have some faces a back, and some none?
  bool is_partial() const {
    bool is = false;
    for_each_front([&](Index face) { is |= !complex_.backs().has(face); });
    return is;
  }

  // A vertex that has one value has it on both sides. Faces without a back have one value
  // throughout, which costs nothing.
  std::optional<ChannelInput> channel_of_backs(const ChannelInput& channel) const {
    if (channel.corners.empty())
      return std::nullopt;
    const Backs& backs = complex_.backs();
    bool differs = false;
    std::optional<Index> first;
    auto corners = channel.corners;
    for_each_front([&](Index face) {
      if (!backs.has(face))
        return;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index value = channel.corners[backs.input_face(face)][backs.opposite(face, i)];
        differs |= !channel.are_equal(channel.corners[faces_[face]][i], value);
        corners[faces_[face]][i] = value;
        first = first.value_or(value);
      }
    });
    if (!differs)
      return std::nullopt;
    for_each_front([&](Index face) {
      if (!backs.has(face))
        corners[faces_[face]] = {*first, *first, *first};
    });
    ChannelInput result = channel;
    result.corners = std::move(corners);
    return result;
  }

  const TriangleComplex& complex_;
  const InputIndices& faces_;
  Array<Index>& labels_;
  std::vector<ChannelInput>& channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_APPEARANCE_BACK_VALUES_H
