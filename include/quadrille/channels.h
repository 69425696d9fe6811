#ifndef QUADRILLE_CHANNELS_H
#define QUADRILLE_CHANNELS_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/attributes/channel_map.h>
#include <quadrille/internal/attributes/channel_teller.h>
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
/// Attributes of a surface as *channels*, which any cost in space takes along and counts, any
/// number of them at once, each with seams of its own:
///
/// ```cpp
/// simplify(mesh, FaceRatio{0.1}, Texture{uv});
/// simplify<MemorylessQuadric>(mesh, Texture{uv0}, Texture{uv1, {.importance = 0.3}},
///                             Normals{normals}, Labels{materials});
/// simplify(points, triangles, Texture{uvs, uv_triangles});          // as in an OBJ file
/// simplify(points, triangles, SplitVertices{}, Texture{uvs}, Normals{normals}); // as in glTF
/// ```
///
/// Positions stay one for each vertex, so no seam can tear. The values at a corner (a face at one
/// of its vertices) are those of a *wedge*: corners of one value around a vertex that are connected
/// by edges. A channel of one value a vertex has one wedge a vertex.
///
/// Source: Hoppe, New Quadric Metric for Simplifying Meshes with Appearance Attributes, 1999: the
/// quadric of a wedge with its attributes eliminated, which leaves sums of squares in space.

namespace quadrille {

namespace internal {

template <class T>
concept NotOptions = !std::same_as<T, ChannelOptions>;

/// What the kinds of channels have in common. A source is a property map, or IndexedValues.
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

/// Texture coordinates of two components, as an argument of `simplify`.
///
/// Of a property map `Texture{map}`: over the vertices or the halfedges of a mesh (told by the key;
/// a halfedge stands for the corner of its face at the vertex that it points to), or over the
/// indices of a soup's points. Of a soup with index triples, as in an OBJ file,
/// `Texture{values, triples}`: vectors, which are rewritten with the soup, so that values that
/// nothing uses any more are gone. What a value may be: see AttributeQuadric's maps.
///
/// A contraction that would turn a face over in the texture is refused and counted as
/// Rejection::texture, unless seams are priced or free. Where they are kept, one that would tear or
/// merge charts, or make their borders meet elsewhere, is refused as Rejection::seam. Edges where
/// the texture is mirrored are seams too. Coordinates that change stay in the range of those that
/// there were.
template <class Source>
struct Texture : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Texture(Map, ChannelOptions = {}) -> Texture<Map>;
template <class Values, internal::NotOptions Triples>
Texture(Values&, Triples&, ChannelOptions = {}) -> Texture<IndexedValues<Values, Triples>>;

/// Normals of three components; those that change get unit length. Otherwise as Texture.
template <class Source>
struct Normals : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Normals(Map, ChannelOptions = {}) -> Normals<Map>;
template <class Values, internal::NotOptions Triples>
Normals(Values&, Triples&, ChannelOptions = {}) -> Normals<IndexedValues<Values, Triples>>;

/// Colours of three components, or of four with alpha; those that change stay in the range of those
/// that there were, or in [0, 1] where these lie there. Otherwise as Texture.
template <class Source>
struct Colors : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Colors(Map, ChannelOptions = {}) -> Colors<Map>;
template <class Values, internal::NotOptions Triples>
Colors(Values&, Triples&, ChannelOptions = {}) -> Colors<IndexedValues<Values, Triples>>;

/// Anything else of as many components as the type of the values tells: weights of a skin, heat, a
/// second channel of anything. Otherwise as Texture.
template <class Source>
struct Attributes : internal::ChannelArgument<Source> {
  using internal::ChannelArgument<Source>::ChannelArgument;
};
template <class Map>
Attributes(Map, ChannelOptions = {}) -> Attributes<Map>;
template <class Values, internal::NotOptions Triples>
Attributes(Values&, Triples&, ChannelOptions = {}) -> Attributes<IndexedValues<Values, Triples>>;

/// An argument of `simplify` for a soup whose vertices are split at seams, as the buffers of a
/// renderer: points at exactly the same place are one vertex, and are told apart by the channels.
/// Points that are left keep their order; there may be as many at a place as there are combinations
/// of wedges.
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

/// The channel of a named parameter as a tuple, if it is given.
template <template <class> class Channel, class Named, class Tag>
auto channel_of(const Named& named, Tag tag) {
  const auto map = CGAL::parameters::get_parameter(named, tag);
  if constexpr (is_given<decltype(map)>)
    return std::tuple(Channel<std::remove_const_t<decltype(map)>>(map));
  else
    return std::tuple();
}

/// Attributes that are named parameters as channels with defaults.
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
