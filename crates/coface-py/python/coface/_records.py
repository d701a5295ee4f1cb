"""Answers as dictionaries and pickles, and back: an answer that holds more than its facts also says how it was made.

The key ``recipe`` of ``to_dict()`` has the function and what it was given. ``from_dict`` and unpickling ask again, which gives the same answer,
bit by bit; everything in a dictionary is JSON.
"""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import numpy as np

from coface import _coface
from coface._arrays import raise_invalid
from coface._coface import (
    Chain,
    ChainComplex,
    Cocycles,
    Complex,
    Congruence,
    Cover,
    Curve,
    CuboidGrid,
    CutCells,
    Domain,
    FundamentalGroup,
    Generator,
    Homology,
    HomologyGroup,
    Kinks,
    LarModel,
    Interface,
    Model,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Report,
    Simplices,
    SimplicialGrid,
    SolidBoolean,
    SpatialArrangement,
    Surface,
    Verdict,
    YinSet,
)
from coface._faults import in_words

Answer = TypeVar("Answer")

#: What recipes may call.
MAKERS: dict[str, Callable[..., Any]] = {
    "ChainComplex.from_boundaries": ChainComplex.from_boundaries,
    "ChainComplex.of_points": ChainComplex.of_points,
    "Complex": Complex,
    **{f"{cls.__name__}.from_dict": getattr(cls, "from_dict") for cls in (Chain, Generator, Homology, HomologyGroup, Verdict) if hasattr(cls, "from_dict")},
    "FundamentalGroup": FundamentalGroup,
    "CuboidGrid": CuboidGrid,
    "CuboidGrid.of_lengths": lambda lengths: CuboidGrid(lengths=lengths),
    "Kinks.of": lambda region: region.kinks,
    "LarModel": LarModel,
    "SimplicialGrid": SimplicialGrid,
    "Simplices": Simplices,
    "Surface.cocycles": Surface.cocycles,
    "Surface.cover": Surface.cover,
    "Surface.cut": Surface.cut,
    "YinSet.cut_cells": YinSet.cut_cells,
    "interface": _coface._interface,
    **{name: getattr(_coface, name) for name in ("_chains", "_named_chains", "_curve", "_group", "_interface_of_text", "_model", "_report", "_surface", "_yin_set")},
    **{name: getattr(_coface, name) for name in ("alpha", "arrange", "boolean", "cech", "congruence", "cubical", "flag", "persistence", "rips", "witness")},
}
#: Functions of pickles that have other names in dictionaries.
_NAMES: dict[Any, str] = {}
#: Classes whose answers are asked for again.
ASKED = (
    Cocycles,
    Congruence,
    Cover,
    CutCells,
    Domain,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    SolidBoolean,
    SpatialArrangement,
)
#: Classes that are made again of their parts.
MADE = (ChainComplex, Complex, CuboidGrid, Curve, FundamentalGroup, Interface, Kinks, LarModel, Model, Report, SimplicialGrid, Simplices, Surface, YinSet)


def asked(name: str, *arguments: Any, **options: Any) -> Any:
    """The answer of a maker, which remembers how it was made: of what a caller may change later it keeps a copy, so that the answer can be made again.

    Examples
    --------
    >>> import coface
    >>> coface.arrange(coface.generate("box", boundary=True)).__dict__["recipe"][0]
    'arrange'
    """
    progress = {key: options.pop(key) for key in ("progress",) if key in options}
    arguments, options = kept(arguments), kept(options)
    found = _TOLD.get(name, MAKERS[name])(*arguments, **options, **progress)
    found.__dict__["recipe"] = (name, arguments, options)
    return found


def remember(answer: Any, name: str, x: Any, **options: Any) -> None:
    """Keeps beside an answer what it was asked of, for its certificate: an object of this package, which nobody can change."""
    answer.__dict__["asked"] = (name, x, options)


