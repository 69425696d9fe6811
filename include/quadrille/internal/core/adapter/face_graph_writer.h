#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_WRITER_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_WRITER_H

#include <quadrille/internal/core/adapter/attributes.h>
#include <quadrille/internal/core/adapter/duplicates.h>
#include <quadrille/internal/core/adapter/face_linker.h>
#include <quadrille/internal/core/adapter/named_edges.h>
#include <quadrille/internal/core/adapter/umbrellas.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/quadric_form.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Rewrites a FaceGraph from the result of a simplification, in linear time; see FaceGraphAdapter.
template <class Mesh, class PointMap, class Vertices, class Attributes, class Channels>
class FaceGraphWriter {
public:
  static constexpr std::size_t dimension = 3 + Attributes::size;
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<PointMap>::value_type;

  /// `vertices` are those of the mesh, in the order in which they were read.
  FaceGraphWriter(Mesh& mesh, PointMap points, Vertices& vertices, Attributes& attributes,
                  Channels& channels, NamedEdges<Edge>& named_edges, Arena* arena)
      : arena_(arena), mesh_(mesh), points_(points), vertices_(vertices), attributes_(attributes),
        channels_(channels), named_edges_(named_edges) {}

  /// See FaceGraphAdapter::write.
  template <class Result, class AnyReporter>
  std::size_t write(const Result& result, AnyReporter reporter) {
    number_vertices(result);
    collect_faces(result);
    umbrellas_.build(sides_, left_.size(), [this](Index i, Index j) {
      return opposite(halfedges_[i], mesh_) == halfedges_[j];
    });
    if (!result.is_closed())
      collect_boundary(result);
    choose_halfedges(result);
    doomed_edges_.resize(num_edges(mesh_));
    write_points(result, reporter);
    write_connectivity();
    return umbrellas_.duplicates().size();
  }

private:
  // The data that write_points has overwritten.
  struct Undo {
    explicit Undo(Arena* arena) : points(arena) {}

    Array<std::pair<Vertex, Point>> points;
    std::vector<std::pair<Vertex, AttributeValue<Attributes>>> attributes;

    void run(FaceGraphWriter& writer) const {
      for (const auto& [v, p] : points)
        put(writer.points_, v, p);
      if constexpr (Attributes::size > 0)
        for (const auto& [v, value] : attributes)
          writer.attributes_.put_raw(v, value);
      writer.channels_.undo();
    }
  };

  // From here on, edges are given by the numbers of the result.
  template <class Result>
  void number_vertices(const Result& result) {
    left_ = result.input_vertices();
    number_ = places(left_, result.input_vertex_count());
    named_edges_.renumber([&](Index v) { return number_of(v, result); });
  }

  // Returns the number of the vertex into which v was merged.
  template <class Result>
  Index number_of(Index v, const Result& result) const {
    return number_[result.merged_vertex(v)];
  }

  // With the halfedges to their corners, which are in the order of read().
  template <class Result>
  void collect_faces(const Result& result) {
    const Array<Index> inputs = result.input_faces();
    const Array<Index> places = internal::places(inputs, result.input_face_count());
    const std::size_t left = inputs.size();
    faces_.resize(left + 1);
    doomed_faces_.resize(places.size() - left + 1);
    std::size_t face = 0, found = 0;
    for (Face f : faces(mesh_)) { // without a branch, which would be hard to predict
      const Index place = places[face];
      faces_[(std::min<std::size_t>)(place, left)] = f;
      doomed_faces_[face++ - found] = f;
      found += place != none;
    }
    faces_.pop_back();
    doomed_faces_.pop_back();
    if constexpr (requires { result.input_side(Index{}, std::size_t{}); })
      collect_given_sides(result, left);
    else
      collect_sides_of_faces(left);
    sides_.reserve(3 * left);
    for (Index i = 0; i < left; ++i) {
      const auto corners = result.corners(i);
      for (std::size_t k = 0; k < 3; ++k)
        sides_.push_back({corners[k == 0 ? 2 : k - 1], corners[k]});
    }
  }

