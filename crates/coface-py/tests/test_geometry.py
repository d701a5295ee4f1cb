"""What reports say about faces in space."""

from __future__ import annotations

import pytest

import coface


def house(tip: float) -> coface.Model:
    """A cube with a roof whose tip is at this height."""
    corners = [[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)] + [[0.5, 0.5, tip]]
    sides = [[0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return coface.Model(corners, [*sides, [4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]])


def test_a_sound_solid_is_valid() -> None:
    geometry = house(1.5).report().geometry
    assert geometry["checked"] and geometry["sound_surface"] and geometry["valid_solid"]
    assert geometry["faults"] == []


def test_faces_that_cross_are_named() -> None:
    report = house(-0.5).report()
    (fault,) = report.geometry["faults"]
    assert (fault["code"], fault["name"], fault["of"], fault["count"]) == (306, "faces_cross", "surface", 4)
    assert all(place["faces"][0] == 0 for place in fault["places"])
    assert "4 pairs of faces cross (ISO 19107 code 306)" in report.warnings


def test_flatness_and_the_check_are_choices() -> None:
    model = house(1.5)
    assert model.report(check="topology").geometry["checked"] is False
    raised = coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 0.001], [0, 1, 0]], [[0, 1, 2, 3]])
    codes = [fault["code"] for fault in raised.report(check="geometry", flatness=1e-6).geometry["faults"]]
    assert codes == [203, 301]
    assert [fault["code"] for fault in raised.report().geometry["faults"]] == [301]
    with pytest.raises(coface.InvalidInputError):
        model.report(check="everything")
    with pytest.raises(coface.InvalidInputError):
        model.report(flatness=-1.0)
