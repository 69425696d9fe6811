#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_FANS_OF_STAR_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_FANS_OF_STAR_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/guards/distance/face_of_star.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Connected faces, in components, each oriented like the first of its component or the other way:
/// a union-find whose links also store whether a face is turned against the one to which it links.
class OrientedComponents {
public:
  /// A link to the first face of a component; is the other one oriented the other way?
  struct Link {
    Index face;
    bool is_turned;
  };

  /// Each face is a component of its own.
  void reset(std::size_t faces) {
    links_.resize(faces);
    for (std::size_t i = 0; i < faces; ++i)
      links_[i] = {static_cast<Index>(i), false};
  }

  std::size_t size() const { return links_.size(); }

  /// Halves the way while it goes there.
  Link first_of(Index face) {
    Link link = {face, false};
    while (links_[link.face].face != link.face) {
      Link& step = links_[link.face];
      const Link& beyond = links_[step.face];
      step = {beyond.face, step.is_turned != beyond.is_turned};
      link = {step.face, link.is_turned != step.is_turned};
    }
    return link;
  }

  /// Joins the components of two faces, which are oriented alike or not. Returns false if both are
  /// in one component with the other orientation: it has only one side.
  bool join(Index f, Index g, bool are_alike) {
    Link first = first_of(f), second = first_of(g);
    const bool differ = are_alike == (first.is_turned != second.is_turned);
    if (first.face == second.face)
      return !differ;
    if (first.face > second.face)
      std::swap(first, second);
    links_[second.face] = {first.face, differ};
    return true;
  }

private:
  std::vector<Link> links_; // to a face of the same component, finally the first of it
};

/// The fans of a star: faces that hang together by edges of two faces, at the ends of the pair.
/// They meet along junction lines, edges of three faces or more, and in points.
class FansOfStar {
public:
  /// All faces are one fan, and wound alike.
  void take_one(std::vector<FaceOfStar>& faces) {
    order_.resize(faces.size());
    std::transform(faces.begin(), faces.end(), order_.begin(), [](FaceOfStar& f) { return &f; });
    ends_.assign(1, faces.size());
  }

  /// Finds the fans, in O(n log n), and winds the faces of each alike: how they were wound does
  /// not matter. b is the second end of the pair.
  void find(std::vector<FaceOfStar>& faces, Index b) {
    corners_.clear();
    components_.reset(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      add_edges(faces[i], static_cast<Index>(i), b);
    std::sort(corners_.begin(), corners_.end(), [](const Corner& c, const Corner& d) {
      return c.edge < d.edge || (c.edge == d.edge && c.face < d.face);
    });
    for (std::size_t i = 0, next; i < corners_.size(); i = next) {
      next = i + 1;
      while (next < corners_.size() && corners_[next].edge == corners_[i].edge)
        ++next;
      if (next - i == 2)
        join(corners_[i], corners_[i + 1]);
    }
    group(faces);
  }

  std::size_t size() const { return ends_.size(); }
  std::span<FaceOfStar* const> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {order_.data() + begin, ends_[i] - begin};
  }

private:
  // A face at an edge: the neighbour of the pair with the number of the end, or b with the first.
  struct Corner {
    std::uint64_t edge;
    Index face;
    bool is_towards_end; // does the face have it so?
  };
  void add_edges(const FaceOfStar& f, Index i, Index b) {
    const auto add = [&](Index neighbour, std::size_t end, bool is_towards_end) {
      corners_.push_back({std::uint64_t{neighbour} << 1 | end, i, is_towards_end});
    };
    add(f.third, f.end, true);
    add(f.second, f.end, false);
    if (f.is_shared && f.second == b)
      add(f.third, 1, false);
    else if (f.is_shared)
      add(f.second, 1, true);
  }

  // Faces of the same orientation have their common edge in opposite directions. If a fan has
  // only one side some edge is left at which they differ.
  void join(const Corner& c, const Corner& d) {
    components_.join(c.face, d.face, c.is_towards_end != d.is_towards_end);
  }

  // By fans, each in the order of the faces.
  void group(std::vector<FaceOfStar>& faces) {
    fan_.resize(faces.size());
    ends_.clear();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const OrientedComponents::Link first = components_.first_of(static_cast<Index>(i));
      if (first.is_turned)
        faces[i].turn_over();
      if (first.face == i) {
        fan_[i] = static_cast<Index>(ends_.size());
        ends_.push_back(0);
      } else {
        fan_[i] = fan_[first.face];
      }
      ++ends_[fan_[i]];
    }
    std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), std::size_t{0});
    order_.resize(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      order_[ends_[fan_[i]]++] = &faces[i];
  }

  std::vector<Corner> corners_;
  OrientedComponents components_;
  std::vector<Index> fan_;
  std::vector<FaceOfStar*> order_;
  std::vector<std::size_t> ends_; // in the order, of each fan
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_FANS_OF_STAR_H
