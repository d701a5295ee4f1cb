"""Maps changed feature by feature: repaired, buffered, clipped, simplified; lines noded; coverages checked.

Each function takes what :func:`coface.as_model` understands, such as a ``GeoDataFrame``, and gives a :class:`coface.Model`; features keep
their order, properties and ids. What was assumed or changed is in ``warnings`` of the model. ``__geo_interface__`` of it, or
``GeoDataFrame.from_features``, has the features.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

from coface import _coface
from coface._answers import FactsAnswer
from coface._coface import Model
from coface._faults import in_words
from coface._questions import _inputs

__all__ = ["buffer", "clip", "coverage", "node", "polygonize", "repair", "simplify"]


@in_words
def repair(*models: Any, method: str = "structure", progress: Any = False) -> Model:
    """Polygons made valid as OGC says, with rings as RFC 7946 has them: outer ones counterclockwise, holes clockwise.

    Parameters
    ----------
    *models
        The maps.
    method
        What is inside of a polygon that is not valid: ``"structure"`` (outer rings minus holes) or ``"linework"`` (what lies behind an odd
        number of lines), as GEOS names them.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        The map. Valid polygons keep their coordinates.

    Examples
    --------
    >>> import coface
    >>> tie = coface.Model.from_bytes(b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", "wkt")
    >>> coface.maps.repair(tie).__geo_interface__["features"][0]["geometry"]["type"]
    'MultiPolygon'
    """
    return _coface.map_task(_inputs(models), "repair", method=method, progress=progress)[0]


@in_words
def buffer(
    *models: Any,
    distance: float,
    error: float | None = None,
    joins: str = "round",
    mitre_limit: float = 5.0,
    caps: str = "round",
    progress: Any = False,
) -> Model:
    """What is at most a distance away from each feature; below 0, what is inside and at least so far from the border.

    Parameters
    ----------
    *models
        The maps.
    distance
        The distance, in the unit of the maps.
    error
        How far flattened arcs may be from true ones; a thousandth of the distance if left out.
    joins
        How corners are joined: ``"round"``, ``"mitre"`` or ``"bevel"``.
    mitre_limit
        How many times the distance a mitred corner may be away; beyond it is cut off.
    caps
        How the ends of lines are closed: ``"round"``, ``"flat"`` or ``"square"``.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        A map with one buffer for each feature.

    Examples
    --------
    >>> import coface
    >>> square = coface.Model.from_bytes(b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "wkt")
    >>> coface.maps.buffer(square, distance=1, joins="mitre").vertex_count
    4
    """
    return _coface.map_task(
        _inputs(models),
        "buffer",
        length=distance,
        error=error,
        joins=joins,
        mitre_limit=mitre_limit,
        caps=caps,
        progress=progress,
    )[0]


@in_words
def clip(*models: Any, box: Sequence[float], progress: Any = False) -> Model:
    """What of each feature is in a box along the axes.

    Parameters
    ----------
    *models
        The maps.
    box
        Least x, least y, greatest x, greatest y.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        The map. Features outside of the box are left out.

    Examples
    --------
    >>> import coface
    >>> line = coface.Model.from_bytes(b"LINESTRING (0 0, 4 4)", "wkt")
    >>> coface.maps.clip(line, box=(1, 1, 2, 3)).vertices.tolist()
    [[1.0, 1.0], [2.0, 2.0]]
    """
    return _coface.map_task(_inputs(models), "clip", frame=list(box), progress=progress)[0]


@in_words
def node(
    *models: Any, snap: bool = False, grid: float | None = None, tolerance: float | None = None, progress: Any = False
) -> Model:
    """All lines and rings cut where they meet: each piece between two meetings is a line.

    Parameters
    ----------
    *models
        The maps.
    snap
        Whether coordinates are rounded and lines cut again until all vertices are where their coordinates say.
    grid
        All coordinates are multiples of this length.
    tolerance
        Vertices and lines at most so far apart are put together, in the unit of the map; not with `grid`.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        The lines, each a feature. What several run along is there once.

    Examples
    --------
    >>> import coface
    >>> cross = coface.Model.from_bytes(b"LINESTRING (0 0, 2 2)\\nLINESTRING (0 2, 2 0)", "wkt")
    >>> len(coface.maps.node(cross).__geo_interface__["features"])
    4
    """
    return _coface.map_task(_inputs(models), "node", snap=snap, grid=grid, tolerance=tolerance, progress=progress)[0]


@in_words
def polygonize(
    *models: Any, snap: bool = False, grid: float | None = None, tolerance: float | None = None, progress: Any = False
) -> Model:
    """The faces that lines and rings bound, cut where they meet.

    Parameters
    ----------
    *models
        The maps.
    snap
        Whether coordinates are rounded and lines cut again until all vertices are where their coordinates say.
    grid
        All coordinates are multiples of this length.
    tolerance
        Vertices and lines at most so far apart are put together, in the unit of the map; not with `grid`.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        The polygons, each a feature. ``warnings`` counts the edges that bound nothing.

    Examples
    --------
    >>> import coface
    >>> lines = coface.Model.from_bytes(b"LINESTRING (0 0, 2 0, 2 2, 0 0)\\nLINESTRING (1 -1, 1 3)", "wkt")
    >>> len(coface.maps.polygonize(lines).__geo_interface__["features"])
    2
    """
    return _coface.map_task(_inputs(models), "polygonize", snap=snap, grid=grid, tolerance=tolerance, progress=progress)[0]


@in_words
def simplify(*models: Any, tolerance: float, progress: Any = False) -> Model:
    """Fewer vertices: common borders stay common, and nothing crosses, vanishes or changes sides.

    Parameters
    ----------
    *models
        The maps.
    tolerance
        How far a border may be from where it was, in the unit of the maps.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    Model
        The map.

    Examples
    --------
    >>> import coface
    >>> line = coface.Model.from_bytes(b"LINESTRING (0 0, 1 0.1, 2 0)", "wkt")
    >>> coface.maps.simplify(line, tolerance=0.2).vertex_count
    2
    """
    return _coface.map_task(_inputs(models), "simplify", length=tolerance, progress=progress)[0]


@in_words
def coverage(*models: Any, gap_width: float | None = None, progress: Any = False) -> dict[str, Any]:
    """Whether polygons fit together: gaps, overlaps, and sides that do not fit those of their neighbors.

    Parameters
    ----------
    *models
        The maps.
    gap_width
        Gaps up to this width are faults, in the unit of the maps; none is if left out.
    progress
        As for :func:`coface.homology`.

    Returns
    -------
    dict
        ``valid``, ``invalid_edges`` (how many sides), ``overlaps`` and ``gaps`` (each with ``features``, ``area``, ``point``), and ``edges``, a
        Model of the sides that do not fit, feature by feature.

    Examples
    --------
    >>> import coface
    >>> text = b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\\nPOLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))"
    >>> found = coface.maps.coverage(coface.Model.from_bytes(text, "wkt"))
    >>> found["valid"], [part["area"] for part in found["overlaps"]]
    (False, [2.0])
    """
    model, answer = _coface.map_task(_inputs(models), "coverage", length=gap_width, progress=progress)
    return FactsAnswer({**cast("dict[str, Any]", answer["coverage"]), "edges": model})
