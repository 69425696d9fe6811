// Can the borders of parts be found in the result? Simplifies a PLY file by parts, and once in one
// part, and compares edges, areas, degrees and distances near the places where borders were with
// those elsewhere; and colours, if the file has some.
//
//   quadrille_seams IN.ply FACES PARTS [memoryless|quadric [OUT.ply BORDERS]]
//
// OUT.ply is the result in parts, BORDERS-K.obj the borders of phase K as lines, BORDERS-one.ply
// the result in one part.
//
//   quadrille_seams measure IN.ply OUT.ply [BORDERS.obj]
//
// measures any result by its own, of the borders that a file has as lines.
//
// Near are vertices within two edges of a face that is closest to a point of a former border. For
// each phase it prints, of the run in parts and of the run in one part, which has no seams, at the
// same places: the share of faces that are near, and the ratios of the means near and elsewhere, of
// lengths of edges, areas of faces, degrees of vertices, and distances of faces to the input. Then
// distances over all: the root of the mean square, in parts, in one part, and the ratio.
#include <quadrille/file.h>
#include <quadrille/memoryless_quadric.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Point = Vector<3>;
using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 cgal(const Point& p) {
  return {p[0], p[1], p[2]};
}

double distance(const Point& p, const Point& q) {
  return std::sqrt(squared_length(p - q));
}

struct Surface {
  std::vector<Point> points;
  std::vector<Point> colors; ///< red, green and blue; or none
  std::vector<internal::FaceRow> faces;
  Triangles triangles;
  Tree tree;

  explicit Surface(const std::filesystem::path& path) {
    const internal::PlyInput ply(path);
    std::array<std::size_t, 3> places{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < ply.scalars().size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        if (ply.scalars().properties()[i].name == std::array{"red", "green", "blue"}[c]) {
          places[c] = i;
          ++found;
        }
    ply.for_vertices([&](internal::VertexId, const Point& p, const std::vector<double>& scalars) {
      points.push_back(p);
      if (found == 3)
        colors.push_back({scalars[places[0]], scalars[places[1]], scalars[places[2]]});
    });
    ply.for_faces([&](std::uint64_t, const internal::FaceRow& f, const auto&) {
      if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0])
        return;
      faces.push_back(f);
      triangles.emplace_back(cgal(points[f[0]]), cgal(points[f[1]]), cgal(points[f[2]]));
    });
    tree.rebuild(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
  }

  std::size_t face_at(const Point& p) const {
    return static_cast<std::size_t>(tree.closest_point_and_primitive(cgal(p)).second -
                                    triangles.begin());
  }
  double distance_to(const Point& p) const { return std::sqrt(tree.squared_distance(cgal(p))); }

  /// Of a point of a face.
  Point color_at(std::size_t face, const Point& p) const {
    const internal::FaceRow& f = faces[face];
    const auto area = [&](std::size_t i) {
      const Point a = points[f[(i + 1) % 3]] - p, b = points[f[(i + 2) % 3]] - p;
      return std::sqrt(squared_length(cross(a, b)));
    };
    const double sum = area(0) + area(1) + area(2);
    Point color{};
    for (std::size_t i = 0; i < 3; ++i)
      color += (sum > 0 ? area(i) / sum : 1. / 3) * colors[f[i]];
    return color;
  }
};

/// Points of a face at which it is measured, evenly spread.
std::array<Point, 4> samples(const Surface& s, std::size_t face) {
  const auto& [a, b, c] = s.faces[face];
  const Point middle = (1. / 3) * (s.points[a] + s.points[b] + s.points[c]);
  return {middle, 0.5 * (middle + s.points[a]), 0.5 * (middle + s.points[b]),
          0.5 * (middle + s.points[c])};
}

double area(const Surface& s, std::size_t face) {
  return std::sqrt(s.triangles[face].squared_area());
}

/// The root of the mean square of something over a surface.
template <class Square>
double rms(const Surface& s, Square square) {
  double sum = 0, weights = 0;
  for (std::size_t f = 0; f < s.faces.size(); ++f)
    for (const Point& p : samples(s, f)) {
      sum += area(s, f) * square(f, p);
      weights += area(s, f);
    }
  return std::sqrt(sum / weights);
}

double rms_distance(const Surface& s, const Surface& input) {
  return rms(s, [&](std::size_t, const Point& p) {
    const double d = input.distance_to(p);
    return d * d;
  });
}

