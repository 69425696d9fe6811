#ifndef QUADRILLE_TEST_CHANNEL_REFERENCE_H
#define QUADRILLE_TEST_CHANNEL_REFERENCE_H

#include "reference.h"
#include "soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test {

/// The components of an attribute.
using Value = std::vector<double>;

/// Values at the corners of each triangle.
using CornerValues = std::vector<std::array<Value, 3>>;

/// A sum of squares of affine functions of n unknowns, by its normal equations.
class LeastSquares {
public:
  using Real = long double;
  struct Term {
    std::size_t unknown;
    Real factor;
  };

  explicit LeastSquares(std::size_t unknowns)
      : m_(unknowns, std::vector<Real>(unknowns + 1)), diagonal_(unknowns) {}

  /// Adds weight · (Σ terms − right)².
  void add(const std::vector<Term>& terms, Real right, Real weight) {
    for (const auto& [i, a] : terms) {
      for (const auto& [j, b] : terms)
        m_[i][j] += weight * a * b;
      m_[i].back() += weight * a * right;
      diagonal_[i] += weight * a * a;
    }
  }

  /// Leaves the function of the first `left` unknowns that is the minimum over all others.
  void eliminate(std::size_t left) {
    for (std::size_t k = m_.size(); k-- > left;) {
      if (!has_pivot(k))
        continue;
      for (std::size_t i = 0; i < k; ++i) {
        const Real part = m_[i][k] / m_[k][k];
        for (std::size_t j = 0; part != 0 && j < m_[i].size(); ++j)
          m_[i][j] -= part * m_[k][j];
      }
    }
  }

  /// The other unknowns of least sum, once they are eliminated, where the first ones are `known`.
  /// What nothing determines is 0.
  std::vector<Real> solve(std::vector<Real> known) const {
    for (std::size_t k = known.size(); k < m_.size(); ++k) {
      Real right = m_[k].back();
      for (std::size_t i = 0; i < k; ++i)
        right -= m_[k][i] * known[i];
      known.push_back(has_pivot(k) ? right / m_[k][k] : 0);
    }
    return known;
  }

  bool has_pivot(std::size_t k) const { return m_[k][k] > 1e-15L * diagonal_[k]; }
  Real operator()(std::size_t i, std::size_t j) const { return m_[i][j]; }
  Real right(std::size_t i) const { return m_[i].back(); }

private:
  std::vector<std::vector<Real>> m_; // the right side in the last column
  std::vector<Real> diagonal_;       // before anything was eliminated
};

/// The reference for `simplify` with channels. Each vertex remembers, beside planes in space,
/// squares in space and the attributes of all its wedges: of a face of weight a that is a(s_j −
/// s_j(x))² for each attribute j, where s_j(x) is the affine map that the face has. Nothing is
/// eliminated until an edge is looked at, and then by Gauss.
///
/// Kept seams are a graph, whose link condition holds: Vivodtzev et al. 2005. A vertex at a corner
/// of it stays, and so do the values that it has. The edges of charts leave a square more, of the
/// distance to them in the texture.
///
/// Source: Hoppe, New Quadric Metric for Simplifying Meshes with Appearance Attributes, 1999.
class ChannelReference : public Reference {
public:
  struct Channel {
    CornerValues values;
    Value weights; ///< the length that a step of 1 in each component counts as
    bool is_kept_texture = false;
    double chart_boundary_weight = 10; ///< of the edges of charts
  };

  ChannelReference(const Soup& soup, const std::vector<Channel>& channels,
                   double boundary_weight = 100)
      : Reference(soup, boundary_weight) {
    for (const Channel& channel : channels) {
      corners_.emplace_back();
      find_wedges(channel);
      are_kept_.push_back(channel.is_kept_texture);
      for (const auto& [f, t] : faces())
        remember_face(f, channel);
    }
    find_graph(soup.points.size());
    for (const auto& [edge, count] : edges()) {
      if (graph_degree_[edge[0]] == 0 || !is_in_graph(edge))
        continue;
      if (count == 2)
        remember_line(edge, 1);
      for (std::size_t c = 0; c < channels.size(); ++c)
        if (are_kept_[c])
          remember_chart_edge(edge, c, channels[c]);
    }
  }

