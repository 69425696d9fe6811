#include "cases.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace test {

using namespace quadrille;

// --- From bytes ----------------------------------------------------------------------------------

std::uint8_t Bytes::byte() {
  if (bytes_.empty())
    return 0;
  const std::uint8_t first = bytes_.front();
  bytes_ = bytes_.subspan(1);
  return first;
}

std::uint64_t Bytes::word() {
  std::uint64_t word = 0;
  for (int i = 0; i < 8; ++i)
    word = word << 8 | byte();
  return word;
}

namespace {

AnyStop make_stop(Bytes& bytes, std::size_t faces) {
  const std::size_t count = faces * bytes.byte() / 256;
  const double error = std::ldexp(1.0, static_cast<int>(bytes.below(40)) - 30);
  switch (bytes.below(8)) {
  case 1:
    return {FaceCount{count}};
  case 2:
    return {FaceRatio{static_cast<double>(count) / 256}};
  case 3:
    return {VertexCount{count / 2}};
  case 4:
    return {DistanceLimit(error)};
  case 5:
    return {AfterContractions{count / 2}};
  case 6:
    return {AnyOf(FaceCount{count}, DistanceLimit::relative(error))};
  case 7:
    return {AllOf(VertexCount{count}, AfterContractions{count / 4})};
  default:
    return {Never{}};
  }
}

Call make_call(Bytes& bytes, std::size_t faces) {
  constexpr std::array<double, 6> degrees{90, 180, 90, 45, 5, 120};
  Call call;
  call.cost = static_cast<CostName>(bytes.below(4));
  call.placement = static_cast<PlacementName>(bytes.below(3));
  const std::uint8_t topology = bytes.byte();
  call.topology = topology % 2 == 1 ? Topology::free
                  : topology < 128  ? Topology::kept
                                    : Topology::parts_may_vanish;
  call.stop = make_stop(bytes, faces);
  if (bytes.one_in(2))
    call.relaxed = RelaxedOrder{.share = (1.0 + bytes.byte()) / 256, .refresh = bytes.one_in(2)};
  if (bytes.one_in(2))
    call.threshold = std::ldexp(1 + bytes.byte() / 256.0, static_cast<int>(bytes.below(24)) - 20);
  call.flip_degrees = degrees[bytes.below(degrees.size())];
  if (bytes.one_in(4))
    call.smallest_angle = 60 * (bytes.byte() / 255.0);
  if (bytes.one_in(4))
    call.degree = 3 + bytes.below(20);
  if (bytes.one_in(4))
    call.boundary_weight = bytes.one_in(2) ? 0 : std::ldexp(1.0, bytes.byte() - 128);
  if (bytes.one_in(4))
    call.crease_degrees = 180 * (bytes.byte() / 255.0);
  if (bytes.one_in(4))
    call.weighting = Weighting::uniform;
  if (bytes.one_in(16))
    call.cancel_at = 1 + bytes.below(32);
  if (call.cost == CostName::memoryless && bytes.one_in(2))
    call.cost = CostName::thin_feature;
  return call;
}

// Takes out about one face in `step`, no two that touch.
Soup with_holes_apart(Soup soup, std::uint64_t seed, std::size_t step) {
  Random random(seed);
  std::vector<bool> is_beside(soup.points.size(), false);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const auto is_used = [&](std::uint32_t v) -> bool { return is_beside[v]; };
    if (random.below(step) > 0 || std::any_of(t.begin(), t.end(), is_used))
      return false;
    for (std::uint32_t v : t)
      is_beside[v] = true;
    return true;
  });
  return soup;
}

