#ifndef TEST_SUPPORT_DAMAGE_H
#define TEST_SUPPORT_DAMAGE_H

/// \file
/// Random solids of several parts, right results of them, and ways to damage these, of which each
/// breaks one finding of verify() and no other.

#include "soups.h"

#include <quadrille/quadric_form.h>
#include <quadrille/verdict.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Of faces turned over, a surface.
inline Soup turned_over(Soup soup) {
  for (Triangle& t : soup.triangles)
    std::swap(t[0], t[1]);
  return soup;
}

/// A ring, a ball with a cavity, a ball, and more balls, in a row in any order.
class RandomSolid {
public:
  struct Part {
    bool is_ring = false, is_inside_out = false;
    Position place{}, size{{1, 1, 1}};
  };
  static constexpr std::size_t ring = 0, hollow = 1, ball = 2, cavity = 3;

  explicit RandomSolid(std::uint64_t seed) : random(seed), parts(4 + seed % 4) {
    std::vector<double> places(parts.size() - 1);
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = 5 * (static_cast<double>(i) + random(0, 0.2));
    for (std::size_t i = places.size(); i > 1; --i)
      std::swap(places[i - 1], places[random.below(i)]);
    for (std::size_t i = 0, next = 0; i < parts.size(); ++i)
      if (i != cavity)
        put(i, {{places[next++], random(-1, 1), random(-1, 1)}}, random(0.5, 1.5));
    put(cavity, parts[hollow].place, 0.4 * parts[hollow].size[0]);
    parts[ring].is_ring = parts[cavity].is_inside_out = true;
  }

  void put(std::size_t part, const Position& place, double size) {
    parts[part].place = place;
    parts[part].size = {{size, size, size}};
  }

  /// As faces: balls of 32 · 4^fineness, rings of 192 · 4^fineness.
  Soup soup(int fineness) const {
    Soup all;
    for (const Part& part : parts) {
      const Soup shape =
          part.is_ring ? torus(12u << fineness, 8u << fineness) : sphere(1 + fineness);
      const Soup placed = mapped(shape, [&](const Position& p) {
        return Position{{part.size[0] * p[0], part.size[1] * p[1], part.size[2] * p[2]}};
      });
      all = joined(std::move(all), part.is_inside_out ? turned_over(placed) : placed, part.place);
    }
    return all;
  }

  /// One of the vertices of a ball, in soup(0).
  std::size_t vertex(std::size_t part) {
    RandomSolid before = *this;
    before.parts.resize(part);
    return before.soup(0).points.size() + random.below(sphere(1).points.size());
  }

  Random random;
  std::vector<Part> parts;
};

/// What is claimed of a right result, and how it is damaged.
struct Damage {
  std::string name, finding; ///< the only one that is broken then
  quadrille::Claims claims;
  std::function<void(RandomSolid&, Soup&)> apply; ///< to soup(0)
};

inline std::size_t random_face(RandomSolid& solid, const Soup& soup) {
  return solid.random.below(soup.triangles.size());
}

/// The names of those that are broken.
inline std::vector<std::string> broken_findings(const quadrille::Verdict& verdict) {
  std::vector<std::string> broken;
  for (const quadrille::Finding& finding : verdict.findings)
    if (!finding.is_met)
      broken.push_back(finding.claim);
  return broken;
}

/// Those that move or turn one vertex or face. A right result is within `distance` both ways.
inline std::vector<Damage> damages_of_faces(double distance) {
  const quadrille::Claims shape{.no_self_intersection = true, .solid = true};
  quadrille::Claims all = shape;
  all.distance_both_ways = distance;
  return {
      {"a vertex moved out", "distance of the result from the input", all,
       [distance](RandomSolid& s, Soup& soup) {
         Position& p = soup.points[s.vertex(RandomSolid::ball)];
         const Position out = p - s.parts[RandomSolid::ball].place;
         p += s.random(1.1, 1.4) * distance / std::sqrt(quadrille::squared_length(out)) * out;
       }},
      {"a vertex pulled through", "intersecting pairs of faces", shape,
       [](RandomSolid& s, Soup& soup) {
         Position& p = soup.points[s.vertex(RandomSolid::ball)];
         p += s.random(2.2, 2.6) * (s.parts[RandomSolid::ball].place - p);
       }},
      {"a face turned", "open edges", shape,
       [](RandomSolid& s, Soup& soup) {
         Triangle& t = soup.triangles[random_face(s, soup)];
         std::swap(t[0], t[1]);
       }},
      {"a face lost", "open edges", shape,
       [](RandomSolid& s, Soup& soup) {
         std::swap(soup.triangles[random_face(s, soup)], soup.triangles.back());
         soup.triangles.pop_back();
       }},
      {"a part on a line",
       "components turned inside out, or without volume",
       {.solid = true},
       [](RandomSolid& s, Soup& soup) {
         s.parts[RandomSolid::ball].size[0] = s.parts[RandomSolid::ball].size[1] = 0;
         soup = s.soup(0);
       }},
      {"a part pressed flat",
       "components turned inside out, or without volume",
       {.solid = true},
       [](RandomSolid& s, Soup& soup) {
         s.parts[RandomSolid::ball].size[2] = 0;
         soup = s.soup(0);
       }},
  };
}

/// Those that change one part, so that each still is closed and intersects none.
inline std::vector<Damage> damages_of_parts() {
  const quadrille::Claims shape{.no_self_intersection = true, .solid = true};
  const auto damage = [&](const char* name, const char* finding, auto change) {
    return Damage{name, finding, shape, [change](RandomSolid& s, Soup& soup) {
                    change(s);
                    soup = s.soup(0);
                  }};
  };
  return {
      damage("a part turned inside out", "components turned inside out, or without volume",
             [](RandomSolid& s) { s.parts[RandomSolid::ball].is_inside_out = true; }),
      damage("all turned inside out", "components turned inside out, or without volume",
             [](RandomSolid& s) {
               for (RandomSolid::Part& part : s.parts)
                 part.is_inside_out = !part.is_inside_out;
             }),
      damage("a handle on another part", "components with a different number of handles",
             [](RandomSolid& s) {
               std::swap(s.parts[RandomSolid::ring].is_ring, s.parts[RandomSolid::ball].is_ring);
             }),
      damage("parts that have changed places", "components with a different number of handles",
             [](RandomSolid& s) {
               std::swap(s.parts[RandomSolid::ring].place, s.parts[RandomSolid::ball].place);
               std::swap(s.parts[RandomSolid::ring].size, s.parts[RandomSolid::ball].size);
             }),
      damage("a cavity in another part", "components inside other components than before",
             [](RandomSolid& s) {
               s.put(RandomSolid::cavity, s.parts[RandomSolid::ball].place,
                     0.4 * s.parts[RandomSolid::ball].size[0]);
             }),
      damage("a cavity outside", "components inside other components than before",
             [](RandomSolid& s) { s.parts[RandomSolid::cavity].place[1] += 4; }),
      damage("a part lost", "components",
             [](RandomSolid& s) { s.parts.erase(s.parts.begin() + 2); }),
      damage("a part added", "components",
             [](RandomSolid& s) {
               s.parts.push_back({.place = {{-5, 0, 0}}});
             }),
  };
}

} // namespace test

#endif // TEST_SUPPORT_DAMAGE_H
