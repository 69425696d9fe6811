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

/// The stages of simplify_file.
enum class FileStage {
  weld,      ///< merges the corners of STL into vertices, converts other PLY to binary triangles,
             ///< or joins tiles into one surface
  survey,    ///< reads the file, before anything else is written
  partition, ///< cuts it into chunks
  sample,    ///< simplifies samples of chunks, to estimate the cost limit of a phase
  simplify,  ///< simplifies the chunks
  regroup,   ///< cuts the result into other chunks
  merge,     ///< writes the result
  check      ///< compares surfaces, in file_distance or verify_files
};

/// Returns the name of a stage.
constexpr std::string_view to_string(FileStage stage) {
  constexpr std::string_view names[] = {"weld",     "survey",  "partition", "sample",
                                        "simplify", "regroup", "merge",     "check"};
  return names[static_cast<std::size_t>(stage)];
}

/// An estimate of the resources of simplify_file, from the file sizes. It is available before any
/// work is done.
struct FileEstimate {
  std::uint64_t faces = 0;   ///< the faces of the input
  std::uint64_t memory = 0;  ///< peak memory of the process, in bytes
  std::uint64_t scratch = 0; ///< peak size of the scratch folder, in bytes
  std::uint64_t output = 0;  ///< size of the output, in bytes; 0 if distances are limited
  double seconds = 0;        ///< time of this process alone; it depends on the machine
};

/// The progress of simplify_file.
struct FileStatus {
  FileStage stage = FileStage::survey; ///< the current stage
  unsigned phase = 0;                  ///< from 1 on; 0 while the file is cut
  unsigned phases = 0;                 ///< the estimated number of phases
  std::size_t chunks = 0;              ///< the number of chunks of the phase
  std::size_t chunks_done = 0;         ///< the number of chunks that are done
  std::uint64_t faces = 0;             ///< the faces of the input
  double progress = 0;                 ///< the estimated fraction of the whole work that is done,
                                       ///< from 0 to 1
  FileEstimate estimate = {};          ///< for the whole job; it does not change
};

/// The input of simplify_file: one file, or several tiles of one surface. Boundary vertices at
/// exactly the same place in two or more tiles are merged.
struct SurfaceFiles {
  /// Takes one file.
  template <class Path>
  requires std::is_convertible_v<const Path&, std::filesystem::path> SurfaceFiles(const Path& path)
      : paths{std::filesystem::path(path)} {}
  /// Takes tiles: all PLY with the same properties, or all STL.
  SurfaceFiles(std::vector<std::filesystem::path> tiles) : paths(std::move(tiles)) {}

  std::vector<std::filesystem::path> paths; ///< at least one
};

/// Options for the simplification of a file in chunks.
struct OutOfCore {
  /// A folder for temporary files, on a file system that all processes of the job share. It is
  /// created if it does not exist, and is left as it was: the job has a subfolder of its own. It
  /// takes about 60 bytes for each face of the input, 70 if half of them stay, 90 while STL is
  /// merged into vertices; 4 more with labels, and 6 for each scalar property of a vertex.
  std::filesystem::path scratch;
  /// The greatest memory of the process, in bytes. It must be at least 64 MB plus two bytes for
  /// each vertex of the input.
  std::uint64_t memory = 4'000'000'000;
  /// The number of chunks that are simplified at a time; 0: one for each processor. It is reduced
  /// to what fits into memory. The result does not depend on it.
  unsigned chunks_in_flight = 0;
  /// Resumes the job in the scratch folder. Otherwise a folder with a job is rejected.
  bool restart = false;
  /// The approximate number of faces of a chunk; 0: as many as fit into memory, but at most
  /// 4,000,000. The result depends on it.
  std::uint64_t chunk_faces = 0;
  /// The greatest number of faces with which the last phase may begin, which simplifies the whole
  /// surface to the target; 0: as many as fit into memory. The result depends on it.
  std::uint64_t whole_faces = 0;
  /// The importance of colours, normals, texture coordinates and other scalar properties of
  /// vertices relative to the shape: see ChannelOptions::importance. Above 0. The result depends on
  /// it.
  double attribute_importance = 1;
  /// Makes the output a folder, in which each file of the input gets its own result, with the same
  /// name but the extension .ply. The boundaries between the files stay roughly in place, as those
  /// of labels do, and match bit for bit.
  bool keeps_tiles = false;
  /// Keeps vertices at edges of one face in place, bit for bit. The result depends on it.
  bool locks_boundary = false;
  /// Merges vertices at exactly the same place, whatever their edges are, within one file or across
  /// all tiles. Otherwise only the vertices of faces that share no vertices are merged, and those
  /// of tile boundaries. Vertices at one place with different scalar properties are rejected. The
  /// result depends on it.
  bool welds = false;
  /// For a ToleranceLimit: the name of the scalar property of a PLY file's vertices that is their
  /// tolerance, in the unit of the positions, at least 0. It is carried as other properties are.
  std::string tolerance = {};
  /// Ignores everything in the file but positions, corners, labels and tolerances; otherwise
  /// contents that cannot be carried are rejected.
  bool positions_only = false;
  /// Called from time to time by the calling thread, and before each chunk; if it returns false,
  /// the run ends and can be resumed.
  std::function<bool(const FileStatus&)> proceed = {};
};

/// The report of simplify_file. The figures of Report on topology are not known for a surface in
/// chunks. Contractions and rejections are summed over all phases, except for chunks that had been
/// simplified before a restart in a phase that was over.
struct FileReport : Report {
  unsigned phases = 0;                        ///< the number of phases in which chunks were
                                              ///< simplified
  std::size_t chunks = 0;                     ///< the number of chunks of the first phase
  std::vector<std::uint64_t> faces_of_phases; ///< the faces left by each phase
  bool is_count_exact = false;       ///< the target is met exactly, or as nearly as faces allow
  std::uint64_t bytes_read = 0;      ///< approximate bytes read from files
  std::uint64_t bytes_written = 0;   ///< approximate bytes written to files
  double diagonal = 0;               ///< the diagonal of the box of the vertices that faces use
  std::uint64_t shared_vertices = 0; ///< shared by chunks of the first phase
  /// Vertices that were merged with another one at the same place before the simplification.
  std::uint64_t welded_vertices = 0;
  /// Polygons that were cut into fans because they are flat or intersect themselves.
  std::uint64_t fans = 0;
  /// Faces that were left out because they have fewer than three different corners.
  std::uint64_t short_faces = 0;
  /// Vertices without a face that were left out because they are not finite.
  std::uint64_t unused_not_finite = 0;
  std::uint64_t peak_memory = 0;    ///< peak memory of the process so far, in bytes, as the system
                                    ///< reports it
  std::vector<std::string> dropped; ///< elements and properties that were ignored
};

/// Prints a report in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const FileReport& report) {
  out << static_cast<const Report&>(report) << "; " << report.phases << " phases, " << report.chunks
      << " parts, " << report.bytes_read << " bytes read, " << report.bytes_written
      << " written, at most " << report.peak_memory << " bytes of memory";
  return out;
}

} // namespace quadrille

#endif // QUADRILLE_FILE_REPORT_H