Soup make_base(Bytes& bytes, int size) {
  const auto n = static_cast<std::uint32_t>(size) * static_cast<std::uint32_t>(2 + bytes.below(5));
  switch (bytes.below(12)) {
  case 1:
    return grid(n, n + 1);
  case 2:
    return sphere(1 + size / 4);
  case 3:
    return torus(n + 1, n + 2);
  case 4:
    return plate_with_holes(1 + static_cast<int>(n) % 3, 1 + size / 4);
  case 5:
    return open_cylinder(n + 2, n);
  case 6: // cubes that touch in edges and vertices
    return surface_of_cubes(3, 3, 2, [&](int, int, int) { return bytes.one_in(2); });
  case 7:
    return joined(sphere(1), sphere(1), {{1 + bytes.byte() / 128.0, 0, 0}});
  case 8:
    return with_flipped_edges(torus(n + 1, n + 2), bytes.byte(), 8);
  case 9:
    return with_holes(with_flipped_edges(grid(n, n), bytes.byte(), 8), bytes.byte(), 3);
  case 10:
    return joined(tetrahedron(), cube(1), {{2, 0, 0}});
  case 11:
    return with_holes_apart(torus(2 * n + 1, n + 2), bytes.byte(), 1 + bytes.below(16));
  default:
    return {};
  }
}

double make_coordinate(Bytes& bytes, bool is_any) {
  return is_any ? std::bit_cast<double>(bytes.word()) : static_cast<std::int8_t>(bytes.byte());
}

// Points and triangles of any kind, at the base or beside it.
void add_parts(Bytes& bytes, Soup& soup) {
  const bool is_any = bytes.one_in(16);
  for (std::size_t n = bytes.below(24); n > 0; --n) {
    const double x = make_coordinate(bytes, is_any), y = make_coordinate(bytes, is_any);
    soup.points.push_back({{x, y, make_coordinate(bytes, is_any)}});
  }
  if (soup.points.empty())
    return;
  const std::size_t indices = soup.points.size() + bytes.one_in(64);
  for (std::size_t n = bytes.below(64); n > 0; --n) {
    const auto corner = [&] { return static_cast<std::uint32_t>(bytes.below(indices)); };
    const std::uint32_t a = corner(), b = corner();
    soup.triangles.push_back({a, b, corner()});
  }
}

// Turns, glues, copies and takes out faces, and moves points onto others.
void change(Bytes& bytes, Soup& soup) {
  for (std::size_t n = bytes.below(16); n > 0 && !soup.triangles.empty(); --n) {
    Triangle& t = soup.triangles[(bytes.byte() * 256u + bytes.byte()) % soup.triangles.size()];
    const std::uint32_t v = t[bytes.below(3)];
    switch (bytes.below(6)) {
    case 0:
      t = soup.triangles.back();
      soup.triangles.pop_back();
      break;
    case 1:
      std::swap(t[0], t[1]);
      break;
    case 2:
      t[bytes.below(3)] = static_cast<std::uint32_t>(bytes.below(soup.points.size()));
      break;
    case 3:
      soup.triangles.push_back(Triangle(t));
      break;
    case 4:
      if (v < soup.points.size())
        soup.points[v] = soup.points[bytes.below(soup.points.size())];
      break;
    default:
      if (v < soup.points.size())
        for (double& x : soup.points[v].coordinates)
          x += static_cast<std::int8_t>(bytes.byte()) / 64.0;
    }
  }
}

// Noise, scales and flattens.
void deform(Bytes& bytes, Soup& soup) {
  if (bytes.one_in(2))
    soup = with_noise(std::move(soup), bytes.byte(), std::ldexp(1.0, -1 - int(bytes.below(50))));
  if (!bytes.one_in(4))
    return;
  Position factor, offset;
  for (std::size_t i = 0; i < 3; ++i) {
    factor[i] = bytes.one_in(4) ? 0 : std::ldexp(1.0, 8 * (int(bytes.below(240)) - 120));
    offset[i] = bytes.one_in(2) ? 0 : factor[i] * bytes.byte();
  }
  soup = mapped(std::move(soup), [&](const Position& p) {
    Position q;
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = factor[i] * p[i] + offset[i];
    return q;
  });
}

