// Simplifies a soup with a texture and regions, without templates: links quadrille::compiled.
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iostream>
#include <quadrille/compiled.h>
#include <vector>

int main() {
  using namespace quadrille;

  constexpr std::uint32_t n = 100; // a bent sheet of n × n points
  SoupPoints points;
  SoupTriangles triangles;
  std::vector<double> uv;            // two numbers for each point
  std::vector<std::uint32_t> labels; // one for each triangle
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const double u = (i % n) / (n - 1.), v = (i / n) / (n - 1.);
    points.push_back({u, v, 0.1 * std::sin(6 * u) * std::cos(6 * v)});
    uv.insert(uv.end(), {u, v});
    if (i % n > 0 && i >= n)
      for (const std::uint32_t third : {i - n, i}) {
        triangles.push_back({i - n - 1, third, third == i ? i - 1 : i});
        labels.push_back(u > 0.5 ? 1 : 0);
      }
  }

  SoupView soup{points, triangles}; // looks at arrays of yours and changes nothing
  soup.labels = labels;
  soup.channels.push_back({.kind = SoupChannelView::Kind::texture, .components = 2, .values = uv});
  SoupOptions options;
  options.faces = 1000;
  options.relative_error = 0.01;
  options.cost = SoupOptions::Cost::memoryless_quadric;
  const SoupResult result = simplified_soup(soup, options);
  std::cout << result.report << '\n';
  return result.channels[0].values.size() == 2 * result.points.size() ? 0 : 1;
}
