// Computes figures of Garland and Heckbert's papers, on models that come with CGAL or on generated
// ones, prints what each of them shows and writes its meshes.
//
//   figures MODEL_FOLDER OUTPUT_FOLDER [NUMBER...]     all of them without a number
#include "figure_1.h"
#include "figure_2.h"
#include "figure_3.h"
#include "figure_4.h"
#include "figure_5.h"
#include "figure_6.h"
#include "figure_7.h"
#include "figure_8.h"
#include "figure_9.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

using figures::fs::path;

template <class Figure>
void show(const path& models, const path& folder) {
  const Figure figure(models);
  figure.print();
  figure.write(folder);
}

struct Entry {
  std::string number;
  const char* title;
  void (*show)(const path& models, const path& folder);
};

const std::array<Entry, 9> entries = {
    {{"1", "The shortest edge first, and quadrics", show<figures::Figure1>},
     {"2", "The bones of a foot, by edges, by pairs and by clustering", show<figures::Figure2>},
     {"3", "A hundred cubes, by edges and by pairs", show<figures::Figure3>},
     {"4", "The borders of a cylinder's wall", show<figures::Figure4>},
     {"5", "Colours", show<figures::Figure5>},
     {"6", "Texture coordinates", show<figures::Figure6>},
     {"7", "The bunny to 100 faces", show<figures::Figure7>},
     {"8", "Quadrics as ellipsoids", show<figures::Figure8>},
     {"9", "The pairs of a foot", show<figures::Figure9>}}};

} // namespace

int main(int argc, char* argv[]) try {
  const std::vector<std::string> numbers(argv + std::min(argc, 3), argv + argc);
  const auto is_known = [](const std::string& number) {
    return std::ranges::find(entries, number, &Entry::number) != entries.end();
  };
  if (argc < 3 || !std::ranges::all_of(numbers, is_known)) {
    std::fprintf(stderr, "usage: %s MODEL_FOLDER OUTPUT_FOLDER [NUMBER...], numbers 1 to %zu\n",
                 argv[0], entries.size());
    return 2;
  }
  const path models = argv[1], folder = argv[2];
  figures::fs::create_directories(folder);
  for (const Entry& entry : entries) {
    if (!numbers.empty() && std::ranges::find(numbers, entry.number) == numbers.end())
      continue;
    std::printf("Figure %s. %s\n\n", entry.number.c_str(), entry.title);
    std::fflush(stdout);
    entry.show(models, folder);
    std::printf("\n");
  }
  std::printf("The meshes are in %s\n", folder.c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "figures: %s\n", error.what());
  return 2;
}