def kept(value: Any) -> Any:
    """A value that nobody else can change: arrays, matrices, lists and dictionaries are copied, but for arrays that are read-only and own their numbers.

    Examples
    --------
    >>> given = np.zeros(2)
    >>> held = kept([given, {"a": given}])
    >>> given[:] = 7
    >>> held[0].tolist(), held[1]["a"].tolist(), kept(held[0]) is held[0]
    ([0.0, 0.0], [0.0, 0.0], True)
    """
    if isinstance(value, np.ndarray):
        if type(value) is np.ndarray and value.flags.owndata and not value.flags.writeable and value.dtype != object:
            return value
        copied = np.array(value)
        copied.flags.writeable = False
        return copied
    if type(value) is list:
        return [one if type(one) in _PLAIN else kept(one) for one in value]
    if type(value) is tuple:
        return tuple(one if type(one) in _PLAIN else kept(one) for one in value)
    if type(value) is dict:
        return {key: kept(one) for key, one in value.items()}
    return value.copy() if hasattr(value, "tocoo") else value


#: What cannot be changed.
_PLAIN = frozenset({int, float, str, bool, bytes, type(None)})


def _again(name: str, arguments: tuple[Any, ...], options: dict[str, Any]) -> Any:
    """Makes what a pickle holds."""
    return asked(name, *arguments, **options)


def _reduce(self: Any) -> tuple[Any, ...]:
    if "recipe" not in self.__dict__:
        raise_invalid(f"this {type(self).__name__} does not know how it was made", "ask by the functions of coface")
    return _again, self.__dict__["recipe"]


def written(value: Any) -> Any:
    """A value as JSON: arrays, matrices and objects of this package by what makes them.

    Examples
    --------
    >>> import coface
    >>> read_back(written({"a": [1, np.float64("inf")], "b": np.arange(3)}))
    {'a': [1, inf], 'b': array([0, 1, 2])}
    """
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, (float, np.floating)):
        return float(value) if math.isfinite(value) else {"float": repr(float(value))}
    if isinstance(value, (np.integer, np.bool_)):
        return value.item()
    if isinstance(value, bytes):
        return {"json": json.loads(value)}
    if isinstance(value, np.ndarray):
        flat = value.reshape(-1).tolist()
        items = [written(item) for item in flat] if value.dtype.kind in "fO" else flat
        return {"array": items, "dtype": str(value.dtype), "shape": list(value.shape)}
    if hasattr(value, "tocoo"):
        found = value.tocoo()
        entries = [found.row.tolist(), found.col.tolist(), found.data.tolist()]
        return {"matrix": entries, "shape": list(value.shape), "dtype": str(value.dtype)}
    if isinstance(value, tuple):
        return {"tuple": [written(item) for item in value]}
    if isinstance(value, list):
        return [written(item) for item in value]
    if isinstance(value, Mapping) and type(value).__module__ != "coface":
        return {"items": [[written(key), written(item)] for key, item in value.items()]}
    if type(value).__module__ == "coface":
        maker, arguments = value.__reduce__()[:2]
        if maker is _again:
            name, arguments, options = arguments
        else:
            name, options = _NAMES.get(maker, getattr(maker, "__qualname__", maker.__name__)), {}
        return {"made_by": name, "arguments": [written(item) for item in arguments], "options": {k: written(v) for k, v in options.items()}}
    raise_invalid(f"a {type(value).__name__} cannot be written to a dictionary", "give arrays, lists and models")


def read_back(value: Any) -> Any:
    """The value that :func:`written` wrote."""
    if isinstance(value, list):
        return [read_back(item) for item in value]
    if not isinstance(value, Mapping):
        return value
    if "float" in value:
        return float(value["float"])
    if "json" in value:
        return json.dumps(value["json"]).encode()
    if "array" in value:
        return np.array(read_back(value["array"]), dtype=value["dtype"]).reshape(value["shape"])
    if "matrix" in value:
        from scipy.sparse import coo_array

        rows, columns, data = value["matrix"]
        shape = (int(value["shape"][0]), int(value["shape"][1]))
        return coo_array((np.array(data, dtype=value["dtype"]), (rows, columns)), shape=shape).tocsc()
    if "tuple" in value:
        return tuple(read_back(item) for item in value["tuple"])
    if "items" in value:
        return {read_back(key): read_back(item) for key, item in value["items"]}
    maker = value.get("made_by")
    if maker not in MAKERS:
        raise_invalid(f"this dictionary was made by {maker!r}", "give what to_dict() gave")
    arguments = [read_back(item) for item in value["arguments"]]
    options = {key: read_back(item) for key, item in value["options"].items()}
    if maker in RECIPES:
        return asked(maker, *arguments, **options)
    return MAKERS[maker](*arguments, **options)


