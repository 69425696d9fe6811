#ifndef QUADRILLE_INTERNAL_LEVELS_PLACE_TRACKER_H
#define QUADRILLE_INTERNAL_LEVELS_PLACE_TRACKER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/nearest_point.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/level_steps.h>
#include <quadrille/levels.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Carries places on the surface of a level to that of another one: see carried_places(). Lengths
/// are in the engine's unit, so that squares neither over- nor underflow.
class PlaceTracker {
public:
  template <class Places>
  PlaceTracker(const Levels& levels, const LevelInfo& from, const Places& places)
      : steps_(levels, from), scale_(Box<3>(levels.at(AfterContractions{0}).points), true),
        first_(levels.finest().faces, none), next_(places.size(), none), places_(places.size()) {
    const std::vector<Index> numbers = face_numbers();
    for (Index i = 0; i < places.size(); ++i) {
      if (places[i].face == not_recorded)
        continue;
      if (places[i].face >= numbers.size() || numbers[places[i].face] == none)
        throw std::invalid_argument("quadrille::carried_places: the place " + std::to_string(i) +
                                    " is on the face " + std::to_string(places[i].face) +
                                    ", which is not in the level");
      const Face face = face_at(numbers[places[i].face]);
      places_[i].position = combination(face.corners, places[i].weights);
      put(i, face, places[i].weights);
    }
  }

  /// Carries the places to a level.
  void carry_to(const LevelInfo& to) {
    set_detour((std::max)(steps_.info(), to, is_finer));
    while (steps_.info().contractions < to.contractions && steps_.coarsen()) {
      set_detour(steps_.info());
      follow();
    }
    for (LevelInfo coarser = steps_.info(); coarser.contractions > to.contractions;
         coarser = steps_.info()) {
      set_detour(coarser);
      steps_.refine();
      follow();
    }
    for (Place& place : places_)
      if (place.face != none)
        approach(place);
  }
  /// Returns the places, on faces of the input.
  template <class Place>
  std::vector<Place> places() const {
    std::vector<Place> places(places_.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places_[i].face != none)
        places[i] = {steps_.input_faces()[places_[i].face], places_[i].weights};
    return places;
  }

private:
  struct Face {
    Index number;
    TriangleCorners corners;
    Vector<3> normal;
    Box<3> box;
  };
  struct Place {
    Vector<3> position; // where it was at first
    Vector<3> normal;   // that of its face
    Index face = none;
    std::array<double, 3> weights = {};
  };
  // The nearest point of several faces.
  struct Choice {
    const Face* face = nullptr;
    NearestPoint point;

    void take_nearer(const Face& other, const Vector<3>& position) {
      if (squared_distance_to_box(position, other.box) >= point.squared_distance)
        return; // saves a quarter of the time of both maps
      const NearestPoint nearest = nearest_of_triangle(position, other.corners);
      if (nearest.squared_distance < point.squared_distance) {
        face = &other;
        point = nearest;
      }
    }
  };

  static bool is_finer(const LevelInfo& a, const LevelInfo& b) {
    return a.contractions < b.contractions;
  }

  // Sets how much further a face on the side of a place may be than one that is turned, for a step
  // to or from a level: twice the error, and never beyond the bound of the level. Where faces are
  // not wound alike, those that are not turned may be far away.
  void set_detour(const LevelInfo& coarser) {
    detour_ = scale_.length_from_mesh(2 * coarser.error);
    bound_ = scale_.length_from_mesh(coarser.hausdorff_bound);
  }

  // Returns for each face of the input its number in the level.
  std::vector<Index> face_numbers() const {
    std::vector<Index> numbers;
    for (Index face = 0; face < steps_.input_faces().size(); ++face) {
      const std::size_t input = steps_.input_faces()[face];
      if (input >= numbers.size())
        numbers.resize(input + 1, none);
      numbers[input] = face;
    }
    return numbers;
  }

