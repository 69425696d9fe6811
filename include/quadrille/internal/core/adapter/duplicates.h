#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_DUPLICATES_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_DUPLICATES_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <concepts>
#include <cstddef>
#include <map>
#include <vector>

namespace quadrille::internal {

/// Can a mesh copy all properties of a vertex? So can those of OpenMesh.
template <class Mesh, class Vertex>
concept CopiesProperties = requires(Mesh& mesh, Vertex v) {
  mesh.copy_all_properties(v, v, true);
};

/// Or those of all vertices of another mesh? So can Surface_mesh.
template <class Mesh, class Vertex>
concept JoinsProperties = std::copy_constructible<Mesh> && requires(Mesh& mesh, Vertex v) {
  mesh.join(mesh);
  mesh.collect_garbage();
  mesh.is_removed(v);
  mesh.template properties<Vertex>();
  mesh.template add_property_map<Vertex, std::size_t>("");
};

/// Adds vertices to a Surface_mesh with all properties of their originals. These have types that
/// only the mesh knows, and it hands them over from one mesh to another: so it is joined with a
/// copy of itself of which nothing but the originals is left.
template <class Mesh>
class JoinedDuplicates {
public:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Number = typename Mesh::size_type;

  /// Are there any but those that each mesh has?
  static bool has_properties(const Mesh& mesh) {
    return mesh.template properties<Vertex>().size() > Mesh().template properties<Vertex>().size();
  }

  explicit JoinedDuplicates(Mesh& mesh) : mesh_(mesh), donor_(mesh) {
    number_ = donor_.template add_property_map<Vertex, std::size_t>("quadrille:number").first;
  }

  /// Appends the duplicates, in the order of the originals. If it throws, there is none.
  void add(const std::vector<Vertex>& originals, std::vector<Vertex>& duplicates) {
    std::map<Vertex, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < originals.size(); ++i)
      places[originals[i]].push_back(i);
    duplicates.resize(originals.size());
    const Number begin = mesh_.num_vertices();
    mesh_.reserve(begin + static_cast<Number>(originals.size()), mesh_.num_edges(),
                  mesh_.num_faces());
    keep_vertices();
    try {
      for (std::size_t round = 0; leave([&](std::size_t number) {
             const auto found = places.find(Vertex(static_cast<Number>(number)));
             return found != places.end() && found->second.size() > round;
           });
           ++round) {
        const Number first = mesh_.num_vertices();
        mesh_.join(donor_);
        for (Vertex v : vertices(donor_))
          duplicates[places.at(Vertex(static_cast<Number>(number_[v])))[round]] =
              Vertex(first + static_cast<Number>(v));
      }
    } catch (...) {
      for (Number v = begin; v < mesh_.num_vertices(); ++v)
        mesh_.remove_vertex(Vertex(v));
      duplicates.clear();
      throw;
    }
  }

private:
  // And nothing else.
  void keep_vertices() {
    for (const auto f : faces(donor_))
      donor_.remove_face(f);
    for (const auto e : edges(donor_))
      donor_.remove_edge(e);
    for (Vertex v : vertices(donor_)) {
      donor_.set_halfedge(v, Mesh::null_halfedge());
      number_[v] = static_cast<Number>(v);
    }
  }

  // Lists the vertices that satisfy is_wanted(number). Returns false if there are none.
  template <class IsWanted>
  bool leave(IsWanted is_wanted) {
    for (Vertex v : vertices(donor_))
      if (!is_wanted(number_[v]))
        donor_.remove_vertex(v);
    donor_.collect_garbage();
    return donor_.number_of_vertices() > 0;
  }

  Mesh& mesh_;
  Mesh donor_;
  typename Mesh::template Property_map<Vertex, std::size_t> number_;
};

/// Adds a duplicate of each of the originals, with all of its properties where the mesh has a way
/// to copy them. `duplicates` has room for them; if it throws, these have been added.
template <class Mesh, class Vertex>
void add_duplicates(Mesh& mesh, const std::vector<Vertex>& originals,
                    std::vector<Vertex>& duplicates) {
  if constexpr (JoinsProperties<Mesh, Vertex>)
    if (!originals.empty() && JoinedDuplicates<Mesh>::has_properties(mesh)) {
      JoinedDuplicates<Mesh>(mesh).add(originals, duplicates);
      return;
    }
  for (Vertex original : originals) {
    duplicates.push_back(add_vertex(mesh));
    if constexpr (CopiesProperties<Mesh, Vertex>)
      mesh.copy_all_properties(original, duplicates.back(), true);
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_DUPLICATES_H
