"""Pages and pictures: the page of ``coface view`` in a file, and stills."""

from __future__ import annotations

import html
import json
import os
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from coface import _coface
from coface._answers import html_of, is_facts
from coface._arrays import raise_invalid
from coface._coface import AssumptionWarning, ChainComplex, Interface, Persistence, YinSet
from coface._faults import in_words
from coface._scenes import colored
from coface._shown import _flat, is_answer, shown


@in_words
def page(
    x: Any, results: Any = None, *, title: str | None = None, report: bool = True, colors: Any = None, progress: Any = False
) -> str:
    """The page that ``coface view`` writes: one text, without a network.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands; an answer, which is shown over its model: homology with generators, one of its groups or
        generators, fundamental groups, a cover, cocycles, a cut, persistence, an arrangement, a Boolean, a :class:`YinSet`; or a list of a
        model and answers about it, harmonic forms among them. Several models are shown where they stand, each as a layer with a name and a color: a
        list of models and answers about them, or a dictionary of names to models, or to lists of a model and answers about it.
    results
        More answers to show over the model, or dictionaries in the words of the program's ``--json``, or lists of those.
    title
        What the model is called.
    report
        Whether the report is shown beside it, which takes most of the time on large models.
    colors
        The colors of several models: one for each, or a dictionary by their names. A color is ``"#ff8000"``, a name such as ``"orange"``, or three
        numbers from 0 to 1; ``None`` is the next one of the palette.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    str
        HTML. Of an answer without cells to draw, such as homology without generators, a page with its table; of persistence of points or an image one with its
        diagram.

    Examples
    --------
    >>> import coface
    >>> coface.page(coface.generate("csaszar"), title="seven vertices").count("seven vertices") > 0
    True
    >>> torus = coface.generate("torus")
    >>> text = coface.page([torus, coface.homology(torus, generators=True), coface.pi1(torus)], report=False)
    >>> "H1 generator 1" in text, "loop 1" in text
    (True, True)
    >>> sphere = coface.generate("sphere")
    >>> text = coface.page({"ring": torus, "ball": sphere}, colors={"ring": "orange"}, report=False)
    >>> '"name":"ring"' in text, '"name":"ball"' in text
    (True, True)
    """
    if isinstance(x, dict) and ("extended+" in x or "closed-open" in x) and not results:
        return _extended_page(x, title or ("extended persistence" if "extended+" in x else "zigzag persistence"))
    together = shown(x, results)
    members = colored(together.members, colors)
    if together.model is None and is_answer(x) and (not together.facts or isinstance(x, Persistence) and not results):
        body = html_of(x) if is_facts(x) else getattr(x, "_repr_html_", lambda: f"<pre>{html.escape(repr(x))}</pre>")()
        name = html.escape(title or type(x).__name__)
        return f"<!doctype html><html><head><meta charset=\"utf-8\"><title>{name}</title></head><body><h1>{name}</h1>{body}</body></html>"
    texts = [json.dumps(fact) for fact in together.facts]
    _warn_of_tables(x, results)
    return _coface._page(together.scene(), title or "model", texts, report, members, progress)


def _warn_of_tables(*given: Any) -> None:
    """Says which answers have no cells, so that nothing of them is drawn over the model."""
    if any(is_facts(one) for x in given if x is not None for one in _flat(x)):
        message = "an answer in the list has no cells to draw: its table is in coface.view(answer, path)"
        warnings.warn(message, AssumptionWarning, stacklevel=4)


def _extended_page(found: dict[str, Any], title: str) -> str:
    """A page with the table of extended persistence, or of a zigzag."""
    rows = "".join(
        f"<tr><td>{kind}</td><td>{degree}</td><td>{birth:g}</td><td>{death:g}</td></tr>"
        for kind, pairs in found.items()
        for degree, (birth, death) in pairs
    )
    name = html.escape(title)
    head = "<tr><th>kind</th><th>degree</th><th>birth</th><th>death</th></tr>"
    return f'<!doctype html><html><head><meta charset="utf-8"><title>{name}</title></head><body><h1>{name}</h1><table>{head}{rows}</table></body></html>'


