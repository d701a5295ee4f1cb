"""Voxels: arrays and files of numbers, of which some set their voxels."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import Model, _read_volume, _volume


def volume(
    x: Any,
    *,
    threshold: float | None = None,
    below: float | None = None,
    between: tuple[float, float] | None = None,
    value: float | None = None,
    periodic: Sequence[int] = (),
    progress: Any = None,
) -> Model:
    """The cubical complex of the voxels that are set, with all their faces.

    Parameters
    ----------
    x : array_like or path
        An array of numbers or truth values with 1 to 8 axes; or a file: ``.npy``, NRRD or NIfTI.
    threshold : float, optional
        Set voxels of this number and above. Without any rule those not 0 are set; NaN never is.
    below : float, optional
        Set voxels below this number.
    between : (float, float), optional
        Set voxels from the first number to the second.
    value : float, optional
        Set voxels of this number, a label.
    periodic : sequence of int
        The axes whose last voxel meets their first.
    progress
        As in :func:`read`, for a file.

    Returns
    -------
    Model
        A model of structure ``volume``; cells are numbered by their places, the last axis fastest.

    Raises
    ------
    InvalidInputError
        For more than one rule, an axis that is not there, an array without axes.

    Examples
    --------
    A ring of voxels; and a torus, whose voxels are all set and whose axes close up.

    >>> import coface, numpy as np
    >>> ring = np.ones((3, 3)); ring[1, 1] = 0
    >>> coface.homology(coface.volume(ring))
    Homology(Z, Z)
    >>> coface.homology(coface.volume(np.ones((4, 4, 4)), periodic=[0, 1, 2]))
    Homology(Z, Z^3, Z^3, Z)
    """
    rules = {"threshold": threshold, "below": below, "between": between, "value": value}
    given = {name: bounds for name, bounds in rules.items() if bounds is not None}
    if len(given) > 1:
        raise_invalid(f"{' and '.join(given)} are given together", "give one rule for voxels")
    axes = [int(axis) for axis in periodic]
    if any(axis < 0 for axis in axes):
        raise_invalid(f"axis {min(axes)} is negative", "number axes from 0")
    if isinstance(x, (str, os.PathLike)):
        rule, bounds = next(iter(given.items()), ("nonzero", 0.0))
        low, high = (float(bound) for bound in (bounds if isinstance(bounds, (tuple, list)) else (bounds, bounds)))
        return _read_volume(x, rule, (low, high), axes, progress)
    array = np.asarray(x)
    if array.dtype.kind not in "biuf":
        raise_invalid(f"an array of {array.dtype} has no numbers to compare", "give numbers or truth values")
    if array.ndim == 0:
        raise_invalid("an array without axes has no voxels", "give an array with 1 to 8 axes")
    return _volume(np.ascontiguousarray(_is_set(array, threshold, below, between, value)), axes)


def _is_set(
    array: np.ndarray[Any, Any],
    threshold: float | None,
    below: float | None,
    between: tuple[float, float] | None,
    value: float | None,
) -> Any:
    if threshold is not None:
        return array >= threshold
    if below is not None:
        return array < below
    if between is not None:
        return (array >= between[0]) & (array <= between[1])
    if value is not None:
        return array == value
    return (array != 0) & ~np.isnan(array) if array.dtype.kind == "f" else array.astype(np.bool_)
