"""Euler characteristics of what has entered, and along directions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from coface import _coface
from coface._arrays import numbers, plain, raise_invalid
from coface._faults import in_words
from coface._models import as_cells, as_chain_complex
from coface._questions import _at_cells, _at_vertices, _held, image_of
from coface._volumes import voxel_rule


@in_words
def euler_curve(
    x: Any,
    vertex_values: Any = None,
    *,
    cell_values: Sequence[Any] | None = None,
    upper: bool = False,
    construction: Literal["t", "v"] = "t",
    superlevel: bool = False,
    periodic: Sequence[int] = (),
    mask: Any = None,
    at: Any = None,
    smooth: bool = False,
    progress: Any = False,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The Euler characteristic of what has entered, at each value: counted, without homology.

    Parameters
    ----------
    x
        With values, anything that :func:`as_chain_complex` understands. Without values an image, as for :func:`cubical`.
    vertex_values, cell_values, upper
        As for :func:`persistence`.
    construction, superlevel, periodic, mask
        As for :func:`cubical`.
    at
        Values, or the number of values from the first at which something enters to the last; all steps if not given.
    smooth
        Whether the numbers are the integrals of what the characteristic is above its mean over the range of the values.
    progress
        As for :func:`homology`.

    Returns
    -------
    tuple of numpy.ndarray
        The values and the numbers at them.

    Examples
    --------
    A path that goes up to 2 and down to 1: its second end is a piece of its own at 1.

    >>> import coface
    >>> values, characteristics = coface.euler_curve([[0, 1], [1, 2]], [0.0, 2.0, 1.0])
    >>> values.tolist(), characteristics.tolist()
    ([0.0, 1.0, 2.0], [1.0, 2.0, 1.0])
    >>> coface.euler_curve([[1, 2, 1], [2, 9, 2], [1, 2, 1]])[1].tolist()
    [4.0, 0.0, 1.0]
    """
    if vertex_values is None and cell_values is None:
        if upper:
            raise_invalid("upper is for values of vertices", "give superlevel=True for an image")
        if hasattr(x, "chain_complex"):
            raise_invalid("a model needs values", 'give vertex_values, such as "z" or a number for each vertex, or cell_values; or ask coface.euler_transform(x)')
        values, inside = image_of(x, mask)
        _, _, axes = voxel_rule(periodic=periodic)
        return _coface._euler_curve_of_image(
            values, construction=construction, superlevel=superlevel, periodic=axes, mask=inside, at=at, smooth=smooth, progress=progress
        )
    if superlevel or mask is not None or len(tuple(periodic)) > 0:
        raise_invalid("superlevel, mask and periodic are for images", "leave the values out for the image's own, or give upper=True")
    x = _held(x, progress)
    complex = as_chain_complex(x, progress=progress)
    if cell_values is not None:
        if upper:
            raise_invalid("values of cells fall only where those of vertices do: upper=True is for vertex_values", "give the negative of each")
        cell_values = [_at_cells(values, degree, complex) for degree, values in enumerate(cell_values)]
    if vertex_values is not None:
        vertex_values = _at_vertices(vertex_values, x, complex)
    return _coface._euler_curve(
        complex, vertex_values=vertex_values, cell_values=cell_values, upper=upper, at=at, smooth=smooth, progress=progress
    )


@in_words
def euler_transform(
    x: Any, directions: Any = 64, *, at: Any = None, normalize: bool = False, smooth: bool = False, progress: Any = False
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The Euler characteristic transform: along each direction the Euler characteristic of the cells below each height.

    Parameters
    ----------
    x
        A model with positions: anything that :func:`as_model` understands. Of a volume the model of its set voxels.
    directions
        How many, spread evenly on the circle or the sphere, or an array with a row for each.
    at
        Heights, or their number; 100 from one end of all heights that there can be to the other if not given.
    normalize
        Whether heights are measured from the middle of the box of the vertices, in units of the greatest distance from there, so that all lie from -1 to 1.
    smooth
        Whether the numbers are the integrals of what the characteristic is above its mean over the range of the heights.
    progress
        As for :func:`homology`.

    Returns
    -------
    tuple of numpy.ndarray
        The directions as rows as long as a unit, the heights, and a row of numbers for each direction.

    Examples
    --------
    A square whose middle is the origin: one corner or side comes first, and the rest changes nothing.

    >>> import coface
    >>> square = coface.Model([[-1, -1], [1, -1], [1, 1], [-1, 1]], [[0, 1, 2, 3]])
    >>> directions, heights, numbers = coface.euler_transform(square, 4, at=[-2.0, -1.0, 0.0, 1.0])
    >>> numbers[0].tolist()
    [0.0, 1.0, 1.0, 1.0]
    """
    x = _held(x, progress)
    model: Any = x if getattr(x, "vertices", None) is not None else as_cells(x, progress=progress)
    complex = as_chain_complex(model, progress=progress)
    points = model.vertices
    if points is None or np.ndim(points) != 2:
        raise_invalid("vertices have no positions, so that they have no heights", "give a model with positions")
    ids = np.asarray(complex.simplices(0)).reshape(-1)
    rows = np.ascontiguousarray(np.asarray(points, np.float64)[ids])
    if not (isinstance(directions, (int, np.integer)) and not isinstance(directions, bool)):
        directions = numbers(plain(directions), "directions")
        if directions.ndim != 2:
            raise_invalid(f"directions have the shape {directions.shape}", "give a number of directions, or an array with a row for each")
    elif directions < 1:
        raise_invalid(f"there are no {directions} directions", "give a number from 1 on")
    else:
        directions = int(directions)
    return _coface._euler_transform(complex, rows, directions, at=at, normalize=normalize, smooth=smooth, progress=progress)
