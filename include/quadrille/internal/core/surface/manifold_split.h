#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_MANIFOLD_SPLIT_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_MANIFOLD_SPLIT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A face at an edge, and the corner at which the edge begins in it.
struct FaceAtEdge {
  Index other; // the higher end of the edge
  Index face, corner;
  bool is_up; // does the face run along the edge from its lower end to its higher one?
  auto operator<=>(const FaceAtEdge&) const = default;
};

/// Pairs the faces at an edge of more than two of them so that sheets touch there and do not cross:
/// in the order in which they lie around the edge, each with the next one on the other side of what
/// the surface encloses. Source: Guéziec, Taubin, Lazarus and Horn, Cutting and stitching, 2001.
class EdgePairing {
public:
  explicit EdgePairing(const SurfaceView& surface) : surface_(surface) {}

  /// Calls join(a, b) for each pair, by places among the faces at the edge. A face is left without
  /// a mate only where there are more that run up along the edge than down, or the other way round.
  template <class Join>
  void operator()(Index low, std::span<const FaceAtEdge> faces, Join join) {
    sort_around(low, faces);
    open_.clear();
    is_joined_.assign(faces.size(), false);
    for (std::size_t step = 0; step < 2 * faces.size(); ++step) { // the turn begins anywhere
      const std::size_t i = order_[step % faces.size()].second;
      if (!faces[i].is_up && step < faces.size()) {
        open_.push_back(i);
      } else if (faces[i].is_up && !open_.empty() && !is_joined_[i]) {
        is_joined_[i] = true;
        join(open_.back(), i);
        open_.pop_back();
      }
    }
  }

private:
  Index opposite(const FaceAtEdge& f) const {
    return surface_.triangles[f.face][(f.corner + 2) % 3];
  }

  // Nothing lies between faces on the same three vertices: those that run up come first.
  void sort_around(Index low, std::span<const FaceAtEdge> faces) {
    const Vector<3> origin = surface_.points[low];
    const Vector<3> axis = surface_.points[faces.front().other] - origin;
    const auto away = [&](const FaceAtEdge& f) {
      return cross(axis, surface_.points[opposite(f)] - origin);
    };
    const Vector<3> x = away(faces.front()), y = cross(axis, x);
    const double length = std::sqrt(squared_length(axis));
    order_.clear();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const double angle =
          length > 0 ? std::atan2(dot(away(faces[i]), y) / length, dot(away(faces[i]), x)) : 0;
      order_.push_back({{angle, opposite(faces[i]), !faces[i].is_up}, i});
    }
    std::sort(order_.begin(), order_.end());
  }

  using Place = std::tuple<double, Index, bool>;
  SurfaceView surface_;
  std::vector<std::pair<Place, std::size_t>> order_;
  std::vector<std::size_t> open_;
  std::vector<bool> is_joined_;
};

/// A surface cut into manifold sheets: each edge has at most two faces, and those of each vertex
/// form a disc or half a disc. What touches itself at a vertex or along edges gets a vertex for
/// each sheet. Where sheets along an edge have both ends in common, all but one get another vertex
/// in the middle of the edge.
class ManifoldSplit {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Triangle> triangles;
  std::vector<Index> faces;                ///< the input face that each triangle is a fragment of
  std::vector<std::array<Index, 2>> added; ///< vertices: in the middle of two; of one, a copy
  std::size_t split_edges = 0;             ///< in their middles

  explicit ManifoldSplit(const SurfaceView& surface)
      : surface_(surface), umbrella_(3 * surface.triangles.size()) {
    std::iota(umbrella_.begin(), umbrella_.end(), Index{0});
    for (Index face = 0; face < surface.triangles.size(); ++face)
      if (const auto [a, b, c] = surface.triangles[face]; a != b && b != c && c != a)
        faces.push_back(face);
    join_faces();
    number_vertices();
    split_touching_edges();
  }

private:
  struct Mates {
    FaceAtEdge first, second; // the second may be `none`
  };

