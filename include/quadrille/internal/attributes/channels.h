#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/attributes/channel_contraction.h>
#include <quadrille/internal/attributes/channel_seams.h>
#include <quadrille/internal/attributes/channel_weights.h>
#include <quadrille/internal/attributes/chart_ends.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/appearance/no_channels.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/cost/vertex_states.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/vertex_arrays.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Stores the values of reverse faces as channels of their forward faces.
class ReverseChannels {
public:
  ReverseChannels(const TriangleComplex& complex, const InputIndices& faces,
                  std::vector<ChannelInput>& channels)
      : complex_(complex), faces_(faces), channels_(channels) {}

  /// Appends a channel of the values that reverse faces have for each channel in which they differ
  /// from their forward faces. Returns which channel these are, of each that there was; its own
  /// number where there is none.
  std::vector<std::size_t> add() {
    std::vector<std::size_t> numbers;
    const std::size_t count = channels_.size();
    for (std::size_t c = 0; c < count; ++c) {
      std::optional<ChannelInput> reverse_faces = channel_of_reverse(channels_[c]);
      numbers.push_back(reverse_faces ? channels_.size() : c);
      if (reverse_faces)
        channels_.push_back(*std::move(reverse_faces));
    }
    return numbers;
  }

private:
  // A vertex that has one value has it on both sides. Faces without a reverse face have one value
  // throughout, which costs nothing.
  std::optional<ChannelInput> channel_of_reverse(const ChannelInput& channel) const {
    if (channel.corners.empty())
      return std::nullopt;
    const ReverseFaces& reverse_faces = complex_.reverse_faces();
    bool differs = false;
    std::optional<Index> first;
    auto corners = channel.corners;
    for_each_face(complex_, [&](Index face) {
      if (!reverse_faces.has(face))
        return;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index value =
            channel.corners[reverse_faces.input_face(face)][reverse_faces.opposite(face, i)];
        differs |= !channel.are_equal(channel.corners[faces_[face]][i], value);
        corners[faces_[face]][i] = value;
        first = first.value_or(value);
      }
    });
    if (!differs)
      return std::nullopt;
    for_each_face(complex_, [&](Index face) {
      if (!reverse_faces.has(face))
        corners[faces_[face]] = {*first, *first, *first};
    });
    ChannelInput result = channel;
    result.corners = std::move(corners);
    return result;
  }

  const TriangleComplex& complex_;
  const InputIndices& faces_;
  std::vector<ChannelInput>& channels_;
};

/// The final channels of a surface, by the numbers that the caller has given them. The wedges of
/// reverse faces come after all others.
struct ChannelsLeft {
  std::vector<Channel> channels;
  std::vector<std::size_t> reverse_channels; ///< see ReverseChannels

  /// Returns the wedge of a face of the complex at a vertex, or of its reverse.
  Index wedge(const TriangleComplex& complex, std::size_t c, Index face, Index v,
              bool is_reverse) const {
    const bool is_other = is_reverse && has_reverse_channel(c);
    return is_other ? wedges_of(complex, c) + channel_of_reverse(c).wedge(complex, face, v)
                    : channels[c].wedge(complex, face, v);
  }
  /// How many numbers of wedges a channel may use.
  std::size_t wedge_count(const TriangleComplex& complex, std::size_t c) const {
    return has_reverse_channel(c) ? wedges_of(complex, c) +
                                        channel_of_reverse(c).wedge_count(complex.vertex_capacity())
                                  : wedges_of(complex, c);
  }
  std::size_t components(std::size_t c) const { return channels[c].components(); }
  double value(const TriangleComplex& complex, std::size_t c, Index wedge,
               std::size_t component) const {
    const auto [channel, number] = channel_and_wedge(complex, c, wedge);
    return channel->value(number, component);
  }
  Index origin(const TriangleComplex& complex, std::size_t c, Index wedge) const {
    const auto [channel, number] = channel_and_wedge(complex, c, wedge);
    return channel->origin(number);
  }

private:
  bool has_reverse_channel(std::size_t c) const {
    return !reverse_channels.empty() && reverse_channels[c] != c;
  }
  const Channel& channel_of_reverse(std::size_t c) const { return channels[reverse_channels[c]]; }
  Index wedges_of(const TriangleComplex& complex, std::size_t c) const {
    return static_cast<Index>(channels[c].wedge_count(complex.vertex_capacity()));
  }
  std::pair<const Channel*, Index> channel_and_wedge(const TriangleComplex& complex, std::size_t c,
                                                     Index wedge) const {
    if (!has_reverse_channel(c) || wedge < wedges_of(complex, c))
      return {&channels[c], wedge};
    return {&channel_of_reverse(c), wedge - wedges_of(complex, c)};
  }
};

