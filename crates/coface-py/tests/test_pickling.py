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