@in_words
def view(
    x: Any,
    path: str | os.PathLike[str],
    results: Any = None,
    *,
    title: str | None = None,
    report: bool = True,
    colors: Any = None,
    progress: Any = False,
) -> Path:
    """Write a page that shows a model and answers: opens from disk in any browser, to turn, cut and take apart.

    Parameters
    ----------
    x
        A model, an answer, a list of a model and answers, or several models, as in :func:`page`.
    path
        The file to write.
    results, title, report, colors, progress
        As in :func:`page`.

    Returns
    -------
    pathlib.Path
        The file.

    Examples
    --------
    >>> import coface, tempfile
    >>> path = coface.view(coface.generate("csaszar"), tempfile.mkdtemp() + "/torus.html")
    >>> path.name, path.stat().st_size > 100_000
    ('torus.html', True)
    """
    target = Path(path)
    text = page(x, results, title=title or target.stem, report=report, colors=colors, progress=progress)
    _coface._replace_file(target, text.encode())
    return target


@in_words
def render(
    x: Any,
    format: str = "svg",
    *,
    results: Any = (),
    size: tuple[int, int] = (1200, 900),
    camera: Sequence[float] | None = None,
    up: Sequence[float] | None = None,
    perspective: float | None = None,
    edges: bool | None = None,
    dark: bool = False,
    transparent: bool = False,
    line_width: float | None = None,
    edge_width: float | None = None,
    label: Sequence[str] | str = (),
    star: Any = None,
    closure: Any = None,
    link: Any = None,
    legend: bool = False,
    spin: int | None = None,
    witness: bool = False,
    title: str = "model",
    colors: Any = None,
    progress: Any = False,
) -> bytes:
    """A still picture of a model, of an answer over its model, or of several together; hidden lines are removed.

    Parameters
    ----------
    x
        A model, an answer, a list of a model and answers, or several models, as in :func:`page`. Persistence alone is a diagram, an interface its phases, a
        chain complex without a model its matrices.
    format
        ``"svg"``, ``"png"`` or ``"pdf"``; PDF has vectors, a pixel is 0.75 points. With ``spin`` ``"gif"``, ``"png"`` or ``"webp"``.
    results
        More answers to be shown over it, or dictionaries as ``to_dict()`` gives them.
    size
        Width and height in pixels.
    camera, up
        The direction from which it is seen, and what is up.
    perspective
        The angle of view in degrees; parallel if left out.
    edges
        Whether edges are drawn; if left out, where they can be distinguished.
    dark
        Whether the background is dark.
    transparent
        Whether what lies behind the picture shows through, in place of a background.
    line_width, edge_width
        The widths of the lines of answers and of edges, in points; 2.25 and 0.45 if left out.
    label
        ``"vertices"``, ``"edges"`` or ``"faces"``, or several of them: the numbers of these cells are written beside them.
    star, closure, link
        A simplex, ``[0, 1]``, or several, ``[[0, 1], [3]]``: what they have around them is drawn over the pale complex, each in a color of
        its own. A star is open: vertices that bound it are rings.
    legend
        Whether the names of what is drawn over the model stand above it, with their colors; with ``star``, ``closure`` and ``link`` they
        do anyway.
    spin
        So many frames, in which the model turns once about what is up: an animated GIF, PNG or WebP, 24 frames a second.
    witness
        Whether what is wrong is marked.
    title
        What it is called.
    colors
        The colors of several models, as in :func:`page`.
    progress
        As for :func:`homology`.

    Returns
    -------
    bytes
        The content of the file.

    Examples
    --------
    >>> import coface
    >>> coface.render(coface.cocycles(coface.generate("torus"))).startswith(b"<svg")
    True
    >>> b"link of {0}" in coface.render(coface.generate("csaszar"), star=[0], link=[0])
    True
    """
    if not results and isinstance(x, Persistence):
        return x._picture(title if title != "model" else "persistence diagram", format, size, transparent)
    if not results and isinstance(x, YinSet):
        return x._picture(format, size, transparent)
    if not results and isinstance(x, Interface):
        return x._picture(title if title != "model" else "interface", format, size, transparent)
    if not results and isinstance(x, ChainComplex) and x.source is None:
        return _coface._matrix_picture(x, format, size, transparent)
    together = shown(x, results)
    if together.model is not None:
        _warn_of_tables(x, results)
    if together.model is None and not together.facts and is_answer(x):
        raise_invalid(
            f"this {type(x).__name__} has no cells that could be drawn",
            "ask with generators=True, or write its table: coface.view(answer, path)",
        )
    return _coface.render(
        together.scene(),
        format,
        results=together.facts,
        size=size,
        camera=camera,
        up=up,
        perspective=perspective,
        edges=edges,
        dark=dark,
        transparent=transparent,
        line_width=line_width,
        edge_width=edge_width,
        label=[label] if isinstance(label, str) else list(label),
        star=star,
        closure=closure,
        link=link,
        legend=legend,
        spin=spin,
        witness=witness,
        title=title,
        members=colored(together.members, colors),
        progress=progress,
    )
