#ifndef QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H
#define QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H

#include <quadrille/internal/file/disk_file.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Is it one of the names that a job gives to its files: a stem, perhaps with numbers, and perhaps
/// unfinished?
inline bool is_job_file(std::string_view name, std::initializer_list<std::string_view> stems) {
  const std::size_t end = (std::min)(name.find_first_of("-."), name.size());
  if (std::find(stems.begin(), stems.end(), name.substr(0, end)) == stems.end())
    return false;
  std::string rest(name.substr(end));
  for (const std::string_view known : {".unfinished", ".ply"})
    if (const std::size_t at = rest.find(known); at != std::string::npos)
      rest.erase(at, known.size());
  return rest.find_first_not_of("-0123456789") == std::string::npos;
}

/// Removes from a folder the files that have the names of a job's files.
template <class IsOwn>
void remove_files_only_if(const std::filesystem::path& folder, const IsOwn& is_own) {
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end;
       i.increment(error))
    if (is_own(i->path().filename().string()) &&
        !std::filesystem::is_directory(i->symlink_status()))
      found.push_back(i->path());
  for (const std::filesystem::path& path : found)
    if (!std::filesystem::remove(path, error) && error)
      fail_file(path, "cannot be removed: " + error.message());
}
/// Removes the folder as well if nothing else is in it.
template <class IsOwn>
void remove_files_if(const std::filesystem::path& folder, const IsOwn& is_own) {
  remove_files_only_if(folder, is_own);
  ::rmdir(folder.c_str());
}
inline void remove_job_files(const std::filesystem::path& folder,
                             std::initializer_list<std::string_view> stems) {
  remove_files_if(folder, [&](const std::string& name) { return is_job_file(name, stems); });
}

/// The folder that a job makes for itself in the scratch folder, and the names of its files. No
/// file with another name is read, overwritten or removed.
///
/// job                    marks the folder as a job's, see JobLock
/// lock                   names the process that works there, see JobLock
/// welding/               files for making a surface from a soup, see StlWeld
/// welded-KEY.ply         that surface, also the one made from several tiles
/// welded-0-T.ply         tile T of it, if it is a soup
/// welded-0.ply           the result of several tiles, before it is split into them
/// labels                 the values of the labels, see LabelTable
/// phase-K/plan           the plan of the phase: it exists once all of the phase's input does
/// phase-K/vertices-P     the vertices of chunk P, as VertexRow
/// phase-K/faces-P        its faces, as FaceRow
/// phase-K/labels-P       the label of each face, if there are labels
/// phase-K/bounds-P       a distance bound for each face, see FaceBound, if distances are limited
/// phase-K/boundaries        edges of one face between vertices that are shared, as two numbers
/// phase-K/sample-P       the costs in samples of the chunk, see SampleFile
/// phase-K/left-P         the remaining chunk: it exists once the chunk has been simplified
/// phase-K/claims-N/      which process has which chunk, see TaskClaims
class JobFolder {
public:
  /// The folder lies in the user's scratch folder, which need not exist yet.
  explicit JobFolder(const std::filesystem::path& scratch)
      : scratch_(scratch.has_filename() ? scratch : scratch.parent_path()),
        path_(scratch_ / "quadrille-job") {}

