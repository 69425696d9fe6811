#ifndef QUADRILLE_INTERNAL_FILE_INPUT_SURVEY_H
#define QUADRILLE_INTERNAL_FILE_INPUT_SURVEY_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/label_table.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// Reads a file once, from its first face to its last vertex, before anything is written. It finds
/// what the file contains, what of it is used, and whether all of it can be simplified in chunks.
/// Vertices that no face uses do not count for boxes and ranges, and need not be finite. Memory: a
/// bit for each vertex.
class InputSurvey {
public:
  /// `notify(fraction)` is as in FirstChunks. Throws std::runtime_error with the name of the file.
  /// `tolerance` is the index of that scalar in a row, if there is one.
  template <class Notify>
  InputSurvey(const PlyInput& input, std::optional<std::size_t> tolerance, Notify notify)
      : input_(input), tolerance_(tolerance), used_(input.vertices()), labels_(input.labels()) {
    facts_.vertices = input.vertices();
    facts_.faces = input.faces();
    facts_.has_doubles = input.has_doubles();
    facts_.made = input.header().made;
    const auto from = [&](double begin, double end, std::uint64_t count) {
      return [=, &notify](std::uint64_t i) {
        if (i % (1 << 18) == 0)
          notify(begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count));
      };
    };
    survey_faces(from(0, 0.7, facts_.faces));
    require_labels();
    survey_vertices(from(0.7, 1, facts_.vertices));
  }

  const InputFacts& facts() const { return facts_; }
  bool is_used(VertexId v) const { return used_.has(v); }
  const LabelTable& labels() const { return labels_; } ///< all labels of the file
  std::uint64_t checksum_of_faces() const { return of_faces_; }
  std::uint64_t checksum_of_vertices() const { return of_vertices_; }

private:
  static constexpr std::size_t most_colors = 64; // more colours make a picture, whose faces are not
                                                 // regions

  template <class Notify>
  void survey_faces(Notify notify) {
    of_faces_ = input_.for_faces([&](std::uint64_t face, const FaceRow& corners,
                                     const LabelValues& values) {
      notify(face);
      is_loose_ =
          is_loose_ && !used_.has(corners[0]) && !used_.has(corners[1]) && !used_.has(corners[2]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        return;
      ++facts_.counted_faces;
      for (const VertexId v : corners)
        used_.add(v);
      if (!values.empty())
        take_labels(values);
    });
    if (facts_.counted_faces == 0)
      fail("nothing to simplify: it has no face with three different vertices");
    if (is_loose_ && facts_.faces > 1 && !input_.is_welded())
      fail("no two of its faces share a vertex, so there is nothing to simplify: 'weld' merges "
           "vertices at exactly the same place");
  }

  void take_labels(const LabelValues& values) {
    LabelValues colors;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (PlyInput::is_color(input_.labels()[i].name))
        colors.push_back(values[i]);
    if (!colors.empty() && colors != last_color_ && colors_.size() <= most_colors)
      colors_.insert(colors);
    last_color_ = colors;
    try {
      if (colors_.size() <= most_colors)
        labels_.number(values);
    } catch (const std::length_error& error) {
      fail(error.what());
    }
  }

  void require_labels() const {
    const std::string leave_out = "; 'positions only' leaves them out";
    if (colors_.size() > std::min<std::uint64_t>(most_colors, facts_.faces / 2))
      fail("its faces have more than " + std::to_string(colors_.size() - 1) +
           " colours, which look like an image and not like labels, and cannot be kept out of "
           "core" +
           leave_out);
    if (labels_.size() > facts_.faces / 2)
      fail("its faces have " + std::to_string(labels_.size()) +
           " different labels, like numbers of faces, which cannot be kept out of core");
  }

  template <class Notify>
  void survey_vertices(Notify notify) {
    of_vertices_ = input_.for_vertices(
        [&](VertexId id, const Vector<3>& p, const std::vector<double>& scalars) {
          notify(id);
          const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
          if (used_.has(id))
            take_vertex(id, p, is_finite, scalars);
          else
            facts_.unused_not_finite += is_finite ? 0 : 1;
        });
  }

  void take_vertex(VertexId id, const Vector<3>& p, bool is_finite,
                   const std::vector<double>& scalars) {
    if (!is_finite)
      fail("vertex " + std::to_string(id) + " is not finite");
    ++facts_.used_vertices;
    facts_.box.add(p);
    if (tolerance_ && !(scalars[*tolerance_] >= 0))
      fail("the tolerance " + text_of(scalars[*tolerance_]) + " of vertex " + std::to_string(id) +
           " is not a distance");
    for (std::size_t i = 0; i < scalars.size(); ++i)
      if (!(std::abs(scalars[i]) < 0x1p170))
        fail("property " + input_.scalars().properties()[i].name + " of vertex " +
             std::to_string(id) + " is not finite, or too large; 'positions only' leaves it out");
    facts_.ranges.add(scalars);
  }

  [[noreturn]] void fail(const std::string& what) const { fail_file(input_.file().path(), what); }

  const PlyInput& input_;
  std::optional<std::size_t> tolerance_;
  InputFacts facts_;
  IdSet used_;
  LabelTable labels_;
  std::set<LabelValues> colors_; // at most one more than the limit
  LabelValues last_color_;
  bool is_loose_ = true;
  std::uint64_t of_faces_ = 0, of_vertices_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_INPUT_SURVEY_H
