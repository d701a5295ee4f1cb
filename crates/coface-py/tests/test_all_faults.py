"""Every public function with wrong arguments: whatever it raises is a fault of this package."""

from __future__ import annotations

import importlib
import inspect
import re
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coface
import coface.interop.sparse
import coface.shards

#: What is nearly never right.
WRONG = [None, object(), -1, 2**70, 1.5, float("nan"), "no such thing", b"\xff\x00", [], [[-1]], [["x"]], {"x": 1}, lambda *given: given, np.zeros((2, 2, 2, 2)), True, np.array(["a"])]
#: What is never called here: it starts processes or waits for them, or its faults are those of other libraries.
#: What makes right calls fast.
SMALL = {"coface.render": {"size": (40, 30)}, "coface.widget": {"report": False}, "coface.page": {"report": False}}
LEFT_OUT = {"batch", "plot", "signatures"}
TORUS = coface.generate("csaszar")
SQUARE = coface.polygon([[0, 0], [2, 0], [2, 2], [0, 2]])
BOX = coface.generate("box", boundary=True)
DISK = coface.YinSet([coface.Curve.circle([0, 0], 1)])

#: An object of each class.
EXAMPLES: dict[str, Callable[[], Any]] = {
    "CellGraph": lambda: coface.arrange(BOX).graph(),
    "Chain": lambda: TORUS.chain_complex().chain([(1, [0, 1])]),
    "ChainComplex": lambda: TORUS.chain_complex(),
    "Cocycles": lambda: coface.cocycles(TORUS),
    "Complex": lambda: TORUS.complex(),
    "Congruence": lambda: coface.congruence(BOX, tolerance=0.1),
    "Cover": lambda: coface.cover(TORUS, radius=1),
    "CuboidGrid": lambda: coface.CuboidGrid((2, 1)),
    "Curve": lambda: coface.Curve.circle([0, 0], 1),
    "CutCells": lambda: DISK.cut_cells((2, 2)),
    "Domain": lambda: coface.cut(TORUS),
    "FundamentalGroup": lambda: coface.pi1(TORUS)[0],
    "Generator": lambda: coface.homology(TORUS, generators=True)[1].generators[0],
    "Homology": lambda: coface.homology(TORUS, generators=True),
    "HomologyGroup": lambda: coface.homology(TORUS, generators=True)[1],
    "Interface": lambda: coface.interface(np.array([[1, 2], [1, 1]])),
    "Kinks": lambda: (DISK & coface.YinSet([coface.Curve.circle([1, 0], 1)])).kinks,
    "LarModel": lambda: coface.LarModel([[[0, 1], [1, 2], [0, 2]], [[0, 1, 2]]]),
    "Model": lambda: TORUS,
    "Persistence": lambda: coface.persistence(TORUS, np.arange(7.0)),
    "PlanarArrangement": lambda: coface.arrange(SQUARE),
    "PlanarBoolean": lambda: coface.boolean("union", SQUARE),
    "Report": lambda: TORUS.report(),
    "Simplices": lambda: TORUS.complex().star([0]),
    "SimplicialGrid": lambda: coface.SimplicialGrid((1, 1)),
    "SolidBoolean": lambda: coface.boolean("union", BOX),
    "SpatialArrangement": lambda: coface.arrange(BOX),
    "Surface": lambda: TORUS.surface(),
    "Verdict": lambda: TORUS.complex().is_manifold(),
    "YinSet": lambda: DISK,
}


#: What Python says of classes that nobody makes objects of.
PROTOCOL = re.compile("cannot create")


def callables() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Functions, constructors and methods, with names."""
    for module in ("coface", "coface.maps", "coface.shards", "coface.interop.sparse"):
        found = importlib.import_module(module)
        names = getattr(found, "__all__", None) or [name for name, value in vars(found).items() if not name.startswith("_") and getattr(value, "__module__", "") == module]
        for name in names:
            thing = getattr(found, name)
            if inspect.isclass(thing) and issubclass(thing, BaseException) or name in LEFT_OUT or not callable(thing):
                continue
            is_record = inspect.isclass(thing) and (hasattr(thing, "__dataclass_fields__") or issubclass(thing, dict))
            if not is_record:
                yield f"{module}.{name}", thing
    for name, make in EXAMPLES.items():
        example = make()
        for member in dir(type(example)):
            if not member.startswith("_") and member not in LEFT_OUT and callable(getattr(type(example), member)):
                yield f"{name}.{member}", getattr(example, member)


CALLABLES = dict(callables())


def resolves(path: str) -> bool:
    """Whether a dotted name of the package is there."""
    thing = coface
    for part in path.split(".")[1:]:
        if not hasattr(thing, part):
            return False
        thing = getattr(thing, part)
    return path.startswith("coface.")


def calls(function: Callable[..., Any]) -> Iterator[tuple[tuple[Any, ...], dict[str, Any]]]:
    """Arguments that are wrong in one place, and ones that are wrong in all."""
    yield (), {}
    yield (), {"no_such_parameter": 1}
    yield (1, 2, 3, 4, 5, 6, 7, 8, 9), {}
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        parameters = []
    needed = [one for one in parameters if one.default is one.empty and one.kind in (one.POSITIONAL_ONLY, one.POSITIONAL_OR_KEYWORD)]
    must = [one.name for one in parameters if one.default is one.empty and one.kind is one.KEYWORD_ONLY]
    optional = [one.name for one in parameters if one.default is not one.empty and one.kind is not one.POSITIONAL_ONLY]
    for wrong in WRONG:
        yield (wrong,) * max(len(needed), 1), dict.fromkeys(must, wrong)
        # The first one is right.
        if needed:
            yield (TORUS, *(wrong,) * (len(needed) - 1)), dict.fromkeys(must, wrong)
        for name in optional:
            yield (TORUS,) * len(needed), {**dict.fromkeys(must, wrong), name: wrong}


@pytest.mark.parametrize("name", sorted(CALLABLES))
def test_whatever_is_raised_is_a_fault_of_this_package(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    faults = {}
    for arguments, options in calls(CALLABLES[name]):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                CALLABLES[name](*arguments, **{**(SMALL.get(name, {}) if options else {}), **options})
        except coface.Error as error:
            # Whatever a message sends to is there.
            for path in re.findall(r"help\(([\w.<>]+)\)", str(error)):
                if not resolves(path):
                    faults[f"help({path})"] = f"{arguments!r:.120} {options!r:.120}"
        except TypeError as error:
            # Python itself says what cannot be made.
            if not (inspect.isclass(CALLABLES[name]) and PROTOCOL.search(str(error))):
                faults[f"{type(error).__name__}: {error}"[:200]] = f"{arguments!r:.120} {options!r:.120}"
        except Exception as error:  # noqa: BLE001
            faults[f"{type(error).__name__}: {error}"[:200]] = f"{arguments!r:.120} {options!r:.120}"
    assert faults == {}


def test_every_class_is_asked() -> None:
    classes = {name for name in coface.__all__ if inspect.isclass(getattr(coface, name)) and not issubclass(getattr(coface, name), Exception)}
    # Rows and records hold what they are given.
    assert classes - set(EXAMPLES) <= {"BatchRow", "BatchSummary", "CellEdge", "CellNode", "Verified"}
