"""Euler characteristic curves and transforms, and cycles of images."""

from __future__ import annotations

from pathlib import Path

import coface
import numpy as np
import pytest


@pytest.mark.parametrize("construction", ["t", "v"])
@pytest.mark.parametrize("superlevel", [False, True])
def test_curves_of_images_are_those_of_their_diagrams(construction: str, superlevel: bool) -> None:
    image = np.random.default_rng(1).integers(0, 9, (5, 4, 3)).astype(float)
    mask = np.random.default_rng(2).random(image.shape) < 0.8
    at = np.linspace(-1.0, 9.0, 41)
    options = {"construction": construction, "superlevel": superlevel, "mask": mask}
    values, numbers = coface.euler_curve(image, at=at, **options)
    assert np.array_equal(values, at)
    assert np.array_equal(numbers, coface.cubical(image, **options).euler_curve(at=at)[1])


def test_curves_of_models_are_those_of_their_diagrams() -> None:
    torus = coface.generate("torus")
    at = np.linspace(-2.0, 2.0, 33)
    for axis in "xyz":
        expected = coface.persistence(torus, axis).euler_curve(at=at)[1]
        assert np.array_equal(coface.euler_curve(torus, axis, at=at)[1], expected)


def test_transforms_have_a_row_for_each_direction() -> None:
    torus = coface.generate("torus")
    directions, heights, numbers = coface.euler_transform(torus, 12, at=9, normalize=True)
    assert directions.shape == (12, 3) and np.allclose(np.linalg.norm(directions, axis=1), 1.0)
    assert np.array_equal(heights, np.linspace(-1.0, 1.0, 9))
    assert numbers.shape == (12, 9) and not numbers[:, -1].any()
    again = coface.euler_transform(torus, 3.0 * directions, at=heights, normalize=True)
    assert np.array_equal(again[2], numbers)
    smooth = coface.euler_transform(torus, 12, at=9, normalize=True, smooth=True)[2]
    assert not smooth[:, [0, -1]].any() and smooth.any()


def test_what_cannot_be_is_refused() -> None:
    torus = coface.generate("torus")
    for wrong in (
        lambda: coface.euler_curve(torus),
        lambda: coface.euler_curve(torus, "z", superlevel=True),
        lambda: coface.euler_transform([[0, 1]]),
        lambda: coface.euler_transform(torus, 0),
        lambda: coface.euler_transform(torus, [[0.0, 0.0, 0.0]]),
        lambda: coface.euler_transform(torus, np.zeros((0, 3))),
        lambda: coface.euler_transform(torus, [[1.0, 0.0]]),
    ):
        with pytest.raises(coface.Error):
            wrong()
    values, numbers = coface.euler_curve(np.zeros((0, 3)))
    assert values.size == numbers.size == 0


def test_classes_of_images_have_cycles() -> None:
    grid = np.linspace(-1.0, 1.0, 15)
    x, y, z = np.meshgrid(grid, grid, grid, indexing="ij")
    ring = np.hypot(np.hypot(x, y) - 0.6, z)
    for construction in ("t", "v"):
        found = coface.cubical(ring, construction=construction, cycles=True, least=0.1)
        ((cycle, filling, cocycle),) = found.cycles(1)
        _, times = np.unique(np.asarray(cycle.simplices), return_counts=True)
        assert not (times % 2).any()
        # Squares have their corners around them.
        squares = np.asarray(filling.simplices)
        sides = np.sort(np.stack([squares, np.roll(squares, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
        edges, times = np.unique(sides, axis=0, return_counts=True)
        assert np.array_equal(edges[times % 2 == 1], np.unique(np.sort(np.asarray(cycle.simplices), axis=1), axis=0))
        assert len(cocycle.cells)
    with pytest.raises(coface.InvalidInputError, match="cycles=True"):
        coface.cubical(ring).cycles(1)


def test_extended_and_zigzag_persistence_are_proved(tmp_path: Path) -> None:
    surface, steps = tmp_path / "torus.off", tmp_path / "steps.txt"
    coface.generate("torus").write(surface)
    proof = coface.certificate(surface, "persistence", extended=True, function="x", coefficients="f3")
    assert coface.check(proof, surface)["proved"][0] == "the values of the vertices are x"
    steps.write_text("i 0\ni 1\ni 0 1\nd 0 1\n")
    assert not coface.check(coface.certificate(steps, "persistence", zigzag=True), steps)["unchecked"]
    with pytest.raises(coface.InvalidInputError, match="lies|steps"):
        coface.certificate(steps, "persistence", zigzag=True, extended=True)