// Two numbers a point that follow the surface and jump here and there, or any at all.
void make_numbers(Bytes& bytes, Case& result) {
  const bool is_any = bytes.one_in(8);
  for (const Position& p : result.soup.points) {
    if (is_any)
      result.numbers.push_back({make_coordinate(bytes, true), make_coordinate(bytes, true)});
    else
      result.numbers.push_back({p[0] > 0 ? 1 : bytes.byte() / 16.0, bytes.one_in(8) ? -7.0 : 0});
  }
  if (bytes.one_in(4))
    result.weights = {std::ldexp(1.0, bytes.byte() - 128), 1 / 16.0};
  result.may_be_refused = is_any || result.weights;
  result.call.cost = CostName::attributes;
}

Case make_case_without_channels(Bytes& bytes, int size) {
  Case result;
  Soup& soup = result.soup;
  soup = make_base(bytes, bytes.one_in(4) ? 4 * size : size); // passes need larger ones
  if (!bytes.one_in(2)) {                                     // else a mesh can be made of most
    add_parts(bytes, soup);
    change(bytes, soup);
  }
  deform(bytes, soup);
  result.call = make_call(bytes, soup.triangles.size());
  const bool has_colors = bytes.one_in(2);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    result.colors.emplace_back(has_colors ? bytes.byte() : 0, has_colors ? v % 256 : 0, 0);
  const bool has_fixed = bytes.one_in(4);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    result.is_fixed.push_back(has_fixed && bytes.one_in(4));
  const bool has_kept = bytes.one_in(4);
  if (bytes.one_in(4))
    make_numbers(bytes, result);
  else
    result.numbers.resize(soup.points.size());
  if (!bytes.one_in(2) || !is_finite(soup))
    return result;
  for (const Triangle& t : soup.triangles)
    for (std::uint32_t v : t)
      if (v >= soup.points.size())
        return result;
  const SoupTopology topology = topology_of(soup);
  result.is_mesh = topology.is_manifold && topology.is_oriented && !topology.has_duplicate_faces &&
                   !topology.has_collapsed_faces &&
                   // in some orders of faces CGAL's add_face() loses its way
                   is_valid_triangle_mesh(make_mesh(soup));
  if (result.is_mesh && has_kept)
    for (const auto& [a, b, c] : soup.triangles)
      if (bytes.one_in(8))
        result.kept.push_back({std::min(a, b), std::max(a, b)});
  return result;
}

} // namespace

Case make_case(Bytes bytes, int size) {
  Case result = make_case_without_channels(bytes, size);
  if (!result.is_mesh && bytes.one_in(4)) {
    result.call.cost = CostName::channels;
    result.numbers.assign(result.soup.points.size(), {});
    result.seed = bytes.word();
  }
  return result;
}

// --- To text -------------------------------------------------------------------------------------

std::ostream& operator<<(std::ostream& out, const Call& call) {
  out << "cost " << static_cast<int>(call.cost) << ", placement "
      << static_cast<int>(call.placement) << ", boundary weight " << call.boundary_weight
      << ", creases above " << call.crease_degrees << " degrees, weighting "
      << static_cast<int>(call.weighting) << ", stop " << call.stop.chosen.index();
  out << ", pairs closer than " << call.threshold;
  if (call.relaxed)
    out << ", relaxed order, share " << call.relaxed->share << ", refresh "
        << call.relaxed->refresh;
  return out << ", topology "
             << (call.topology == Topology::kept   ? "kept"
                 : call.topology == Topology::free ? "free"
                                                   : "kept, parts may vanish")
             << ", normals turn by " << call.flip_degrees << " degrees, angles of at least "
             << call.smallest_angle
             << ", degree " << call.degree << ", cancelled at call " << call.cancel_at;
}

void write_numbers(std::ostream& out, const Case& input) {
  out.precision(17);
  out << "\n# numbers:";
  for (const Numbers& n : input.numbers)
    out << ' ' << n[0] << ',' << n[1];
  if (input.weights)
    out << "; weights " << (*input.weights)[0] << ' ' << (*input.weights)[1];
}

