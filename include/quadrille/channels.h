#ifndef QUADRILLE_CHANNELS_H
#define QUADRILLE_CHANNELS_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/attributes/channel_map.h>
#include <quadrille/internal/attributes/channel_writer.h>
#include <quadrille/internal/attributes/channels.h>
#include <quadrille/internal/attributes/face_graph_channels.h>
#include <quadrille/internal/attributes/soup_channels.h>
#include <quadrille/internal/attributes/split_soup_adapter.h>
#include <quadrille/internal/attributes/two_channel_forms.h>
#include <quadrille/internal/core/base/attribute_values.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>

/// \file
/// Attributes of a surface as *channels*. Any cost in space carries them and includes them in
/// its error. There may be any number of them at once, each with its own seams:
///
/// ```cpp
/// simplify(mesh, FaceRatio{0.1}, Texture{uv});
/// simplify<MemorylessQuadric>(mesh, Texture{uv0}, Texture{uv1, {.importance = 0.3}},
///                             Normals{normals}, Labels{materials});
/// simplify(points, triangles, Texture{uvs, uv_triangles});          // as in an OBJ file
/// simplify(points, triangles, SplitVertices{}, Texture{uvs}, Normals{normals}); // as in glTF
/// ```
///
/// Each vertex keeps a single position, so no seam can tear. The values at a corner (a face at one
/// of its vertices) are those of a *wedge*: corners around a vertex that share one value and are
/// connected by edges. A channel with one value per vertex has one wedge per vertex.
///
/// Source: Hoppe, New Quadric Metric for Simplifying Meshes with Appearance Attributes, 1999: the
/// quadric of a wedge with its attributes eliminated, which leaves sums of squares in space.

namespace quadrille {

namespace internal {

template <class T>
concept NotOptions = !std::same_as<T, ChannelOptions>;

/// The common base of the kinds of channels. A source is a property map, or IndexedValues.
template <class Source_>
struct ChannelArgument {
  using Source = Source_;

  explicit ChannelArgument(Source map, ChannelOptions given = {})
      : source(std::move(map)), options(std::move(given)) {}
  template <class Values, NotOptions Triples>
  ChannelArgument(Values& values, Triples& triples, ChannelOptions given = {})
      : source{&values, &triples}, options(std::move(given)) {}

  void validate() const { options.validate(); }

  Source source;
  ChannelOptions options;
};

} // namespace internal

/// Two-component texture coordinates, as an argument of `simplify`.
///
/// `Texture{map}` takes a property map over the vertices or the halfedges of a mesh (the key type
/// decides; a halfedge stands for the corner of its face at its target vertex), or over the indices
/// of a soup's points. `Texture{values, triples}` is for a soup with index triples, as in an OBJ
/// file: both are vectors that are rewritten with the soup, and unused values are removed.
/// AttributeQuadric's maps document the accepted value types.
///
/// A contraction that would flip a face in the texture is rejected and counted as
/// Rejection::texture, unless seams are priced or free. Where seams are kept, a contraction that
/// would tear or merge charts, or make chart boundaries meet elsewhere, is rejected as
/// Rejection::seam. Edges where the texture is mirrored are seams too. Changed coordinates stay in
/// the range of the original ones.
template <class Source>
struct Texture : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Texture(Map, ChannelOptions = {}) -> Texture<Map>;
template <class Values, internal::NotOptions Triples>
Texture(Values&, Triples&, ChannelOptions = {}) -> Texture<IndexedValues<Values, Triples>>;

/// Three-component normals; changed normals get unit length. Otherwise as Texture.
template <class Source>
struct Normals : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Normals(Map, ChannelOptions = {}) -> Normals<Map>;
template <class Values, internal::NotOptions Triples>
Normals(Values&, Triples&, ChannelOptions = {}) -> Normals<IndexedValues<Values, Triples>>;

/// Colours of three components, or of four with alpha. Changed colours stay in the range of the
/// original ones, or in [0, 1] if the original ones lie there. Otherwise as Texture.
template <class Source>
struct Colors : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Colors(Map, ChannelOptions = {}) -> Colors<Map>;
template <class Values, internal::NotOptions Triples>
Colors(Values&, Triples&, ChannelOptions = {}) -> Colors<IndexedValues<Values, Triples>>;

/// Any other attribute, with as many components as its value type has: weights of a skin, heat, a
/// second channel of any kind. Otherwise as Texture.
template <class Source>
struct Attributes : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Attributes(Map, ChannelOptions = {}) -> Attributes<Map>;
template <class Values, internal::NotOptions Triples>
Attributes(Values&, Triples&, ChannelOptions = {}) -> Attributes<IndexedValues<Values, Triples>>;

/// An argument of `simplify` for a soup whose vertices are split at seams, as in a renderer's
/// buffers: points at exactly the same place are one vertex, and the channels distinguish them. The
/// remaining points keep their order; a place may have as many points as there are combinations of
/// wedges.
struct SplitVertices {};

namespace internal {

template <class Source>
inline constexpr bool is_channel<Texture<Source>> = true;
template <class Source>
inline constexpr bool is_channel<Normals<Source>> = true;
template <class Source>
inline constexpr bool is_channel<Colors<Source>> = true;
template <class Source>
inline constexpr bool is_channel<Attributes<Source>> = true;

template <class Source>
struct ChannelKind<Texture<Source>> {
  static constexpr Attribute attribute = Attribute::texture;
  template <class Value>
  static constexpr std::size_t components = 2;
};
template <class Source>
struct ChannelKind<Normals<Source>> {
  static constexpr Attribute attribute = Attribute::normal;
  template <class Value>
  static constexpr std::size_t components = 3;
};
template <class Source>
struct ChannelKind<Colors<Source>> {
  static constexpr Attribute attribute = Attribute::color;
  template <class Value>
  static constexpr std::size_t components = component_count<Value>() == 4 ? 4 : 3;
};
template <class Source>
struct ChannelKind<Attributes<Source>> {
  static constexpr Attribute attribute = Attribute::any;
  template <class Value>
  static constexpr std::size_t components = component_count<Value>();
};

/// Returns the channel of a named parameter as a tuple, which is empty if the parameter is not
/// given.
template <template <class> class Channel, class Named, class Tag>
auto channel_of(const Named& named, Tag tag) {
  const auto map = CGAL::parameters::get_parameter(named, tag);
  if constexpr (is_given<decltype(map)>)
    return std::tuple(Channel<std::remove_const_t<decltype(map)>>(map));
  else
    return std::tuple();
}

/// Makes channels with default options of the attributes that are named parameters.
template <class Named>
struct NamedChannels {
  static auto of(const Named& named) {
    namespace np = CGAL::internal_np;
    return std::tuple_cat(channel_of<Colors>(named, np::vertex_color_map),
                          channel_of<Texture>(named, np::vertex_texture_map),
                          channel_of<Normals>(named, np::vertex_normal_map),
                          channel_of<Attributes>(named, parameters::vertex_attribute));
  }
};

} // namespace internal

} // namespace quadrille

#endif // QUADRILLE_CHANNELS_H
