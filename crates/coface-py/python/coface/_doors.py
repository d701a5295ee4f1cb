"""To and from other libraries, by name."""

from __future__ import annotations

from typing import Any

from coface._coface import Complex, Model, PlanarArrangement, YinSet
from coface._models import as_complex, as_drawn, as_model, geometries_of, is_features
from coface._arrays import raise_invalid
from coface.interop import geopandas, gudhi, meshio, networkx, open3d, pymeshlab, pyvista, shapely, trimesh
from coface._faults import in_words


def _like(x: Any, what: str, *attributes: str) -> None:
    """Refuses what has not the attributes of an object of another library."""
    if not all(hasattr(x, name) for name in attributes):
        raise_invalid(f"a {type(x).__name__} is no {what}", f"give a {what}; coface.as_model takes objects of any library")


@in_words
def from_trimesh(mesh: Any) -> Model:
    """A mesh, scene, drawing or point cloud of trimesh as a model; :func:`as_model` does it too.

    Examples
    --------
    >>> import coface, pytest
    >>> trimesh = pytest.importorskip("trimesh")
    >>> coface.from_trimesh(trimesh.creation.box())
    Model(8 vertices, 12 faces)
    """
    return trimesh.to_model(mesh)


@in_words
def to_trimesh(x: Any, **options: Any) -> Any:
    """A model as ``trimesh.Trimesh``, its polygons cut into triangles; one of lines as ``trimesh.path.Path3D``; of a volume the squares around its voxels.

    Vertices keep their numbers, and faces if they are triangles. `options` go to the class of trimesh; ``process=False`` stands unless said otherwise.

    Examples
    --------
    >>> import coface, pytest
    >>> _ = pytest.importorskip("trimesh")
    >>> coface.to_trimesh(coface.generate("csaszar")).is_watertight
    True
    """
    return trimesh.from_model(as_drawn(x), **options)


@in_words
def from_meshio(mesh: Any) -> Model:
    """A ``meshio.Mesh`` as a model; :func:`as_model` does it too."""
    _like(mesh, "meshio.Mesh", "points", "cells")
    return meshio.to_model(mesh)


@in_words
def to_meshio(x: Any, **options: Any) -> Any:
    """A model as ``meshio.Mesh``: a block for each kind of cell. `options` go to the class of meshio."""
    return meshio.from_model(as_drawn(x), **options)


@in_words
def from_pyvista(mesh: Any) -> Model:
    """A data set of pyvista, or of VTK, as a model; :func:`as_model` does it too."""
    if pyvista.is_other(mesh):
        raise_invalid(f"a {type(mesh).__name__} is no data set of pyvista or VTK", "give one; coface.as_model takes objects of any library")
    return pyvista.to_model(mesh)


@in_words
def to_pyvista(x: Any, *, grid: bool = False, **options: Any) -> Any:
    """A model as ``pyvista.PolyData``, or as ``pyvista.UnstructuredGrid`` where it has 3-cells.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    grid
        Whether it becomes an ``UnstructuredGrid`` in any case: lines, then faces, then 3-cells.
    options
        What else the class of pyvista takes.
    """
    return pyvista.from_model(as_drawn(x), grid=grid, **options)


@in_words
def from_pymeshlab(mesh: Any) -> Model:
    """A ``pymeshlab.Mesh``, or the current mesh of a ``MeshSet``, as a model; :func:`as_model` does it too."""
    if not hasattr(mesh, "current_mesh"):
        _like(mesh, "pymeshlab.Mesh", "vertex_matrix", "face_matrix")
    return pymeshlab.to_model(mesh)


@in_words
def to_pymeshlab(x: Any) -> Any:
    """A model of triangles, or of points alone, as ``pymeshlab.Mesh``, which ``MeshSet.add_mesh`` takes."""
    return pymeshlab.from_model(as_drawn(x))


@in_words
def from_open3d(geometry: Any) -> Model:
    """A mesh, set of lines or point cloud of open3d as a model; :func:`as_model` does it too."""
    return open3d.to_model(geometry)


@in_words
def to_open3d(x: Any) -> Any:
    """A model as ``open3d.geometry.TriangleMesh``, ``TetraMesh``, ``LineSet`` or ``PointCloud``."""
    return open3d.from_model(as_drawn(x))


@in_words
def from_networkx(graph: Any) -> Model:
    """A graph as a model of lines: vertex i is the i-th node; positions from the attribute ``pos`` if all nodes have it."""
    _like(graph, "networkx.Graph", "nodes", "edges", "is_multigraph")
    return networkx.to_model(graph)


