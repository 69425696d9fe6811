#ifndef QUADRILLE_EXAMPLES_MESH_IO_REPLACE_FILE_H
#define QUADRILLE_EXAMPLES_MESH_IO_REPLACE_FILE_H

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace quadrille_examples {

inline void write_content(const std::filesystem::path& path, const std::string& content) {
  std::ofstream stream(path, std::ios::binary);
  if (!stream)
    throw std::runtime_error("cannot be opened for writing");
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot be written in full");
}

/// Gives the file at `path` a new content: all of it or, throwing, nothing. It is written beside
/// the file first, and then takes its place. A pipe or a device, which has no content to lose, is
/// written to.
inline void replace_file(const std::filesystem::path& path, const std::string& content) {
  namespace fs = std::filesystem;
  if (fs::exists(path) && !fs::is_regular_file(path))
    return write_content(path, content);
  const fs::path target = fs::exists(path) ? fs::canonical(path) : path; // where a link leads
  fs::path beside = target;
  beside += ".part" + std::to_string(std::random_device{}());
  std::error_code ignored;
  try {
    write_content(beside, content);
    fs::rename(beside, target);
  } catch (...) {
    fs::remove(beside, ignored);
    throw;
  }
}

} // namespace quadrille_examples

#endif
