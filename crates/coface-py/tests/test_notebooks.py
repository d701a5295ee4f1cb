"""The notebooks in docs/notebooks: executed, and what they print compared with what they show."""

from __future__ import annotations

import importlib.util
import re
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nbclient", reason="nbclient is not installed")
pytest.importorskip("ipykernel", reason="ipykernel is not installed")

PROJECT = Path(__file__).resolve().parents[1]
_SPEC = importlib.util.spec_from_file_location("coface_notebooks", PROJECT / "notebooks.py")
assert _SPEC is not None and _SPEC.loader is not None
notebooks: Any = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(notebooks)
PATHS: list[Path] = notebooks.paths()


@pytest.fixture(scope="module")
def executed():
    """All of them at work, two at a time: half of the time kernels start."""
    with ThreadPoolExecutor(2) as pool:
        found: dict[str, Future[dict[str, Any]]] = {path.stem: pool.submit(notebooks.execute, path) for path in PATHS}
        yield found
        for future in found.values():
            future.cancel()


@pytest.mark.parametrize("name", [path.stem for path in PATHS])
def test_notebooks_print_what_they_show(name: str, executed: dict[str, Future[dict[str, Any]]]) -> None:
    kept = notebooks.read(notebooks.FOLDER / f"{name}.ipynb")
    faults = notebooks.differences(kept, executed[name].result())
    assert faults == [], "\n".join([*faults, "python notebooks.py --write keeps what is printed now"])


def test_there_are_ten_and_they_are_small() -> None:
    assert [path.stem[:2] for path in PATHS] == [f"{number:02}" for number in range(1, 11)]
    for path in PATHS:
        assert path.stat().st_size < 400_000, path.name


def test_no_cell_shows_a_fault_or_a_path_of_this_machine() -> None:
    for path in PATHS:
        notebook = notebooks.read(path)
        assert notebook == notebooks.tidied(notebook), f"{path.name}: write it by notebooks.py --write"
        for cell in notebook["cells"]:
            for one in cell.get("outputs", []):
                assert one["output_type"] != "error", path.name
                text = notebooks.joined(one.get("text", "")) + notebooks.joined(one.get("data", {}).get("text/plain", ""))
                assert not re.search(r"/(home|root|tmp|work)/|object at 0x", text), (path.name, text)


def test_the_docs_lead_to_them() -> None:
    docs = PROJECT.parents[1] / "docs"
    for page in (docs / "python.md", docs / "book" / "src" / "first.md"):
        text = page.read_text(encoding="utf-8")
        missing = [path.name for path in PATHS if path.name not in text]
        assert missing == [], page
