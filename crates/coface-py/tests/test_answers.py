"""Answers as dictionaries: made of typed answers, without JSON between."""

import json

import coface
import numpy as np
import pytest


def _square(corner: float) -> coface.Model:
    points = [[corner, corner], [corner + 2, corner], [corner + 2, corner + 2], [corner, corner + 2]]
    return coface.Model.from_arrays(points, cells={"polyline": [[0, 1, 2, 3, 0]]})


def _answers() -> dict[str, object]:
    squares = [_square(0), _square(1)]
    cubes = [coface.generate("box", boundary=True), coface.generate("box", boundary=True)]
    torus = coface.generate("torus", columns=5, rows=4).surface()
    sets = [coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]]) for _ in range(2)]
    return {
        "PlanarArrangement": coface.arrange(squares),
        "PlanarBoolean": coface.boolean("union", squares),
        "SpatialArrangement": coface.arrange(cubes),
        "SolidBoolean": coface.boolean("union", cubes),
        "Congruence": coface.congruence(squares, tolerance=0.01),
        "Domain": torus.cut(),
        "Cover": torus.cover(copies=3),
        "Cocycles": torus.cocycles(harmonic=True),
        "YinSet": sets[0] & ~sets[1],
    }


@pytest.mark.parametrize("name", sorted(_answers()))
def test_dictionaries_are_json_and_properties_are_their_values(name: str) -> None:
    answer = _answers()[name]
    assert type(answer).__name__ == name
    facts = answer.to_dict()  # type: ignore[attr-defined]
    assert facts == json.loads(json.dumps(facts, allow_nan=False))
    assert list(facts) == sorted(facts)
    # Some words are properties that are more than the facts: objects with arrays.
    more = {"kinks", "curves", "area", "order", "cocycles", "harmonic", "remarks", "name"}
    more |= {"polygons", "cells"}
    shared = [key for key in facts if hasattr(type(answer), key) and key not in more]
    shared = [key for key in shared if not isinstance(getattr(answer, key), np.ndarray)]
    # Functions that make the empty set and the plane.
    shared = [key for key in shared if not callable(getattr(answer, key))]
    assert len(shared) >= 4
    for key in shared:
        assert getattr(answer, key) == facts[key], key


def test_numbers_beyond_the_floating_point_are_none() -> None:
    outside = ~coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    assert outside.to_dict()["area"] is None
    assert isinstance(outside.to_dict()["curve_counts"][0], int)
    assert outside.to_dict()["bounded"] is False


def test_a_combination_has_its_provenance_and_a_set_has_none() -> None:
    square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    assert square.provenance is None
    assert list((square | ~square).provenance) == ["sources", "uncertified"]
