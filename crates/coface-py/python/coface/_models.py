"""What everything begins with: anything that describes a space becomes a model."""

from __future__ import annotations

import json
import os
import warnings
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple
from uuid import UUID

import numpy as np
from numpy.typing import NDArray

from coface import _coface
from coface._answers import same
from coface._arrays import plain, raise_invalid
from coface._coface import (
    AssumptionWarning,
    ChainComplex,
    Cocycles,
    Complex,
    Congruence,
    Curve,
    Interface,
    LarModel,
    Model,
    NotAComplexError,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Simplices,
    SpatialArrangement,
    Surface,
    YinSet,
    _volume,
    read,
)
from coface._records import read_back
from coface.interop import adapter_of
from coface._faults import in_words


class Repaired(NamedTuple):
    """What :meth:`Model.repaired` gives; functions that take a model take it as its model."""

    #: The repaired model; the same repair again does nothing.
    model: Model
    #: For each vertex the one that it was.
    vertex_sources: NDArray[np.int64]

    def _repr_html_(self) -> str:
        return self.model._repr_html_()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, tuple) and same(tuple(self), tuple(other))

    def __ne__(self, other: object) -> bool:
        return not self == other


class RepairedSurface(NamedTuple):
    """What :meth:`Model.repaired_surface` gives; functions that take a model take it as its model."""

    #: The surface.
    model: Model
    #: How much was done, by what it was.
    done: dict[str, int]


class Subdivided(NamedTuple):
    """What :meth:`Model.subdivided` gives; functions that take a model take it as its model."""

    #: The facet list.
    model: Model
    #: For each vertex the dimension and the number of the cell that it lies in the interior of.
    carriers: NDArray[np.int64]


def unwrapped(x: Any) -> Any:
    """The model of a model with what was done to it; anything else as it is.

    Examples
    --------
    >>> import coface
    >>> type(unwrapped(coface.Model.from_facets([[0, 1, 2]]).repaired())).__name__
    'Model'
    """
    is_pair = isinstance(x, tuple) and len(x) == 2 and isinstance(x[0], Model)
    return x[0] if is_pair and isinstance(x[1], (np.ndarray, dict)) else x


