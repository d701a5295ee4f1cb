"""Answers keep what they were made of: a caller who changes its arrays and lists later changes no answer, and equal answers are equal however they were asked for."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import coface

POINTS = np.random.default_rng(0).random((12, 2))
SQUARE = np.sqrt(((POINTS[:, None] - POINTS[None]) ** 2).sum(-1))
LOWER = np.concatenate([SQUARE[i, :i] for i in range(12)])


def torus() -> coface.Model:
    return coface.generate("torus", columns=5, rows=4)


def region() -> coface.YinSet:
    return coface.YinSet.from_model(coface.polygon([[0, 0], [1, 0], [1, 1], [0, 1]]))


def loop() -> Any:
    generators = coface.homology(torus(), generators=True)[1].generators
    return generators[0].loop.copy()


def sparse() -> Any:
    from scipy.sparse import coo_array

    return coo_array(np.tril(SQUARE))


#: What is given, as something that can be changed, and what is asked of it.
CASES: dict[str, tuple[Callable[[], Any], Callable[[Any], Any]]] = {
    "cubical": (lambda: SQUARE.copy(), coface.cubical),
    "cubical float32": (lambda: SQUARE.astype(np.float32), coface.cubical),
    "cubical list": (lambda: SQUARE.tolist(), coface.cubical),
    "cubical mask": (lambda: np.ones((12, 12), bool), lambda mask: coface.cubical(SQUARE, mask=mask)),
    "cubical periodic": (lambda: [0], lambda axes: coface.cubical(SQUARE, periodic=axes)),
    "rips": (lambda: POINTS.copy(), coface.rips),
    "rips lower": (lambda: LOWER.copy(), lambda x: coface.rips(x, distances="lower")),
    "rips lower rows": (lambda: [SQUARE[i, :i].tolist() for i in range(1, 12)], lambda x: coface.rips(x, distances="lower")),
    "rips upper": (lambda: SQUARE[np.triu_indices(12, 1)], lambda x: coface.rips(x, distances="upper")),
    "rips sparse": (sparse, coface.rips),
    "alpha": (lambda: POINTS.copy(), coface.alpha),
    "alpha weights": (lambda: np.full(12, 0.01), lambda weights: coface.alpha(POINTS, weights)),
    "alpha periods": (lambda: np.array([2.0, 2.0]), lambda periods: coface.alpha(POINTS, periods=periods)),
    "alpha periods list": (lambda: [2.0, 2.0], lambda periods: coface.alpha(POINTS, periods=periods)),
    "cech": (lambda: POINTS.copy(), coface.cech),
    "witness": (lambda: POINTS.copy(), lambda points: coface.witness(points, 5)),
    "flag": (lambda: [[0, 1, 2.0], [1, 2, 3.0], [0, 2, 4.0]], lambda edges: coface.flag(edges, dimension=0)),
    "persistence": (lambda: np.arange(20.0), lambda values: coface.persistence(torus(), values)),
    "cell values": (lambda: [np.array([0.0, 1.0]), np.array([5.0])], lambda values: coface.persistence([[0, 1]], cell_values=values)),
    "cut": (loop, lambda along: coface.cut(torus(), along)),
    "cut cells": (lambda: [0.0, 0.0], lambda origin: region().cut_cells((4, 4), origin=origin, spacing=[0.3, 0.3])),
    "cut cells spacing": (lambda: np.array([0.3, 0.3]), lambda spacing: region().cut_cells((4, 4), origin=[0.0, 0.0], spacing=spacing)),
    "arrange": (lambda: [coface.generate("box", boundary=True)], coface.arrange),
    "boolean": (lambda: [coface.generate("box", boundary=True)], lambda models: coface.boolean("union", models)),
}


def change(given: Any) -> None:
    """Other numbers in the place of those that are there."""
    if hasattr(given, "tocoo"):
        given.data[:] = 7.0
    elif isinstance(given, np.ndarray):
        given[...] = given.reshape(-1)[::-1].reshape(given.shape) if given.dtype == bool else 3 * given.reshape(-1)[::-1].reshape(given.shape) + 1
        if given.dtype == bool:
            given[: len(given) // 2] = False
    elif given and isinstance(given[0], (list, np.ndarray)):
        for row in given:
            row[-1] = 11.0
    else:
        given.append(given[0])
        del given[0]
        if isinstance(given[0], float):
            given[0] += 0.25
        elif isinstance(given[0], int):
            given.append(1)


@pytest.mark.parametrize("name", CASES)
def test_later_changes_change_no_answer(name: str) -> None:
    make, ask = CASES[name]
    given = make()
    answer, fresh = ask(given), ask(make())
    change(given)
    for again in (answer, pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer), type(answer).from_dict(answer.to_dict())):
        assert again == fresh
    assert answer.to_dict() == fresh.to_dict()


def test_answers_are_equal_however_they_were_asked_for() -> None:
    assert coface.rips(POINTS, coefficients="f2") == coface.rips(POINTS, coefficients=2)
    assert coface.rips(POINTS) == coface.rips(POINTS, distances="points")
    assert coface.alpha(POINTS, periods=[2, 2]) == coface.alpha(POINTS, periods=(2.0, 2.0))
    assert coface.cover(torus(), radius=1) == coface.as_surface(torus()).cover(radius=1)
    assert coface.cocycles(torus()) == coface.as_surface(torus()).cocycles()
    with pytest.warns(coface.AssumptionWarning):
        assert coface.rips(SQUARE) == coface.rips(SQUARE, distances="square")


def test_answers_that_differ_are_not_equal() -> None:
    assert coface.rips(POINTS) != coface.rips(POINTS, coefficients=3)
    # The same births and deaths of other simplices.
    assert coface.rips([[0.0], [1.0], [3.0]], dimension=0) != coface.rips([[0.0], [2.0], [3.0]], dimension=0)
    assert coface.cubical([0.0, 5.0, 1.0]) != coface.cubical([1.0, 5.0, 0.0])
    assert coface.cover(torus(), radius=1) != coface.cover(torus(), radius=2)


def test_shorter_diagrams_can_be_written() -> None:
    for answer in (coface.rips(POINTS), coface.alpha(POINTS), coface.cubical(SQUARE), coface.persistence(torus(), np.random.default_rng(2).random(20))):
        lengths = sorted(death - birth for _, (birth, death) in answer.to_gudhi() if np.isfinite(death))
        shorter = answer.longer_than(lengths[0])
        assert 0 < len(shorter) < len(answer)
        assert pickle.loads(pickle.dumps(shorter)) == shorter
        assert coface.Persistence.from_dict(shorter.to_dict()) == shorter
        assert shorter.longer_than(lengths[0] / 2) == shorter
