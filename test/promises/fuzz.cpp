// Simplifies random and hard surfaces with each filter and limit that guarantees.md promises
// something of, and has <quadrille/verify.h> look at all of it. Equal seeds are equal surfaces.
// Prints what is broken, writes it to broken_SEED_in.off and broken_SEED_out.off, and fails if
// anything is.
//   fuzz FIRST_SEED COUNT [MODEL.off...]    models are simplified beside the others, in their turn
#include "seeds.h"

#include <quadrille/compiled.h>
#include <quadrille/verify.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Random;
using test::Soup;
using test::Surface;

class Fuzz {
public:
  Fuzz(std::uint64_t seed, const Surface& surface)
      : seed_(seed), random_(seed + 5), surface_(surface), diagonal_(test::diagonal(surface.soup)) {
    for (const Position& p : surface.soup.points)
      points_.push_back({p[0], p[1], p[2]});
  }

  bool check() {
    const double part = std::pow(10, random_(-3.5, -1));
    run("no self-intersection", [](SoupOptions& o) { o.no_self_intersection = true; });
    run("solid", [](SoupOptions& o) { o.keep_solid = true; });
    run("both ways", [&](SoupOptions& o) { limit(o, part); });
    run("tolerances", [&](SoupOptions& o) { vary(o, part); });
    run("normals", [&](SoupOptions& o) { o.normal_deviation = random_(15, 120); });
    run("all but solid", [&](SoupOptions& o) {
      o.no_self_intersection = true;
      o.normal_deviation = random_(30, 120);
      random_.below(2) == 0 ? limit(o, part) : vary(o, part);
    });
    return holds_;
  }

private:
  void limit(SoupOptions& o, double part) {
    o.both_ways = true;
    o.relative_error = part;
  }
  void vary(SoupOptions& o, double part) {
    for (std::size_t v = 0; v < points_.size(); ++v)
      o.tolerance.push_back(
          random_.below(20) == 0
              ? 0
              : part * diagonal_ *
                    std::pow(100, points_[v][0] / diagonal_ - points_[0][0] / diagonal_));
  }

  /// Whatever else there is to choose.
  SoupOptions options() {
    SoupOptions o;
    constexpr std::array costs{SoupOptions::Cost::quadric, SoupOptions::Cost::memoryless_quadric};
    o.cost = costs[random_.below(2)];
    o.placement =
        random_.below(3) == 0 ? SoupOptions::Placement::endpoint : SoupOptions::Placement::optimal;
    o.ratio = random_.below(3) == 0 ? 0 : random_(0.02, 0.5);
    return o;
  }

  template <class Ask>
  void run(const char* promise, Ask ask) {
    SoupOptions o = options();
    ask(o);
    if (o.both_ways || !o.tolerance.empty())
      o.ratio.reset();
    if (!o.no_self_intersection && !o.keep_solid) {
      o.order = random_.below(2) == 0 ? SoupOptions::Order::relaxed : SoupOptions::Order::greedy;
      if (random_.below(3) == 0)
        o.topology = Topology::free;
    } else if (!o.keep_solid && random_.below(4) == 0) {
      o.topology = Topology::free;
    }
    SoupResult result;
    try {
      result = simplified_soup({points_, surface_.soup.triangles}, o);
    } catch (const std::invalid_argument& refused) {
      if (!o.keep_solid)
        tell(promise, refused.what());
      return;
    }
    if (result.triangles.empty())
      return; // at no distance
    const Verdict verdict = verify(points_, surface_.soup.triangles, result.points,
                                   result.triangles, claims_of(o, result));
    if (!verdict) {
      std::string text;
      for (const Finding& f : verdict.findings)
        if (!f.is_met)
          text += f.claim + ": " + std::to_string(f.promised) + " promised, " +
                  std::to_string(f.measured) + " measured, error " + std::to_string(f.error) + "; ";
      tell(promise, text + std::to_string(result.report.faces_before) + " -> " +
                        std::to_string(result.report.faces_after) + " faces");
      const std::string name = "broken_" + std::to_string(seed_);
      CGAL::IO::write_polygon_soup(name + "_in.off", test::points_of(surface_.soup),
                                   surface_.soup.triangles, CGAL::parameters::stream_precision(17));
      std::vector<test::Point> left;
      for (const auto& p : result.points)
        left.emplace_back(p[0], p[1], p[2]);
      CGAL::IO::write_polygon_soup(name + "_out.off", left, result.triangles,
                                   CGAL::parameters::stream_precision(17));
    }
  }

  Claims claims_of(const SoupOptions& o, const SoupResult& result) const {
    Claims claims{.no_self_intersection = o.no_self_intersection || o.keep_solid};
    claims.solid = o.keep_solid && verify(points_, surface_.soup.triangles, points_,
                                          surface_.soup.triangles, {.solid = true})
                                       .is_met();
    claims.tolerances = o.tolerance;
    if (o.both_ways) // as one tolerance for all, since CGAL takes long where surfaces nearly agree
      claims.tolerances.assign(points_.size(), result.report.hausdorff_bound);
    claims.normal_deviation = result.report.normal_bound_degrees;
    claims.vertex_map = result.image;
    return claims;
  }

  void tell(const char* promise, const std::string& what) {
    std::printf("seed %llu, %s, %s: BROKEN: %s\n", static_cast<unsigned long long>(seed_),
                surface_.name.c_str(), promise, what.c_str());
    std::fflush(stdout);
    holds_ = false;
  }

  std::uint64_t seed_;
  Random random_;
  const Surface& surface_;
  double diagonal_;
  SoupPoints points_;
  bool holds_ = true;
};

} // namespace

int main(int argc, char** argv) {
  return test::check_seeds(argc, argv, [](std::uint64_t seed, const test::Surface& surface) {
    return Fuzz(seed, surface).check();
  });
}
