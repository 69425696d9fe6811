#ifndef QUADRILLE_EXAMPLES_MESH_IO_LOSSES_H
#define QUADRILLE_EXAMPLES_MESH_IO_LOSSES_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace quadrille_examples {

/// The kinds of things that a file has and that are not kept, each named once.
class Losses {
public:
  void add(const std::string& what) {
    if (std::find(kinds_.begin(), kinds_.end(), what) != kinds_.end())
      return;
    if (kinds_.size() < most_kinds)
      kinds_.push_back(what);
    else
      has_more_ = true;
  }

  bool empty() const { return kinds_.empty(); }

  /// All of them, in one line.
  std::string text() const {
    std::string line;
    for (const std::string& kind : kinds_)
      line += (line.empty() ? "" : ", ") + kind;
    return line + (has_more_ ? " and more" : "");
  }

private:
  static constexpr std::size_t most_kinds = 30; // a file may have any number

  std::vector<std::string> kinds_;
  bool has_more_ = false;
};

} // namespace quadrille_examples

#endif
