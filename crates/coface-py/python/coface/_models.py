"""What everything begins with: anything that describes a space becomes a model."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import ChainComplex, Complex, Model, Surface, _volume, read
from coface.interop import adapter_of


def as_model(x: Any, *, progress: Any = None) -> Model:
    """Whatever describes a space, as a model.

    Parameters
    ----------
    x
        One of these:

        * a :class:`Model`, :class:`Complex`, :class:`Surface` or :class:`ChainComplex`;
        * a path, or a file that is open for reading;
        * ``(vertices, faces)``: an array ``(n, d)`` of coordinates, or ``None``, and polygons as in :class:`Model`;
        * facets of a simplicial complex: a list of lists of integers, or an integer array ``(m, k)``;
        * points: an array ``(n, d)`` of floats;
        * voxels: an array of truth values, as in :func:`volume`;
        * a dictionary in the words of the JSON files: ``{"facets": ...}``, ``{"boundaries": ...}`` and so on;
        * a mesh, scene or drawing of trimesh, a mesh of meshio, a data set of pyvista or VTK, a geometry of open3d, a graph of networkx, a
          ``SimplexTree`` of gudhi, a geometry of shapely.
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
    if isinstance(x, Model):
        return x
    if type(x).__module__ == "coface" and hasattr(x, "model"):
        own = x.model
        made: Model = own() if callable(own) else own
        return made
    if isinstance(x, (str, os.PathLike)):
        return read(x, progress=progress)
    if isinstance(x, (bytes, bytearray, memoryview)):
        return Model.from_bytes(bytes(x), progress=progress)
    if isinstance(x, dict):
        return Model.from_bytes(json.dumps(x, default=_plain).encode(), "json")
    adapter = adapter_of(x)
    if adapter is not None:
        found: Model = adapter.to_model(x)
        return found
    if hasattr(x, "read"):
        data = x.read()
        return Model.from_bytes(data.encode() if isinstance(data, str) else data, progress=progress)
    if isinstance(x, np.ndarray):
        if x.dtype.kind == "b":
            return _volume(np.ascontiguousarray(x), [])
        if x.dtype.kind in "iu":
            return Model.from_facets(x)
        return Model.from_arrays(x)
    if isinstance(x, tuple) and len(x) == 2 and not _is_list_of_ids(x[0]):
        return Model.from_arrays(x[0], x[1])
    if isinstance(x, (list, tuple)):
        if x and adapter_of(x[0]) is not None and type(x[0]).__module__.startswith("shapely"):
            from coface.interop import shapely

            return shapely.to_model(list(x))
        return Model.from_facets(x)
    raise_invalid(
        f"a {type(x).__name__} is nothing that describes a space here",
        "give a path, (vertices, faces), facets, or an object that as_model names",
    )


def _is_list_of_ids(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(one, (int, np.integer)) for one in value)


def _plain(value: Any) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"a {type(value).__name__} cannot be written as JSON")


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
        Its cells are named by the vertices of the model where there is one.

    Examples
    --------
    >>> import coface
    >>> coface.as_chain_complex([[0, 1], [1, 2], [0, 2]]).homology().betti_numbers
    (1, 1)
    """
    if isinstance(x, ChainComplex):
        return x
    if isinstance(x, (list, tuple)) and len(x) and hasattr(x[0], "tocsc"):
        return ChainComplex.from_boundaries(list(x))
    if hasattr(x, "is_multigraph") and hasattr(x, "nodes"):
        from coface.interop import networkx

        return networkx.to_chain_complex(x)
    if isinstance(x, Complex):
        return x.chain_complex(progress=progress)
    return as_model(x, progress=progress).chain_complex(progress=progress)


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
    return Surface(as_model(x, progress=progress), boundary=boundary, progress=progress)