std::ostream& operator<<(std::ostream& out, const Case& input) {
  out << "OFF\n# " << (input.is_mesh ? "mesh, " : "soup, ") << input.call << "\n# fixed:";
  for (std::size_t v = 0; v < input.is_fixed.size(); ++v)
    if (input.is_fixed[v])
      out << ' ' << v;
  if (input.call.cost == CostName::attributes)
    write_numbers(out, input);
  if (input.call.cost == CostName::channels)
    out << "\n# channels: seed " << input.seed;
  out << "\n# constrained edges:";
  for (const auto& [v, w] : input.kept)
    out << ' ' << v << '-' << w;
  out << '\n' << input.soup.points.size() << ' ' << input.soup.triangles.size() << " 0\n";
  out.precision(17);
  for (const Position& p : input.soup.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& [a, b, c] : input.soup.triangles)
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return out;
}

// --- The result ----------------------------------------------------------------------------------

template <class Cost>
void simplify_soup(const Case& input, Outcome& outcome, const Cost& cost);
template <class Cost>
void simplify_mesh(const Case& input, Outcome& outcome, const Cost& cost);

void simplify_soup_with_channels(const Case& input, Outcome& outcome);

template <class Cost>
void simplify_with(const Case& input, Outcome& outcome, const Cost& cost) {
  input.is_mesh ? simplify_mesh(input, outcome, cost) : simplify_soup(input, outcome, cost);
}

void simplify_by_cost(const Case& input, Outcome& outcome) {
  const Call& call = input.call;
  switch (call.cost) {
  case CostName::quadric:
    return simplify_with(input, outcome,
                         Quadric{.boundary_weight = call.boundary_weight,
                                 .crease_degrees = call.crease_degrees,
                                 .weighting = call.weighting});
  case CostName::memoryless:
    return simplify_with(input, outcome,
                         MemorylessQuadric{.boundary_weight = call.boundary_weight});
  case CostName::thin_feature: {
    ThinFeatureQuadric cost;
    cost.boundary_weight = call.boundary_weight;
    return simplify_with(input, outcome, cost);
  }
  case CostName::color: {
    ColorQuadric cost;
    cost.boundary_weight = call.boundary_weight;
    cost.weighting = call.weighting;
    return simplify_with(input, outcome, cost);
  }
  case CostName::edge_length:
    return simplify_with(input, outcome, EdgeLength{});
  case CostName::attributes: {
    TextureQuadric cost;
    cost.boundary_weight = call.boundary_weight;
    cost.weighting = call.weighting;
    if (input.weights)
      cost.weights = Vector<2>{*input.weights};
    return simplify_with(input, outcome, cost);
  }
  case CostName::channels:
    return simplify_soup_with_channels(input, outcome);
  }
}

void simplify(const Case& input, Outcome& outcome) {
  outcome.points = points_of(input.soup);
  outcome.triangles = input.soup.triangles;
  outcome.colors = input.colors;
  outcome.numbers = input.numbers;
  simplify_by_cost(input, outcome);
}

namespace {

bool has_finite(const Numbers& numbers) {
  return std::isfinite(numbers[0]) && std::isfinite(numbers[1]);
}

/// The same for all triangles on the same vertices; or, if sides are told apart, for those of them
/// that run the same way round.
Triangle key_of(Triangle t, bool tells_sides) {
  if (tells_sides)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  else
    std::sort(t.begin(), t.end());
  return t;
}

/// The triangles without those that have two equal corners and without doubles.
Soup cleaned(Soup soup, bool tells_sides) {
  std::set<Triangle> seen;
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
           !seen.insert(key_of(t, tells_sides)).second;
  });
  return soup;
}

std::size_t count_non_manifold_edges(const Soup& soup) {
  std::map<std::array<std::uint32_t, 2>, int> faces;
  for (const auto& [a, b, c] : soup.triangles)
    for (const auto& [v, w] : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)})
      ++faces[{v, w}];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& e) { return e.second > 2; }));
}