  const std::filesystem::path& scratch() const { return scratch_; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path marker() const { return path_ / "job"; }
  std::filesystem::path lock() const { return path_ / "lock"; }
  std::filesystem::path phase(unsigned k) const { return path_ / ("phase-" + std::to_string(k)); }
  std::filesystem::path plan(unsigned k) const { return phase(k) / "plan"; }
  std::filesystem::path boundaries(unsigned k) const { return phase(k) / "borders"; }
  std::filesystem::path vertices(unsigned k, std::size_t chunk) const {
    return phase(k) / ("vertices-" + std::to_string(chunk));
  }
  std::filesystem::path faces(unsigned k, std::size_t chunk) const {
    return phase(k) / ("faces-" + std::to_string(chunk));
  }
  std::filesystem::path labels(unsigned k, std::size_t chunk) const {
    return phase(k) / ("labels-" + std::to_string(chunk));
  }
  std::filesystem::path bounds(unsigned k, std::size_t chunk) const {
    return phase(k) / ("bounds-" + std::to_string(chunk));
  }
  /// The values of the labels, for all phases.
  std::filesystem::path label_table() const { return path_ / "labels"; }
  std::filesystem::path left(unsigned k, std::size_t chunk) const {
    return phase(k) / ("left-" + std::to_string(chunk));
  }
  std::filesystem::path samples(unsigned k, std::size_t chunk) const {
    return phase(k) / ("sample-" + std::to_string(chunk));
  }
  /// The folder in which a surface is made from a soup.
  std::filesystem::path welding() const { return path_ / "welding"; }
  /// The file of one of several soups, which is a tile of a surface.
  std::filesystem::path welded_tile(std::size_t tile) const {
    return path_ / ("welded-0-" + std::to_string(tile) + ".ply");
  }
  /// The file of the surface that was made.
  std::filesystem::path welded(std::uint64_t key) const {
    return path_ / ("welded-" + std::to_string(key) + ".ply");
  }

  /// Returns the current phase, which is the one with a plan. If it is 0, nothing has been
  /// finished.
  unsigned phase_at_work() const {
    unsigned k = 0;
    for (const unsigned phase : phases())
      if (std::filesystem::exists(plan(phase)))
        k = (std::max)(k, phase);
    return k;
  }

  /// Makes an empty folder for a phase; anything that a killed run has left there is removed.
  void begin_phase(unsigned k) const {
    remove_phase(k);
    std::error_code error;
    std::filesystem::create_directories(phase(k), error);
    if (error)
      fail_file(phase(k), "cannot be made: " + error.message());
  }
  void remove_phase(unsigned k) const {
    ::unlink(plan(k).c_str()); // first, because it says that the other files exist
    remove_claims(phase(k));
    remove_job_files(
        phase(k), {"plan", "vertices", "faces", "labels", "bounds", "borders", "sample", "left"});
  }
  /// Removes the chunks of a phase after all of them have been simplified.
  void remove_chunks(unsigned k) const {
    remove_job_files(phase(k), {"vertices", "faces", "labels", "bounds", "borders", "sample"});
  }
  void remove_phases() const {
    for (const unsigned k : phases())
      remove_phase(k);
  }
  /// Removes the files from which a surface was made out of a soup.
  void remove_welded() const {
    remove_job_files(welding(), {"run", "corners"});
    remove_job_files(path_, {"welded"});
  }

private:
  static bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  }
  // Removes the claims that a killed run has left.
  static void remove_claims(const std::filesystem::path& phase) {
    constexpr std::string_view stem = "claims-";
    std::error_code error;
    for (std::filesystem::directory_iterator i(phase, error), end; !error && i != end;
         i.increment(error)) {
      const std::string name = i->path().filename().string();
      if (name.rfind(stem, 0) == 0 && is_number(std::string_view(name).substr(stem.size())))
        remove_files_if(i->path(),
                        [](const std::string& file) { return is_number(file) || file == "ended"; });
    }
  }
  // Returns the number of a phase's folder, from 1 on, with the name that phase() gives.
  static std::optional<unsigned> phase_of(const std::string& name) {
    constexpr std::string_view stem = "phase-";
    const std::string digits = name.substr((std::min)(name.size(), stem.size()));
    if (name.rfind(stem, 0) != 0 || !is_number(digits) || digits.size() > 5 || digits[0] == '0')
      return std::nullopt;
    return static_cast<unsigned>(std::stoul(digits));
  }
  std::vector<unsigned> phases() const {
    std::vector<unsigned> result;
    std::error_code error;
    for (std::filesystem::directory_iterator i(path_, error), end; !error && i != end;
         i.increment(error))
      if (const auto k = phase_of(i->path().filename().string()))
        result.push_back(*k);
    std::sort(result.begin(), result.end());
    return result;
  }

  std::filesystem::path scratch_, path_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H
