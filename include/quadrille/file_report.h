#ifndef QUADRILLE_FILE_REPORT_H
#define QUADRILLE_FILE_REPORT_H

#include <quadrille/report.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille {

/// What simplify_file is at.
enum class FileStage {
  weld,      ///< corners of STL become vertices, other PLY binary triangles, or tiles one surface
  survey,    ///< the file is read, before anything else is written
  partition, ///< it is cut into parts
  sample,    ///< pieces of parts are simplified, to learn up to which cost a phase goes
  simplify,  ///< parts are simplified
  regroup,   ///< what is left is cut into other parts
  sew,       ///< what is left is written
  check      ///< surfaces are compared, by file_distance or verify_files
};

/// In words.
constexpr std::string_view to_string(FileStage stage) {
  constexpr std::string_view names[] = {"weld",     "survey",  "partition", "sample",
                                        "simplify", "regroup", "sew",       "check"};
  return names[static_cast<std::size_t>(stage)];
}

/// What simplify_file will take, about, as far as sizes of files tell: it is there before anything
/// is done.
struct FileEstimate {
  std::uint64_t faces = 0;   ///< of the input
  std::uint64_t memory = 0;  ///< of the process at its greatest, in bytes
  std::uint64_t scratch = 0; ///< in the scratch folder at its greatest, in bytes
  std::uint64_t output = 0;  ///< of the output, in bytes; 0 if distances are limited
  double seconds = 0;        ///< of this process alone; it depends on the machine
};

/// How far simplify_file is.
struct FileStatus {
  FileStage stage = FileStage::survey; ///< what it is at
  unsigned phase = 0;                  ///< from 1 on; 0 while the file is cut
  unsigned phases = 0;                 ///< how many there will be, about
  std::size_t parts = 0;               ///< of the phase
  std::size_t parts_done = 0;          ///< of them
  std::uint64_t faces = 0;             ///< of the input
  double progress = 0;                 ///< about which part of all work is done, from 0 to 1
  FileEstimate estimate = {};          ///< of all of it, always the same
};

/// What simplify_file reads: a file, or several, which are tiles of one surface. Vertices of their
/// borders that lie at exactly the same place, in two tiles or more, become one.
struct SurfaceFiles {
  /// A file.
  template <class Path>
  requires std::is_convertible_v<const Path&, std::filesystem::path> SurfaceFiles(const Path& path)
      : paths{std::filesystem::path(path)} {}
  /// Tiles, all of them PLY with the same properties, or STL.
  SurfaceFiles(std::vector<std::filesystem::path> tiles) : paths(std::move(tiles)) {}

  std::vector<std::filesystem::path> paths; ///< at least one
};

/// How a file is simplified in parts.
struct OutOfCore {
  /// A folder for what lies on disk meanwhile, on a file system that all who run parts see. It is
  /// made if it is not there, and is as it was at the end: the job has a folder of its own in it.
  /// About 60 bytes for each face of the
  /// input, 70 if half of them stay, 90 while STL is welded; 4 more with labels, and 6 for each
  /// number of a vertex.
  std::filesystem::path scratch;
  /// How many bytes the process shall take at most. It has to be at least two bytes for each vertex
  /// of the input, beside 64 MB.
  std::uint64_t memory = 4'000'000'000;
  /// How many parts are simplified at a time; 0: one for each processor. There are never more than
  /// fit into the memory. The result does not depend on it.
  unsigned parts_in_flight = 0;
  /// Go on with what is in the scratch folder. Without this a folder with a job is refused.
  bool restart = false;
  /// Faces of a part, about; 0: as the memory allows, 4,000,000 at most. The result depends on it.
  std::uint64_t part_faces = 0;
  /// How many faces may be left before the last phase, which simplifies the whole to the target
  /// itself; 0: as many as fit into the memory. The result depends on it.
  std::uint64_t whole_faces = 0;
  /// How much colours, normals, texture coordinates and other numbers of vertices count beside the
  /// shape: see ChannelOptions::importance. Above 0. The result depends on it.
  double attribute_importance = 1;
  /// The output is a folder, in which each of several files of the input becomes one again, of the
  /// same name but with .ply. Borders between them stay where they are about, as those of labels,
  /// and fit bit for bit.
  bool keeps_tiles = false;
  /// Vertices at edges of one face stay where they are, bit by bit. The result depends on it.
  bool locks_boundary = false;
  /// Vertices at exactly the same place become one, whatever the edges: of one file, or of all
  /// tiles. Without this only those of faces that have vertices of their own do, and those of
  /// borders of tiles. Vertices at a place that differ in numbers that go along are refused. The
  /// result depends on it.
  bool welds = false;
  /// Where the limit is a ToleranceLimit: the name of the number of vertices of a PLY file that is
  /// their tolerance, in the unit of their places, at least 0. It goes along as others do.
  std::string tolerance = {};
  /// Read over whatever the file has beside positions, corners, labels and tolerances; else what
  /// can't go along is refused.
  bool positions_only = false;
  /// Called now and then by the thread that has called, and before each part; returning false ends
  /// the run, which can be restarted.
  std::function<bool(const FileStatus&)> proceed = {};
};

/// What simplify_file did. What Report says of topology is not known of a surface in parts; of the
/// contractions and refusals it has those of all phases, but not those of parts that had been
/// simplified before a restart in a phase that was over.
struct FileReport : Report {
  unsigned phases = 0;                        ///< in which parts were simplified
  std::size_t parts = 0;                      ///< of the first phase
  std::vector<std::uint64_t> faces_of_phases; ///< left by each
  bool is_count_exact = false;     ///< the target itself is what is left, or as near as faces allow
  std::uint64_t bytes_read = 0;    ///< of files, about
  std::uint64_t bytes_written = 0; ///< the same
  double diagonal = 0;             ///< of the box of the vertices that faces use
  std::uint64_t shared_vertices = 0; ///< in the first phase
  /// Vertices that have become one with another one at the same place, before all else.
  std::uint64_t welded_vertices = 0;
  /// Polygons that were cut into fans, for being flat or crossing themselves.
  std::uint64_t fans = 0;
  /// Faces that were left out, for having fewer than three different corners.
  std::uint64_t short_faces = 0;
  /// Vertices that no face uses, left out for not being finite.
  std::uint64_t unused_not_finite = 0;
  std::uint64_t peak_memory = 0;    ///< of the process so far, in bytes, as the system counts it
  std::vector<std::string> dropped; ///< elements and properties that were read over
};

/// Prints a report in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const FileReport& report) {
  out << static_cast<const Report&>(report) << "; " << report.phases << " phases, " << report.parts
      << " parts, " << report.bytes_read << " bytes read, " << report.bytes_written
      << " written, at most " << report.peak_memory << " bytes of memory";
  return out;
}

} // namespace quadrille

#endif // QUADRILLE_FILE_REPORT_H
