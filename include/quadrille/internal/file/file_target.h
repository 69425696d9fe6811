#ifndef QUADRILLE_INTERNAL_FILE_FILE_TARGET_H
#define QUADRILLE_INTERNAL_FILE_FILE_TARGET_H

#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/stop.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace quadrille::internal {

/// The stop policies of an out-of-core surface: how many of its faces are to be left, and whether a
/// distance limit may end it before.
class FileTarget {
public:
  template <class Stop>
  FileTarget(const Stop& stop, bool is_limited) : is_limited_(is_limited) {
    static_assert(
        std::is_same_v<Stop, FaceCount> || std::is_same_v<Stop, FaceRatio>,
        "quadrille: the target for a file is a FaceCount or FaceRatio, a DistanceLimit, "
        "HausdorffLimit or ToleranceLimit, or AnyOf one of each: other stop policies work "
        "only for surfaces in memory");
    validate(stop);
    if constexpr (std::is_same_v<Stop, FaceCount>)
      faces_ = stop.faces;
    else
      ratio_ = stop.ratio;
  }

  std::uint64_t faces(std::uint64_t of) const {
    return ratio_ < 0 ? faces_
                      : static_cast<std::uint64_t>(std::llround(ratio_ * static_cast<double>(of)));
  }
  bool is_limited() const { return is_limited_; }
  void add_to(JobKey& key) const {
    key.add_number(faces_);
    key.add_number(ratio_);
  }

private:
  std::uint64_t faces_ = 0;
  double ratio_ = -1; // negative if the target is a count
  bool is_limited_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_FILE_TARGET_H
