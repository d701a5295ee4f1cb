"""Vineyards."""

from __future__ import annotations

import numpy as np
import pytest

import coface


@pytest.mark.parametrize("prime", [2, 3])
def test_vines_pass_the_diagrams_of_the_functions(prime: int) -> None:
    rng = np.random.default_rng(11)
    sphere = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3], [3, 4], [4, 5], [5, 3]]
    functions = rng.random((4, 6))
    vines = coface.vineyard(sphere, functions, coefficients=prime)
    for place, function in enumerate(functions):
        found = sorted((degree, *point[1:]) for degree, points in vines for point in points.tolist() if point[0] == place and point[1] < point[2])
        expected = sorted((degree, birth, death) for degree, (birth, death) in coface.persistence(sphere, function, coefficients=prime).to_gudhi())
        assert found == expected
    assert all(np.all(np.diff(points[:, 0]) > 0) for _, points in vines)


def test_wrong_functions() -> None:
    assert coface.vineyard([[0, 1]], [[0.0, 1.0]], least=2.0)[0][0] == 0
    with pytest.raises(coface.InvalidInputError, match="no function"):
        coface.vineyard([[0, 1]], [])
    with pytest.raises(coface.Error):
        coface.vineyard([[0, 1]], [[0.0]])
