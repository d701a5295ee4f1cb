"""Questions as functions: each makes a model of what it gets and asks that."""

from __future__ import annotations

import os
import struct
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from coface import _coface
from coface._answers import FactsAnswer, ListAnswer
from coface._arrays import numbers, plain, point_rows, ragged, raise_invalid
from coface._coface import (
    ChainComplex,
    Cocycles,
    Complex,
    Congruence,
    Cover,
    Domain,
    FundamentalGroup,
    Homology,
    LarModel,
    Model,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    SolidBoolean,
    SpatialArrangement,
    Surface,
)
from coface._models import as_cells, as_chain_complex, as_drawn, as_model, as_surface, unwrapped
from coface._records import asked, remember
from coface._volumes import voxel_rule
from coface._faults import in_words


if TYPE_CHECKING:
    from scipy.sparse import csr_array

    from coface._types import ComparedWalk, SurfacePart


@in_words
def homology(
    x: Any,
    coefficients: str | int = "z",
    *,
    relative: Any = None,
    domain: str | int | list[str | int] | None = None,
    reduced: bool = False,
    generators: bool = False,
    progress: Any = False,
) -> Homology:
    """The homology groups, over the integers or other coefficients.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    coefficients
        ``"z"``, ``"q"``, ``"f2"``, ``"f3"``, ... for a prime field, ``"z/4"`` and the like, or a modulus: 2 is ``"f2"``.
    relative
        A part that is divided out: ``"boundary"``, a group of the model by its name or number, such as a physical group of a ``.msh``, a list
        of these, or anything that :func:`as_model` understands, with the same numbers of vertices.
    domain
        Groups of the model, by name or number, whose cells and faces are meant; the whole model by default.
    reduced
        Whether a point has no homology at all.
    generators
        Whether cycles that generate the groups are found too, short ones where that is cheap. Those of finite order m have a
        certificate: a chain whose boundary is m times the cycle.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Homology
        A group for each degree: ``homology[k].betti``, ``.torsion``, ``.generators``.

    Notes
    -----
    Cells are matched in pairs first, which takes time near linear in their number; Smith normal form of the rest gives the groups.

    Examples
    --------
    The projective plane has a loop twice which bounds a disk:

    >>> import coface
    >>> groups = coface.homology(coface.generate("rp2"), generators=True)
    >>> [str(group) for group in groups]
    ['Z', 'Z/2', '0']
    >>> groups[1].generators[0].certificate
    Chain(degree 2, 10 cells)

    A disk modulo its boundary is a sphere but for a point:

    >>> coface.homology([[0, 1, 2], [0, 2, 3]], relative="boundary").betti_numbers
    (0, 0, 1)
    """
    x = _held(x, progress)
    chains = _chains(x, relative, domain, reduced, progress)
    found = chains.homology(coefficients, generators=generators, progress=progress)
    return _remembered(found, x, chains, relative, domain, coefficients=coefficients, reduced=reduced, generators=generators)


@in_words
def cohomology(
    x: Any,
    coefficients: str | int = "z",
    *,
    relative: Any = None,
    domain: str | int | list[str | int] | None = None,
    reduced: bool = False,
    generators: bool = False,
    progress: Any = False,
) -> Homology:
    """The cohomology groups; torsion stands one degree above that of homology.

    Parameters
    ----------
    x, coefficients, relative, domain, reduced, generators, progress
        As for :func:`homology`; generators are cocycles.

    Returns
    -------
    Homology
        A group for each degree.

    Examples
    --------
    >>> import coface
    >>> [str(group) for group in coface.cohomology(coface.generate("rp2"))]
    ['Z', '0', 'Z/2']
    """
    x = _held(x, progress)
    chains = _chains(x, relative, domain, reduced, progress)
    found = chains.cohomology(coefficients, generators=generators, progress=progress)
    return _remembered(found, x, chains, relative, domain, coefficients=coefficients, reduced=reduced, generators=generators, cohomology=True)


def _held(x: Any, progress: Any) -> Any:
    """Lists and arrays of cells as a model, which nobody changes; everything else as it is."""
    is_list = isinstance(x, (list, tuple, np.ndarray)) and not (len(x) and hasattr(x[0], "tocsc"))
    return as_cells(x, progress=progress) if is_list else x


def _remembered(found: Homology, x: Any, chains: ChainComplex, relative: Any, domain: Any, **options: Any) -> Homology:
    """The groups, which know what they were asked of: the model, or the chain complex where a part of it was divided out."""
    is_whole = isinstance(x, (Model, Complex, Surface)) and domain is None and (relative is None or relative == "boundary" and isinstance(relative, str))
    if is_whole:
        remember(found, "homology", x, relative=relative, **options)
    elif not options["reduced"]:
        remember(found, "homology", chains, **options)
    return found


def _chains(x: Any, relative: Any, domain: Any, reduced: bool, progress: Any) -> ChainComplex:
    if relative is None and domain is None and not reduced:
        return as_chain_complex(x, progress=progress)
    model = as_cells(x, progress=progress)
    part = relative if _are_groups(model, relative) else part_of(model, relative)
    return model.chain_complex(part, domain=domain, reduced=reduced, progress=progress)


def _are_groups(model: Model, words: Any) -> bool:
    """Whether these are names or numbers of groups; names must be there to be told from files."""
    if isinstance(words, list) and words:
        return all(isinstance(word, (str, int)) for word in words)
    return isinstance(words, int) or any(name == words for name, _, _ in model.groups)


def part_of(model: Model, part: Any) -> Any:
    """The part of a model that is divided out: its boundary, one of its groups, or another model."""
    if part is None or not isinstance(part, str) or part == "boundary":
        return part if part is None or isinstance(part, str) else as_model(part)
    names = [name for name, _, _ in model.groups]
    if part in names:
        return group_of(model, part)
    if os.path.exists(part.partition("#")[0]):
        return as_model(part)
    shown = ", ".join(map(repr, dict.fromkeys(names))) or "none"
    raise_invalid(
        f"relative is {part!r}, which is no group of the model (it has {shown}) and no file",
        'give relative="boundary", the name of a group, or a model of cells',
    )


def group_of(model: Model, name: str) -> Model:
    """The cells of all groups of one name as a model with the same numbers of vertices."""
    faces, cells, lines, points = ragged(model.faces), model.cells, ragged(model.lines), []
    cells_chosen: dict[str, Any] = {}
    for other, kind, members in model.groups:
        if other != name:
            continue
        if kind == "vertices":
            points.extend(members.tolist())
        elif kind in ("faces", "lines"):
            flat, offsets = faces if kind == "faces" else lines
            chosen = [flat[offsets[member] : offsets[member + 1]] for member in members]
            cells_chosen.setdefault("polygon" if kind == "faces" else "polyline", []).extend(chosen)
        else:
            start = 0
            if len(cells) > 1:
                raise_invalid(
                    f"the group {name!r} has 3-cells of a model with several kinds of them",
                    "give the part as a model: coface.Model.from_arrays(vertices, cells=...)",
                )
            for shape, rows in cells.items():
                inside = members[(members >= start) & (members < start + len(rows))] - start
                if len(inside):
                    cells_chosen.setdefault(shape, []).extend(np.asarray(rows)[inside])
                start += len(rows)
    if points:
        cells_chosen["vertex"] = [[vertex] for vertex in points]
    return Model.from_arrays(model.vertices, cells=cells_chosen, vertex_count=model.vertex_count)


@in_words
def pi1(
    x: Any,
    *,
    simplify: bool = True,
    base: int | None = None,
    time_limit: float | None = None,
    progress: Any = False,
) -> list[FundamentalGroup]:
    """The fundamental groups of the components.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands; :meth:`Surface.pi1` gives canonical and shortest systems of loops on surfaces.
    simplify
        Whether presentations are made short by Tietze moves.
    base
        The vertex that loops of its component start from.
    time_limit
        Seconds for simplifying and recognizing a group.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of FundamentalGroup
        One for each component: generators, relators, a name where it can be proved, and loops.

    Examples
    --------
    >>> import coface
    >>> [str(group) for group in coface.pi1(coface.generate("rp2"))]
    ['Z/2']
    """
    model = as_cells(x)
    groups = _coface.fundamental_groups(model, simplify=simplify, base=base, time_limit=time_limit, progress=progress)
    if base is None:
        for group in groups:
            remember(group, "pi1", model, simplify=simplify)
    return groups


@in_words
def homotopic(x: Any, walks: Sequence[Any], *, boundary: bool = False, progress: Any = False) -> list[ComparedWalk]:
    """Which closed walks on a surface can be contracted, which bound, and which are homotopic to each other.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands.
    walks
        Closed paths of vertices along edges, the first one again at the end.
    boundary
        Whether the boundary surface of a volume is meant.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of dict
        For each walk ``contractible``, ``bounds``, ``class``, ``component``, ``word``, ``homotopic`` and ``freely_homotopic`` (numbers of other walks that
        are).

    Examples
    --------
    >>> import coface
    >>> loop, face = coface.homotopic(coface.generate("rp2"), [[0, 1, 3, 0], [0, 1, 2, 0]])
    >>> [loop["contractible"], face["contractible"]].count(True)
    1
    """
    return ListAnswer(as_surface(x, boundary=boundary, progress=progress).compare(walks, progress=progress))


