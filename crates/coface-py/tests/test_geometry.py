"""What reports say about faces in space."""

from __future__ import annotations

from pathlib import Path

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


def test_polygons_of_drawings_are_checked(tmp_path: Path) -> None:
    path = tmp_path / "bow.wkt"
    path.write_text("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")
    (problem,) = coface.read(path).report().problems
    assert (problem["kind"], problem["points"]) == ("ring_crosses_itself", [[1.0, 1.0]])
    polygons = coface.read(path).report().polygons
    assert (polygons["valid"], polygons["reason"]) == (False, "Self-intersection[1 1]")
    assert polygons["faults"][0]["name"] == "ring_crosses_itself"
    assert house(1.5).report().polygons is None


def test_results_in_the_plane_are_valid_unless_they_are_exact(tmp_path: Path) -> None:
    x, y = "-1120500.000000126", "-1120500.0000001257"
    rings = [
        f"{x} 850931.058865365,{y} 851343.3885007716,{y} 851342.2386007707,-1120399.762684411 851199.4941312922,{x} 850931.058865365",
        f"{x} 851253.4627870625,{y} 851299.8179383819,-1120492.1498410008 851293.8417889411,{x} 851253.4627870625",
    ]
    models = []
    for name, ring in zip("ab", rings, strict=True):
        path = tmp_path / f"{name}.wkt"
        path.write_text(f"POLYGON(({ring}))")
        models.append(coface.read(path))
    assert coface.boolean("union", models, exact=True).rounding["valid"] is False
    assert coface.boolean("union", models).rounding["valid"] is True
    on_grid = coface.boolean("union", models, grid=0.5)
    assert (on_grid.vertices % 0.5 == 0.0).all()
    with pytest.raises(coface.InvalidInputError):
        coface.boolean("union", house(1.5), grid=0.5)


def test_exact_results_are_input_again(tmp_path: Path) -> None:
    corners = [
        [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z + 0.1 * x] for z in (0, 1) for y in (0, 1) for x in (0, 1)
    ]
    sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    cube = coface.Model(corners, sides)
    shifted = [[9 * x - 4.5, 9 * y - 4.5, 4 * z + 0.37 * x - 0.21 * y + 0.4] for x, y, z in corners]
    knife = coface.Model(shifted, sides)
    below = coface.boolean("difference", [cube, knife], exact=True)
    above = coface.boolean("intersection", [cube, knife], exact=True)
    nothing = coface.boolean("a ^ (b | c)", [cube, below, above], exact=True)
    assert nothing.measure == 0 and list(nothing.f_vector) == [0, 0, 0]
    # Files keep the exact points, also of the surface as a mesh.
    for model in (below.cells, below.model):
        model.write(tmp_path / "below.json")
        read = coface.read(tmp_path / "below.json")
        assert list(coface.boolean("a ^ (b | c)", [cube, read, above]).f_vector) == [0, 0, 0]
    arranged = coface.arrange([cube, knife], exact=True)
    assert len(coface.arrange([arranged.model()], exact=True)) == len(arranged)
