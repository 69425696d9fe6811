#ifndef QUADRILLE_INTERNAL_FILE_SAMPLE_FILE_H
#define QUADRILLE_INTERNAL_FILE_SAMPLE_FILE_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

namespace quadrille::internal {

/// The costs in a connected region of a chunk.
struct CostSample {
  double free_faces = 0; ///< see SampleCounts
  CostHistogram costs;
};

/// The samples of a chunk as a file, which exists completely or not at all, so that any process may
/// take them.
class SampleFile {
public:
  /// `key` is the key of the job.
  static void write(const std::filesystem::path& path, std::uint64_t key,
                    const std::vector<CostSample>& samples) {
    std::vector<Row> rows(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      rows[i].free_faces = samples[i].free_faces;
      const auto counters = samples[i].costs.counters();
      std::copy(counters.begin(), counters.end(), rows[i].counters.begin());
    }
    const Header header{magic, key, rows.size(), checksum_of(rows)};
    WholeFile file = WholeFile::by_any_process(path);
    file.write(&header, sizeof(header));
    file.write(rows.data(), rows.size() * sizeof(Row));
    file.finish();
  }

  /// Returns nothing if they have not been taken, or do not belong to this job.
  static std::optional<std::vector<CostSample>> read(const std::filesystem::path& path,
                                                     std::uint64_t key) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
      return std::nullopt;
    const InputFile file(path);
    Header header{};
    if (file.size() < sizeof(header))
      return std::nullopt;
    file.read(0, &header, sizeof(header));
    if (header.magic != magic || header.key != key ||
        file.size() != sizeof(header) + header.count * sizeof(Row))
      return std::nullopt;
    std::vector<Row> rows(static_cast<std::size_t>(header.count));
    file.read(sizeof(header), rows.data(), rows.size() * sizeof(Row));
    return checksum_of(rows) == header.checksum ? std::optional(samples(rows)) : std::nullopt;
  }

private:
  static constexpr std::uint64_t magic = 0x31504D53'4C445251; // "QRDLSMP1"

  struct Header {
    std::uint64_t magic, key, count, checksum;
  };
  struct Row {
    double free_faces;
    std::array<std::uint64_t, CostHistogram::size> counters;
  };

  static std::uint64_t checksum_of(const std::vector<Row>& rows) {
    Checksum checksum;
    checksum.add(rows.data(), rows.size() * sizeof(Row));
    return checksum.value();
  }
  static std::vector<CostSample> samples(const std::vector<Row>& rows) {
    std::vector<CostSample> result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      result[i].free_faces = rows[i].free_faces;
      std::copy(rows[i].counters.begin(), rows[i].counters.end(),
                result[i].costs.counters().begin());
    }
    return result;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SAMPLE_FILE_H