#: The makers whose answers remember how they were made.
RECIPES = ("alpha", "arrange", "boolean", "cech", "congruence", "cubical", "flag", "interface", "persistence", "rips", "Surface.cocycles", "Surface.cover", "Surface.cut", "witness", "YinSet.cut_cells")
#: The methods among them as they are compiled.
_TOLD: dict[str, Callable[..., Any]] = {name: maker for name, maker in MAKERS.items() if name.startswith(("Surface.", "YinSet."))}


def from_dict(cls: type[Answer], facts: Mapping[str, Any]) -> Answer:
    """The answer that ``to_dict()`` wrote."""
    if cls is Report and isinstance(facts, Mapping) and facts and "recipe" not in facts:
        raise_invalid("this report was written without its model", "write it with report.to_dict(model=True)")
    if not isinstance(facts, Mapping) or "recipe" not in facts:
        raise_invalid(f"there is no recipe for a {cls.__name__}", f"give what {cls.__name__}.to_dict() gave")
    found = read_back(facts["recipe"])
    if not isinstance(found, cls):
        raise_invalid(f"this is a {type(found).__name__}, not a {cls.__name__}", f"give what {cls.__name__}.to_dict() gave")
    return found


#: The facts of answers that are asked for again, as the compiled part knows them.
FACTS: dict[type, Callable[[Any], dict[str, Any]] | None] = {}


def facts_of(x: Any) -> dict[str, Any]:
    """The facts of an answer without how it was made, which takes time on large models.

    Examples
    --------
    >>> import coface
    >>> "recipe" in facts_of(coface.cover(coface.generate("torus"), radius=1))
    False
    """
    compiled = FACTS.get(type(x))
    found: Any = compiled(x) if compiled is not None else x.to_dict()
    return {key: value for key, value in found.items() if key != "recipe"} if isinstance(found, dict) else {}


def _facts(compiled: Callable[[Any], dict[str, Any]] | None) -> Callable[[Any], dict[str, Any]]:
    def to_dict(self: Any) -> dict[str, Any]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        facts = {} if compiled is None else compiled(self)
        if "recipe" in self.__dict__:
            facts["recipe"] = written(self)
        return dict(sorted(facts.items()))

    return to_dict


def _persistence_facts(self: Persistence) -> dict[str, Any]:
    pairs = [(degree, float(birth), float(death)) for degree, (birth, death) in self.to_gudhi()]
    finite = [{"degree": k, "birth": _or_none(birth), "death": _or_none(death)} for k, birth, death in pairs]
    return {"diagram": finite, "falling": self.is_falling, "prime": self.prime}


def _cut_facts(self: CutCells) -> dict[str, Any]:
    return {
        "areas": self.areas.tolist(),
        "counts": self.counts(),
        "coverage": self.coverage.tolist(),
        "lengths": self.lengths.tolist(),
        "origin": self.origin,
        "spacing": self.spacing,
        "total_area": self.total_area,
        "total_length": self.total_length,
    }


