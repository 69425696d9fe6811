#ifndef QUADRILLE_INTERNAL_FILE_VERTEX_SCALARS_H
#define QUADRILLE_INTERNAL_FILE_VERTEX_SCALARS_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/file/chunk_adapter.h>
#include <quadrille/internal/file/ply_header.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The least and the greatest value of each scalar.
struct ScalarRanges {
  std::vector<double> low, high;

  void add(std::span<const double> values) {
    low.resize(values.size(), (std::numeric_limits<double>::max)());
    high.resize(values.size(), std::numeric_limits<double>::lowest());
    for (std::size_t i = 0; i < values.size(); ++i) {
      low[i] = (std::min)(low[i], values[i]);
      high[i] = (std::max)(high[i], values[i]);
    }
  }
};

/// The numbers of a PLY file's vertices in addition to their positions, in the order of the file,
/// and their grouping into channels, whose numbers are simplified together. A colour, a normal and
/// the coordinates of a texture are each one channel, and so is each other number by itself.
class VertexScalars {
public:
  /// The number of channels is limited, since each takes time and memory.
  static constexpr std::size_t most_channels = 64;

  VertexScalars() = default;
  explicit VertexScalars(std::vector<PlyProperty> properties) : properties_(std::move(properties)) {
    std::vector<bool> is_taken(properties_.size());
    take(is_taken, {"red", "green", "blue", "alpha"}, 3, Kind::weighty);
    take(is_taken, {"nx", "ny", "nz"}, 3, Kind::normal);
    take(is_taken, {"s", "t"}, 2, Kind::weighty);
    take(is_taken, {"u", "v"}, 2, Kind::weighty);
    take(is_taken, {"texture_u", "texture_v"}, 2, Kind::weighty);
    for (std::size_t i = 0; i < properties_.size(); ++i)
      if (!is_taken[i])
        channels_.push_back({{i}, properties_[i].type.is_integer ? Kind::integer : Kind::number});
  }

  bool empty() const { return properties_.empty(); }
  std::size_t size() const { return properties_.size(); }
  std::size_t channels() const { return channels_.size(); }
  const std::vector<PlyProperty>& properties() const { return properties_; }
  /// Returns the index in a row of a number that is a channel by itself, if there is one of that
  /// name.
  std::optional<std::size_t> place_of(std::string_view name) const {
    for (const Channel& channel : channels_)
      if (channel.is_scalar() && properties_[channel.properties.front()].name == name)
        return channel.properties.front();
    return std::nullopt;
  }
  /// The comments of the file that name the pictures of texture coordinates.
  const std::vector<std::string>& textures() const { return textures_; }
  void set_textures(std::vector<std::string> textures) { textures_ = std::move(textures); }
  /// The index in a row of the number that is the tolerance of a vertex: see ToleranceLimit.
  std::optional<std::size_t> tolerance() const { return tolerance_; }
  void set_tolerance(std::string_view name) { tolerance_ = place_of(name); }

  /// Returns the channels in the engine's form, from rows of size() values. `diagonal` is the
  /// diagonal of the whole surface: with the ranges it determines the weight of a channel, so that
  /// it counts equally in all chunks.
  ChunkChannels channels(const std::vector<double>& values, const ScalarRanges& ranges,
                         double diagonal, double importance) const {
    ChunkChannels result;
    for (const Channel& channel : channels_) {
      ChunkChannel& to = result.channels.emplace_back();
      to.components = channel.properties.size();
      to.options.importance = importance * (channel.is_scalar() ? scalar_importance : 1);
      to.options.weights.assign(to.components, weight(channel, ranges, diagonal));
      if (channel.kind == Kind::integer)
        to.options.new_values = NewValues::existing;
      to.values.reserve(values.size() / size() * to.components);
      for (std::size_t row = 0; row < values.size(); row += size())
        for (const std::size_t property : channel.properties)
          to.values.push_back(values[row + property]);
    }
    return result;
  }

  /// Returns rows for the remaining vertices of a chunk, from the channels that it has then: values
  /// in their ranges, and new normals of unit length. `vertices` gives the row of `before` that
  /// each vertex had.
  std::vector<double> rows(const std::vector<std::vector<double>>& channels,
                           const std::vector<Index>& vertices, const std::vector<double>& before,
                           const ScalarRanges& ranges) const {
    std::vector<double> result(vertices.size() * size());
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const Channel& channel = channels_[c];
      const std::size_t components = channel.properties.size();
      for (std::size_t row = 0; row < vertices.size(); ++row) {
        bool is_new = false;
        for (std::size_t i = 0; i < components; ++i) {
          const std::size_t p = channel.properties[i];
          double& value = result[row * size() + p];
          value = std::clamp(channels[c][row * components + i], ranges.low[p], ranges.high[p]);
          is_new = is_new || value != before[vertices[row] * size() + p];
        }
        if (is_new && channel.kind == Kind::normal)
          normalize(channel, result.data() + row * size());
      }
    }
    return result;
  }

private:
  static constexpr double scalar_importance = 1. / 64; // they may be noise

  enum class Kind { weighty, normal, number, integer };
  struct Channel {
    std::vector<std::size_t> properties;
    Kind kind;

    bool is_scalar() const { return kind == Kind::number || kind == Kind::integer; }
  };

  // The first `least` of the names must exist.
  void take(std::vector<bool>& is_taken, std::initializer_list<std::string_view> names,
            std::size_t least, Kind kind) {
    Channel channel{{}, kind};
    for (const std::string_view name : names) {
      const auto found = std::find_if(properties_.begin(), properties_.end(),
                                      [&](const PlyProperty& p) { return p.name == name; });
      if (found != properties_.end())
        channel.properties.push_back(static_cast<std::size_t>(found - properties_.begin()));
      else if (channel.properties.size() < least)
        return;
    }
    for (const std::size_t i : channel.properties)
      is_taken[i] = true;
    channels_.push_back(std::move(channel));
  }

  static void normalize(const Channel& channel, double* row) {
    double square = 0;
    for (const std::size_t p : channel.properties)
      square += row[p] * row[p];
    for (const std::size_t p : channel.properties)
      row[p] = square > 0 ? row[p] / std::sqrt(square) : row[p];
  }

  // The largest range counts as a fiftieth of the diagonal, as in ChannelOptions.
  static double weight(const Channel& channel, const ScalarRanges& ranges, double diagonal) {
    double range = 0;
    for (const std::size_t p : channel.properties)
      range = (std::max)(range, ranges.high[p] - ranges.low[p]);
    const double length = diagonal > 0 ? 0.02 * diagonal : 1;
    return range > 0x1p-150 ? length / range : length;
  }

  std::vector<PlyProperty> properties_;
  std::vector<Channel> channels_;
  std::vector<std::string> textures_;
  std::optional<std::size_t> tolerance_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_VERTEX_SCALARS_H
