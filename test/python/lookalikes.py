"""Classes that look to the Python module as those of trimesh, Open3D, PyVista and meshio do: what it may ask for
does what it does there, and every other public attribute of trimesh.Trimesh and pyvista.PolyData is there as well,
as something that is no mesh."""

import numpy as np


def with_all_of(names, methods):
    """A decorator of classes: what they lack of these public attributes is there, and of no use."""
    def complete(cls):
        for name in names.split():
            if not hasattr(cls, name):
                setattr(cls, name, property(lambda self, name=name: np.full((7, 3, 3), 0.5)))
        for name in methods.split():
            if not hasattr(cls, name):
                setattr(cls, name, lambda self, *arguments, **named: NotImplemented)
        return cls
    return complete


class TrackedArray(np.ndarray):
    """The arrays of trimesh."""


class ColorVisuals:
    def __init__(self, mesh=None, face_colors=None, vertex_colors=None):
        self.mesh, self.given = mesh, {"face": face_colors, "vertex": vertex_colors}

    @property
    def kind(self):
        return next((kind for kind in ("vertex", "face") if self.given[kind] is not None), None)

    @property
    def defined(self):
        return self.kind is not None

    def _colors(self, kind, count):
        grey = np.tile(np.uint8([102, 102, 102, 255]), (count, 1))
        return grey if self.given[kind] is None else np.asarray(self.given[kind])

    @property
    def face_colors(self):
        return self._colors("face", len(self.mesh.faces))

    @property
    def vertex_colors(self):
        return self._colors("vertex", len(self.mesh.vertices))


class TextureVisuals:
    kind, defined = "texture", True

    def __init__(self, uv=None, material=None, image=None, face_materials=None):
        self.uv, self.material, self.face_materials = uv, material, face_materials


@with_all_of(
    "area area_faces body_count bounding_box bounding_box_oriented bounding_cylinder bounding_primitive bounding_sphere "
    "center_mass centroid convex_hull density edges_face edges_sorted edges_sorted_tree edges_sparse edges_unique "
    "edges_unique_inverse edges_unique_length euler_number extents face_adjacency face_adjacency_angles "
    "face_adjacency_convex face_adjacency_edges face_adjacency_edges_tree face_adjacency_projections "
    "face_adjacency_radius face_adjacency_span face_adjacency_tree face_adjacency_unshared face_angles "
    "face_angles_sparse face_neighborhood faces_sparse faces_unique_edges facets facets_area facets_boundary "
    "facets_normal facets_on_hull facets_origin identifier identifier_hash integral_mean_curvature is_convex is_empty "
    "is_volume is_watertight is_winding_consistent kdtree mass mass_properties moment_inertia mutable nearest permutate "
    "principal_inertia_components principal_inertia_transform principal_inertia_vectors ray referenced_vertices scale "
    "smooth_shaded source symmetry symmetry_axis symmetry_section triangles_cross triangles_tree units "
    "vertex_adjacency_graph vertex_defects vertex_degree vertex_faces vertex_neighbors volume",
    "apply_obb apply_scale apply_transform apply_translation compute_stable_poses contains convert_units "
    "convex_decomposition copy difference eval_cached export extend_faces fill_holes fix_normals intersection invert "
    "merge_vertices moment_inertia_frame nondegenerate_faces outline process projected register remove_infinite_values "
    "remove_unreferenced_vertices rezero sample scene section section_multiplane show simplify_quadric_decimation "
    "slice_plane split subdivide subdivide_loop subdivide_to_size submesh to_dict union unique_faces unmerge_vertices "
    "unwrap update_faces update_vertices voxelized")
