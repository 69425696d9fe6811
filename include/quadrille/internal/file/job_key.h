#ifndef QUADRILLE_INTERNAL_FILE_JOB_KEY_H
#define QUADRILLE_INTERNAL_FILE_JOB_KEY_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace quadrille::internal {

/// A number that distinguishes a job from others. It depends on the input file as it is, and on
/// everything that affects the result.
class JobKey {
public:
  void add_number(std::uint64_t number) { checksum_.add(&number, sizeof(number)); }
  void add_number(double number) { checksum_.add(&number, sizeof(number)); }

  void add_text(std::string_view text) {
    add_number(std::uint64_t{text.size()});
    checksum_.add(text.data(), text.size());
  }

  /// Adds the size, the time of the last change, the beginning and the end of a file.
  void add_file(const InputFile& file) {
    add_number(file.size());
    add_number(static_cast<std::uint64_t>(file.changed()));
    std::vector<char> bytes(std::size_t{1} << 16);
    const std::uint64_t end = file.size() - std::min<std::uint64_t>(file.size(), bytes.size());
    for (const std::uint64_t offset : {std::uint64_t{0}, end})
      checksum_.add(bytes.data(), file.read_some(offset, bytes.data(), bytes.size()));
  }

  /// Adds a policy: its type; the members by which costs of the library differ; and all bytes of
  /// a policy that has no members that are rounded.
  template <class Policy>
  void add_policy(const std::optional<Policy>& policy) {
    add_number(std::uint64_t{policy.has_value()});
    if (policy)
      add_policy(*policy);
  }
  template <class Policy>
  void add_policy(const Policy& policy) {
    add_text(typeid(Policy).name());
    const auto add_member = [&](auto member) {
      if constexpr (std::is_invocable_v<decltype(member), const Policy&>)
        add_number(static_cast<double>(member(policy)));
    };
    add_member([](const auto& p) -> decltype(p.boundary_weight) { return p.boundary_weight; });
    add_member([](const auto& p) -> decltype(p.crease_weight) { return p.crease_weight; });
    add_member([](const auto& p) -> decltype(p.crease_degrees) { return p.crease_degrees; });
    add_member([](const auto& p) -> decltype(p.weighting) { return p.weighting; });
    add_member([](const auto& p) -> decltype(p.line_weight) { return p.line_weight; });
    add_member([](const auto& p) -> decltype(p.normal_noise) { return p.normal_noise; });
    add_member([](const auto& p) -> decltype(p.position_noise) { return p.position_noise; });
    add_member([](const auto& p) -> decltype(p.loss_weight) { return p.loss_weight; });
    add_member([](const auto& p) -> decltype(p.loss_tolerance) { return p.loss_tolerance; });
    add_member([](const auto& p) -> decltype(p.kind()) { return p.kind(); });
    add_member([](const auto& p) -> decltype(p.distance(1.0)) { return p.distance(1.0); });
    add_member([](const auto& p) -> decltype(p.distance(2.0)) { return p.distance(2.0); });
    if constexpr (std::has_unique_object_representations_v<Policy> && !std::is_empty_v<Policy>)
      checksum_.add(&policy, sizeof(policy));
  }

  std::uint64_t value() const { return checksum_.value(); }

private:
  Checksum checksum_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_KEY_H