@in_words
def as_model(x: Any, *, progress: Any = None) -> Model:
    """Whatever describes a space, as a model.

    Parameters
    ----------
    x
        One of these:

        * a :class:`Model`, :class:`Complex`, :class:`Surface`, :class:`ChainComplex` or :class:`LarModel`, or an answer that has a model: an arrangement (in
          space its cells, :attr:`SpatialArrangement.cells`), a Boolean, a :class:`Domain`, a :class:`Cover`, a :class:`Report`, a :class:`YinSet`,
          :class:`Curve` or :class:`Interface` (its boundary as lines), what :meth:`Model.repaired` gives;
        * a dictionary of ``to_dict()``;
        * a path, or a file that is open for reading;
        * ``(vertices, faces)``: an array ``(n, d)`` of coordinates, or ``None``, and polygons as in :class:`Model`;
        * facets of a simplicial complex: a list or set of lists of integers, or an integer array ``(m, k)`` of 32 or 64 bits;
        * points: an array ``(n, 1)``, ``(n, 2)`` or ``(n, 3)`` of floats;
        * voxels: an array of truth values, as in :func:`volume`; an image of other numbers is refused here, since it could be points or
          facets;
        * a ``GeoDataFrame`` or ``GeoSeries``, or anything else with ``__geo_interface__``: its geometries, with their attributes; a dictionary of GeoJSON;
        * a table with ``to_numpy()``, as pandas has them, or a generator, for any of these;
        * a dictionary in the words of the JSON files: ``{"facets": ...}``, ``{"boundaries": ...}`` and so on;
        * a mesh, scene or drawing of trimesh, a mesh of meshio, a mesh of PyMeshLab, a data set of pyvista or VTK, a geometry of open3d, a
          graph of networkx, a ``SimplexTree`` of gudhi, a geometry of shapely or a list, set or array of them, a ``Delaunay`` triangulation or a ``ConvexHull`` of scipy.
    progress
        As in :func:`read`, where a file is read.

    Returns
    -------
    Model
        Vertices and cells keep their numbers and order.

    Raises
    ------
    InvalidInputError
        If nothing here knows what `x` is, or it breaks a rule of models.

    Examples
    --------
    >>> import coface
    >>> coface.as_model(([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]))
    Model(3 vertices, 1 face)
    >>> coface.as_model([[0, 1, 2], [2, 3]]).f_vector
    (4, 4, 1)
    """
    x = unwrapped(x)
    if isinstance(x, Model):
        return x
    if type(x).__module__ == "coface":
        return _of_answer(x)
    if type(x).__module__ == "coface._buildings":
        return _of_cell_graph(x)
    if isinstance(x, (str, os.PathLike)):
        return read(x, progress=progress)
    if isinstance(x, (bytes, bytearray, memoryview)):
        return Model.from_bytes(bytes(x), progress=progress)
    if isinstance(x, dict) and "recipe" in x:
        return as_model(read_back(x["recipe"]))
    if isinstance(x, dict) and x.get("type") in _GEOJSON:
        return _of_geojson(x, progress)
    if isinstance(x, dict):
        return Model.from_bytes(json.dumps(x, default=_plain).encode(), "json")
    if is_features(x):
        return _of_geojson(_features(x), progress)
    geometries = geometries_of(x)
    if geometries is not None:
        return _of_geometries(geometries, getattr(x, "crs", None), progress)
    adapter = adapter_of(x)
    if adapter is not None:
        found: Model = adapter.to_model(x)
        return found
    if hasattr(x, "__geo_interface__"):
        return _of_geojson(dict(x.__geo_interface__), progress)
    if hasattr(x, "read"):
        data = x.read()
        return Model.from_bytes(data.encode() if isinstance(data, str) else data, progress=progress)
    x = plain(x)
    geometries = geometries_of(x)
    if geometries is not None:
        return _of_geometries(geometries, None, progress)
    if isinstance(x, np.ndarray):
        return _of_array(x)
    if isinstance(x, tuple) and len(x) == 2 and not _is_list_of_ids(x[0]):
        return Model.from_arrays(x[0], x[1])
    if isinstance(x, (list, tuple)):
        first = _first_leaf(x)
        if isinstance(first, (bool, np.bool_, float, np.floating)):
            try:
                array = np.asarray(x)
            except ValueError:
                raise_invalid(
                    "a list of lists of different lengths has numbers that are no ids",
                    "give facets as lists of integers, or points as rows of one length",
                )
            return _of_array(array)
        return Model.from_facets(x)
    raise_invalid(
        f"a {type(x).__name__} is nothing that describes a space here",
        "give a path, (vertices, faces), facets, or an object that as_model names",
    )


def _of_answer(x: Any) -> Model:
    """The model that an answer has, or that it is about."""
    if isinstance(x, YinSet):
        return _of_curves(x.curves, is_plane=x.is_plane)
    if isinstance(x, Curve):
        return _of_curves([x], is_plane=False)
    if isinstance(x, Interface):
        return _of_curves([curve for region in x.sets() for curve in region.curves], is_plane=False)
    if isinstance(x, Simplices):
        if not x.is_complex:
            _refuse_open(x)
        return x.closure().model()
    if isinstance(x, SpatialArrangement):
        return x.cells
    if isinstance(x, Persistence) and x.__dict__.get("recipe", ("",))[0] == "persistence":
        complex: ChainComplex = x.__dict__["recipe"][1][0]
        return complex.source if complex.source is not None else complex.model()
    if isinstance(x, Cocycles) and "recipe" in x.__dict__:
        return as_model(x.__dict__["recipe"][1][0])
    own = getattr(x, "model", None)
    if own is None:
        cure = "ask for its model where it was made, or give both in a list to coface.view, render or plot"
        raise_invalid(f"a {type(x).__name__} does not know its model", cure)
    made: Model = own() if callable(own) else own
    return made


