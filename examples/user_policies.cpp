// One policy of each kind written by the user, a filter and a guard. Simplifies a Surface_mesh with
// each.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <quadrille/guard.h>
#include <quadrille/simplify.h>
#include <vector>

using namespace quadrille;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A cost: how far the ends move, times the area of all faces that have gone into them.
struct MovedArea {
  static constexpr std::size_t dimension = 3;
  struct State {
    double area = 0;
    void operator+=(const State& other) { area += other.area; }
  };
  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return {std::sqrt(squared_length(double_area_vector(p, q, r)))};
  }
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.state.area * (squared_distance(pair.first, x) + squared_distance(pair.second, x));
  }
  double squared_error(const auto& pair, double cost) const { return cost / pair.state.area; }
};

// A placement: the cheapest of nine points from one end to the other.
struct OnSegment {
  auto operator()(const auto& cost, const auto& pair) const {
    auto best = pair.first;
    for (int i = 1; i <= 8; ++i) {
      const auto x = pair.first + i / 8.0 * (pair.second - pair.first);
      if (cost(pair, x) < cost(pair, best))
        best = x;
    }
    return best;
  }
};

// Pairs: the edges, and vertices in one place, so that parts that only touch grow together.
struct EdgesAndSeams {
  static constexpr bool includes_edges = true;
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    const auto place = [&](std::size_t v) { return surface.points[v].coordinates; };
    std::vector<std::size_t> order(surface.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, place);
    for (std::size_t i = 1; i < order.size(); ++i)
      if (place(order[i - 1]) == place(order[i]))
        emit(order[i - 1], order[i]);
  }
};

// A stop: when the time is up.
struct Deadline {
  std::chrono::steady_clock::time_point end;
  bool operator()(const Status&) const { return std::chrono::steady_clock::now() >= end; }
};

// A filter: no face of which an edge at the new vertex gets longer than twice what it was.
struct NoStretch {
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      for (const auto& end : {face.second, face.third})
        if (squared_distance(face.after, end) > 4 * squared_distance(face.before, end))
          return false;
    return true;
  }
};

// A filter that is told indices: it keeps away from selected vertices.
struct KeepAway {
  const std::vector<bool>* is_selected; // of each vertex
  bool allows(const auto& contraction) const {
    return !(*is_selected)[contraction.first()] && !(*is_selected)[contraction.second()];
  }
};

// A cost that is told indices: how far the ends move, times the importance of the most important
// vertex of the input that they stand for.
struct ByImportance {
  static constexpr std::size_t dimension = 3;
  struct State {
    double importance = 0;
    void operator+=(const State& m) { importance = std::max(importance, m.importance); }
  };
  const std::vector<double>* importance; // of each vertex
  State face(const Vector<3>&, const Vector<3>&, const Vector<3>&) const { return {}; }
  State input_vertex(std::size_t index) const { return {(*importance)[index]}; }
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.state.importance *
           (squared_distance(pair.first, x) + squared_distance(pair.second, x));
  }
};

// A guard: no vertex leaves its cell of a grid. It knows the cell of each vertex of the input.
struct SameCell {
  double size; // of a cell, in the mesh's units

  static Vector<3> cell(const auto& p, double size) {
    return {{std::floor(p[0] / size), std::floor(p[1] / size), std::floor(p[2] / size)}};
  }
  struct State {
    double size;
    std::vector<Vector<3>> cells; // of each vertex
    bool allows(const auto& contraction) const {
      const Vector<3>& first = cells[contraction.first()];
      return first == cells[contraction.second()] && first == cell(contraction.target(), size);
    }
    void follow(const auto&) {} // the vertex that is kept has the cell that it had
  };
  State begin(const GuardedSurface& surface) const {
    State state{size, std::vector<Vector<3>>(surface.vertex_count)};
    for (const auto& [index, point] : surface.vertices)
      state.cells[index] = cell(point, size);
    return state;
  }
};

int main(int argc, char* argv[]) {
  Mesh mesh;
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  std::vector<bool> is_selected;
  for (const Mesh::Vertex_index v : mesh.vertices())
    is_selected.push_back(mesh.point(v).x() > 0);
  std::vector<double> importance;
  for (const bool selected : is_selected)
    importance.push_back(selected ? 100 : 1);
  const auto run = [mesh](const char* name, const auto&... policies) {
    Mesh copy = mesh;
    std::cout << name << ": " << simplify(copy, policies...) << '\n';
  };
  run("cost", MovedArea{}, MidpointPlacement{});
  run("placement", OnSegment{}, FaceCount{1000});
  run("pairs", EdgesAndSeams{}, FaceCount{1000});
  run("stop", Deadline{std::chrono::steady_clock::now() + std::chrono::milliseconds(2)});
  run("filter", NoStretch{}, FaceCount{1000});
  run("selection", KeepAway{&is_selected});
  run("guard", SameCell{0.02}, FaceCount{0});
  run("importance", ByImportance{&importance}, MidpointPlacement{});
  run("all", MovedArea{}, OnSegment{}, EdgesAndSeams{}, FaceCount{1000}, NoStretch{});
}
