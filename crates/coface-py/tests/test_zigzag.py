"""Zigzag persistence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import coface


def test_the_example_of_dionysus() -> None:
    simplices = [[0], [1], [0, 1], [2], [0, 2], [1, 2]]
    times = [[0.4, 0.6, 0.7], [0.1], [0.9], [0.9], [0.9], [0.9]]
    found = coface.zigzag(simplices, times)
    assert found["closed-open"] == [(0, (0.1, np.inf)), (0, (0.7, 0.9)), (1, (0.9, np.inf))]
    assert found["closed-closed"] == [(0, (0.4, 0.6))]
    assert found["open-closed"] == found["open-open"] == []


def test_files_and_steps(tmp_path: Path) -> None:
    place = tmp_path / "steps.txt"
    place.write_text("i 0\ni 1\ni 0 1\nd 0 1\ni 0 1\n")
    steps = [("i", [0]), ("i", [1]), ("i", (0, 1)), ("d", np.array([1, 0])), ("i", [0, 1])]
    assert coface.zigzag(place, coefficients=3) == coface.zigzag(str(place)) == coface.zigzag(steps)
    assert coface.zigzag(steps)["open-open"] == [(0, (4.0, 5.0))]
    assert coface.zigzag(steps, least=1.0)["open-open"] == []
    with pytest.raises(coface.InvalidInputError, match="the time at which it leaves"):
        coface.zigzag([(word, simplex, 2.0) for word, simplex in steps], least=-1.0)


def test_insertions_are_a_filtration() -> None:
    rng = np.random.default_rng(3)
    simplices = [[0], [1], [2], [3], [0, 1], [1, 2], [0, 2], [2, 3], [0, 1, 2]]
    times = np.sort(rng.random(len(simplices)))
    found = coface.zigzag(simplices, times[:, np.newaxis])
    by_values = coface.persistence(coface.Complex([[0, 1, 2], [2, 3]]), cell_values=[times[:4], times[[4, 6, 5, 7]], times[8:]])
    assert found["closed-open"] == [(degree, (birth, death)) for degree, (birth, death) in by_values.to_gudhi()]


def test_wrong_steps() -> None:
    with pytest.raises(coface.InvalidInputError, match="step 2: .* enters before its face"):
        coface.zigzag([("i", [0]), ("i", [0, 1])])
    with pytest.raises(coface.InvalidInputError, match="2 simplices and 1 lists"):
        coface.zigzag([[0], [1]], [[0]])
    with pytest.raises(coface.Error):
        coface.zigzag([("x", [0])])
    with pytest.raises(coface.Error):
        coface.zigzag("missing.txt")