def _of_cell_graph(x: Any) -> Model:
    """The cells of a graph as points where their centers are, and a line between cells that are adjacent."""
    if not hasattr(x, "nodes"):
        raise_invalid(f"a {type(x).__name__} is a part of a graph", "give the graph: arrangement.graph()")
    places = {node.cell: place for place, node in enumerate(x.nodes)}
    lines = [[places[cell] for cell in edge.cells] for edge in x.edges]
    points = np.array([node.centroid for node in x.nodes], np.float64).reshape(-1, 3)
    return Model.from_arrays(points, cells={"line": lines} if lines else None)


def _refuse_open(x: Simplices) -> None:
    """Says that a set of simplices is no complex, with a face that it leaves out."""
    own = {tuple(row) for k in range(1 + (x.dimension or 0)) for row in np.asarray(x.simplices(k)).tolist()}
    found = next(((row, row[:i] + row[i + 1 :]) for row in sorted(own) for i in range(len(row)) if len(row) > 1 and row[:i] + row[i + 1 :] not in own), None)
    why = "" if found is None else f": it has {list(found[0])} without its face {list(found[1])}"
    message = f"the set of simplices is no complex{why}"
    cure = "take its closure: simplices.closure(), or the homology relative to the rest: coface.homology(s.closure(), relative=s.closure() - s)"
    raise NotAComplexError(f"{message}; {cure}", fault=message, cure=cure, cells=[] if found is None else [list(found[0])])


def as_drawn(x: Any, *, progress: Any = None) -> Model:
    """As :func:`as_model`, but what can be drawn and handed to other libraries: of an arrangement in space its faces, of an open star its closure.

    Examples
    --------
    >>> import coface
    >>> arranged = coface.arrange(coface.generate("box", boundary=True))
    >>> len(as_drawn(arranged).faces), len(coface.as_model(arranged).faces)
    (12, 0)
    """
    x = unwrapped(x)
    if isinstance(x, SpatialArrangement):
        return x.model()
    if isinstance(x, Simplices):
        return x.closure().model()
    return as_model(x, progress=progress)


def as_cells(x: Any, *, progress: Any = None) -> Model:
    """As :func:`as_model`, but with the cells that an answer counts in its ``f_vector``, and of a set of the plane the set itself: what homology and other
    questions about cells are asked of.

    Examples
    --------
    >>> import coface
    >>> square = coface.polygon([[0, 0], [3, 0], [3, 3], [0, 3]], [[1, 1], [2, 1], [2, 2], [1, 2]])
    >>> coface.homology(coface.boolean("union", square))
    Homology(Z, Z)
    """
    if isinstance(x, (Congruence, PlanarArrangement, PlanarBoolean, SpatialArrangement)):
        return x.cells
    if isinstance(x, YinSet):
        return _region_of(x)
    if isinstance(x, Interface):
        return _edges_of(x)
    return as_model(x, progress=progress)


def _edges_of(x: Interface) -> Model:
    """The edges of an interface as lines, each once, which meet in its vertices; splines as chords."""
    at = x.sample(per_piece=1 if x.order == 2 else 16)
    points, lines = [np.asarray(x.vertices, np.float64).reshape(-1, 2)], []
    count = len(points[0])
    edges: list[Any] = list(x.edges)
    for number, edge in enumerate(edges):
        own = at["point"][at["edge"] == number][1:-1]
        start, end = edge["ends"]
        lines.append([start, *range(count, count + len(own)), end])
        points.append(own)
        count += len(own)
    return Model.from_arrays(np.concatenate(points), cells={"polyline": lines} if lines else None)


