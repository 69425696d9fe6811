// SPDX-License-Identifier: MIT
//
// What takes part in the benchmark, and the surfaces that are handed around.

#ifndef QUADRILLE_BENCHMARK_CONTENDER_H
#define QUADRILLE_BENCHMARK_CONTENDER_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <time.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

using Triangles = std::vector<std::array<std::uint32_t, 3>>; ///< by three indices each

/// What corners of triangles have beside positions: colours, or texture coordinates.
struct Attributes {
  std::size_t components = 0; ///< of a value; 0 if there is nothing
  std::vector<double> values; ///< the components of one value after the other
  Triangles triangles;        ///< the values of each triangle's corners

  std::size_t size() const { return components == 0 ? 0 : values.size() / components; }
};

/// Triangles of any kind, non-manifold ones included.
struct Soup {
  std::vector<Point> points;
  Triangles triangles;
  Attributes attributes = {};
};

/// What a contender tells beside the mesh that it leaves behind.
struct Answer {
  /// Processor time without the conversions from and to Surface_mesh, for those that need any.
  std::optional<double> own_seconds;
  /// The result before it was made a Surface_mesh, which can hold no non-manifold edge.
  std::optional<Soup> soup;
};

/// One way to simplify a mesh.
struct Contender {
  std::string name;
  std::string options; ///< the settings it runs with, to be shown beside the table
  /// Brings the mesh, in place, to `faces` faces or as near as it can. The whole call is timed.
  /// Faces that are only marked as removed may stay in the mesh.
  std::function<Answer(Mesh& mesh, std::size_t faces)> simplify;
  bool is_slow = false; ///< does it take part only where it is named?
};

std::vector<Contender> our_contenders();
std::vector<Contender> cgal_contenders();
// The following are empty where the library was not found.
std::vector<Contender> meshoptimizer_contenders();
std::vector<Contender> openmesh_contenders();
std::vector<Contender> vtk_contenders();

/// The faces and vertices of a mesh, renumbered without gaps.
Soup to_soup(const Mesh& mesh);

/// The mean length of its edges; 0 without any.
double mean_edge_length(const Mesh& mesh);

/// Moves each coordinate by at most that many mean edge lengths, the same on every platform.
void add_noise(Mesh& mesh, double edges, std::uint64_t seed);

/// Makes `mesh` anew from triangles. A triangle that a Surface_mesh cannot take gets vertices of
/// its own.
void to_mesh(const Soup& soup, Mesh& mesh);

/// Counts the processor time of all threads: that of a busy machine differs little from that of an
/// idle one, which the wall clock's does.
class Stopwatch {
public:
  double seconds() const { return now() - start_; }

private:
  static double now() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
  }

  double start_ = now();
};

} // namespace bench

#endif
