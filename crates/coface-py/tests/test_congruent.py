"""The arrangement by congruence, and vertices that are merged."""

from __future__ import annotations

import numpy as np
import pytest

import coface


def _turned(model: coface.Model, angle: float) -> coface.Model:
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    return coface.Model(np.asarray(model.vertices) @ turn.T, model.faces)


def test_congruence_has_the_cells_of_the_exact_method() -> None:
    cube = coface.generate("box", boundary=True)
    models = [_turned(cube, 0.3), _turned(coface.Model(cube.vertices + 0.5, cube.faces), 0.3)]
    exact = coface.arrange(models, merge_coplanar=False)
    found = coface.arrange(models, method="congruence", tolerance=1e-9)
    assert found.f_vector == exact.f_vector and found.f_vector[3] == 3
    assert sorted(found.measures) == pytest.approx(sorted(exact.measures))
    assert sorted(found.inside) == sorted(exact.inside)
    assert exact.congruence is None and found.congruence["stacked_f_vector"][2] >= found.f_vector[2]
    assert list(found.chain_complex().f_vector) == found.f_vector
    assert f"{found.f_vector[2]} faces" in repr(found.model(triangles=False))
    assumed = coface.arrange(models, method="congruence")
    assert assumed.f_vector == found.f_vector and 0 < assumed.congruence["tolerance"] < 1e-8
    assert "tolerance-assumed" in [remark["code"] for remark in assumed.to_dict()["remarks"]]
    assert found.joined["classes"] == [] and found.congruence["glued_f_vector"][2] == 0
    areas = [sorted(edge.area for edge in arranged.graph().edges) for arranged in (found, exact)]
    assert areas[0] == pytest.approx(areas[1])
    # The exact cells of what is glued, with faces in one plane merged as they usually are.
    exact = coface.arrange(models, method="congruence", tolerance=1e-9, exact=True)
    assert exact.f_vector[3] == 3 and exact.congruence is not None


def test_drawings_that_meet_nearly_are_glued() -> None:
    ring = [[0, 1, 2, 3, 0]]
    a = coface.Model.from_arrays([[0, 0], [2, 0], [2, 2], [0, 2]], cells={"polyline": ring})
    b = coface.Model.from_arrays([[2.001, 0], [4, 0], [4, 2], [1.9995, 2]], cells={"polyline": ring})
    found = coface.arrange(a, b, method="congruence", tolerance=0.01)
    union = coface.boolean("union", a, b, method="congruence", tolerance=0.01)
    assert found.f_vector == [6, 7, 2] and found.joined["classes"] == [[1, 4], [2, 7]]
    assert found.congruence["stacked_f_vector"] == [24, 8] and found.congruence["collapsed"] == 0
    assert union.f_vector == [6, 6, 1] and union.measure == pytest.approx(8)
    assert coface.arrange(a, b).congruence is None
    apart = coface.boolean("union", a, b, method="congruence")
    assert "tolerance-assumed" in [remark["code"] for remark in apart.to_dict()["remarks"]]
    with pytest.raises(coface.InvalidInputError, match="smaller tolerance"):
        coface.arrange(a, method="congruence", tolerance=10.0)


def test_cracks_are_welded() -> None:
    cube = coface.generate("box", boundary=True)
    corners = np.vstack([cube.vertices, np.asarray(cube.vertices) + 1e-7])
    faces = np.array(cube.faces)
    faces[0] += 8
    cracked = coface.Model(corners, faces)
    with pytest.raises(coface.NotACycleError, match="weld=") as fault:
        coface.boolean("union", cracked)
    radius = float(str(fault.value).split("weld=")[1].split(")")[0])
    assert coface.boolean("union", cracked, weld=radius).measure == pytest.approx(1)
    assert coface.arrange(cracked, weld=radius).f_vector == [8, 12, 6, 1]
    welded = cracked.welded(1e-6)
    assert len(welded.vertices) == 8 and coface.boolean("union", welded).measure == pytest.approx(1)
    with pytest.raises(coface.InvalidInputError):
        cracked.welded(-1.0)


def test_solids_that_meet_nearly_are_glued() -> None:
    cube = coface.generate("box", boundary=True)
    beside = coface.Model(np.asarray(cube.vertices) + [1.0004, 0.0003, 0], cube.faces)
    union = coface.boolean("union", cube, beside, method="congruence", tolerance=0.01)
    assert union.solids == 1 and union.measure == pytest.approx(2, abs=0.01)
    assert union.congruence["collapsed"] == 0 and union.congruence["largest_class_diameter"] < 0.001
    assert list(union.cells.chain_complex().f_vector)[3] == 2
    assert coface.boolean("union", cube, beside).congruence is None
    snapped = coface.boolean("union", cube, beside, method="congruence", tolerance=0.01, snap=True)
    assert snapped.measure == pytest.approx(2, abs=0.01) and snapped.congruence is not None
    with pytest.raises(coface.InvalidInputError, match="smaller tolerance"):
        coface.boolean("union", cube, method="congruence", tolerance=10.0)
