#ifndef QUADRILLE_LABELS_H
#define QUADRILLE_LABELS_H

#include <quadrille/internal/core/base/text.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace quadrille {

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

#endif // QUADRILLE_LABELS_H
