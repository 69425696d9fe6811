#ifndef QUADRILLE_INTERNAL_CORE_STATE_COMPONENT_EVENT_H
#define QUADRILLE_INTERNAL_CORE_STATE_COMPONENT_EVENT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <span>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// The event that observers with a function vanished(event) receive before a component of the
/// surface is removed: all vertices that are left of it, and all their faces.
struct ComponentEvent {
  std::span<const Index> vertices, faces;
  double radius, size; // of the component as it was in the input, in the mesh's unit: see Component
};

template <class Observer>
void notify_vanished(Observer& observer, const ComponentEvent& event) {
  if constexpr (requires { observer.vanished(event); })
    observer.vanished(event);
}

/// Returns all faces of the vertices of a component, each once.
inline std::vector<Index> faces_of(const TriangleComplex& complex,
                                   std::span<const Index> vertices) {
  std::vector<Index> faces;
  for (Index v : vertices)
    complex.for_each_corner(v, [&](Index face, Index i) {
      if (i == 0)
        faces.push_back(face);
    });
  return faces;
}

/// Removes a whole component, of which these vertices are left, notifies observers before, and
/// counts it.
template <class Component, class... Observer, class Counters>
void remove_component(TriangleComplex& complex, std::span<const Index> vertices,
                      const Component& component, const std::tuple<Observer&...>& observers,
                      Counters& counters) {
  const std::vector<Index> faces = faces_of(complex, vertices);
  const ComponentEvent event{vertices, faces, component.radius, component.size};
  std::apply([&](auto&... observer) { (notify_vanished(observer, event), ...); }, observers);
  std::size_t count = 0; // with reverse faces
  for (Index face : faces) {
    count += complex.reverse_faces().count(face);
    complex.remove_face(face);
  }
  for (Index v : vertices)
    complex.prune_corners(v);
  counters.count_component(event, count);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_COMPONENT_EVENT_H
