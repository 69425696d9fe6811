#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_PROGRESS_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_PROGRESS_H

#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/counters.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace quadrille::internal {

/// The progress of a simplification, for stop policies, the visitor and the report.
template <class Policies>
class Progress {
public:
  explicit Progress(const Policies& policies) : policies_(policies) {}

  /// Starts with a surface whose second half may not be changed and does not count for the target.
  /// `edges`: without these, see CountedEdges.
  void start(const Loss& all, const Loss& unselected, std::size_t edges, double diagonal) {
    unselected_ = unselected;
    status_.faces = status_.initial_faces = all.faces - unselected.faces;
    status_.vertices = status_.initial_vertices = all.vertices - unselected.vertices;
    status_.edges = status_.initial_edges = edges;
    status_.diagonal = diagonal;
  }
  /// How many contractions there will be, as a rule.
  void expect(std::size_t contractions) { expected_contractions_ = contractions; }

  /// Without what is not selected.
  const Status& status() const { return status_; }
  /// Is there anything that may not be changed?
  bool has_unselected() const { return unselected_.faces > 0; }
  /// How many vertices are left in all.
  std::size_t vertices() const { return status_.vertices + unselected_.vertices; }
  bool has_visitor() const { return static_cast<bool>(policies_.visitor); }
  /// Pairs are contracted from here on. False if the visitor cancels.
  bool begin_contracting() {
    stage_ = Stage::contract;
    return proceed();
  }
  /// Has anything been contracted, or vanished?
  bool has_begun() const { return status_.vertices < status_.initial_vertices; }

  /// Adds what contractions have changed, and forgets it.
  void count(Counters& counters) {
    status_.faces -= counters.faces;
    status_.vertices -= counters.vertices;
    status_.edges -= counters.edges;
    status_.contractions += counters.contractions;
    total_.non_edge_contractions += counters.non_edge_contractions;
    total_.doubled_faces += counters.doubled_faces;
    total_.doubled_labels += counters.doubled_labels;
    total_.vanished_components += counters.vanished_components;
    total_.error = (std::max)(total_.error, counters.error);
    total_.vanished_size = (std::max)(total_.vanished_size, counters.vanished_size);
    total_.moved += counters.moved;
    total_.loses_points |= counters.loses_points;
    for (std::size_t cause = 0; cause < rejection_causes; ++cause)
      total_.rejections[cause] += counters.rejections[cause];
    counters = {};
  }

  /// Announces the error of the next contraction, the distance to which it would lead, and its
  /// cost.
  void announce(double error) { status_.next_error = error; }
  void announce_distance(double distance) { status_.next_distance = distance; }
  void announce_cost(double cost) { status_.next_cost = cost; }
  /// Announces the distance from the input to the surface.
  void announce_reverse_distance(double distance) { status_.next_reverse_distance = distance; }
  /// Announces the fraction of its tolerance that a point will have used.
  void announce_tolerance(double fraction) { status_.next_tolerance = fraction; }
  /// Returns the total displacement of contractions up to now: see Displacement.
  std::uint64_t moved() const { return total_.moved; }
  /// How many were rejected for one cause.
  std::size_t rejected(Rejection cause) const {
    return total_.rejections[static_cast<std::size_t>(cause)];
  }
  /// Is each point of the input still known to have some place on the surface?
  bool has_all_points() const { return !total_.loses_points; }
  /// Does the stop policy stop?
  bool is_enough() const { return policies_.stop(status_); }

  /// Asks the visitor, which may cancel the simplification, and does until now.
  bool proceed() {
    return is_cancelled_ ? false : !(is_cancelled_ = !ask_visitor(fraction_done(), stage_));
  }
  /// Reports to the visitor that nothing more will follow.
  void report_end() const { ask_visitor(1, Stage::write); }
  bool is_cancelled() const { return is_cancelled_; }

  void write_to(Report& report) const {
    report.faces_after = status_.faces + unselected_.faces;
    report.vertices_after = vertices();
    report.contractions = status_.contractions;
    report.non_edge_contractions = total_.non_edge_contractions;
    report.counted_faces = status_.initial_faces + unselected_.faces;
    report.doubled_faces = total_.doubled_faces;
    report.doubled_labels = total_.doubled_labels;
    report.vanished_components = total_.vanished_components;
    report.largest_vanished_component = total_.vanished_size;
    report.rejections = total_.rejections;
    report.error = total_.error;
  }

private:
  bool ask_visitor(double progress, Stage stage) const {
    if (!has_visitor())
      return true;
    Status now = status_;
    now.progress = progress;
    now.stage = stage;
    return policies_.visitor(now);
  }

  // Less than all: something may always come.
  double fraction_done() const {
    const auto done = static_cast<double>(status_.contractions);
    const auto all = static_cast<double>(std::max<std::size_t>(expected_contractions_, 1));
    return (std::min)(done / all, most_fraction_done);
  }
  static constexpr double most_fraction_done = 0.999;

  const Policies& policies_;
  Status status_;
  Loss unselected_{0, 0};
  Counters total_;
  std::size_t expected_contractions_ = 0;
  Stage stage_ = Stage::prepare;
  bool is_cancelled_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_PROGRESS_H
