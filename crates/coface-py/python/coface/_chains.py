"""Questions about one complex or two: each makes a complex of what it gets and asks that."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coface import _coface
from coface._answers import FactsAnswer, ListAnswer
from coface._arrays import plain, raise_invalid
from coface._coface import Chain, Generator, Model
from coface._models import as_cells, as_chain_complex, as_model
from coface._faults import in_words

if TYPE_CHECKING:
    from scipy.sparse import csc_array

    from coface._types import CupTable, CycleClass, Exactness, ExactSequence, GroupMap, IntersectionForm


@in_words
def laplacian(x: Any, degree: int, *, progress: Any = False) -> csc_array:
    """The combinatorial Laplacian of a degree: boundary times coboundary and coboundary times boundary.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    degree
        The degree.
    progress
        As for :func:`homology`.

    Returns
    -------
    scipy.sparse.csc_array
        Symmetric, with integer entries: a row and a column for each cell of the degree.

    Examples
    --------
    >>> import coface
    >>> coface.laplacian([[0, 1], [1, 2]], 0).toarray()
    array([[ 1, -1,  0],
           [-1,  2, -1],
           [ 0, -1,  1]], dtype=int32)
    """
    return _coface.laplacian(as_chain_complex(x), degree, progress=progress)


@in_words
def classes(x: Any, cycles: Iterable[Any], *, degree: int | None = None, progress: Any = False) -> list[CycleClass]:
    """The classes of cycles in integral homology, and whether they bound.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    cycles
        Cycles as :meth:`ChainComplex.chain` takes them.
    degree
        Their degree, where they do not say it.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of dict
        ``class``: coefficients in the generators; ``orders`` of these, 0 for infinite; ``bounds``; ``multiple``: the least that bounds;
        ``bounding``: a chain whose boundary is that multiple; ``cocycle`` and ``value``: what shows that no multiple bounds.

    Examples
    --------
    >>> import coface
    >>> found, = coface.classes([[0, 1], [1, 2], [0, 2]], [[(2, [0, 1]), (2, [1, 2]), (-2, [0, 2])]])
    >>> found["class"], found["bounds"]
    ([2], False)
    """
    return ListAnswer(_coface.classes(as_chain_complex(x), list(cycles), degree=degree, progress=progress))


@in_words
def matching(x: Any, degree: int, *, progress: Any = False) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """A discrete gradient field: cells matched with faces, and critical cells.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    degree
        The degree of the faces.
    progress
        As for :func:`homology`.

    Returns
    -------
    critical : numpy.ndarray
        The critical cells of the degree.
    pairs : numpy.ndarray of shape (n, 2)
        Faces of the degree and the cells of the next one that they are matched with.

    Examples
    --------
    One vertex of a path is critical; the others are matched with its edges.

    >>> import coface
    >>> critical, pairs = coface.matching([[0, 1], [1, 2]], 0)
    >>> critical.shape, pairs.shape
    ((1,), (2, 2))
    """
    return _coface.matching(as_chain_complex(x), degree, progress=progress)


@in_words
def decompose(
    x: Any, degree: int, values: ArrayLike, *, weights: Sequence[ArrayLike] | None = None, progress: Any = False
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The Hodge decomposition of a real cochain.

    Parameters
    ----------
    x
        Anything that :func:`as_chain_complex` understands.
    degree
        The degree.
    values
        A value for each cell of the degree.
    weights
        For each degree a positive weight for each cell; 1 if left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    exact, coexact, harmonic : numpy.ndarray
        Orthogonal parts that add up to the cochain.

    Examples
    --------
    A flow around a ring is harmonic:

    >>> import coface
    >>> exact, coexact, harmonic = coface.decompose([[0, 1], [1, 2], [0, 2]], 1, [1.0, -1.0, 1.0])
    >>> [float(abs(part).max().round(9)) for part in (exact, coexact, harmonic)]
    [0.0, 0.0, 1.0]
    """
    return _coface.decompose(as_chain_complex(x), degree, values, weights=weights, progress=progress)


@in_words
def cup_products(
    x: Any, p: int, q: int, coefficients: str | int = "z", *, progress: Any = False
) -> CupTable:
    """Cup products of a basis of cohomology in degree p with one in degree q, in a basis of degree p + q.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands: simplices, or a gluing table.
    p, q
        The degrees.
    coefficients
        ``"z"``, ``"f2"``, ...
    progress
        As for :func:`homology`.

    Returns
    -------
    dict
        ``table[i][j]``: the coefficients of the product of class i and class j; ``first``, ``second``, ``target``: cocycles as lists of
        (coefficient, vertices); ``first_orders``, ``second_orders``, ``target_orders``.

    Examples
    --------
    On the torus the product of the two classes of degree 1 is the fundamental class, up to sign:

    >>> import coface
    >>> table = coface.cup_products(coface.generate("csaszar"), 1, 1)["table"]
    >>> table[0][0], abs(table[0][1][0])
    ([0], 1)
    """
    return cast("CupTable", FactsAnswer(_coface.cup_products(as_cells(x), p, q, coefficients, progress=progress)))


@in_words
def intersection_form(x: Any, *, progress: Any = False) -> IntersectionForm:
    """The intersection form of a closed oriented manifold of even dimension.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands: the manifold, of simplices.
    progress
        As for :func:`homology`.

    Returns
    -------
    dict
        ``matrix``, ``rank``, ``determinant``, ``symmetric``, ``signature``, ``parity``, ``definiteness``, ``name``, ``basis``.

    Examples
    --------
    >>> import coface
    >>> form = coface.intersection_form(coface.generate("cp2"))
    >>> abs(form["signature"]), form["parity"]
    (1, 'odd')
    """
    return cast("IntersectionForm", FactsAnswer(_coface.intersection_form(as_cells(x), progress=progress)))


