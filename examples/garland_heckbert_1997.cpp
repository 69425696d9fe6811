// garland_heckbert_1997 INPUT.off OUTPUT.off FACES [T]: simplifies a triangle mesh.
//
// This is the algorithm of Garland and Heckbert, Surface Simplification Using Quadric Error
// Metrics, 1997, from nothing, to be read beside the paper, whose sections are named. Nothing of
// the library is used, which does the same more carefully and for any mesh: see
// doc/manual/algorithm.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
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

// Section 5: Kₚ = ppᵀ, by which the error is the squared distance to the plane p = (a, b, c, d).
Quadric quadric_of_plane(const Vector& normal, const Vector& point, double weight = 1) {
  const Vector n = normal / std::max(std::sqrt(dot(normal, normal)), 1e-300);
  const Vector p{n[0], n[1], n[2], -dot(n, point)};
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

// Section 4: the place of the least error, by equation 1 and Cramer's rule. If the matrix cannot
// be inverted, as where all planes are one, it is the best of the ends and of what is between them.
Vector best_place(const Quadric& q, const Vector& v, const Vector& w) {
  const Vector a{q[0], q[1], q[2]}, b{q[4], q[5], q[6]}, c{q[8], q[9], q[10]};
  const double determinant = dot(a, cross(b, c)), trace = a[0] + b[1] + c[2];
  if (std::abs(determinant) > 1e-6 * std::pow(trace, 3))
    return (q[3] * cross(b, c) + q[7] * cross(c, a) + q[11] * cross(a, b)) / -determinant;
  Vector best = v;
  for (double part = 0.125; part <= 1; part += 0.125)
    if (const Vector place = (1 - part) * v + part * w; error(q, place) < error(q, best))
      best = place;
  return best;
}

struct Vertex {
  Vector point;
  Quadric quadric = Quadric(16);
  std::set<Index> faces{}, partners{}; // those that have it, and those of its valid pairs
  int changes = 0;
};
struct Pair {
  double cost;
  Index first, second;
  Vector target;
  int age;                                                              // the changes of both
  bool operator<(const Pair& other) const { return cost > other.cost; } // the least is on top
};

struct Simplification {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  Index faces; // that are left
  std::priority_queue<Pair> heap;

  // Section 4.1: quadrics (step 1), valid pairs (2), their targets and costs (3), a heap (4).
  Simplification(const std::vector<Vector>& points, std::vector<Triangle> input, double t)
      : triangles(std::move(input)), faces(triangles.size()) {
    for (const Vector& point : points)
      vertices.push_back({point});
    for (Index f = 0; f < faces; ++f)
      for (const Index v : triangles[f])
        vertices[v].faces.insert(f);
    for (Index f = 0; f < faces; ++f)
      for (Index i = 0; i < 3; ++i)
        add_edge(f, triangles[f][i], triangles[f][(i + 1) % 3]);
    for (Index v = 0; v < points.size(); ++v) {
      for (Index w = v + 1; w < points.size() && t > 0; ++w)
        if (dot(points[w] - points[v], points[w] - points[v]) < t * t)
          add_pair(v, w);
      push_pairs(v);
    }
  }

  void add_pair(Index v, Index w) {
    vertices[v].partners.insert(w);
    vertices[w].partners.insert(v);
  }
  Vector normal(Index f) const {
    const auto& [a, b, c] = triangles[f];
    return cross(vertices[b].point - vertices[a].point, vertices[c].point - vertices[a].point);
  }

  // Section 3.2: an edge is a valid pair. Section 5: a vertex has the planes of its faces. Section
  // 6: ends of an edge of one face also have a plane through it, upright on the face, that weighs.
  void add_edge(Index f, Index v, Index w) {
    const std::set<Index>&of_v = vertices[v].faces, &of_w = vertices[w].faces;
    add_pair(v, w);
    vertices[v].quadric += quadric_of_plane(normal(f), vertices[v].point);
    if (std::count_if(of_v.begin(), of_v.end(), [&](Index g) { return of_w.contains(g); }) == 1)
      for (const Index end : {v, w})
        vertices[end].quadric += quadric_of_plane(
            cross(normal(f), vertices[w].point - vertices[v].point), vertices[v].point, 1000);
  }

  // Section 4: the new vertex has the error of both, by Q = Q₁ + Q₂.
  void push_pairs(Index v) {
    for (const Index w : vertices[v].partners) {
      const Quadric q = vertices[v].quadric + vertices[w].quadric;
      const Vector target = best_place(q, vertices[v].point, vertices[w].point);
      heap.push({error(q, target), v, w, target, vertices[v].changes + vertices[w].changes});
    }
  }

  // Section 4.1, step 5: the pair of the least cost is contracted, again and again. Pairs with what
  // has changed are pushed anew; what they were before stays in the heap, and is known by its age.
  std::vector<Triangle> run(Index most) {
    for (; faces > most && !heap.empty();) {
      const Pair pair = heap.top();
      heap.pop();
      if (pair.age == vertices[pair.first].changes + vertices[pair.second].changes &&
          !turns(pair.first, pair.second, pair.target) &&
          !turns(pair.second, pair.first, pair.target))
        contract(pair);
    }
    std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1]; });
    return triangles;
  }

  // Section 6: no face may turn over where v goes to a place; those of v and w go.
  bool turns(Index v, Index w, const Vector& place) {
    for (const Index f : vertices[v].faces) {
      const Vector before = normal(f), point = std::exchange(vertices[v].point, place);
      const Vector after = normal(f);
      vertices[v].point = point;
      if (!vertices[w].faces.contains(f) && dot(before, after) < 0)
        return true;
    }
    return false;
  }

  // Section 3.1: (v₁, v₂) → v̄ moves both vertices to v̄, connects all that v₂ is connected with to
  // v₁, deletes v₂, and removes what has become degenerate, or is a face that is there already.
  void contract(const Pair& pair) {
    Vertex &kept = vertices[pair.first], &gone = vertices[pair.second];
    kept.point = pair.target;
    kept.quadric += gone.quadric;
    for (const Index f : std::exchange(gone.faces, {})) {
      std::replace(triangles[f].begin(), triangles[f].end(), pair.second, pair.first);
      const bool is_there = std::any_of(kept.faces.begin(), kept.faces.end(), [&](Index g) {
        return std::is_permutation(triangles[f].begin(), triangles[f].end(), triangles[g].begin());
      });
      kept.faces.insert(f);
      if (!is_there)
        continue;
      for (const Index v : std::exchange(triangles[f], {}))
        vertices[v].faces.erase(f);
      --faces;
    }
    for (const Index partner : std::exchange(gone.partners, {})) {
      vertices[partner].partners.erase(pair.second);
      if (partner != pair.first)
        add_pair(pair.first, partner);
    }
    ++kept.changes;
    ++gone.changes;
    push_pairs(pair.first);
  }
};

int main(int argc, char* argv[]) {
  std::ifstream in(argc > 3 ? argv[1] : "");
  std::string off, corners;
  Index vertices = 0, faces = 0, edges = 0;
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
  for (const Vertex& v : simplification.vertices)
    out << v.point[0] << ' ' << v.point[1] << ' ' << v.point[2] << '\n';
  for (const Triangle& t : triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
