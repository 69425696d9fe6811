#ifndef QUADRILLE_INTERNAL_FILE_PHASE_PLAN_H
#define QUADRILLE_INTERNAL_FILE_PHASE_PLAN_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/vertex_scalars.h>
#include <quadrille/report.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ios>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// The files from which a chunk of a phase is read.
struct ChunkFiles {
  FileContent vertices, faces;
  FileContent labels = {};   ///< the labels of the faces; empty if there are none
  FileContent bounds = {};   ///< the bounds of the faces; empty if their distances are unknown
  std::uint64_t doubled = 0; ///< faces that repeat an earlier one, which do not count

  std::uint64_t face_count() const { return faces.size / sizeof(FaceRow) - doubled; }
};

/// The facts about the input.
struct InputFacts {
  std::uint64_t vertices = 0, faces = 0; ///< the counts of the file
  std::uint64_t counted_faces = 0;       ///< faces with three different corners, once each
  std::uint64_t doubled_faces = 0;       ///< faces that repeat an earlier one with the same
                                         ///< orientation
  std::uint64_t used_vertices = 0;       ///< vertices of the counted faces
  std::uint64_t unused_not_finite = 0;   ///< vertices
  MadeCounts made;
  bool has_doubles = false;
  FileBox box;         ///< the box of the used vertices
  ScalarRanges ranges; ///< the ranges of the used vertices
};

/// The plan of a phase that may begin: each of its chunks exists, and the results depend on nothing
/// else. It is written as a whole after all other files of the phase, and again when the limit of
/// its costs has been found.
struct PhasePlan {
  std::uint64_t key = 0;          ///< the key of the job: see JobKey
  unsigned phase = 0;             ///< from 1 on
  unsigned step = 0;              ///< the step of the schedule
  unsigned attempt = 0;           ///< above 0: the phase had removed too much, and is repeated
  bool is_last = false;           ///< one chunk, which is simplified to the target itself
  bool is_exact = false;          ///< each chunk contributes its share of the excess faces
  bool is_resolved = false;       ///< is it known where its chunks end?
  bool is_by_count = false;       ///< each chunk contributes its share of the faces above
                                  ///< `faces_wanted`
  double limit = 0;               ///< the greatest cost, in the engine's unit, if it is not the
                                  ///< last phase
  std::uint64_t faces_wanted = 0; ///< the target of the limit
  InputFacts input;
  std::vector<ChunkFiles> chunks;
  FileContent boundaries;
  FileContent label_table;                         ///< empty if there are no labels
  std::uint64_t first_chunks = 0;                  ///< chunks of the first phase
  std::uint64_t first_shared = 0;                  ///< vertices that several of them had
  std::uint64_t bytes_read = 0, bytes_written = 0; ///< so far
  /// The contractions of the phases that have ended.
  std::uint64_t contractions = 0;
  double error = 0;                                ///< the greatest of these phases
  /// The greatest tolerance of the input, after the first phase; 0 if there are none.
  double greatest_tolerance = 0;
  std::array<std::uint64_t, rejection_causes> rejections{}; ///< the rejections of these phases
  /// A count for each phase that has ended.
  std::vector<std::uint64_t> faces_after_phases = {};

  void write(const std::filesystem::path& path) const {
    std::ostringstream text;
    text << magic << std::hex;
    for_numbers(*this, [&](auto number) {
      if constexpr (std::is_same_v<decltype(number), double>)
        text << ' ' << std::bit_cast<std::uint64_t>(number);
      else
        text << ' ' << static_cast<std::uint64_t>(number);
    });
    text << '\n';
    const std::string content = text.str();
    const std::string end = end_of(content);
    WholeFile file(path);
    file.write(content.data(), content.size());
    file.write(end.data(), end.size());
    file.finish();
  }

  static PhasePlan read(const std::filesystem::path& path) {
    const InputFile file(path);
    std::string content(static_cast<std::size_t>(file.size()), '\0');
    file.read(0, content.data(), content.size());
    const std::size_t end = content.rfind("end ");
    if (end == std::string::npos || content.compare(0, magic.size(), magic) != 0 ||
        content.substr(end) != end_of(content.substr(0, end)))
      fail_file(path, "was changed after it was written: its checksum differs");
    std::istringstream text(content.substr(magic.size(), end - magic.size()));
    PhasePlan plan;
    text >> std::hex;
    for_numbers(plan, [&]<class Number>(Number& number) {
      std::uint64_t value = 0;
      text >> value;
      if constexpr (std::is_same_v<Number, double>)
        number = std::bit_cast<double>(value);
      else
        number = static_cast<Number>(value);
    });
    return plan;
  }

private:
  static inline const std::string magic = "quadrille phase 7";

  static std::string end_of(const std::string& content) {
    Checksum checksum;
    checksum.add(content.data(), content.size());
    std::ostringstream text;
    text << "end " << std::hex << checksum.value() << '\n';
    return text.str();
  }

  // Calls pass(x) for all numbers of a plan; when a plan is read, lists get the length that was
  // read.
  template <class Plan, class Pass>
  static void for_numbers(Plan& plan, Pass pass) {
    const auto pass_all = [&](auto&... numbers) { (pass(numbers), ...); };
    const auto pass_list = [&](auto& list, auto pass_item) {
      std::uint64_t size = list.size();
      pass(size);
      if constexpr (!std::is_const_v<Plan>)
        list.resize(static_cast<std::size_t>(size));
      for (auto& item : list)
        pass_item(item);
    };
    const auto pass_content = [&](auto& file) { pass_all(file.size, file.checksum); };
    pass_all(plan.key, plan.phase, plan.step, plan.attempt, plan.is_last, plan.is_exact,
             plan.is_resolved, plan.is_by_count, plan.limit, plan.faces_wanted, plan.first_chunks,
             plan.first_shared, plan.bytes_read, plan.bytes_written, plan.contractions, plan.error,
             plan.greatest_tolerance);
    for (auto& number : plan.rejections)
      pass(number);
    auto& input = plan.input;
    pass_all(input.vertices, input.faces, input.counted_faces, input.doubled_faces,
             input.used_vertices, input.unused_not_finite, input.has_doubles, input.made.welded,
             input.made.fans, input.made.short_faces);
    for (std::size_t i = 0; i < 3; ++i)
      pass_all(input.box.low.coordinates[i], input.box.high.coordinates[i]);
    pass_list(input.ranges.low, pass);
    pass_list(input.ranges.high, pass);
    pass_content(plan.boundaries);
    pass_content(plan.label_table);
    pass_list(plan.chunks, [&](auto& chunk) {
      pass_content(chunk.vertices);
      pass_content(chunk.faces);
      pass_content(chunk.labels);
      pass_content(chunk.bounds);
      pass(chunk.doubled);
    });
    pass_list(plan.faces_after_phases, pass);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PHASE_PLAN_H
