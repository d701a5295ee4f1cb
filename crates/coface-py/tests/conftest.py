"""What tests share: real files, and spaces whose answers are in the books."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[3]
#: Small real models that come with the repository.
DATA = ROOT / "data"


def manifest() -> tuple[Path, dict[str, Any]] | None:
    """The folder of real files and its manifest, where the environment variable COFACE_DATA names one."""
    folder = os.environ.get("COFACE_DATA")
    if not folder or not (Path(folder) / "MANIFEST.json").is_file():
        return None
    return Path(folder), json.loads((Path(folder) / "MANIFEST.json").read_text(encoding="utf-8"))


#: Why tests on real files are skipped.
NO_DATA = "tests on real files: the environment variable COFACE_DATA names no folder with a MANIFEST.json"


@pytest.fixture
def spot() -> Path:
    """A cow: a sphere of 5856 triangles."""
    return DATA / "spot.obj"


@pytest.fixture
def projective_plane() -> list[list[int]]:
    """The projective plane with six vertices; Munkres (1984), section 6: its homology is Z, Z/2, 0."""
    return [
        [0, 1, 2], [0, 1, 5], [0, 2, 4], [0, 3, 4], [0, 3, 5],
        [1, 2, 3], [1, 3, 4], [1, 4, 5], [2, 3, 5], [2, 4, 5],
    ]  # fmt: skip


@pytest.fixture
def torus() -> list[list[int]]:
    """The torus with seven vertices (Moebius 1861)."""
    return [[i, (i + 1) % 7, (i + 3) % 7] for i in range(7)] + [[i, (i + 3) % 7, (i + 2) % 7] for i in range(7)]