  // For each vertex, the faces at edges of which it is the lower end, by the higher ones.
  void join_faces() {
    std::vector<std::size_t> end(surface_.points.size() + 1, 0);
    for_each_side([&](Index low, const FaceAtEdge&) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<FaceAtEdge> sides(end.back());
    for_each_side([&](Index low, const FaceAtEdge& side) { sides[end[low]++] = side; });
    EdgePairing pairing(surface_);
    std::size_t begin = 0;
    for (Index low = 0; low < surface_.points.size(); ++low) {
      const std::span<FaceAtEdge> at_low(sides.data() + begin, end[low] - begin);
      begin = end[low];
      std::sort(at_low.begin(), at_low.end());
      for (std::size_t i = 0, n = 1; i < at_low.size(); i += n, n = 1) {
        while (i + n < at_low.size() && at_low[i + n].other == at_low[i].other)
          ++n;
        join_edge(low, at_low.subspan(i, n), pairing);
      }
    }
  }
  template <class Visit>
  void for_each_side(Visit visit) const {
    for (Index face : faces)
      for (Index i = 0; i < 3; ++i) {
        const Index v = surface_.triangles[face][i], w = surface_.triangles[face][(i + 1) % 3];
        visit((std::min)(v, w), FaceAtEdge{(std::max)(v, w), face, i, v < w});
      }
  }

  void join_edge(Index low, std::span<const FaceAtEdge> at_edge, EdgePairing& pairing) {
    if (at_edge.size() < 2)
      return;
    const auto join = [&](std::size_t a, std::size_t b) {
      for (const bool at_low : {true, false})
        unite(corner(at_edge[a], at_low), corner(at_edge[b], at_low));
    };
    if (at_edge.size() == 2)
      return join(0, 1);
    std::vector<Mates>& mates = crowded_.emplace_back();
    std::vector<bool> is_left(at_edge.size(), true);
    pairing(low, at_edge, [&](std::size_t a, std::size_t b) {
      join(a, b);
      is_left[a] = is_left[b] = false;
      mates.push_back({at_edge[a], at_edge[b]});
    });
    for (std::size_t i = 0; i < at_edge.size(); ++i)
      if (is_left[i])
        mates.push_back({at_edge[i], {none, none, none, false}});
  }

  // The corner of a face at an end of an edge.
  static Index corner(const FaceAtEdge& f, bool at_low) {
    return 3 * f.face + (f.corner + (f.is_up == at_low ? 0 : 1)) % 3;
  }
  Index root(Index c) {
    while (umbrella_[c] != c)
      c = umbrella_[c] = umbrella_[umbrella_[c]];
    return c;
  }
  void unite(Index a, Index b) { umbrella_[root(a)] = root(b); }

  // The first umbrella of a vertex keeps its number.
  void number_vertices() {
    std::vector<bool> is_taken(surface_.points.size(), false);
    std::vector<Index> number(umbrella_.size(), none); // of each root
    for (Index face : faces) {
      Triangle& triangle = triangles.emplace_back();
      for (Index i = 0; i < 3; ++i) {
        Index& n = number[root(3 * face + i)];
        if (const Index v = surface_.triangles[face][i]; n == none && !is_taken[v]) {
          n = v;
          is_taken[v] = true;
        } else if (n == none) {
          n = add({v, v});
        }
        triangle[i] = n;
      }
    }
  }
  Index add(const std::array<Index, 2>& ends) {
    added.push_back(ends);
    return static_cast<Index>(surface_.points.size() + added.size() - 1);
  }

  // The first of several sheets that have both ends of an edge in common keeps the edge.
  void split_touching_edges() {
    std::vector<Touching> touching;
    std::vector<Index> place(crowded_.empty() ? 0 : surface_.triangles.size(), none); // of a face
    for (Index f = 0; f < place.size() && f < faces.size(); ++f)
      place[faces[f]] = f;
    std::vector<std::array<Index, 2>> seen;
    for (const std::vector<Mates>& at_edge : crowded_) {
      seen.clear();
      for (const Mates& mates : at_edge) {
        const Triangle& t = triangles[place[mates.first.face]];
        const std::array ends{t[mates.first.corner], t[(mates.first.corner + 1) % 3]};
        const std::array edge{(std::min)(ends[0], ends[1]), (std::max)(ends[0], ends[1])};
        if (std::find(seen.begin(), seen.end(), edge) != seen.end())
          touching.push_back({edge, place[mates.first.face],
                              mates.second.face == none ? none : place[mates.second.face]});
        seen.push_back(edge);
      }
    }
    for (const Touching& pair : touching)
      split(pair);
  }

  // A sheet that touches another one along an edge.
  struct Touching {
    std::array<Index, 2> edge;
    Index first, second; // faces, by place; the second may be none
  };

  void split(const Touching& pair) {
    const Index middle = add_middle(pair.edge);
    const Index opposite = split(pair.first, pair.edge, middle);
    if (pair.second == none || split(pair.second, pair.edge, middle) != opposite)
      return;
    // The sheet is folded along the edge: both faces would get an edge to the same vertex.
    const std::array across{opposite, middle};
    const Index inner = add_middle(across);
    split(pair.second, across, inner);
    split(pair.second, across, inner); // on its other side
  }

  Index add_middle(const std::array<Index, 2>& edge) {
    const auto original = [this](Index v) { // of a copy
      const std::size_t points = surface_.points.size();
      return v >= points && added[v - points][0] == added[v - points][1] ? added[v - points][0] : v;
    };
    ++split_edges;
    return add({original(edge[0]), original(edge[1])});
  }

  // The fragment of a face that has the edge becomes two. Returns the vertex opposite to the edge.
  Index split(Index face, const std::array<Index, 2>& edge, Index middle) {
    std::vector<Index>& fragments = fragments_.try_emplace(face, 1, face).first->second;
    for (const Index fragment : fragments)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = triangles[fragment][i], w = triangles[fragment][(i + 1) % 3];
        if ((std::min)(v, w) != edge[0] || (std::max)(v, w) != edge[1])
          continue;
        Triangle other = triangles[fragment];
        other[i] = middle;
        triangles[fragment][(i + 1) % 3] = middle;
        fragments.push_back(static_cast<Index>(triangles.size()));
        triangles.push_back(other);
        faces.push_back(Index{faces[face]});
        return other[(i + 2) % 3];
      }
    return none; // is not reached: the edge is one of the face
  }

  SurfaceView surface_;
  std::vector<Index> umbrella_;             // of each corner another one of its umbrella, or itself
  std::vector<std::vector<Mates>> crowded_; // the sheets at each edge of more than two faces
  std::map<Index, std::vector<Index>> fragments_; // of faces of which edges were split
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_MANIFOLD_SPLIT_H
