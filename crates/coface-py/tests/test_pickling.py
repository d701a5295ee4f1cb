"""What is pickled comes back the same, so that several processes can work."""

from __future__ import annotations

import copy
import pickle

import pytest

import coface


def things(spot, torus):
    yield coface.read(spot)
    yield coface.as_model([[0, 1, 2], [2, 3]])
    yield coface.as_complex(torus)
    yield coface.as_chain_complex(torus)
    yield coface.Model.from_arrays([[0, 0], [1, 0], [1, 1]], cells={"line": [[0, 1], [1, 2]]}).with_data("x", [1, 2, 3])


@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_pickles_come_back(protocol, spot, torus) -> None:
    for thing in things(spot, torus):
        again = pickle.loads(pickle.dumps(thing, protocol))
        assert type(again) is type(thing)
        assert again == thing
        assert str(coface.homology(again)) == str(coface.homology(thing))


def test_copies_are_equal(spot, torus) -> None:
    for thing in things(spot, torus):
        assert copy.copy(thing) == thing
        assert copy.deepcopy(thing) == thing


def test_grids_come_back() -> None:
    for grid in (coface.CuboidGrid([2, 3]), coface.CuboidGrid([1, 2, 2]), coface.SimplicialGrid([2, 3])):
        again = pickle.loads(pickle.dumps(grid))
        assert type(again) is type(grid)
        assert repr(again) == repr(grid)
        assert again.vertices.tolist() == grid.vertices.tolist()
        assert again.model() == grid.model()
        assert copy.deepcopy(grid).model() == grid.model()


@pytest.mark.parametrize("lengths", [[[0.5, 2.0], [1.0]], [[1.0, -1.0, 1.0]]])
def test_grids_with_lengths_come_back(lengths) -> None:
    grid = coface.CuboidGrid(lengths=lengths)
    again = pickle.loads(pickle.dumps(grid))
    assert again == grid and again.model() == grid.model() and again.vertices.tolist() == grid.vertices.tolist()
    assert grid != coface.CuboidGrid([len(axis) for axis in lengths])


def test_grids_whose_lengths_cannot_be_told_are_refused() -> None:
    # Of two gaps in a row nobody sees where they meet.
    grid = coface.CuboidGrid(lengths=[[1.0, -1.0, -2.0, 1.0]])
    try:
        assert pickle.loads(pickle.dumps(grid)) == grid
    except coface.InvalidInputError as error:
        assert "grid.model()" in (error.cure or "")
    assert pickle.loads(pickle.dumps(grid.model())) == grid.model()


def test_incidences_come_back() -> None:
    square = coface.LarModel([[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]], [[0, 1, 2], [0, 2, 3]]])
    lone = coface.LarModel([[[0, 1]]], 4)
    mixed = coface.LarModel([[[0, 1], [1, 2], [2, 0], [2, 3], [3, 4], [4, 0]], [[0, 1, 2], [0, 2, 3, 4]]])
    for model in (square, lone, mixed, square * lone):
        again = pickle.loads(pickle.dumps(model))
        assert again.f_vector == model.f_vector
        for degree in range(1, len(model.f_vector)):
            assert (again.characteristic(degree) != model.characteristic(degree)).nnz == 0