class Trimesh:
    """Beside `faces`, which are indices, it has `triangles`, which are coordinates."""

    def __init__(self, vertices=None, faces=None, face_normals=None, vertex_normals=None, face_colors=None,
                 vertex_colors=None, face_attributes=None, vertex_attributes=None, metadata=None, process=True,
                 validate=False, merge_tex=None, merge_norm=None, use_embree=True, initial_cache=None, visual=None):
        self._vertices = np.ascontiguousarray(vertices, np.float64).view(TrackedArray)
        self._faces = np.ascontiguousarray(faces, np.int64).view(TrackedArray)
        self.is_processed, self.metadata, self._normals = process, dict(metadata or {}), vertex_normals
        self.vertex_attributes, self.face_attributes = dict(vertex_attributes or {}), dict(face_attributes or {})
        if visual is not None and vertex_colors is not None:
            self.vertex_attributes["color"] = vertex_colors
        self.visual = ColorVisuals(self, face_colors, vertex_colors) if visual is None else visual

    vertices, faces = property(lambda self: self._vertices), property(lambda self: self._faces)
    triangles = property(lambda self: self.vertices.view(np.ndarray)[self.faces])
    triangles_center = property(lambda self: self.triangles.mean(axis=1))
    edges = property(lambda self: np.asarray(self.faces)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2))
    bounds = property(lambda self: np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)]))

    @property
    def face_normals(self):
        a, b, c = np.moveaxis(self.triangles, 1, 0)
        return np.cross(b - a, c - a)

    @property
    def vertex_normals(self):
        return np.zeros(self.vertices.shape) if self._normals is None else self._normals


class Primitive(Trimesh):
    """A sphere, or a box: it takes no vertices."""

    def __init__(self, radius=1.0, transform=None, mutable=True):
        super().__init__(np.eye(4)[:, :3], np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]))


class StubbornPrimitive(Primitive):
    """It takes them, and has its own."""

    def __init__(self, **arguments):
        super().__init__()


class Vector:
    """Of Open3D: of one type, and only numpy can look into it."""

    def __init__(self, array=()):
        array = np.asarray(array)
        if array.size > 0 and (array.dtype, array.shape[1:]) != (self.dtype, self.row):
            raise TypeError(f"{type(self).__name__} of {array.dtype} and the shape {array.shape}")
        self._array = array.astype(self.dtype)

    def __array__(self, dtype=None):
        return self._array.astype(dtype or self.dtype)

    def __len__(self):
        return len(self._array)


class Vector3dVector(Vector):
    dtype, row = np.float64, (3,)


class Vector2dVector(Vector):
    dtype, row = np.float64, (2,)


class Vector3iVector(Vector):
    dtype, row = np.int32, (3,)


class IntVector(Vector):
    dtype, row = np.int32, ()


class TriangleMesh:
    def __init__(self, vertices=(), triangles=()):
        self.vertices, self.triangles = Vector3dVector(vertices), Vector3iVector(triangles)
        self.vertex_colors, self.vertex_normals = Vector3dVector(), Vector3dVector()
        self.triangle_uvs, self.textures, self.triangle_material_ids = Vector2dVector(), [], IntVector()


