#ifndef QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H
#define QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H

#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace quadrille::internal {

/// The names of the files of a scratch folder.
///
/// welded-KEY.ply         the surface of a soup, see StlWeld
/// labels                  what these are, see LabelTable
/// phase-K/plan            what the phase is: there once all of the phase's input is
/// phase-K/vertices-P      the vertices of part P, as VertexRow
/// phase-K/faces-P         its faces, as FaceRow
/// phase-K/labels-P        the label of each face, if there are labels
/// phase-K/borders         edges of one face between vertices that are shared, as two numbers
/// phase-K/left-P          what is left of the part: there once it has been simplified
class JobFolder {
public:
  explicit JobFolder(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path phase(unsigned k) const { return path_ / ("phase-" + std::to_string(k)); }
  std::filesystem::path plan(unsigned k) const { return phase(k) / "plan"; }
  std::filesystem::path borders(unsigned k) const { return phase(k) / "borders"; }
  std::filesystem::path vertices(unsigned k, std::size_t part) const {
    return phase(k) / ("vertices-" + std::to_string(part));
  }
  std::filesystem::path faces(unsigned k, std::size_t part) const {
    return phase(k) / ("faces-" + std::to_string(part));
  }
  std::filesystem::path labels(unsigned k, std::size_t part) const {
    return phase(k) / ("labels-" + std::to_string(part));
  }
  /// What labels are: of all phases.
  std::filesystem::path label_table() const { return path_ / "labels"; }
  std::filesystem::path left(unsigned k, std::size_t part) const {
    return phase(k) / ("left-" + std::to_string(part));
  }
  /// A soup whose vertices have been made one.
  std::filesystem::path welded(std::uint64_t key) const {
    return path_ / ("welded-" + std::to_string(key) + ".ply");
  }

  /// The phase that is at work: the one with a plan. Nothing has been finished if it is 0.
  unsigned phase_at_work() const {
    unsigned k = 0;
    std::error_code ignored;
    if (!std::filesystem::is_directory(path_, ignored))
      return 0;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("phase-", 0) == 0 && std::filesystem::exists(entry.path() / "plan"))
        k = (std::max)(k, static_cast<unsigned>(std::stoul(name.substr(6))));
    }
    return k;
  }

  /// An empty folder for a phase; what a run has left there that was killed goes.
  void begin_phase(unsigned k) const {
    remove_phase(k);
    std::error_code error;
    std::filesystem::create_directories(phase(k), error);
    if (error)
      fail_file(phase(k), "cannot be made: " + error.message());
  }
  void remove_phase(unsigned k) const {
    std::error_code error;
    std::filesystem::remove(plan(k), error); // first: it says that the others are there
    std::filesystem::remove_all(phase(k), error);
    std::error_code ignored;
    if (error && std::filesystem::exists(phase(k), ignored))
      fail_file(phase(k), "cannot be removed: " + error.message());
  }
  /// What a soup was made.
  void remove_welded() const {
    std::error_code ignored;
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      if (entry.path().filename().string().rfind("welded-", 0) == 0)
        found.push_back(entry.path());
    for (const std::filesystem::path& path : found)
      std::filesystem::remove(path, ignored);
    std::filesystem::remove_all(path_ / "welding", ignored);
  }
  /// Removes whatever a job has there, and the folder if nothing else is in it.
  void remove() const {
    for (unsigned k = 0; k <= phase_at_work() + 1; ++k)
      remove_phase(k);
    remove_welded();
    std::error_code ignored;
    std::filesystem::remove(label_table(), ignored);
    std::filesystem::remove(path_, ignored);
  }

private:
  std::filesystem::path path_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_FOLDER_H
