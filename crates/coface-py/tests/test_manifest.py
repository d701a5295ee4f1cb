"""Real files, and what others found out about them."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import NO_DATA, manifest

import coface

FOUND = manifest()
FILES = FOUND[1]["files"] if FOUND else []
pytestmark = pytest.mark.skipif(FOUND is None, reason=NO_DATA)


def test_there_are_files() -> None:
    assert FOUND is not None
    assert len(FILES) == FOUND[1]["count"]


@pytest.mark.parametrize("entry", FILES, ids=[entry["file"] for entry in FILES])
def test_files_are_what_the_manifest_says(entry) -> None:
    assert FOUND is not None
    path = FOUND[0] / entry["file"]
    try:
        model = coface.read(path)
    except coface.Error as error:
        # Files that are wrong on purpose: the fault has a place.
        assert "vertices" not in entry or entry.get("unreadable"), str(error)
        assert error.file is not None and path.name in error.file
        return
    if "vertices" not in entry:
        return
    report = model.report()
    assert report.f_vector[0] == entry["vertices"]
    for key, found in [
        ("euler", report.euler_characteristic),
        ("components", report.components),
        ("orientable", report.orientable),
        ("coherently_oriented", report.coherently_oriented),
    ]:
        if entry.get(key) is not None and entry.get("face_sizes") is not None and "faces" in entry:
            if key == "euler" and entry.get("degenerate_index_faces"):
                continue
            assert found == entry[key], key
    if entry.get("manifold") is not None:
        assert (report.manifold == "yes") == entry["manifold"]
    for key in ["area", "signed_volume"]:
        found = getattr(report, key)
        if entry.get(key) is not None and found is not None:
            assert found == pytest.approx(entry[key], rel=1e-6), key
    betti = [group.betti for group in report.homology]
    if entry.get("betti") is not None:
        assert betti[: len(entry["betti"])] == entry["betti"]
    complex = coface.as_chain_complex(model)
    for prime, key in [(2, "betti_F2"), (3, "betti_F3")]:
        if entry.get(key) is not None:
            found = list(coface.homology(complex, f"f{prime}").betti_numbers)
            assert found[: len(entry[key])] == entry[key], key
    alternating = sum((-1) ** degree * rank for degree, rank in enumerate(betti))
    assert alternating == report.euler_characteristic
    for degree in range(1, (complex.dimension or 0)):
        product = complex.boundary(degree).astype(np.int64) @ complex.boundary(degree + 1).astype(np.int64)
        assert abs(product).sum() == 0
