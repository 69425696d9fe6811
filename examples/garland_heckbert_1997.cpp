// garland_heckbert_1997 INPUT.off OUTPUT.off FACES [T]: simplifies a triangle mesh.
//
// This is the algorithm of Garland and Heckbert, Surface Simplification Using Quadric Error
// Metrics, 1997, from nothing, to be read beside the paper, whose sections are named. Nothing of
// the library is used, which does the same more carefully and for any mesh: see
// doc/manual/algorithm.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <utility>
#include <valarray>
#include <vector>

using Vector = std::valarray<double>;  // (x, y, z)
using Quadric = std::valarray<double>; // a symmetric 4 × 4 matrix, row by row
using Index = std::size_t;
using Triangle = std::array<Index, 3>;

double dot(const Vector& a, const Vector& b) {
  return (a * b).sum();
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
  return a / std::max(std::sqrt(dot(a, a)), 1e-300);
}

// Section 5: Kₚ = ppᵀ, by which the error is the squared distance to the plane p = (a, b, c, d).
Quadric quadric_of_plane(const Vector& normal, const Vector& point, double weight = 1) {
  const Vector p{normal[0], normal[1], normal[2], -dot(normal, point)};
  Quadric k(16);
  for (Index i = 0; i < 16; ++i)
    k[i] = weight * p[i / 4] * p[i % 4];
  return k;
}

// Section 4: the error of a vertex at v = (x, y, z, 1) is vᵀQv.
double error(const Quadric& q, const Vector& at) {
  const Vector v{at[0], at[1], at[2], 1};
  double sum = 0;
  for (Index i = 0; i < 16; ++i)
    sum += q[i] * v[i / 4] * v[i % 4];
  return sum;
}

// Section 4, equation 1: the place of the least error, by Cramer's rule. There is none if the
// matrix cannot be inverted, as where all planes are one, or meet in a line.
std::optional<Vector> minimum(const Quadric& q) {
  const Vector a{q[0], q[1], q[2]}, b{q[4], q[5], q[6]}, c{q[8], q[9], q[10]};
  const double determinant = dot(a, cross(b, c)), trace = a[0] + b[1] + c[2];
  if (std::abs(determinant) <= 1e-6 * std::pow(trace, 3))
    return std::nullopt;
  return (q[3] * cross(b, c) + q[7] * cross(c, a) + q[11] * cross(a, b)) / -determinant;
}

class Simplification {
public:
  // Section 4.1: the quadrics of all vertices (step 1), the valid pairs (2), their targets and
  // costs (3), and a heap of them (4).
  Simplification(const std::vector<Vector>& points, std::vector<Triangle> triangles, double t)
      : triangles_(std::move(triangles)), faces_(triangles_.size()) {
    for (const Vector& point : points)
      vertices_.push_back({point, Quadric(16), {}, {}, 0});
    for (Index f = 0; f < triangles_.size(); ++f)
      for (const Index v : triangles_[f])
        vertices_[v].faces.insert(f);
    for (Index f = 0; f < triangles_.size(); ++f)
      for (Index i = 0; i < 3; ++i)
        add_edge(f, triangles_[f][i], triangles_[f][(i + 1) % 3]);
    add_close_pairs(t);
    for (Index v = 0; v < vertices_.size(); ++v)
      for (const Index partner : vertices_[v].partners)
        if (v < partner)
          push(v, partner);
  }

  // Section 4.1, step 5: the pair of the least cost is contracted, again and again. The costs of
  // its vertex's pairs are pushed anew; what they were before stays in the heap, and is known by
  // its age.
  std::vector<Triangle> run(std::size_t faces) {
    for (; faces_ > faces && !heap_.empty();) {
      const Pair pair = heap_.top();
      heap_.pop();
      if (pair.age == age(pair.first, pair.second) && !inverts_faces(pair))
        contract(pair);
    }
    std::erase_if(triangles_, [](const Triangle& t) { return t[0] == t[1]; });
    return triangles_;
  }
  const Vector& point(Index v) const { return vertices_[v].point; }

private:
  struct Vertex {
    Vector point;
    Quadric quadric;
    std::set<Index> faces, partners; // those that have it, and those with which it is a valid pair
    std::size_t changes;
  };
  struct Pair {
    double cost;
    Index first, second;
    Vector target;
    std::size_t age;
    bool operator<(const Pair& other) const { return cost > other.cost; } // the least is on top
  };

  Vector normal(Index f) const {
    const auto& [a, b, c] = triangles_[f];
    return cross(point(b) - point(a), point(c) - point(a));
  }
  bool has(Index f, Index v) const { return vertices_[v].faces.contains(f); }
  std::size_t age(Index v, Index w) const { return vertices_[v].changes + vertices_[w].changes; }
  void add_pair(Index v, Index w) {
    vertices_[v].partners.insert(w);
    vertices_[w].partners.insert(v);
  }

  // Section 3.2: an edge is a valid pair. Section 5: a vertex has the planes of its faces. Section
  // 6: if an edge has one face only, its ends also have a plane through it, upright on the face, of
  // a large weight.
  void add_edge(Index f, Index v, Index w) {
    const Vector n = unit(normal(f)), upright = unit(cross(n, point(w) - point(v)));
    add_pair(v, w);
    vertices_[v].quadric += quadric_of_plane(n, point(v));
    const std::set<Index>& faces = vertices_[v].faces;
    if (std::count_if(faces.begin(), faces.end(), [&](Index other) { return has(other, w); }) == 1)
      for (const Index end : {v, w})
        vertices_[end].quadric += quadric_of_plane(upright, point(v), 1000);
  }

