"""Questions as functions: each makes a model of what it gets and asks that."""

from __future__ import annotations

from typing import Any

from coface._coface import Homology
from coface._models import as_chain_complex, as_model


def homology(
    x: Any,
    coefficients: str = "z",
    *,
    relative: Any = None,
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
        ``"z"``, ``"q"``, ``"f2"``, ``"f3"``, ... for a prime field, ``"z/4"`` and the like.
    relative
        A part that is divided out: ``"boundary"``, or anything that :func:`as_model` understands, with the same numbers of vertices.
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
    return _chains(x, relative, reduced, progress).homology(coefficients, generators=generators, progress=progress)


def cohomology(
    x: Any,
    coefficients: str = "z",
    *,
    relative: Any = None,
    reduced: bool = False,
    generators: bool = False,
    progress: Any = False,
) -> Homology:
    """The cohomology groups; torsion stands one degree above that of homology.

    Parameters
    ----------
    x, coefficients, relative, reduced, generators, progress
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
    return _chains(x, relative, reduced, progress).cohomology(coefficients, generators=generators, progress=progress)


def _chains(x: Any, relative: Any, reduced: bool, progress: Any) -> Any:
    if relative is None and not reduced:
        return as_chain_complex(x, progress=progress)
    part = relative if relative is None or isinstance(relative, str) and relative == "boundary" else as_model(relative)
    return as_model(x, progress=progress).chain_complex(part, reduced=reduced, progress=progress)