@in_words
def to_networkx(x: Any) -> Any:
    """The vertices and edges of a model, those of its faces and cells included, as ``networkx.Graph``."""
    return networkx.from_model(as_drawn(x))


@in_words
def from_gudhi(tree: Any) -> Complex:
    """A ``gudhi.SimplexTree`` as a complex, whatever its filtration values."""
    _like(tree, "gudhi.SimplexTree", "get_simplices")
    return gudhi.to_model(tree).complex()


@in_words
def to_gudhi(x: Any, values: Any = None) -> Any:
    """A complex as ``gudhi.SimplexTree``.

    Parameters
    ----------
    x
        Anything that :func:`as_complex` understands.
    values
        A number for each vertex, indexed by its id: a simplex comes with the last of its vertices. Without it all come at 0.
    """
    return gudhi.from_complex(as_complex(x), values)


@in_words
def from_shapely(geometry: Any) -> Model:
    """A geometry of shapely, or a list, set, array, ``GeoSeries`` or ``GeoDataFrame`` of them, as a model of lines; rings know their polygon."""
    if is_features(geometry) or geometries_of(geometry) is not None:
        return as_model(geometry)
    for one in geometry if isinstance(geometry, (list, tuple)) else [geometry]:
        _like(one, "geometry of shapely", "geom_type")
    return shapely.to_model(geometry)


@in_words
def to_shapely(x: Any) -> Any:
    """A planar model as a geometry of shapely: polygons with holes, lines and points. Coordinates go over exactly."""
    return shapely.from_model(as_drawn(x))


@in_words
def to_geopandas(x: Any) -> Any:
    """A planar model as ``geopandas.GeoDataFrame``: a row for each feature, its attributes as columns, with its reference system.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands and that lies in the plane. A :class:`PlanarArrangement` is an overlay: a row for each face that an input contains, with the
        attributes of all features that contain it, ``None`` where no feature of an input does.

    Returns
    -------
    geopandas.GeoDataFrame

    Examples
    --------
    >>> import coface
    >>> frame = coface.to_geopandas(coface.arrange(land, zones))    # doctest: +SKIP
    >>> frame[["use", "zone", "geometry"]]                          # doctest: +SKIP
    """
    return geopandas.from_model(x.attributes() if isinstance(x, PlanarArrangement) else as_drawn(x))


def set_from_shapely(geometry: Any, *, order: int = 2, rule: str | None = None, kinks: Any = None, progress: Any = None) -> YinSet:
    """The polygons of a geometry of shapely, or of a list of them, as a set.

    Parameters
    ----------
    geometry
        Polygons with holes, in any direction.
    order
        2 for polylines, 4 for cubic splines through the points, ...
    rule
        What is inside rings that cross: ``"nonzero"``, ``"evenodd"`` or ``"positive"``.
    kinks
        Where splines may turn, as in :meth:`YinSet.from_rings`.
    progress
        As for :func:`homology`.

    Returns
    -------
    YinSet
        Coordinates go over exactly.

    Examples
    --------
    >>> import coface, pytest
    >>> shapely = pytest.importorskip("shapely")
    >>> coface.YinSet.from_shapely(shapely.box(0, 0, 2, 1)).area
    2.0
    """
    return YinSet.from_model(as_model(geometry), order=order, rule=rule, kinks=kinks, progress=progress)


def set_to_shapely(self: YinSet, *, flatten: float | None = None) -> Any:
    """The set as polygons of shapely, with holes.

    Parameters
    ----------
    flatten
        How far chords may be from curves; not needed for polylines, whose coordinates go over exactly.

    Returns
    -------
    shapely.Polygon or shapely.MultiPolygon

    Examples
    --------
    >>> import coface, pytest
    >>> _ = pytest.importorskip("shapely")
    >>> coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 1], [0, 1]]]).to_shapely().area
    2.0
    """
    from coface.interop import needed

    library = needed("shapely", "YinSet.to_shapely")
    found = [library.from_wkt(line) for line in self.to_bytes("wkt", flatten=flatten).decode().splitlines() if line]
    return found[0] if len(found) == 1 else library.MultiPolygon([part for one in found for part in getattr(one, "geoms", [one])])


setattr(YinSet, "from_shapely", staticmethod(in_words(set_from_shapely)))
setattr(YinSet, "to_shapely", in_words(set_to_shapely))
