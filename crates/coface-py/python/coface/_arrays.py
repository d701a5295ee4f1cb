"""Models as plain arrays: what the conversions to other libraries are built on."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, KeysView, Sequence, ValuesView
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from coface._coface import Model

Ids = NDArray[np.int64]
Points = NDArray[np.float64]

#: The corners of a cell of each kind, in the words of meshio; the order of the corners is that of VTK.
CORNERS = {
    "vertex": 1,
    "line": 2,
    "triangle": 3,
    "quad": 4,
    "tetra": 4,
    "pyramid": 5,
    "wedge": 6,
    "hexahedron": 8,
}
#: What to do with masked entries where nothing can be left out.
MASKED = "leave them out or give them numbers with array.filled(..); only coface.volume and coface.cubical take them, as outside"
#: Why data of cells are left out.
MIXED = "which are taken where all cells are faces, or all are 3-cells"
#: The kinds of 3-cells.
SOLID = ("tetra", "pyramid", "wedge", "hexahedron")


def ragged(lists: Any) -> tuple[Ids, Ids]:
    """All members one after the other, and where each list begins and the last ends.

    Examples
    --------
    >>> ragged([[0, 1, 2], [2, 3]])
    (array([0, 1, 2, 2, 3]), array([0, 3, 5]))
    >>> ragged(np.array([[0, 1, 2], [2, 1, 3]]))[1]
    array([0, 3, 6])
    """
    if isinstance(lists, tuple) and len(lists) == 2:
        return np.asarray(lists[0], np.int64), np.asarray(lists[1], np.int64)
    if isinstance(lists, np.ndarray) and lists.ndim == 2:
        flat = np.ascontiguousarray(lists, np.int64).reshape(-1)
        return flat, np.arange(len(lists) + 1, dtype=np.int64) * lists.shape[1]
    each = [np.asarray(one, np.int64).reshape(-1) for one in lists]
    offsets = np.zeros(len(each) + 1, np.int64)
    np.cumsum([len(one) for one in each], out=offsets[1:])
    return (np.concatenate(each) if each else np.zeros(0, np.int64)), offsets


def blocks(flat: Ids, offsets: Ids) -> Iterable[tuple[int, Ids]]:
    """The lists of each length as one array, the shortest first.

    Examples
    --------
    >>> for length, block in blocks(*ragged([[0, 1, 2, 3], [0, 1, 4], [4, 1, 2]])):
    ...     print(length, block.tolist())
    3 [[0, 1, 4], [4, 1, 2]]
    4 [[0, 1, 2, 3]]
    """
    lengths = np.diff(offsets)
    for length in np.unique(lengths):
        begins = offsets[:-1][lengths == length]
        yield int(length), flat[begins[:, None] + np.arange(length)]


def lists(flat: Ids, offsets: Ids) -> list[Ids]:
    """Each list as an array of its own."""
    return [flat[begin:end] for begin, end in zip(offsets[:-1], offsets[1:])]


def padded(flat: Ids, offsets: Ids) -> Ids:
    """The lists with their lengths before them, one after the other, as VTK has them.

    Examples
    --------
    >>> padded(*ragged([[0, 1, 2], [2, 3]]))
    array([3, 0, 1, 2, 2, 2, 3])
    """
    return np.insert(flat, offsets[:-1], np.diff(offsets))


def unpadded(values: Any) -> tuple[Ids, Ids]:
    """The opposite of :func:`padded`.

    Examples
    --------
    >>> unpadded([3, 0, 1, 2, 2, 2, 3])
    (array([0, 1, 2, 2, 3]), array([0, 3, 5]))
    """
    values = np.asarray(values, np.int64).reshape(-1)
    if len(values) and len(values) % (values[0] + 1) == 0:
        rows = values.reshape(-1, values[0] + 1)
        if (rows[:, 0] == values[0]).all():
            return ragged(rows[:, 1:])
    begins = []
    place = 0
    while place < len(values):
        begins.append(place)
        place += int(values[place]) + 1
    offsets = np.array([*begins, len(values)], np.int64) - np.arange(len(begins) + 1)
    return np.delete(values, begins), offsets


def polygons(model: Model) -> tuple[Ids, Ids]:
    """The faces of a model, flat and offsets."""
    return ragged(model.faces)


def steps(model: Model) -> Ids:
    """The lines of a model, each step from one vertex to the next: an array of pairs."""
    flat, offsets = ragged(model.lines)
    keep = np.ones(len(flat), bool)
    keep[offsets[1:][np.diff(offsets) > 0] - 1] = False
    begins = np.flatnonzero(keep)
    return np.column_stack([flat[begins], flat[begins + 1]]) if len(begins) else np.zeros((0, 2), np.int64)


def refuse_unplaced(points: Points, purpose: str) -> None:
    """Nothing, unless a coordinate is NaN or infinite, as those of files may be.

    Raises
    ------
    coface.InvalidInputError
        Naming the first such vertex.
    """
    unplaced = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(unplaced):
        raise_invalid(
            f"{purpose} needs finite coordinates, and v{unplaced[0]} is at {points[unplaced[0]].tolist()}",
            "give it finite coordinates; coface.render and coface.view leave such vertices out",
        )


def positions(model: Model, purpose: str) -> Points:
    """Where the vertices are, in space.

    Raises
    ------
    coface.InvalidInputError
        If the model has no coordinates, one that is not finite, or its space more than three dimensions.
    """
    found = model.vertices
    if found is None:
        raise_invalid(f"{purpose} needs coordinates, and this model has none", "give vertices to Model.from_arrays")
    points = np.asarray(found, np.float64)
    refuse_unplaced(points, purpose)
    if points.shape[1] > 3:
        raise_invalid(
            f"{purpose} needs points of space, and these have {points.shape[1]} coordinates",
            "choose three of them: Model.from_arrays(model.vertices[:, :3], model.faces)",
        )
    if points.shape[1] < 3:
        points = np.pad(points, [(0, 0), (0, 3 - points.shape[1])])
    return points


def triangles(model: Model, purpose: str) -> Ids:
    """The faces of a model, which have to be triangles.

    Raises
    ------
    coface.InvalidInputError
        If there is a face with more corners.
    """
    flat, offsets = polygons(model)
    sizes = np.diff(offsets)
    if (sizes != 3).any():
        first = int(np.argmax(sizes != 3))
        raise_invalid(
            f"{purpose} needs triangles, and face {first} has {sizes[first]} corners",
            "use model.triangulated()",
            [flat[offsets[first] : offsets[first + 1]].tolist()],
        )
    return flat.reshape(-1, 3)


def plain(value: Any) -> Any:
    """Tables as arrays, sets and generators as lists, everything else as it is.

    Members of sets come in rising order, and the sets in them as sorted lists.

    Raises
    ------
    coface.InvalidInputError
        For an array of which entries are masked: what stands behind a mask is no number of its owner's.

    Examples
    --------
    >>> plain({(0, 1, 2), (1, 2, 3)})
    [(0, 1, 2), (1, 2, 3)]
    >>> plain(frozenset([frozenset([2, 1]), frozenset([0])]))
    [(0,), (1, 2)]
    >>> plain(x for x in "ab")
    ['a', 'b']
    """
    if isinstance(value, (set, frozenset)):
        return sorted(tuple(sorted(one)) if isinstance(one, frozenset) else one for one in value)
    if hasattr(value, "data_vars") and hasattr(value, "to_dataarray"):
        # A data set of xarray.
        names = list(value.data_vars)
        if len(names) != 1:
            raise_invalid(
                f"a data set has the variables {', '.join(map(repr, names)) or 'none'}, and one is wanted",
                f"choose one: dataset[{(names or ['name'])[0]!r}]",
            )
        return value[names[0]].to_numpy()
    if hasattr(value, "to_numpy"):
        return value.to_numpy()
    if hasattr(value, "__next__") or isinstance(value, (KeysView, ValuesView)):
        return list(value)
    if np.ma.is_masked(value):
        raise_invalid("an array has masked entries", MASKED)
    return value


def numbers(value: Any, what: str) -> NDArray[np.float64]:
    """Real numbers in an array of any shape.

    Raises
    ------
    coface.InvalidInputError
        For what is no array of real numbers.
    """
    value = plain(value)
    try:
        found = np.asarray(value)
    except ValueError:
        found = np.empty(0, object)
    if found.dtype.kind not in "biuf" and (found.size or found.dtype.kind == "O"):
        raise_invalid(f"{what} are no array of numbers", "give real numbers")
    return found.astype(np.float64)


def raise_invalid(message: str, cure: str, cells: Sequence[Sequence[int]] = ()) -> NoReturn:
    """Raise :class:`coface.InvalidInputError` with what is wrong and what to do about it."""
    from coface._coface import InvalidInputError

    raise InvalidInputError(f"{message}; {cure}", fault=message, cure=cure, cells=cells)


def point_rows(points: Any, weights: Any = None) -> NDArray[np.float64]:
    """Points with their weights behind them, if they have weights."""
    rows = numbers(points, "points")
    if rows.size == 0:
        return np.empty((0, 0))
    if rows.ndim != 2:
        raise_invalid(f"points have the shape {rows.shape}", "give an array of two axes, a row for each point")
    if weights is None:
        rows.flags.writeable = False
        return rows
    behind = numbers(weights, "weights")
    if behind.shape != (len(rows),):
        raise_invalid(f"weights have the shape {behind.shape} for {len(rows)} points", "give one weight for each point")
    return np.column_stack([rows, behind])


def with_numbers(model: Model, values: Any, on: str, count: int) -> Model:
    """The model with the arrays of a mapping as data on its vertices or faces; a warning names those that are no numbers, one row for each."""
    left_out = []
    for name, given in dict(values).items():
        array = np.asarray(given)
        is_integer = array.dtype.kind in "biu"
        exceeds = is_integer and array.size and int(array.max()) > np.iinfo(np.int64).max
        if array.dtype.kind not in "biuf" or array.ndim == 0 or len(array) != count or not array.size or exceeds:
            left_out.append(name)
        else:
            model = model.with_data(str(name), array.astype(np.int64 if is_integer else np.float64), on)
    warn_of_data_left_out(left_out, on, "which are no numbers of 64 bits, one row for each")
    return model


def warn_of_data_left_out(names: Iterable[Any], on: str, why: str) -> None:
    """A warning that names data that are left out; none if there are none."""
    left_out = ", ".join(repr(str(name)) for name in names)
    if left_out:
        from coface._coface import AssumptionWarning

        warnings.warn(f"left out of the data of the {on}: {left_out}, {why}", AssumptionWarning, stacklevel=4)


def numbers_on(model: Model, on: str) -> dict[str, Any]:
    """The data of a model on its vertices or faces, by name."""
    return {name: np.asarray(values) for name, place, values in model.data if place == on}
