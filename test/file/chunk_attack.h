#ifndef QUADRILLE_TEST_CHUNK_ATTACK_H
#define QUADRILLE_TEST_CHUNK_ATTACK_H

#include "folder.h"
#include "properties.h"
#include "random_surfaces.h"
#include "soups.h"
#include "surface_files.h"

#include <quadrille/distance_limits.h>
#include <quadrille/file.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// A surface of which each face has a label, and each vertex may have a tolerance.
struct LabelledSoup {
  Soup soup;
  std::vector<std::int32_t> labels = {};
  std::vector<double> tolerances = {};
};

/// As ply_of, with labels of faces, and tolerances if there are any.
inline std::string labelled_ply_of(const LabelledSoup& surface) {
  const bool is_tolerant = !surface.tolerances.empty();
  const std::string plain = is_tolerant ? ply_with(surface.soup, "allowed", surface.tolerances)
                                        : ply_of<double>(surface.soup);
  const std::size_t header = plain.find("end_header\n") + 11;
  const std::size_t faces = header + (is_tolerant ? 32 : 24) * surface.soup.points.size();
  std::string ply = plain.substr(0, header - 11) + "property int region\n" +
                    plain.substr(header - 11, faces - header + 11);
  for (std::size_t f = 0; f < surface.labels.size(); ++f) {
    ply += plain.substr(faces + 13 * f, 13);
    put_number(ply, surface.labels[f]);
  }
  return ply;
}

inline LabelledSoup read_labelled_ply(const std::filesystem::path& path) {
  const std::string content = content_of(path);
  const std::size_t begin = content.find("end_header\n") + 11;
  const auto number_behind = [&](const std::string& words) {
    return std::stoul(content.substr(content.find(words) + words.size()));
  };
  LabelledSoup surface;
  surface.soup.points.resize(number_behind("element vertex "));
  const std::size_t faces = number_behind("element face ");
  const bool is_tolerant = content.find("property double allowed\n") < begin;
  const char* at = content.data() + begin;
  const auto take = [&](auto& number) {
    std::memcpy(&number, at, sizeof number);
    at += sizeof number;
  };
  for (Position& p : surface.soup.points) {
    for (double& x : p.coordinates)
      take(x);
    if (is_tolerant)
      take(surface.tolerances.emplace_back());
  }
  for (std::size_t f = 0; f < faces; ++f) {
    ++at;
    for (std::uint32_t& v : surface.soup.triangles.emplace_back())
      take(v);
    take(surface.labels.emplace_back());
  }
  return surface;
}

/// Simplifies a random surface by small parts, to a distance, to tolerances or to a count, and
/// looks at what holds of a run in memory as well: distances, topology, regions of labels and which
/// of them meet; and that the bytes are the same however many parts are in flight.
class ChunkAttack {
public:
  ChunkAttack(std::uint64_t seed, const Surface& surface)
      : seed_(seed), random_(seed + 21), name_(surface.name), input_{surface.soup} {
    const double width = random_(0.1, 0.6) * diagonal(input_.soup);
    const double begin = input_.soup.points.front()[0];
    for (const Triangle& t : input_.soup.triangles)
      input_.labels.push_back(
          static_cast<std::int32_t>(std::floor((input_.soup.points[t[0]][0] - begin) / width)));
  }

  /// What is broken, in a line each.
  std::vector<std::string> broken() {
    const Folder folder;
    chunk_faces_ = 60 + random_.below(300);
    const double part = std::pow(10, random_(-3, -1));
    switch (random_.below(4)) {
    case 0:
      limited(folder, quadrille::DistanceLimit::relative(part));
      break;
    case 1:
      limited(folder, quadrille::HausdorffLimit::relative(part));
      break;
    case 2:
      tolerant(folder, part * diagonal(input_.soup));
      break;
    default:
      check_properties(folder, {}, run(folder, quadrille::FaceRatio{random_(0.02, 0.3)}));
    }
    return broken_;
  }

private:
  template <class Limit>
  void limited(const Folder& folder, const Limit& limit) {
    const quadrille::FileReport report = run(folder, limit);
    Asked asked;
    asked.distance = limit.distance(report.diagonal);
    check_properties(folder, asked, report);
  }

  /// Tolerances from a tenth of the distance to ten times as much, in stripes.
  void tolerant(const Folder& folder, double distance) {
    const std::array<double, 3> allowed{0.1 * distance, distance, 10 * distance};
    const double width = random_(0.1, 0.4) * diagonal(input_.soup);
    for (const Position& p : input_.soup.points)
      input_.tolerances.push_back(
          allowed[static_cast<std::size_t>(std::abs(std::floor(p[1] / width))) % 3]);
    const quadrille::FileReport report = run(folder, quadrille::ToleranceLimit{});
    check_properties(folder, {}, report);
    if (std::isfinite(report.hausdorff_bound))
      check("more used than there is", report.used_tolerance->fraction <= 1);
  }

  template <class Stop>
  quadrille::FileReport run(const Folder& folder, const Stop& stop) {
    folder.file("in.ply", labelled_ply_of(input_));
    quadrille::FileReport report;
    for (const unsigned in_flight : {1U, 3U}) {
      quadrille::OutOfCore options;
      options.scratch = folder.path("scratch");
      options.chunk_faces = options.whole_faces = chunk_faces_;
      options.chunks_in_flight = in_flight;
      options.tolerance = input_.tolerances.empty() ? "" : "allowed";
      report = quadrille::simplify_file<quadrille::MemorylessQuadric, quadrille::OptimalPlacement>(
          folder.path("in.ply"), folder.path("out" + std::to_string(in_flight) + ".ply"), stop,
          options);
    }
    check("bytes that depend on how many parts are in flight",
          content_of(folder.path("out1.ply")) == content_of(folder.path("out3.ply")));
    return report;
  }

  void check_properties(const Folder& folder, Asked asked, const quadrille::FileReport& report) {
    asked.soup = input_.soup;
    asked.labels = input_.labels;
    asked.tolerances = input_.tolerances;
    const LabelledSoup output = read_labelled_ply(folder.path("out1.ply"));
    Result result;
    result.soup = output.soup;
    result.labels = output.labels;
    result.report.distance_bound = report.distance_bound;
    result.report.hausdorff_bound = report.hausdorff_bound;
    const std::string complaint = test::broken(asked, result, properties_of_files());
    check(complaint, complaint.empty());
  }

  void check(const std::string& what, bool holds) {
    if (!holds && broken_.size() < 10)
      broken_.push_back("seed " + std::to_string(seed_) + ", " + name_ + ", parts of " +
                        std::to_string(chunk_faces_) + ": " + what);
  }

  std::uint64_t seed_;
  Random random_;
  std::string name_;
  LabelledSoup input_;
  std::uint64_t chunk_faces_ = 0;
  std::vector<std::string> broken_;
};

} // namespace test

#endif // QUADRILLE_TEST_CHUNK_ATTACK_H
