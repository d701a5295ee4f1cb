"""Answers that are dictionaries or lists of facts: they can be shown, written and read back as the others can."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

import numpy as np

Found = TypeVar("Found", bound="_Shown")


class _Shown:
    """What dictionaries and lists of facts have in common."""

    def _repr_html_(self) -> str:
        return html_of(self)

    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        return plotted(self, options)

    def to_dict(self) -> dict[str, Any]:
        """The facts as JSON, arrays and answers among them by what makes them; ``from_dict`` reads it."""
        return written_facts(self)

    @classmethod
    def from_dict(cls: type[Found], facts: Mapping[str, Any]) -> Found:
        """The answer that ``to_dict()`` wrote."""
        return read_facts(cls, facts)

    def __ne__(self, other: object) -> bool:
        return not self == other


class FactsAnswer(_Shown, dict[str, Any]):
    """An answer as a dictionary of facts.

    Examples
    --------
    >>> import coface
    >>> form = coface.intersection_form(coface.generate("torus"))
    >>> type(form).from_dict(form.to_dict()) == form, "rank" in form._repr_html_()
    (True, True)
    """

    def __eq__(self, other: object) -> bool:
        return isinstance(other, dict) and same(dict(self), dict(other))


class ListAnswer(_Shown, list[Any]):
    """An answer as a list of facts: a dictionary for each part, or a pair.

    Examples
    --------
    >>> import coface
    >>> parts = coface.classify(coface.generate("torus"))
    >>> type(parts).from_dict(parts.to_dict()) == parts, "torus" in parts._repr_html_()
    (True, True)
    """

    def __eq__(self, other: object) -> bool:
        return isinstance(other, list) and same(list(self), list(other))


def is_facts(x: Any) -> bool:
    """Whether this is such an answer."""
    return isinstance(x, (FactsAnswer, ListAnswer))


def written_facts(x: Any) -> dict[str, Any]:
    """The dictionary of such an answer."""
    from coface._records import written

    # A class of this package is written by what makes it, a dictionary by its items.
    plain = dict(x) if isinstance(x, dict) else list(x)
    return {"answer": type(x).__name__, "facts": written(plain)}


def read_facts(cls: type[Found], facts: Mapping[str, Any]) -> Found:
    """The answer of its dictionary."""
    from coface._arrays import raise_invalid
    from coface._records import read_back

    if not isinstance(facts, Mapping) or facts.get("answer") != cls.__name__:
        raise_invalid(f"this is no dictionary of a {cls.__name__}", "give what to_dict() gave")
    make: Any = cls
    found: Found = make(read_back(facts["facts"]))
    return found


def same(a: Any, b: Any) -> bool:
    """Whether two facts are equal; arrays are if all their numbers are."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.shape(a) == np.shape(b) and bool(np.all(np.asarray(a) == np.asarray(b)))
    if hasattr(a, "tocoo") and hasattr(b, "tocoo"):
        return bool(a.shape == b.shape and (a != b).nnz == 0)
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(value, b[key]) for key, value in a.items())
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(map(same, a, b))
    return bool(a == b)


def rows_of(x: Any) -> Iterable[tuple[str, Any]]:
    """The facts of an answer by their names; those of the members of a list by their numbers too."""
    if isinstance(x, dict):
        yield from ((str(key), value) for key, value in x.items())
        return
    for number, one in enumerate(x):
        if isinstance(one, dict):
            yield from ((f"{number}: {key}", value) for key, value in one.items())
        else:
            yield str(number), one


def html_of(x: Any) -> str:
    """What a notebook shows: the facts as a table."""
    from coface._notebook import BUDGET, table

    facts: dict[str, Any] = {}
    for number, (name, value) in enumerate(rows_of(x)):
        if number == 200:
            break
        facts[name] = value.tolist() if isinstance(value, np.ndarray) and value.size <= 200 else value
    text = f"<div>{table(facts)}</div>"
    return text if len(text) <= BUDGET else f"<div>{len(x)} facts</div>"


def plotted(x: Any, options: dict[str, Any]) -> Any:
    """The answer as :func:`coface.plot` draws it."""
    from coface._plot import plot

    return plot(x, **options)