/// From each vertex of the input to the place that is closest to it.
double rms_color(const Surface& s, const Surface& input) {
  double sum = 0;
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    const auto [p, primitive] = s.tree.closest_point_and_primitive(cgal(input.points[v]));
    const auto face = static_cast<std::size_t>(primitive - s.triangles.begin());
    sum += squared_length(s.color_at(face, {p.x(), p.y(), p.z()}) - input.colors[v]) / 3;
  }
  return std::sqrt(sum / static_cast<double>(input.points.size()));
}

using Segment = std::array<Point, 2>;

/// Edges of which several parts of the phase at work have faces.
std::vector<Segment> boundaries_of_phase(const internal::JobFolder& folder, unsigned phase,
                                         std::size_t memory_size) {
  const auto plan = internal::PhasePlan::read(folder.plan(phase));
  std::map<std::pair<internal::VertexId, internal::VertexId>, std::set<std::size_t>> chunks;
  std::map<internal::VertexId, Point> places;
  for (std::size_t p = 0; p < plan.chunks.size(); ++p) {
    const auto part = internal::LoadedChunk::read(folder, plan, p, memory_size);
    for (const auto& t : part.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [v, w] = std::minmax(t[i], t[(i + 1) % 3]);
        if (!part.is_shared[v] || !part.is_shared[w])
          continue;
        chunks[{part.ids[v], part.ids[w]}].insert(p);
        places[part.ids[v]] = part.positions[v];
        places[part.ids[w]] = part.positions[w];
      }
  }
  std::vector<Segment> borders;
  for (const auto& [edge, owners] : chunks)
    if (owners.size() > 1)
      borders.push_back({places[edge.first], places[edge.second]});
  return borders;
}

/// Means near and elsewhere.
struct Means {
  std::array<double, 2> sum{}, weight{};

  void add(bool is_near, double x, double w = 1) {
    sum[is_near] += w * x;
    weight[is_near] += w;
  }
  double ratio() const { return (sum[1] / weight[1]) / (sum[0] / weight[0]); }
};

struct Ratios {
  double share, length, area, degree, distance;
};

std::vector<bool> near_vertices(const Surface& s, const std::vector<Segment>& borders) {
  std::vector<bool> is_near(s.points.size());
  for (const Segment& b : borders)
    for (const Point& p : {b[0], 0.5 * (b[0] + b[1]), b[1]})
      for (const internal::VertexId v : s.faces[s.face_at(p)])
        is_near[v] = true;
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<bool> before = is_near;
    for (const internal::FaceRow& f : s.faces)
      if (before[f[0]] || before[f[1]] || before[f[2]])
        for (const internal::VertexId v : f)
          is_near[v] = true;
  }
  return is_near;
}

Ratios ratios(const Surface& s, const Surface& input, const std::vector<Segment>& borders) {
  const std::vector<bool> is_near = near_vertices(s, borders);
  Means lengths, areas, degrees, distances;
  std::vector<std::size_t> degree(s.points.size());
  std::size_t near_faces = 0;
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const auto& v = s.faces[f];
    const bool is_near_face = is_near[v[0]] && is_near[v[1]] && is_near[v[2]];
    near_faces += is_near_face;
    areas.add(is_near_face, area(s, f));
    for (const Point& p : samples(s, f))
      distances.add(is_near_face, input.distance_to(p), area(s, f));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = v[i], b = v[(i + 1) % 3];
      ++degree[a];
      lengths.add(is_near[a] && is_near[b], distance(s.points[a], s.points[b]));
    }
  }
  for (std::size_t v = 0; v < degree.size(); ++v)
    degrees.add(is_near[v], static_cast<double>(degree[v]));
  return {static_cast<double>(near_faces) / static_cast<double>(s.faces.size()), lengths.ratio(),
          areas.ratio(), degrees.ratio(), distances.ratio()};
}

void write_lines(const std::filesystem::path& path, const std::vector<Segment>& segments) {
  std::ofstream lines(path);
  for (const Segment& s : segments)
    for (const Point& p : s)
      lines << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (std::size_t i = 0; i < segments.size(); ++i)
    lines << "l " << 2 * i + 1 << ' ' << 2 * i + 2 << '\n';
}

void print(const std::string& what, const Ratios& in_chunks, const Ratios& in_one) {
  std::printf("%-10s near %4.1f %%, edges %.3f (%.3f), areas %.3f (%.3f), degrees %.3f (%.3f), "
              "distances %.3f (%.3f)\n",
              what.c_str(), 100 * in_chunks.share, in_chunks.length, in_one.length, in_chunks.area,
              in_one.area, in_chunks.degree, in_one.degree, in_chunks.distance, in_one.distance);
}

