"""What notebooks show of models and answers: tables, formulas and small pictures, at most 60 kB each."""

from __future__ import annotations

import base64
import html
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from coface._coface import (
    ChainComplex,
    Error,
    FundamentalGroup,
    Homology,
    HomologyGroup,
    Persistence,
    Report,
    YinSet,
)
from coface._records import facts_of
from coface._shown import is_model, shown

#: So many bytes a cell shows at most.
BUDGET = 60_000
#: Models with more faces are not drawn by themselves.
LARGEST = 20_000
#: Pictures may have so many bytes before they are written as text.
_PICTURE = 40_000
_STYLE = "style=\"text-align:left;font-family:monospace\""


def repr_html(self: Any) -> str:
    """What a notebook shows: a picture where it is small, and the facts as a table; groups as formulas.

    Examples
    --------
    >>> import coface
    >>> text = coface.generate("csaszar")._repr_html_()
    >>> "<img" in text, len(text) <= 60_000
    (True, True)
    >>> "H<sub>1</sub> = \u2124<sup>2</sup>" in coface.homology(coface.generate("csaszar"))._repr_html_()
    True
    """
    parts = [f"<b>{html.escape(repr(self))}</b>", _picture(self), _facts(self)]
    found = ""
    for part in parts:
        if len(found) + len(part) <= BUDGET:
            found += part
    return f"<div>{found}</div>"


def _facts(x: Any) -> str:
    if isinstance(x, Homology):
        return "".join(f"<div>{_formula(group)}</div>" for group in x) or "<div>0</div>"
    if isinstance(x, HomologyGroup):
        return f"<div>{_formula(x)}</div>"
    if isinstance(x, FundamentalGroup):
        return f"<div>{_presentation(x)}</div>"
    if is_model(x):
        return table(_of_model(x))
    if not hasattr(x, "to_dict"):
        return ""
    return table(facts_of(x))


def _of_model(x: Any) -> dict[str, Any]:
    facts: dict[str, Any] = {}
    for name in ("f_vector", "dimension", "vertex_count", "structure", "format", "euler_characteristic", "genus", "is_orientable"):
        if len(x) > LARGEST and name in ("f_vector", "dimension", "euler_characteristic"):
            continue
        try:
            facts[name] = getattr(x, name, None)
        except Error:
            # What breaks a rule of complexes is said by its report.
            continue
    return facts


def table(facts: Mapping[str, Any]) -> str:
    """Facts as a table; those that are too long for a line are counted or left out."""
    rows = []
    for key, value in facts.items():
        text = _short(value)
        if key != "recipe" and text is not None:
            rows.append(f"<tr><th {_STYLE}>{html.escape(key)}</th><td {_STYLE}>{html.escape(text)}</td></tr>")
    return f"<table>{''.join(rows)}</table>" if rows else ""


def _short(value: Any) -> str | None:
    """A value in a line; ``None`` for nothing and for what is too long."""
    if value is None or isinstance(value, (list, tuple)) and not value:
        return None
    if isinstance(value, (list, tuple)):
        items = [_short(one) for one in value[:12]]
        if len(value) > 12 or any(one is None for one in items):
            return f"{len(value)} of them"
        text = ", ".join(one for one in items if one is not None)
        return f"[{text}]" if len(text) <= 200 else f"{len(value)} of them"
    if isinstance(value, Mapping):
        text = ", ".join(f"{key} {_short(one)}" for key, one in value.items() if _short(one) is not None)
        return text if 0 < len(text) <= 200 else None
    text = str(value)
    return text if len(text) <= 200 else text[:197] + "..."


def _formula(group: HomologyGroup) -> str:
    mark = "sup" if group.is_cohomology else "sub"
    return f"H<{mark}>{group.degree}</{mark}> = {_group(str(group))}"


def _group(text: str) -> str:
    """A group in letters of formulas.

    Examples
    --------
    >>> _group("Z^2 + (Z/3)^2")
    '\u2124<sup>2</sup> \u2295 (\u2124/3)<sup>2</sup>'
    """
    text = html.escape(text).replace(" + ", " \u2295 ").replace("Z", "\u2124").replace("Q", "\u211a")
    return re.sub(r"\^(\d+)", r"<sup>\1</sup>", text)


def _presentation(group: FundamentalGroup) -> str:
    """A group by generators and relators."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    count = group.generators

    def letter(number: int) -> str:
        name = letters[abs(number) - 1] if count <= len(letters) else f"x<sub>{abs(number)}</sub>"
        return name if number > 0 else f"{name}<sup>-1</sup>"

    words = [" ".join(letter(number) for number in word) for word in group.relators[:20]]
    more = ", ..." if len(group.relators) > 20 else ""
    given = ", ".join(letter(number) for number in range(1, min(count, 60) + 1)) + (", ..." if count > 60 else "")
    name = "" if group.name is None else f"{html.escape(group.name)} = "
    return f"{name}\u27e8 {given} | {', '.join(words)}{more} \u27e9"


def _picture(x: Any) -> str:
    from coface._view import render

    if isinstance(x, (Homology, HomologyGroup)) and not any(group.generators for group in (x if isinstance(x, Homology) else [x])):
        return ""
    if isinstance(x, (Report, ChainComplex)):
        return ""
    try:
        if isinstance(x, (Persistence, YinSet)):
            text = x.to_svg().encode()
            if len(text) <= _PICTURE:
                return _image(text, "svg+xml")
        together = shown(x)
        if together.model is None:
            return ""
        model = together.scene()
        if len(model) > LARGEST or model.vertex_count > 3 * LARGEST:
            return f"<p>{len(model):,} faces: too many for a cell. <code>coface.view(x, &quot;x.html&quot;)</code> writes a page of its own.</p>"
        note = "<p><code>coface.view(x, &quot;x.html&quot;)</code> writes a page to turn it.</p>"
        for size in ((480, 360), (320, 240), (200, 150)):
            picture = render(x, "png", size=size)
            if len(picture) <= _PICTURE:
                return _image(picture, "png") + note
        return note
    except (Error, np.linalg.LinAlgError):
        # What cannot be drawn has its table.
        return ""


def _image(data: bytes, kind: str) -> str:
    return f'<img alt="" src="data:image/{kind};base64,{base64.b64encode(data).decode()}"><br>'
