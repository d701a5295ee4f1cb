"""Handles of closed surfaces in space, and shortest paths in a limited time."""

from __future__ import annotations

import coface
import pytest


def test_handles_are_listed_and_filled() -> None:
    torus = coface.generate("torus", columns=16, rows=8)
    found = torus.handles()
    assert found["genus"] == 1
    (pair,) = found["handles"]
    assert pair["shorter"] == "handle"
    assert pair["length"] == pair["handle"]["length"] < pair["tunnel"]["length"]
    assert pair["tunnel"]["vertices"][0] == pair["tunnel"]["vertices"][-1]
    assert torus.handles(shorter_than=0.01)["handles"] == []
    sphere, done = torus.handles_filled()
    assert (done["before"]["genus"], done["after"]["genus"], done["left"]) == (1, 0, [])
    assert sphere.surface().genus == 0
    same, done = torus.handles_filled(shorter_than=0.01)
    assert done["before"] == done["after"]


def test_what_has_no_inside_is_refused() -> None:
    with pytest.raises(coface.NonManifoldError, match="repaired_surface"):
        coface.generate("cylinder").handles()
    with pytest.raises(coface.NonManifoldError, match="not orientable"):
        coface.generate("moebius").handles()
    with pytest.raises(coface.InvalidInputError):
        coface.generate("torus").handles(shorter_than=-1.0)


def test_a_search_that_is_stopped_has_a_bound() -> None:
    torus = coface.generate("torus", columns=24, rows=12).surface()
    (full,) = torus.shortest_cycles("non-contractible")
    length, vertices, bound = torus.shortest_cycle_within(3600.0)
    assert length == full[0] == bound
    assert vertices[0] == vertices[-1]
    length, _, bound = torus.shortest_cycle_within(0.0, "non-separating")
    assert bound <= full[0] <= length
    assert coface.generate("sphere").surface().shortest_cycle_within(1.0) is None
    with pytest.raises(coface.InvalidInputError):
        torus.shortest_cycle_within(-1.0)
