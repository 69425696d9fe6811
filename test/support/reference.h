#ifndef QUADRILLE_TEST_REFERENCE_H
#define QUADRILLE_TEST_REFERENCE_H

#include "soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace test {

/// What `simplify` with Quadric, OptimalPlacement and EdgePairs is compared with: the same rules,
/// told with sets and maps and nothing else. It shares no code with the engine. A vertex remembers
/// a list of planes, not a quadric; the link condition is the equation of sets that
/// defines it; and every step looks at every edge there is. A class that is derived from it adds to
/// what vertices remember.
class Reference {
public:
  using Vertex = std::uint32_t;
  using Edge = std::array<Vertex, 2>; // the lower vertex first

  struct Contraction {
    Vertex kept, gone;
    Position target;
  };

  /// The soup is manifold.
  explicit Reference(const Soup& soup, double boundary_weight = 100) : position_(soup.points) {
    state_.resize(position_.size());
    ring_radius_.resize(position_.size());
    for (Vertex v = 0; v < position_.size(); ++v)
      image_.push_back(v);
    for (Vertex f = 0; f < soup.triangles.size(); ++f)
      faces_[f] = soup.triangles[f];
    for (const auto& [f, face] : faces_)
      remember_face(face);
    for (const auto& [edge, count] : edges())
      if (count == 1)
        remember_line(edge, boundary_weight);
    for (Vertex v = 0; v < position_.size(); ++v)
      ring_radius_[v] = distance_to_farthest_neighbour(v);
  }
  virtual ~Reference() = default;

  /// Contracts the cheapest edge that may be contracted; nothing if none may.
  std::optional<Contraction> contract_next() {
    while (const std::optional<Candidate> next = cheapest()) {
      const auto [a, b] = next->edge;
      std::size_t* cause = nullptr;
      if (changes_seams(next->edge))
        cause = &seam_rejections;
      else if (!is_link_condition_met(a, b))
        cause = &topology_rejections;
      else if (const std::optional<Position> target = good_target(*next))
        return contract(*next, *target);
      else
        cause = turns_faces(next->edge, next->target) ? &flip_rejections : &texture_rejections;
      ++*cause;
      rejected_.insert(next->edge);
    }
    return std::nullopt;
  }

  const std::map<Vertex, Triangle>& faces() const { return faces_; } ///< by the input's number
  const Position& position(Vertex v) const { return position_[v]; }
  bool has_faces(Vertex v) const {
    return std::any_of(faces_.begin(), faces_.end(), [v](const auto& f) { return has(f, v); });
  }
  /// What has become of a vertex of the input.
  Vertex image(Vertex v) const { return image_[v] == v ? v : image(image_[v]); }

  double error = 0; ///< as Report::error
  std::size_t topology_rejections = 0, flip_rejections = 0;
  std::size_t seam_rejections = 0, texture_rejections = 0; ///< of a class that is derived

protected:
  using Real = long double;
  /// Half of the gradient of a cost by the displacement from an origin: matrix, and right side in
  /// column 3.
  using System = std::array<std::array<Real, 4>, 3>;

  /// What the contraction of an edge costs at x.
  virtual Real cost(const Edge& edge, const Position& x) const {
    Real sum = 0;
    for (Vertex v : edge)
      for (const Plane& plane : state_[v]) {
        Real distance = 0;
        for (std::size_t i = 0; i < 3; ++i)
          distance += Real(plane.normal[i]) * (Real(x[i]) - plane.point[i]);
        sum += plane.weight * distance * distance;
      }
    return sum;
  }

