#include <quadrille/compiled/soup_channel_map.h>

#include <quadrille/internal/core/adapter/linear_light.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

namespace {

std::string number_of(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what;
}

Attribute attribute_of(SoupChannelView::Kind kind) {
  switch (kind) {
  case SoupChannelView::Kind::texture:
    return Attribute::texture;
  case SoupChannelView::Kind::normals:
    return Attribute::normal;
  case SoupChannelView::Kind::colors:
    return Attribute::color;
  default:
    return Attribute::any;
  }
}

} // namespace

void SoupChannelMap::validate(const std::string& name, std::size_t points,
                              std::size_t triangles) const {
  const auto require = [&](bool is_right, const std::string& what) {
    if (!is_right)
      throw std::invalid_argument("quadrille::simplified_soup: " + name + " " + what);
  };
  const auto [kind, size, values, triples, options] = channel_;
  const bool has_right_size = kind == Kind::texture   ? size == 2
                              : kind == Kind::normals ? size == 3
                              : kind == Kind::colors  ? size == 3 || size == 4
                                                      : size > 0;
  require(has_right_size,
          "has " + number_of(size, "components") + ", which its kind does not allow");
  require(values.size() % size == 0, "has " + number_of(values.size(), "numbers") +
                                         ", which is not a multiple of " +
                                         number_of(size, "components"));
  if (is_indexed())
    require(triples.size() == triangles, "has index triples for " +
                                             number_of(triples.size(), "triangles") + " of " +
                                             std::to_string(triangles));
  else if (triangles > 0) // otherwise it is unknown whether the channel is over points
    require(value_count() == points,
            "has " + number_of(value_count(), "values") + " for " + number_of(points, "points"));
  require(options.weights.empty() || options.weights.size() == size,
          "has " + number_of(size, "components") + " and " +
              number_of(options.weights.size(), "weights"));
  require(options.new_values != NewValues::existing || kind != Kind::texture,
          "is a texture, which NewValues::existing would tear apart");
  require(options.new_values != NewValues::recomputed || kind == Kind::normals,
          "does not contain normals, which NewValues::recomputed needs");
  require(options.new_values != NewValues::weights || kind == Kind::attributes,
          "does not contain attributes, which NewValues::weights needs");
  require(!options.linear_light || kind == Kind::colors,
          "does not contain colours, which linear_light needs");
}

ChannelInput SoupChannelMap::input(Arena& arena) const {
  ChannelInput input(channel_.options, channel_.components, attribute_of(channel_.kind), arena);
  input.values.reserve(channel_.values.size());
  for (std::size_t i = 0; i < channel_.values.size(); ++i)
    input.values.push_back(counted(channel_.values[i], i % channel_.components));
  return input;
}

void SoupChannelMap::end_of_reading(ChannelInput& input,
                                    const Array<TriangleComplex::Triangle>& triangles) {
  input.require_finite();
  low_.assign(channel_.components, (std::numeric_limits<double>::max)());
  high_.assign(channel_.components, std::numeric_limits<double>::lowest());
  for (const auto& triple : input.corners.empty() ? triangles : input.corners)
    for (Index value : triple)
      for (std::size_t c = 0; c < channel_.components; ++c) {
        low_[c] = (std::min)(low_[c], input.value(value, c));
        high_[c] = (std::max)(high_[c], input.value(value, c));
      }
  if (channel_.kind == Kind::colors && *std::min_element(low_.begin(), low_.end()) >= 0 &&
      *std::max_element(high_.begin(), high_.end()) <= 1) {
    low_.assign(channel_.components, 0);
    high_.assign(channel_.components, 1);
  }
  input.as_written = [map = *this](std::span<double> values, bool has_changed) {
    if (has_changed && !map.bring_in_range(values))
      return false;
    for (std::size_t c = 0; c < values.size(); ++c)
      values[c] = map.of_user(values[c], c);
    return true;
  };
}

void SoupChannelMap::append(std::span<const double> components, bool is_new, Index old,
                            std::vector<double>& values) const {
  const std::span<const double> before = raw(old);
  bool is_same = true;
  for (std::size_t c = 0; c < components.size(); ++c)
    is_same = is_same && counted(before[c], c) == components[c];
  std::vector<double> value(components.begin(), components.end());
  if (is_same || (is_new && !bring_in_range(value)))
    values.insert(values.end(), before.begin(), before.end());
  else
    for (std::size_t c = 0; c < value.size(); ++c)
      values.push_back(std::clamp(of_user(value[c], c), std::numeric_limits<double>::lowest(),
                                  (std::numeric_limits<double>::max)()));
}

double SoupChannelMap::counted(double number, std::size_t component) const {
  return channel_.options.linear_light && component < 3 ? light_of_srgb(number) : number;
}

double SoupChannelMap::of_user(double number, std::size_t component) const {
  return channel_.options.linear_light && component < 3 ? srgb_of_light(number) : number;
}

bool SoupChannelMap::bring_in_range(std::span<double> value) const {
  if (channel_.options.new_values == NewValues::weights) {
    double sum = 0;
    for (double& weight : value)
      sum += weight = (std::max)(weight, 0.0);
    if (!(sum > 0))
      return false;
    for (double& weight : value)
      weight *= 1 / sum;
  } else if (channel_.kind == Kind::colors || channel_.kind == Kind::texture) {
    for (std::size_t c = 0; c < value.size(); ++c)
      value[c] = std::clamp(value[c], low_[c], high_[c]);
  } else if (channel_.kind == Kind::normals) {
    const double squared = squared_length(Vector<3>{{value[0], value[1], value[2]}});
    if (!(squared > 0))
      return false;
    for (double& x : value)
      x *= 1 / std::sqrt(squared);
  }
  return true;
}

} // namespace quadrille::internal
