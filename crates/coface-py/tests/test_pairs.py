"""Persistence of a pair, and edge collapse."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from scipy.sparse import coo_array

import coface

TENT = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
HEIGHTS = [0.0, 1.0, 2.0, 3.0, 9.0]
RIM = [[0, 1], [1, 2], [2, 3], [0, 3]]


@pytest.mark.parametrize("x", [TENT, coface.Complex(TENT), coface.as_model(TENT)])
@pytest.mark.parametrize("part", ["boundary", RIM])
def test_a_tent_and_its_rim(x: object, part: object) -> None:
    relative = coface.persistence(x, HEIGHTS, relative=part)
    assert relative.diagram(2).tolist() == [[9.0, np.inf]]
    assert relative.betti_numbers == (0, 0, 1)
    ((cycle, bounding, _),) = relative.cycles(2)
    assert bounding is None
    assert sorted(map(sorted, cycle.simplices.tolist())) == sorted(map(sorted, TENT))
    image = coface.persistence(x, HEIGHTS, image_of=part)
    assert image.diagram(1).tolist() == [[3.0, 9.0]]
    assert image.diagram(0).tolist() == [[0.0, np.inf]]
    with pytest.raises(coface.InvalidInputError, match="no cycles of the image"):
        image.cycles(1)
    for found in (relative, image, relative.longer_than(1.0)):
        assert pickle.loads(pickle.dumps(found)).diagrams[1].tolist() == found.diagrams[1].tolist()


def test_relative_to_and_image_of() -> None:
    with pytest.raises(coface.InvalidInputError, match="not both"):
        coface.persistence(TENT, HEIGHTS, relative="boundary", image_of="boundary")
    falling = coface.persistence(TENT, HEIGHTS, relative="boundary", upper=True)
    assert falling.diagram(0).tolist() == [[9.0, 3.0]]
    by_cells = coface.persistence(TENT, cell_values=[HEIGHTS, [np.nan] * 8, [9.0] * 4], relative="boundary")
    assert by_cells.betti_numbers == (0, 0, 1)


@pytest.mark.parametrize("dimension", [1, 2])
def test_collapsed_edges_leave_diagrams(dimension: int) -> None:
    points = np.random.default_rng(5).random((40, 3))
    distances = np.sqrt(((points[:, None] - points[None]) ** 2).sum(axis=2))
    rows, columns = np.nonzero(np.tril(distances < 0.5) & (np.arange(40)[:, None] > np.arange(40)))
    sparse = coo_array((distances[rows, columns], (rows, columns)), shape=(40, 40))
    edges = np.column_stack([rows, columns, distances[rows, columns]])
    for plain, collapsed in (
        (coface.rips(points, dimension=dimension), coface.rips(points, dimension=dimension, collapse=True)),
        (coface.rips(sparse, dimension=dimension), coface.rips(sparse, dimension=dimension, collapse=True)),
        (coface.flag(edges, dimension=dimension), coface.flag(edges, dimension=dimension, collapse=True)),
    ):
        for degree in range(dimension + 1):
            assert sorted(plain.diagram(degree).tolist()) == sorted(collapsed.diagram(degree).tolist())
        assert plain.collapsed is None and collapsed.collapsed is not None
        before, after = collapsed.collapsed
        assert after < before
        with pytest.raises(coface.InvalidInputError, match="collapsed"):
            collapsed.cycles(1)
    with pytest.raises(coface.InvalidInputError, match="directions"):
        coface.flag(edges, directed=True, collapse=True)
