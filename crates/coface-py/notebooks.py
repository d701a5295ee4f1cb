"""Executes the notebooks in docs/notebooks, and compares the text that their cells print with what is kept in them.

    python notebooks.py                compare all of them
    python notebooks.py --write        keep what they print and draw
    python notebooks.py 02_surfaces    one of them
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "notebooks"
#: A cell that takes so many seconds has failed.
TIMEOUT = 60


def paths() -> list[Path]:
    """All notebooks, in their order."""
    return sorted(FOLDER.glob("*.ipynb"))


def read(path: Path) -> dict[str, Any]:
    """A notebook as it is kept."""
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def execute(path: Path) -> dict[str, Any]:
    """The same notebook with new outputs. Cells run in the folder of the notebooks; each notebook has a kernel of its own.

    Raises
    ------
    nbclient.exceptions.CellExecutionError
        If a cell fails.
    """
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(str(path), as_version=4)
    for cell in notebook.cells:
        cell.setdefault("outputs", [])
    NotebookClient(notebook, timeout=TIMEOUT, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}).execute()
    return tidied(json.loads(nbformat.writes(notebook)))


def tidied(notebook: dict[str, Any]) -> dict[str, Any]:
    """Without what differs between two runs and two machines: times, versions, numbers of a kernel."""
    cells = []
    for number, cell in enumerate(notebook["cells"]):
        kept: dict[str, Any] = {"cell_type": cell["cell_type"], "id": f"cell-{number}", "metadata": {}, "source": joined(cell["source"]).splitlines(keepends=True)}
        if cell["cell_type"] == "code":
            kept["execution_count"] = None
            kept["outputs"] = together([output(one) for one in cell["outputs"]])
        cells.append(kept)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}}, "nbformat": 4, "nbformat_minor": 5}


def output(one: dict[str, Any]) -> dict[str, Any]:
    """What a cell printed or showed, without its number. Of a picture the text says where its object lay in memory, so it goes."""
    kept = {key: value for key, value in one.items() if key not in ("execution_count", "metadata")}
    if one["output_type"] in ("display_data", "execute_result"):
        kept["metadata"] = {}
        kept["data"] = {kind: value for kind, value in one["data"].items() if kind != "text/plain" or not joined(value).startswith("<IPython.core")}
        if one["output_type"] == "execute_result":
            kept["execution_count"] = None
    if "text" in kept:
        kept["text"] = joined(kept["text"]).splitlines(keepends=True)
    return kept


def together(outputs: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """What is printed in one go as one: kernels send it in pieces, as it comes."""
    found: list[dict[str, Any]] = []
    for one in outputs:
        last = found[-1] if found else {}
        if one["output_type"] == last.get("output_type") == "stream" and one["name"] == last["name"]:
            found[-1] = {**last, "text": (joined(last["text"]) + joined(one["text"])).splitlines(keepends=True)}
        else:
            found.append(one)
    return found


def joined(text: str | list[str]) -> str:
    """A text that may be kept line by line."""
    return text if isinstance(text, str) else "".join(text)


def said(notebook: dict[str, Any]) -> list[list[tuple[str, str]]]:
    """What each cell prints and shows: texts as they are, of pictures and tables their kind alone."""
    found = []
    for cell in notebook["cells"]:
        shown: list[tuple[str, str]] = []
        for one in cell.get("outputs", []):
            if one["output_type"] == "stream":
                shown.append((one["name"], joined(one["text"])))
            for kind, value in sorted(one.get("data", {}).items()):
                shown.append((kind, joined(value) if kind == "text/plain" else ""))
        found.append(shown)
    return found


def differences(kept: dict[str, Any], made: dict[str, Any]) -> list[str]:
    """What the cells print otherwise than the notebook says; nothing if all is the same."""
    faults = []
    for number, (before, now) in enumerate(zip(said(kept), said(made), strict=True)):
        if before != now:
            faults.append(f"cell {number}:\n--- kept\n{before}\n--- now\n{now}")
    return faults


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="notebooks without .ipynb; all if left out")
    parser.add_argument("--write", action="store_true", help="keep what they print and draw")
    options = parser.parse_args()
    status = 0
    for path in paths():
        if options.names and path.stem not in options.names:
            continue
        made = execute(path)
        if options.write:
            path.write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
            continue
        faults = differences(read(path), made)
        print(path.stem, "differs" if faults else "is the same")
        for fault in faults:
            print(fault)
        status |= bool(faults)
    return status


if __name__ == "__main__":
    sys.exit(main())