/// Do the states of vertices include the quadrics of channels?
template <class Cost>
inline constexpr bool accumulates_forms = std::same_as<typename Cost::State, QuadricForm<3>>;

/// Does a cost add what channels leave to what it sees now?
template <class Cost>
inline constexpr bool sees_forms = requires(PairOf<Cost>& pair, const QuadricForm<3>& form) {
  pair.current.quadric += form;
};

/// The channels of a surface, and what they cost. A cost that takes no quadric does not count them,
/// but they are carried along.
template <class Cost>
class Channels {
public:
  using Geometry = internal::Geometry<Cost::dimension>;
  using Position = Vector<3>;
  using Left = ChannelsLeft;
  using Seams = ChannelSeams;

  Channels(const TriangleComplex& complex, const Geometry& geometry, VertexStates<Cost>& states)
      : complex_(complex), geometry_(geometry), states_(states), forms_(complex.arena()),
        traces_(complex.arena()) {}

  /// Takes the data of an adapter; if reverse faces have values of their own, these are channels
  /// after the others. `labels`: of each face; or empty.
  void read(std::vector<ChannelInput> inputs, const Numbering& numbering,
            const Array<Index>& labels, const Scale<Cost::dimension>& scale, bool are_pairs_edges) {
    if (!complex_.reverse_faces().is_empty())
      reverse_channels_ = ReverseChannels(complex_, numbering.faces, inputs).add();
    for (const ChannelInput& input : inputs)
      channels_.push_back(
          Channel(input, numbering, complex_,
                  channel_weights(input, numbering, complex_, geometry_.positions(), labels, scale),
                  are_pairs_edges));
  }
  std::span<const Channel> all() const { return channels_; }
  std::span<Channel> all() { return channels_; }
  /// See ReverseChannels; empty if there are no reverse faces.
  const std::vector<std::size_t>& reverse_channels() const { return reverse_channels_; }
  bool have_seams() const {
    return std::any_of(channels_.begin(), channels_.end(),
                       [](const Channel& channel) { return channel.has_seams(); });
  }
  /// Does it take longer to see what these channels add to a pair than to cost its state alone, so
  /// that the state is looked at first where that may be enough?
  bool are_costly() const {
    std::size_t components = 0;
    for (const Channel& channel : channels_)
      components += channel.components();
    return components > 4 || have_seams();
  }
  /// Returns the seams of the current channels.
  ChannelSeams seams() const { return {complex_, channels_}; }
  /// With the values of the result.
  ChannelsLeft take() {
    for (Channel& channel : channels_)
      channel.resolve(geometry_.positions(), complex_);
    return {std::move(channels_), std::move(reverse_channels_)};
  }

  /// Accumulates the current attributes in the states of all vertices. `labels`: of each face; or
  /// empty.
  void accumulate(const Array<Index>& labels, Threads threads) {
    if constexpr (!accumulates_forms<Cost>)
      forms_.assign(geometry_.positions().size(), QuadricForm<3>());
    traces_.assign(geometry_.positions().size(), 0);
    for (Channel& channel : channels_)
      channel.accumulate(
          geometry_.positions(), complex_, labels, weight_of_area,
          [&](Index v, const SymmetricMatrix<3>& matrix) {
            form_at(v).matrix() += matrix;
            traces_[v] += matrix.trace();
          },
          threads);
  }