  /// The same as a quadratic function.
  virtual System system(const Edge& edge, const Position& origin) const {
    System m{};
    for (Vertex v : edge)
      for (const Plane& plane : state_[v]) {
        Real offset = 0;
        for (std::size_t i = 0; i < 3; ++i)
          offset += Real(plane.normal[i]) * (Real(plane.point[i]) - origin[i]);
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j)
            m[i][j] += Real(plane.weight) * plane.normal[i] * plane.normal[j];
          m[i][3] += plane.weight * plane.normal[i] * offset;
        }
      }
    return m;
  }

  /// What the planes of an edge weigh.
  Real plane_weight(const Edge& edge) const {
    Real sum = 0;
    for (Vertex v : edge)
      for (const Plane& plane : state_[v])
        sum += plane.weight;
    return sum;
  }

  /// Takes note of a contraction, before faces change.
  virtual void remember(const Contraction&) {}

  /// Does a vertex stay where it is?
  virtual bool is_fixed(Vertex) const { return false; }
  /// Must an edge not be contracted since that would change a graph in the surface?
  virtual bool changes_seams(const Edge&) const { return false; }
  /// Must it not go to x for the sake of a texture?
  virtual bool turns_texture_over(const Edge&, const Position&) const { return false; }

  /// The ends of an edge remember its line, for each of its faces.
  void remember_line(const Edge& edge, double weight_of_line) {
    for (const auto& [f, t] : faces_)
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::min(t[i], t[(i + 1) % 3]) != edge[0] || std::max(t[i], t[(i + 1) % 3]) != edge[1])
          continue;
        const Position along = position_[t[(i + 1) % 3]] - position_[t[i]];
        const Position normal = cross(along, position_[t[(i + 2) % 3]] - position_[t[i]]);
        const Position within = cross(along, normal);
        if (!(squared_length(normal) > 0))
          continue;
        const double weight = weight_of_line * squared_length(along);
        for (Vertex v : edge) {
          state_[v].push_back({position_[t[i]], unit(within), weight});
          state_[v].push_back({position_[t[i]], unit(normal), weight / 4});
        }
      }
  }

  static bool has(const std::pair<const Vertex, Triangle>& face, Vertex v) {
    return std::find(face.second.begin(), face.second.end(), v) != face.second.end();
  }

  /// Every edge, with the number of its faces.
  std::map<Edge, int> edges() const {
    std::map<Edge, int> result;
    for (const auto& [f, t] : faces_)
      for (std::size_t i = 0; i < 3; ++i)
        ++result[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
    return result;
  }

private:
  using Simplex = std::set<Vertex>;
  static constexpr Vertex infinity = ~Vertex{0}; // the boundary's neighbour

  struct Plane {
    Position point, normal; // of unit length
    double weight;
  };
  using State = std::vector<Plane>;
  struct Candidate {
    float key; // what it costs, and what tells it from others that cost the same
    Edge edge;
    Position target;
    Real cost;
    bool operator<(const Candidate& other) const {
      return std::pair(key, edge) < std::pair(other.key, other.edge);
    }
  };

  std::set<Vertex> neighbours(Vertex v) const {
    std::set<Vertex> result;
    for (const auto& face : faces_)
      if (has(face, v))
        result.insert(face.second.begin(), face.second.end());
    result.erase(v);
    return result;
  }

  // --- What a vertex remembers -------------------------------------------------------------------

  void remember_face(const Triangle& face) {
    const auto& [p, q, r] = face;
    const Position twice = cross(position_[q] - position_[p], position_[r] - position_[p]);
    const double area = std::sqrt(squared_length(twice)) / 2;
    if (!(area > 0))
      return;
    for (Vertex v : face)
      state_[v].push_back({position_[p], 0.5 / area * twice, area});
  }

  static Position unit(const Position& v) { return 1 / std::sqrt(squared_length(v)) * v; }

  // --- Costs and positions -----------------------------------------------------------------------

  static Real trace(const System& m) { return m[0][0] + m[1][1] + m[2][2]; }

  // A billionth of the planes' weight pulls to the two ends.
  Real tie_break(const Edge& edge, const Position& x) const {
    return 0.5e-9L * trace(system(edge, x)) *
           (squared_distance(x, position_[edge[0]]) + squared_distance(x, position_[edge[1]]));
  }

  // Of the sum of the costs and of `pull` times their weight times the squared distance to
  // `origin`. By the normal equations and Cramer's rule, as a displacement from there. Nothing
  // where a pivot is not above `least` of the weight.
  std::optional<Position> minimizer(const Edge& edge, const Position& origin, Real pull,
                                    Real least) const {
    System m = system(edge, origin);
    const Real weight = trace(m);
    for (std::size_t i = 0; i < 3; ++i)
      m[i][i] += pull * weight;
    const auto determinant = [&](std::size_t a, std::size_t b, std::size_t c) {
      return m[0][a] * (m[1][b] * m[2][c] - m[2][b] * m[1][c]) -
             m[1][a] * (m[0][b] * m[2][c] - m[2][b] * m[0][c]) +
             m[2][a] * (m[0][b] * m[1][c] - m[1][b] * m[0][c]);
    };
    const Real d = determinant(0, 1, 2), minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const Real least_pivot = least * weight;
    if (!(m[0][0] > least_pivot && minor > least_pivot * m[0][0] && d > least_pivot * minor))
      return std::nullopt;
    return origin + Position{{double(determinant(3, 1, 2) / d), double(determinant(0, 3, 2) / d),
                              double(determinant(0, 1, 3) / d)}};
  }

  Position best_position(const Edge& edge) const {
    const Position &p = position_[edge[0]], &q = position_[edge[1]];
    for (Vertex v : edge)
      if (is_fixed(v))
        return position_[v];
    std::optional<Position> x = minimizer(edge, p, 0, 1e-4L);
    if (!x) { // planes leave it free, or nearly so
      x = minimizer(edge, 0.5 * (p + q), 1e-9L, 0);
      if (x)
        x = minimizer(edge, *x, 1e-9L, 0); // takes back what it has given for being near
    }
    const double reach = std::max(ring_radius_[edge[0]], ring_radius_[edge[1]]);
    if (x && std::min(squared_distance(*x, p), squared_distance(*x, q)) <= reach) {
      for (const Position& end : {p, q}) // not moved by rounding alone
        if (squared_distance(*x, end) <= reach * 0x1p-60)
          return end;
      return *x;
    }
    const Position middle = 0.5 * (p + q);
    Position best = p;
    for (const Position& other : {q, middle})
      if (cost(edge, other) < cost(edge, best))
        best = other;
    return best;
  }

  std::optional<Candidate> cheapest() const {
    std::optional<Candidate> best;
    for (const auto& [edge, count] : edges()) {
      if (rejected_.contains(edge))
        continue;
      const Position target = best_position(edge);
      const Real value = cost(edge, target);
      const Candidate candidate{static_cast<float>(value + tie_break(edge, target)), edge, target,
                                value};
      if (!best || candidate < *best)
        best = candidate;
    }
    return best;
  }

  // Squared, as a float.
  float distance_to_farthest_neighbour(Vertex v) const {
    float reach = 0;
    for (Vertex w : neighbours(v))
      reach = std::max(reach, static_cast<float>(squared_distance(position_[v], position_[w])));
    return reach;
  }

  // --- What is refused ---------------------------------------------------------------------------

  // Lk(a) ∩ Lk(b) = Lk(ab), with the boundary joined to a point at infinity.
  bool is_link_condition_met(Vertex a, Vertex b) const {
    std::vector<Simplex> closed;
    for (const auto& [f, t] : faces_)
      closed.push_back({t[0], t[1], t[2]});
    for (const auto& [edge, count] : edges())
      if (count == 1)
        closed.push_back({edge[0], edge[1], infinity});
    const auto link = [&](const Simplex& of) { // the faces of the opposite sides
      std::set<Simplex> result;
      for (const Simplex& face : closed) {
        if (!std::includes(face.begin(), face.end(), of.begin(), of.end()))
          continue;
        Simplex rest;
        std::set_difference(face.begin(), face.end(), of.begin(), of.end(),
                            std::inserter(rest, rest.end()));
        result.insert(rest);
        for (Vertex v : rest)
          result.insert(Simplex{v});
      }
      return result;
    };
    const std::set<Simplex> of_a = link({a}), of_b = link({b});
    std::set<Simplex> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::inserter(common, common.end()));
    return common == link({a, b});
  }

  // A face that a contraction changes, or one beside it: its normals, not of unit length.
  struct Turn {
    Triangle face;
    Position before, after;
  };

  Turn turn(const Triangle& face, Vertex a, Vertex b, const Position& target) const {
    const auto after = [&](Vertex v) { return v == a || v == b ? target : position_[v]; };
    const auto normal = [&](const auto& at) {
      return cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0]));
    };
    return {face, normal([&](Vertex v) { return position_[v]; }), normal(after)};
  }

  // Of the faces with just one of the ends: the others vanish, or nothing happens to them.
  std::vector<Turn> changed_faces(Vertex a, Vertex b, const Position& target) const {
    std::vector<Turn> changed;
    for (const auto& face : faces_)
      if (has(face, a) != has(face, b))
        changed.push_back(turn(face.second, a, b, target));
    return changed;
  }

  // Where the pair goes; nowhere if faces would turn over, fold or become needles there, and at its
  // ends and between these, as far as it costs no more.
  std::optional<Position> good_target(const Candidate& candidate) const {
    const auto [a, b] = candidate.edge;
    const Real most = candidate.cost + 1e-3L * tie_break(candidate.edge, candidate.target);
    const Position middle = 0.5 * (position_[a] + position_[b]);
    for (const Position& x : {candidate.target, position_[a], position_[b], middle})
      if ((x == candidate.target ||
           (!is_fixed(a) && !is_fixed(b) && cost(candidate.edge, x) <= most)) &&
          !turns_faces(candidate.edge, x) && !turns_texture_over(candidate.edge, x))
        return x;
    return std::nullopt;
  }

  bool turns_faces(const Edge& edge, const Position& x) const {
    const auto [a, b] = edge;
    return turns_a_face_over(a, b, x) || makes_sliver(a, b, x) || makes_fold_over(a, b, x);
  }

  bool turns_a_face_over(Vertex a, Vertex b, const Position& target) const {
    const std::vector<Turn> changed = changed_faces(a, b, target);
    return std::any_of(changed.begin(), changed.end(), [](const Turn& f) {
      return squared_length(f.before) > 0 && dot(f.before, f.after) <= 0;
    });
  }

  // Does a face become lower than 10⁻⁴ of about its length that was not, and is no part of a narrow
  // wall: is less than a quarter of its area left, or less than 0.01 of the least such height?
  bool makes_sliver(Vertex a, Vertex b, const Position& target) const {
    struct Needle {
      double area_left, height;
    };
    double least = std::numeric_limits<double>::infinity();
    std::vector<Needle> needles;
    for (const auto& face : faces_) {
      if (has(face, a) == has(face, b))
        continue;
      const Turn f = turn(face.second, a, b, target);
      const auto height = [&](const Position& normal, const auto& at) {
        double edges = 0; // the two at the corner that moves
        for (Vertex v : face.second)
          for (Vertex w : face.second)
            if ((v == a || v == b) && w != v)
              edges += squared_distance(at(v), at(w));
        return std::sqrt(squared_length(normal)) / edges;
      };
      const double before = height(f.before, [&](Vertex v) { return position_[v]; });
      const double after =
          height(f.after, [&](Vertex v) { return v == a || v == b ? target : position_[v]; });
      least = std::min(least, before);
      if (after < 2e-4 && before >= 2e-4)
        needles.push_back({std::sqrt(squared_length(f.after) / squared_length(f.before)), after});
    }
    return std::any_of(needles.begin(), needles.end(), [&](const Needle& n) {
      return n.area_left < 0.25 || n.height < 0.01 * least;
    });
  }

  static constexpr double degrees = 180 / std::numbers::pi; // in a radian

  static double degrees_between(const Position& m, const Position& n) {
    return std::acos(dot(m, n) / std::sqrt(squared_length(m) * squared_length(n))) * degrees;
  }

  // Does a face come to lie between a ridge and a valley of more than 90.45 degrees, as it did not
  // before? Looked for if a face turns by 20 degrees, where one looks away from the mean.
  bool makes_fold_over(Vertex a, Vertex b, const Position& target) const {
    const std::vector<Turn> changed = changed_faces(a, b, target);
    const double least_turn = std::acos(std::sqrt(0.883)) * degrees;
    Position mean{};
    for (const Turn& f : changed)
      mean = mean + f.after;
    return std::any_of(
               changed.begin(), changed.end(),
               [&](const Turn& f) { return degrees_between(f.before, f.after) > least_turn; }) &&
           std::any_of(changed.begin(), changed.end(), [&](const Turn& f) {
             return !(degrees_between(f.after, mean) < 60) && is_new_fold_over(f, a, b, target);
           });
  }

  bool is_new_fold_over(const Turn& f, Vertex a, Vertex b, const Position& target) const {
    const auto is_end = [&](Vertex v) { return v == a || v == b; };
    const auto is_same = [&](Vertex v, Vertex w) { return v == w || (is_end(v) && is_end(w)); };
    std::array<bool, 2> before{}, after{}; // over a ridge, over a valley
    for (const auto& face : faces_) {
      if (face.second == f.face || (has(face, a) && has(face, b)))
        continue;
      const Turn g = turn(face.second, a, b, target);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const Vertex p = f.face[i], q = f.face[(i + 1) % 3]; // an edge of one, and of the other
          if (!is_same(p, g.face[(j + 1) % 3]) || !is_same(q, g.face[j]))
            continue;
          const Position way = position_[g.face[(j + 2) % 3]] - position_[is_end(p) ? q : p];
          before[dot(f.before, way) < 0 ? 0 : 1] |= degrees_between(f.before, g.before) > 90.4476;
          after[dot(f.after, way) < 0 ? 0 : 1] |= degrees_between(f.after, g.after) > 90.4476;
        }
    }
    return after[0] && after[1] && !(before[0] && before[1]);
  }

  // --- The contraction ---------------------------------------------------------------------------

  Contraction contract(const Candidate& candidate, const Position& target) {
    Vertex kept = candidate.edge[0], gone = candidate.edge[1]; // clang captures no bindings
    if (target == position_[gone] && target != position_[kept])
      std::swap(kept, gone);
    error = std::max(error, std::sqrt(double(candidate.cost / plane_weight(candidate.edge))));
    remember({kept, gone, target});
    state_[kept].insert(state_[kept].end(), state_[gone].begin(), state_[gone].end());
    position_[kept] = target;
    image_[gone] = kept;
    std::erase_if(faces_, [&](const auto& face) { return has(face, kept) && has(face, gone); });
    for (auto& [f, t] : faces_)
      std::replace(t.begin(), t.end(), gone, kept);
    ring_radius_[kept] = distance_to_farthest_neighbour(kept);
    std::set<Vertex> changed = neighbours(kept);
    changed.insert({kept, gone});
    std::erase_if(rejected_, [&](const Edge& edge) {
      return changed.contains(edge[0]) || changed.contains(edge[1]);
    });
    return {kept, gone, target};
  }

  std::vector<Position> position_;
  std::vector<State> state_;
  std::vector<float> ring_radius_; // squared
  std::vector<Vertex> image_;
  std::map<Vertex, Triangle> faces_;
  std::set<Edge> rejected_;
};

} // namespace test

#endif // QUADRILLE_TEST_REFERENCE_H
