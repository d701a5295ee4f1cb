"""Memory does not grow with the number of calls."""

from __future__ import annotations

import gc
import itertools
import sys
from collections.abc import Callable

import numpy as np
import pytest

import coface

CALLS = 10_000
#: What the process may take more after the last call than after the first thousand. A leak of 400 bytes a call is more.
BOUND = 4 << 20


def resident() -> int:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


def growth(call: Callable[[], object]) -> int:
    for _ in range(1000):
        call()
    gc.collect()
    before = resident()
    for _ in range(CALLS):
        call()
    gc.collect()
    return resident() - before


FACETS = [[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3], [3, 4]]
VERTICES = np.random.default_rng(0).normal(size=(5, 3))


def ask_homology() -> object:
    return coface.Complex(FACETS).chain_complex().homology().betti_numbers


def make_models() -> object:
    model = coface.Model.from_arrays(VERTICES, [[0, 1, 2], [0, 2, 3]])
    return model.vertices.sum() + model.faces.sum()


def share_matrices() -> object:
    complex = coface.as_chain_complex(FACETS)
    return (complex.boundary(1) @ complex.boundary(2)).nnz


def raise_errors() -> object:
    try:
        return coface.Complex(FACETS).link([[0, 9]])
    except coface.Error as error:
        return error.cells


def in_turns() -> Callable[[], object]:
    calls = itertools.cycle([ask_homology, make_models, share_matrices, raise_errors])
    return lambda: next(calls)()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="resident memory is read from /proc")
def test_ten_thousand_calls_take_no_more_memory() -> None:
    grown = growth(in_turns())
    assert grown < BOUND, f"{grown / CALLS:.0f} bytes a call"
