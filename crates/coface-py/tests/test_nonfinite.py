"""Coordinates of files that are NaN or infinite."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import coface

TORN = b"v 0 0 0\nv 1 0 0\nv 0 nan inf\nv 0 1 0\nf 1 2 3\nf 1 4 2\n"


@pytest.fixture
def torn() -> coface.Model:
    with pytest.warns(coface.AssumptionWarning, match="1 vertex has a coordinate that is not finite"):
        return coface.Model.from_bytes(TORN, "obj")


def test_they_stay_what_they_are(torn: coface.Model) -> None:
    assert np.array_equal(torn.vertices[2], [0, np.nan, np.inf], equal_nan=True)
    assert np.array_equal(torn.vertices[[0, 1, 3]], [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    again = pickle.loads(pickle.dumps(torn))
    assert np.array_equal(again.vertices, torn.vertices, equal_nan=True)
    assert np.array_equal(again.faces, torn.faces)
    with pytest.raises(coface.InvalidInputError, match="not finite"):
        coface.Model.from_bytes(TORN, "obj", strict=True)


def test_topology_does_without_them(torn: coface.Model) -> None:
    report = torn.report().to_dict()
    assert (report["name"], report["area"], report["f_vector"]) == ("disk", None, [4, 5, 2])
    assert [group.betti for group in coface.homology(torn)] == [1, 0, 0]


def test_pictures_leave_them_out(torn: coface.Model) -> None:
    picture = coface.render(torn, "svg")
    assert picture.startswith(b"<svg") and b"NaN" not in picture


def test_what_needs_all_of_them_names_the_first(torn: coface.Model) -> None:
    for question in [lambda: coface.arrange(torn), lambda: coface.congruence(torn, tolerance=0.1)]:
        with pytest.raises(coface.InvalidInputError, match="of v2 is NaN"):
            question()


def test_plots_and_other_libraries_want_all_of_them(torn: coface.Model) -> None:
    pytest.importorskip("matplotlib").use("agg")
    with pytest.raises(coface.InvalidInputError, match=r"v2 is at \[0.0, nan, inf\]"):
        coface.plot(torn)
    pytest.importorskip("trimesh")
    with pytest.raises(coface.InvalidInputError, match=r"v2 is at \[0.0, nan, inf\]"):
        coface.to_trimesh(torn)
