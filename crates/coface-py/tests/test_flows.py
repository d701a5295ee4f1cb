"""Flows that are functions: of all points at once, or of one."""

from __future__ import annotations

import numpy as np
import pytest

import coface


def _disk() -> coface.YinSet:
    return coface.YinSet([coface.Curve.circle([0.5, 0.25], 0.25)])


def test_arrays_and_points_move_alike() -> None:
    calls = [0, 0]

    def together(p, t):
        calls[0] += 1
        return np.column_stack([-p[:, 1], p[:, 0]])

    def single(x, y, t):
        calls[1] += 1
        return (-y, x)

    moved, facts = _disk().advected(together, 1.0, step=0.1)
    again, _ = _disk().advected(single, 1.0, step=0.1)
    named, _ = _disk().advected("rotation", 1.0, step=0.1)
    assert moved == again
    assert moved.area == pytest.approx(named.area, rel=1e-12)
    assert facts["steps"] == 10
    assert calls[0] < calls[1] / 10


def test_the_function_may_have_more_arguments() -> None:
    shift = lambda p, t, by=2.0: np.full_like(p, by)  # noqa: E731
    moved, _ = _disk().advected(shift, 1.0, step=0.5)
    assert moved.bounding_box[0] == pytest.approx([2.25, 2.0])
    # Of any number of arguments: it is tried with points first.
    moved, _ = _disk().advected(lambda *given: (1.0, 0.0), 1.0, step=0.5)
    assert moved.bounding_box[0] == pytest.approx([1.25, 0.0])


def test_faults_are_raised() -> None:
    with pytest.raises(coface.InvalidInputError, match=r"shape \(3,\)"):
        _disk().advected(lambda p, t: p[:, 0], 1.0)
    with pytest.raises(ZeroDivisionError):
        _disk().advected(lambda p, t: p / (1 // 0), 1.0)
    with pytest.raises(ZeroDivisionError):
        _disk().advected(lambda x, y, t: (1 // 0, 0.0), 1.0)

    def late(p, t):
        if t > 0.5:
            raise KeyError("late")
        return np.zeros_like(p)

    with pytest.raises(KeyError, match="late"):
        _disk().advected(late, 1.0)


def test_options_are_those_of_the_program() -> None:
    moved, _ = _disk().advected("rotation", 1.0, step=0.1, scheme="cooper-verner", least_ratio=0.2, turn=20.0)
    assert moved.area == pytest.approx(_disk().area, rel=1e-9)
    with pytest.raises(coface.InvalidInputError, match="scheme"):
        _disk().advected("rotation", scheme="euler")


def test_events_are_listed() -> None:
    disks = coface.YinSet([coface.Curve.circle([x, 0], 1) for x in (-1.25, 1.25)])
    squeeze = {"step": 0.1, "contact_distance": 0.1}
    merged, facts = disks.advected("-x; 0", 2.0, on_contact="merge", event_tolerance=1e-6, **squeeze)
    (event,) = facts["events"]
    assert event["kind"] == "components-merge"
    assert event["time"] == pytest.approx(np.log(5), abs=1e-3)
    assert (event["before"], event["after"]) == ({"components": 2, "holes": 0}, {"components": 1, "holes": 0})
    assert merged.betti_open == [1, 0]
    with pytest.warns(coface.AssumptionWarning, match="came into contact at 1 place"):
        kept, facts = disks.advected("-x; 0", 2.0, on_contact="keep", **squeeze)
    assert [event["kind"] for event in facts["events"]] == ["contact"] and kept.betti_open == [2, 0]
    _, facts = disks.advected("-y; x", 1.0, step=0.1, events=True)
    assert facts["events"] == []
    _, facts = disks.advected("-y; x", 1.0, step=0.1)
    assert facts["events"] is None
    with pytest.raises(coface.InvalidInputError, match="on_contact"):
        disks.advected("-x; 0", on_contact="join")
    with pytest.raises(coface.InvalidInputError, match="contact distance"):
        disks.advected("-x; 0", on_contact="merge", contact_distance=-1)