@in_words
def cut(
    x: Any,
    along: Any = None,
    *,
    simplify: bool = True,
    rounds: int | None = None,
    base: int | None = None,
    canonical: bool = False,
    layout: str | None = None,
    weights: str = "uniform",
    uv: bool = False,
    boundary: bool = False,
    progress: Any = False,
) -> Domain:
    """A surface cut open: each component to a disk, or along a path of vertices.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands.
    along
        A path of vertices, closed if the first is there again at the end; else a graph that leaves disks is found.
    simplify
        Whether loose ends are left out and seams made short. The program does so with ``--simplify``: ``simplify=False`` is ``coface cut`` without options.
    rounds
        How often to go through all seams to make them shorter.
    base
        The vertex that the graph is grown from.
    canonical
        Whether the mesh is refined and cut along disjoint simple loops, so that the word around the domain is canonical.
    layout
        ``"polygon"`` or ``"klein"``: draws the domain of a canonical cut as a regular polygon of the Euclidean or the hyperbolic plane.
    weights
        Of a layout: ``"uniform"`` or ``"cotangent"``.
    uv
        Of a layout: whether it becomes texture coordinates of a mesh that stays where it is.
    boundary
        Whether the boundary surface of a volume is cut.
    progress
        As for :func:`homology`.

    Returns
    -------
    Domain
        The opened surface as :attr:`Domain.model`, and what each seam is for.

    Examples
    --------
    >>> import coface
    >>> torus = coface.generate("torus", columns=5, rows=4)
    >>> coface.cut(torus).model.report().name
    'disk'
    """
    surface = as_surface(x, boundary=boundary, progress=progress)
    if along is not None:
        return surface.cut(along, progress=progress)
    if canonical or layout is not None or uv:
        return surface.cut(canonical=True, base=base, layout=layout, weights=weights, uv=uv, progress=progress)
    return surface.cut(simplify=simplify, rounds=rounds, base=base, progress=progress)


@in_words
def cover(
    x: Any,
    *,
    radius: int | None = None,
    copies: int | None = None,
    component: int = 0,
    layout: str = "auto",
    boundary: bool = False,
    progress: Any = False,
) -> Cover:
    """The universal cover of a surface, as far as it is asked for: copies of a fundamental domain, glued.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands.
    radius
        All copies at words of at most this length. One of `radius` and `copies` is needed.
    copies
        So many copies, instead.
    component
        The component that is covered.
    layout
        ``"flat"`` in the plane, ``"disk"`` in the Poincare disk, ``"klein"`` in the disk of Klein, ``"none"`` over the surface, ``"auto"`` whichever there is.
    boundary
        Whether the boundary surface of a volume is covered.
    progress
        As for :func:`homology`.

    Returns
    -------
    Cover
        The copies, their words, and the cover as :attr:`Cover.model`.

    Examples
    --------
    >>> import coface
    >>> coface.cover(coface.generate("genus", genus=2), radius=1).spheres
    [1, 8]
    """
    surface = as_surface(x, boundary=boundary, progress=progress)
    return surface.cover(radius=radius, copies=copies, component=component, layout=layout, progress=progress)


@in_words
def cocycles(
    x: Any, *, method: str = "crossing", boundary: bool = False, progress: Any = False
) -> Cocycles:
    """A basis of the first cohomology of a surface, dual to loops.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands.
    method
        ``"crossing"`` by a dual tree, ``"slicing"`` along loops.
    boundary
        Whether the boundary surface of a volume is asked about.
    progress
        As for :func:`homology`.

    Returns
    -------
    Cocycles
        Loops, cocycles, and the values of cocycles on loops.

    Examples
    --------
    >>> import coface
    >>> coface.cocycles(coface.generate("torus", columns=5, rows=4)).pairing
    [[1, 0], [0, 1]]
    """
    return as_surface(x, boundary=boundary, progress=progress).cocycles(method=method, progress=progress)


@in_words
def harmonic(
    x: Any,
    *,
    degree: int | None = None,
    weights: Any = "auto",
    boundary: bool = False,
    progress: Any = False,
) -> NDArray[np.float64]:
    """Harmonic forms: of a surface, one in each class of a basis of its first cohomology; with `degree` of any complex.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands; with `degree`, anything that :func:`as_chain_complex` understands.
    degree
        The degree of harmonic cochains dual to the free generators of homology; leave it out for forms of a surface.
    weights
        ``"cotangent"`` by angles, ``"uniform"``, or ``"auto"``: by angles where that can be. With `degree`, for each degree a positive
        weight for each cell.
    boundary
        Whether the boundary surface of a volume is asked about.
    progress
        As for :func:`homology`.

    Returns
    -------
    numpy.ndarray
        ``float64``, shape (rank, edges): a value for each edge, from its first vertex to its second, in the order of the edges of
        :class:`Surface`. With `degree` shape (rank, cells), in the order of the chain complex.

    Examples
    --------
    >>> import coface
    >>> coface.harmonic(coface.generate("torus", columns=5, rows=4)).shape
    (2, 60)
    >>> coface.harmonic([[0, 1], [1, 2], [0, 2]], degree=1).round(3).tolist()
    [[0.333, -0.333, 0.333]]
    """
    if degree is not None:
        lists = None if isinstance(weights, str) and weights in ("auto", "uniform") else weights
        forms: NDArray[np.float64] = _coface.harmonic(as_chain_complex(x), degree, weights=lists, progress=progress)
        return forms
    surface = as_surface(x, boundary=boundary, progress=progress)
    found = surface.cocycles(harmonic=True, weights=weights, progress=progress).harmonic
    assert found is not None, "it was asked for"
    return found


@in_words
def classify(x: Any, *, boundary: bool = False, progress: Any = False) -> list[SurfacePart]:
    """What each component of a surface is.

    Parameters
    ----------
    x
        Anything that :func:`as_surface` understands.
    boundary
        Whether the boundary surface of a volume is asked about.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of dict
        ``name``, ``orientable``, ``genus``, ``boundary_loops``, ``euler_characteristic``, ``f_vector`` of each component.

    Examples
    --------
    >>> import coface
    >>> [part["name"] for part in coface.classify(coface.generate("klein"))]
    ['Klein bottle']
    """
    return ListAnswer(as_surface(x, boundary=boundary, progress=progress).classify())


@in_words
def incidence(
    x: Any,
    operator: str,
    kind: str | None = None,
    *,
    at_least: int | None = None,
    exactly: int | None = None,
    progress: Any = False,
) -> csr_array:
    """Which cells share vertices, touch or bound, as a sparse matrix.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    operator
        Rows and columns: two of ``V``, ``E``, ``F``, ``C``, as in ``"FE"``.
    kind
        ``"counts"``: how many vertices two cells share; ``"incident"``: 1 where one is a face of the other; ``"signed"``: the signs of the
        boundary. If it is left out, ``"counts"`` between cells of one degree, as in ``"FF"``, and ``"incident"`` between those of two, as in
        ``"FE"``: what ``coface incidence`` prints.
    at_least, exactly
        1 where so many vertices are shared, instead of `kind`.
    progress
        As for :func:`homology`.

    Returns
    -------
    scipy.sparse.csr_array
        One row for each cell of the first degree. Of ``"counts"`` between cells of one degree the diagonal is not empty: a cell shares all
        its vertices with itself. ``"VV"`` counts edges: an entry is the number of edges that join two vertices, the diagonal the number of
        edges at a vertex. ``"incident"`` has no diagonal.

    Examples
    --------
    >>> import coface
    >>> coface.incidence([[0, 1, 2], [1, 2, 3]], "FE", "incident").toarray()
    array([[1, 1, 1, 0, 0],
           [0, 0, 1, 1, 1]], dtype=int32)
    >>> coface.incidence([[0, 1, 2]], "VV").toarray()
    array([[2, 1, 1],
           [1, 2, 1],
           [1, 1, 2]], dtype=int32)
    >>> coface.incidence([[0, 1, 2]], "VV", "incident").toarray()
    array([[0, 1, 1],
           [1, 0, 1],
           [1, 1, 0]], dtype=int32)
    """
    lar = x if isinstance(x, LarModel) else LarModel(as_cells(x, progress=progress), progress=progress)
    return lar.incidence(operator, kind, at_least=at_least, exactly=exactly, progress=progress)


def _inputs(inputs: tuple[Any, ...], as_input: Callable[[Any], Model] = as_drawn) -> Any:
    """The models of the inputs, with names where they come in a dictionary."""
    inputs = tuple(map(_segments, map(unwrapped, inputs)))
    if len(inputs) == 1 and isinstance(inputs[0], Mapping) and not _is_json(inputs[0]):
        return {str(name): as_input(x) for name, x in inputs[0].items()}
    if len(inputs) == 1 and hasattr(inputs[0], "__next__"):
        inputs = (list(inputs[0]),)
    if len(inputs) == 1 and isinstance(inputs[0], (list, tuple)) and not _is_one_model(inputs[0]):
        inputs = tuple(inputs[0])
    return [as_input(_segments(x)) for x in inputs]


