#include "cases.h"

#include "../support/properties.h"

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
                                    : Topology::components_may_vanish;
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
  std::vector<bool> is_next_to(soup.points.size(), false);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const auto is_used = [&](std::uint32_t v) -> bool { return is_next_to[v]; };
    if (random.below(step) > 0 || std::any_of(t.begin(), t.end(), is_used))
      return false;
    for (std::uint32_t v : t)
      is_next_to[v] = true;
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
void add_components(Bytes& bytes, Soup& soup) {
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
  result.may_be_rejected = is_any || result.weights;
  result.call.cost = CostName::attributes;
}

Case make_case_without_channels(Bytes& bytes, int size) {
  Case result;
  Soup& soup = result.soup;
  soup = make_base(bytes, bytes.one_in(4) ? 4 * size : size); // passes need larger ones
  if (!bytes.one_in(2)) {                                     // else a mesh can be made of most
    add_components(bytes, soup);
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
             << call.smallest_angle << ", degree " << call.degree << ", cancelled at call "
             << call.cancel_at;
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

Asked asked_of(const Case& input) {
  const Call& call = input.call;
  Asked asked;
  asked.soup = input.soup;
  asked.is_mesh = input.is_mesh;
  asked.is_fixed = input.is_fixed;
  asked.kept = input.kept;
  asked.topology = call.topology;
  asked.is_by_edges = !(call.threshold > 0);
  asked.is_at_endpoints = call.placement == PlacementName::endpoint;
  asked.may_be_cancelled = call.cancel_at < 1000;
  if (call.cost == CostName::attributes)
    for (const Numbers& numbers : input.numbers)
      asked.attributes.emplace_back(numbers.begin(), numbers.end());
  if (call.stop.chosen.index() != 6) // the next distance is not known after the end
    asked.stop = [&](const Status& status) { return call.stop(status); };
  asked.stops_at_distance = std::holds_alternative<DistanceLimit>(call.stop.chosen);
  if (const auto* contractions = std::get_if<AfterContractions>(&call.stop.chosen))
    asked.contractions = contractions->count;
  return asked;
}

Result result_of(const Case& input, const Outcome& outcome) {
  Result result;
  for (const Point& p : outcome.points)
    result.soup.points.push_back(to_position(p));
  result.soup.triangles = outcome.triangles;
  result.report = outcome.report;
  if (input.call.cost == CostName::attributes)
    for (const Numbers& numbers : outcome.numbers)
      result.attributes.emplace_back(numbers.begin(), numbers.end());
  return result;
}

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
  } catch (const std::length_error& error) {
    if (!(input.call.threshold > 0))
      return std::string("good input is refused: ") + error.what();
    return outcome.triangles == input.soup.triangles ? ""
                                                     : "too many pairs, and the soup has changed";
  } catch (const std::invalid_argument& error) {
    if (!is_bad(input) && !input.may_be_rejected)
      return std::string("good input is refused: ") + error.what();
    return outcome.triangles == input.soup.triangles ? "" : "thrown, and the soup has changed";
  } catch (const std::logic_error& error) {
    return error.what();
  }
  if (is_bad(input))
    return "bad input is not refused";
  if (outcome.colors.size() < outcome.points.size() ||
      outcome.numbers.size() < outcome.points.size())
    return "colours or numbers are missing";
  return broken(asked_of(input), result_of(input, outcome));
}

} // namespace test