def _region_of(x: YinSet) -> Model:
    """The closure of a bounded set as cells; splines as chords, and never with another topology."""
    if not x.is_bounded:
        raise_invalid(
            "the set is not bounded, and has no finite cells",
            "take its part in a box, set & box, or ask for set.betti_open, set.betti_closed, or coface.as_model(set) for its boundary",
        )
    if x.is_empty:
        return Model.from_arrays(np.zeros((0, 2)))
    found: Model = _coface.boolean("union", [_of_curves(x.curves, is_plane=False)], rule="evenodd").cells
    groups = found.chain_complex().homology().betti_numbers
    closed = list(x.betti_closed)
    if [*groups, 0, 0][:2] != closed:
        raise_invalid(
            f"chords of the boundary have Betti numbers {list(groups)[:2]}, and the closed set has {closed}",
            "ask for set.betti_open and set.betti_closed, which are of the splines themselves",
        )
    if list(x.betti_open) != closed:
        message = f"homology is that of the closed set, with Betti numbers {closed}; the open set has {list(x.betti_open)}, where it touches itself in points"
        warnings.warn(message, AssumptionWarning, stacklevel=4)
    return found


def _of_curves(curves: list[Curve], *, is_plane: bool) -> Model:
    """Boundaries as closed lines in their directions; curves as chords within a ten thousandth of their size."""
    if is_plane:
        raise_invalid("the whole plane has no boundary", "give a set with curves")
    points: list[NDArray[np.float64]] = []
    lines, start = [], 0
    for curve in curves:
        low, high = np.asarray(curve.bounding_box)
        if curve.order == 2:
            points.append(np.asarray(curve.controls)[: -1 if curve.is_closed else None])
        else:
            points.append(curve.flattened(float((high - low).max()) / 10_000))
        count = len(points[-1])
        lines.append([*range(start, start + count), *([start] if curve.is_closed else [])])
        start += count
    return Model.from_arrays(np.concatenate(points) if points else np.zeros((0, 2)), cells={"polyline": lines})


#: What an array can be, and how to say so.
_ARRAYS = (
    "say what it is: coface.volume(x, threshold=...) for an image, coface.cubical(x) for its persistence, coface.Model(vertices, faces) for a mesh, "
    "coface.Model.from_facets(x) for facets, coface.Model(x) for points"
)


def _of_array(x: NDArray[Any]) -> Model:
    """An array that can be one thing only."""
    kind, shape = x.dtype.kind, x.shape
    if kind == "b":
        return _volume(np.ascontiguousarray(x), [])
    if kind in "iu":
        if x.ndim != 2 or x.dtype.itemsize < 4 and x.size:
            raise_invalid(f"an array of {x.dtype} of shape {shape} could be an image or facets", _ARRAYS)
        rows = np.sort(x, axis=1)
        if (rows[:, 1:] == rows[:, :-1]).any():
            raise_invalid(f"an array of {x.dtype} of shape {shape} has rows that repeat a number, so they are no facets", _ARRAYS)
        return Model.from_facets(x)
    if kind == "f":
        if x.ndim == 2 and shape[1] > 3 or x.ndim > 2:
            raise_invalid(f"an array of {x.dtype} of shape {shape} could be an image or points", _ARRAYS)
        return Model.from_arrays(x)
    raise_invalid(f"an array of {x.dtype} has no numbers", _ARRAYS)


def _first_leaf(value: Any) -> Any:
    """The first thing in lists of lists that is no list."""
    while isinstance(value, (list, tuple)) and len(value):
        value = value[0]
    return value


def geo_interface(model: Model) -> dict[str, Any]:
    """A planar model as a ``FeatureCollection`` of GeoJSON, which geopandas, shapely and others take."""
    found: dict[str, Any] = json.loads(_coface._bytes_of(model, "geojson"))
    return found