@in_words
def long_exact_sequence(x: Any, part: Any = "boundary", *, progress: Any = False) -> ExactSequence:
    """The long exact sequence of a pair, checked to be exact.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands: the whole.
    part
        ``"boundary"``, the name of a group of the model, or anything that :func:`as_model` understands.
    progress
        As for :func:`homology`.

    Returns
    -------
    dict
        ``part``, ``whole`` and ``pair``: homology; ``inclusion``, ``projection`` and ``connecting``: for each degree a map or ``None``,
        with ``matrix`` (columns are images of generators), ``image``, ``kernel`` and ``cokernel``.

    Examples
    --------
    >>> import coface
    >>> coface.long_exact_sequence([[0, 1, 2]], "boundary")["pair"].betti_numbers
    (0, 0, 1)
    """
    from coface._questions import part_of

    model = as_cells(x)
    return cast("ExactSequence", FactsAnswer(_coface.long_exact_sequence(model, part_of(model, part), progress=progress)))


@in_words
def induced_map(
    source: Any, target: Any, vertices: Mapping[int, int] | Iterable[tuple[int, int]], *, progress: Any = False
) -> list[GroupMap]:
    """The maps on integral homology that a simplicial map induces.

    Parameters
    ----------
    source, target
        Anything that :func:`as_model` understands: simplicial complexes.
    vertices
        The image of each vertex: a dictionary, or pairs.
    progress
        As for :func:`homology`.

    Returns
    -------
    list of dict
        For each degree ``matrix`` (columns are images of generators), ``source_orders``, ``target_orders``, ``kernel``, ``cokernel``.

    Examples
    --------
    A hexagon that runs twice around a triangle:

    >>> import coface
    >>> hexagon = [[i, (i + 1) % 6] for i in range(6)]
    >>> maps = coface.induced_map(hexagon, [[0, 1], [1, 2], [0, 2]], {i: i % 3 for i in range(6)})
    >>> abs(maps[1]["matrix"]), maps[1]["cokernel"]
    (array([[2]]), 'Z/2')
    """
    images: Any = dict(vertices) if isinstance(vertices, Mapping) else [tuple(pair) if isinstance(pair, (list, tuple)) else pair for pair in plain(vertices)]
    return ListAnswer(_coface.induced_map(as_cells(source), as_cells(target), images, progress=progress))


@in_words
def is_exact(x: Any, values: ArrayLike, *, tolerance: float | None = None, progress: Any = False) -> Exactness:
    """Whether a cochain of degree 1 is closed, and whether it is exact.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    values
        A value for each edge, in the order of the chain complex, or a cochain or chain of degree 1; integers are decided exactly.
    tolerance
        Which sums count as zero, for real values.
    progress
        As for :func:`homology`.

    Returns
    -------
    dict
        ``closed`` and ``exact``; ``potential`` of an exact one; ``walk`` and ``period`` of a closed one that is not; ``face`` and ``sum`` of
        one that is not closed.

    Examples
    --------
    >>> import coface
    >>> coface.is_exact([[0, 1], [1, 2], [0, 2]], [1, 2, 3])["exact"]
    False
    >>> coface.is_exact([[0, 1], [1, 2], [0, 2]], [1, 3, 2])["potential"]
    array([0, 1, 3])
    """
    if isinstance(values, (Chain, Generator)):
        values = values.as_vector().toarray().reshape(-1)
    return _coface.is_exact(as_cells(x), _on_edges(values), tolerance=tolerance, progress=progress)


def _on_edges(values: Any) -> Any:
    """Values along one axis; what is none is refused in words."""
    try:
        is_listed = np.asarray(values).dtype.kind != "O"
    except ValueError:
        is_listed = False
    if not is_listed:
        raise_invalid("values are no list of numbers", "give one for each edge, or a Chain: complex.chain(terms)")
    return values


@in_words
def product(first: Any, second: Any, *, chains: bool = False, progress: Any = False) -> Model:
    """The product of two models: of simplices a simplicial complex, its cells cut along staircases; else a chain complex.

    Parameters
    ----------
    first, second
        Anything that :func:`as_model` understands: the factors.
    chains
        Whether products of cells are kept as they are, for simplices too.
    progress
        As for :func:`homology`.

    Returns
    -------
    Model
        A facet list, or a chain complex.

    Examples
    --------
    >>> import coface
    >>> circle = [[0, 1], [1, 2], [0, 2]]
    >>> coface.product(circle, circle).report().name
    'torus'
    """
    return _coface.product(as_model(first), as_model(second), chains=chains, progress=progress)


@in_words
def extruded(x: Any, heights: Sequence[float], *, progress: Any = False) -> Model:
    """Points, segments or triangles swept along one more axis, as simplices.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    heights
        The heights of the layers between, negative where one is left empty.
    progress
        As for :func:`homology`.

    Returns
    -------
    Model
        Simplices of one dimension more.

    Examples
    --------
    >>> import coface
    >>> coface.extruded(coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), [1.0, 1.0]).f_vector[0]
    9
    """
    return _coface.extruded(as_model(x), [float(height) for height in plain(heights)], progress=progress)
