#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_POLYGON_TABLE_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_POLYGON_TABLE_H

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The polygons into which the new faces of a star are cut over its old ones, so that a comparison
/// of old faces with new ones need not cut them again: the heights over a polygon are the same from
/// both sides.
class PolygonTable {
public:
  struct Polygon {
    double distance; // the greatest; below 0 where there is none
    double area;     // twice of it, in the plane
  };

  /// More faces would make a large table.
  static constexpr std::size_t most_faces = 64;

  void clear() { size_ = 0; }
  /// Starts with a star of so many faces, none of which has polygons yet.
  void begin(std::size_t faces) {
    clear();
    if (faces > most_faces)
      return;
    size_ = faces;
    polygons_.assign(faces * faces, {-1, 0});
    is_complete_.assign(faces, false);
  }
  bool is_kept() const { return size_ > 0; }

  void put(std::size_t now, std::size_t old, const Polygon& polygon) {
    polygons_[now * size_ + old] = polygon;
  }
  const Polygon& operator()(std::size_t now, std::size_t old) const {
    return polygons_[now * size_ + old];
  }

  /// All polygons of a new face have been added.
  void complete(std::size_t now) { is_complete_[now] = true; }
  bool is_complete(std::size_t now) const { return size_ > 0 && is_complete_[now]; }

private:
  std::size_t size_ = 0;
  std::vector<Polygon> polygons_;
  std::vector<char> is_complete_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_POLYGON_TABLE_H
