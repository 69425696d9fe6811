#ifndef QUADRILLE_ATTRIBUTE_H
#define QUADRILLE_ATTRIBUTE_H

namespace quadrille {

/// Which property of the vertices the attributes are, and so which named parameter they come from.
enum class Attribute {
  any,     ///< quadrille::parameters::vertex_attribute_map
  color,   ///< vertex_color_map; clamped to the range of colours
  texture, ///< vertex_texture_map
  normal   ///< vertex_normal_map; made unit vectors again
};

} // namespace quadrille

#endif // QUADRILLE_ATTRIBUTE_H
