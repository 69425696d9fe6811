#ifndef QUADRILLE_INTERNAL_LEVELS_LEVEL_BUILDER_H
#define QUADRILLE_INTERNAL_LEVELS_LEVEL_BUILDER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/recording/record_list.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/levels/level_track.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

using LevelCorners = std::array<Index, 3>;

/// The recorded state of items before the first contraction, by input numbers.
struct RecordedItems {
  std::size_t width = 0;
  std::vector<LevelCorners> corners; ///< for each face; none for faces that are not in the surface
  std::vector<double> values;
};

/// The removal times of items and the items that they become, for a track over a whole recording.
struct ItemLives {
  std::vector<Index> inputs;      ///< for each item by its number, the recorded item
  std::vector<Index> parents;     ///< for each item by its number, the item that it becomes, or
                                  ///< none
  std::vector<Index> items_after; ///< for each contraction
  std::vector<Index> numbers;     ///< for each recorded item; or none
};

/// Follows items through all contractions. merges(i, merge) calls merge(kept, gone) for those of
/// the contraction i.
template <class Merges>
class LifeFinder {
public:
  LifeFinder(const RecordedItems& items, const RecordList& records, Merges merges)
      : items_(items), records_(records), merges_(merges),
        merged_into_(items.values.size() / items.width, none), corners_(merged_into_.size(), 0) {}

  ItemLives find() {
    count_corners();
    ItemLives lives;
    const auto left = [](Index corners) { return corners > 0; };
    auto count = static_cast<Index>(std::count_if(corners_.begin(), corners_.end(), left));
    const std::size_t all = count;
    std::vector<Index> deaths;
    deaths.reserve(all);
    lives.items_after.reserve(records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const std::size_t before = deaths.size();
      merges_(i, [&](Index kept, Index gone) {
        merged_into_[gone] = kept;
        corners_[kept] += corners_[gone];
        deaths.push_back(gone);
      });
      for (Index face : records_.removed_faces(i))
        remove_corners(face, deaths);
      lives.items_after.push_back(count -= static_cast<Index>(deaths.size() - before));
    }
    number(all, deaths, lives);
    return lives;
  }

private:
  void count_corners() {
    for (const LevelCorners& corners : items_.corners)
      for (Index item : corners)
        if (item != none)
          ++corners_[item];
  }

  void remove_corners(Index face, std::vector<Index>& deaths) {
    for (Index corner : items_.corners[face]) {
      const Index item = follow_merges(merged_into_, corner);
      if (--corners_[item] == 0)
        deaths.push_back(item);
    }
  }

  void number(std::size_t all, const std::vector<Index>& deaths, ItemLives& lives) {
    lives.numbers.assign(merged_into_.size(), none);
    for (std::size_t i = 0; i < deaths.size(); ++i)
      lives.numbers[deaths[i]] = static_cast<Index>(all - 1 - i);
    Index number = 0;
    for (Index item = 0; item < lives.numbers.size(); ++item)
      if (lives.numbers[item] == none && merged_into_[item] == none && corners_[item] > 0)
        lives.numbers[item] = number++;
    lives.inputs.assign(all, none);
    for (Index item = 0; item < lives.numbers.size(); ++item)
      if (lives.numbers[item] != none)
        lives.inputs[lives.numbers[item]] = item;
    lives.parents.assign(all, none);
    for (std::size_t i = 0; i < records_.size(); ++i)
      merges_(i, [&](Index kept, Index gone) {
        lives.parents[lives.numbers[gone]] = lives.numbers[kept];
      });
  }

  const RecordedItems& items_;
  const RecordList& records_;
  Merges merges_;
  std::vector<Index> merged_into_;
  std::vector<Index> corners_; // the number of corners of each item
};

/// Makes the segments of a recording, each from the one before; the number of faces halves in each.
class LevelBuilder {
public:
  /// `items` are the vertices, followed by the wedges of each channel with seams.
  LevelBuilder(std::vector<RecordedItems> items, const RecordList& records)
      : items_(std::move(items)), records_(records) {}

  void build() {
    number_faces();
    std::vector<ItemLives> lives;
    for (std::size_t track = 0; track < items_.size(); ++track)
      lives.push_back(find_lives(track));
    LevelSegment segment = first_segment(lives);
    std::size_t begin = 0;
    for (;;) {
      const std::size_t end = end_of_segment(segment.faces(), begin);
      fill(segment, lives, begin, end);
      segments_.push_back(std::move(segment));
      if (end == records_.size())
        break;
      segment = next_segment(segments_.back());
      begin = end;
    }
    vertices_ = std::move(lives.front().inputs);
  }

  std::vector<LevelSegment> take_segments() { return std::move(segments_); }
  /// Returns the input indices of faces and vertices, by number.
  std::vector<Index> take_faces() { return std::move(faces_); }
  std::vector<Index> take_vertices() { return std::move(vertices_); }

private:
  void number_faces() {
    const std::vector<LevelCorners>& triangles = items_.front().corners;
    std::vector<Index> deaths;
    deaths.reserve(triangles.size());
    faces_.reserve(triangles.size());
    std::vector<bool> dies(triangles.size(), false);
    for (std::size_t i = 0; i < records_.size(); ++i)
      for (Index face : records_.removed_faces(i)) {
        deaths.push_back(face);
        dies[face] = true;
      }
    for (Index face = 0; face < triangles.size(); ++face)
      if (!dies[face] && triangles[face][0] != none)
        faces_.push_back(face);
    faces_.insert(faces_.end(), deaths.rbegin(), deaths.rend());
    faces_after_.reserve(records_.size());
    auto left = static_cast<Index>(faces_.size());
    for (std::size_t i = 0; i < records_.size(); ++i)
      faces_after_.push_back(left -= static_cast<Index>(records_.removed_faces(i).size()));
  }

