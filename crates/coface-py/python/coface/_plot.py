"""Pictures by matplotlib, which is imported when the first is made."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from coface._answers import is_facts, rows_of
from coface._arrays import blocks, polygons, raise_invalid, refuse_unplaced, steps
from coface._shown import shown
from coface.interop import needed
from coface._faults import in_words

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Colors of generators, curves and cells, one after the other; distinguishable without red and green.
COLORS = ("#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c564b", "#000000")
SURFACE = "#c9ced6"
INK = "#2b2f36"


def color(number: int) -> str:
    """The color of the thing with this number."""
    return COLORS[number % len(COLORS)]


@in_words
def plot(
    x: Any,
    *,
    ax: Any = None,
    generators: Any = None,
    values: Any = None,
    edges: bool | None = None,
    alpha: float | None = None,
    view: tuple[float, float] = (20.0, -60.0),
    title: str | None = None,
) -> Any:
    """Draw something with matplotlib.

    Parameters
    ----------
    x
        * anything that :func:`as_model` understands: faces, lines and points, in space or in the plane; volumes by the squares around them;
        * an answer, drawn over its model: homology with generators, one group or generator, fundamental groups, a cover, cocycles, a cut, an
          arrangement, a Boolean; homology without generators as bars of its Betti numbers;
        * a list of a model and answers about it, harmonic forms among them;
        * :class:`CutCells`: the part of each cell that is covered;
        * a :class:`ChainComplex` or a sparse matrix: where the entries are, one panel a degree;
        * a :class:`Persistence`, what :func:`extended_persistence` gives, or an array ``(n, 2)`` of births and deaths: a diagram;
        * a :class:`PlanarArrangement` or :class:`PlanarBoolean`: each bounded face in a color of its own;
        * a :class:`YinSet`: the set filled, positive and negative curves, kinks as dots;
        * an :class:`Interface`: each bounded phase in a color of its own, junctions as dots.
    ax
        The axes to draw in; new ones by default. A chain complex with several matrices takes a list of axes.
    generators
        What :func:`homology` gave, or a list of generators: drawn over the model, each in a color of its own.
    values
        A number for each vertex, or for each face: shown as colors.
    edges
        Whether edges of faces are drawn; by default where there are few.
    alpha
        How opaque faces are, from 0 to 1; by default 1, and less under generators.
    view
        Elevation and azimuth of the eye in degrees.
    title
        What to write above.

    Returns
    -------
    matplotlib.axes.Axes
        The axes, or a list of them for a chain complex.

    Raises
    ------
    ImportError
        Without matplotlib, with the command that installs it.

    Examples
    --------
    >>> import coface
    >>> axes = coface.plot(coface.generate("torus"))          # doctest: +SKIP
    >>> axes.figure.savefig("torus.png")                      # doctest: +SKIP
    """
    pyplot = needed("matplotlib.pyplot", "plot")
    kind = type(x).__name__ if type(x).__module__ == "coface" else ""
    if kind == "ChainComplex":
        return _chain_complex(pyplot, x, ax, title)
    if hasattr(x, "tocoo"):
        return _titled(_matrix(_flat_axes(pyplot, ax), x), title)
    if isinstance(x, dict) and ("extended+" in x or "closed-open" in x):
        return _titled(_diagram(_flat_axes(pyplot, ax), _extended(x)), title)
    if isinstance(x, np.ndarray) and x.ndim == 2 and x.shape[1] == 2 and x.dtype.kind == "f":
        return _titled(_diagram(_flat_axes(pyplot, ax), {0: x}), title)
    if kind in FLAT:
        return _titled(FLAT[kind](_flat_axes(pyplot, ax), x), title)
    if is_facts(x):
        return _titled(_facts(_flat_axes(pyplot, ax), x), title)
    together = shown(x)
    is_placed = together.model is not None and together.model.vertices is not None
    if not is_placed and kind in ("Homology", "HomologyGroup"):
        return _titled(_bars(_flat_axes(pyplot, ax), x), title)
    model = together.scene()
    given = _generators(generators)
    _refuse_strangers(model, given)
    found = [*given, *overlays(together.facts)]
    if kind == "CutCells" and values is None and len(model.data):
        values = model.data[0][2]
    places = model.vertices
    if places is None and (kind not in ("", "Model", "Complex", "Surface") or isinstance(x, (list, tuple)) and together.facts):
        places = _spectral(model)
    if places is None:
        raise_invalid("plot needs coordinates, and this model has none", "give vertices to Model.from_arrays, or plot its chain complex")
    points = np.asarray(places, np.float64)
    refuse_unplaced(points, "plot")
    if points.shape[1] > 3:
        raise_invalid(
            f"plot shows the plane and space, and these points have {points.shape[1]} coordinates",
            "project them: Model.from_arrays(model.vertices @ projection, model.faces)",
        )
    is_flat = points.shape[1] < 3 or not np.ptp(points[:, 2]).any()
    if is_flat:
        points = np.pad(points[:, :2], [(0, 0), (0, 2 - min(2, points.shape[1]))])
        axes = _flat_axes(pyplot, ax)
    elif ax is not None:
        axes = ax
    else:
        axes = pyplot.figure(figsize=(6, 6)).add_subplot(projection="3d", computed_zorder=False)
    _model(axes, model, points, is_flat, found, values, edges, alpha)
    _frame(axes, points, is_flat, view)
    return _titled(axes, title)


def _refuse_strangers(model: Any, generators: Iterable[Any]) -> None:
    """Refuses generators with vertices or edges that the model does not have."""
    ends: set[tuple[int, int]] | None = None
    for generator in generators:
        cells = np.asarray(generator.simplices) if not isinstance(generator.simplices, tuple) else np.zeros((0, 1))
        if not cells.size or cells.dtype.kind not in "iu":
            continue
        missing: list[Any] | None = [int(cells.max())] if int(cells.max()) >= model.vertex_count else None
        if missing is None and cells.ndim == 2 and cells.shape[1] == 2 and model.structure != "volume":
            if ends is None:
                ends = set(map(tuple, np.sort(np.asarray(model.edges, np.int64).reshape(-1, 2), axis=1).tolist()))
            missing = next((row for row in cells.tolist() if tuple(sorted(row)) not in ends), None)
        if missing is not None:
            what = "vertex" if len(missing) == 1 else "edge between the vertices"
            raise_invalid(
                f"the generators are of another model: this one has no {what} {', '.join(map(str, missing))}",
                "give coface.homology(model, generators=True) of the model that is drawn",
                [missing],
            )


def plot_method(self: Any, **options: Any) -> Any:
    """Draw this with matplotlib: :func:`plot` with the same options."""
    return plot(self, **options)


class Overlay:
    """Cells that are drawn over a model: their vertices, and for forms a value for each."""

    def __init__(self, simplices: Any, values: Any = None) -> None:
        self.simplices = np.asarray(simplices)
        self.values = None if values is None else np.asarray(values, np.float64)


def overlays(facts: list[dict[str, Any]]) -> list[Overlay]:
    """What answers show over a model."""
    found: list[Overlay] = []
    for fact in facts:
        for group in fact.get("generators", ()):
            for generator in group:
                cells = [cell for _, cell in generator["chain"]]
                if len(set(map(len, cells))) == 1:
                    found.append(Overlay(cells))
        walks = [*fact.get("loops", ()), *(seam["vertices"] for part in fact.get("components", ()) for seam in part.get("seams", ()))]
        found.extend(Overlay(list(zip(walk[:-1], walk[1:]))) for walk in walks if len(walk) > 1)
        if "harmonic" not in fact:
            found.extend(Overlay([cell for _, cell in chain]) for chain in fact.get("cocycles", ()) if chain)
        found.extend(Overlay(fact["edges"], form["values"]) for form in fact.get("harmonic", ())[:1])
        cells = fact.get("simplices", ())
        found.extend(Overlay([cell for cell in cells if len(cell) == size]) for size in sorted(set(map(len, cells))))
    return found


def _spectral(model: Any) -> Any:
    """Places of vertices without positions: two slow vibrations of the graph of edges (K. M. Hall, 1970), so that neighbors are near."""
    count, pairs = model.vertex_count, np.asarray(model.edges).reshape(-1, 2)
    count = max(count, 1 + int(pairs.max(initial=-1)))
    if count > 2000:
        return None
    laplacian = np.zeros((count, count))
    np.add.at(laplacian, (pairs[:, 0], pairs[:, 1]), -1.0)
    np.add.at(laplacian, (pairs[:, 1], pairs[:, 0]), -1.0)
    laplacian -= np.diag(laplacian.sum(axis=1))
    _, shapes = np.linalg.eigh(laplacian)
    return np.pad(shapes, [(0, 0), (0, max(0, 3 - count))])[:, 1:3]


def _bars(axes: Any, x: Any) -> Any:
    """Betti numbers as bars, with the groups below."""
    groups = list(x) if hasattr(x, "betti_numbers") else [x]
    degrees = [group.degree for group in groups]
    axes.bar(degrees, [group.betti for group in groups], color=COLORS[1])
    axes.set_xticks(degrees, [repr(group) for group in groups])
    axes.set_ylabel("Betti number")
    return axes


def _titled(axes: Any, title: str | None) -> Any:
    if title is not None:
        axes.set_title(title)
    return axes


def _flat_axes(pyplot: Any, ax: Any) -> Any:
    return ax if ax is not None else pyplot.figure(figsize=(6, 6)).add_subplot()


def _generators(value: Any) -> list[Any]:
    """The generators in what was given: groups, lists of them, single ones."""
    if value is None:
        return []
    if hasattr(value, "coefficients") and hasattr(value, "simplices"):
        return [value]
    if hasattr(value, "generators"):
        return _generators(value.generators)
    return [one for part in value for one in _generators(part)]


def _frame(axes: Any, points: NDArray[np.float64], is_flat: bool, view: tuple[float, float]) -> None:
    axes.set_axis_off()
    if is_flat:
        axes.autoscale_view()
        axes.set_aspect("equal")
        return
    if len(points) == 0:
        return
    low, high = points.min(axis=0), points.max(axis=0)
    size = np.where(high > low, high - low, max(1e-12, float((high - low).max()) * 1e-3))
    for name, start, extent in zip("xyz", low, size):
        getattr(axes, f"set_{name}lim")(start, start + extent)
    axes.set_box_aspect(size / size.max(), zoom=1.3)
    axes.view_init(*view)


def _model(
    axes: Any,
    model: Any,
    points: NDArray[np.float64],
    is_flat: bool,
    generators: list[Any],
    values: Any,
    edges: bool | None,
    alpha: float | None,
) -> None:
    flat, offsets = polygons(model)
    count = len(offsets) - 1
    opacity = alpha if alpha is not None else (0.55 if generators and not is_flat else 1.0)
    wanted = edges if edges is not None else count <= 3000
    colors = _face_colors(values, len(points), flat, offsets)
    shapes: list[Any] = []
    order: list[int] = []
    lengths = np.diff(offsets)
    for length, block in blocks(flat, offsets):
        shapes.extend(points[block])
        order.extend(np.flatnonzero(lengths == length).tolist())
    fill: Any = SURFACE if colors is None else colors[order]
    line: dict[str, Any] = {"edgecolors": INK if wanted else "none", "linewidths": 0.25 if wanted else 0.0}
    if shapes and is_flat:
        from matplotlib.collections import PolyCollection

        axes.add_collection(PolyCollection(shapes, facecolors=fill, alpha=opacity, **line))
    elif shapes:
        from matplotlib.colors import to_rgba_array
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        shade = to_rgba_array(fill, opacity)
        shaded = _shaded(shapes, shade if len(shade) == len(shapes) else np.repeat(shade, len(shapes), axis=0))
        if not wanted:
            # Faces without seams: each has its own color around it.
            line = {"edgecolors": shaded, "linewidths": 0.2}
        axes.add_collection3d(Poly3DCollection(shapes, facecolors=shaded, zorder=1, **line))
    pairs = steps(model)
    if len(pairs):
        _segments(axes, points[pairs], INK, 1.0, 2)
    if count == 0 and len(pairs) == 0:
        if len(model.cells):
            _segments(axes, points[np.asarray(model.edges)], INK, 0.5, 2)
        else:
            axes.scatter(*points.T, s=6, color=INK)
    for number, generator in enumerate(generators):
        _generator(axes, points, is_flat, generator, color(number))


def _face_colors(values: Any, vertex_count: int, flat: Any, offsets: Any) -> Any:
    if values is None:
        return None
    from matplotlib import colormaps

    numbers = np.asarray(values, np.float64).reshape(-1)
    count = len(offsets) - 1
    if len(numbers) == vertex_count and count:
        numbers = np.add.reduceat(numbers[flat], offsets[:-1]) / np.diff(offsets)
    elif len(numbers) != count:
        raise_invalid(
            f"there are {len(numbers)} values, and {vertex_count} vertices and {count} faces",
            "give one for each vertex or for each face",
        )
    span = float(np.ptp(numbers)) or 1.0
    return colormaps["viridis"]((numbers - numbers.min()) / span)


def _shaded(shapes: list[Any], colors: Any) -> Any:
    """The colors by the light from the upper left; the two sides of a face alike."""
    corners = np.array([shape[:3] for shape in shapes])
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = np.array([0.45, -0.55, 0.7])
    facing = np.abs(normals @ (light / np.linalg.norm(light))) / np.where(lengths > 0, lengths, 1.0)
    shaded = np.array(colors, np.float64)
    shaded[:, :3] *= (0.45 + 0.55 * facing)[:, None]
    return shaded


def _segments(axes: Any, segments: Any, shade: Any, width: float, order: int) -> None:
    if segments.shape[2] == 2:
        from matplotlib.collections import LineCollection

        axes.add_collection(LineCollection(segments, colors=shade, linewidths=width, zorder=order))
    else:
        from mpl_toolkits.mplot3d.art3d import Line3DCollection

        axes.add_collection3d(Line3DCollection(segments, colors=shade, linewidths=width, zorder=order))


def _generator(axes: Any, points: Any, is_flat: bool, generator: Any, shade: str) -> None:
    simplices = generator.simplices
    if isinstance(simplices, tuple):
        return
    simplices = np.asarray(simplices)
    if simplices.ndim != 2 or len(simplices) == 0:
        return
    strength = getattr(generator, "values", None)
    if strength is not None and len(strength) == len(simplices):
        from matplotlib import colormaps

        most = float(np.abs(strength).max(initial=0.0)) or 1.0
        _segments(axes, points[simplices], colormaps["viridis"](np.abs(strength) / most), 2.0, 5)
        return
    if simplices.shape[1] == 1:
        axes.scatter(*points[simplices[:, 0]].T, s=24, color=shade, zorder=6)
    elif simplices.shape[1] == 2:
        _segments(axes, points[simplices], shade, 2.5, 5)
    elif simplices.shape[1] == 3:
        if is_flat:
            from matplotlib.collections import PolyCollection

            axes.add_collection(PolyCollection(points[simplices], facecolors=shade, alpha=0.4))
        else:
            from mpl_toolkits.mplot3d.art3d import Poly3DCollection

            axes.add_collection3d(Poly3DCollection(points[simplices], facecolors=shade, alpha=0.4, zorder=4))


def _facts(axes: Any, found: Any) -> Any:
    """Paths of points of a diagram; other facts as a table."""
    if isinstance(found, list) and found and all(isinstance(one, tuple) and len(one) == 2 and np.ndim(one[1]) == 2 for one in found):
        for degree, path in found:
            path = np.asarray(path, np.float64)
            axes.plot(path[:, -2], path[:, -1], color=color(int(degree)), linewidth=1.0, label=f"degree {degree}")
        axes.set_xlabel("birth")
        axes.set_ylabel("death")
        return axes
    lines = [f"{name} = {str(value)[:60]}" for name, value in rows_of(found)]
    axes.axis("off")
    axes.text(0.0, 1.0, "\n".join(lines[:40]), transform=axes.transAxes, va="top", family="monospace", color=INK)
    return axes


def _matrix(axes: Any, matrix: Any) -> Any:
    found = matrix.tocoo()
    rows, columns = found.shape
    size = max(0.5, min(8.0, 220.0 / max(rows, columns, 1)))
    for sign, shade in [(1, COLORS[1]), (-1, COLORS[0])]:
        chosen = np.sign(found.data) == sign
        axes.plot(found.col[chosen], found.row[chosen], "s", markersize=size, color=shade, linestyle="none")
    axes.set_xlim(-0.5, max(columns, 1) - 0.5)
    axes.set_ylim(max(rows, 1) - 0.5, -0.5)
    axes.set_aspect("equal")
    axes.set_xlabel(f"{columns} columns, {found.nnz} entries")
    axes.set_ylabel(f"{rows} rows")
    return axes


def _chain_complex(pyplot: Any, complex: Any, ax: Any, title: str | None) -> list[Any]:
    degrees = range(1, complex.dimension + 1)
    if ax is not None:
        every = list(np.atleast_1d(np.asarray(ax, dtype=object)))
    else:
        panels = max(1, len(degrees))
        every = list(np.atleast_1d(pyplot.figure(figsize=(5 * panels, 5)).subplots(1, panels)))
    for axes, degree in zip(every, degrees):
        _titled(_matrix(axes, complex.boundary(degree)), f"boundary from degree {degree} to {degree - 1}")
    if title is not None:
        every[0].figure.suptitle(title)
    return every


def _extended(found: dict[str, Any]) -> dict[int, NDArray[np.float64]]:
    """Births and deaths of extended persistence, or of a zigzag, by degree, of all kinds together."""
    pairs = [pair for pairs in found.values() for pair in pairs]
    degrees = range(1 + max((degree for degree, _ in pairs), default=0))
    return {k: np.array([ends for degree, ends in pairs if degree == k], np.float64).reshape(-1, 2) for k in degrees}


def _diagram(axes: Any, persistence: Any) -> Any:
    if isinstance(persistence, dict):
        by_degree: dict[int, Any] = persistence
    else:
        by_degree = dict(enumerate(persistence.diagrams))
    diagrams = {degree: np.asarray(pairs, np.float64).reshape(-1, 2) for degree, pairs in by_degree.items()}
    every = np.concatenate([np.zeros((0, 2)), *diagrams.values()])
    finite = every[np.isfinite(every)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 1.0)
    span = (high - low) or 1.0
    top = high + 0.1 * span
    axes.plot([low - 0.05 * span, top], [low - 0.05 * span, top], color=INK, linewidth=0.6)
    if len(every) and np.isinf(every[:, 1]).any():
        axes.axhline(top, color=INK, linewidth=0.6, linestyle="--")
        axes.text(low, top, " never dies", va="bottom", color=INK)
    for degree, pairs in diagrams.items():
        if len(pairs):
            deaths = np.where(np.isinf(pairs[:, 1]), top, pairs[:, 1])
            axes.plot(pairs[:, 0], deaths, "o", markersize=4, color=color(degree), label=f"degree {degree}", linestyle="none")
    axes.set_aspect("equal")
    axes.set_xlabel("birth")
    axes.set_ylabel("death")
    axes.legend(loc="lower right")
    return axes


def _region(rings: Iterable[Any]) -> Any:
    """A region by its rings; holes run the other way, so that they stay empty."""
    from matplotlib.path import Path

    corners: list[Any] = []
    codes: list[Any] = []
    for ring in rings:
        points = np.asarray(ring, np.float64)[:, :2]
        corners.extend([points, points[:1]])
        codes.append(np.array([Path.MOVETO, *[Path.LINETO] * (len(points) - 1), Path.CLOSEPOLY], np.uint8))
    return Path(np.concatenate(corners), np.concatenate(codes))


def _arrangement(axes: Any, arrangement: Any) -> Any:
    from matplotlib.patches import PathPatch

    points = np.asarray(arrangement.vertices)
    for number in range(len(arrangement)):
        region = _region([points[np.asarray(walk)] for walk in arrangement.walks(number)])
        axes.add_patch(PathPatch(region, facecolor=color(number), alpha=0.45, edgecolor="none"))
    pairs = np.asarray(arrangement.edges)
    if len(pairs):
        _segments(axes, points[pairs][:, :, :2], INK, 0.8, 2)
    _frame(axes, points, True, (0.0, 0.0))
    return axes


def _boolean(axes: Any, result: Any) -> Any:
    from matplotlib.patches import PathPatch

    points = np.asarray(result.vertices)
    for number, rings in enumerate(result.polygons):
        region = _region([points[np.asarray(ring)] for ring in rings])
        axes.add_patch(PathPatch(region, facecolor=color(number), alpha=0.45, edgecolor=INK, linewidth=0.8))
    _frame(axes, points, True, (0.0, 0.0))
    return axes


def _yin_set(axes: Any, region: Any) -> Any:
    from matplotlib.patches import PathPatch, Rectangle

    curves = list(region.curves)
    every = np.concatenate([np.asarray(curve.bounding_box) for curve in curves]) if curves else np.array([[0.0, 0.0], [1.0, 1.0]])
    low, high = every.min(axis=0), every.max(axis=0)
    size = float((high - low).max())
    sampled = [np.asarray(curve.flattened(size / 2000)) for curve in curves]
    rings = list(sampled)
    if not region.is_bounded:
        # The unbounded part is cut off by a frame around everything.
        low, high = low - 0.1 * size, high + 0.1 * size
        rings.append(np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]))
        axes.add_patch(Rectangle(tuple(low), *(high - low), fill=False, linestyle="--", linewidth=0.6, edgecolor=INK))
    if rings and not region.is_empty:
        axes.add_patch(PathPatch(_region(rings), facecolor=COLORS[5], alpha=0.5, edgecolor="none"))
    for curve, points in zip(curves, sampled):
        closed = np.concatenate([points, points[:1]])
        axes.plot(*closed.T, color=COLORS[1] if curve.signed_area > 0 else COLORS[0], linewidth=1.4)
    kinks = np.asarray(region.kinks.points)
    if len(kinks):
        axes.plot(*kinks.T, "o", markersize=5, color=INK, linestyle="none")
    _frame(axes, every, True, (0.0, 0.0))
    return axes


def _interface(axes: Any, interface: Any) -> Any:
    from matplotlib.patches import PathPatch

    every = [np.zeros((0, 2))]
    for number, region in enumerate(interface.sets()):
        curves = list(region.curves)
        if not curves:
            continue
        boxes = np.concatenate([np.asarray(curve.bounding_box) for curve in curves])
        size = float((boxes.max(axis=0) - boxes.min(axis=0)).max())
        rings = [np.asarray(curve.flattened(size / 2000)) for curve in curves]
        every.extend(rings)
        if region.is_bounded:
            axes.add_patch(PathPatch(_region(rings), facecolor=color(number), alpha=0.45, edgecolor="none"))
        for ring in rings:
            axes.plot(*np.concatenate([ring, ring[:1]]).T, color=INK, linewidth=1.0)
    points = np.array([junction["point"] for junction in interface.junctions])
    if len(points):
        axes.plot(*points.T, "o", markersize=4, color=INK, linestyle="none")
    _frame(axes, np.concatenate(every) if len(every) > 1 else np.array([[0.0, 0.0], [1.0, 1.0]]), True, (0.0, 0.0))
    return axes


#: How classes are drawn that are no models.
FLAT = {
    "Interface": _interface,
    "Persistence": _diagram,
    "PlanarArrangement": _arrangement,
    "PlanarBoolean": _boolean,
    "YinSet": _yin_set,
}