  // Section 3.2: vertices closer than t are valid pairs too. They are near in the order of x.
  void add_close_pairs(double t) {
    std::multimap<double, Index> by_x;
    for (Index v = 0; v < vertices_.size(); ++v)
      by_x.emplace(point(v)[0], v);
    for (auto v = by_x.begin(); v != by_x.end(); ++v)
      for (auto w = std::next(v); w != by_x.end() && w->first - v->first < t; ++w) {
        const Vector between = point(w->second) - point(v->second);
        if (dot(between, between) < t * t)
          add_pair(v->second, w->second);
      }
  }

  // Section 4: the new vertex has the error of both quadrics, Q = Q₁ + Q₂, and goes to where that
  // is least; where there is no such place, to the best one on the segment: its ends, its middle,
  // and the lowest point of the parabola through the errors of these three.
  void push(Index v, Index w) {
    const Quadric q = vertices_[v].quadric + vertices_[w].quadric;
    std::optional<Vector> target = minimum(q);
    if (!target) {
      std::array<Vector, 4> places{point(v), 0.5 * (point(v) + point(w)), point(w), point(v)};
      const double e0 = error(q, places[0]), e1 = error(q, places[1]), e2 = error(q, places[2]);
      const double bend = 4 * (e0 - 2 * e1 + e2);
      if (bend > 0)
        places[3] += std::clamp((3 * e0 - 4 * e1 + e2) / bend, 0.0, 1.0) * (point(w) - point(v));
      target = *std::min_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
        return error(q, a) < error(q, b);
      });
    }
    heap_.push({error(q, *target), v, w, *target, age(v, w)});
  }

  // Section 6: a contraction that would turn the normal of a face over is not done.
  bool inverts_faces(const Pair& pair) {
    for (const auto& [v, other] : {std::pair(pair.first, pair.second), {pair.second, pair.first}})
      for (const Index f : vertices_[v].faces) {
        const Vector before = normal(f), place = std::exchange(vertices_[v].point, pair.target);
        const Vector after = normal(f);
        vertices_[v].point = place;
        if (!has(f, other) && dot(before, after) < 0) // a face of both goes
          return true;
      }
    return false;
  }

  // Section 3.1: (v₁, v₂) → v̄ moves both vertices to v̄, connects all that v₂ is connected with to
  // v₁, deletes v₂, and removes what has become degenerate: faces of both, and one of two on three
  // vertices.
  void contract(const Pair& pair) {
    Vertex &kept = vertices_[pair.first], &gone = vertices_[pair.second];
    kept.point = pair.target;
    kept.quadric += gone.quadric;
    for (const Index f : std::exchange(gone.faces, {})) {
      std::replace(triangles_[f].begin(), triangles_[f].end(), pair.second, pair.first);
      if (!kept.faces.insert(f).second || is_doubled(f))
        remove(f);
    }
    for (const Index partner : std::exchange(gone.partners, {})) {
      vertices_[partner].partners.erase(pair.second);
      if (partner != pair.first)
        add_pair(pair.first, partner);
    }
    ++kept.changes;
    ++gone.changes;
    for (const Index partner : kept.partners)
      push(pair.first, partner);
  }
  bool is_doubled(Index f) const {
    const auto& [a, b, c] = triangles_[f];
    for (const Index other : vertices_[a].faces)
      if (other != f && has(other, b) && has(other, c))
        return true;
    return false;
  }
  void remove(Index f) {
    for (const Index v : std::exchange(triangles_[f], {}))
      vertices_[v].faces.erase(f);
    --faces_;
  }

  std::vector<Triangle> triangles_;
  std::size_t faces_; // that are left
  std::vector<Vertex> vertices_;
  std::priority_queue<Pair> heap_;
};

int main(int argc, char* argv[]) {
  std::ifstream in(argc > 3 ? argv[1] : "");
  std::string off, corners;
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> off >> vertices >> faces >> edges;
  std::vector<Vector> points(vertices, Vector(3));
  std::vector<Triangle> triangles(faces);
  for (Vector& p : points)
    in >> p[0] >> p[1] >> p[2];
  for (Triangle& t : triangles)
    in >> corners >> t[0] >> t[1] >> t[2];
  if (!in || off != "OFF") {
    std::cerr << "garland_heckbert_1997 INPUT.off OUTPUT.off FACES [T], of triangles\n";
    return EXIT_FAILURE;
  }
  Simplification simplification(points, triangles, argc > 4 ? std::stod(argv[4]) : 0);
  triangles = simplification.run(std::stoul(argv[3]));

  std::ofstream out(argv[2]);
  out << "OFF\n"
      << vertices << ' ' << triangles.size() << " 0\n"; // all points are left in the file
  for (Index v = 0; v < vertices; ++v)
    out << simplification.point(v)[0] << ' ' << simplification.point(v)[1] << ' '
        << simplification.point(v)[2] << '\n';
  for (const Triangle& t : triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
