"""Interfaces: sets as phases that share the arcs between them."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import coface


def _square(x: float, y: float, side: float = 1.0) -> coface.YinSet:
    return coface.YinSet.from_rings([[[x, y], [x + side, y], [x + side, y + side], [x, y + side]]])


def test_named_sets_are_phases() -> None:
    found = coface.interface({"left": _square(0, 0), "right": _square(1, 0), "top": _square(0, 1, 2)})
    assert found.names == ["left", "right", "top"]
    assert found.areas == [1.0, 1.0, 4.0]
    assert found.neighbors == [(0, 1, 1.0), (0, 2, 1.0), (1, 2, 1.0)]
    assert sum(found.lengths) == pytest.approx(found.length) == pytest.approx(2 * 2 + 1 + 2 + 6)
    # Three meet below the top, two and the outside at its lower corners.
    assert sorted(junction["point"] for junction in found.junctions) == [[0.0, 1.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0]]
    assert len(found) == 3 and "3 phases" in repr(found)
    # The sets give the same interface again.
    again = coface.interface(dict(zip(found.names, found.sets())))
    assert (again.phases, again.edges, again.junctions) == (found.phases, found.edges, found.junctions)
    assert [region.area for region in again.sets()] == found.areas


def test_images_of_labels() -> None:
    labels = np.zeros((4, 5), np.uint16)
    labels[1:3, 1:3] = 7
    labels[1:3, 3] = 300
    found = coface.interface(labels)
    assert found.names == ["7", "300"] and found.areas == [4.0, 2.0]
    assert found.neighbors == [(0, 1, 2.0)]
    # Rows go from the top down: the phases lie one row above the lower edge.
    assert found.sets()[0].bounding_box == [[1.0, 1.0], [3.0, 3.0]]
    random = np.random.default_rng(5).integers(0, 4, (20, 30))
    found = coface.interface(random)
    assert found.areas == [float((random == int(name)).sum()) for name in found.names]
    sides = sum(int((a != b).sum()) for a, b in [(random[1:], random[:-1]), (random[:, 1:], random[:, :-1])])
    rim = sum(int((edge != 0).sum()) for edge in [random[0], random[-1], random[:, 0], random[:, -1]])
    assert found.length == pytest.approx(sides + rim)
    for wrong in (np.zeros((2, 2)), np.zeros(3, int), np.array([[-1, 2]])):
        with pytest.raises(coface.InvalidInputError, match="labels"):
            coface.interface(wrong)


def test_maps_have_a_phase_for_each_feature() -> None:
    def feature(name: str, x: float) -> dict:
        ring = [[x, 0], [x + 2, 0], [x + 2, 2], [x, 2], [x, 0]]
        return {"type": "Feature", "properties": {"name": name}, "geometry": {"type": "Polygon", "coordinates": [ring]}}

    text = json.dumps({"type": "FeatureCollection", "features": [feature("wood", 0), feature("field", 2)]})
    found = coface.interface(coface.Model.from_bytes(text.encode(), "geojson"))
    assert found.names == ["wood", "field"] and found.neighbors == [(0, 1, 2.0)]


def test_overlaps() -> None:
    sets = [_square(0, 0, 2), _square(1, 1, 2)]
    with pytest.raises(coface.InvalidInputError, match="overlap"):
        coface.interface(sets)
    assert coface.interface(sets, overlaps="first").areas == [4.0, 3.0]
    assert coface.interface(sets, overlaps="last").areas == [3.0, 4.0]
    with pytest.raises(coface.InvalidInputError, match="smooth"):
        coface.interface(sets, smooth=200)
    assert len(coface.as_model(coface.interface(sets, overlaps="first")).vertices) >= 8


def test_models_are_sets_too() -> None:
    left, right = (coface.polygon([[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]]) for x in (0, 1))
    rooms = coface.interface({"left": left, "right": right})
    assert rooms.neighbors == [(0, 1, 1.0)]
    with pytest.raises(coface.InvalidInputError, match='overlaps="first"'):
        coface.interface([left, left])


def test_interfaces_move() -> None:
    rooms = coface.interface({"left": _square(0, 0), "right": _square(1, 0), "top": _square(0, 1, 2)})
    moved, facts = rooms.advected("-y; x", np.pi / 2, step=0.05, spacing=0.5, scheme="verner")
    assert moved.names == rooms.names and facts["steps"] == 32
    assert moved.areas == pytest.approx(rooms.areas, abs=1e-6)
    assert len(moved.junctions) == len(rooms.junctions)
    assert sorted(junction["kind"] for junction in moved.junctions) == sorted(junction["kind"] for junction in rooms.junctions)
    # A quarter turn of the corner (1, 1).
    assert any(np.allclose(junction["point"], (-1, 1), atol=1e-6) for junction in moved.junctions)
    again, _ = rooms.advected(lambda p, t: np.column_stack([-p[:, 1], p[:, 0]]), np.pi / 2, step=0.05, spacing=0.5, scheme="verner")
    assert again.areas == pytest.approx(moved.areas, abs=1e-12)
    # Phases of what has moved give the same interface.
    same = coface.interface(dict(zip(moved.names, moved.sets())))
    assert same.areas == pytest.approx(moved.areas, abs=1e-12) and len(same.junctions) == len(moved.junctions)
    with pytest.raises(coface.InvalidInputError, match="flow"):
        rooms.advected("drift")


def test_files_places_phases_and_comparisons(tmp_path: Path) -> None:
    rooms = coface.interface({"left": _square(0, 0), "right": _square(1, 0), "top": _square(0, 1, 2)})
    path = tmp_path / "rooms.json"
    rooms.write(path)
    again = coface.Interface.read(path)
    assert (again.phases, again.edges, again.junctions) == (rooms.phases, rooms.edges, rooms.junctions)
    assert again.phase("top").area == 4.0 and again.phase(0).bounding_box == [[0.0, 0.0], [1.0, 1.0]]
    with pytest.raises(coface.InvalidInputError, match="no phase"):
        again.phase("attic")
    random = np.random.default_rng(3).uniform(-1, 4, (200, 2))
    phases, facts = again.locate(random)
    for number, region in enumerate(again.sets()):
        assert ((phases == number) == (region.locate(random) == 1)).all()
    assert facts["outside"] == int((phases == -1).sum()) and (phases != -2).all()
    assert again.locate([[1, 1]])[0].tolist() == [-2]
    assert again.compare(rooms)["area_xor"] == 0.0
    moved, _ = rooms.advected("translation", 1.0, velocity=(0.5, 0.0), spacing=3.0)
    assert rooms.compare(moved)["area_xor"] == pytest.approx(1 + 1 + 2)
    with pytest.raises(coface.UnsupportedFormatError, match="coface.Interface.read"):
        coface.YinSet.read(path)
    other = tmp_path / "other.json"
    other.write_text('{"curves": []}')
    with pytest.raises(coface.ParseError, match="no interface"):
        coface.Interface.read(other)


def test_events_have_times_and_phases() -> None:
    left, right = (coface.YinSet.from_rings([[[0.0, -0.5], [0.0, 0.5], [s * 2, 2], [s * 2, -2]][::-s]]) for s in (-1, 1))
    pair = coface.interface({"left": left, "right": right})
    _, facts = pair.advected(lambda p, t: np.column_stack([0 * p[:, 0], -p[:, 1]]), 4.0, spacing=0.5, events=True)
    events = facts["events"]
    assert [(event["kind"], event["phases"]) for event in events] == [("junctions-meet", [0, 1])]
    # The edge has the length exp(-t), and points are 0.05 apart at least.
    assert events[0]["time"] == pytest.approx(np.log(20), abs=1e-3) and events[0]["before"] is None
    assert pair.advected("translation", 1.0, spacing=3.0)[1]["events"] is None


def test_points_along_edges_bends_and_images() -> None:
    found = coface.interface({"left": _square(0, 0), "right": _square(1, 0)})
    samples = found.sample(count=4)
    assert samples["point"].shape == samples["tangent"].shape == (len(samples["edge"]), 2)
    # Each edge gives its end too, and the phases beside it.
    assert len(samples["edge"]) == 5 * len(found.edges)
    for number, edge in enumerate(found.edges):
        own = samples["edge"] == number
        left, right = (-1 if edge[side] is None else edge[side] for side in ("left", "right"))
        assert set(samples["left"][own]) == {left} and set(samples["right"][own]) == {right}
        assert samples["length"][own][-1] == pytest.approx(edge["length"])
    # Within the length of each edge, at distances that fit.
    fine = found.sample(spacing=0.1)
    steps = np.hypot(*np.diff(fine["point"], axis=0).T)[np.diff(fine["edge"]) == 0]
    assert steps.max() <= 0.1 + 1e-12
    assert len(found.sample()["edge"]) > len(found.edges)
    with pytest.raises(coface.Error, match="more than one way"):
        found.sample(count=4, spacing=0.1)
    bends = found.curvature()
    assert [bend["edge"] for bend in bends] == list(range(len(found.edges)))
    assert {abs(bend["sharpest"]["value"]) for bend in bends if bend["sharpest"]} == {90.0}
    image = found.transformed([[0, 2], [1, 0]], (5, -1))
    assert image.areas == [2.0, 2.0] and image.names == found.names
    expected = np.array(found.vertices) @ np.array([[0, 1], [2, 0]]) + [5, -1]
    assert np.array(image.vertices) == pytest.approx(expected)
    for matrix in ([[1, 2], [2, 4]], [[1, 0, 0], [0, 1, 0]], [1, 2]):
        with pytest.raises(coface.Error):
            found.transformed(matrix)


def test_points_along_a_boundary_bends_and_images() -> None:
    angles = np.arange(64) * 2 * np.pi / 64
    ring = [[3 + 2 * np.cos(angle), 2 * np.sin(angle)] for angle in angles]
    disk = coface.YinSet.from_rings([ring], order=4)
    samples = disk.sample(spacing=0.25)
    assert set(samples["curve"]) == {0}
    assert np.hypot(samples["point"][:, 0] - 3, samples["point"][:, 1]) == pytest.approx(2, abs=1e-5)
    assert samples["curvature"] == pytest.approx(0.5, abs=1e-2)
    assert np.hypot(*samples["tangent"].T) == pytest.approx(1)
    (bend,) = disk.curvature()
    assert 0.49 < bend["least"]["value"] <= bend["greatest"]["value"] < 0.51
    ellipse = disk.transformed([[2, 0], [0, 0.5]])
    assert ellipse.area == pytest.approx(disk.area)
    assert disk.transformed(np.eye(2), (1, 1)).area == pytest.approx(disk.area)
    (bend,) = ellipse.curvature()
    # Half axes 4 and 1.
    assert bend["greatest"]["value"] == pytest.approx(4, rel=1e-2)
    assert bend["least"]["value"] == pytest.approx(1 / 16, rel=1e-1)


def test_kept_parameters_are_nearer() -> None:
    angles = np.arange(80) * 2 * np.pi / 80
    ring = [[0.5 + 0.15 * np.cos(angle), 0.75 + 0.15 * np.sin(angle)] for angle in angles]
    disk = coface.YinSet.from_rings([ring], order=4)
    off = {}
    for parameters in ("lengths", "kept"):
        moved, _ = disk.advected("vortex", spacing=0.0125, step=0.02, parameters=parameters)
        off[parameters] = moved.compare(disk)["area_xor"]
    assert off["kept"] is not None and off["lengths"] is not None and 50 * off["kept"] < off["lengths"]
    with pytest.raises(coface.Error, match="parameters"):
        disk.advected("vortex", parameters="chords")


def test_unique_form_fit_kinks_and_cells() -> None:
    rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    unique = rooms.normalized()
    assert unique.areas == rooms.areas and unique.normalized() == unique
    smooth = rooms.fit(4, kinks=45.0)
    assert (smooth.order, smooth.areas, len(smooth.junctions)) == (4, rooms.areas, 2)
    assert all(isinstance(edge, int) and isinstance(knot, int) for edge, knot in smooth.kinks.values())
    cut, vertex = rooms.insert_kink_near([0, 2])
    assert list(cut.kinks) == [vertex]
    whole, gone = cut.erase_kink_near([0, 2])
    assert gone == vertex and whole.edges == rooms.edges
    assert len(rooms.reset_kinks("all").kinks) > len(rooms.reset_kinks("none").kinks) == 0
    with pytest.raises(coface.NotInComplexError, match="no kink"):
        rooms.erase_kink(99)
    with pytest.raises(coface.InvalidInputError, match="is a junction"):
        rooms.insert_kink(0, 0)
    cells = rooms.cut_cells((6, 4))
    assert [own.total_area for own in cells] == rooms.areas
    assert sum(own.areas for own in cells) == pytest.approx(np.full((4, 6), 0.25))


def test_contacts_of_phases() -> None:
    pair = coface.interface([coface.YinSet([coface.Curve.circle([x, 0], 1)]) for x in (-1.25, 1.25)])
    moved, facts = pair.advected("-x; 0", 2.0, step=0.1, on_contact="merge", contact_distance=0.25)
    assert facts["events"][0]["kind"] == "phases-meet" and facts["events"][0]["time"] == pytest.approx(np.log(2), abs=1e-3)
    assert len(moved.junctions) == 2 and moved.neighbors[0][:2] == (0, 1)
    with pytest.warns(coface.AssumptionWarning, match="came into contact"):
        kept, _ = pair.advected("-x; 0", 2.0, step=0.1, on_contact="keep", contact_distance=0.25)
    assert len(kept.junctions) == 0
    with pytest.warns(coface.AssumptionWarning, match="below the least distance of knots"):
        pair.advected("-x; 0", 0.1, on_contact="merge", contact_distance=1e-9)
