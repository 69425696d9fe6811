#ifndef QUADRILLE_TEST_PIECES_H
#define QUADRILLE_TEST_PIECES_H

#include "soups.h"

#include <quadrille/internal/file/chunk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Surfaces that are cut into pieces, simplified piece by piece, and sewn: all in memory, and by
/// the numbers of vertices only.

namespace test {

/// Of each face, one of `parts` parts of about as many faces: boxes of a kd-tree over the middles
/// of faces, each cut across its longest side where a `share` of its faces is on one side.
inline std::vector<std::uint32_t> kd_chunks(const Soup& soup, std::uint32_t parts, double share) {
  std::vector<std::uint32_t> part(soup.triangles.size(), 0), faces(soup.triangles.size());
  std::vector<Position> middles;
  for (const auto& [a, b, c] : soup.triangles)
    middles.push_back(soup.points[a] + soup.points[b] + soup.points[c]);
  std::iota(faces.begin(), faces.end(), 0);
  const auto divide = [&](const auto& self, std::size_t begin, std::size_t end, std::uint32_t first,
                          std::uint32_t count) -> void {
    if (count == 1) {
      for (std::size_t i = begin; i < end; ++i)
        part[faces[i]] = first;
      return;
    }
    std::size_t axis = 0;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      double low = std::numeric_limits<double>::max(), high = -low;
      for (std::size_t f = begin; f < end; ++f) {
        low = std::min(low, middles[faces[f]][i]);
        high = std::max(high, middles[faces[f]][i]);
      }
      if (high - low > longest)
        longest = high - low, axis = i;
    }
    const auto middle = begin + static_cast<std::size_t>(share * static_cast<double>(end - begin));
    std::sort(faces.begin() + static_cast<std::ptrdiff_t>(begin),
              faces.begin() + static_cast<std::ptrdiff_t>(end),
              [&](std::uint32_t f, std::uint32_t g) {
                return std::pair(middles[f][axis], f) < std::pair(middles[g][axis], g);
              });
    self(self, begin, middle, first, count / 2);
    self(self, middle, end, first + count / 2, count - count / 2);
  };
  divide(divide, 0, faces.size(), 0, parts);
  return part;
}

/// A surface between two phases: with what vertices remember, if anything.
template <class Cost>
struct Sewn {
  using State = typename Cost::State;
  Soup soup;
  std::vector<State> states; ///< empty, or one for each point
};

/// A part of a surface as a piece, and which point of the surface each of its points is.
template <class Cost>
struct CutPiece {
  quadrille::internal::Chunk<Cost> piece;
  std::vector<std::uint32_t> points;
};

/// The pieces of a surface, in the box of it.
template <class Cost>
std::vector<CutPiece<Cost>> cut(const Sewn<Cost>& surface, const std::vector<std::uint32_t>& part,
                                const quadrille::internal::Box<3>& box) {
  const Soup& soup = surface.soup;
  const std::uint32_t parts = part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
  constexpr std::uint32_t nobody = ~std::uint32_t{0};
  std::vector<std::uint32_t> owner(soup.points.size(), nobody);
  std::vector<bool> is_shared(soup.points.size(), false);
  std::map<std::array<std::uint32_t, 2>, std::size_t> faces_at;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = soup.triangles[f][i], w = soup.triangles[f][(i + 1) % 3];
      is_shared[v] = is_shared[v] || (owner[v] != nobody && owner[v] != part[f]);
      owner[v] = part[f];
      ++faces_at[{std::min(v, w), std::max(v, w)}];
    }
  std::vector<CutPiece<Cost>> pieces(parts);
  std::vector<std::map<std::uint32_t, std::uint32_t>> numbers(parts);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    auto& [piece, points] = pieces[part[f]];
    Triangle t;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = soup.triangles[f][i];
      const auto [at, is_new] =
          numbers[part[f]].try_emplace(v, static_cast<std::uint32_t>(points.size()));
      t[i] = at->second;
      if (!is_new)
        continue;
      points.push_back(v);
      piece.positions.push_back(soup.points[v]);
      piece.is_shared.push_back(is_shared[v]);
      if (!surface.states.empty())
        piece.states.push_back(surface.states[v]);
    }
    piece.triangles.push_back(t);
  }
  for (std::uint32_t p = 0; p < parts; ++p) {
    pieces[p].piece.box = box;
    for (const Triangle& t : pieces[p].piece.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        const auto edge = std::minmax(pieces[p].points[a], pieces[p].points[b]);
        if (is_shared[edge.first] && is_shared[edge.second] &&
            faces_at[{edge.first, edge.second}] == 1)
          pieces[p].piece.boundaries.push_back({a, b});
      }
  }
  return pieces;
}

/// Simplifies each piece by itself and sews them: no positions are compared.
template <class Cost, class... Policies>
Sewn<Cost> simplified_in_chunks(const Sewn<Cost>& surface, const std::vector<std::uint32_t>& part,
                                const quadrille::internal::Box<3>& box,
                                quadrille::internal::CostHistogram& costs, const Cost& cost,
                                const Policies&... policies) {
  Sewn<Cost> result;
  constexpr bool remembers = !std::is_empty_v<typename Cost::State>;
  std::map<std::uint32_t, std::uint32_t> number; // of each point of the surface that is left
  for (auto& [piece, points] : cut(surface, part, box)) {
    const std::vector<bool> is_shared = piece.is_shared;
    const auto left = quadrille::internal::simplify_chunk(std::move(piece), cost, policies...);
    costs += left.costs;
    for (std::size_t i = 0; i < left.vertices.size(); ++i) {
      const std::uint32_t v = points[left.vertices[i]];
      const auto [at, is_new] =
          number.try_emplace(v, static_cast<std::uint32_t>(result.soup.points.size()));
      if (is_new)
        result.soup.points.push_back(left.positions[i]);
      if constexpr (remembers) {
        const bool has_given = is_shared[left.vertices[i]] && !surface.states.empty();
        if (is_new)
          result.states.push_back(has_given ? surface.states[v] : typename Cost::State{});
        result.states[at->second] += left.states[i];
      }
    }
    for (const auto& t : left.triangles) {
      Triangle sewn;
      for (std::size_t i = 0; i < 3; ++i)
        sewn[i] = number.at(points[left.vertices[t[i]]]);
      result.soup.triangles.push_back(sewn);
    }
  }
  return result;
}

} // namespace test

#endif // QUADRILLE_TEST_PIECES_H
