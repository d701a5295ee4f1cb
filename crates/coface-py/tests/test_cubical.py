"""Persistence of images, beside gudhi where it is there."""

from __future__ import annotations

import importlib.util
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coface

RANDOM = np.random.default_rng(5)
IMAGES: list[Any] = [
    RANDOM.integers(0, 6, 30),
    RANDOM.integers(0, 9, (7, 9)),
    RANDOM.random((5, 6, 7), dtype=np.float32),
    RANDOM.integers(0, 50, (3, 4, 3, 4)),
]


def points(diagrams: Any) -> list[Any]:
    """Finite and infinite points of each degree in one order."""
    return [sorted(map(tuple, np.asarray(diagram).reshape(-1, 2).tolist())) for diagram in diagrams]


@pytest.mark.skipif(importlib.util.find_spec("gudhi") is None, reason="gudhi is not installed")
@pytest.mark.parametrize("image", IMAGES, ids=["1d", "2d", "3d", "4d"])
@pytest.mark.parametrize("construction", ["t", "v"])
@pytest.mark.parametrize("is_periodic", [False, True])
def test_gudhi_agrees(image: Any, construction: Any, is_periodic: bool) -> None:
    """All constructions, with the first axis periodic and without."""
    import gudhi

    name = {"t": "top_dimensional_cells", "v": "vertices"}[construction]
    values = np.asarray(image, np.float64)
    if is_periodic:
        axes = [True] + [False] * (values.ndim - 1)
        if construction == "v":
            pytest.skip("gudhi makes no periodic complex of vertices with free axes")
        theirs = gudhi.PeriodicCubicalComplex(periodic_dimensions=axes, **{name: values})
        ours = coface.cubical(image, construction=construction, periodic=[0])
    else:
        theirs = gudhi.CubicalComplex(**{name: values})
        ours = coface.cubical(image, construction=construction)
    theirs.compute_persistence(homology_coeff_field=2, min_persistence=0.0)
    degrees = range(values.ndim + 1)
    wanted = [np.array(theirs.persistence_intervals_in_dimension(degree)).reshape(-1, 2) for degree in degrees]
    assert points(ours.diagrams) == points(wanted)


@pytest.mark.parametrize("image", IMAGES, ids=["1d", "2d", "3d", "4d"])
def test_superlevel_sets(image: Any) -> None:
    """They are sublevel sets of the opposite, and voxels have the values."""
    image = np.asarray(image, np.float64)
    falling, rising = coface.cubical(image, superlevel=True), coface.cubical(-image)
    assert falling.is_falling and not rising.is_falling
    for degree in range(image.ndim):
        ours, theirs = falling.diagram(degree), rising.diagram(degree)
        finite = np.isfinite(ours[:, 1])
        assert np.array_equal(ours[:, 0], -theirs[:, 0]) and np.array_equal(ours[finite, 1], -theirs[finite, 1])
        places = falling.voxels(degree)
        assert places.shape == (len(ours), 2, image.ndim)
        assert np.array_equal(image[tuple(places[:, 0].T)], ours[:, 0])
        assert np.array_equal(image[tuple(places[finite, 1].T)], ours[finite, 1])


def test_masks_and_what_is_no_number() -> None:
    """NaN is outside, as what a mask leaves out."""
    row = np.array([0.0, 5.0, 1.0, 7.0])
    masked = coface.cubical(row, mask=[1, 0, 1, 1])
    assert masked.betti_numbers == (2, 0)
    assert masked.diagrams[0].tolist() == coface.cubical([0, np.nan, 1, 7]).diagrams[0].tolist()
    assert coface.cubical(row, periodic=[0]).diagram(1).tolist() == [[7.0, np.inf]]
    with pytest.raises(coface.ShapeError, match="mask has the shape"):
        coface.cubical(row, mask=[1, 0])


def test_files_have_their_axes(tmp_path: Path) -> None:
    """A file and its array have one diagram; the axes of NRRD run x first."""
    np.save(tmp_path / "a.npy", IMAGES[1])
    assert points(coface.cubical(tmp_path / "a.npy").diagrams) == points(coface.cubical(IMAGES[1]).diagrams)
    (tmp_path / "a.nrrd").write_text("NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n0 5 1\n6 6 6\n")
    found = coface.cubical(tmp_path / "a.nrrd")
    assert found.voxels(0).tolist() == [[[0, 0], [-1, -1]], [[2, 0], [1, 0]]]
    (tmp_path / "a.json").write_text("[[0,1]]")
    with pytest.raises(coface.InvalidInputError, match="is no volume"):
        coface.cubical(tmp_path / "a.json")


def test_answers_are_values() -> None:
    """They are pickled, compared, drawn and written as other diagrams."""
    found = coface.cubical(IMAGES[1], coefficients=3, construction="v", least=1.0)
    again = pickle.loads(pickle.dumps(found))
    assert again == found and again.prime == 3
    assert coface.Persistence.from_dict(found.to_dict()) == found
    assert found.to_svg().startswith("<svg") or "<svg" in found.to_svg()
    assert found.to_bytes("gudhi").startswith(b"3 0 ")
    assert len(found.longer_than(3.0)) < len(found)
    with pytest.raises(coface.InvalidInputError, match=r"\.voxels\(degree\)"):
        found.pairs(0)
    with pytest.raises(coface.InvalidInputError, match=r"\.simplices\(degree\)"):
        coface.rips([[0.0], [1.0]]).voxels(0)


@pytest.mark.parametrize(
    ("x", "options", "message"),
    [
        (3.0, {}, "without axes"),
        (np.zeros((2,) * 5), {}, "one to four axes"),
        ([0.0, -np.inf], {}, "is at -inf"),
        ([0.0, 1.0], {"construction": "u"}, "construction"),
        ([0.0, 1.0], {"periodic": [1]}, "axis|axes"),
        (["a"], {}, "numbers"),
    ],
)
def test_refusals(x: Any, options: Any, message: str) -> None:
    """What is wrong is named."""
    with pytest.raises(coface.Error, match=message):
        coface.cubical(x, **options)


def test_masked_voxels_are_outside() -> None:
    values = np.array([[1.0, 2.0, 1.0], [2.0, 0.0, 2.0], [1.0, 2.0, 1.0]])
    masked = np.ma.masked_equal(values, 0.0)
    assert coface.cubical(masked) == coface.cubical(values, mask=values != 0)
    assert coface.cubical(masked).diagram(1).tolist() == [[2.0, np.inf]]
    inside = np.ones((3, 3), bool)
    inside[0, 1] = False
    assert coface.cubical(masked, mask=inside) == coface.cubical(values, mask=inside & (values != 0))
    with pytest.raises(coface.Error):
        coface.cubical(masked, mask=np.ones((2, 2), bool))
