"""Views: the page of ``coface view`` in a notebook or a file."""

from __future__ import annotations

import html
import json
import os
from pathlib import Path
from typing import Any
from coface._faults import in_words

#: So many faces are shown in a notebook by themselves; each page also has the viewer, about half a megabyte.
LARGEST = 20_000


@in_words
def page(x: Any, results: Any = None, *, title: str | None = None, report: bool = True, progress: Any = False) -> str:
    """The page that ``coface view`` writes: one text, without a network.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    results
        Answers to show over the model: objects with ``to_dict()``, dictionaries in the words of the program's ``--json``, or lists of those.
    title
        What the model is called.
    report
        Whether the report is shown beside it, which takes most of the time on large models.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    str
        HTML.

    Examples
    --------
    >>> import coface
    >>> coface.page(coface.generate("csaszar"), title="seven vertices").count("seven vertices") > 0
    True
    """
    import coface
    from coface._coface import _page

    texts = [json.dumps(result.to_dict() if hasattr(result, "to_dict") else result) for result in _list(results)]
    return _page(coface.as_model(x), title or "model", texts, report, progress)


def _list(results: Any) -> list[Any]:
    if results is None:
        return []
    return list(results) if isinstance(results, (list, tuple)) else [results]


@in_words
def view(
    x: Any,
    path: str | os.PathLike[str],
    results: Any = None,
    *,
    title: str | None = None,
    report: bool = True,
    progress: Any = False,
) -> Path:
    """Write a page that shows a model: opens from disk in any browser, to turn, cut and take apart.

    Parameters
    ----------
    x
        Anything that :func:`as_model` understands.
    path
        The file to write.
    results, title, report, progress
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
    from coface._coface import _replace_file

    target = Path(path)
    text = page(x, results, title=title or target.stem, report=report, progress=progress)
    _replace_file(target, text.encode())
    return target


def repr_html(x: Any) -> str:
    """What a notebook shows of a model, a complex or a surface: the page if it is small, else its report in short.

    Examples
    --------
    >>> import coface
    >>> text = repr_html(coface.generate("csaszar"))
    >>> text.startswith("<iframe"), "srcdoc=" in text
    (True, True)
    """
    import coface

    model = coface.as_model(x)
    if len(model) <= LARGEST and model.vertices is not None:
        source = html.escape(page(model), quote=True)
        return (
            f'<iframe srcdoc="{source}" sandbox="allow-scripts" loading="lazy" '
            'style="width:100%;height:480px;border:1px solid #ccc" title="coface"></iframe>'
        )
    if model.vertices is None:
        return f"<pre>{html.escape(repr(x))}</pre>"
    note = f"{len(model):,} faces: too many for a cell. <code>coface.view(model, &quot;model.html&quot;)</code> writes a page of its own."
    return f"<pre>{html.escape(repr(x))}</pre><p>{note}</p>"
