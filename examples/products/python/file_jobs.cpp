#include "file_jobs.h"

#include "../chunks/policies_of_chunks.h"
#include "interruptible.h"

#include <quadrille/compiled.h>
#include <quadrille/file.h>
#include <quadrille/report.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using namespace quadrille;
using internal::BuiltInPlacement;
using internal::DistanceChoice;

/// The steps of a job, whatever its cost. All of them are called without the lock of the
/// interpreter.
class FileJob {
public:
  FileJob() = default;
  FileJob(const FileJob&) = delete;
  FileJob& operator=(const FileJob&) = delete;
  virtual ~FileJob() = default;

  virtual FileEstimate estimate() const = 0;
  virtual std::size_t partition() = 0; ///< how many parts come next
  virtual std::size_t join() = 0;      ///< the same
  virtual void simplify(std::size_t part) const = 0;
  virtual std::size_t close() = 0; ///< the same, or 0 if nothing does
  virtual FileReport merge(const std::filesystem::path& output) = 0;
  virtual FileReport run(const std::filesystem::path& output) = 0;
};

template <class Cost>
class FileJobBy : public FileJob {
public:
  template <class Stop>
  FileJobBy(const SurfaceFiles& input, const Stop& stop, const OutOfCore& how, const Cost& cost,
            const SoupOptions& options)
      : job_(input, stop, how, cost, placement_of_chunks<Cost>(options),
             options.topology.value_or(Topology::kept), limit_of_chunks(options, how.tolerance)) {}

  FileEstimate estimate() const override { return job_.estimate(); }
  std::size_t partition() override { return job_.partition(), job_.chunks(); }
  std::size_t join() override { return job_.join(), job_.chunks(); }
  void simplify(std::size_t part) const override {
    if (part >= job_.chunks())
      throw std::out_of_range("part is " + std::to_string(part) + ", but the phase has " +
                              std::to_string(job_.chunks()) + " parts, numbered from 0");
    Interruptible proceed{py::none()};
    job_.simplify(part, [&] { return !proceed(0); });
  }
  std::size_t close() override { return job_.close() ? job_.chunks() : 0; }
  FileReport merge(const std::filesystem::path& output) override { return job_.merge(output); }
  FileReport run(const std::filesystem::path& output) override { return job_(output); }

private:
  PartitionedSimplifier<Cost, BuiltInPlacement, Topology, std::optional<DistanceChoice>> job_;
};

std::unique_ptr<FileJob> job_of(const std::vector<std::filesystem::path>& paths,
                                const SoupOptions& options, OutOfCore how, py::object progress) {
  how.proceed = [proceed = std::make_shared<Interruptible>(std::move(progress))](
                    const FileStatus& status) { return (*proceed)(status); };
  const SurfaceFiles input(paths);
  const py::gil_scoped_release unlocked;
  return with_policies_of_chunks(
      options, limit_of_chunks(options, how.tolerance).has_value(),
      [&]<class Cost>(const Cost& cost, const auto& stop) -> std::unique_ptr<FileJob> {
        return std::make_unique<FileJobBy<Cost>>(input, stop, how, cost, options);
      });
}

/// What a report of a file has beside what any has.
py::dict figures_of(const FileReport& report) {
  using namespace py::literals;
  return py::dict("phases"_a = report.phases, "chunks"_a = report.chunks,
                  "faces_of_phases"_a = report.faces_of_phases,
                  "is_count_exact"_a = report.is_count_exact, "bytes_read"_a = report.bytes_read,
                  "bytes_written"_a = report.bytes_written, "diagonal"_a = report.diagonal,
                  "peak_memory"_a = report.peak_memory,
                  "welded_vertices"_a = report.welded_vertices, "fans"_a = report.fans,
                  "short_faces"_a = report.short_faces,
                  "unused_not_finite"_a = report.unused_not_finite, "dropped"_a = report.dropped);
}

/// A step that ends with a report, as that and the figures beside.
template <FileReport (FileJob::*step)(const std::filesystem::path&)>
py::tuple reported(FileJob& job, const std::filesystem::path& output) {
  const FileReport report = [&] {
    const py::gil_scoped_release unlocked;
    return (job.*step)(output);
  }();
  return py::make_tuple(static_cast<const Report&>(report), figures_of(report));
}

void add_status(py::module_& m) {
  py::class_<FileEstimate>(
      m, "FileEstimate",
      "The resources that simplify_file() will need, estimated from the file sizes.")
      .def_readonly("faces", &FileEstimate::faces, "faces of the input")
      .def_readonly("memory", &FileEstimate::memory, "the peak memory of the process, in bytes")
      .def_readonly("scratch", &FileEstimate::scratch,
                    "the peak size of the scratch folder, in bytes")
      .def_readonly("output", &FileEstimate::output,
                    "the size of the output, in bytes; 0 if distances are limited")
      .def_readonly("seconds", &FileEstimate::seconds, "the duration with this process alone");
  py::class_<FileStatus>(m, "FileStatus", "The progress of simplify_file().")
      .def_property_readonly(
          "stage", [](const FileStatus& s) { return to_string(s.stage); },
          "'weld', 'survey', 'partition', 'sample', 'simplify', 'regroup' or 'merge'")
      .def_readonly("phase", &FileStatus::phase, "counted from 1; 0 while the file is cut")
      .def_readonly("phases", &FileStatus::phases, "the expected number of phases")
      .def_readonly("chunks", &FileStatus::chunks, "the number of chunks of the phase")
      .def_readonly("chunks_done", &FileStatus::chunks_done)
      .def_readonly("faces", &FileStatus::faces, "faces of the input")
      .def_readonly("progress", &FileStatus::progress,
                    "the approximate completed fraction, from 0 to 1")
      .def_readonly("estimate", &FileStatus::estimate)
      .def("__repr__", [](const FileStatus& s) {
        return "<quadrille.FileStatus: " + std::string(to_string(s.stage)) + ", phase " +
               std::to_string(s.phase) + " of " + std::to_string(s.phases) + ", " +
               std::to_string(s.chunks_done) + " of " + std::to_string(s.chunks) + " parts>";
      });
}

} // namespace

void add_file_jobs(py::module_& m) {
  add_status(m);
  py::class_<OutOfCore>(m, "OutOfCore")
      .def(py::init<>())
      .def_readwrite("scratch", &OutOfCore::scratch)
      .def_readwrite("memory", &OutOfCore::memory)
      .def_readwrite("chunks_in_flight", &OutOfCore::chunks_in_flight)
      .def_readwrite("restart", &OutOfCore::restart)
      .def_readwrite("chunk_faces", &OutOfCore::chunk_faces)
      .def_readwrite("attribute_importance", &OutOfCore::attribute_importance)
      .def_readwrite("keeps_tiles", &OutOfCore::keeps_tiles)
      .def_readwrite("locks_boundary", &OutOfCore::locks_boundary)
      .def_readwrite("welds", &OutOfCore::welds)
      .def_readwrite("tolerance", &OutOfCore::tolerance)
      .def_readwrite("positions_only", &OutOfCore::positions_only);
  using Unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<FileJob>(m, "FileJob")
      .def(py::init(&job_of))
      .def_property_readonly("estimate", &FileJob::estimate)
      .def("partition", &FileJob::partition, Unlocked())
      .def("join", &FileJob::join, Unlocked())
      .def("simplify", &FileJob::simplify, Unlocked())
      .def("close", &FileJob::close, Unlocked())
      .def("merge", &reported<&FileJob::merge>)
      .def("run", &reported<&FileJob::run>);
}

} // namespace quadrille_examples
