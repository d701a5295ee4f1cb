"""Directions of curves, kinks by places and names, and areas that are no numbers."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping

import numpy as np
import pytest

import coface


def _clockwise() -> list[coface.Curve]:
    return [coface.Curve.circle([0, 0], radius).reversed() for radius in (2, 1)]


def test_curves_of_any_direction() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ring = coface.YinSet(_clockwise(), orient=True)
    assert ring.area == pytest.approx(3 * math.pi, rel=1e-3)
    with pytest.warns(coface.AssumptionWarning, match="orient=True"):
        outside = coface.YinSet(_clockwise()[:1])
    assert math.isinf(outside.area)


def test_kinks_by_places_and_names(tmp_path) -> None:
    path = tmp_path / "leaf.json"
    path.write_text('{"order":4,"curves":[{"points":[[0,0],[4,0],[5,2],[4,4],[0,4]],"name":"rim"}]}')
    leaf = coface.YinSet.read(path)
    near, vertex = leaf.insert_kink_near([4.2, 0.1])
    named, _ = leaf.insert_kink("rim", 1)
    assert near == named
    assert near.kinks[vertex] == (0, 1)
    assert near.erase_kink_near(np.array([9.0, 9.0])) == (leaf, vertex)
    assert near.erase_kink(vertex) == (leaf, vertex)
    with pytest.raises(coface.InvalidInputError, match="no curve is named"):
        leaf.insert_kink("hole", 1)
    with pytest.raises(coface.InvalidInputError, match="no kinks"):
        leaf.erase_kink_near([0, 0])
    with pytest.raises(coface.InvalidInputError, match="not finite"):
        leaf.insert_kink_near([math.nan, 0])


def test_an_area_beyond_the_range_of_numbers() -> None:
    far = coface.YinSet.from_rings([[[0, 0], [1e300, 0], [1e300, 1e300], [0, 1e300]]])
    assert far.is_bounded
    with pytest.raises(coface.InvalidInputError, match="beyond the range"):
        _ = far.area


def test_kinks_are_a_mapping() -> None:
    square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]], order=4, kinks="all")
    kinks = square.kinks
    assert isinstance(kinks, Mapping)
    assert dict(kinks) == {0: (0, 0), 1: (0, 1), 2: (0, 2), 3: (0, 3)}
    assert list(kinks.keys()) == [0, 1, 2, 3] and (0, 2) in kinks.values() and (3, (0, 3)) in kinks.items()
    assert kinks.get(2) == (0, 2) and kinks.get(9) is None and kinks.get(9, (7, 7)) == (7, 7)
    assert "x" not in kinks
    with pytest.raises(KeyError):
        kinks[9]
