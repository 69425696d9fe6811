#ifndef QUADRILLE_INTERNAL_FILE_PLACE_SORT_H
#define QUADRILLE_INTERNAL_FILE_PLACE_SORT_H

#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <queue>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Sorts positions with their numbers by an external merge sort (Knuth, The Art of Computer
/// Programming, volume 3, section 5.4), in runs that fit into memory and are written to files in a
/// folder: so vertices at exactly the same position follow one another, in the order of their
/// numbers. Number is float or double.
template <class Number>
class PlaceSort {
  using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;

public:
  struct Item {
    std::array<Bits, 3> place; // the bits of the coordinates, in an order of their own
    std::uint32_t number_low, number_high;

    std::uint64_t number() const { return std::uint64_t{number_high} << 32 | number_low; }
    std::array<Number, 3> position() const {
      return {coordinate(place[0]), coordinate(place[1]), coordinate(place[2])};
    }
    friend bool operator<(const Item& a, const Item& b) {
      return a.place != b.place ? a.place < b.place : a.number() < b.number();
    }
  };

  /// Sorts that many items, in `memory` bytes.
  PlaceSort(std::filesystem::path folder, std::uint64_t memory, std::uint64_t items)
      : folder_(std::move(folder)), memory_(memory),
        most_(static_cast<std::size_t>(
            std::clamp<std::uint64_t>(memory / 2 / sizeof(Item), 3000, most_sorted))) {
    run_.reserve(static_cast<std::size_t>((std::min<std::uint64_t>)(most_, items)));
  }

  /// Coordinates must be finite; -0 becomes 0.
  void add(const std::array<Number, 3>& position, std::uint64_t number) {
    if (run_.size() == most_)
      write_run();
    Item item{{}, static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Bits bits = std::bit_cast<Bits>(position[i] + Number{0});
      item.place[i] = (bits & sign) != 0 ? ~bits : bits | sign;
    }
    run_.push_back(item);
  }
  /// Must be called after the last item.
  void end() {
    write_run();
    run_ = {};
  }

  /// Calls take(item, is_new) for each item; is_new says whether its position differs from the
  /// previous one. It removes the files.
  template <class Take>
  void for_sorted(Take take) {
    std::vector<std::unique_ptr<Run>> runs;
    const auto is_later = [&](std::size_t a, std::size_t b) {
      return runs[b]->item < runs[a]->item;
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(is_later)> queue(is_later);
    const auto block = static_cast<std::size_t>(
        std::clamp<std::uint64_t>(memory_ / 4 / (std::max)(runs_, 1U), 1 << 14, 1 << 20));
    for (unsigned r = 0; r < runs_; ++r) {
      runs.push_back(std::make_unique<Run>(path(r), block));
      if (runs[r]->next())
        queue.push(r);
    }
    std::array<Bits, 3> last{};
    for (bool is_first = true; !queue.empty(); is_first = false) {
      const std::size_t r = queue.top();
      queue.pop();
      take(runs[r]->item, is_first || runs[r]->item.place != last);
      last = runs[r]->item.place;
      if (runs[r]->next())
        queue.push(r);
    }
    for (unsigned r = 0; r < runs_; ++r)
      std::filesystem::remove(path(r));
  }

private:
  struct Run {
    Run(const std::filesystem::path& path, std::size_t block)
        : file(path), stream(file, 0, block) {}

    bool next() {
      const char* const bytes = stream.next(sizeof(item));
      if (bytes)
        std::memcpy(&item, bytes, sizeof(item));
      return bytes != nullptr;
    }

    InputFile file;
    ByteStream stream;
    Item item{};
  };

  std::filesystem::path path(unsigned run) const {
    return folder_ / ("run-" + std::to_string(run));
  }
  void write_run() {
    std::sort(run_.begin(), run_.end());
    append_to_file(path(runs_++), run_.data(), run_.size() * sizeof(Item));
    run_.clear();
  }
  static Number coordinate(Bits place) {
    return std::bit_cast<Number>((place & sign) != 0 ? place & ~sign : ~place);
  }

  static constexpr Bits sign = Bits{1} << (8 * sizeof(Bits) - 1);
  static constexpr std::uint64_t most_sorted = 9'000'000; // sorting these takes about a second

  std::filesystem::path folder_;
  std::uint64_t memory_;
  std::size_t most_;
  std::vector<Item> run_;
  unsigned runs_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLACE_SORT_H