@with_all_of(
    "actual_memory_size active_normals active_scalars active_scalars_info active_scalars_name "
    "active_tensors active_tensors_info active_tensors_name active_texture_coordinates_name active_vectors "
    "active_vectors_info active_vectors_name area array_names arrow bounds cell center center_of_mass dimensionality "
    "distinct_cell_types edge_mask extent face_normals field_data irregular_faces is_all_triangles is_empty is_manifold "
    "length memory_address mesh n_arrays n_cells n_faces_strict n_open_edges n_points obbTree plotting point point_normals "
    "user_dict volume verts lines strips",
    "add_field_data align align_xyz append_polydata boolean_difference boolean_intersection boolean_union "
    "bounding_box cast_to_pointset cast_to_poly_points cast_to_unstructured_grid cell_centers cell_data_to_point_data "
    "cell_neighbors cell_neighbors_levels cell_point_ids cell_quality clean clear_cell_data clear_data clear_field_data "
    "clear_point_data clip clip_box clip_closed_surface clip_scalar clip_surface collision color_labels "
    "compute_arc_length compute_boundary_mesh_quality compute_cell_quality compute_cell_sizes compute_derivative "
    "compute_implicit_distance compute_normals connectivity contour contour_banded copy copy_from "
    "copy_meta_from copy_structure ctp curvature decimate decimate_boundary decimate_polyline decimate_pro deep_copy "
    "delaunay_2d delaunay_3d edge_source elevation explode extract_all_edges extract_cells extract_cells_by_type "
    "extract_feature_edges extract_geometry extract_largest extract_points extract_surface extract_values extrude "
    "extrude_rotate extrude_trim fast_simplification fill_holes find_cells_along_line find_cells_within_bounds "
    "find_closest_cell find_closest_point find_containing_cell flip_faces flip_normals flip_x flip_y flip_z from_irregular_faces "
    "from_regular_faces geodesic geodesic_distance gaussian_smooth generic_filter get_array get_array_association "
    "get_cell get_data_range glyph head integrate_data interpolate intersection is_equal kdtree merge merge_points "
    "multi_ray_trace oriented_bounding_box outline outline_corners overwrite pack_labels partition "
    "plot plot_boundaries plot_curvature plot_normals plot_over_line point_cell_ids point_data_to_cell_data "
    "point_is_inside_cell point_neighbors point_neighbors_levels points_to_double probe project_points_to_plane ptc "
    "protein_ribbon ray_trace reconstruct_surface reflect remove_cells remove_points remove_unused_points "
    "rename_array resample_to_image ribbon rotate rotate_vector rotate_x rotate_y rotate_z ruled_surface sample "
    "sample_over_circular_arc sample_over_line sample_over_multiple_lines save scale select_enclosed_points "
    "select_interior_points separate_cells set_active_scalars set_active_tensors set_active_vectors shallow_copy "
    "shrink slice slice_along_axis slice_along_line slice_implicit slice_orthogonal smooth smooth_taubin "
    "sort_labels split_bodies split_values streamlines strip subdivide subdivide_adaptive surface_indices tail "
    "tessellate texture_map_to_plane texture_map_to_sphere threshold threshold_percent to_polydata transform "
    "translate triangle_strip triangulate triangulate_contours tube validate_mesh voxelize voxelize_binary_mask "
    "voxelize_rectilinear warp_by_scalar warp_by_vector "
    "DeepCopy GetBounds GetCell GetCellData GetLines GetNumberOfCells GetNumberOfLines GetNumberOfPoints "
    "GetNumberOfPolys GetNumberOfStrips GetNumberOfVerts GetPointData GetPoints GetPolys GetStrips GetVerts SetLines "
    "SetPoints SetPolys SetStrips SetVerts ShallowCopy")
class PolyData:
    """`faces` are padded: 3, a, b, c, 3, ..."""

    active_texture_coordinates = None
    n_strips, n_verts, n_lines = 0, 0, 0

    def __init__(self, points, faces=None, lines=None, strips=None, deep=False, force_float=True, verts=None):
        self.points, self.faces = points, faces
        self.point_data, self.cell_data = {}, {}

    def __setitem__(self, name, values):
        self.point_data[name] = values

    def __getitem__(self, name):
        return self.point_data[name]

    @property
    def regular_faces(self):
        return np.asarray(self.faces).reshape(-1, 4)[:, 1:]


class CellBlock:
    def __init__(self, kind, data):
        self.type, self.data = kind, data


class MeshioMesh:
    def __init__(self, points, cells, point_data=None, cell_data=None, field_data=None):
        self.points, self.cells = points, [CellBlock(kind, data) for kind, data in cells]
        self.point_data, self.cell_data = point_data or {}, cell_data or {}
        self.field_data = field_data or {}


def padded(faces):
    """As VTK has triangles."""
    return np.insert(faces.astype(np.int64), 0, 3, axis=1).ravel()