def _segments(x: Any) -> Any:
    """An array of segments, of shape ``(n, 2, 2)`` or ``(n, 2, 3)``, as lines; everything else as it is."""
    if not isinstance(x, np.ndarray) or x.dtype.kind not in "iuf" or x.ndim != 3 or x.shape[1] != 2 or x.shape[2] not in (2, 3):
        return x
    points, number = np.unique(x.reshape(-1, x.shape[2]), axis=0, return_inverse=True)
    return Model.from_arrays(points.astype(np.float64), cells={"line": number.reshape(-1, 2)})


def _as_solid(x: Any) -> Model:
    """As :func:`as_drawn`, but of an arrangement in space its cells, where it has some: their union."""
    return x.cells if isinstance(x, SpatialArrangement) and len(x) else as_drawn(x)


def _is_one_model(x: Any) -> bool:
    """Whether a list is facets, or vertices and faces, and no list of models."""
    of_rows: tuple[type, ...] = (list, int, np.integer)
    if isinstance(x, tuple):
        of_rows = (*of_rows, tuple, np.ndarray, type(None))
    return len(x) == 0 or any(isinstance(one, of_rows) for one in x)


def _is_json(x: Mapping[Any, Any]) -> bool:
    return bool({"facets", "boundaries", "next", "gluings", "curves", "type", "recipe"} & set(map(str, x)))


@in_words
def congruence(
    *inputs: Any,
    tolerance: float,
    greedy: bool = False,
    representative: str = "lowest",
    stable: bool = False,
    collisions: str = "rewrap",
    blocks: str = "models",
    within_blocks: str = "allow",
    method: str = "lists",
    progress: Any = False,
) -> Congruence:
    """Models merged within a tolerance: vertices nearby become one, and edges, faces and cells with them.

    Parameters
    ----------
    *inputs
        Anything that :func:`as_model` understands, or one list or dictionary of such.
    tolerance
        How near vertices become one, in the unit of the models.
    greedy
        Whether a class is what is near its first vertex, instead of chains of near vertices.
    representative
        Where a class is: ``"lowest"``, ``"mean"`` or ``"median"``.
    stable
        Whether classes are merged again until none are near.
    collisions
        What becomes of cells that lose terms without vanishing: ``"rewrap"``, ``"keep"`` or ``"refuse"``.
    blocks, within_blocks
        What a block is (``"models"``, ``"components"``, ``"none"``), and whether its own vertices may become one (``"allow"``,
        ``"warn"``, ``"forbid"``).
    method
        ``"lists"`` or ``"matrices"``; the result is the same.
    progress
        As for :func:`homology`.

    Returns
    -------
    Congruence
        The quotient, with the classes and signs of all cells.

    Examples
    --------
    >>> import coface
    >>> left = coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
    >>> right = coface.Model([[1.0001, 0], [0, 1], [1, 1]], [[0, 2, 1]])
    >>> coface.congruence(left, right, tolerance=0.01).f_vector
    [4, 5, 2]
    """
    found: Congruence = asked(
        "congruence",
        _inputs(inputs, as_model),
        tolerance,
        greedy=greedy,
        representative=representative,
        stable=stable,
        collisions=collisions,
        blocks=blocks,
        within_blocks=within_blocks,
        method=method,
        progress=progress,
    )
    return found


@in_words
def arrange(
    *models: Any,
    dimension: int | None = None,
    rule: str | None = None,
    features: bool = False,
    inputs: str | None = None,
    prune: bool = False,
    snap: bool = False,
    exact: bool = False,
    grid: float | None = None,
    close: bool = False,
    tolerance: float | None = None,
    weld: float | None = None,
    method: str | None = None,
    max_cells: int | None = None,
    split: bool = True,
    merge_coplanar: bool = True,
    precision: Literal["double", "single"] = "double",
    progress: Any = False,
) -> PlanarArrangement | SpatialArrangement:
    """What segments cut the plane into, or polygons space, exactly.

    Parameters
    ----------
    *models
        Anything that :func:`as_model` understands, or one list or dictionary of such; segments also as an array of shape ``(n, 2, 2)``, the ends of each.
    dimension
        2 or 3; by the models if left out. 2 leaves out the heights of maps.
    rule
        What is inside an input: ``"nonzero"``, ``"evenodd"`` or ``"positive"``.
    features
        The same as ``inputs="features"``.
    inputs
        What an input is: ``"files"`` (each model), ``"features"`` (its polygons of one name), ``"objects"``,
        ``"groups"`` or
        ``"components"`` of models. If left out, models are, and objects where a formula names more inputs than there
        are models.
    prune
        In the plane, whether edges that hang on the rest by one end are left out.
    snap
        Whether coordinates are rounded so that the result stays as it is.
    exact
        Whether the exact result is kept where rounding its coordinates makes edges or faces cross or overlap; otherwise
        these are cut and bent there by a few units of the last digit. Its ``model()``, and ``.json`` written of it, keep
        exact points, so that the next call takes it as it is.
    grid
        In the plane, all coordinates are multiples of this length.
    close
        In the plane, whether lines that end where they begin are rings of polygons. Else lines of maps bound nothing.
    tolerance
        In space, planes, vertices, edges and faces at most so far apart are put together, in the unit of the inputs.
    weld
        Before anything else, vertices of each model that are at most so far apart are merged; none moves farther.
    method
        How cells are found: ``"exact"`` or ``"congruence"``, which cuts each segment, in space each polygon in its own
        plane, for itself, in rounded numbers, and makes one what is within ``tolerance`` of each other.
    max_cells
        More cells than this are refused.
    split
        In space, whether polygons that are not flat are split into triangles; otherwise they are refused.
    merge_coplanar
        In space, whether faces of polygons in one plane are merged.
    precision
        In space, ``"single"`` makes a result that is valid with coordinates of 32 bits, which are those of an STL file.
    progress
        As for :func:`homology`.

    Returns
    -------
    PlanarArrangement or SpatialArrangement
        The cells, their measures, which inputs contain each, and where everything comes from.

    Examples
    --------
    Two segments that cross, and a third that closes a triangle:

    >>> import coface
    >>> cross = coface.Model.from_arrays([[0, 0], [2, 2], [0, 2], [2, 0]], cells={"line": [[0, 1], [2, 3], [1, 3]]})
    >>> coface.arrange(cross).f_vector
    [5, 5, 1]
    """
    found: PlanarArrangement | SpatialArrangement = asked(
        "arrange",
        _inputs(models),
        dimension=dimension,
        rule=rule,
        features=features,
        inputs=inputs,
        prune=prune,
        snap=snap,
        exact=exact,
        grid=grid,
        close=close,
        tolerance=tolerance,
        weld=weld,
        method=method,
        max_cells=max_cells,
        split=split,
        merge_coplanar=merge_coplanar,
        precision=precision,
        progress=progress,
    )
    return found


#: The words that name an operation; everything else is a formula.
_OPERATIONS = ("union", "intersection", "difference", "xor", "join", "meet")
#: What other libraries call them.
_SYNONYMS = {
    "and": "intersection",
    "intersect": "intersection",
    "minus": "difference",
    "or": "union",
    "subtract": "difference",
    "symmetric difference": "xor",
    "symmetric_difference": "xor",
    "unite": "union",
}


def _operation(word: Any) -> Any:
    """The name of an operation, in any case and by other names; a formula as it is."""
    if not isinstance(word, str):
        return word
    lower = word.strip().lower()
    if lower in _OPERATIONS:
        return lower
    if lower in _SYNONYMS:
        return _SYNONYMS[lower]
    if lower.replace("_", "").isalpha() and len(lower) > 2 and "xor" not in lower:
        raise_invalid(
            f"the operation is {word!r}",
            'give "union", "intersection", "difference", "xor", or a formula such as "(a | b) - c" or "0 & !1"',
        )
    return word


def _refuse_order(operation: Any, models: tuple[Any, ...]) -> None:
    """Says so where the operation does not come first."""
    words = [x for x in models if isinstance(x, str) and x in _OPERATIONS]
    if isinstance(operation, str) and (not words or operation in _OPERATIONS):
        return
    if words:
        raise_invalid(
            f"the operation {words[0]!r} stands behind an input", f'call coface.boolean("{words[0]}", a, b): the operation first'
        )
    raise_invalid(
        f"the operation is a {type(operation).__name__}",
        'call coface.boolean("union", a, b), or with "intersection", "difference", "xor" or a formula first',
    )


