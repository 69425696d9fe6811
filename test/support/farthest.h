#ifndef TEST_SUPPORT_FARTHEST_H
#define TEST_SUPPORT_FARTHEST_H

// How far one surface is from another, by CGAL's tree and by points of its triangles.
#include "soups.h"

#include <memory>

namespace test {

/// Distances of points from a surface of any kind, to the last bits.
class Nearest {
public:
  explicit Nearest(const Soup& soup);
  Nearest(Nearest&&) noexcept;
  ~Nearest();

  double distance(const Position& p) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Calls visit(point) for points of a triangle, corners and points between, `steps` along each
/// edge.
template <class Visit>
void for_each_point(const Soup& soup, const Triangle& t, int steps, Visit visit) {
  const auto& [a, b, c] = t;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      visit(1.0 / steps *
            (i * soup.points[a] + j * soup.points[b] + (steps - i - j) * soup.points[c]));
}

/// How far points of one surface are from the other at most, corners and points between, `steps`
/// along each edge: never more than it is. For surfaces of any kind.
double farthest(const Soup& from, const Soup& to, int steps);

/// The greatest coordinate of a soup.
double greatest_coordinate(const Soup& soup);

} // namespace test

#endif // TEST_SUPPORT_FARTHEST_H