  ItemLives find_lives(std::size_t track) const {
    if (track == 0)
      return LifeFinder(items_[0], records_,
                        [this](std::size_t i, auto merge) {
                          if (records_.gone(i) != none)
                            merge(records_.kept(i), records_.gone(i));
                        })
          .find();
    return LifeFinder(items_[track], records_,
                      [this, track](std::size_t i, auto merge) {
                        for_each_wedge(i, track, [&](const RecordedWedge& wedge) {
                          for (Index joined : wedge.joined)
                            merge(wedge.wedge, joined);
                        });
                      })
        .find();
  }

  template <class Visit>
  void for_each_wedge(std::size_t i, std::size_t track, Visit visit) const {
    records_.for_each_wedge(i, [&](const RecordedWedge& wedge) {
      if (wedge.channel + 1 == track)
        visit(wedge);
    });
  }

  LevelSegment first_segment(const std::vector<ItemLives>& lives) {
    LevelSegment segment;
    for (std::size_t t = 0; t < items_.size(); ++t) {
      LevelTrack& track = segment.tracks.emplace_back();
      track.width = items_[t].width;
      track.corners.reserve(faces_.size());
      for (Index face : faces_) {
        LevelCorners corners = items_[t].corners[face];
        for (Index& item : corners)
          item = lives[t].numbers[item];
        track.corners.push_back(corners);
      }
      track.values.reserve(lives[t].inputs.size() * track.width);
      for (Index item : lives[t].inputs)
        track.values.insert(
            track.values.end(),
            items_[t].values.begin() + static_cast<std::ptrdiff_t>(item * track.width),
            items_[t].values.begin() + static_cast<std::ptrdiff_t>((item + 1) * track.width));
    }
    items_.clear();
    return segment;
  }

  // Returns the end of the segment, after the contraction that halves the faces.
  std::size_t end_of_segment(std::size_t faces, std::size_t begin) const {
    const auto is_more = [](Index left, std::size_t half) { return left > half; };
    const auto first = faces_after_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto half = std::lower_bound(first, faces_after_.end(), faces / 2, is_more);
    return half == faces_after_.end() ? records_.size()
                                      : static_cast<std::size_t>(half - faces_after_.begin()) + 1;
  }

  // Fills a segment with the contractions from begin to end.
  void fill(LevelSegment& segment, const std::vector<ItemLives>& lives, std::size_t begin,
            std::size_t end) const {
    const auto of_records = [&](const auto& array) {
      return std::vector(array.begin() + static_cast<std::ptrdiff_t>(begin),
                         array.begin() + static_cast<std::ptrdiff_t>(end));
    };
    segment.faces_after = of_records(faces_after_);
    segment.are_bounds_both_ways = records_.knows_both_ways();
    float error = segment.error_before, bound = segment.bound_before;
    for (std::size_t i = begin; i < end; ++i) {
      segment.errors.push_back(error = (std::max)(error, records_.error(i)));
      if (records_.knows_distances())
        segment.bounds.push_back(bound = (std::max)(bound, records_.distance_bound(i)));
    }
    for (std::size_t t = 0; t < lives.size(); ++t) {
      LevelTrack& track = segment.tracks[t];
      track.items_after = of_records(lives[t].items_after);
      const std::size_t left = track.items_at(track.items_after.size());
      track.parents.assign(lives[t].parents.begin() + static_cast<std::ptrdiff_t>(left),
                           lives[t].parents.begin() + static_cast<std::ptrdiff_t>(track.items()));
      track.change_ends.reserve(end - begin);
      track.changed.reserve(end - begin);
      track.changed_values.reserve((end - begin) * track.width);
      for (std::size_t i = begin; i < end; ++i)
        add_changes(t, i, lives[t].numbers, track);
    }
  }

  void add_changes(std::size_t t, std::size_t i, const std::vector<Index>& numbers,
                   LevelTrack& track) const {
    const auto add = [&](Index item, std::span<const double> values) {
      track.changed.push_back(numbers[item]);
      track.changed_values.insert(track.changed_values.end(), values.begin(), values.end());
    };
    if (t == 0 && records_.kept(i) != none)
      add(records_.kept(i), records_.values(i));
    if (t > 0)
      for_each_wedge(i, t, [&](const RecordedWedge& wedge) {
        if (!wedge.values.empty())
          add(wedge.wedge, wedge.values);
      });
    track.change_ends.push_back(static_cast<Index>(track.changed.size()));
  }

  static LevelSegment next_segment(const LevelSegment& last) {
    const std::size_t contractions = last.contractions();
    LevelSegment segment;
    segment.error_before = last.errors.back();
    segment.bound_before = last.bounds.empty() ? 0 : last.bounds.back();
    for (const LevelTrack& before : last.tracks) {
      LevelTrack& track = segment.tracks.emplace_back();
      track.width = before.width;
      track.corners = before.corners_at(contractions, last.faces_at(contractions));
      track.values = before.values_at(contractions);
    }
    return segment;
  }

  std::vector<RecordedItems> items_;
  const RecordList& records_;
  std::vector<Index> faces_, vertices_; // input indices, by number
  std::vector<Index> faces_after_;      // for each contraction
  std::vector<LevelSegment> segments_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_LEVEL_BUILDER_H