  /// Of a channel at a corner of a face.
  const Value& value(std::size_t channel, Vertex face, std::size_t corner) const {
    return wedges_[corners_[channel].at(face)[corner]].value;
  }

protected:
  Real cost(const Edge& edge, const Position& x) const override {
    const std::vector<Group> groups = joined_wedges(edge);
    const std::vector<Value> values = best_values(groups, x);
    Real sum = Reference::cost(edge, x);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (std::size_t w : groups[g])
        for (const Square& square : wedges_[w].squares) {
          const Real off = square.off(values[g], x);
          sum += square.weight * off * off;
        }
    return sum;
  }

  System system(const Edge& edge, const Position& origin) const override {
    LeastSquares all = least_squares(joined_wedges(edge), origin);
    all.eliminate(3);
    System sum = Reference::system(edge, origin);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        sum[i][j] += all(i, j);
      sum[i][3] += all.right(i);
    }
    return sum;
  }

  void remember(const Contraction& contraction) override {
    const auto [low, high] = std::minmax(contraction.kept, contraction.gone);
    const std::vector<Group> groups = joined_wedges({low, high});
    const std::vector<Value> values = best_values(groups, contraction.target);
    std::size_t& degree = graph_degree_[contraction.kept]; // a corner stays one, a line a line
    const std::size_t other = graph_degree_[contraction.gone];
    degree = is_fixed(contraction.gone) || degree == 0 ? other : degree;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Wedge& first = wedges_[groups[g].front()];
      first.vertex = contraction.kept;
      first.value = values[g];
      for (std::size_t w : groups[g])
        if (w != groups[g].front())
          join(groups[g].front(), w);
    }
  }

  bool is_fixed(Vertex v) const override { return graph_degree_[v] != 0 && graph_degree_[v] != 2; }

  bool changes_seams(const Edge& edge) const override {
    const auto [a, b] = edge;
    if (graph_degree_[a] != 0 && graph_degree_[b] != 0 &&
        (!is_in_graph(edge) || (is_fixed(a) && is_fixed(b)) || has_common_neighbour(a, b)))
      return true;
    for (std::size_t c = 0; c < corners_.size(); ++c)
      if (has_graph_ && are_kept_[c] && !are_seams_kept(c, edge))
        return true;
    return false;
  }

  bool turns_texture_over(const Edge& edge, const Position& x) const override {
    const std::vector<Group> groups = joined_wedges(edge);
    const std::vector<Value> values = best_values(groups, x);
    const auto after = [&](std::size_t w) {
      for (std::size_t g = 0; g < groups.size(); ++g)
        if (std::count(groups[g].begin(), groups[g].end(), w) > 0)
          return values[g];
      return wedges_[w].value;
    };
    for (std::size_t c = 0; c < corners_.size(); ++c)
      for (const auto& face : faces())
        if (are_kept_[c] && has(face, edge[0]) != has(face, edge[1])) {
          const double old_area =
              texture_area(c, face.first, [&](std::size_t w) { return wedges_[w].value; });
          if (old_area * texture_area(c, face.first, after) <= 0 && old_area != 0)
            return true;
        }
    return false;
  }