double squared_distance_to_segment(const Position& x, const Position& p, const Position& q) {
  const double length = squared_distance(p, q);
  const double t = length > 0 ? std::clamp(dot(x - p, q - p) / length, 0.0, 1.0) : 0;
  return squared_distance(x, p + t * (q - p));
}

double squared_distance_to_triangle(const Position& x, const Position& p, const Position& q,
                                    const Position& r) {
  double least =
      std::min({squared_distance_to_segment(x, p, q), squared_distance_to_segment(x, q, r),
                squared_distance_to_segment(x, r, p)});
  const Position n = cross(q - p, r - p);
  const auto is_left = [&](const Position& a, const Position& b) {
    return dot(cross(b - a, x - a), n) >= 0;
  };
  if (squared_length(n) > 0 && is_left(p, q) && is_left(q, r) && is_left(r, p))
    least = std::min(least, dot(x - p, n) * dot(x - p, n) / squared_length(n));
  return least;
}

/// What is promised of a result, looked at one by one; the first that does not hold is told.
// The Euler characteristic of each part and how many borders it has, in order.
std::multiset<std::array<std::ptrdiff_t, 2>> topologies_of_parts(const Soup& soup) {
  detail::Partition parts(soup.points.size());
  for (const auto& [a, b, c] : soup.triangles)
    parts.merge(a, b), parts.merge(b, c);
  std::map<std::uint32_t, Soup> by_root;
  for (const Triangle& t : soup.triangles) {
    Soup& part = by_root[parts.root(t[0])];
    part.points = soup.points;
    part.triangles.push_back(t);
  }
  std::multiset<std::array<std::ptrdiff_t, 2>> result;
  for (const auto& [root, part] : by_root) {
    const SoupTopology topology = topology_of(part);
    result.insert({static_cast<std::ptrdiff_t>(topology.euler()),
                   static_cast<std::ptrdiff_t>(topology.border_loops)});
  }
  return result;
}

class Judge {
public:
  Judge(const Case& input, const Outcome& outcome)
      : input_(input), call_(input.call), report_(outcome.report), outcome_(outcome),
        before_(cleaned(input.soup, !input.is_mesh)), topology_before_(topology_of(before_)) {
    for (const Point& p : outcome.points)
      after_.points.push_back(to_position(p));
    after_.triangles = outcome.triangles;
  }

  std::string violation() {
    require_valid();
    if (!complaint_.empty())
      return complaint_;
    if (report_.stop == StopReason::cancelled && report_.contractions == 0)
      return require_untouched();
    topology_after_ = topology_of(after_);
    require_clean();
    require_report();
    require_target();
    require_distance();
    require_constraints();
    require_topology();
    require_endpoints();
    return complaint_;
  }

private:
  void require(bool holds, const std::string& what) {
    if (!holds && complaint_.empty())
      complaint_ = what;
  }

  // Cancelled before the first contraction it is as it was, with all that is odd about it.
  std::string require_untouched() {
    require(report_.faces_after == report_.faces_before, "faces went though nothing was done");
    return complaint_;
  }

  void require_valid() {
    require(is_finite(after_), "a point is not finite");
    require(outcome_.colors.size() >= after_.points.size(), "colours are missing");
    require(outcome_.numbers.size() >= after_.points.size(), "attributes are missing");
    for (std::size_t v = 0; v < after_.points.size() && v < outcome_.numbers.size(); ++v)
      require(has_finite(outcome_.numbers[v]), "an attribute is not finite");
    for (const Triangle& t : after_.triangles)
      for (std::uint32_t v : t)
        require(v < after_.points.size(), "an index of no point");
  }

  void require_clean() {
    require(!topology_after_.has_collapsed_faces, "a face with two equal corners");
    const bool has_sides = topology_before_.has_duplicate_faces && !input_.is_mesh;
    require(cleaned(after_, has_sides).triangles.size() == after_.triangles.size() ||
                report_.duplicated_vertices > 0,
            "a duplicate face");
    require(topology_after_.vertices == after_.points.size(), "a point of no face");
  }