template <class Cost>
void compare(const std::vector<std::string>& words) {
  namespace fs = std::filesystem;
  const fs::path input = words[0];
  const auto faces = static_cast<std::size_t>(std::stod(words[1]));
  const fs::path work = fs::temp_directory_path() / ("seams-" + std::to_string(::getpid()));
  fs::create_directories(work);
  const fs::path output = words.size() > 4 ? fs::path(words[4]) : work / "parts.ply";
  const std::uint64_t all = internal::PlyInput(input).faces();
  OutOfCore options{.scratch = work / "scratch", .memory = 16'000'000'000};
  options.whole_faces = options.chunk_faces = all;
  const std::size_t memory_size = internal::ChunkConversion<Cost>::memory_size;
  simplify_file<Cost, OptimalPlacement>(input, work / "one.ply", FaceCount{faces}, options);
  options.whole_faces = 0;
  options.chunk_faces = all / std::stoul(words[2]) + 1;
  PartitionedSimplifier<Cost, OptimalPlacement> job(input, FaceCount{faces}, options);
  job.partition();
  std::vector<std::vector<Segment>> borders;
  const std::size_t chunks = job.chunks();
  do {
    borders.push_back(
        boundaries_of_phase(internal::JobFolder(options.scratch), job.phase(), memory_size));
    for (std::size_t part = 0; part < job.chunks(); ++part)
      job.simplify(part);
  } while (job.close());
  const FileReport report = job.merge(output);
  const Surface before(input), in_chunks(output), in_one(work / "one.ply");
  std::printf("%s: %zu faces in %zu parts, %u phases, to %zu; in one part to %zu\n",
              input.filename().c_str(), static_cast<std::size_t>(all), chunks, report.phases,
              in_chunks.faces.size(), in_one.faces.size());
  for (std::size_t k = 0; k < borders.size(); ++k)
    if (!borders[k].empty())
      print("phase " + std::to_string(k + 1), ratios(in_chunks, before, borders[k]),
            ratios(in_one, before, borders[k]));
  const double parted = rms_distance(in_chunks, before), whole = rms_distance(in_one, before);
  std::printf("RMS distance %.4g, in one part %.4g: %.4f\n", parted, whole, parted / whole);
  if (!before.colors.empty()) {
    const double color = rms_color(in_chunks, before), of_one = rms_color(in_one, before);
    std::printf("RMS of colours %.4g, in one part %.4g: %.4f\n", color, of_one, color / of_one);
  }
  for (std::size_t k = 0; k < borders.size() && words.size() > 5; ++k)
    write_lines(words[5] + "-" + std::to_string(k + 1) + ".obj", borders[k]);
  if (words.size() > 5)
    fs::copy_file(work / "one.ply", words[5] + "-one.ply", fs::copy_options::overwrite_existing);
  fs::remove_all(work);
}

std::vector<Segment> read_lines(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Segment> segments;
  std::string word;
  Segment segment;
  for (std::size_t ends = 0; file >> word && word == "v"; ++ends) {
    for (double& x : segment[ends % 2].coordinates)
      file >> x;
    if (ends % 2 == 1)
      segments.push_back(segment);
  }
  return segments;
}

/// A result of whatever program.
void measure(const std::vector<std::string>& words) {
  const Surface before(words[1]), after(words[2]);
  double farthest = 0;
  const double mean = rms(after, [&](std::size_t, const Point& p) {
    const double d = before.distance_to(p);
    farthest = std::max(farthest, d);
    return d * d;
  });
  std::printf("%zu faces, RMS distance %.4g, at most %.4g", after.faces.size(), mean, farthest);
  if (words.size() > 3) {
    const Ratios r = ratios(after, before, read_lines(words[3]));
    std::printf(", near %.1f %%, edges %.3f, areas %.3f, degrees %.3f, distances %.3f",
                100 * r.share, r.length, r.area, r.degree, r.distance);
  }
  std::printf("\n");
}

} // namespace

int main(int argc, char* argv[]) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() < 3)
      throw std::runtime_error(
          "quadrille_seams IN.ply FACES PARTS [memoryless|quadric [OUT.ply BORDERS]]");
    if (words[0] == "measure")
      measure(words);
    else if (words.size() > 3 && words[3] == "quadric")
      compare<Quadric>(words);
    else
      compare<MemorylessQuadric>(words);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
