#ifndef QUADRILLE_INTERNAL_CONTRACTION_BACK_VALUES_H
#define QUADRILLE_INTERNAL_CONTRACTION_BACK_VALUES_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/doubled_faces.h>
#include <quadrille/internal/contraction/setup.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/surface/channel_input.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/internal/surface/surface_input.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What backs have beside their fronts, told as labels and channels of the fronts.
template <std::size_t N>
class BackValues {
public:
  BackValues(const TriangleComplex& complex, const InputIndices& faces, SurfaceInput<N>& input)
      : complex_(complex), faces_(faces), input_(input) {}

  /// A label for both sides: where it changes, or where backs begin, there is a border.
  void join_labels() {
    if (input_.labels.empty() && !is_partial())
      return;
    std::map<std::pair<Index, Index>, Index> numbers;
    const auto label = [&](Index face) {
      return input_.labels.empty() ? Index{0} : input_.labels[face];
    };
    Array<Index> joined(faces_.input_count(), Index{0}, complex_.workspace());
    for_each_front([&](Index face) {
      const Index front = faces_[face];
      const Index back =
          complex_.backs().has(face) ? label(complex_.backs().input_face(face)) : none;
      joined[front] = numbers.try_emplace({label(front), back}, static_cast<Index>(numbers.size()))
                          .first->second;
    });
    input_.labels = std::move(joined);
  }

  /// Appends a channel of the values that backs have for each channel in which they differ from
  /// their fronts. Returns which channel these are, of each that there was; its own number where
  /// there is none.
  std::vector<std::size_t> add_channels() {
    std::vector<std::size_t> numbers;
    const std::size_t count = input_.channels.size();
    for (std::size_t c = 0; c < count; ++c) {
      std::optional<ChannelInput> backs = channel_of_backs(input_.channels[c]);
      numbers.push_back(backs ? input_.channels.size() : c);
      if (backs)
        input_.channels.push_back(*std::move(backs));
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
  SurfaceInput<N>& input_;
};

/// Before the first contraction: of faces on the same vertices one is left, or one with a back
/// where the input may have them. Returns which channel has the values of backs, of each.
template <std::size_t N>
std::vector<std::size_t> settle_doubled_faces(TriangleComplex& complex, const InputIndices& faces,
                                              SurfaceInput<N>& input, Tally& tally) {
  const Array<Index> labels = labels_by_face(input.labels, faces, complex);
  DoubledFaces doubled(complex, labels, tally);
  if (!input.may_have_backs) {
    doubled.remove();
    return {};
  }
  doubled.pair_up(faces);
  if (complex.backs().is_empty())
    return {};
  BackValues<N> values(complex, faces, input);
  values.join_labels();
  return values.add_channels();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_BACK_VALUES_H
