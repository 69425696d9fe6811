#ifndef QUADRILLE_INTERNAL_FILE_ID_INDEX_H
#define QUADRILLE_INTERNAL_FILE_ID_INDEX_H

#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille::internal {

/// Finds the position of a number in an ascending list: its top bits select a short range, which is
/// searched by bisection. There is about one such range per number.
class IdIndex {
public:
  explicit IdIndex(std::span<const VertexId> ids) : ids_(ids) {
    first_ = ids.empty() ? 0 : ids.front();
    const std::uint64_t range = ids.empty() ? 0 : std::uint64_t{ids.back()} - first_;
    const std::uint64_t wanted = std::max<std::uint64_t>(ids.size(), 1);
    while ((range >> shift_) >= wanted)
      ++shift_;
    begins_.resize(static_cast<std::size_t>(range >> shift_) + 2);
    for (const VertexId id : ids)
      ++begins_[bucket(id) + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i)
      begins_[i] += begins_[i - 1];
  }

  /// The id must be in the list; otherwise ids.size() is returned.
  std::size_t find(VertexId id) const {
    if (ids_.empty() || id < ids_.front() || id > ids_.back())
      return ids_.size();
    const std::size_t b = bucket(id);
    const auto begin = ids_.begin() + begins_[b], end = ids_.begin() + begins_[b + 1];
    const auto found = std::lower_bound(begin, end, id);
    return found != end && *found == id ? static_cast<std::size_t>(found - ids_.begin())
                                        : ids_.size();
  }

private:
  std::size_t bucket(VertexId id) const {
    return static_cast<std::size_t>((std::uint64_t{id} - first_) >> shift_);
  }

  std::span<const VertexId> ids_;
  std::uint64_t first_ = 0;
  unsigned shift_ = 0;
  std::vector<std::uint32_t> begins_; // of each range
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_ID_INDEX_H
