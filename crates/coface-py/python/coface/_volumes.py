"""Voxels: arrays and files of numbers, of which some set their voxels."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from typing import Any

import numpy as np

from coface._arrays import plain, raise_invalid
from coface._coface import InvalidTypeError, Model, _read_volume, _volume
from coface._faults import in_words


@in_words
def volume(
    x: Any,
    *,
    threshold: float | None = None,
    below: float | None = None,
    between: tuple[float, float] | None = None,
    value: float | None = None,
    periodic: Sequence[int] = (),
    allow_outside: bool = False,
    progress: Any = None,
) -> Model:
    """The cubical complex of the voxels that are set, with all their faces.

    Parameters
    ----------
    x : array_like or path
        An array of numbers or truth values with 1 to 8 axes, of which masked ones are not set; or a file: ``.npy``, NRRD, NIfTI, MetaImage, PGM
        or PNG.
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
    allow_outside, progress
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
    rule, bounds, axes = voxel_rule(threshold=threshold, below=below, between=between, value=value, periodic=periodic)
    if isinstance(x, (str, os.PathLike)):
        return _read_volume(x, (rule, bounds, axes), allow_outside, progress)
    # What is masked is outside.
    outside = np.ma.getmaskarray(x) if np.ma.is_masked(x) else None
    array = np.asarray(plain(x if outside is None else np.ma.getdata(x)))
    if array.dtype.kind not in "biuf":
        raise_invalid(f"an array of {array.dtype} has no numbers to compare", "give numbers or truth values")
    if array.ndim == 0:
        raise_invalid("an array without axes has no voxels", "give an array with 1 to 8 axes")
    is_set = _is_set(array, rule, bounds)
    return _volume(np.ascontiguousarray(is_set if outside is None else is_set & ~outside), axes)


def voxel_rule(
    *,
    threshold: float | None = None,
    below: float | None = None,
    between: tuple[float, float] | None = None,
    value: float | None = None,
    periodic: Sequence[int] = (),
) -> tuple[str, tuple[float, float], list[int]]:
    """Which voxels are set, in the words of the compiled part: the name of the rule, its bounds, and the axes that close up."""
    rules = {"threshold": threshold, "below": below, "between": between, "value": value}
    given = {name: bounds for name, bounds in rules.items() if bounds is not None}
    if len(given) > 1:
        raise_invalid(f"{' and '.join(given)} are given together", "give one rule for voxels")
    name, bounds = next(iter(given.items()), ("nonzero", 0.0))
    pair = tuple(bounds) if isinstance(bounds, (tuple, list, np.ndarray)) else (bounds, bounds)
    is_pair = isinstance(bounds, (tuple, list, np.ndarray))
    if is_pair != (name == "between") or len(pair) != 2 or not all(_is_number(bound) for bound in pair):
        wanted = "two numbers: between=(0.2, 0.8)" if name == "between" else f"a number: {name}=0.5"
        message, cure = f"{name} is {bounds!r}", f"give {wanted}"
        raise InvalidTypeError(f"{message}; {cure}", fault=message, cure=cure)
    low, high = (float(bound) for bound in pair)
    if math.isnan(low) or math.isnan(high):
        raise_invalid(f"{name} is no number", "give a number to compare voxels with")
    if low > high:
        raise_invalid(f"no number is between {low} and {high}", "give the lower bound first")
    listed = plain(periodic)
    if not isinstance(listed, (list, tuple, range, np.ndarray)) or not all(isinstance(axis, (int, np.integer)) and not isinstance(axis, bool) for axis in listed):
        message, cure = f"periodic is {periodic!r}", "give the axes that close up by their numbers: periodic=[0, 1]"
        raise InvalidTypeError(f"{message}; {cure}", fault=message, cure=cure)
    axes = [int(axis) for axis in listed]
    if any(axis < 0 for axis in axes):
        raise_invalid(f"axis {min(axes)} is negative", "number axes from 0")
    return name, (low, high), axes


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)


def _is_set(array: np.ndarray[Any, Any], rule: str, bounds: tuple[float, float]) -> Any:
    """The truth values of voxels. Bounds have 64 bits, and integers are compared with them exactly, as in files."""
    if array.dtype.kind == "b":
        array = array.astype(np.uint8)
    is_integral = array.dtype.kind in "iu"

    def rounded(bound: float, up: bool) -> Any:
        if is_integral and math.isfinite(bound):
            return math.ceil(bound) if up else math.floor(bound)
        return np.float64(bound)

    low, high = rounded(bounds[0], True), rounded(bounds[1], False)
    if rule == "threshold":
        return array >= low
    if rule == "below":
        return array < low
    if rule == "between":
        return (array >= low) & (array <= high)
    if rule == "value":
        if is_integral:
            return (array >= low) & (array <= high)
        # Of short numbers the one next to it.
        return array == array.dtype.type(bounds[0])
    return (array != 0) & (array == array)
