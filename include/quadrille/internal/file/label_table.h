#ifndef QUADRILLE_INTERNAL_FILE_LABEL_TABLE_H
#define QUADRILLE_INTERNAL_FILE_LABEL_TABLE_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_header.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The values of a face in some integer properties, all of them together.
using LabelValues = std::vector<std::int64_t>;

/// Numbers the labels of faces in the order of their first occurrence.
class LabelTable {
public:
  static constexpr std::size_t most = 65'536;

  explicit LabelTable(std::vector<PlyProperty> properties) : properties_(std::move(properties)) {}

  const std::vector<PlyProperty>& properties() const { return properties_; }
  std::size_t size() const { return values_.size(); }
  const LabelValues& values(std::uint32_t label) const { return values_.at(label); }

  /// Throws std::length_error if there are too many: values that differ from face to face are not
  /// labels.
  std::uint32_t number(const LabelValues& values) {
    if (last_ < values_.size() && values_[last_] == values)
      return last_;
    const auto [found, is_new] =
        numbers_.try_emplace(values, static_cast<std::uint32_t>(values_.size()));
    if (is_new)
      values_.push_back(values);
    if (values_.size() > most)
      throw std::length_error("more than " + std::to_string(most) +
                              " different labels, like numbers of faces");
    last_ = found->second;
    return last_;
  }

  /// Writes the table to a file.
  FileContent write(const std::filesystem::path& path) const {
    std::ostringstream text;
    text << properties_.size() << '\n';
    for (const PlyProperty& p : properties_)
      text << p.name << ' ' << p.type.size << ' ' << p.type.is_signed << '\n';
    for (const LabelValues& values : values_)
      for (const std::int64_t value : values)
        text << value << ' ';
    const std::string content = text.str();
    std::filesystem::remove(path);
    AppendedFiles file({path}, 1 << 20);
    file.add(0, content.data(), content.size());
    return file.finish().front();
  }

  static LabelTable read(const std::filesystem::path& path, const FileContent& content) {
    const std::vector<char> bytes = read_rows<char>(path, content);
    std::istringstream text(std::string(bytes.begin(), bytes.end()));
    std::size_t count = 0;
    text >> count;
    std::vector<PlyProperty> properties(count);
    for (PlyProperty& p : properties)
      text >> p.name >> p.type.size >> p.type.is_signed;
    LabelTable table(std::move(properties));
    LabelValues values(count);
    for (std::size_t i = 0; text >> values[i % count];)
      if (++i % count == 0)
        table.number(values);
    return table;
  }

private:
  std::vector<PlyProperty> properties_;
  std::map<LabelValues, std::uint32_t> numbers_;
  std::vector<LabelValues> values_;
  std::uint32_t last_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_LABEL_TABLE_H
