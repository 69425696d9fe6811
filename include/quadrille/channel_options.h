#ifndef QUADRILLE_CHANNEL_OPTIONS_H
#define QUADRILLE_CHANNEL_OPTIONS_H

#include <quadrille/internal/core/base/text.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille {

/// The property of the vertices that the attributes are; it decides which named parameter they come
/// from.
enum class Attribute {
  any,     ///< quadrille::parameters::vertex_attribute_map
  color,   ///< vertex_color_map; clamped to the range of colours
  texture, ///< vertex_texture_map
  normal   ///< vertex_normal_map; made unit vectors again
};

/// The treatment of the edges at which a channel is discontinuous.
enum class Seams {
  kept,   ///< they stay, as a graph in the surface: no chart is torn, merged, or flipped
  soft,   ///< they may vanish, at a cost for the visible damage: the difference of the values, and
          ///< the area over which faces show texture outside of their chart. No face is flipped in
          ///< a texture. Channels other than textures are treated as with priced
  priced, ///< they may vanish; the cost includes the error. Wedges stay apart until then
  free    ///< the values around a vertex are merged from the start: into their mean, or the first
          ///< one if only existing values are allowed
};

/// The way in which the values of changed corners are computed.
enum class NewValues {
  optimal,   ///< the values of least cost, within the range of the existing values
  weights,   ///< as optimal, but non-negative and with the sum 1: weights of a skin
  existing,  ///< the one of the merged values that is closest to the optimum: for indices, classes
             ///< and anything that cannot be interpolated. Not for a Texture
  recomputed ///< for Normals: the angle-weighted sum over the faces of the result around the
             ///< corner. Corners that the simplification does not touch are recomputed too
};

/// Options that say how a channel counts.
struct ChannelOptions {
  /// The factor on the default importance of the channel; above 0.
  double importance = 1;
  /// The length in the mesh's unit that a step of 1 in each component counts as, times importance.
  /// The default for texture coordinates is √(area of the surface / area of the texture), for each
  /// label separately, so that a texture that slides counts by the distance it slides. The default
  /// for Attributes is 0.02 · (diagonal of the bounding box) / (largest range of the components).
  /// For Colors and Normals this is multiplied by a factor of 0.05 to 1, or of 0.1 to 2, so that
  /// colours become half as hard to predict from their surroundings as the shape is, and normals as
  /// hard: noise counts little, smooth values much.
  std::vector<double> weights = {};
  /// By default soft for texture coordinates, priced for others.
  std::optional<Seams> seams = {};
  /// The weight of chart boundaries in the texture, for kept or soft seams, per squared edge
  /// length; at least 0. With 1 a deviation along an edge counts as much as one across it. For soft
  /// seams it is also the weight of chart boundaries in the surface, whose lines are constrained as
  /// those of open boundaries are, which count 100: 0 is the same as priced, and higher values give
  /// up more of the shape. The default is 10 for kept seams. For soft seams it is 0.0036 / p²,
  /// where p is the fraction of all edges that are seams, but at most 1 (reached at 6 % and below)
  /// and at least 0.1 (reached at 19 % and above).
  std::optional<double> chart_boundary_weight = {};
  NewValues new_values = NewValues::optimal; ///< the values of changed corners
  /// True for Colors in sRGB, as numbers in [0, 1] or in the whole range of an integral type: they
  /// are averaged as linear light, and so are their default weights. Alpha is always linear.
  bool linear_light = false;

  /// Throws std::invalid_argument for an importance or a weight that is out of range.
  void validate() const {
    const auto require_positive = [](const char* name, double x) {
      if (!(x > 0) || !std::isfinite(x))
        throw std::invalid_argument(std::string("quadrille::ChannelOptions: ") + name + " " +
                                    internal::text_of(x) + " is not above 0 and finite");
    };
    require_positive("importance", importance);
    for (double weight : weights)
      require_positive("a weight", weight);
    if (chart_boundary_weight &&
        (!(*chart_boundary_weight >= 0) || !std::isfinite(*chart_boundary_weight)))
      throw std::invalid_argument("quadrille::ChannelOptions: chart_boundary_weight " +
                                  internal::text_of(*chart_boundary_weight) +
                                  " is negative or not finite");
  }
};

/// The values of a channel of a soup, with an index triple for each triangle, as in an OBJ file.
template <class Values, class Triples>
struct IndexedValues {
  Values* values;   ///< any container of the values; it is rewritten with the soup
  Triples* triples; ///< three indices of values for each triangle
};

/// Labels of the faces (materials, regions, patches), which a simplification preserves. They are an
/// argument of `simplify`: `simplify(mesh, Labels{materials}, FaceCount{1000})`. CGAL's named
/// parameter `face_patch_map` has the same effect with the default weight.
///
/// `map` is a property map over the faces of a mesh, or over the indices of a soup's triangles, to
/// values that are compared with <. A face that is left keeps its label: in a mesh it keeps its
/// descriptor; in a soup the map is written, so that the labels of the remaining triangles come
/// first.
///
/// If topology is kept, the regions of equal labels keep their topology: none is torn or
/// vanishes, and no two regions meet that did not. Edges between two labels, and edges that do not
/// have exactly two faces, form one graph in the surface. Contractions that would change this graph
/// are rejected and counted as Rejection::seam; a vertex stays where the number of its edges in the
/// graph is not two. Source: the link condition of a complex with a subcomplex, Vivodtzev, Bonneau
/// and Le Texier 2005.
template <class Map>
struct Labels {
  Map map; ///< from faces, or indices of triangles, to labels
  /// The weight of the boundaries between labels, as Quadric::crease_weight; at least 0. It applies
  /// to costs with crease terms.
  double region_boundary_weight = 1;

  /// Throws std::invalid_argument for a weight that is negative or not finite.
  void validate() const {
    if (!(region_boundary_weight >= 0) || !std::isfinite(region_boundary_weight))
      throw std::invalid_argument("quadrille::Labels: region_boundary_weight " +
                                  internal::text_of(region_boundary_weight) +
                                  " is negative or not finite");
  }
};
template <class Map>
Labels(Map) -> Labels<Map>;
template <class Map>
Labels(Map, double) -> Labels<Map>;

} // namespace quadrille

#endif // QUADRILLE_CHANNEL_OPTIONS_H
