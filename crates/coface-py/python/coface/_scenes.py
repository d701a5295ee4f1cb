"""Several models in one scene, with names and colors, and answers about each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from coface._arrays import Points, ragged, raise_invalid
from coface._coface import ChainComplex, Model
from coface._models import as_drawn
from coface._shown import Facts, Shown, _flat, _on_edges, _one, is_answer, is_space
from coface.interop import adapter_of

#: What a model of a scene is called, and the model or the answer.
Named = tuple[str, Any]

#: The colors of pictures, which can be told apart with any sort of color vision.
PALETTE = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")

#: Colors by name: those of the palette of pictures, and some that everybody knows.
NAMES = {
    "blue": "#0072b2",
    "orange": "#e69f00",
    "green": "#009e73",
    "pink": "#cc79a7",
    "vermilion": "#d55e00",
    "sky": "#56b4e9",
    "red": "#d0021b",
    "yellow": "#f0e442",
    "purple": "#7a2cf5",
    "brown": "#8d6248",
    "black": "#000000",
    "gray": "#808080",
    "grey": "#808080",
    "white": "#ffffff",
}


def several(x: Any) -> list[Named] | None:
    """The models and answers of a scene, with names; ``None`` where there is one model at most.

    Examples
    --------
    >>> import coface
    >>> torus, klein = coface.generate("torus"), coface.generate("klein")
    >>> [name for name, _ in several([torus, klein])]
    ['model 1', 'model 2']
    >>> several([torus, coface.homology(torus)]) is None
    True
    """
    if isinstance(x, Mapping):
        if not x or not all(isinstance(name, str) and _is_shown(value) for name, value in x.items()):
            return None
        named: list[Named] = []
        for name, value in x.items():
            named.extend((name, one) for one in _listed(value))
        return named
    flat = _listed(x)
    if not isinstance(x, (list, tuple)) or not any(is_answer(one) or _is_foreign(one) for one in flat):
        return None
    flat = _without_chains(flat)
    if sum(map(is_space, flat)) < 2:
        return None
    count, found = 0, []
    for one in flat:
        count += is_space(one)
        found.append((f"model {max(count, 1)}", one))
    return found


def _without_chains(flat: list[Any]) -> list[Any]:
    """Without chain complexes of models that are shown too; one that has no positions is refused beside others."""
    models = [one for one in flat if isinstance(one, Model)]
    found = []
    for one in flat:
        if not isinstance(one, ChainComplex):
            found.append(one)
            continue
        if one.source is None and sum(map(is_space, flat)) < 2:
            found.append(one)
            continue
        if one.source is None:
            raise_invalid("a chain complex without a model has nothing to be shown beside others", "show its matrices alone: coface.render(complex)")
        if one.source not in models:
            found.append(one.source)
            models.append(one.source)
    return found


def _listed(x: Any) -> list[Any]:
    """The members of a list, and of lists of answers in it."""
    return [one for part in x for one in _flat(part)] if isinstance(x, (list, tuple)) else [x]


def _is_shown(x: Any) -> bool:
    """Whether this can stand under a name: a model, an answer, or a list of them."""
    if isinstance(x, (list, tuple)):
        return len(x) > 0 and any(is_answer(one) or _is_foreign(one) for one in x)
    return is_answer(x) or _is_foreign(x)


def _is_foreign(x: Any) -> bool:
    return adapter_of(x) is not None


def together(named: list[Named], results: list[Any]) -> Shown:
    """One model of all, with the facts of answers about each."""
    names: list[str] = []
    models: list[Model] = []
    answers: list[tuple[int, Shown, Any]] = []
    for name, one in named:
        if is_space(one):
            if name in names:
                raise_invalid(f"there are two models called {name!r}", "give each model a name of its own")
            names.append(name)
            models.append(as_drawn(one))
            continue
        part = _one(one)
        if name not in names and part.model is not None and not name.startswith("model "):
            # An answer under a name of its own is shown over its model.
            names.append(name)
            models.append(part.model)
        answers.append((len(models) - 1, part, one))
    for one in results:
        part = Shown(None, [one]) if isinstance(one, dict) and "recipe" not in one else _one(one)
        answers.append((-1, part, one))
    facts = [(_place_of(part, one, models, last), fact) for last, part, one in answers for fact in part.facts]
    drawn = [_drawn(model) for model in models]
    whole, starts = _joined(drawn)
    found = Shown(whole, [_moved(_on_edges(fact, models[place]), starts[place]) for place, fact in facts])
    found.members = [(name, starts[i], starts[i + 1]) for i, name in enumerate(names)]
    return found


def _place(model: Model, models: list[Model]) -> int | None:
    """Which of the models this is."""
    found = [i for i, known in enumerate(models) if known is model] or [i for i, known in enumerate(models) if known == model]
    return found[0] if found else None


def _place_of(part: Shown, answer: Any, models: list[Model], last: int) -> int:
    """The model that an answer is about: its own if that is shown, else the one that stands before it."""
    known = _place(part.model, models) if part.model is not None else None
    if known is not None:
        return known
    if last < 0 or part.model is not None:
        raise_invalid(
            f"a {type(answer).__name__} is about none of the models",
            "let it follow its model: coface.view([first, answer, second], path)",
        )
    return last


def _drawn(model: Model) -> Model:
    """A model with positions, whose vertices have the same numbers."""
    shown = Shown(model).scene()
    if shown.vertices is not None:
        return shown
    if shown.structure != "facets":
        shown = shown.triangulated()
        if shown.vertices is not None:
            return shown
    from coface._plot import _spectral

    found = _spectral(shown)
    if found is None:
        raise_invalid(
            f"a model of {shown.vertex_count} vertices has no positions, too many to place beside others",
            "give it positions: coface.Model(vertices, faces)",
        )
    places = np.asarray(found, np.float64)
    top = 1 + (-1 if shown.dimension is None else shown.dimension)
    triangles = np.asarray(shown.simplices(2)) if top > 2 else np.zeros((0, 3), np.int64)
    edges = np.asarray(shown.simplices(1)) if top > 1 else np.zeros((0, 2), np.int64)
    return Model.from_arrays(places, triangles, {"line": edges} if len(edges) and not len(triangles) else None)


def _joined(models: Sequence[Model]) -> tuple[Model, list[int]]:
    """Models side by side as one, and where the vertices of each begin and the last ones end."""
    width = 3 if any(_points(model).shape[1] > 2 for model in models) else 2
    starts, points = [0], []
    faces: list[Any] = []
    cells: dict[str, list[Any]] = {}
    for model in models:
        own = _points(model)
        if own.shape[1] > 3:
            raise_invalid(
                f"a scene shows the plane and space, and a model has {own.shape[1]} coordinates",
                "project it: coface.Model(model.vertices @ projection, model.faces)",
            )
        points.append(np.pad(own, [(0, 0), (0, width - own.shape[1])]))
        start = starts[-1]
        faces.extend(_rows(model.faces, start))
        for kind, rows in (("polyline", _rows(model.lines, start)), ("vertex", [[point + start] for point in model.points.tolist()])):
            if rows:
                cells.setdefault(kind, []).extend(rows)
        for kind, block in model.cells.items():
            cells.setdefault(kind, []).extend((np.asarray(block, np.int64) + start).tolist())
        starts.append(start + len(own))
    return Model.from_arrays(np.concatenate(points), faces if faces else None, cells), starts


def _points(model: Model) -> Points:
    return np.asarray(model.vertices, np.float64)


def _rows(lists: Any, start: int) -> list[list[int]]:
    flat, offsets = ragged(lists)
    flat = flat + start
    return [flat[begin:end].tolist() for begin, end in zip(offsets[:-1], offsets[1:])]


def _moved(fact: Facts, start: int) -> Facts:
    """Facts about one model, with the numbers that its vertices have in the scene."""
    if start == 0:
        return fact

    def walk(vertices: Any) -> list[int]:
        return [vertex + start for vertex in vertices]

    def chain(terms: Any) -> list[Any]:
        return [[value, walk(cell)] for value, cell in terms]

    found: Facts = {}
    for key, value in fact.items():
        if key == "generators":
            found[key] = [[{**one, "chain": chain(one["chain"])} for one in group] for group in value]
        elif key in ("loops", "simplices", "edges"):
            found[key] = [walk(row) for row in value]
        elif key == "cocycles":
            found[key] = [chain(terms) for terms in value]
        elif key == "components":
            kept = ({**part, "seams": [{**seam, "vertices": walk(seam["vertices"])} for seam in part["seams"]]} for part in value if "seams" in part)
            found[key] = [{name: part[name] for name in part if name in ("seams", "cut_edges")} for part in kept]
        elif key in ("cohomology", "harmonic", "diagram"):
            found[key] = value
        else:
            raise_invalid(f"{key!r} of an answer is shown over one model alone", "leave out the other models")
    return found


def rgb(color: Any) -> tuple[int, int, int]:
    """A color as red, green and blue from 0 to 255.

    Parameters
    ----------
    color
        ``"#ff8000"``, ``"#f80"``, a name such as ``"orange"``, or three numbers from 0 to 1.

    Examples
    --------
    >>> rgb("#ff8000"), rgb("blue"), rgb((1.0, 0.5, 0.0))
    ((255, 128, 0), (0, 114, 178), (255, 128, 0))
    """
    if isinstance(color, str):
        text = NAMES.get(color.lower(), color).lstrip("#")
        text = "".join(2 * digit for digit in text) if len(text) == 3 else text
        if len(text) == 6 and all(digit in "0123456789abcdefABCDEF" for digit in text):
            return int(text[:2], 16), int(text[2:4], 16), int(text[4:], 16)
    elif isinstance(color, (list, tuple, np.ndarray)) and len(color) == 3:
        parts = [float(part) for part in color]
        if all(0 <= part <= 1 for part in parts):
            red, green, blue = (int(255 * part + 0.5) for part in parts)
            return red, green, blue
    raise_invalid(f"{color!r} is no color", f'give "#ff8000", three numbers from 0 to 1, or one of {", ".join(NAMES)}')


def colored(members: Sequence[tuple[str, int, int]], colors: Any) -> list[tuple[str, int, int, tuple[int, int, int] | None]]:
    """Members with their colors; those that are not named have the next color of the palette."""
    if colors is None:
        return [(*member, None) for member in members]
    if not members:
        raise_invalid("colors are for several models, and there is one", "leave colors out, or give a list of models")
    names = [name for name, _, _ in members]
    if isinstance(colors, Mapping):
        unknown = [name for name in colors if name not in names]
        if unknown:
            raise_invalid(f"colors has {unknown[0]!r}, and no model is called so", f"the models are called {', '.join(names)}")
        return _filled(members, [colors.get(name) for name in names])
    if isinstance(colors, str) or len(colors) != len(members):
        raise_invalid(f"colors is {colors!r}, and there are {len(members)} models", "give a color for each, or a dictionary by their names")
    return _filled(members, list(colors))


def _filled(members: Sequence[tuple[str, int, int]], colors: list[Any]) -> list[tuple[str, int, int, tuple[int, int, int] | None]]:
    """Members with these colors; where there is none, with the next one of the palette that no other has."""
    given = [None if color is None else rgb(color) for color in colors]
    free = [color for color in map(rgb, PALETTE) if color not in given] or list(map(rgb, PALETTE))
    found: list[tuple[str, int, int, tuple[int, int, int] | None]] = []
    place = 0
    for member, color in zip(members, given, strict=True):
        found.append((*member, free[place % len(free)] if color is None else color))
        place += color is None
    return found
