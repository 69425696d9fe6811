#include "simplify_mesh.h"

#include "run_engine.h"

#include <algorithm>
#include <array>

namespace quadrille_examples {

namespace {

/// Without attributes that vary.
quadrille::Report simplify_positions(IndexedMesh& mesh, const Options& options) {
  quadrille::SoupPoints points(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), points.begin(), [](const Point& p) {
    return std::array{p.x(), p.y(), p.z()};
  });
  const quadrille::Report report = quadrille::simplify_soup(
      points, mesh.triangles, soup_options(options, mesh.points, mesh.triangles));
  mesh.points.resize(points.size());
  std::transform(points.begin(), points.end(), mesh.points.begin(),
                 [](const auto& p) { return Point(p[0], p[1], p[2]); });
  return report;
}

} // namespace

quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options) {
  if (goes_by_channels(mesh, options))
    return simplify_by_channels(mesh, options);
  const MeshAttributes attributes(mesh, importance(options));
  if (attributes.size() > 0)
    return simplify_attributes(attributes, mesh, options);
  const quadrille::Report report = simplify_positions(mesh, options);
  attributes.restore(mesh);
  return report;
}

quadrille::Report simplify_by_channels(IndexedMesh& mesh, const Options& options) {
  return simplify_channels(mesh, MeshChannels(mesh), options);
}

} // namespace quadrille_examples