@in_words
def boolean(
    operation: str,
    *models: Any,
    dimension: int | None = None,
    rule: str | None = None,
    features: bool = False,
    inputs: str | None = None,
    keep_walls: bool = False,
    snap: bool = False,
    exact: bool = False,
    grid: float | None = None,
    close: bool = False,
    tolerance: float | None = None,
    weld: float | None = None,
    method: str | None = None,
    max_cells: int | None = None,
    split: bool = True,
    merge_coplanar: bool = True,
    triangles: bool | None = None,
    open: str = "refuse",
    split_pinches: bool = False,
    precision: Literal["double", "single"] = "double",
    progress: Any = False,
) -> PlanarBoolean | SolidBoolean:
    """Regions of the plane, or solids, combined exactly.

    Parameters
    ----------
    operation
        ``"union"``, ``"intersection"``, ``"difference"``, ``"xor"``, in any case, or a formula such as ``"(a | b) - c"`` or ``"(0 | 1) & !2"``.
    *models
        Anything that :func:`as_model` understands, or one list or dictionary of such.
    dimension
        2 or 3; by the models if left out. 2 leaves out the heights of maps.
    rule
        What is inside an input: ``"nonzero"``, ``"evenodd"`` or ``"positive"``.
    features
        The same as ``inputs="features"``.
    inputs
        What an input is: ``"files"`` (each model), ``"features"`` (its polygons of one name), ``"objects"``,
        ``"groups"`` or
        ``"components"`` of models. If left out, models are, and objects where a formula names more inputs than there
        are models.
    keep_walls
        Whether what lies inside the result is kept.
    snap, exact, grid, close, tolerance, weld, method, max_cells, split, merge_coplanar, precision
        As for :func:`arrange`.
    triangles
        In space, whether faces are cut into triangles; if all inputs are triangles, if left out.
    open
        In space, what becomes of an input with a rim: ``"refuse"`` it, or ``"close"`` its mouths with patches of least area.
    split_pinches
        In space, whether edges and vertices where the result is no surface are duplicated.
    progress
        As for :func:`homology`.

    Returns
    -------
    PlanarBoolean or SolidBoolean
        The result with its measure; it is input again.

    Examples
    --------
    >>> import coface
    >>> cube = coface.generate("box", boundary=True)
    >>> moved = coface.Model(cube.vertices + 0.5, cube.faces)
    >>> coface.boolean("intersection", cube, moved).measure
    0.125
    """
    _refuse_order(operation, models)
    found: PlanarBoolean | SolidBoolean = asked(
        "boolean",
        _operation(operation),
        _inputs(models, _as_solid),
        dimension=dimension,
        rule=rule,
        features=features,
        inputs=inputs,
        keep_walls=keep_walls,
        snap=snap,
        exact=exact,
        grid=grid,
        close=close,
        tolerance=tolerance,
        weld=weld,
        method=method,
        max_cells=max_cells,
        split=split,
        merge_coplanar=merge_coplanar,
        triangles=triangles,
        open=open,
        split_pinches=split_pinches,
        precision=precision,
        progress=progress,
    )
    return found


@in_words
def dissolve(
    *models: Any,
    by: str | Sequence[str],
    dimension: int | None = None,
    rule: str | None = None,
    snap: bool = False,
    exact: bool = False,
    grid: float | None = None,
    close: bool = False,
    max_cells: int | None = None,
    progress: Any = False,
) -> Model:
    """Features of maps with the same values of properties, united: one feature for each, whose common borders vanish.

    Parameters
    ----------
    *models
        Anything that :func:`as_model` understands, such as a ``GeoDataFrame``, or one list or dictionary of such.
    by
        The name of a property, or the names of several.
    dimension, rule, snap, exact, grid, close, max_cells
        As for :func:`boolean`.
    progress
        As for :func:`homology`.

    Returns
    -------
    Model
        A map. Each feature has the properties of `by`, then ``features`` (how many were united), ``area``, and what all of them have with
        one value. Features without the properties are one of their own, the last; ``warnings`` says so.

    Examples
    --------
    >>> import coface, json
    >>> ring = [[[0, 0], [1, 0], [1, 1], [0, 0]]]
    >>> feature = {"type": "Feature", "properties": {"use": "wood"}, "geometry": {"type": "Polygon", "coordinates": ring}}
    >>> found = coface.dissolve(coface.Model.from_bytes(json.dumps(feature).encode(), "geojson"), by="use")
    >>> found.__geo_interface__["features"][0]["properties"]
    {'use': 'wood', 'features': 1, 'area': 0.5}
    """
    return _coface.dissolve(
        _inputs(models),
        [by] if isinstance(by, str) else list(by),
        dimension=dimension,
        rule=rule,
        snap=snap,
        exact=exact,
        grid=grid,
        close=close,
        max_cells=max_cells,
        progress=progress,
    )


