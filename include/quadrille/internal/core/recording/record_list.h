#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_LIST_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_LIST_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/recorded.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The least float that is not below a number.
inline float float_above(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) >= x
             ? nearest
             : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

/// A list of lists, one after the other.
template <class T>
class Rows {
public:
  std::size_t size() const { return ends_.size(); }
  std::span<const T> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span<const T>(values_).subspan(begin, ends_[i] - begin);
  }
  void add(std::span<const T> row) {
    values_.insert(values_.end(), row.begin(), row.end());
    ends_.push_back(static_cast<Index>(values_.size()));
  }

private:
  std::vector<T> values_;
  std::vector<Index> ends_;
};

/// Contractions one after the other: about 48 bytes for each, without channels. Errors and bounds
/// are rounded up to floats.
class RecordList {
public:
  RecordList() = default;
  /// `width`: how many numbers a vertex has.
  RecordList(std::size_t width, bool knows_distances, bool knows_both_ways)
      : width_(width), knows_distances_(knows_distances), knows_both_ways_(knows_both_ways) {}

  std::size_t size() const { return headers_.size(); }
  bool knows_distances() const { return knows_distances_; }
  bool knows_both_ways() const { return knows_both_ways_; }

  /// Reserves room, so that nothing is copied. Unused room takes no memory.
  void reserve(std::size_t contractions, std::size_t faces) {
    headers_.reserve(contractions);
    values_.reserve(contractions * width_);
    if (knows_distances_)
      bounds_.reserve(contractions);
    removed_faces_.reserve(faces);
  }

  void add(const RecordedContraction& contraction) {
    removed_faces_.insert(removed_faces_.end(), contraction.removed_faces.begin(),
                          contraction.removed_faces.end());
    headers_.push_back({contraction.kept, contraction.gone, float_above(contraction.error),
                        static_cast<Index>(removed_faces_.size())});
    values_.insert(values_.end(), contraction.values.begin(), contraction.values.end());
    values_.resize(size() * width_); // if there are none
    if (knows_distances_)
      bounds_.push_back(float_above(contraction.distance_bound));
    if (!contraction.wedges.empty())
      add_wedges(contraction.wedges);
  }

  Index kept(std::size_t i) const { return headers_[i].kept; }
  Index gone(std::size_t i) const { return headers_[i].gone; }
  std::span<const double> values(std::size_t i) const {
    return std::span(values_).subspan(i * width_, width_);
  }
  float error(std::size_t i) const { return headers_[i].error; }
  float distance_bound(std::size_t i) const { return knows_distances_ ? bounds_[i] : 0; }
  std::span<const Index> removed_faces(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : headers_[i - 1].removed_end;
    return std::span(removed_faces_).subspan(begin, headers_[i].removed_end - begin);
  }

  /// Calls visit(wedge) for each of a contraction.
  template <class Visit>
  void for_each_wedge(std::size_t i, Visit visit) const {
    if (i >= wedge_ends_.size())
      return;
    for (std::size_t w = i == 0 ? 0 : wedge_ends_[i - 1]; w < wedge_ends_[i]; ++w)
      visit(RecordedWedge{channels_[w], wedges_[w], joined_[w], wedge_values_[w]});
  }

  /// One of them; `wedges` is memory for what it refers to.
  RecordedContraction contraction(std::size_t i, std::vector<RecordedWedge>& wedges) const {
    wedges.clear();
    for_each_wedge(i, [&](const RecordedWedge& wedge) { wedges.push_back(wedge); });
    return {kept(i),
            gone(i),
            values(i),
            static_cast<double>(error(i)),
            static_cast<double>(distance_bound(i)),
            removed_faces(i),
            wedges};
  }

private:
  struct Header {
    Index kept, gone;
    float error;
    Index removed_end; // in removed_faces_
  };

  void add_wedges(std::span<const RecordedWedge> wedges) {
    wedge_ends_.resize(size() - 1, static_cast<Index>(wedges_.size())); // none until now
    for (const RecordedWedge& wedge : wedges) {
      channels_.push_back(static_cast<Index>(wedge.channel));
      wedges_.push_back(wedge.wedge);
      joined_.add(wedge.joined);
      wedge_values_.add(wedge.values);
    }
    wedge_ends_.push_back(static_cast<Index>(wedges_.size()));
  }

  std::size_t width_ = 3;
  bool knows_distances_ = false, knows_both_ways_ = false;
  std::vector<Header> headers_;
  std::vector<double> values_;
  std::vector<float> bounds_;
  std::vector<Index> removed_faces_;
  std::vector<Index> wedge_ends_, channels_,
      wedges_; // ends: of contractions up to the last with any
  Rows<Index> joined_;
  Rows<double> wedge_values_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_LIST_H
