#ifndef QUADRILLE_INTERNAL_CORE_BASE_WOUND_PIECES_H
#define QUADRILLE_INTERNAL_CORE_BASE_WOUND_PIECES_H

#include <quadrille/internal/core/base/index.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Faces that hang together, in pieces, each wound as the first of its piece or the other way: a
/// union-find whose links also tell whether a face is turned against the one that it leads to.
class WoundPieces {
public:
  /// To the first face of a piece; is the other one wound the other way?
  struct Link {
    Index face;
    bool is_turned;
  };

  /// Each face is a piece of its own.
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

  /// Makes one piece of those of two faces, which are wound alike or not. False where they are of
  /// one piece that says otherwise: it has but one side.
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
  std::vector<Link> links_; // to a face of the same piece, at last the first of it
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_WOUND_PIECES_H
