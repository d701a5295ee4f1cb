"""The types that editors and checkers see: docstrings in the stub, and calls that work are accepted."""

from __future__ import annotations

import ast
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

import coface

PACKAGE = Path(coface.__file__).parent
PROJECT = Path(__file__).resolve().parents[1]

SCRIPT = '''
import numpy as np
from pathlib import Path
import coface

model = coface.read("a.off")
betti: tuple[int, ...] = coface.homology(model, 2).betti_numbers
betti = coface.homology(model, "f2", generators=True).betti_numbers
betti = coface.as_chain_complex(model).homology(2).betti_numbers
betti = coface.persistence(model, np.zeros(3), coefficients=3).betti_numbers
order: int | None = coface.homology(model)[0].generators[0].order
walk = coface.homology(model)[0].generators[0].loop
if walk is not None:
    start: int = int(walk[0])
name: str | None = coface.classify(model)[0]["name"]
bounds: bool = coface.classes(model, [])[0]["bounds"]
matrix = coface.intersection_form(model)["matrix"].sum()
page: Path = coface.view([model, coface.pi1(model)], "a.html")
picture: bytes = coface.render(coface.cut(model), "png", size=(100, 100))
rows: list[coface.BatchRow] = coface.batch("*.off")
reports: list[dict[str, object]] = [dict(row) for row in coface.batch("*.off", flat=False)]
summary: coface.BatchSummary = coface.batch("*.off", "rows.csv")
volume: coface.Model = coface.volume(np.zeros((3, 3)), threshold=0.5).to_model(surface=True, spacing=(1.0, 1.0, 2.0))
again: coface.Cover = coface.Cover.from_dict(coface.cover(model, radius=1).to_dict())
genus: int | None = model.report().genus
kind: str = model.report().problems[0]["kind"]
'''

WRONG = '''
import coface

coface.homology(coface.read("a.off"), 2.5)
coface.read("a.off").report().genus + 1
coface.classify([[0, 1, 2]])[0]["colour"]
'''


def _check(text: str, folder: Path) -> subprocess.CompletedProcess[str]:
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")
    (folder / "script.py").write_text(text)
    cache = Path(__import__("tempfile").gettempdir()) / "coface-mypy"
    words = ["--config-file", str(PROJECT / "pyproject.toml"), "--cache-dir", str(cache), str(folder / "script.py")]
    return subprocess.run([sys.executable, "-m", "mypy", *words], capture_output=True, text=True, cwd=PACKAGE.parent, check=False)


def test_calls_that_work_are_accepted(tmp_path: Path) -> None:
    run = _check(SCRIPT, tmp_path)
    assert run.returncode == 0, run.stdout


def test_calls_that_fail_are_refused(tmp_path: Path) -> None:
    run = _check(WRONG, tmp_path)
    assert run.returncode == 1
    assert [int(line.split(":")[1]) for line in run.stdout.splitlines() if ": error:" in line] == [4, 5, 6]


def test_the_stub_has_the_docstrings() -> None:
    run = subprocess.run([sys.executable, str(PROJECT / "stubs.py")], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr


def test_results_have_types() -> None:
    """No result of the stub is Any, but those of other libraries."""
    foreign = {"plot", "to_shapely", "__reduce__", "from_dict"}
    found = []
    for node in ast.walk(ast.parse((PACKAGE / "_coface.pyi").read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef) and node.returns is not None and node.name not in foreign:
            if not node.name.startswith("_") and "Any" in ast.unparse(node.returns):
                found.append(node.name)
    assert found == []