def _or_none(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _equal(self: Any, other: object) -> Any:
    """Whether two answers say the same, however they were asked for."""
    if not isinstance(other, type(self)):
        return NotImplemented
    return self is other or bool(facts_of(self) == facts_of(other) and _parts_of(self) == _parts_of(other))


def _parts_of(x: Any) -> Any:
    """What an answer has besides its facts, to be compared."""
    if isinstance(x, Persistence):
        return [_cells_of(x, degree) for degree in range(len(x.diagrams))]
    if isinstance(x, Cocycles):
        forms = None if x.harmonic is None else [np.asarray(form).tolist() for form in x.harmonic]
        return [chain.to_dict()["chain"] for chain in x.cocycles], forms
    if isinstance(x, Interface):
        return x.vertices, x.edges
    model = getattr(x, "model", None)
    return model() if callable(model) else model


def _cells_of(x: Persistence, degree: int) -> Any:
    """The simplices, or the voxels of an image, that make and end the classes of a degree."""
    name = x.__dict__.get("recipe", ("",))[0]
    return x.voxels(degree).tolist() if name == "cubical" else x.simplices(degree)


def _equal_surfaces(self: Surface, other: object) -> Any:
    if not isinstance(other, Surface):
        return NotImplemented
    return bool(self.f_vector == other.f_vector and self.model() == other.model())


def _hash(self: Any) -> int:
    return hash(repr(self))


def _recipe_of(self: Any) -> dict[str, Any]:
    """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
    return {"recipe": written(self)}


def _reduce_lar(self: LarModel) -> tuple[Any, ...]:
    counts = self.f_vector
    return LarModel, ([self.cells(degree) for degree in range(1, len(counts))], counts[0] if counts else 0)


def _reduce_simplicial(self: SimplicialGrid) -> tuple[Any, ...]:
    return SimplicialGrid, (self.shape,)


def _reduce_cuboids(self: CuboidGrid) -> tuple[Any, ...]:
    # Corners tell the shape, and where lengths are not 1 or places are left out, the lengths of all intervals.
    corners = self.vertices
    shape = [int(last) for last in corners.max(axis=0)] if corners.size else []
    plain = CuboidGrid(shape) if np.prod([last + 1.0 for last in shape]) == len(corners) else None
    if plain is not None and _are_equal_cells(plain, self):
        return CuboidGrid, (shape,)
    lengths = _lengths(self)
    made = CuboidGrid(lengths=lengths) if lengths else None
    if made is None or not _are_equal_cells(made, self):
        raise_invalid("the lengths of this CuboidGrid cannot be told from its corners", "pickle its model: grid.model()")
    return _cuboids_of_lengths, (lengths,)


def _cuboids_of_lengths(lengths: list[list[float]]) -> CuboidGrid:
    """The grid that has these lengths."""
    return CuboidGrid(lengths=lengths)


def _lengths(grid: CuboidGrid) -> list[list[float]]:
    """The lengths of the intervals of each axis, those of gaps negative."""
    dimension, found = grid.dimension, []
    if dimension is None:
        return []
    corners = np.array([grid.cell(dimension, cell)[1] for cell in range(grid.f_vector[dimension])])
    for axis in range(dimension):
        places = np.unique(grid.vertices[:, axis])
        is_full = np.isin(np.arange(len(places) - 1), corners[:, axis])
        found.append([float(length) for length in np.where(is_full, 1, -1) * np.diff(places)])
    return found


def _are_equal_cells(a: CuboidGrid, b: CuboidGrid) -> bool:
    top = a.dimension
    return a.f_vector == b.f_vector and np.array_equal(a.vertices, b.vertices) and (top is None or np.array_equal(a.cells(top), b.cells(top)))


def _equal_cells(self: Any, other: object) -> Any:
    if not isinstance(other, type(self)):
        return NotImplemented
    if isinstance(self, CuboidGrid) and isinstance(other, CuboidGrid):
        return _are_equal_cells(self, other)
    return bool(self.__reduce__()[0] is other.__reduce__()[0] and written(self) == written(other))


def _kinks_of(region: YinSet) -> Kinks:
    """The kinks of a set."""
    return region.kinks


def _reduce_kinks(self: Kinks) -> tuple[Any, ...]:
    return _kinks_of, (self.set,)


def _kinks_facts(self: Kinks) -> dict[str, Any]:
    """The kinks as a dictionary: ``kinks`` with a name, a curve, a knot and a point each, and ``recipe``, which ``from_dict`` reads."""
    rows = zip(self.vertices.tolist(), self.knots.tolist(), self.points.tolist(), strict=True)
    return {"kinks": [{"vertex": vertex, "curve": at[0], "knot": at[1], "point": point} for vertex, at, point in rows], **_recipe_of(self)}


def _simplices_facts(self: Simplices) -> dict[str, Any]:
    """The simplices in the words of the program's JSON, and ``recipe``, which ``from_dict`` reads."""
    cells = self.__reduce__()[1][0]
    return {"f_vector": list(self.f_vector), "is_complex": self.is_complex, **_recipe_of(self), "simplices": cells}


def _reduce_verdict(self: Verdict) -> tuple[Any, ...]:
    return Verdict.from_dict, (self.to_dict(),)


def install() -> None:
    """Gives the classes their methods; the compiled part knows nothing of recipes."""
    _NAMES.update({_cuboids_of_lengths: "CuboidGrid.of_lengths", _kinks_of: "Kinks.of"})
    for name, compiled in _TOLD.items():

        def method(self: Any, *arguments: Any, __name: str = name, **options: Any) -> Any:
            return asked(__name, self, *arguments, **options)

        functools.update_wrapper(method, compiled)
        owner: type = YinSet if name.startswith("YinSet.") else Surface
        setattr(owner, name.partition(".")[2], in_words(method))
    FACTS.update({cls: getattr(cls, "to_dict", None) for cls in ASKED})
    FACTS[Persistence] = _persistence_facts
    FACTS[CutCells] = _cut_facts
    for cls in ASKED:
        setattr(cls, "to_dict", _facts(FACTS[cls]))
        setattr(cls, "from_dict", classmethod(from_dict))
        setattr(cls, "__reduce__", _reduce)
        setattr(cls, "__eq__", _equal)
        setattr(cls, "__hash__", _hash)
    for made in MADE:
        setattr(made, "from_dict", classmethod(from_dict))
        if made not in (Interface, Kinks, Report, Simplices, YinSet):
            setattr(made, "to_dict", _recipe_of)
    for grid, reduce in ((LarModel, _reduce_lar), (SimplicialGrid, _reduce_simplicial), (CuboidGrid, _reduce_cuboids), (Kinks, _reduce_kinks)):
        setattr(grid, "__reduce__", reduce)
        setattr(grid, "__eq__", _equal_cells)
        setattr(grid, "__hash__", _hash)
    setattr(Kinks, "to_dict", _kinks_facts)
    setattr(Simplices, "to_dict", _simplices_facts)
    setattr(Verdict, "__reduce__", _reduce_verdict)
    setattr(Verdict, "__eq__", _equal)
    setattr(Verdict, "__hash__", _hash)
    setattr(Surface, "__eq__", _equal_surfaces)
    setattr(Surface, "__hash__", _hash)
    shortened = Persistence.longer_than

    def longer_than(self: Persistence, length: float) -> Persistence:
        found: Persistence = shortened(self, length)
        if "recipe" in self.__dict__:
            name, arguments, options = self.__dict__["recipe"]
            found.__dict__["recipe"] = (name, arguments, {**options, "least": max(options.get("least", 0.0), float(length))})
        if "asked" in self.__dict__:
            name, x, options = self.__dict__["asked"]
            remember(found, name, x, **{**options, "min_persistence": max(options["min_persistence"], float(length))})
        return found

    functools.update_wrapper(longer_than, shortened)
    setattr(Persistence, "longer_than", in_words(longer_than))
    yin_facts, report_facts, interface_facts = YinSet.to_dict, Report.to_dict, Interface.to_dict
    FACTS[YinSet] = yin_facts
    FACTS[Interface] = interface_facts
    FACTS[Report] = report_facts

    def set_to_dict(self: YinSet) -> dict[str, Any]:
        """The set as a dictionary, in the words of the program's JSON, with its curves in ``recipe``, which ``from_dict`` reads."""
        return dict(sorted({**yin_facts(self), **_recipe_of(self)}.items()))

    def interface_to_dict(self: Interface) -> dict[str, Any]:
        """The interface as a dictionary, in the words of the program's JSON, with what it is made of in ``recipe``, which ``from_dict`` reads."""
        return dict(sorted({**interface_facts(self), **_recipe_of(self)}.items()))

    def report_to_dict(self: Report, limit: int = 100, *, model: bool = False) -> dict[str, Any]:
        """The report as ``coface info --json`` prints it, but for ``file``.

        Parameters
        ----------
        limit
            How many places of each problem are listed.
        model
            Whether the model stands in it too, as ``recipe``, which ``from_dict`` needs.

        Returns
        -------
        dict
            ``kind``, ``dimension``, ``f_vector``, ..., with ``format`` if the model came from a file.

        Examples
        --------
        >>> import coface
        >>> report = coface.Model.from_facets([[0, 1]]).report()
        >>> report.to_dict()["homology"][0]
        {'betti': 1, 'degree': 0, 'torsion': []}
        >>> coface.Report.from_dict(report.to_dict(model=True)) == report
        True
        """
        found: dict[str, Any] = report_facts(self, limit)
        return {**found, **_recipe_of(self)} if model else found

    setattr(YinSet, "to_dict", set_to_dict)
    setattr(Interface, "to_dict", interface_to_dict)
    setattr(Interface, "__eq__", _equal)
    setattr(Interface, "__hash__", _hash)
    setattr(Report, "to_dict", report_to_dict)
