"""Mapper complexes of points."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from coface import _coface
from coface._arrays import point_rows, raise_invalid
from coface._coface import Model
from coface._faults import in_words


@in_words
def mapper(
    points: Any,
    function: Any = 0,
    *,
    intervals: int = 10,
    overlap: float = 0.3,
    threshold: float | None = None,
) -> tuple[Model, list[NDArray[np.int64]]]:
    """The Mapper complex of a function on points: the nerve of clusters over overlapping intervals of its range.

    The clusters over an interval are the connected components of the points whose values lie in it, where points within `threshold` are neighbors; a simplex
    is a set of clusters with a point in common.

    Parameters
    ----------
    points
        An array of shape ``(points, coordinates)``.
    function
        A value for each point; the number of a coordinate; a callable that is given the array of points; or ``"eccentricity"``, the largest distance to another point.
    intervals
        How many intervals cover the range, the resolution of GUDHI's ``MapperComplex``.
    overlap
        How much of each interval lies in the next, from 0 to 0.9: the gain of GUDHI's ``MapperComplex``.
    threshold
        Within which distance points are neighbors. Without it the least distance at which all are connected is taken, and a warning says which.

    Returns
    -------
    Model
        The nerve of the clusters, at the means of their points; with data ``points``, how many points a cluster has, and ``value``, the mean of the function.
    list of numpy.ndarray
        For each vertex of the model the numbers of its points, rising.

    Examples
    --------
    A circle of points, and their heights:

    >>> import coface, numpy as np
    >>> t = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    >>> circle = np.column_stack([np.cos(t), np.sin(t)])
    >>> model, clusters = coface.mapper(circle, 1, intervals=4, threshold=0.2)
    >>> coface.homology(model).betti_numbers
    (1, 1)
    >>> [len(points) for points in clusters]
    [23, 8, 8, 8, 8, 23]
    """
    table = point_rows(points)
    if isinstance(function, str):
        if function != "eccentricity":
            raise_invalid(f"the function is {function!r}", 'give values, the number of a coordinate, or "eccentricity"')
        values = None
    elif callable(function):
        values = function(np.asarray(points, dtype=float))
    elif isinstance(function, (int, np.integer)):
        coordinates = np.asarray(points, dtype=float)
        if coordinates.ndim != 2 or not 0 <= function < coordinates.shape[1]:
            raise_invalid(f"points of shape {coordinates.shape} have no coordinate {function}", "give a smaller number, from 0, or values")
        values = coordinates[:, function]
    else:
        values = function
    return _coface.mapper(table, values, intervals=intervals, overlap=overlap, threshold=threshold)
