"""Interfaces: sets of the plane as phases that share the arcs between them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from coface import _coface
from coface._coface import Interface, Model, YinSet
from coface._arrays import raise_invalid
from coface._faults import in_words
from coface._models import as_model
from coface._records import asked


@in_words
def interface(
    x: Any,
    *,
    overlaps: str = "refuse",
    smooth: float = 1.0,
    order: int | None = None,
    progress: Any = False,
) -> Interface:
    """Sets that lie side by side as phases of one interface, which share the arcs between them.

    Parameters
    ----------
    x
        A dictionary of names to :class:`YinSet` or models in the plane, or a list of these; an image of labels, an integer array of shape (rows, columns) with
        the highest row first, whose pixels are unit squares from the origin and whose label 0 is no phase; or a map, such as a
        ``GeoDataFrame`` or anything that :func:`as_model` understands, each of whose features is a phase.
    overlaps
        Where points go that several sets have in common: ``"refuse"`` is an error, ``"first"`` and ``"last"`` give them to one of these.
    smooth
        By how many degrees edges may turn at a junction and still go on smoothly into each other.
    order
        Of a map, the order of its curves: 2, 4, 6 or 8.
    progress
        As for :func:`homology`.

    Returns
    -------
    Interface
        Phases with areas and neighbors, edges with lengths, junctions with types.

    Raises
    ------
    InvalidInputError
        If sets overlap, with the place.

    Examples
    --------
    Two rooms side by side in a picture of labels:

    >>> import coface, numpy as np
    >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    >>> rooms.names, rooms.areas, rooms.neighbors
    (['1', '2'], [4.0, 2.0], [(0, 1, 2.0)])
    >>> [junction["kind"] for junction in rooms.junctions]
    ['t', 't']
    """
    named = _named_sets(x, order)
    found: Interface = asked(
        "interface",
        [str(name) for name, _ in named],
        [set for _, set in named],
        overlaps,
        float(smooth),
        progress=progress,
    )
    return found


def _as_set(x: YinSet | Model, order: int | None) -> YinSet:
    return x if isinstance(x, YinSet) else YinSet.from_model(x, order=order)


def _named_sets(x: Any, order: int | None) -> list[tuple[Any, YinSet]]:
    cure = "give YinSets, an array of labels, or a map"
    if isinstance(x, Mapping) and all(isinstance(value, (YinSet, Model)) for value in x.values()):
        return [(name, _as_set(value, order)) for name, value in x.items()]
    if isinstance(x, (list, tuple)) and x and all(isinstance(value, (YinSet, Model)) for value in x):
        return [(place, _as_set(value, order)) for place, value in enumerate(x)]
    if isinstance(x, YinSet):
        return [(0, x)]
    if isinstance(x, np.ndarray):
        if x.ndim != 2 or x.dtype.kind not in "iub":
            raise_invalid(f"labels have the shape {x.shape} and the type {x.dtype}", "give integers of shape (rows, columns)")
        if x.size and (int(x.min()) < 0 or int(x.max()) >= 1 << 32):
            raise_invalid("labels are below 0 or above 2^32 - 1", "give numbers from 0, for what is in no phase")
        return list(_coface._label_sets(x.shape[1], x.reshape(-1).tolist()))
    found = _coface._feature_sets(as_model(x), order)
    if found is None:
        raise_invalid("the curves bound one set", cure)
    return list(found)
