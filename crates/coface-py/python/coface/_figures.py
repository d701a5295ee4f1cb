"""Figures: polygons with their letters, long exact sequences, boundary matrices in blocks."""

from __future__ import annotations

from typing import Any

from coface import _coface
from coface._faults import in_words
from coface._models import as_cells, as_model


@in_words
def schema_picture(
    x: Any,
    format: str = "svg",
    *,
    size: tuple[int, int] = (1000, 1100),
    transparent: bool = False,
    title: str | None = None,
) -> bytes:
    """The polygon of a word, or the canonical polygon of each component of a surface, as a picture.

    Sides that are glued have one color and arrows that agree with their letters; corners that are glued to one point have one name.

    Parameters
    ----------
    x
        A word such as ``"a b a^-1 b^-1"``, ``"abAB"`` or ``"a1 a1 a2 a2"``, or anything that :func:`as_model` understands, whose faces are a
        surface.
    format
        ``"svg"``, ``"png"`` or ``"pdf"``.
    size
        Width and height of a PNG in pixels.
    transparent
        Whether what lies behind the picture shows through.
    title
        What it is called.

    Returns
    -------
    bytes
        The content of the file.

    Examples
    --------
    >>> import coface
    >>> b">torus<" in coface.schema_picture("a b a^-1 b^-1")
    True
    >>> b">Klein bottle<" in coface.schema_picture(coface.generate("klein"))
    True
    """
    is_word = isinstance(x, str) and "." not in x
    name = title or (x if is_word else "polygon")
    return _coface._schema_picture(x if is_word else as_model(x), format, size, transparent, name)


@in_words
def sequence_picture(
    x: Any,
    part: Any = "boundary",
    format: str = "svg",
    *,
    size: tuple[int, int] = (1800, 1500),
    transparent: bool = False,
    title: str = "long exact sequence",
) -> bytes:
    """The long exact sequence of a pair as a diagram: groups, and maps with their matrices or ranks.

    Parameters
    ----------
    x, part
        As for :func:`long_exact_sequence`.
    format
        ``"svg"``, ``"png"`` or ``"pdf"``.
    size
        Width and height of a PNG in pixels.
    transparent
        Whether what lies behind the picture shows through.
    title
        What it is called.

    Returns
    -------
    bytes
        The content of the file.

    Examples
    --------
    >>> import coface
    >>> b"exact at every group" in coface.sequence_picture(coface.generate("moebius"))
    True
    """
    from coface._questions import part_of

    model = as_cells(x)
    return _coface._sequence_picture(model, part_of(model, part), format, size, transparent, title)


@in_words
def matrix_picture(
    x: Any,
    degree: int,
    blocks: str = "components",
    format: str = "svg",
    *,
    size: tuple[int, int] = (1200, 1200),
    transparent: bool = False,
    title: str = "boundary matrix",
) -> bytes:
    """A boundary matrix with its rows and columns in blocks: blue entries are positive, orange ones negative.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    degree
        The degree of the cells of columns.
    blocks
        ``"components"`` of the complex, ``"groups"`` of the mesh, or ``"matching"``: what an acyclic matching makes of cells, which are matched
        or critical.
    format
        ``"svg"``, ``"png"`` or ``"pdf"``.
    size
        Width and height of a PNG in pixels.
    transparent
        Whether what lies behind the picture shows through.
    title
        What it is called.

    Returns
    -------
    bytes
        The content of the file.

    Examples
    --------
    >>> import coface
    >>> b"critical" in coface.matrix_picture(coface.generate("csaszar"), 1, "matching")
    True
    """
    return _coface._blocked_matrix_picture(as_cells(x), degree, blocks, format, size, transparent, title)
