// Faces that are not seen from outside.
#include "jobs.h"

#include <quadrille/compiled.h>
#include <quadrille/hidden.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

template <class Options>
Options options_of(const Work& work) {
  Options options;
  options.directions = static_cast<std::size_t>(work.bag.number("directions"));
  options.front_only = work.bag.flag("front_only");
  options.threads = static_cast<unsigned>(work.bag.number("threads"));
  if constexpr (requires { options.threshold; })
    options.threshold = work.bag.number("threshold");
  options.progress = [&work](double fraction) { return work.proceed(fraction); };
  return options;
}

} // namespace

/// Gives for each face whether it is hidden; for each group its kind, its faces one after the
/// other, and its area, volume and diagonal.
void find_hidden(const Work& work) {
  const quadrille_bag& bag = work.bag;
  const quadrille::HiddenFaces found =
      quadrille::hidden_faces(bag.rows<double, 3>("points"), bag.rows<std::uint32_t, 3>("faces"),
                              options_of<quadrille::HiddenOptions>(work));
  std::vector<std::string> kinds;
  std::vector<std::int64_t> faces, ends;
  std::vector<std::array<double, 3>> sizes;
  for (const quadrille::HiddenGroup& group : found.groups) {
    kinds.emplace_back(to_string(group.kind));
    faces.insert(faces.end(), group.faces.begin(), group.faces.end());
    ends.push_back(static_cast<std::int64_t>(faces.size()));
    sizes.push_back({group.area, group.volume, group.diagonal});
  }
  work.bag.give("is_hidden",
                std::vector<std::uint8_t>(found.is_hidden.begin(), found.is_hidden.end()));
  work.bag.give_texts("kinds", kinds);
  work.bag.give("group_faces", std::move(faces));
  work.bag.give("group_ends", std::move(ends));
  work.bag.give("sizes", std::move(sizes));
  work.bag.give_numbers("figures", found.area, found.whole_area, found.cut_edges,
                        found.is_cancelled);
}

/// Gives what is left without hidden faces: the added points, the corners of all faces, for each
/// face the one of the input that it is or is next to, and for each added point one next to it.
void remove_hidden(const Work& work) {
  const auto given_points = work.bag.rows<double, 3>("points");
  const auto given_faces = work.bag.rows<std::uint32_t, 3>("faces");
  quadrille::SoupPoints points(given_points.begin(), given_points.end());
  quadrille::SoupTriangles faces(given_faces.begin(), given_faces.end());
  const quadrille::HiddenRemoval changes =
      quadrille::remove_hidden(points, faces, options_of<quadrille::HiddenOptions>(work));
  std::vector<std::int64_t> origins;
  for (const auto& origin : changes.origins)
    origins.push_back(static_cast<std::int64_t>(origin[0]));
  work.bag.give("added",
                quadrille::SoupPoints(points.end() - std::ptrdiff_t(origins.size()), points.end()));
  work.bag.give("faces", std::move(faces));
  work.bag.give("sources",
                std::vector<std::int64_t>(changes.triangles.begin(), changes.triangles.end()));
  work.bag.give("origins", std::move(origins));
}

/// Gives the fraction that is visible of each face and of each point.
void find_visibility(const Work& work) {
  const quadrille_bag& bag = work.bag;
  quadrille::Visibility found =
      quadrille::visibility(bag.rows<double, 3>("points"), bag.rows<std::uint32_t, 3>("faces"),
                            options_of<quadrille::VisibilityOptions>(work));
  work.bag.give("importance", quadrille::visibility_importance(found, bag.number("least")));
  work.bag.give("of_faces", std::move(found.faces));
  work.bag.give("of_points", std::move(found.vertices));
}

} // namespace quadrille_examples
