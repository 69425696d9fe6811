// SPDX-License-Identifier: MIT
//
// Quadrille: attributes as channels, whose seams stay in the surface, and in quadrics of more
// dimensions, for which vertices are split at seams.

#include "contender.h"
#include "model.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/channels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <utility>

namespace bench {
namespace {

template <std::size_t M>
using Values = std::vector<std::array<double, M>>;

template <std::size_t M>
Values<M> to_arrays(const Attributes& attributes) {
  Values<M> values(attributes.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    std::copy_n(&attributes.values[i * M], M, values[i].begin());
  return values;
}

template <std::size_t M>
void from_arrays(const Values<M>& values, Attributes& attributes) {
  attributes.values.clear();
  for (const auto& value : values)
    attributes.values.insert(attributes.values.end(), value.begin(), value.end());
}

/// The part of a stopwatch's time that is not conversion.
double own_seconds(const quadrille::Report& report, double seconds) {
  const auto& parts = report.seconds; // of wall clock time
  return (parts.prepare + parts.contract) / parts.total() * seconds;
}

template <std::size_t M, class Simplify>
double simplify_values(Soup& soup, Simplify simplify) {
  Values<M> values = to_arrays<M>(soup.attributes);
  const Stopwatch stopwatch;
  const quadrille::Report report = simplify(values);
  const double seconds = own_seconds(report, stopwatch.seconds());
  from_arrays(values, soup.attributes);
  return seconds;
}

template <class Cost, class Order>
auto with_channels(const Order& order) {
  return [order](Soup& soup, const AttributeTask& task) -> std::optional<double> {
    using namespace quadrille;
    const ChannelOptions options{.importance = task.factor};
    Triangles& corners = soup.attributes.triangles;
    const auto run = [&](const auto& channel) {
      return simplify<Cost>(soup.points, soup.triangles, FaceCount{task.faces}, order, channel);
    };
    if (task.kind == Kind::texture)
      return simplify_values<2>(soup, [&](auto& values) {
        return run(Texture{values, corners, options});
      });
    return simplify_values<3>(soup, [&](auto& values) {
      return run(Colors{values, corners, options});
    });
  };
}

/// Of split vertices.
std::optional<double> with_attribute_quadric(Soup& soup, const AttributeTask& task) {
  using namespace quadrille;
  split_points(soup);
  const double weight = task.weight;
  const double seconds =
      task.kind == Kind::texture
          ? simplify_values<2>(
                soup,
                [&](auto& values) {
                  return simplify(
                      soup.points, soup.triangles,
                      TextureQuadric{.weights = Vector<2>{{weight, weight}}}, FaceCount{task.faces},
                      CGAL::parameters::vertex_texture_map(CGAL::make_property_map(values)));
                })
          : simplify_values<3>(soup, [&](auto& values) {
              return simplify(soup.points, soup.triangles,
                              ColorQuadric{.weights = Vector<3>{{weight, weight, weight}}},
                              FaceCount{task.faces},
                              CGAL::parameters::vertex_color_map(CGAL::make_property_map(values)));
            });
  soup.attributes.triangles = soup.triangles;
  return seconds;
}

} // namespace

std::vector<AttributeContender> our_attribute_contenders() {
  using namespace quadrille;
  return {{"Quadrille channels",
           "Quadric, GreedyOrder, Texture with seams kept or Colors",
           {1},
           with_channels<Quadric>(GreedyOrder{})},
          {"Quadrille channels memoryless",
           "MemorylessQuadric, GreedyOrder, Texture with seams kept or Colors",
           {1},
           with_channels<MemorylessQuadric>(GreedyOrder{})},
          {"Quadrille channels relaxed",
           "Quadric, RelaxedOrder{}, Texture with seams kept or Colors",
           {1},
           with_channels<Quadric>(RelaxedOrder{})},
          {"Quadrille attribute quadric",
           "TextureQuadric or ColorQuadric, GreedyOrder; vertices are split at seams", peer_factors,
           with_attribute_quadric}};
}

} // namespace bench
