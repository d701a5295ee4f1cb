"""What is shown of answers: over which model, and which of their cells, loops, forms and diagrams."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from coface._answers import is_facts
from coface._arrays import lists, ragged, raise_invalid
from coface._coface import (
    Chain,
    ChainComplex,
    Cocycles,
    Complex,
    CutCells,
    Domain,
    FundamentalGroup,
    Generator,
    Homology,
    HomologyGroup,
    Model,
    Persistence,
    PlanarArrangement,
    Simplices,
    Surface,
    Verdict,
    YinSet,
)
from coface._models import as_drawn, unwrapped
from coface._records import facts_of

#: Facts over a model in the words of the program's JSON, as :func:`coface.page` and :func:`coface.render` take them.
Facts = dict[str, Any]


class Shown:
    """A model, and facts to show over it; the model is ``None`` where nothing says which it is.

    Several models that are shown together are one model here, and members say where the vertices of each begin and end.
    """

    def __init__(self, model: Model | None = None, facts: Iterable[Facts] = ()) -> None:
        self.model = model
        self.facts = list(facts)
        self.members: list[tuple[str, int, int]] = []

    def scene(self) -> Model:
        """The model as something that can be drawn."""
        if self.model is None:
            raise_invalid(
                "there is no model to show this over",
                "give both in a list: coface.view([model, answer], path); homology needs generators=True to be drawn",
            )
        if self.model.structure != "volume":
            return self.model
        voxels, axes = self.model.voxels or (np.zeros(0, bool), [])
        # Cells of a volume are named by the corners of voxels, which the mesh of all voxels keeps.
        return self.model.to_model(surface=voxels.ndim == 3 and not self.facts and not axes)


def is_answer(x: Any) -> bool:
    """Whether this is an object of the package."""
    return type(x).__module__ == "coface" or is_facts(x)


def is_model(x: Any) -> bool:
    """Whether this is a space itself, and no answer about one."""
    return isinstance(x, (Model, Complex, Surface, ChainComplex))


def is_space(x: Any) -> bool:
    """Whether this is a space itself, of this package or of another library."""
    return is_model(x) or not is_answer(x) and not isinstance(x, (dict, np.ndarray))


def shown(x: Any, results: Any = None) -> Shown:
    """What is shown of a model, an answer, or a list of a model and answers, with more answers.

    Examples
    --------
    >>> import coface
    >>> found = coface.homology(coface.generate("csaszar"), generators=True)
    >>> together = shown(found)
    >>> together.model, len(together.facts[0]["generators"][1])
    (Model(7 vertices, 14 faces), 2)
    """
    from coface import _scenes

    x = unwrapped(x)
    several = _scenes.several(x)
    if several is not None:
        return _scenes.together(several, [] if results is None else _flat(results))
    listed = isinstance(x, (list, tuple)) and any(is_answer(one) for one in _flat(x))
    parts = [_one(one) for one in (_flat(x) if listed else [x])]
    extra = [] if results is None else [_result(one) for one in _flat(results)]
    given = [one for one in (_flat(x) if listed else [x]) if is_space(one)]
    models = [part.model for part in parts + extra if part.model is not None]
    own = as_drawn(given[0]) if given and not isinstance(given[0], ChainComplex) else None
    model = own if own is not None else next(iter(models), None)
    # Answers about the cells of an arrangement or a region are shown over these: what is drawn of it has other vertices.
    of_cells = next((part.model for part in parts + extra if part.facts and part.model is not None and part.model.structure == "chains"), None)
    if own is None and of_cells is not None and of_cells != model:
        parts = [part if part.model is None or part.model == of_cells else Shown(None) for part in parts]
        model = of_cells
    together = Shown(model, [fact for part in parts + extra for fact in part.facts])
    if model is None and any(isinstance(fact.get("harmonic"), np.ndarray) for fact in together.facts):
        raise_invalid("harmonic forms in an array do not know their model", "give both: coface.view([model, forms], path)")
    if model is not None:
        together.facts = [_on_edges(fact, model) for fact in together.facts]
    return together


def _flat(x: Any) -> list[Any]:
    """The members of lists of lists of answers."""
    x = unwrapped(x)
    if is_facts(x):
        return [x]
    if isinstance(x, (list, tuple)) and len(x) == 0:
        return []
    if isinstance(x, (list, tuple)) and (any(is_answer(one) or isinstance(one, dict) for one in x) or any(_is_list_of_answers(one) for one in x)):
        return [one for part in x for one in _flat(part)]
    return [x]


def _is_list_of_answers(x: Any) -> bool:
    return not is_facts(x) and isinstance(x, (list, tuple)) and any(is_answer(one) or isinstance(one, dict) or _is_list_of_answers(one) for one in x)


def _result(x: Any) -> Shown:
    """An answer that is shown over a model of others."""
    return Shown(None, [x]) if isinstance(x, dict) and "recipe" not in x else _one(x)


def _one(x: Any) -> Shown:
    if is_facts(x) and not ({"harmonic", "generators", "loops", "cocycles", "simplices", "diagram"} & set(x if isinstance(x, dict) else ())):
        return Shown()
    if isinstance(x, dict):
        return Shown(None, [{key: value for key, value in x.items() if key != "recipe"}])
    if isinstance(x, np.ndarray) and x.ndim == 2 and x.dtype.kind == "f" and x.shape[1] > 3:
        return Shown(None, [{"harmonic": x}])
    if isinstance(x, Homology):
        found = [one for group in x for one in group.generators]
        return _generators(found, [[one for one in group.generators] for group in x], x.is_cohomology)
    if isinstance(x, HomologyGroup):
        found = list(x.generators)
        return _generators(found, [*([[]] * x.degree), found], x.is_cohomology)
    if isinstance(x, Generator):
        return _generators([x], [*([[]] * x.degree), [x]], x.chain.is_cochain)
    if isinstance(x, Chain):
        facts = {"order": 0, "length": sum(abs(int(value)) for value in x.coefficients), "chain": x.to_dict()["chain"]}
        return Shown(x.model, [{"generators": [*([[]] * x.degree), [facts]], "cohomology": x.is_cochain}] if len(x) else [])
    if isinstance(x, FundamentalGroup):
        return Shown(x.model, [{"loops": [walk.tolist() for walk in x.loops if len(walk) > 1]}] if any(len(walk) > 1 for walk in x.loops) else [])
    if isinstance(x, Domain):
        components = [part for part in x.components if part.get("seams")]
        surface = x.__dict__.get("recipe", (None, (None,)))[1][0]
        if surface is None or not components:
            return Shown(x.model)
        return Shown(surface.model(), [{"components": components}])
    if isinstance(x, Cocycles):
        return _cocycles(x)
    if isinstance(x, Persistence):
        # Points, graphs and images are no complexes.
        asked_of = x.__dict__.get("recipe", (None, (None,)))[1][0]
        model = asked_of.source if isinstance(asked_of, ChainComplex) else None
        return Shown(model, [{"diagram": facts_of(x)["diagram"]}] if len(x) else [])
    if isinstance(x, PlanarArrangement):
        model = x.model()
        is_plain = len(ragged(model.faces)[1]) - 1 == len(x.measures) > 0
        return Shown(model, [{"measures": x.measures, "inside": x.inside}] if is_plain else [])
    if isinstance(x, YinSet):
        return Shown(as_drawn(x), [{"curves": x.curve_facts}] if x.curve_facts else [])
    if isinstance(x, Verdict):
        return Shown(None, [{"simplices": x.cells}] if x.cells else [])
    if isinstance(x, Simplices):
        cells = [row for k in range(1 + (-1 if x.dimension is None else x.dimension)) for row in lists(*ragged(x.simplices(k)))]
        return Shown(as_drawn(x), [{"simplices": [row.tolist() for row in cells]}] if cells else [])
    if isinstance(x, CutCells):
        return Shown(cells_of(x))
    if isinstance(x, ChainComplex):
        return Shown(x.source if x.source is not None else x.model())
    return Shown(as_drawn(x))


def _generators(found: list[Generator], by_degree: list[list[Generator]], is_cohomology: bool) -> Shown:
    if not found:
        return Shown()
    written = [[one.to_dict() for one in group] for group in by_degree]
    return Shown(found[0].model, [{"generators": written, "cohomology": is_cohomology}])


def _cocycles(x: Cocycles) -> Shown:
    surface = x.__dict__.get("recipe", (None, (None,)))[1][0]
    if x.rank == 0:
        return Shown(None if surface is None else surface.model())
    facts: Facts = {"cocycles": [chain.to_dict()["chain"] for chain in x.cocycles], "loops": x.loops}
    if surface is None:
        return Shown(None, [facts])
    if x.harmonic is not None:
        numbers = surface.vertex_numbers
        facts["edges"] = numbers[surface.edge_ends].tolist()
        facts["harmonic"] = [{"values": form.tolist()} for form in x.harmonic]
    return Shown(surface.model(), [facts])


def _on_edges(fact: Facts, model: Model) -> Facts:
    """Harmonic forms as an array, with the edges that they are on."""
    forms = fact.get("harmonic")
    if not isinstance(forms, np.ndarray):
        return fact
    surface = model.surface(boundary=True)
    ends = surface.vertex_numbers[surface.edge_ends]
    if forms.shape[1] != len(ends):
        ends = np.asarray(model.edges)
    if forms.shape[1] != len(ends):
        raise_invalid(
            f"an array of shape {forms.shape} has no value for each of {len(ends)} edges", "give what coface.harmonic(model) gave"
        )
    return {"harmonic": [{"values": form.tolist()} for form in forms], "edges": ends.tolist()}


def cells_of(x: CutCells) -> Model:
    """The cells of a grid that a set meets, with the part that it covers as data."""
    rows, columns = x.coverage.shape
    xs = x.origin[0] + x.spacing[0] * np.arange(columns + 1)
    ys = x.origin[1] + x.spacing[1] * np.arange(rows + 1)
    points = np.column_stack([np.tile(xs, rows + 1), np.repeat(ys, columns + 1)])
    row, column = np.nonzero(x.coverage >= 0)
    corner = row * (columns + 1) + column
    faces = np.column_stack([corner, corner + 1, corner + columns + 2, corner + columns + 1])
    part = x.areas[row, column] / (x.spacing[0] * x.spacing[1])
    return Model(points, faces).with_data("covered", part, "faces") if len(faces) else Model(points)