  // Collects the sides of each remaining face.
  void collect_sides_of_faces(std::size_t left) {
    halfedges_.resize(3 * left); // step by step, so that no face waits for what another one reads
    for (std::size_t i = 0; i < left; ++i)
      halfedges_[3 * i] = halfedge(faces_[i], mesh_);
    for (std::size_t k = 1; k < 3; ++k)
      for (std::size_t i = 0; i < left; ++i)
        halfedges_[3 * i + k] = next(halfedges_[3 * i + k - 1], mesh_);
  }
  // Collects the sides of a result whose faces may have sides of any faces.
  template <class Result>
  void collect_given_sides(const Result& result, std::size_t left) {
    Array<Halfedge> inputs(arena_);
    inputs.reserve(3 * result.input_face_count());
    for (Face f : faces(mesh_)) {
      inputs.push_back(halfedge(f, mesh_));
      inputs.push_back(next(inputs.back(), mesh_));
      inputs.push_back(next(inputs.back(), mesh_));
    }
    for (Index i = 0; i < left; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        halfedges_.push_back(inputs[result.input_side(i, k)]);
  }

  // Adds the edges that were on the boundary, by the vertices into which their ends were merged.
  template <class Result>
  void collect_boundary(const Result& result) {
    std::vector<std::pair<Side, Edge>> boundary;
    for (Halfedge h : halfedges(mesh_)) {
      if (!CGAL::is_border(h, mesh_))
        continue;
      const Side side{number_of(vertices_.index(source(h, mesh_)), result),
                      number_of(vertices_.index(target(h, mesh_)), result)};
      const Edge e = edge(h, mesh_);
      if (side.from != side.to && !named_edges_.contains(side, e))
        boundary.emplace_back(side, e);
    }
    for (const auto& [side, e] : boundary)
      named_edges_.add(side.from, side.to, e, false);
    named_edges_.sort();
  }

  // Two sides that were not mates from the beginning come from two edges: the first one's is left,
  // but for a named edge.
  template <class Result>
  void choose_halfedges(const Result& result) {
    chosen_ = halfedges_;
    for (Index side = 0; side < sides_.size(); ++side)
      named_edges_.own(side, sides_[side], edge(halfedges_[side], mesh_));
    for (Index side = 0; side < sides_.size(); ++side) {
      const Index mate = umbrellas_.mate(side);
      if (mate != none && mate < side)
        continue; // done with its mate
      if (const Edge* e = named_edges_.take(side, mate, sides_[side]))
        chosen_[side] = half_along(*e, sides_[side], result);
      if (mate != none)
        chosen_[mate] = opposite(chosen_[side], mesh_);
    }
  }

  // The half of an edge that runs as the side does.
  template <class Result>
  Halfedge half_along(Edge e, const Side& side, const Result& result) const {
    const Halfedge h = halfedge(e, mesh_);
    return number_of(vertices_.index(target(h, mesh_)), result) == side.to ? h : opposite(h, mesh_);
  }

  // Points, attributes and duplicates of vertices: all that calls the user's code or takes memory.
  template <class Result, class AnyReporter>
  void write_points(const Result& result, AnyReporter& reporter) {
    std::vector<Vertex> added;
    added.reserve(umbrellas_.duplicates().size()); // so that none is lost
    std::vector<Vertex> originals;
    for (Index number : umbrellas_.duplicates())
      originals.push_back(vertices_[left_[number]]);
    Undo undo(arena_);
    try {
      for (Index number = 0; number < left_.size(); ++number) {
        const Vertex v = vertices_[left_[number]];
        if (result.is_moved(number))
          write_position(v, result.position(number), undo);
        reporter.vertex(v, number, result);
      }
      channels_.write(
          result, left_.size(), [this](Index v) { return vertices_[left_[v]]; }, chosen_);
      if constexpr (AnyReporter::asks_for_vertex_map)
        report_vertex_map(result, reporter);
      if constexpr (AnyReporter::asks_for_face_map)
        report_face_map(reporter);
      add_duplicates(mesh_, originals, added);
      for (std::size_t i = 0; i < added.size(); ++i) {
        left_.push_back(vertices_.add(added[i]));
        put(points_, added[i], Point(get(points_, originals[i])));
        if constexpr (Attributes::size > 0)
          attributes_.put_raw(added[i], attributes_.raw(originals[i]));
        channels_.copy(originals[i], added[i]);
        reporter.vertex(added[i], umbrellas_.duplicates()[i], result);
      }
      for (std::size_t i = 0; i < added.size(); ++i)
        reporter.duplicate(added[i], originals[i]);
    } catch (...) {
      for (Vertex v : added)
        remove_vertex(v, mesh_);
      undo.run(*this);
      throw;
    }
  }

  template <class Result, class AnyReporter>
  void report_vertex_map(const Result& result, AnyReporter& reporter) const {
    for (Index v = 0; v < number_.size(); ++v) {
      const Index number = number_of(v, result);
      reporter.map_vertex(vertices_[v],
                          number == none ? Traits::null_vertex() : vertices_[left_[number]]);
    }
  }

  template <class AnyReporter>
  void report_face_map(AnyReporter& reporter) const {
    for (Face f : faces_)
      reporter.map_face(f, f);
    for (Face f : doomed_faces_)
      reporter.map_face(f, Traits::null_face());
  }

  void write_position(Vertex v, const Vector<dimension>& position, Undo& undo) {
    undo.points.emplace_back(v, get(points_, v));
    put(points_, v, point_at<Point>(space(position)));
    if constexpr (Attributes::size > 0) {
      undo.attributes.emplace_back(v, attributes_.raw(v));
      attributes_.write(v, attributes_of(position));
    }
  }

  void write_connectivity() {
    FaceLinker<Mesh>(mesh_, umbrellas_, faces_, chosen_)
        .link([this](Index corner) { return vertex_at(corner); }, doomed_edges_);
    for (Face f : doomed_faces_)
      remove_face(f, mesh_);
    for (Edge e : doomed_edges_)
      remove_edge(e, mesh_);
    remove_other_vertices();
  }

  // Than those that are left.
  void remove_other_vertices() {
    for (Index v = 0; v < number_.size(); ++v)
      if (number_[v] == none)
        remove_vertex(vertices_[v], mesh_);
  }

  Vertex vertex_at(Index corner) const { return vertices_[left_[umbrellas_.vertex(corner)]]; }

  Arena* arena_;
  Mesh& mesh_;
  PointMap points_;
  Vertices& vertices_; // with those that write() adds
  Attributes& attributes_;
  Channels& channels_;
  NamedEdges<Edge>& named_edges_;
  Array<Index> left_{arena_};         // the vertices that are left, with the duplicates
  Array<Index> number_{arena_};       // of each vertex that was read: where it is in left_
  Array<Face> faces_{arena_};         // the faces that are left
  Array<Side> sides_{arena_};         // three a face, of numbers in left_: side k leads to corner k
  Array<Halfedge> halfedges_{arena_}; // of each side before
  Array<Halfedge> chosen_{arena_};    // and after
  Umbrellas umbrellas_{arena_};
  Array<Face> doomed_faces_{arena_};
  Array<Edge> doomed_edges_{arena_};
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_WRITER_H
