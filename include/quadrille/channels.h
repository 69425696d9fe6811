#ifndef QUADRILLE_CHANNELS_H
#define QUADRILLE_CHANNELS_H

#include <quadrille/internal/base/text.h>

#include <cmath>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

/// What a simplification does with the edges at which a channel is discontinuous.
enum class Seams {
  kept,   ///< they stay, as a graph in the surface: no chart is torn, merged, or turned over
  held,   ///< they may vanish, at the price of what that shows: the disagreement of the values, and
          ///< the area over which faces show what lies beside their chart of a texture. No face is
          ///< turned over in a texture. Of other channels the same as priced
  priced, ///< they may vanish; what that costs is in the error. Wedges stay apart until then
  free    ///< the values around a vertex are one from the beginning: their mean, or the first if
          ///< only existing values may be
};

/// What the corners have whose values a simplification changes.
enum class NewValues {
  optimal,   ///< the values of least cost, between those that there were
  weights,   ///< the same, at least 0 and with the sum 1: weights of a skin
  existing,  ///< of the values that have become one, the closest to the optimal ones: for indices,
             ///< classes and whatever has nothing in between. Not for a Texture
  recomputed ///< of Normals: sums over the faces of the result around the corner, weighted by their
             ///< angles. Corners that a simplification does not touch get them too
};

/// How a channel counts.
struct ChannelOptions {
  /// By how much more than by default it counts; above 0.
  double importance = 1;
  /// Lengths in the mesh's unit that a step of 1 in each component counts as, times importance. By
  /// default, for texture coordinates, √(area of the surface / area of the texture), of each label
  /// by itself, so that a texture that slides counts as it slides; for Attributes 0.02 · (diagonal
  /// of the bounding box) / (largest range of the components). For Colors and Normals that times a
  /// factor of 0.05 to 1, or of 0.1 to 2, by which they come to be half as hard to tell from what
  /// is beside as the shape is, and as hard: what is noise counts little, what is smooth much.
  std::vector<double> weights = {};
  /// By default held for texture coordinates, priced for others.
  std::optional<Seams> seams = {};
  /// How firmly charts of a texture whose seams are kept or held hold their borders in the texture,
  /// for each square of an edge's length; at least 0. The same along an edge as off it is 1. Where
  /// seams are held, also how firmly borders hold their place in the surface, by lines as open
  /// borders do, which count 100: 0 is priced, and the higher the more is given up of the shape. By
  /// default 10 where seams are kept. Where they are held it is 0.0036 / p² for the part p of all
  /// edges that they are, but at most 1, as up to 6 %, and at least 0.1, as from 19 % on.
  std::optional<double> border_weight = {};
  NewValues new_values = NewValues::optimal; ///< what corners have whose values change
  /// Of Colors in sRGB, numbers in [0, 1] or in the whole range of an integral type: they are
  /// averaged as light is, and so are their default weights. Alpha is linear already.
  bool linear_light = false;

  /// Throws std::invalid_argument for an importance or a weight that makes no sense.
  void validate() const {
    const auto require_positive = [](const char* name, double x) {
      if (!(x > 0) || !std::isfinite(x))
        throw std::invalid_argument(std::string("quadrille::ChannelOptions: ") + name + " " +
                                    internal::text_of(x) + " is not above 0 and finite");
    };
    require_positive("importance", importance);
    for (double weight : weights)
      require_positive("a weight", weight);
    if (border_weight && (!(*border_weight >= 0) || !std::isfinite(*border_weight)))
      throw std::invalid_argument("quadrille::ChannelOptions: border_weight " +
                                  internal::text_of(*border_weight) + " is not a weight");
  }
};

/// Values of a channel of a soup with an index triple for each triangle, as in an OBJ file.
template <class Values, class Triples>
struct IndexedValues {
  Values* values;   ///< any container of them, rewritten with the soup
  Triples* triples; ///< three indices of values for each triangle
};

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

} // namespace quadrille

#endif // QUADRILLE_CHANNELS_H