  /// Constrains charts at their ends, whether a surface has seams of other kinds or not: a boundary
  /// of the surface constrains no chart if there is no seam. After this, pairs can be costed.
  void constrain_boundaries(const LinkCondition& link_condition, const Array<Index>& labels,
                            bool has_other_seams) {
    for (Channel& channel : channels_) {
      constrain_boundaries(channel, link_condition, labels, has_other_seams);
      channel.find_plain_vertices(complex_.vertex_capacity());
    }
  }

  /// Adds the cost of the attributes of a pair, so that the cost of the pair includes it.
  QUADRILLE_ALWAYS_INLINE void add_to(PairOf<Cost>& pair, Index a, Index b) const {
    if constexpr (accumulates_forms<Cost>)
      add_joins(pair.state, contracted(a, b));
    else if constexpr (sees_forms<Cost>)
      pair.current.quadric += form(contracted(a, b));
  }

  /// The weight of a pair with what channels add, divided by that of the shape alone: an error is a
  /// distance by the latter.
  double error_factor(const PairOf<Cost>& pair, Index a, Index b) const {
    double weight = 0;
    QuadricForm<3> form;
    if constexpr (accumulates_forms<Cost>) {
      weight = pair.state.trace();
    } else if constexpr (sees_forms<Cost>) {
      weight = pair.current.quadric.trace();
      add_joins(form, contracted(a, b));
    }
    const double joins = trace_of_joins(pair, a, b, form);
    const double of_shape = weight - (traces_[a] + traces_[b] + joins);
    return of_shape > 0 ? weight / of_shape : 1;
  }

  /// The pair of a contraction.
  ContractedPair contracted(Index a, Index b) const {
    return {a, b, geometry_.position(b) - geometry_.position(a), geometry_.is_fixed(a),
            geometry_.is_fixed(b)};
  }

  /// Adds the cost of the joins of a pair, about its first end.
  QUADRILLE_ALWAYS_INLINE void add_joins(QuadricForm<3>& form, const ContractedPair& pair) const {
    for (const Channel& channel : channels_)
      add_joins(channel, pair, form);
  }
  /// Adds the joins of one channel.
  QUADRILLE_ALWAYS_INLINE void add_joins(const Channel& channel, const ContractedPair& pair,
                                         QuadricForm<3>& form) const {
    if (channel.joins_two(pair))
      channel.add_difference(pair.first, pair.second, pair.to_second, form);
    else
      ChannelContraction(channel, complex_, pair).add_joins(form);
  }
  /// Returns the quadric of channels at a vertex, if its state does not contain it.
  const QuadricForm<3>& form(Index v) const { return forms_[v]; }

  /// Would a contraction turn a face over in a texture?
  bool turn_over(const PairStar& star, Index a, Index b, const Position& target) const {
    return std::any_of(channels_.begin(), channels_.end(), [&](const Channel& channel) {
      return channel.constrains_charts() && ChannelContraction(channel, complex_, contracted(a, b))
                                                .turns_over(star, target - geometry_.position(a));
    });
  }

  /// While the faces of the star still have their old corners, and vertices their old places.
  template <class Event>
  void contract(const Event& event) {
    const auto& contraction = event.contraction;
    const ContractedPair pair = contracted(contraction.first(), contraction.second());
    const Position target = contraction.target() - geometry_.position(pair.first);
    QuadricForm<3> joins;
    for (Channel& channel : channels_)
      if (channel.joins_two(pair)) {
        if constexpr (!accumulates_forms<Cost>)
          channel.add_difference(pair.first, pair.second, pair.to_second, joins);
        channel.apply_join(complex_, contraction.star(), pair, event.kept, target);
      } else {
        const ChannelContraction change(channel, complex_, pair);
        change.apply(channel, contraction.star(), event.kept, change.changes(target, joins));
      }
    traces_[event.kept] = traces_[pair.first] + traces_[pair.second] +
                          trace_of_joins(contraction.pair(), pair.first, pair.second, joins);
    if constexpr (!accumulates_forms<Cost>) {
      joins +=
          QuadricForm<3>::sum_about_first(forms_[pair.first], forms_[pair.second], pair.to_second);
      joins.move_origin(target);
      forms_[event.kept] = joins;
    }
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.forms_, self.traces_); }
  /// Leaves out wedges of faces for which is_left is false, and of vertices that are not in an
  /// ascending list.
  template <class IsLeft>
  void pack(const Array<Index>& vertices, IsLeft is_left) {
    for (Channel& channel : channels_)
      channel.pack(vertices, is_left);
  }
  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const {
    for (const Channel& channel : channels_)
      channel.prefetch(v);
    if constexpr (!accumulates_forms<Cost>)
      prefetch_value(forms_, v);
  }