@in_words
def persistence(
    x: Any,
    vertex_values: Any = None,
    *,
    cell_values: Sequence[Any] | None = None,
    coefficients: str | int = "f2",
    upper: bool = False,
    least: float = 0.0,
    relative: Any = None,
    image_of: Any = None,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the filtration that values make.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands. A ``SimplexTree`` of gudhi brings its own values.
    vertex_values
        A number for each vertex of `x` by its id, an array of shape ``(n,)``, the name of data on its vertices, or a coordinate by its name, ``"x"``,
        ``"y"`` or ``"z"``: a cell comes with its last vertex.
    cell_values
        For each degree a number for each cell, an array of shape ``(cells,)``; NaN where a cell comes as late as its cofaces allow.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    upper
        Whether a cell comes with its first vertex and values fall; for `vertex_values` alone.
    least
        Classes that live no longer than this are left out.
    relative
        A part of `x` that is divided out, as for :func:`homology`: classes are those of the cells outside of it, as they come, and cells have the numbers that
        they have in ``chain_complex(relative)``.
    image_of
        A part of `x`, as for `relative`, whose classes are followed as the whole sees them (image persistence): they are born in the part, and die when they bound in the whole. It has no cycles.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths.

    Examples
    --------
    A path that goes up to 2 and down to 1:

    >>> import coface
    >>> coface.persistence([[0, 1], [1, 2]], [0.0, 2.0, 1.0]).diagram(0)
    array([[ 0., inf],
           [ 1.,  2.]])

    A disk relative to its boundary, and the boundary in the disk:

    >>> disk = [[0, 1, 3], [1, 2, 3], [2, 0, 3]]
    >>> coface.persistence(disk, [0.0, 1.0, 2.0, 5.0], relative="boundary").diagram(2)
    array([[ 5., inf]])
    >>> coface.persistence(disk, [0.0, 1.0, 2.0, 5.0], image_of="boundary").diagram(1)
    array([[2., 5.]])
    """
    x = _held(x, progress)
    part = relative if image_of is None else image_of
    if relative is not None and image_of is not None:
        raise_invalid("persistence is relative to a part, or of its image in the whole", "give relative or image_of, not both")
    given = x
    if part is not None:
        # Cells and those of the part have the numbers that they have in the model.
        x = as_cells(x, progress=progress)
    complex = as_chain_complex(x, progress=progress)
    if vertex_values is None and cell_values is None:
        if not hasattr(given, "get_simplices"):
            raise_invalid("persistence needs values", "give vertex_values or cell_values; of an image ask coface.cubical(x)")
        from coface.interop import gudhi

        cell_values = gudhi.values(given, complex)
    if vertex_values is not None:
        vertex_values = _at_vertices(vertex_values, x, complex)
    if cell_values is not None and upper:
        raise_invalid(
            "values of cells fall only where those of vertices do: upper=True is for vertex_values",
            "give the negative of each, without upper, and take the negative of what is finite in the diagram",
        )
    if cell_values is not None:
        cell_values = [_at_cells(values, degree, complex) for degree, values in enumerate(cell_values)]
    options: dict[str, Any] = {}
    if part is not None:
        divided = x.chain_complex(part if _are_groups(x, part) else part_of(x, part), progress=progress)
        options = {"part": _coface._cells_of_part(complex, divided), "image": image_of is not None}
    found: Persistence = asked(
        "persistence",
        complex,
        vertex_values=vertex_values,
        cell_values=cell_values,
        coefficients=coefficients,
        upper=upper,
        least=least,
        progress=progress,
        **options,
    )
    if part is None and vertex_values is not None and isinstance(x, (Model, Complex, Surface)):
        function = vertex_values.tolist()
        remember(found, "persistence", x, function=function, coefficients=coefficients, upper_star=upper, min_persistence=least)
    return found


def _coordinate(values: Any, x: Any) -> Any:
    """The coordinate of this name at each vertex of a model; values as they are."""
    if not isinstance(values, str):
        return values
    model = as_cells(x)
    named = [data for name, place, data in model.data if name == values and place == "vertices" and np.ndim(data) == 1]
    if named:
        return np.asarray(named[0], np.float64)
    if values not in ("x", "y", "z"):
        known = ", ".join(repr(name) for name, place, data in model.data if place == "vertices" and np.ndim(data) == 1)
        cure = 'give "x", "y" or "z", or a number for each vertex' + (f"; the data on the vertices are {known}" if known else "")
        raise_invalid(f"the values are {values!r}", cure)
    points, axis = model.vertices, "xyz".index(values)
    if points is None or np.shape(points)[1] <= axis:
        raise_invalid(f"the vertices of the model have no coordinate {values}", "give a number for each vertex")
    return np.asarray(points)[:, axis]


@in_words
def extended_persistence(
    x: Any,
    vertex_values: Any,
    *,
    coefficients: str | int = "f2",
    least: float = 0.0,
    progress: Any = False,
) -> dict[str, list[tuple[int, tuple[float, float]]]]:
    """Extended persistence of a function on vertices: of growing sublevel sets, then of the whole relative to growing superlevel sets, where all classes die.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    vertex_values
        A number for each vertex of `x` by its id, an array of shape ``(n,)``, or ``"x"``, ``"y"`` or ``"z"``.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Ordinary and relative classes that live no longer than this are left out; those of the whole complex are all listed.
    progress
        As for :func:`homology`.

    Returns
    -------
    dict
        ``(degree, (birth, death))`` of the classes of each kind: ``"ordinary"``, ``"relative"``, ``"extended+"`` with deaths no lower than births, and ``"extended-"``. A relative
        class has the degree of relative homology.

    Examples
    --------
    A circle at the heights 0, 2, 1, 3:

    >>> import coface
    >>> found = coface.extended_persistence([[0, 1], [1, 2], [2, 3], [3, 0]], [0.0, 2.0, 1.0, 3.0])
    >>> found["ordinary"], found["relative"]
    ([(0, (1.0, 2.0))], [(1, (2.0, 1.0))])
    >>> found["extended+"], found["extended-"]
    ([(0, (0.0, 3.0))], [(1, (3.0, 0.0))])
    """
    complex = as_chain_complex(x, progress=progress)
    values = _at_vertices(vertex_values, x, complex)
    kinds: dict[str, list[tuple[int, tuple[float, float]]]] = {"ordinary": [], "relative": [], "extended+": [], "extended-": []}
    for kind, degree, birth, death in _coface._extended_persistence(complex, values, coefficients=coefficients, least=least):
        kinds[kind].append((degree, (birth, death)))
    return FactsAnswer(kinds)


@in_words
def vineyard(
    x: Any,
    functions: Any,
    *,
    coefficients: str | int = "f2",
    least: float = 0.0,
    progress: Any = False,
) -> list[tuple[int, NDArray[np.float64]]]:
    """The vines of functions on vertices: the paths of the points of the persistence diagram while the first function becomes the second one, and so on, each vertex along a line.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    functions
        For each function a number for each vertex of `x` by its id: an array of shape ``(k, n)``, or a list of arrays. Their parameters are 0, 1, ..
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Vines whose persistence is nowhere greater are left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of tuple
        For each vine its degree and an array of shape ``(points, 3)``: parameter, birth and death where it bends and at the functions along its way, the death inf for a class that
        stays. A vine that begins or ends between functions does so on the diagonal.

    Examples
    --------
    A path whose valley at the end becomes flat:

    >>> import coface
    >>> (_, _), (degree, points) = coface.vineyard([[0, 1], [1, 2]], [[0.0, 4.0, 2.0], [0.0, 4.0, 6.0]])
    >>> degree, points.tolist()
    (0, [[0.0, 2.0, 4.0], [0.5, 4.0, 4.0]])
    """
    complex = as_chain_complex(x, progress=progress)
    values = [_at_vertices(function, x, complex) for function in functions]
    return ListAnswer(_coface._vineyard(complex, values, coefficients=coefficients, least=least, progress=progress))


@in_words
def zigzag(
    steps: Any,
    times: Any = None,
    *,
    coefficients: str | int = "f2",
    least: float = 0.0,
) -> dict[str, list[tuple[int, tuple[float, float]]]]:
    """Zigzag persistence: the classes of a complex that gains and loses simplices.

    A simplex is there at the time at which it enters, and still at the time at which it leaves. Faces enter before cofaces and leave behind them.

    Parameters
    ----------
    steps
        Steps ``("i", simplex)`` where a simplex enters and ``("d", simplex)`` where it leaves, with times as a third entry or the numbers 1, 2, ..; or simplices, if `times` are
        given; or the path of a file with lines ``i 0 1`` and ``d 0 1`` as fzz has them, or of the JSON that ``coface persistence --zigzag`` reads.
    times
        For each simplex the times at which it enters, leaves, enters again, and so on, as Dionysus has them. At one time simplices enter first, by rising dimension, then others
        leave.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.

    Returns
    -------
    dict
        ``(degree, (birth, death))`` of the classes of each kind: ``"closed-open"``, ``"closed-closed"``, ``"open-closed"`` and ``"open-open"`` say whether a class is there at the
        time of its birth and at that of its death. A class that is there at the end has the death inf.

    Examples
    --------
    Two points that an edge joins from 2 to 5:

    >>> import coface
    >>> found = coface.zigzag([[0], [1], [0, 1]], [[0], [1, 8], [2, 5]])
    >>> found["closed-open"], found["open-closed"]
    ([(0, (0.0, inf)), (0, (1.0, 2.0))], [(0, (5.0, 8.0))])
    >>> coface.zigzag([("i", [0]), ("d", [0])])["closed-closed"]
    [(0, (1.0, 2.0))]
    """
    if not isinstance(steps, (str, os.PathLike)):
        if times is not None:
            times = [[float(time) for time in stays] for stays in times]
            steps = [[int(vertex) for vertex in simplex] for simplex in steps]
        else:
            steps = [_step(step) for step in steps]
    kinds: dict[str, list[tuple[int, tuple[float, float]]]] = {"closed-open": [], "closed-closed": [], "open-closed": [], "open-open": []}
    for kind, degree, birth, death in _coface._zigzag(steps, times, coefficients=coefficients, least=least):
        kinds[kind].append((degree, (birth, death)))
    return FactsAnswer(kinds)


def _step(step: Any) -> tuple[Any, ...]:
    """A step of a zigzag: a letter, the vertices of a simplex, and its time if it has one."""
    try:
        letter, simplex, *time = step
        return letter, [int(vertex) for vertex in simplex], *map(float, time)
    except (TypeError, ValueError):
        raise_invalid(f"{step!r} is no step of a zigzag", 'give ("i", simplex) where a simplex enters and ("d", simplex) where it leaves, with a time behind if there are times')


def _distances(x: Any, distances: Any) -> tuple[Any, Any]:
    """Points or distances as rows, and what these are."""
    if hasattr(x, "tocoo"):
        entries = x.tocoo()
        # Both places of a pair say the same: the lower one is kept, and the upper one where the lower is not stored.
        stored: dict[tuple[int, int], float] = {}
        for i, j, distance in zip(entries.row.tolist(), entries.col.tolist(), entries.data.tolist(), strict=True):
            if i == j:
                continue
            pair = (max(i, j), min(i, j))
            if stored.setdefault(pair, float(distance)) != float(distance):
                raise_invalid(f"the distance of the points {pair[1]} and {pair[0]} is {stored[pair]} and {distance}", "give one")
        # The last point may be at no stored distance to another: it is at 0 to itself.
        last = entries.shape[0] - 1
        x, distances = [[i, j, distance] for (i, j), distance in stored.items()] + [[last, last, 0.0]], "sparse"
    elif distances is None or distances in ("square", "sparse"):
        x = numbers(x, "x")
        if x.ndim != 2:
            raise_invalid(f"x has the shape {x.shape}", "give an array of two axes, a row for each point")
    return x, distances


@in_words
def rips(
    x: Any,
    *,
    dimension: int = 1,
    threshold: float | None = None,
    distances: Literal["points", "lower", "upper", "square", "sparse"] | None = None,
    coefficients: str | int = "f2",
    least: float = 0.0,
    collapse: bool = False,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the Vietoris-Rips filtration of points or of distances.

    Parameters
    ----------
    x
        Points, an array of shape ``(points, coordinates)``; a sparse matrix of distances, of which what is not stored is infinite; or what
        `distances` says.
    dimension
        The highest degree of classes.
    threshold
        The largest diameter of simplices; the enclosing radius if not given, behind which nothing changes.
    distances
        What `x` has: ``"square"``, the distances of all points to all; ``"lower"`` or ``"upper"``, those of each point to the points before it or
        behind it; ``"sparse"``, rows of two points, from 0 on, and their distance; or ``"points"``. If not given, a symmetric array of numbers from 0
        on with zeros on its diagonal has distances, with a warning, and any other has points.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.
    collapse
        Whether edges are collapsed before (Glisse and Pritam, 2022): the diagram is the same, found from fewer simplices, among which are those that make and end classes. ``collapsed`` has the
        numbers of edges before and after. There are no cycles then.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``simplices(degree)`` has the points that make and end each class, and ``cycles(degree)``
        cycles, bounding chains and cocycles, for which simplices up to the last death are stored.

    Examples
    --------
    The corners of a square:

    >>> import coface
    >>> coface.rips([[0, 0], [3, 0], [3, 4], [0, 4]], dimension=1).diagram(1)
    array([[4., 5.]])
    >>> coface.rips([[0, 0], [1, 0], [2, 0], [3, 0]], threshold=3, collapse=True).collapsed
    (6, 3)
    >>> coface.rips([[3], [5, 4]], distances="lower", dimension=0).diagram(0)
    array([[ 0., inf],
           [ 0.,  3.],
           [ 0.,  4.]])
    """
    x, distances = _distances(x, distances)
    found: Persistence = asked(
        "rips",
        x,
        form=distances,
        dimension=dimension,
        threshold=threshold,
        coefficients=coefficients,
        least=least,
        collapse=collapse,
        progress=progress,
    )
    return found


@in_words
def rips_complex(
    x: Any,
    threshold: float | None = None,
    dimension: int | None = None,
    *,
    distances: Literal["points", "lower", "upper", "square", "sparse"] | None = None,
) -> Model:
    """The Vietoris-Rips complex of points or of distances as a model.

    Parameters
    ----------
    x
        As for :func:`rips`.
    threshold
        The largest diameter of simplices; the enclosing radius if not given.
    dimension
        The highest dimension of simplices, 2 if not given.
    distances
        As for :func:`rips`.

    Returns
    -------
    Model
        Tetrahedra, the triangles and edges in none of them, and points, where points have at most three coordinates; else simplices.

    Examples
    --------
    >>> import coface
    >>> coface.homology(coface.rips_complex([[0, 0], [3, 0], [3, 4], [0, 4]], threshold=4)).betti_numbers
    (1, 1)
    """
    x, distances = _distances(x, distances)
    return _coface.rips_complex(x, form=distances, threshold=threshold, dimension=dimension)


def _edges(edges: Any, vertex_values: Any) -> Any:
    """The path of a graph, or its rows, with the values of vertices behind them."""
    if isinstance(edges, (str, os.PathLike)):
        if vertex_values is not None:
            raise_invalid("the file of a graph has the values of its vertices", "leave vertex_values out, or give rows of edges")
        return os.fspath(edges)
    table: list[list[float]]
    if hasattr(edges, "nodes") and hasattr(edges, "edges"):
        place = {node: number for number, node in enumerate(edges.nodes)}
        table = [[number] for number in place.values()]
        table += [[place[i], place[j], float(value)] for i, j, value in edges.edges(data="weight", default=1.0) if i != j]
    else:
        table = []
        if hasattr(edges, "tocoo"):
            entries = edges.tocoo()
            if len(entries.shape) != 2 or entries.shape[0] != entries.shape[1]:
                raise_invalid(f"the matrix of edges has the shape {entries.shape}", "give a square one, a row and a column for each vertex")
            # Vertices without an edge are there too.
            table = [[vertex] for vertex in range(entries.shape[0])]
            edges = np.column_stack([entries.row, entries.col, entries.data])
        elif _is_matrix(rows := numbers(edges, "edges")):
            raise_invalid(
                f"edges have the shape {rows.shape}, are symmetric and have zeros on the diagonal: they could be a matrix of values",
                "give scipy.sparse.coo_array(x) for a matrix, or rows of two vertices and a value, the smaller vertex first",
            )
        rows = numbers(edges, "edges")
        if rows.size and (rows.ndim != 2 or rows.shape[1] not in (2, 3)):
            cure = "give rows of two vertices and a value"
            is_square = rows.ndim == 2 and rows.shape[0] == rows.shape[1]
            raise_invalid(f"edges have the shape {rows.shape}", f"{cure}, or scipy.sparse.coo_array(x) for a matrix of values" if is_square else cure)
        table += rows.reshape(len(rows), -1).tolist() if rows.size else []
    if vertex_values is not None:
        values = vertex_values.items() if isinstance(vertex_values, Mapping) else enumerate(numbers(vertex_values, "vertex_values").tolist())
        table += [[vertex, vertex, value] for vertex, value in values]
    return table


def _is_matrix(rows: NDArray[np.float64]) -> bool:
    """Whether rows of edges could be the values of all edges."""
    return rows.shape in ((2, 2), (3, 3)) and bool((rows == rows.T).all() and not np.diag(rows).any() and rows.any())


@in_words
def flag(
    edges: Any,
    vertex_values: Any = None,
    *,
    directed: bool = False,
    dimension: int = 1,
    threshold: float | None = None,
    coefficients: str | int = "f2",
    least: float = 0.0,
    collapse: bool = False,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the flag complex (clique complex) of a weighted graph.

    A simplex for each set of vertices of which each two are joined enters with its last edge. No complex is stored, as with :func:`rips`. Where vertices have names,
    simplices have their numbers in the order of the file, and ``vertex_names`` the names.

    Parameters
    ----------
    edges
        Rows ``u, v, value`` of two vertices, whole numbers from 0 on, and the value at which their edge enters; rows ``u, v`` are edges of the value 1, and
        ``u, u, value`` is a vertex that enters at the value. Of an edge that is given twice the smaller value is taken, with a warning. Or a square sparse
        matrix of values, with a vertex for each row; a graph of networkx, whose nodes are numbered in its order and whose edges enter at their ``weight``; or the path of an edge list or
        of GraphML, where vertices may have names.
    vertex_values
        A mapping of vertices to the values at which they enter, or a value for each vertex from 0 on; vertices without one enter at 0, or with their first
        edge if that is sooner. Vertices in no edge are taken from here.
    directed
        Whether edges have directions, from `u` to `v`: a simplex is a list of vertices with an edge from each to each later one, so that ``u, v`` and ``v, u``
        make a loop (directed flag complex, as of flagser). This complex is stored.
    dimension
        The highest degree of classes.
    threshold
        The value at which the complex ends.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.
    collapse
        Whether edges are collapsed before (Glisse and Pritam, 2022): the diagram is the same, found from fewer simplices, among which are those that make and end classes. ``collapsed`` has the
        numbers of edges before and after. There are no cycles then.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``simplices(degree)`` has the vertices that make and end each class.

    Examples
    --------
    A cycle of four vertices, and a diagonal that comes later:

    >>> import coface
    >>> coface.flag([[0, 1, 1], [1, 2, 2], [2, 3, 3], [3, 0, 4], [0, 2, 6]]).diagram(1)
    array([[4., 6.]])

    Two edges that lead to and fro:

    >>> coface.flag([[0, 1, 1], [1, 0, 2]], directed=True).diagram(1)
    array([[ 2., inf]])
    """
    table = _edges(edges, vertex_values)
    found: Persistence = asked(
        "flag",
        table,
        directed=directed,
        dimension=dimension,
        threshold=threshold,
        coefficients=coefficients,
        least=least,
        collapse=collapse,
        progress=progress,
    )
    return found


@in_words
def flag_complex(
    edges: Any,
    vertex_values: Any = None,
    *,
    directed: bool = False,
    threshold: float | None = None,
    dimension: int | None = None,
) -> Model:
    """The flag complex (clique complex) of a graph at a value as a model.

    Parameters
    ----------
    edges
        As for :func:`flag`.
    vertex_values
        As for :func:`flag`.
    directed
        As for :func:`flag`.
    threshold
        The value at which the complex ends.
    dimension
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Simplices of vertices; if edges have directions a chain complex, whose cells of each degree are the lists of vertices in lexicographic order.

    Examples
    --------
    >>> import coface
    >>> cycle = [[0, 1, 1], [1, 2, 2], [2, 3, 3], [3, 0, 4], [0, 2, 6]]
    >>> coface.homology(coface.flag_complex(cycle, threshold=5)).betti_numbers
    (1, 1)
    """
    return _coface.flag_complex(_edges(edges, vertex_values), directed=directed, threshold=threshold, dimension=dimension)


@in_words
def cech(
    points: Any,
    *,
    threshold: float | None = None,
    dimension: int = 1,
    coefficients: str | int = "f2",
    least: float = 0.0,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the Čech complex of points of any dimension.

    A set of points enters at the radius of the smallest ball that holds it, as in ``Cech_complex`` of GUDHI in C++. Diagrams are those of :func:`alpha` with ``radii=True``,
    which takes less time and memory where points have at most three coordinates.

    Parameters
    ----------
    points
        An array of shape ``(points, coordinates)``.
    threshold
        The largest radius of balls; that of a ball that holds all points if not given, behind which nothing changes.
    dimension
        The highest degree of classes.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``simplices(degree)`` has the points that make and end each class.

    Examples
    --------
    The corners of a rectangle:

    >>> import coface
    >>> coface.cech([[0, 0], [6, 0], [6, 8], [0, 8]]).diagram(1)
    array([[4., 5.]])
    """
    found: Persistence = asked(
        "cech",
        point_rows(points, None),
        threshold=threshold,
        dimension=dimension,
        coefficients=coefficients,
        least=least,
        progress=progress,
    )
    return found


@in_words
def cech_complex(points: Any, threshold: float | None = None, dimension: int | None = None) -> Model:
    """The Čech complex of points at a radius as a model.

    Parameters
    ----------
    points
        As for :func:`cech`.
    threshold
        As for :func:`cech`.
    dimension
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Tetrahedra, the triangles and edges in none of them, and points, where points have at most three coordinates; else simplices.

    Examples
    --------
    >>> import coface
    >>> coface.homology(coface.cech_complex([[0, 0], [6, 0], [6, 8], [0, 8]], threshold=4)).betti_numbers
    (1, 1)
    """
    return _coface.cech_complex(point_rows(points, None), threshold=threshold, dimension=dimension)


@in_words
def witness(
    points: Any,
    landmarks: int,
    *,
    strong: bool = False,
    threshold: float | None = None,
    dimension: int = 1,
    coefficients: str | int = "f2",
    least: float = 0.0,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the witness complex of landmarks among points of any dimension.

    Landmarks are the first point, then again and again the point that is farthest from those before it. A set of landmarks enters at the least ``a`` for which a
    point has squared distances to all of them that are at most ``a`` more than that to any other landmark, as in ``EuclideanWitnessComplex`` of GUDHI.

    Parameters
    ----------
    points
        An array of shape ``(points, coordinates)``: the witnesses.
    landmarks
        How many landmarks are chosen: the vertices, numbered in the order in which they are chosen.
    strong
        Whether all landmarks of a set are as near to a witness as the nearest one, as in ``EuclideanStrongWitnessComplex`` of GUDHI.
    threshold
        The largest value, as ``max_alpha_square`` of GUDHI; all sets if not given.
    dimension
        The highest degree of classes.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``simplices(degree)`` has the landmarks that make and end each class.

    Examples
    --------
    Two landmarks with a point between them:

    >>> import coface
    >>> coface.witness([[0.0], [1.0], [4.0]], 2, strong=True, dimension=0).diagram(0)
    array([[ 0., inf],
           [ 0.,  8.]])
    """
    found: Persistence = asked(
        "witness",
        point_rows(points, None),
        _landmarks(landmarks),
        strong=strong,
        threshold=threshold,
        dimension=dimension,
        coefficients=coefficients,
        least=least,
        progress=progress,
    )
    return found


def _landmarks(count: Any) -> int:
    """How many landmarks are chosen."""
    if isinstance(count, (int, np.integer)) and not isinstance(count, bool):
        return int(count)
    shape = np.shape(count) if isinstance(count, (list, tuple, np.ndarray)) else ()
    what = f"an array of shape {shape}" if shape else f"a {type(count).__name__}"
    raise_invalid(f"landmarks is {what}", "give how many are chosen among the points, such as landmarks=20; they are spread over the points")


@in_words
def witness_complex(
    points: Any,
    landmarks: int,
    threshold: float | None = None,
    dimension: int | None = None,
    *,
    strong: bool = False,
) -> Model:
    """The witness complex of landmarks among points at a value as a model.

    Parameters
    ----------
    points
        As for :func:`witness`.
    landmarks
        As for :func:`witness`.
    threshold
        As for :func:`witness`.
    dimension
        The highest dimension of simplices, 2 if not given.
    strong
        As for :func:`witness`.

    Returns
    -------
    Model
        Tetrahedra, the triangles and edges in none of them, and landmarks, where points have at most three coordinates; else simplices.

    Examples
    --------
    >>> import coface
    >>> ring = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1]]
    >>> coface.homology(coface.witness_complex(ring, 4, threshold=0)).betti_numbers
    (1, 1)
    """
    return _coface.witness_complex(point_rows(points, None), _landmarks(landmarks), strong=strong, threshold=threshold, dimension=dimension)


@in_words
def alpha(
    points: Any,
    weights: Any = None,
    *,
    bound: float | None = None,
    radii: bool = False,
    periods: Any = None,
    coefficients: str | int = "f2",
    least: float = 0.0,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of the alpha complex of points of at most three coordinates.

    Values are squared radii, as those of ``gudhi.AlphaComplex``; each is the number nearest to the exact one. They are those at which balls around the
    points meet, so that :func:`rips`, whose values are diameters, has at least twice the radii.

    Parameters
    ----------
    points
        An array of shape ``(points, coordinates)``.
    weights
        A weight for each point, a squared radius that is added to that of its ball: the simplices are those of the regular triangulation.
    bound
        The value at which the complex ends, as ``max_alpha_square`` of GUDHI.
    radii
        Whether values, and the bound, are radii instead of squared radii, as with ``output_squared_values=False`` of GUDHI.
    periods
        The lengths after which the points repeat, one for each coordinate, as those of a crystal or a simulation do: the complex is that of a flat torus.
        Points may be few, and outside of the box.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``simplices(degree)`` has the points that make and end each class.

    Examples
    --------
    The corners of a rectangle:

    >>> import coface
    >>> coface.alpha([[0, 0], [6, 0], [6, 8], [0, 8]]).diagram(1)
    array([[16., 25.]])
    >>> coface.alpha([[0, 0], [6, 0], [6, 8], [0, 8]], radii=True).diagram(1)
    array([[4., 5.]])

    A square lattice, of which one point is given: two circles and a torus for ever.

    >>> coface.alpha([[0, 0]], periods=[2, 2]).betti_numbers
    (1, 2, 1)
    """
    found: Persistence = asked(
        "alpha",
        point_rows(points, weights),
        weighted=weights is not None,
        bound=bound,
        radii=radii,
        periods=periods,
        coefficients=coefficients,
        least=least,
        progress=progress,
    )
    return found


@in_words
def alpha_complex(
    points: Any,
    weights: Any = None,
    bound: float | None = None,
    *,
    radii: bool = False,
    periods: Any = None,
) -> Model:
    """The alpha complex of points at a value, or their whole Delaunay triangulation, as a model.

    Parameters
    ----------
    points
        As for :func:`alpha`.
    weights
        As for :func:`alpha`.
    bound
        The value: a squared radius, or a radius if `radii` is true. Without it the model is the whole triangulation.
    radii
        As for :func:`alpha`.
    periods
        As for :func:`alpha`.

    Returns
    -------
    Model
        Tetrahedra, the triangles and edges in none of them, and points. Where points are in no simplex, because they equal others or weights hide
        them, the others are numbered anew, and data ``point`` has their numbers; a warning says so. With `periods` it is a list of simplices, or a chain
        complex if a simplex has a point twice or two have the same points, and has no positions.

    Examples
    --------
    >>> import coface
    >>> corners = [[0, 0], [6, 0], [6, 8], [0, 8]]
    >>> coface.homology(coface.alpha_complex(corners, bound=16)).betti_numbers
    (1, 1)
    >>> coface.alpha_complex(corners).faces.shape
    (2, 3)
    """
    table = point_rows(points, weights)
    return _coface.alpha_complex(table, weighted=weights is not None, bound=bound, radii=radii, periods=periods)


def image_of(x: Any, mask: Any) -> tuple[NDArray[Any], NDArray[np.bool_] | None]:
    """The values of an image, contiguous, and which voxels are inside."""
    if isinstance(x, (str, os.PathLike)):
        values = _coface._values_of_volume(x)
        if values is None:
            raise_invalid(f"{os.fspath(x)!r} is no volume", "give an array, or a file of the format .npy, NRRD, NIfTI, MetaImage, PGM or PNG")
        x = values
    if isinstance(x, np.ma.MaskedArray):
        # What is masked is outside.
        inside = ~np.ma.getmaskarray(x)
        given = None if mask is None else np.asarray(plain(mask))
        mask = inside if given is None else inside & (given != 0) if given.shape == inside.shape else given
        x = np.ma.getdata(x)
    x = np.asarray(plain(x))
    if x.dtype != np.float32:
        x = numbers(x, "x")
        # Made here: the answer need not copy it to remember it.
        x.flags.writeable = False
    if x.ndim == 0:
        raise_invalid("an array without axes has no voxels", "give an array with one to four axes")
    if mask is not None:
        mask = np.asarray(plain(mask))
        if mask.dtype.kind not in "biuf":
            raise_invalid(f"a mask of {mask.dtype} has no truth values", "give truth values")
        mask = np.ascontiguousarray(mask != 0)
    return np.ascontiguousarray(x), mask


@in_words
def cubical(
    x: Any,
    *,
    construction: Literal["t", "v"] = "t",
    superlevel: bool = False,
    periodic: Sequence[int] = (),
    mask: Any = None,
    coefficients: str | int = "f2",
    least: float = 0.0,
    cycles: bool = False,
    progress: Any = False,
) -> Persistence:
    """Persistent homology of an image as its sublevel sets grow, or its superlevel sets.

    Parameters
    ----------
    x
        An array of numbers with one to four axes, or a file: ``.npy``, NRRD, NIfTI, MetaImage, PGM or PNG. A voxel that is NaN never enters, and neither does one at
        infinity.
    construction
        ``"t"``: voxels are top cells, as ``top_dimensional_cells`` of gudhi and ``tcripser``; ``"v"``: voxels are vertices, as ``vertices`` of gudhi
        and ``cripser``.
    superlevel
        Whether superlevel sets grow, from high values to low ones. Births and deaths are values of the image all the same.
    periodic
        The axes whose last voxel meets their first.
    mask
        Truth values in the shape of `x`: which voxels are inside. Those that a masked array of numpy masks are outside.
    coefficients
        A prime field: ``"f2"``, ``"f3"``, ...
    least
        Classes that live no longer than this are left out; those that die at once always are.
    cycles
        Whether the cubes are kept, so that ``cycles(degree)`` of the answer gives cycles, the chains that they bound and cocycles. The cells of these are lists of
        vertices: in the T-construction those of ``coface.volume`` of the voxels that enter, in the V-construction voxels, numbered along the last axis first.
    progress
        As for :func:`homology`.

    Returns
    -------
    Persistence
        ``diagram(degree)`` is an array ``(n, 2)`` of births and deaths, ``voxels(degree)`` has the voxels with these values.

    Examples
    --------
    A ring of low pixels around a high one:

    >>> import coface
    >>> found = coface.cubical([[1, 2, 1], [2, 9, 2], [1, 2, 1]])
    >>> found.diagram(1)
    array([[2., 9.]])
    >>> found.voxels(1)[0, 1]
    array([1, 1])
    >>> coface.cubical([0, 5, 1, 2], superlevel=True).diagram(0)
    array([[  5., -inf],
           [  2.,   1.]])

    A loop around the high pixel, through the side of a pixel that comes last and closes it:

    >>> ((rim, filling, _),) = coface.cubical([[1, 1, 1], [1, 9, 1], [1, 1, 1]], cycles=True).cycles(1)
    >>> len(rim.cells), len(filling.cells)
    (6, 2)
    """
    x, mask = image_of(x, mask)
    _, _, axes = voxel_rule(periodic=periodic)
    found: Persistence = asked(
        "cubical",
        x,
        construction=construction,
        superlevel=superlevel,
        periodic=axes,
        mask=mask,
        coefficients=coefficients,
        least=least,
        cycles=cycles,
        progress=progress,
    )
    return found


@overload
def bottleneck(a: Any, b: Any, *, degree: int | None = None, matching: Literal[False] = False) -> float: ...
@overload
def bottleneck(a: Any, b: Any, *, degree: int | None = None, matching: Literal[True]) -> tuple[float, list[NDArray[np.int64]]]: ...
@in_words
def bottleneck(a: Any, b: Any, *, degree: int | None = None, matching: bool = False) -> Any:
    """The bottleneck distance of two persistence diagrams: the length of the longest pair of the matching in which it is shortest.

    A pair is as long as the greater one of the differences of births and of deaths; a class that goes to the diagonal, half of its persistence. The
    distance is exact. Classes are matched with classes of their degree.

    Parameters
    ----------
    a, b
        A :class:`Persistence`; an array ``(n, 2)`` of births and deaths; a list of such arrays, one for each degree, as of Ripser; or a list of
        ``(degree, (birth, death))``, as of GUDHI. What never dies has the death inf.
    degree
        The classes of this degree alone; all if not given.
    matching
        Whether the matching is returned too.

    Returns
    -------
    float or tuple
        The distance, inf if the numbers of classes that never die differ. With `matching` also a list with an array ``(n, 2)`` for each degree (for
        `degree` alone if it is given): the rows of matched classes in `a` and in `b`, -1 for the diagonal.

    Examples
    --------
    >>> import coface
    >>> coface.bottleneck([[0, 4], [1, 1.5]], [[0.5, 4]])
    0.5
    >>> coface.bottleneck([(0, (0, float("inf"))), (1, (2, 6))], [(0, (0.25, float("inf")))], matching=True)
    (2.0, [array([[0, 0]]), array([[ 0, -1]])])
    """
    distance, pairs = _coface._diagram_distance(_degrees(a, "a"), _degrees(b, "b"), degree=degree)
    return (distance, pairs) if matching else distance


@overload
def wasserstein(
    a: Any, b: Any, *, order: float = 1.0, internal_p: float = np.inf, degree: int | None = None, matching: Literal[False] = False
) -> float: ...
@overload
def wasserstein(
    a: Any, b: Any, *, order: float = 1.0, internal_p: float = np.inf, degree: int | None = None, matching: Literal[True]
) -> tuple[float, list[NDArray[np.int64]]]: ...
@in_words
def wasserstein(
    a: Any, b: Any, *, order: float = 1.0, internal_p: float = np.inf, degree: int | None = None, matching: bool = False
) -> Any:
    """The Wasserstein distance of two persistence diagrams: the root of the sum of powers of the lengths of matched pairs, at its least.

    It is exact but for rounding. Classes are matched with classes of their degree; the distance of all degrees is the root of the sum of all powers.

    Parameters
    ----------
    a, b
        As for :func:`bottleneck`.
    order
        The power, from 1 on.
    internal_p
        The exponent of the norm that measures a pair, from 1 on; ``numpy.inf`` takes the greater one of the differences. (gudhi's default is inf, persim's
        2.)
    degree, matching
        As for :func:`bottleneck`.

    Returns
    -------
    float or tuple
        As for :func:`bottleneck`.

    Examples
    --------
    >>> import coface
    >>> coface.wasserstein([[0, 6], [5, 6]], [[3, 10]])
    4.5
    >>> coface.wasserstein([[0, 6], [5, 6]], [[3, 10]], order=2, internal_p=1)
    7.0710678118654755
    """
    distance, pairs = _coface._diagram_distance(_degrees(a, "a"), _degrees(b, "b"), order=order, internal_p=internal_p, degree=degree)
    return (distance, pairs) if matching else distance


def _degrees(x: Any, name: str) -> list[NDArray[np.float64]]:
    """For each degree births and deaths, one after the other."""
    if isinstance(x, Persistence):
        return [diagram.reshape(-1) for diagram in x.diagrams]
    if isinstance(x, (list, tuple)) and x and all(isinstance(pair, (list, tuple)) and len(pair) == 2 for pair in x):
        if all(isinstance(pair[0], (int, np.integer)) and np.ndim(pair[1]) == 1 for pair in x):
            # The pairs of GUDHI.
            found: list[list[float]] = [[] for _ in range(1 + max(int(pair[0]) for pair in x))]
            for degree, interval in x:
                if degree < 0 or len(interval) != 2:
                    raise_invalid(f"{name} has the class {(degree, interval)}", "give (degree, (birth, death))")
                found[degree].extend(interval)
            return [np.array(intervals, np.float64) for intervals in found]
    if isinstance(x, (list, tuple)) and x and any(np.ndim(part) == 2 or np.size(part) == 0 for part in x):
        return [_intervals(part, name) for part in x]
    return [_intervals(x, name)]


def _intervals(x: Any, name: str) -> NDArray[np.float64]:
    """Births and deaths of a degree, one after the other."""
    found = np.asarray(plain(x), np.float64)
    if found.size and (found.ndim != 2 or found.shape[1] != 2):
        raise_invalid(f"{name} has the shape {found.shape}", "give an array of shape (n, 2): births and deaths")
    return found.reshape(-1)


def _at_vertices(values: Any, x: Any, complex: ChainComplex) -> NDArray[np.float64]:
    """Values by the ids of vertices, in the order of the cells of degree 0."""
    found = numbers(_coordinate(values, x), "vertex_values")
    ids = np.asarray(complex.simplices(0)).reshape(-1)
    wanted = 1 + int(ids.max(initial=-1))
    # A file may have vertices that nothing uses.
    counts = {wanted, x.vertex_count} if isinstance(x, Model) and x.structure is None else {wanted}
    if found.ndim != 1 or len(found) not in counts:
        raise_invalid(
            f"vertex_values have the shape {found.shape}, and the vertices have ids below {wanted}",
            f"give an array of shape ({max(counts)},): a value for each id; values of cells go to cell_values",
            [[wanted - 1]] if found.ndim == 1 and 0 < len(found) < wanted else (),
        )
    placed: NDArray[np.float64] = found[ids]
    return placed


def _at_cells(values: Any, degree: int, complex: ChainComplex) -> NDArray[np.float64]:
    """Values in the order of the cells of a degree."""
    found = numbers(values, f"cell_values[{degree}]")
    count = complex.cell_count(degree)
    if found.shape != (count,):
        raise_invalid(
            f"cell_values[{degree}] have the shape {found.shape}, and there are {count} cells of degree {degree}",
            f"give an array of shape ({count},): a value for each cell",
        )
    return found


@in_words
def polygon(*rings: Any) -> Model:
    """A polygon of the plane with holes, as WKT and shapely have it: input of :func:`boolean`, :func:`arrange` and :mod:`coface.maps`.

    Parameters
    ----------
    *rings
        Arrays ``(n, 2)`` of points: the outer ring, then holes. The first point may stand at the end again.

    Returns
    -------
    Model
        A closed line for each ring, which knows that it is a ring of the polygon: holes are subtracted.

    Raises
    ------
    InvalidInputError
        For a ring of fewer than three points, or with a coordinate that is not finite.

    Examples
    --------
    >>> import coface
    >>> ring = coface.polygon([[0, 0], [3, 0], [3, 3], [0, 3]], [[1, 1], [2, 1], [2, 2], [1, 2]])
    >>> coface.boolean("union", ring).measure
    8.0
    """
    if not rings:
        return Model.from_arrays(np.zeros((0, 2)))
    content = [struct.pack("<BII", 1, 3, len(rings))]
    for number, given in enumerate(rings):
        ring = numbers(given, f"the points of ring {number}")
        if ring.size and (ring.ndim != 2 or ring.shape[1] != 2):
            raise_invalid(f"ring {number} of the polygon has the shape {ring.shape}", "give an array of shape (n, 2): a row for each point")
        if not np.isfinite(ring).all():
            raise_invalid(f"ring {number} of the polygon has a coordinate that is not finite", "give finite coordinates")
        if len(ring) > 3 and (ring[0] == ring[-1]).all():
            ring = ring[:-1]
        if len(ring) < 3:
            raise_invalid(
                f"ring {number} of the polygon has {len(ring)} {'point' if len(ring) == 1 else 'points'}",
                "give three or more, or a line as coface.Model.from_arrays(points, cells={'polyline': [[0, 1]]})",
            )
        closed = np.concatenate([ring, ring[:1]])
        content.append(struct.pack("<I", len(closed)) + closed.astype("<f8").tobytes())
    return Model.from_bytes(b"".join(content), "wkb")
