#ifndef TEST_PROMISES_MODELS_H
#define TEST_PROMISES_MODELS_H

#include "meshes.h"
#include "soups.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

inline std::string name_of(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

/// A model of triangles. Throws std::runtime_error for another, and for one that is too large.
inline Soup read_soup(const std::string& file, std::size_t most_faces) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(file, points, polygons))
    throw std::runtime_error("cannot be read");
  if (polygons.empty() || polygons.size() > most_faces)
    throw std::runtime_error("has no faces, or too many to measure");
  Soup soup;
  for (const Point& p : points)
    soup.points.push_back(to_position(p));
  for (const auto& polygon : polygons) {
    if (polygon.size() != 3)
      throw std::runtime_error("has faces that are no triangles");
    soup.triangles.push_back({static_cast<std::uint32_t>(polygon[0]),
                              static_cast<std::uint32_t>(polygon[1]),
                              static_cast<std::uint32_t>(polygon[2])});
  }
  return soup;
}

/// Calls check(name, soup) for each model, which tells whether all promises are held; says which
/// models are skipped. The exit status of the program.
template <class Check>
int check_models(const std::vector<std::string>& files, std::size_t most_faces, Check check) {
  bool holds = true;
  for (const std::string& file : files) {
    Soup soup;
    try {
      soup = read_soup(file, most_faces);
    } catch (const std::runtime_error& skipped) {
      std::printf("%s: skipped: %s\n", name_of(file).c_str(), skipped.what());
      continue;
    }
    try {
      holds &= check(name_of(file), soup);
    } catch (const std::exception& error) {
      std::printf("%s: BROKEN: %s\n", file.c_str(), error.what());
      holds = false;
    }
  }
  std::puts(holds ? "all promises are held" : "a promise is BROKEN");
  return holds ? 0 : 1;
}

/// Tolerances that grow from `least` along the first axis, a hundredfold in a diagonal.
inline std::vector<double> growing_tolerances(const Soup& soup, double least) {
  double low = soup.points.front()[0];
  for (const Position& p : soup.points)
    low = std::min(low, p[0]);
  std::vector<double> tolerances;
  for (const Position& p : soup.points)
    tolerances.push_back(least * std::pow(100, (p[0] - low) / diagonal(soup)));
  return tolerances;
}

} // namespace test

#endif // TEST_PROMISES_MODELS_H
