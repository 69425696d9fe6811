// Calls the compiled library for the tests of the Python module, so that these can compare bits.
//   facade OUT KEY=VALUE...   standard input and OUT: for points, triangles, uv and its
//   triangles a count of 64 bits and that many rows
#include <quadrille/compiled.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;

template <class Row>
std::vector<Row> read_rows(std::istream& in) {
  std::uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof(count));
  std::vector<Row> rows(count);
  in.read(reinterpret_cast<char*>(rows.data()), static_cast<std::streamsize>(count * sizeof(Row)));
  return rows;
}

template <class Row>
void write_rows(std::ostream& out, const std::vector<Row>& rows) {
  const std::uint64_t count = rows.size();
  out.write(reinterpret_cast<const char*>(&count), sizeof(count));
  out.write(reinterpret_cast<const char*>(rows.data()),
            static_cast<std::streamsize>(count * sizeof(Row)));
}

void set(SoupOptions& options, const std::string& key, const std::string& value) {
  using Cost = SoupOptions::Cost;
  using Placement = SoupOptions::Placement;
  const std::map<std::string, Cost> costs = {{"quadric", Cost::quadric},
                                             {"memoryless_quadric", Cost::memoryless_quadric},
                                             {"thin_feature_quadric", Cost::thin_feature_quadric},
                                             {"edge_length", Cost::edge_length}};
  if (key == "faces")
    options.faces = std::stoul(value);
  else if (key == "vertices")
    options.vertices = std::stoul(value);
  else if (key == "ratio")
    options.ratio = std::stod(value);
  else if (key == "error")
    options.error = std::stod(value);
  else if (key == "cost")
    options.cost = costs.at(value);
  else if (key == "placement")
    options.placement = value == "endpoint" ? Placement::endpoint : Placement::midpoint;
  else if (key == "boundary_weight")
    options.boundary_weight = std::stod(value);
  else if (key == "pairs_closer_than")
    options.pairs_closer_than = std::stod(value);
  else if (key == "order")
    options.order = SoupOptions::Order::relaxed;
  else
    throw std::invalid_argument(key);
}

} // namespace

int main(int argc, char** argv) {
  SoupOptions options;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    set(options, word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
  }
  const auto points = read_rows<std::array<double, 3>>(std::cin);
  const auto triangles = read_rows<std::array<std::uint32_t, 3>>(std::cin);
  const auto uv = read_rows<std::array<double, 2>>(std::cin);
  const auto uv_triangles = read_rows<std::array<std::uint32_t, 3>>(std::cin);
  SoupView soup{points, triangles};
  if (!uv.empty())
    soup.channels.push_back(
        {.values = {uv.front().data(), 2 * uv.size()}, .triangles = uv_triangles});
  const SoupResult result = simplified_soup(soup, options);
  std::ofstream out(argv[1], std::ios::binary);
  write_rows(out, result.points);
  write_rows(out, result.triangles);
  if (!uv.empty()) {
    write_rows(out, result.channels[0].values);
    write_rows(out, result.channels[0].triangles);
  }
  return out ? 0 : 1;
}
