#ifndef QUADRILLE_EXAMPLES_MESH_IO_WINDING_H
#define QUADRILLE_EXAMPLES_MESH_IO_WINDING_H

/// \file
/// How the faces of a mesh are wound.

#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Faces hang together by edges of two faces, in pieces each of which can be wound alike, unless it
/// has but one side, as a Möbius strip has. CGAL's orient_polygon_soup() cuts the surface along
/// lines where more than two faces meet; here they stay.
class Winding {
public:
  /// In O(n log d), where a vertex has d faces.
  explicit Winding(const IndexedMesh& mesh) : links_(mesh.triangles.size()) {
    for (std::uint32_t i = 0; i < links_.size(); ++i)
      links_[i] = {i, false};
    join_all(mesh);
    choose();
  }

  /// How many faces are wound against the others of their pieces: in each, the fewer.
  std::size_t against() const {
    return static_cast<std::size_t>(std::count(is_against_.begin(), is_against_.end(), true));
  }
  /// How many pieces have but one side: how their faces are wound is left as it is.
  std::size_t one_sided() const { return one_sided_; }

  /// Turns those faces, with what their corners have.
  void turn(IndexedMesh& mesh) const {
    for (std::size_t i = 0; i < is_against_.size(); ++i)
      if (is_against_[i])
        for (auto* triples :
             {&mesh.triangles, &mesh.corner_textures.triples, &mesh.corner_normals.triples})
          if (!triples->empty())
            std::swap((*triples)[i][1], (*triples)[i][2]);
  }

private:
  // To a face of the same piece, at last the first of it; wound the other way?
  struct Link {
    std::uint32_t face;
    bool is_turned;
  };
  // A face at an edge, which is kept with the lesser of its vertices.
  struct Side {
    std::uint32_t greater, face;
    bool runs_down; // from the greater to the lesser

    bool operator<(const Side& other) const {
      return std::pair(greater, face) < std::pair(other.greater, other.face);
    }
  };

  template <class Visit>
  static void for_each_side(const IndexedMesh& mesh, Visit visit) {
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t p = mesh.triangles[face][i], q = mesh.triangles[face][(i + 1) % 3];
        visit((std::min)(p, q), Side{(std::max)(p, q), face, p > q});
      }
  }

  void join_all(const IndexedMesh& mesh) {
    std::vector<std::size_t> ends(mesh.points.size() + 1, 0); // of the sides of each vertex
    for_each_side(mesh, [&](std::uint32_t lesser, const Side&) { ++ends[lesser + 1]; });
    for (std::size_t v = 1; v < ends.size(); ++v)
      ends[v] += ends[v - 1];
    std::vector<Side> sides(3 * mesh.triangles.size());
    std::vector<std::size_t> next(ends.begin(), ends.end() - 1);
    for_each_side(mesh, [&](std::uint32_t lesser, const Side& s) { sides[next[lesser]++] = s; });
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
    }
  }

  // Faces wound alike have their common edge in opposite directions.
  void join(const Side& s, const Side& t) {
    Link first = first_of(s.face), second = first_of(t.face);
    const bool differ = (s.runs_down == t.runs_down) != (first.is_turned != second.is_turned);
    if (first.face > second.face)
      std::swap(first, second);
    if (first.face != second.face)
      links_[second.face] = {first.face, differ};
    else if (differ)
      contradictions_.push_back(first.face);
  }

  // Halves the way while it goes there.
  Link first_of(std::uint32_t face) {
    Link link = {face, false};
    while (links_[link.face].face != link.face) {
      Link& step = links_[link.face];
      const Link& beyond = links_[step.face];
      step = {beyond.face, step.is_turned != beyond.is_turned};
      link = {step.face, link.is_turned != step.is_turned};
    }
    return link;
  }

  void choose() {
    struct Piece {
      std::array<std::size_t, 2> faces{}; // wound as its first face, or the other way
      bool is_one_sided = false;
    };
    std::vector<Piece> pieces(links_.size()); // by its first face
    for (std::uint32_t i = 0; i < links_.size(); ++i) {
      links_[i] = first_of(i);
      ++pieces[links_[i].face].faces[links_[i].is_turned];
    }
    for (const std::uint32_t face : contradictions_)
      pieces[first_of(face).face].is_one_sided = true;
    for (const Piece& piece : pieces)
      one_sided_ += piece.is_one_sided;
    for (const Link& link : links_) {
      const Piece& piece = pieces[link.face];
      const bool is_fewer = piece.faces[1] > piece.faces[0] ? !link.is_turned : link.is_turned;
      is_against_.push_back(is_fewer && !piece.is_one_sided);
    }
  }

  std::vector<Link> links_;
  std::vector<std::uint32_t> contradictions_; // a face of a piece of one side, for each
  std::vector<bool> is_against_;
  std::size_t one_sided_ = 0;
};

} // namespace quadrille_examples

#endif