  Face face_at(Index number) const {
    Face face{number, {}, {}, Box<3>::none()};
    for (std::size_t i = 0; i < 3; ++i) {
      face.corners[i] = scale_.position_from_mesh({steps_.points()[steps_.triangles()[number][i]]});
      face.box.add(face.corners[i]);
    }
    face.normal = double_area_vector(face.corners[0], face.corners[1], face.corners[2]);
    return face;
  }

  void put(Index i, const Face& face, const std::array<double, 3>& weights) {
    places_[i].face = face.number;
    places_[i].normal = face.normal;
    places_[i].weights = weights;
    next_[i] = std::exchange(first_[face.number], i);
  }

  // Takes the places on a face off it.
  void take(Index face) {
    for (Index i = std::exchange(first_[face], none); i != none; i = next_[i]) {
      moving_.push_back(i);
      places_[i].face = none;
    }
  }

  // Moves the places on the faces that the last step has changed to the faces that are there now.
  void follow() {
    const LevelStep& step = steps_.last_step();
    moving_.clear();
    for (const Index face : step.changed)
      take(face);
    if (moving_.empty())
      return;
    faces_.clear();
    for (const Index face : step.changed)
      if (face < steps_.triangles().size())
        faces_.push_back(face_at(face));
    if (faces_.empty())
      add_neighbours();
    for (const Index i : moving_) {
      const Choice choice = nearest_face(places_[i]);
      if (choice.face)
        put(i, *choice.face, choice.point.weights);
    }
  }

  // Adds the faces next to those that the step has removed.
  void add_neighbours() {
    neighbours_.clear();
    for (const auto& triangle : steps_.removed_triangles())
      for (const Index v : triangle)
        if (v < steps_.points().size())
          steps_.for_each_triangle(v, [&](Index f) { neighbours_.push_back(f); });
    std::sort(neighbours_.begin(), neighbours_.end());
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    for (const Index face : neighbours_)
      faces_.push_back(face_at(face));
  }

  // Chooses the nearest face, or one on the same side that is hardly further: turned by less than
  // 90 degrees.
  Choice nearest_face(const Place& place) const {
    Choice same_side, turned;
    for (const Face& face : faces_)
      if (dot(face.normal, place.normal) >= 0)
        same_side.take_nearer(face, place.position);
    turned.point.squared_distance = same_side.point.squared_distance;
    for (const Face& face : faces_)
      if (dot(face.normal, place.normal) < 0)
        turned.take_nearer(face, place.position);
    if (!turned.face)
      return same_side;
    const double allowed =
        (std::min)(std::sqrt(turned.point.squared_distance) + detour_ + rounding, bound_);
    return same_side.point.squared_distance <= allowed * allowed ? same_side : turned;
  }

  // Moves a place over edges and corners as long as it comes nearer to its first position.
  void approach(Place& place) {
    for (;;) {
      const auto& w = place.weights;
      if (w[0] > 0 && w[1] > 0 && w[2] > 0)
        return;
      const std::size_t corner = w[0] > 0 ? 0 : w[1] > 0 ? 1 : 2;
      faces_.clear();
      steps_.for_each_triangle(steps_.triangles()[place.face][corner],
                               [&](Index face) { faces_.push_back(face_at(face)); });
      const Choice choice = nearest_face(place);
      const double distance =
          squared_distance(place.position, combination(face_at(place.face).corners, place.weights));
      if (!(choice.point.squared_distance < distance))
        return;
      place.face = choice.face->number;
      place.normal = choice.face->normal;
      place.weights = choice.point.weights;
    }
  }

  static constexpr double rounding = 0x1p-20; // the extent of the surface is about 2^20

  LevelSteps steps_;
  Scale<3> scale_;
  double detour_ = 0, bound_ = 0;
  std::vector<Index> first_; // for each face, the first place on it
  std::vector<Index> next_;  // for each place, the next one on its face
  std::vector<Place> places_;
  std::vector<Index> moving_, neighbours_;
  std::vector<Face> faces_; // to which places may move
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_PLACE_TRACKER_H
