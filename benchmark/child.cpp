// SPDX-License-Identifier: MIT

#include "child.h"

#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

/// A figure of /proc/self/status, in kilobytes.
double status_kilobytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":"))
      return std::stod(line.substr(key.size() + 1));
  return 0;
}

/// The memory taken at most since this object was made, in megabytes, without the parts of the
/// program itself that have come to be used: those are pages of a file. Linux only.
class PeakMemory {
public:
  PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // sets the peak back to what is held now
    before_ = status_kilobytes("VmRSS") - program();
  }

  double megabytes() const { return (status_kilobytes("VmHWM") - program() - before_) / 1024; }

private:
  static double program() { return status_kilobytes("RssFile"); }

  double before_;
};

/// Simplifies a small sphere, so that neither time nor memory is that of loading the program.
void warm_up(const Contender& contender) {
  Mesh sphere;
  CGAL::make_icosahedron<Mesh, Point>(sphere);
  CGAL::Subdivision_method_3::Loop_subdivision(
      sphere, CGAL::parameters::number_of_iterations(3)); // 1280 faces
  contender.simplify(sphere, 128);
}

/// From here on malloc() maps large blocks one by one, so that they are held as long as they are
/// used and no longer. Those that are free in the heap are taken away, and never given back: what
/// is free there, and was once used, would be counted too, and how much that is differs.
void map_large_blocks() {
  constexpr std::size_t large = 1 << 16;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TOP_PAD, 0);
  for (std::size_t size = large << 14; size >= large; size /= 2)
    for (bool is_mapped = false; !is_mapped;) {
      const std::size_t before = mallinfo2().hblkhd; // bytes that are mapped
      void* const block = std::malloc(size);
      is_mapped = !block || mallinfo2().hblkhd > before;
      if (is_mapped)
        std::free(block);
    }
}

Run run_here(const Work& work, Purpose purpose) {
  work.prepare();
  if (purpose == Purpose::memory)
    map_large_blocks();
  const PeakMemory memory;
  const auto start = Clock::now();
  const Stopwatch stopwatch;
  const std::optional<double> own_seconds = work.simplify();
  Run run;
  run.seconds = stopwatch.seconds();
  run.own_seconds = own_seconds.value_or(run.seconds);
  run.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  run.peak_megabytes = memory.megabytes();
  run.answer = work.answer();
  return run;
}

// --- A run as bytes in a pipe --------------------------------------------------------------------

void send(int pipe, const void* data, std::size_t size) {
  for (const char* next = static_cast<const char*>(data); size > 0;) {
    const ssize_t written = write(pipe, next, size);
    if (written <= 0)
      _exit(EXIT_FAILURE);
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

template <class T>
void send(int pipe, const std::vector<T>& records) {
  const std::size_t size = records.size();
  send(pipe, &size, sizeof size);
  send(pipe, records.data(), size * sizeof(T));
}

void send(int pipe, const Run& run) {
  const double figures[] = {run.seconds, run.own_seconds, run.wall_seconds, run.peak_megabytes};
  send(pipe, figures, sizeof figures);
  std::vector<double> coordinates;
  for (const Point& p : run.answer.points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  send(pipe, coordinates);
  send(pipe, run.answer.triangles);
  const Attributes& attributes = run.answer.attributes;
  send(pipe, &attributes.components, sizeof attributes.components);
  send(pipe, attributes.values);
  send(pipe, attributes.triangles);
}

/// Reads from a pipe until a moment in time; then, and at an early end, throws.
class Receiver {
public:
  Receiver(int pipe, double seconds)
      : pipe_(pipe), end_(Clock::now() + std::chrono::milliseconds(std::llround(seconds * 1e3))) {}

  void operator()(void* data, std::size_t size) {
    for (char* next = static_cast<char*>(data); size > 0;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - Clock::now()).count();
      pollfd ready{.fd = pipe_, .events = POLLIN, .revents = 0};
      if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) <= 0)
        throw std::runtime_error("the time is up");
      const ssize_t received = read(pipe_, next, size);
      if (received <= 0)
        throw std::runtime_error("the child ended early");
      next += received;
      size -= static_cast<std::size_t>(received);
    }
  }

  template <class T>
  void operator()(std::vector<T>& records) {
    std::size_t size = 0;
    (*this)(&size, sizeof size);
    records.resize(size);
    (*this)(records.data(), size * sizeof(T));
  }

private:
  int pipe_;
  Clock::time_point end_;
};

Run receive(Receiver receiver) {
  double figures[4];
  receiver(figures, sizeof figures);
  Run run{figures[0], figures[1], figures[2], figures[3], {}};
  std::vector<double> coordinates;
  receiver(coordinates);
  run.answer.points.reserve(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    run.answer.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  receiver(run.answer.triangles);
  Attributes& attributes = run.answer.attributes;
  receiver(&attributes.components, sizeof attributes.components);
  receiver(attributes.values);
  receiver(attributes.triangles);
  return run;
}

} // namespace

std::optional<Run> run_in_child(const Work& work, double limit, Purpose purpose) {
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no child process");
  if (child == 0) {
    try {
      send(ends[1], run_here(work, purpose));
      _exit(EXIT_SUCCESS);
    } catch (...) {
      _exit(EXIT_FAILURE);
    }
  }
  close(ends[1]);
  std::optional<Run> run;
  try {
    run = receive(Receiver(ends[0], limit));
  } catch (const std::runtime_error&) {
    kill(child, SIGKILL);
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return run;
}

std::optional<Run> run_in_child(const Contender& contender, const Mesh& mesh, std::size_t faces,
                                double limit, Purpose purpose) {
  Mesh copy;
  Answer answer;
  return run_in_child(
      {.prepare =
           [&] {
             copy = mesh;
             warm_up(contender);
           },
       .simplify =
           [&] {
             answer = contender.simplify(copy, faces);
             return answer.own_seconds;
           },
       .answer = [&] { return answer.soup ? std::move(*answer.soup) : to_soup(copy); }},
      limit, purpose);
}

} // namespace bench