  void require_report() {
    require(report_.faces_before == input_.soup.triangles.size(), "faces_before");
    require(input_.is_mesh || report_.counted_faces == before_.triangles.size(), "counted_faces");
    require(report_.vertices_before == input_.soup.points.size(), "vertices_before");
    require(report_.faces_after == after_.triangles.size(), "faces_after");
    require(report_.vertices_after == after_.points.size(), "vertices_after");
    require(report_.contractions + report_.vertices_after - report_.duplicated_vertices <=
                topology_before_.vertices,
            "more contractions than vertices are gone");
    require(report_.error >= 0 && std::isfinite(report_.error), "the error is not a distance");
    require(report_.components_before == topology_before_.components, "components_before");
    require(call_.threshold > 0 || report_.non_edge_contractions == 0, "non_edge_contractions");
    if (report_.duplicated_vertices > 0)
      return; // the numbers are those of the surface before it is taken apart
    require(report_.components_after == topology_after_.components, "components_after");
    require(report_.non_manifold_edges == count_non_manifold_edges(after_), "non_manifold_edges");
    require((report_.non_manifold_edges == 0 && report_.non_manifold_vertices == 0) ==
                topology_after_.is_manifold,
            "non_manifold_vertices");
  }

  void require_target() {
    if (report_.stop == StopReason::cancelled)
      return require(call_.cancel_at < 1000, "cancelled by nobody");
    Status status;
    status.initial_faces = before_.triangles.size();
    status.initial_vertices = topology_before_.vertices;
    status.faces = report_.faces_after;
    status.vertices = report_.vertices_after - report_.duplicated_vertices;
    status.contractions = report_.contractions;
    const bool is_met = is_target_reached(report_.stop);
    if (std::holds_alternative<DistanceLimit>(call_.stop.chosen)) {
      // What may be nothing but rounding passes any limit: see DistanceLimit.
      double coordinate = 0;
      for (const Position& p : before_.points)
        for (double x : p.coordinates)
          coordinate = std::max(coordinate, std::abs(x));
      status.next_distance = std::max(0.0, report_.distance_bound - 0x1p-39 * coordinate);
      require(!call_.stop(status), "the result is beyond the limit");
    } else if (call_.stop.chosen.index() != 6) { // the next distance is not known here
      require(call_.stop(status) == is_met, "the target and the reason to stop do not agree");
    }
    if (std::holds_alternative<AfterContractions>(call_.stop.chosen) && is_met)
      require(report_.contractions == std::get<AfterContractions>(call_.stop.chosen).count,
              "contractions after the target was met");
  }

