#ifndef QUADRILLE_CHANNEL_OPTIONS_H
#define QUADRILLE_CHANNEL_OPTIONS_H

#include <quadrille/internal/core/base/text.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille {

/// Which property of the vertices the attributes are, and so which named parameter they come from.
enum class Attribute {
  any,     ///< quadrille::parameters::vertex_attribute_map
  color,   ///< vertex_color_map; clamped to the range of colours
  texture, ///< vertex_texture_map
  normal   ///< vertex_normal_map; made unit vectors again
};

/// What a simplification does with the edges at which a channel is discontinuous.
enum class Seams {
  kept,   ///< they stay, as a graph in the surface: no chart is torn, merged, or turned over
  soft,   ///< they may vanish, at the price of what that shows: the disagreement of the values, and
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
  /// By default soft for texture coordinates, priced for others.
  std::optional<Seams> seams = {};
  /// How firmly charts of a texture whose seams are kept or soft hold their borders in the texture,
  /// for each square of an edge's length; at least 0. The same along an edge as off it is 1. Where
  /// seams are soft, also how firmly borders hold their place in the surface, by lines as open
  /// borders do, which count 100: 0 is priced, and the higher the more is given up of the shape. By
  /// default 10 where seams are kept. Where they are soft it is 0.0036 / p² for the part p of all
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

/// Labels of the faces (materials, regions, patches), which a simplification keeps, as an argument
/// of `simplify`: `simplify(mesh, Labels{materials}, FaceCount{1000})`. The same with its default
/// is CGAL's named parameter `face_patch_map`.
///
/// `map` is a property map over the faces of a mesh, or over the indices of a soup's triangles, to
/// values that are compared with <. A face that is left keeps its label: in a mesh with its
/// descriptor; of a soup the map is written, so that the labels of the triangles that are left are
/// in front.
///
/// Where topology is kept, the regions of equal labels keep theirs: none is torn, vanishes, or
/// meets another one than before. Edges between two labels and edges of other than two faces are
/// one graph in the surface. Contractions that would change that graph are refused and counted as
/// Rejection::seam; where other than two of its edges meet, the vertex stays. Source: the link
/// condition of a complex with a subcomplex, Vivodtzev, Bonneau and Le Texier 2005.
template <class Map>
struct Labels {
  Map map; ///< from faces, or indices of triangles, to labels
  /// How firmly borders between labels hold their shape, as Quadric::crease_weight; at least 0. For
  /// costs that know creases.
  double border_weight = 1;

  /// Throws std::invalid_argument for a weight that makes no sense.
  void validate() const {
    if (!(border_weight >= 0) || !std::isfinite(border_weight))
      throw std::invalid_argument("quadrille::Labels: border_weight " +
                                  internal::text_of(border_weight) + " is not a weight");
  }
};
template <class Map>
Labels(Map) -> Labels<Map>;
template <class Map>
Labels(Map, double) -> Labels<Map>;

} // namespace quadrille

#endif // QUADRILLE_CHANNEL_OPTIONS_H