#: What a dictionary of GeoJSON says that it is.
_GEOJSON = frozenset(
    ("Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection", "Feature", "FeatureCollection")
)


def _features(x: Any) -> dict[str, Any]:
    """The features of a table as GeoJSON, with the reference system that the table names."""
    found = dict(x.__geo_interface__)
    system = _system_of(getattr(x, "crs", None))
    if system is not None and "crs" not in found:
        found["crs"] = {"type": "name", "properties": {"name": system}}
    return found


def _system_of(crs: Any) -> str | None:
    """The name of a reference system of pyproj: by EPSG, else by another authority, else as WKT."""
    if crs is None or not hasattr(crs, "to_epsg"):
        return None
    authority = crs.to_authority(min_confidence=100)
    if authority is not None and authority[0] == "OGC":
        return ":".join(authority)
    srid = crs.to_epsg()
    if srid is not None:
        return f"urn:ogc:def:crs:EPSG::{srid}"
    return ":".join(authority) if authority is not None else str(crs.to_wkt())


def _of_geojson(found: dict[str, Any], progress: Any) -> Model:
    """The model of GeoJSON; one without geometries is an empty drawing, whose box has no numbers."""
    found = {key: value for key, value in found.items() if key != "bbox"}
    return Model.from_bytes(json.dumps(found, default=_plain).encode(), "geojson", progress=progress)


def geometries_of(x: Any) -> list[Any] | None:
    """The geometries of shapely in a list, tuple, set, array, column of a table or generator; ``None`` where it holds other things, or nothing."""
    if isinstance(x, (list, tuple, set, frozenset)):
        members = list(x)
    elif isinstance(x, np.ndarray):
        members = list(x.reshape(-1)) if x.dtype == object else []
    elif type(x).__module__.partition(".")[0] in ("pandas", "geopandas") and hasattr(x, "to_numpy"):
        column = x.to_numpy()
        members = list(column) if column.dtype == object and column.ndim == 1 else []
    else:
        return None
    members = [one for one in members if one is not None]
    return members if members and all(type(one).__module__.startswith("shapely") for one in members) else None


def _of_geometries(geometries: list[Any], crs: Any, progress: Any) -> Model:
    """The model of geometries of shapely, in the reference system of the column that they come from."""
    system = _system_of(crs)
    if system is None:
        from coface.interop import shapely

        return shapely.to_model(geometries)
    features = [{"type": "Feature", "properties": {}, "geometry": one.__geo_interface__} for one in geometries]
    name = {"type": "name", "properties": {"name": system}}
    return _of_geojson({"type": "FeatureCollection", "features": features, "crs": name}, progress)


def is_features(x: Any) -> bool:
    """Whether this is a table of features, such as a ``GeoDataFrame`` or a ``GeoSeries``: with geometries, and properties if it has any."""
    return hasattr(x, "__geo_interface__") and (hasattr(x, "iloc") or hasattr(x, "geom_type") and not hasattr(x, "wkt"))


def _is_list_of_ids(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(one, (int, np.integer)) for one in value)


def _plain(value: Any) -> Any:
    """A value as JSON: times and dates as text of ISO 8601, what is missing as null, fractions of ten as numbers."""
    if isinstance(value, np.datetime64):
        return None if np.isnat(value) else str(value)
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if hasattr(value, "isoformat"):
        text = value.isoformat()
        return None if text == "NaT" else text
    if type(value).__name__ in ("NAType", "NaTType"):
        return None
    if isinstance(value, Decimal):
        return float(value)
    if isinstance(value, (UUID, Path)):
        return str(value)
    raise_invalid(f"a {type(value).__name__} cannot be written as JSON", "make it a number, a text, a date, a list or a dictionary, or leave its column out")


