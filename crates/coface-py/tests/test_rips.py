"""Diagrams of points and distances."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from scipy.sparse import coo_array

import coface

ANGLES = np.arange(20) * (2 * np.pi / 20)
CIRCLE = np.column_stack([np.cos(ANGLES), np.sin(ANGLES)])
DISTANCES = np.sqrt(((CIRCLE[:, None] - CIRCLE[None]) ** 2).sum(axis=2))


def test_a_circle() -> None:
    found = coface.rips(CIRCLE, dimension=2)
    ((birth, death),) = found.diagram(1)
    assert birth == pytest.approx(2 * np.sin(np.pi / 20))
    # The first triangle with the middle inside has corners 7, 7 and 6 steps apart.
    assert death == pytest.approx(2 * np.sin(7 * np.pi / 20))
    assert len(found.diagram(0)) == 20
    assert found.threshold == pytest.approx(2)
    ((edge, triangle),) = found.simplices(1)
    assert DISTANCES[edge[0], edge[1]] == pytest.approx(birth)
    assert triangle is not None and len(triangle) == 3
    assert [len(found.longer_than(0.5).diagram(degree)) for degree in (0, 1)] == [1, 1]
    assert found.to_gudhi()[0] == (0, (0.0, np.inf))
    assert b"persistence intervals in dim 1" in found.to_bytes("ripser")
    assert found.to_svg().startswith("<svg")


@pytest.mark.parametrize("coefficients", ["f2", 3])
def test_distances_of_all_forms(coefficients: str | int) -> None:
    plain = coface.rips(CIRCLE, coefficients=coefficients)
    lower = [row[:i].tolist() for i, row in enumerate(DISTANCES)]
    rows, columns = np.nonzero(np.tril(DISTANCES))
    sparse = coo_array((DISTANCES[rows, columns], (rows, columns)), shape=DISTANCES.shape)
    others = [
        coface.rips(DISTANCES, distances="square", coefficients=coefficients),
        coface.rips(lower[1:], distances="lower", coefficients=coefficients),
        coface.rips(sparse, coefficients=coefficients, threshold=plain.threshold),
        coface.rips(np.column_stack([rows, columns, DISTANCES[rows, columns]]), distances="sparse", coefficients=coefficients),
    ]
    for other in others:
        for degree in (0, 1):
            np.testing.assert_allclose(other.diagram(degree), plain.diagram(degree), atol=1e-12)
    again = pickle.loads(pickle.dumps(plain))
    np.testing.assert_array_equal(again.diagram(1), plain.diagram(1))


def test_a_table_that_looks_like_distances() -> None:
    line = np.abs(np.subtract.outer(np.arange(3.0), np.arange(3.0)))
    with pytest.warns(UserWarning, match='distances="points"'):
        found = coface.rips(line)
    np.testing.assert_array_equal(found.diagram(0), [[0, np.inf], [0, 1], [0, 1]])
    assert coface.rips(line, distances="points").diagram(0)[1, 1] == pytest.approx(np.sqrt(3))


def test_points_without_stored_distances() -> None:
    found = coface.rips(coo_array(([2.0], ([1], [0])), shape=(4, 4)))
    assert sorted(found.diagram(0)[:, 1]) == [2, np.inf, np.inf, np.inf]
    assert len(coface.rips(coo_array((3, 3))).diagram(0)) == 3


def test_wrong_tables() -> None:
    with pytest.raises(coface.InvalidInputError, match="distances=\"lower\""):
        coface.rips([[1.0], [2.0, 3.0]], distances="points")  # type: ignore[arg-type]
    with pytest.raises(coface.InvalidInputError, match="shape"):
        coface.rips(np.zeros(3))
    with pytest.raises(coface.Error, match="no form of distances"):
        coface.rips([[1.0]], distances="lowest")  # type: ignore[arg-type]
    with pytest.raises(coface.InvalidInputError, match="says 1"):
        coface.rips([[0, 1], [2, 0]], distances="square")
    with pytest.raises(coface.InvalidInputError, match="numbers"):
        coface.rips(CIRCLE).pairs(1)


@pytest.mark.parametrize("seed", range(20))
def test_rows_of_cycles_are_those_of_the_diagram_where_distances_tie(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = rng.integers(0, 5, (14, 2)).astype(float) if seed % 2 else rng.random((20, 2)).round(1)
    distances = np.sqrt(((points[:, None] - points[None]) ** 2).sum(-1))
    found = coface.rips(distances, distances="square")

    def diameter(chain: coface.Chain) -> float:
        return max(distances[i, j] for simplex in chain.simplices.tolist() for i in simplex for j in simplex)

    for degree in (0, 1):
        rows = found.cycles(degree)
        assert len(rows) == len(found.diagram(degree))
        for (birth, death), (maker, ender), (cycle, bounding, _) in zip(found.diagram(degree), found.simplices(degree), rows, strict=True):
            assert (bounding is None) == np.isinf(death) == (ender is None)
            assert diameter(cycle) == birth and maker in cycle.simplices.tolist()
            if bounding is not None:
                assert diameter(bounding) == death and ender in bounding.simplices.tolist()


def test_points_that_are_very_near_are_several() -> None:
    assert coface.rips([[0, 0], [3e-160, 4e-160]], dimension=0).diagram(0)[1] == pytest.approx([0, 5e-160], rel=1e-15)
    assert coface.rips([[0.0], [1e-200], [1.0]], dimension=0).diagram(0).tolist() == [[0, np.inf], [0, 1e-200], [0, 1]]
    corners = np.array([[0, 0], [6, 0], [6, 8], [0, 8]])
    for scale in (1e-200, 1e-100, 1e100, 1e200):
        assert coface.cech(corners * scale).diagram(1) == pytest.approx(np.array([[4, 5]]) * scale, rel=1e-14)
