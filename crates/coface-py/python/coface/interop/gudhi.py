"""gudhi: simplex trees."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._coface import ChainComplex, Complex, Model
from coface._arrays import raise_invalid
from coface.interop import needed


def simplices(value: Any) -> dict[int, tuple[Any, Any]]:
    """The simplices of a tree by dimension: arrays ``(m, dimension + 1)`` of vertices, and their filtration values."""
    if not hasattr(value, "get_simplices"):
        cure = "call its create_simplex_tree()" if hasattr(value, "create_simplex_tree") else "ask coface.cubical(x) for the array that it was made of"
        raise_invalid(f"gudhi's {type(value).__name__} is no simplex tree", cure)
    found: dict[int, tuple[list[Any], list[float]]] = {}
    for simplex, level in value.get_simplices():
        rows, levels = found.setdefault(len(simplex) - 1, ([], []))
        rows.append(simplex)
        levels.append(level)
    return {
        dimension: (np.array(rows, np.int64), np.array(levels, np.float64))
        for dimension, (rows, levels) in sorted(found.items())
    }


def to_model(value: Any) -> Model:
    """A :class:`gudhi.SimplexTree` as a model of facets: all its simplices, whatever their filtration values.

    Vertices keep their numbers.
    """
    return Model.from_facets([simplex for rows, _ in simplices(value).values() for simplex in rows.tolist()])


def from_complex(complex: Complex, values: Any = None) -> Any:
    """A complex as :class:`gudhi.SimplexTree`.

    Parameters
    ----------
    values
        A number for each vertex: a simplex comes with the last of its vertices (the lower star filtration). Without it all come at 0.
    """
    library = needed("gudhi", "to_gudhi")
    tree = library.SimplexTree()
    levels = None if values is None else np.asarray(values, np.float64)
    last = int(np.asarray(complex.vertices).max(initial=-1))
    if levels is not None and (levels.ndim != 1 or len(levels) <= last):
        raise_invalid(f"values have the shape {levels.shape}", f"give a number for each vertex, indexed by its id: an array of shape ({last + 1},)")
    for dimension in range((-1 if complex.dimension is None else complex.dimension) + 1):
        rows = np.asarray(complex.simplices(dimension))
        at = np.zeros(len(rows)) if levels is None else levels[rows].max(axis=1)
        tree.insert_batch(np.ascontiguousarray(rows.T).astype(np.int32), at)
    return tree


def values(tree: Any, complex: ChainComplex) -> list[Any]:
    """The filtration values of a tree in the order of the cells of its complex."""
    found = simplices(tree)
    ordered = []
    for degree in range(1 + max(found, default=-1)):
        rows, levels = found[degree]
        rows = np.sort(rows, axis=1)
        cells = np.sort(np.asarray(complex.simplices(degree)), axis=1)
        # Both are brought into one order.
        placed = np.empty(len(cells))
        placed[np.lexsort(cells.T[::-1])] = levels[np.lexsort(rows.T[::-1])]
        ordered.append(placed)
    return ordered