@in_words
def as_complex(x: Any, *, progress: Any = None) -> Complex:
    """Whatever describes a space of simplices, as a simplicial complex.

    Parameters
    ----------
    x
        As in :func:`as_model`; its cells have to be simplices.

    Returns
    -------
    Complex
        The facets with all their faces.

    Examples
    --------
    >>> import coface
    >>> coface.as_complex([[0, 1, 2], [2, 3]]).f_vector
    (4, 4, 1)
    """
    return x if isinstance(x, Complex) else as_model(x, progress=progress).complex(progress=progress)


@in_words
def as_chain_complex(x: Any, *, progress: Any = None) -> ChainComplex:
    """Whatever describes a space, as a chain complex.

    Parameters
    ----------
    x
        As in :func:`as_model`; also a multigraph of networkx with parallel edges and loops, and a list of boundary matrices, the one of
        degree 1 first.

    Returns
    -------
    ChainComplex
        Its cells are named by the vertices of the model where there is one. Of an answer it has the cells that its ``f_vector`` counts: a
        :class:`PlanarBoolean` is the region, a :class:`SolidBoolean` its surface (:attr:`SolidBoolean.cells` are the solid), a bounded
        :class:`YinSet` the closed set.

    Raises
    ------
    InvalidInputError
        Also for a square matrix that may be the adjacency matrix of a graph.

    Examples
    --------
    >>> import coface
    >>> coface.as_chain_complex([[0, 1], [1, 2], [0, 2]]).homology().betti_numbers
    (1, 1)
    """
    if isinstance(x, ChainComplex):
        return x
    if isinstance(x, LarModel):
        return x.chain_complex(progress=progress)
    if hasattr(x, "tocsc"):
        _refuse_graph(x)
    x = plain(x) if not hasattr(x, "tocsc") else [x]
    if isinstance(x, (list, tuple)) and len(x) and hasattr(x[0], "tocsc"):
        return ChainComplex.from_boundaries(list(x))
    if hasattr(x, "is_multigraph") and hasattr(x, "nodes"):
        from coface.interop import networkx

        return networkx.to_chain_complex(x)
    if isinstance(x, Complex):
        return x.chain_complex(progress=progress)
    return as_cells(x, progress=progress).chain_complex(progress=progress)


def _refuse_graph(matrix: Any) -> None:
    """Refuses a sparse matrix that may be the boundary matrix of edges, or the adjacency matrix of a graph."""
    rows, columns = matrix.shape
    found = matrix.tocoo()
    is_off = (found.row != found.col) & (found.data != 0)
    if rows != columns or not is_off.any():
        return
    is_symmetric = (matrix != matrix.T).nnz == 0
    is_of_lengths = not (found.data < 0).any() and not found.data[found.row == found.col].any()
    if is_symmetric or is_of_lengths:
        raise_invalid(
            f"a square matrix of shape {(rows, columns)} may be a boundary matrix or the adjacency matrix of a graph",
            "say which: coface.ChainComplex.from_boundaries([matrix]), or networkx.from_scipy_sparse_array(matrix)",
        )


@in_words
def as_surface(x: Any, *, boundary: bool = False, progress: Any = None) -> Surface:
    """Whatever describes a surface, as halfedges.

    Parameters
    ----------
    x
        As in :func:`as_model`: each edge in one or two faces, the faces around each vertex one fan.
    boundary
        Whether the boundary surface of a volume is meant.

    Returns
    -------
    Surface
        The surface.

    Raises
    ------
    NonManifoldError
        If it is not a surface; ``.cells`` names the place.

    Examples
    --------
    >>> import coface
    >>> coface.as_surface([[0, 1, 2], [0, 2, 3]]).f_vector
    (4, 5, 2)
    """
    if isinstance(x, Surface) and not boundary:
        return x
    if isinstance(x, PlanarBoolean):
        # Polygons with holes as triangles.
        return Surface(Model.from_bytes(x.to_bytes("obj"), "obj"), progress=progress)
    return Surface(as_drawn(x, progress=progress), boundary=boundary, progress=progress)
