#ifndef QUADRILLE_INTERNAL_FILE_SURVIVORS_H
#define QUADRILLE_INTERNAL_FILE_SURVIVORS_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// The counts and distances that all chunks of a run add up.
struct ChunkCounters {
  std::uint64_t faces_before = 0, contractions = 0;
  std::array<std::uint64_t, rejection_causes> rejections{};
  double error = 0, seconds = 0;
  double distance_bound = 0, hausdorff_bound = 0;
  double greatest_tolerance = 0; ///< the greatest tolerance of the input, as far as the chunk knows
  double used_tolerance = -1;    ///< as in Report; below 0 if it is unknown
  std::array<double, 3> place_of_used{};
  std::uint32_t stop = 0; ///< a StopReason

  static ChunkCounters of(const Report& report, double greatest_tolerance) {
    ChunkCounters counters;
    counters.greatest_tolerance = greatest_tolerance;
    counters.faces_before = report.faces_before;
    counters.contractions = report.contractions;
    for (std::size_t i = 0; i < rejection_causes; ++i)
      counters.rejections[i] = report.rejections[i];
    counters.error = report.error;
    counters.distance_bound = report.distance_bound;
    counters.hausdorff_bound = report.hausdorff_bound;
    if (report.used_tolerance) {
      counters.used_tolerance = report.used_tolerance->fraction;
      counters.place_of_used = report.used_tolerance->place;
    }
    counters.seconds = report.seconds.total();
    counters.stop = static_cast<std::uint32_t>(report.stop);
    return counters;
  }
};

/// The beginning of a file of survivors. It is all zeros until the file is finished.
struct SurvivorsHeader {
  std::array<char, 8> magic{'Q', 'D', 'R', 'L', 'E', 'F', 'T', '4'};
  std::uint64_t key = 0; ///< the key of the job
  std::uint64_t phase = 0, chunk = 0;
  std::uint64_t vertices = 0, faces = 0;
  std::uint64_t scalars = 0;    ///< per vertex, after the vertices
  std::uint64_t state_size = 0; ///< per vertex, in bytes, after the faces
  std::uint64_t labels = 0;     ///< one for each face, or none
  std::uint64_t bounds = 0;     ///< one for each face, or none
  std::uint64_t given = 0;      ///< vertices whose state before the phase is stored, after the
                                ///< states
  std::uint64_t checksum = 0;   ///< the checksum of all that follows
  ChunkCounters counters = {};

  std::uint64_t content_size() const {
    return vertices * (sizeof(VertexRow) + scalars * sizeof(double) + state_size) +
           faces * sizeof(FaceRow) + labels * sizeof(std::uint32_t) + bounds * sizeof(FaceBound) +
           given * (sizeof(std::uint64_t) + state_size);
  }
};
static_assert(std::is_trivially_copyable_v<SurvivorsHeader>);

/// The remaining chunk, by the numbers of the input: vertices in ascending order, their scalars,
/// then faces. States are bytes: the state of each vertex, then pairs of an index among the
/// vertices and the state that the vertex had been given.
struct Survivors {
  std::vector<VertexRow> vertices;
  std::vector<FaceRow> faces;
  std::vector<double> scalars = {};       ///< the scalars of the vertices, or empty
  std::vector<std::uint32_t> labels = {}; ///< the labels of the faces, or empty
  std::vector<FaceBound> bounds = {};     ///< the bounds of the faces, or empty
  std::vector<char> states = {};
  std::vector<std::uint64_t> given = {};
  std::vector<char> given_states = {};

  /// Returns the scalars of one vertex.
  std::span<const double> scalars_of(std::size_t vertex) const {
    const std::size_t size = vertices.empty() ? 0 : scalars.size() / vertices.size();
    return std::span(scalars).subspan(vertex * size, size);
  }

  /// `header` has key, phase, chunk and counters.
  void write(const std::filesystem::path& path, SurvivorsHeader header) const {
    header.vertices = vertices.size();
    header.faces = faces.size();
    header.labels = labels.size();
    header.bounds = bounds.size();
    header.given = given.size();
    header.scalars = vertices.empty() ? 0 : scalars.size() / vertices.size();
    header.state_size = vertices.empty() ? 0 : states.size() / vertices.size();
    Checksum checksum;
    for_content([&](const void* bytes, std::size_t size) { checksum.add(bytes, size); });
    header.checksum = checksum.value();
    WholeFile file = WholeFile::by_any_process(path);
    file.write(&header, sizeof(header));
    for_content([&](const void* bytes, std::size_t size) { file.write(bytes, size); });
    file.finish();
  }

  /// Throws if a file is not the one that was written.
  static Survivors read(const std::filesystem::path& path, const SurvivorsHeader& header) {
    const InputFile file(path);
    Survivors s;
    s.vertices.resize(static_cast<std::size_t>(header.vertices));
    s.faces.resize(static_cast<std::size_t>(header.faces));
    s.scalars.resize(static_cast<std::size_t>(header.vertices * header.scalars));
    s.labels.resize(static_cast<std::size_t>(header.labels));
    s.bounds.resize(static_cast<std::size_t>(header.bounds));
    s.states.resize(static_cast<std::size_t>(header.vertices * header.state_size));
    s.given.resize(static_cast<std::size_t>(header.given));
    s.given_states.resize(static_cast<std::size_t>(header.given * header.state_size));
    Checksum checksum;
    std::uint64_t offset = sizeof(header);
    s.for_content([&](void* bytes, std::size_t size) {
      file.read(offset, bytes, size);
      checksum.add(bytes, size);
      offset += size;
    });
    if (checksum.value() != header.checksum)
      fail_file(path, "was changed after it was written: its checksum differs");
    return s;
  }

  /// Returns the header, if the file is finished and belongs to this chunk of this job; nothing if
  /// it does not exist or does not end where it should.
  static std::optional<SurvivorsHeader> header(const std::filesystem::path& path, std::uint64_t key,
                                               unsigned phase, std::size_t chunk) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
      return std::nullopt;
    const InputFile file(path);
    SurvivorsHeader header;
    if (file.size() < sizeof(header))
      return std::nullopt;
    file.read(0, &header, sizeof(header));
    const bool is_it = header.magic == SurvivorsHeader{}.magic && header.key == key &&
                       header.phase == phase && header.chunk == chunk &&
                       header.content_size() == file.size() - sizeof(header);
    return is_it ? std::optional(header) : std::nullopt;
  }

private:
  template <class Self, class Visit>
  static void visit_content(Self& s, Visit visit) {
    visit(s.vertices.data(), s.vertices.size() * sizeof(VertexRow));
    visit(s.scalars.data(), s.scalars.size() * sizeof(double));
    visit(s.faces.data(), s.faces.size() * sizeof(FaceRow));
    visit(s.labels.data(), s.labels.size() * sizeof(std::uint32_t));
    visit(s.bounds.data(), s.bounds.size() * sizeof(FaceBound));
    visit(s.states.data(), s.states.size());
    visit(s.given.data(), s.given.size() * sizeof(std::uint64_t));
    visit(s.given_states.data(), s.given_states.size());
  }
  template <class Visit>
  void for_content(Visit visit) const {
    visit_content(*this, visit);
  }
  template <class Visit>
  void for_content(Visit visit) {
    visit_content(*this, visit);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_SURVIVORS_H
