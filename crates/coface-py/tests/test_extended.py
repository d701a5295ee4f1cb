"""Extended persistence."""

from __future__ import annotations

import numpy as np

import coface


def test_a_circle() -> None:
    found = coface.extended_persistence([[0, 1], [1, 2], [2, 3], [3, 0]], [0.0, 2.0, 1.0, 3.0])
    assert found == {
        "ordinary": [(0, (1.0, 2.0))],
        "relative": [(1, (2.0, 1.0))],
        "extended+": [(0, (0.0, 3.0))],
        "extended-": [(1, (3.0, 0.0))],
    }


def test_extended_classes_are_those_of_the_whole() -> None:
    sphere = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3], [3, 4]]
    values = np.random.default_rng(7).random(5)
    found = coface.extended_persistence(sphere, values)
    betti = coface.homology(sphere).betti_numbers
    for degree, number in enumerate(betti):
        kinds = found["extended+"] + found["extended-"]
        assert sum(1 for class_degree, _ in kinds if class_degree == degree) == number
