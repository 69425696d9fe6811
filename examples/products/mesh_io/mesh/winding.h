#ifndef QUADRILLE_EXAMPLES_MESH_IO_WINDING_H
#define QUADRILLE_EXAMPLES_MESH_IO_WINDING_H

/// \file
/// How the faces of a mesh are wound.

#include "indexed_mesh.h"

#include <quadrille/internal/guards/distance/fans_of_star.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Faces hang together by edges of two faces, in pieces each of which can be wound alike, unless it
/// has but one side, as a Möbius strip has. CGAL's orient_polygon_soup() cuts the surface along
/// lines where more than two faces meet; here they stay.
class Winding {
public:
  using Triangles = std::span<const std::array<std::uint32_t, 3>>;

  /// Of triangles of so many points. In O(n log d), where a vertex has d faces.
  Winding(Triangles triangles, std::size_t points) {
    pieces_.reset(triangles.size());
    join_all(triangles, points);
    choose();
  }
  explicit Winding(const IndexedMesh& mesh) : Winding(mesh.triangles, mesh.points.size()) {}

  /// How many faces are wound against the others of their pieces: in each, the fewer.
  std::size_t against() const {
    return static_cast<std::size_t>(std::count(is_against_.begin(), is_against_.end(), true));
  }
  /// Is a face one of them?
  const std::vector<bool>& is_against() const { return is_against_; }
  /// How many pieces have but one side: how their faces are wound is left as it is.
  std::size_t one_sided() const { return one_sided_; }

  /// How many pieces there are, of faces that hang together by edges of two.
  std::size_t pieces() const { return piece_count_; }
  /// How many edges have more than two faces.
  std::size_t crowded_edges() const { return crowded_edges_; }
  /// How many edges have one face.
  std::size_t open_edges() const { return open_edges_; }

  /// Turns those faces, with what their corners have.
  void turn(IndexedMesh& mesh) const {
    for (std::size_t i = 0; i < is_against_.size(); ++i)
      if (is_against_[i])
        for (auto* triples : {&mesh.triangles, &mesh.value_triangles, &mesh.corner_textures.triples,
                              &mesh.corner_normals.triples})
          if (!triples->empty())
            std::swap((*triples)[i][1], (*triples)[i][2]);
  }

private:
  // A face at an edge, which is kept with the lesser of its vertices.
  struct Side {
    std::uint32_t greater, face;
    bool runs_down; // from the greater to the lesser

    bool operator<(const Side& other) const {
      return std::pair(greater, face) < std::pair(other.greater, other.face);
    }
  };

  template <class Visit>
  static void for_each_side(Triangles triangles, Visit visit) {
    for (std::uint32_t face = 0; face < triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t p = triangles[face][i], q = triangles[face][(i + 1) % 3];
        visit((std::min)(p, q), Side{(std::max)(p, q), face, p > q});
      }
  }

  void join_all(Triangles triangles, std::size_t points) {
    std::vector<std::size_t> ends(points + 1, 0); // of the sides of each vertex
    for_each_side(triangles, [&](std::uint32_t lesser, const Side&) { ++ends[lesser + 1]; });
    for (std::size_t v = 1; v < ends.size(); ++v)
      ends[v] += ends[v - 1];
    std::vector<Side> sides(3 * triangles.size());
    std::vector<std::size_t> next(ends.begin(), ends.end() - 1);
    for_each_side(triangles,
                  [&](std::uint32_t lesser, const Side& s) { sides[next[lesser]++] = s; });
    for (std::size_t v = 0; v + 1 < ends.size(); ++v)
      join(sides.begin() + static_cast<std::ptrdiff_t>(ends[v]),
           sides.begin() + static_cast<std::ptrdiff_t>(ends[v + 1]));
  }

  // At the edges that are kept with one vertex.
  template <class Iterator>
  void join(Iterator begin, Iterator end) {
    std::sort(begin, end);
    for (Iterator next; begin != end; begin = next) {
      next = std::find_if(begin, end, [&](const Side& s) { return s.greater != begin->greater; });
      if (next - begin == 2)
        join(begin[0], begin[1]);
      crowded_edges_ += next - begin > 2;
      open_edges_ += next - begin == 1;
    }
  }

  // Faces wound alike have their common edge in opposite directions.
  void join(const Side& s, const Side& t) {
    if (!pieces_.join(s.face, t.face, s.runs_down != t.runs_down))
      contradictions_.push_back(s.face);
  }

  void choose() {
    struct Chunk {
      std::array<std::size_t, 2> faces{}; // wound as its first face, or the other way
      bool is_one_sided = false;
    };
    std::vector<Chunk> pieces(pieces_.size()); // by its first face
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const auto [first, is_turned] = pieces_.first_of(i);
      ++pieces[first].faces[is_turned];
    }
    for (const std::uint32_t face : contradictions_)
      pieces[pieces_.first_of(face).face].is_one_sided = true;
    for (const Chunk& piece : pieces) {
      one_sided_ += piece.is_one_sided;
      piece_count_ += piece.faces[0] > 0;
    }
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const auto [first, is_turned] = pieces_.first_of(i);
      const Chunk& piece = pieces[first];
      const bool is_fewer = piece.faces[1] > piece.faces[0] ? !is_turned : is_turned;
      is_against_.push_back(is_fewer && !piece.is_one_sided);
    }
  }

  quadrille::internal::OrientedComponents pieces_;
  std::vector<std::uint32_t> contradictions_; // a face of a piece of one side, for each
  std::vector<bool> is_against_;
  std::size_t one_sided_ = 0, piece_count_ = 0, crowded_edges_ = 0, open_edges_ = 0;
};

} // namespace quadrille_examples

#endif