private:
  // weight · (direction · (s − s(x)))², of the attributes s of a wedge, and the map s(x) = at_point
  // + gradients · (x − point).
  struct Square {
    double weight;
    Value direction;
    Position point;
    Value at_point;
    std::vector<Position> gradients;

    Real off(const Value& s, const Position& x) const {
      Real sum = 0;
      for (std::size_t c = 0; c < direction.size(); ++c) {
        Real map = at_point[c];
        for (std::size_t i = 0; i < 3; ++i)
          map += Real(gradients[c][i]) * (Real(x[i]) - point[i]);
        sum += direction[c] * (s[c] - map);
      }
      return sum;
    }
  };
  struct Wedge {
    std::size_t channel;
    Vertex vertex;
    Value value;
    std::vector<Square> squares;
  };
  using Group = std::vector<std::size_t>; // wedges that become one
  static constexpr Vertex none = ~Vertex{0};

  // --- What there is at the beginning ------------------------------------------------------------

  // Corners of one value around a vertex, one beside the other.
  void find_wedges(const Channel& channel) {
    for (const auto& [f, t] : faces())
      corners_.back()[f] = {no_wedge, no_wedge, no_wedge};
    for (const auto& [f, t] : faces())
      for (std::size_t i = 0; i < 3; ++i) {
        if (corners_.back()[f][i] != no_wedge)
          continue;
        wedges_.push_back({corners_.size() - 1, t[i], channel.values[f][i], {}});
        spread(channel, f, i);
      }
  }
  void spread(const Channel& channel, Vertex f, std::size_t i) {
    corners_.back()[f][i] = wedges_.size() - 1;
    const Vertex v = faces().at(f)[i];
    for (const auto& [g, t] : faces())
      for (std::size_t j = 0; j < 3; ++j)
        if (t[j] == v && corners_.back()[g][j] == no_wedge && have_common_edge(f, g) &&
            channel.values[g][j] == channel.values[f][i])
          spread(channel, g, j);
  }
  bool have_common_edge(Vertex f, Vertex g) const {
    const Triangle& t = faces().at(f);
    return std::count_if(t.begin(), t.end(), [&](Vertex v) { return has(*faces().find(g), v); }) ==
           2;
  }

  // The weight is less where attributes are steep: a / (1 + Σ (ω_j |g_j|)² / m), or 16 m where they
  // are no texture.
  void remember_face(Vertex f, const Channel& channel) {
    const auto& [p, q, r] = faces().at(f);
    const Position u = position(q) - position(p), v = position(r) - position(p);
    const Position normal = cross(u, v);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return;
    const auto& [at_p, at_q, at_r] = channel.values[f];
    const std::size_t m = channel.weights.size();
    std::vector<Position> gradients;
    double steepness = 0;
    for (std::size_t c = 0; c < m; ++c) {
      gradients.push_back(
          1 / squared *
          ((at_q[c] - at_p[c]) * cross(v, normal) + (at_r[c] - at_p[c]) * cross(normal, u)));
      steepness += squared_length(channel.weights[c] * gradients[c]);
    }
    const double weight = std::sqrt(squared) / 2 / (1 + steepness / double(m == 2 ? m : 16 * m));
    for (std::size_t w : corners_.back().at(f))
      for (std::size_t c = 0; c < m; ++c) {
        Value direction(m);
        direction[c] = channel.weights[c];
        wedges_[w].squares.push_back({weight, direction, position(p), at_p, gradients});
      }
  }

  // Its two sides hold the values that they have there, off the edge.
  void remember_chart_edge(const Edge& edge, std::size_t c, const Channel& channel) {
    for (const auto& face : faces()) {
      if (!has(face, edge[0]) || !has(face, edge[1]))
        continue;
      const Wedge& p = wedges_[wedge_at(corners_[c], face.first, edge[0])];
      const Wedge& q = wedges_[wedge_at(corners_[c], face.first, edge[1])];
      const double u = q.value[0] - p.value[0], v = q.value[1] - p.value[1];
      const double length = std::hypot(u, v);
      if (!(length > 0))
        continue;
      const double weight = channel.chart_boundary_weight *
                            squared_distance(position(edge[0]), position(edge[1])) *
                            channel.weights[0] * channel.weights[0];
      for (Vertex end : edge) {
        Wedge& wedge = wedges_[wedge_at(corners_[c], face.first, end)];
        wedge.squares.push_back({weight,
                                 {-v / length, u / length},
                                 position(end),
                                 wedge.value,
                                 std::vector<Position>(2)});
      }
    }
  }

  // --- The graph of seams that are kept ----------------------------------------------------------

  // Of a surface that has neither a seam nor a fold it is empty.
  void find_graph(std::size_t vertices) {
    graph_degree_.assign(vertices, 0);
    const auto all = edges();
    has_graph_ = std::any_of(all.begin(), all.end(), [&](const auto& edge) {
      return edge.second == 2 && is_in_graph(edge.first);
    });
    for (const auto& [edge, count] : all)
      for (Vertex v : edge)
        graph_degree_[v] += has_graph_ && is_in_graph(edge);
  }

  std::vector<Vertex> faces_of(const Edge& edge) const {
    std::vector<Vertex> result;
    for (const auto& face : faces())
      if (has(face, edge[0]) && has(face, edge[1]))
        result.push_back(face.first);
    return result;
  }

  // Is a channel discontinuous at both ends of an edge of two faces?
  bool is_seam(std::size_t c, const Edge& edge) const {
    const std::vector<Vertex> sides = faces_of(edge);
    return are_kept_[c] && sides.size() == 2 &&
           std::all_of(edge.begin(), edge.end(), [&](Vertex v) {
             return wedge_at(corners_[c], sides[0], v) != wedge_at(corners_[c], sides[1], v);
           });
  }

  // Is a texture turned over along it?
  bool is_fold_over(std::size_t c, const Edge& edge) const {
    const std::vector<Vertex> sides = faces_of(edge);
    const auto area = [&](Vertex f) {
      return texture_area(c, f, [&](std::size_t w) { return wedges_[w].value; });
    };
    return are_kept_[c] && sides.size() == 2 && area(sides[0]) * area(sides[1]) < 0;
  }

  bool is_in_graph(const Edge& edge) const {
    if (faces_of(edge).size() != 2)
      return true;
    for (std::size_t c = 0; c < corners_.size(); ++c)
      if (is_seam(c, edge) || is_fold_over(c, edge))
        return true;
    return false;
  }

  // Are the seams of a channel, once an edge is contracted, those that there were?
  bool are_seams_kept(std::size_t c, const Edge& contracted) const {
    const auto [kept, gone] = contracted;
    const auto moved = [&, kept = kept, gone = gone](const Edge& edge) {
      const Vertex v = edge[0] == gone ? kept : edge[0], w = edge[1] == gone ? kept : edge[1];
      return Edge{std::min(v, w), std::max(v, w)};
    };
    const std::vector<Group> groups = joined_wedges(contracted);
    const auto joined = [&](std::size_t w) {
      for (const Group& group : groups)
        if (std::count(group.begin(), group.end(), w) > 0)
          return group.front();
      return w;
    };
    using Side = std::map<Vertex, std::size_t>; // the wedges of a face at an edge
    std::map<Edge, std::vector<Side>> sides;
    std::set<Edge> before, after;
    for (const auto& [edge, count] : edges()) {
      if (edge == contracted)
        continue;
      if (is_seam(c, edge))
        before.insert(moved(edge));
      for (Vertex f : faces_of(edge)) {
        if (has(*faces().find(f), kept) && has(*faces().find(f), gone))
          continue;
        Side side;
        for (Vertex v : edge)
          side[v == gone ? kept : v] = joined(wedge_at(corners_[c], f, v));
        sides[moved(edge)].push_back(side);
      }
    }
    for (const auto& [edge, both] : sides)
      if (both.size() == 2 && both[0].at(edge[0]) != both[1].at(edge[0]) &&
          both[0].at(edge[1]) != both[1].at(edge[1]))
        after.insert(edge);
    return before == after;
  }

  bool has_common_neighbour(Vertex a, Vertex b) const {
    std::map<Vertex, int> joined;
    for (const auto& [edge, count] : edges())
      for (std::size_t i = 0; i < 2; ++i)
        if ((edge[i] == a || edge[i] == b) && is_in_graph(edge))
          ++joined[edge[1 - i]];
    return std::any_of(joined.begin(), joined.end(), [](const auto& v) { return v.second > 1; });
  }

  // Twice the area of a face in a texture: value(wedge) at its corners.
  double texture_area(std::size_t c, Vertex f, const auto& value) const {
    const auto& [i, j, k] = corners_[c].at(f);
    const Value p = value(i), q = value(j), r = value(k);
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  // --- The wedges of an edge ---------------------------------------------------------------------

  // All wedges of both ends; those of a face of both become one. Of a vertex that is fixed, the one
  // that the first face has comes first.
  std::vector<Group> joined_wedges(const Edge& edge) const {
    std::vector<Group> groups;
    for (std::size_t w = 0; w < wedges_.size(); ++w)
      if (wedges_[w].vertex == edge[0] || wedges_[w].vertex == edge[1])
        groups.push_back({w});
    const Edge order = is_fixed(edge[0]) ? edge : Edge{edge[1], edge[0]};
    for (Vertex f : faces_of(edge))
      for (const auto& corners : corners_)
        merge(wedge_at(corners, f, order[0]), wedge_at(corners, f, order[1]), groups);
    return groups;
  }
  static void merge(std::size_t w, std::size_t x, std::vector<Group>& groups) {
    const auto group_of = [&](std::size_t wedge) {
      return std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return std::count(group.begin(), group.end(), wedge) > 0;
      });
    };
    const auto first = group_of(w), second = group_of(x);
    if (first == second)
      return;
    const bool is_second_older = second->size() > 1 && first->size() == 1;
    first->insert(is_second_older ? first->begin() : first->end(), second->begin(), second->end());
    groups.erase(second);
  }
  std::size_t wedge_at(const auto& corners, Vertex f, Vertex v) const {
    const Triangle& t = faces().at(f);
    return corners.at(f)[static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin())];
  }

  // Of the displacement from the origin, and the attributes of all groups.
  LeastSquares least_squares(const std::vector<Group>& groups, const Position& origin) const {
    LeastSquares all(first_unknown(groups, groups.size()));
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::size_t first = first_unknown(groups, g);
      for (std::size_t w : groups[g])
        for (const Square& square : wedges_[w].squares)
          add(square, first, origin, all);
    }
    return all;
  }
  static void add(const Square& square, std::size_t first, const Position& origin,
                  LeastSquares& all) {
    std::vector<LeastSquares::Term> terms;
    for (std::size_t i = 0; i < 3; ++i) {
      Real slope = 0;
      for (std::size_t c = 0; c < square.direction.size(); ++c)
        slope += Real(square.direction[c]) * square.gradients[c][i];
      terms.push_back({i, -slope});
    }
    for (std::size_t c = 0; c < square.direction.size(); ++c)
      terms.push_back({first + c, square.direction[c]});
    const Value zero(square.direction.size());
    all.add(terms, -square.off(zero, origin), square.weight);
  }
  std::size_t first_unknown(const std::vector<Group>& groups, std::size_t end) const {
    std::size_t first = 3;
    for (std::size_t g = 0; g < end; ++g)
      first += wedges_[groups[g].front()].value.size();
    return first;
  }

  // The attributes of least cost at x. Those that no face tells stay, and those of a vertex that is
  // fixed.
  std::vector<Value> best_values(const std::vector<Group>& groups, const Position& x) const {
    LeastSquares all = least_squares(groups, x);
    all.eliminate(3);
    const std::vector<Real> solution = all.solve({0, 0, 0});
    std::vector<Value> values;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto held = std::find_if(groups[g].begin(), groups[g].end(),
                                     [&](std::size_t w) { return is_fixed(wedges_[w].vertex); });
      values.push_back(wedges_[held == groups[g].end() ? groups[g].front() : *held].value);
      if (held != groups[g].end())
        continue;
      const std::size_t first = first_unknown(groups, g);
      for (std::size_t c = 0; c < values[g].size(); ++c)
        if (all.has_pivot(first + c))
          values[g][c] = static_cast<double>(solution[first + c]);
    }
    return values;
  }

  void join(std::size_t first, std::size_t second) {
    Wedge& gone = wedges_[second];
    auto& squares = wedges_[first].squares;
    squares.insert(squares.end(), gone.squares.begin(), gone.squares.end());
    gone.vertex = none;
    for (auto& [f, corners] : corners_[gone.channel])
      std::replace(corners.begin(), corners.end(), second, first);
  }

  static constexpr std::size_t no_wedge = ~std::size_t{0};

  std::vector<Wedge> wedges_;             // of all channels
  std::vector<bool> are_kept_;            // the seams of each channel
  std::vector<std::size_t> graph_degree_; // of each vertex at the beginning: edges of the graph
  bool has_graph_ = false;
  std::vector<std::map<Vertex, std::array<std::size_t, 3>>> corners_; // of each channel
};

} // namespace test

#endif // QUADRILLE_TEST_CHANNEL_REFERENCE_H