private:
  // How much an area counts for the cost.
  static double weight_of_area(double area) {
    if constexpr (requires { Cost::channel_weight(area); })
      return Cost::channel_weight(area);
    else
      return area;
  }

  void constrain_boundaries(Channel& channel, const LinkCondition& link_condition,
                            const Array<Index>& labels, bool has_other_seams) {
    if (!channel.constrains_charts() ||
        (channel.is_boundary_weight_given() && !(channel.chart_boundary_weight() > 0)))
      return;
    const ChartEnds charts(complex_, link_condition, channel);
    if (!charts.has_seams() && !has_other_seams)
      return;
    if (!channel.is_boundary_weight_given())
      channel.choose_boundary_weight(charts.fraction_of_seams());
    for (const ChartEnd& end : charts.ends())
      constrain_boundary(channel, labels, end);
  }
  // Adds a line constraint in the texture and, if seams are soft constraints, one in the surface as
  // well.
  void constrain_boundary(Channel& channel, const Array<Index>& labels, const ChartEnd& boundary) {
    const Vector<3> along = geometry_.position(boundary.w) - geometry_.position(boundary.v);
    const double area = weight_of_area(squared_length(along));
    const QuadricForm<3> line =
        channel.are_seams_soft()
            ? squared_plane(off(boundary, along), 0, channel.chart_boundary_weight() * area)
            : QuadricForm<3>();
    for (const auto& [end, other] :
         {std::pair(boundary.v, boundary.w), std::pair(boundary.w, boundary.v)}) {
      QuadricForm<3> constrained = line;
      channel.constrain_boundary(complex_, labels, boundary.face, end, other, area, constrained);
      form_at(end) += constrained;
      traces_[end] += constrained.trace();
    }
  }
  // Returns the direction in the face that leads away from its edge, of length 1, or 0 if it is
  // undefined.
  Vector<3> off(const ChartEnd& boundary, const Vector<3>& along) const {
    const auto& corners = complex_.vertices(boundary.face);
    const Vector<3> normal =
        normal_vector(geometry_.position(corners[0]), geometry_.position(corners[1]),
                      geometry_.position(corners[2]));
    const Vector<3> off = cross(along, normal);
    const double squared = squared_length(off);
    return squared > 0 ? (1 / std::sqrt(squared)) * off : Vector<3>();
  }

  QuadricForm<3>& form_at(Index v) {
    if constexpr (accumulates_forms<Cost>)
      return states_[v];
    else
      return forms_[v];
  }

  // Returns the trace of the joins of a pair, which are given if its state does not contain them.
  double trace_of_joins(const PairOf<Cost>& pair, Index a, Index b,
                        const QuadricForm<3>& joins) const {
    if constexpr (accumulates_forms<Cost>)
      return pair.state.trace() - states_[a].trace() - states_[b].trace();
    else
      return joins.trace();
  }

  // All that the attributes of a pair cost, about its first end.
  QuadricForm<3> form(const ContractedPair& pair) const {
    auto form =
        QuadricForm<3>::sum_about_first(forms_[pair.first], forms_[pair.second], pair.to_second);
    add_joins(form, pair);
    return form;
  }

  const TriangleComplex& complex_;
  const Geometry& geometry_;
  VertexStates<Cost>& states_;
  std::vector<Channel> channels_;
  std::vector<std::size_t> reverse_channels_;
  Array<QuadricForm<3>> forms_; // of each vertex, where its state does not contain them
  Array<double> traces_;        // of what channels have left at each vertex
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_H