  // At the corners and in the middle of each face.
  void require_distance() {
    if (before_.triangles.empty() || before_.triangles.size() * after_.triangles.size() > 20'000)
      return;
    const double size = diagonal(before_);
    if (!(size > 1e-60 && size < 1e60))
      return; // squares over- or underflow here
    double far = 0;
    for (const Position& p : before_.points)
      far = std::max(far, std::sqrt(squared_length(p)));
    const double limit = report_.distance_bound * (1 + 1e-6) + 1e-9 * size + 1e-14 * far;
    const auto require_near = [&](const Position& x) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [a, b, c] : before_.triangles)
        nearest =
            std::min(nearest, squared_distance_to_triangle(x, before_.points[a], before_.points[b],
                                                           before_.points[c]));
      require(std::sqrt(nearest) <= limit, "the result is further away than distance_bound");
    };
    for (const auto& [a, b, c] : after_.triangles) {
      const Position &p = after_.points[a], &q = after_.points[b], &r = after_.points[c];
      require_near(p);
      require_near(1.0 / 3 * (p + q + r));
    }
  }

  void require_constraints() {
    std::set<Vector> there;
    for (const Position& p : after_.points)
      there.insert(p.coordinates);
    const auto require_there = [&](std::uint32_t v) {
      require(there.contains(before_.points[v].coordinates), "a fixed vertex is gone");
    };
    for (const Triangle& t : before_.triangles)
      for (std::uint32_t v : t)
        if (input_.is_fixed[v])
          require_there(v);
    std::set<std::array<Vector, 2>> edges;
    for (const Triangle& t : after_.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          edges.insert({after_.points[t[i]].coordinates, after_.points[t[j]].coordinates});
    for (const auto& [v, w] : input_.kept)
      require(edges.contains({before_.points[v].coordinates, before_.points[w].coordinates}),
              "a constrained edge is gone");
  }

  // Each part of the result has the topology of another one of the input.
  void require_parts() {
    require(topology_after_.components + report_.vanished_parts == topology_before_.components,
            "the count of parts that vanished");
    require(topology_before_.components == 0 || topology_after_.components > 0, "nothing is left");
    if (!topology_before_.is_manifold)
      return;
    require(topology_after_.is_manifold, "no manifold any more");
    const auto before = topologies_of_parts(before_), after = topologies_of_parts(after_);
    require(std::includes(before.begin(), before.end(), after.begin(), after.end()),
            "the topology of a part changed");
  }

  void require_topology() {
    if (call_.topology == Topology::parts_may_vanish)
      return require_parts();
    require(report_.vanished_parts == 0 || call_.topology == Topology::free, "parts vanished");
    if (call_.topology != Topology::kept)
      return;
    require(topology_after_.components == topology_before_.components, "components changed");
    if (!topology_before_.is_oriented) // the faces that are left may be
      topology_after_.is_oriented = false;
    if (!topology_before_.is_manifold || is_same_topology(topology_before_, topology_after_))
      return;
    std::ostringstream what;
    what << "the topology changed: " << topology_before_ << " -> " << topology_after_;
    require(false, what.str());
  }

  void require_endpoints() {
    if (call_.placement != PlacementName::endpoint)
      return;
    std::set<Vector> there;
    for (const Position& p : before_.points)
      there.insert(p.coordinates);
    for (const Position& p : after_.points)
      require(there.contains(p.coordinates), "a position that is not of the input");
  }

  using Vector = std::array<double, 3>;

  const Case& input_;
  const Call& call_;
  const Report& report_;
  const Outcome& outcome_;
  Soup before_, after_;
  SoupTopology topology_before_, topology_after_;
  std::string complaint_;
};

bool is_bad(const Case& input) {
  return !is_finite(input.soup) ||
         !std::all_of(input.numbers.begin(), input.numbers.end(), has_finite) ||
         std::any_of(input.soup.triangles.begin(), input.soup.triangles.end(),
                     [&](const Triangle& t) {
                       return *std::max_element(t.begin(), t.end()) >= input.soup.points.size();
                     });
}

} // namespace

Case shrunk(Case input) {
  const auto is_sound = [](const Case& c) {
    if (!c.is_mesh)
      return true;
    const SoupTopology topology = topology_of(c.soup);
    return topology.is_manifold && topology.is_oriented;
  };
  for (std::size_t part = input.soup.triangles.size(); part > 0; part /= 2)
    for (std::size_t begin = 0; begin + part <= input.soup.triangles.size();) {
      Case smaller = input;
      const auto from = smaller.soup.triangles.begin() + static_cast<std::ptrdiff_t>(begin);
      smaller.soup.triangles.erase(from, from + static_cast<std::ptrdiff_t>(part));
      if (is_sound(smaller) && !violation(smaller).empty())
        input = std::move(smaller);
      else
        begin += part;
    }
  return input;
}

std::string violation(const Case& input) {
  Outcome outcome;
  try {
    simplify(input, outcome);
  } catch (const std::invalid_argument& error) {
    if (!is_bad(input) && !input.may_be_refused)
      return std::string("good input is refused: ") + error.what();
    return outcome.triangles == input.soup.triangles ? "" : "thrown, and the soup has changed";
  } catch (const std::logic_error& error) {
    return error.what();
  }
  if (is_bad(input))
    return "bad input is not refused";
  return Judge(input, outcome).violation();
}

} // namespace test
