"""Every answer is shown: in a page, as a still, as a plot, in a notebook; alone, or in a list with its model."""

from __future__ import annotations

import json
import re
import warnings
from typing import Any

import numpy as np
import pytest

import coface


def _answers() -> dict[str, Any]:
    torus = coface.generate("torus", columns=6, rows=5)
    found = coface.homology(torus, generators=True)
    heights = np.asarray(torus.vertices)[:, 2]
    cube = coface.generate("box", boundary=True)
    square = coface.polygon([[0, 0], [2, 0], [2, 2], [0, 2]])
    region = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    ball = np.ones((3, 3, 3), bool)
    ball[1, 1, 1] = False
    return {
        "homology": found,
        "cohomology": coface.cohomology(torus, generators=True),
        "group": found[1],
        "generator": found[1].generators[0],
        "chain": found[1].generators[0].chain,
        "pi1": coface.pi1(torus)[0],
        "cover": coface.cover(torus, radius=1),
        "cocycles": coface.cocycles(torus),
        "forms": torus.surface().cocycles(harmonic=True),
        "cut": coface.cut(torus),
        "path": coface.cut(torus, along=coface.cocycles(torus).loops[0]),
        "persistence": coface.persistence(torus, heights),
        "drawing": coface.arrange(square),
        "region": coface.boolean("union", square),
        "arrangement": coface.arrange(cube),
        "solid": coface.boolean("union", cube),
        "congruence": coface.congruence(cube, tolerance=0.1),
        "set": region,
        "curved set": coface.YinSet([coface.Curve.circle([0, 0], 1)]),
        "grid": region.cut_cells((4, 4)),
        "volume": coface.volume(ball),
        "image": coface.volume(np.ones((3, 2), bool)),
        "holes of a volume": coface.homology(coface.volume(ball), generators=True)[2],
        "star": coface.Complex([[0, 1, 2], [1, 2, 3]]).star([1]),
        "abstract": coface.homology(coface.generate("rp2"), generators=True),
        "abstract loops": coface.pi1(coface.generate("rp2"))[0],
    }


ANSWERS = _answers()


def layers(page: str) -> list[str]:
    found = re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.S)
    assert found is not None
    return [layer["name"] for layer in json.loads(found.group(1)).get("layers", [])]


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_answers_have_pages_and_stills(name: str, tmp_path) -> None:
    answer = ANSWERS[name]
    path = coface.view(answer, tmp_path / "answer.html", report=False)
    assert "<html" in path.read_text(encoding="utf-8")
    assert coface.render(answer).lstrip()[:4] == b"<svg"
    if name != "persistence":
        assert coface.render(answer, "png", size=(120, 90))[:4] == b"\x89PNG"


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_answers_are_plotted(name: str) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    axes = coface.plot(ANSWERS[name])
    assert len(axes.get_children()) > 5
    if hasattr(ANSWERS[name], "plot"):
        ANSWERS[name].plot(title="an answer")
    pyplot.close("all")


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_answers_show_themselves_in_notebooks(name: str) -> None:
    text = ANSWERS[name]._repr_html_()
    assert text.startswith("<div>") and len(text) <= 60_000
    assert "recipe" not in text and "<script" not in text


def test_answers_say_what_they_show() -> None:
    pages = {name: layers(coface.page(answer, report=False)) for name, answer in ANSWERS.items()}
    assert [name for name in pages["homology"] if name.startswith("H1")] == ["H1 generator 1", "H1 generator 2"]
    assert pages["cohomology"][1].startswith("H^1")
    assert pages["group"] == ["H1 generator 1", "H1 generator 2"] and pages["generator"] == ["H1 generator 1"]
    assert pages["pi1"] == ["loop 1", "loop 2"]
    assert {"cocycle 1", "cocycle 2", "loop 1", "loop 2"} <= set(pages["cocycles"])
    assert any("harmonic form 1" in name for name in pages["forms"])
    assert any(name.startswith("handle") for name in pages["cut"])
    assert pages["holes of a volume"] == ["H2 generator 1"]


def test_answers_stand_beside_their_model_in_a_list() -> None:
    torus = coface.generate("torus", columns=6, rows=5)
    answers = [torus, coface.homology(torus, generators=True), coface.pi1(torus), coface.harmonic(torus)]
    found = layers(coface.page(answers, report=False))
    assert {"H1 generator 1", "loop 1", "harmonic form 1, arrows"} <= set(found)
    assert found == layers(coface.page(torus, answers[1:], report=False))
    picture = coface.render(answers)
    assert picture == coface.render(torus, results=answers[1:]) != coface.render(torus)
    pytest.importorskip("matplotlib")
    assert len(coface.plot(answers).collections) > len(coface.plot(torus).collections)
    # Dictionaries of the program are answers too.
    assert layers(coface.page(torus, {"loops": [[0, 1, 0]]}, report=False)) == ["loop 1"]
    two = layers(coface.page([torus, coface.generate("klein"), coface.pi1(torus)], report=False))
    assert two == ["model 1", "model 2", "loop 1", "loop 2"]
    with pytest.raises(coface.InvalidInputError, match="each of 90 edges"):
        coface.page([torus, np.zeros((2, 7))])


def test_homology_without_generators_is_a_table() -> None:
    found = coface.homology(coface.generate("rp2"))
    assert "H<sub>1</sub> = \u2124/2" in coface.page(found)
    with pytest.raises(coface.InvalidInputError, match="generators=True"):
        coface.render(found)
    pytest.importorskip("matplotlib")
    assert [bar.get_height() for bar in coface.plot(found).patches] == [1, 0, 0]


def test_reports_and_groups_are_tables() -> None:
    text = coface.generate("rp2").report()._repr_html_()
    assert "<table>" in text and "euler_characteristic" in text
    group = coface.FundamentalGroup(2, [[1, 2, -1, -2]])._repr_html_()
    assert "a b a<sup>-1</sup> b<sup>-1</sup>" in group and "Z^2 = " in group
    assert coface.homology([[0, 1], [1, 2], [0, 2]], "f2")._repr_html_().count("\u2124/2") == 2
    bad = coface.Model.from_bytes(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").with_data("<b>", [1.0, 2.0, 3.0])
    assert "<b><" not in bad._repr_html_()


def test_sets_of_the_plane_are_models() -> None:
    ring = coface.YinSet.from_rings([[[0, 0], [3, 0], [3, 3], [0, 3]], [[1, 1], [1, 2], [2, 2], [2, 1]]])
    model = coface.as_model(ring)
    assert len(model.lines) == 2 and coface.boolean("union", model).measure == ring.area == 8.0
    curved = coface.as_model(coface.YinSet([coface.Curve.circle([0, 0], 1)]))
    assert abs(coface.boolean("union", curved).measure - np.pi) < 2e-3
    assert coface.as_model(coface.YinSet.empty()).vertex_count == 0
    with pytest.raises(coface.InvalidInputError, match="whole plane"):
        coface.as_model(coface.YinSet.plane())


def test_sets_go_to_shapely_and_back() -> None:
    shapely = pytest.importorskip("shapely")
    first = shapely.Polygon([(0, 0), (0, 3), (3, 3), (3, 0)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ring = coface.YinSet.from_shapely(first)
    assert ring.area == 8.0 and ring.betti_open == [1, 1]
    assert ring.to_shapely().equals(first)
    both = coface.YinSet.from_shapely([shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3.1, 1)])
    back = both.to_shapely()
    assert back.geom_type == "MultiPolygon" and sorted(part.area for part in back.geoms)[0] == 1.0
    disk = coface.YinSet([coface.Curve.circle([0, 0], 1)])
    with pytest.raises(coface.Error, match="flatten"):
        disk.to_shapely()
    assert abs(disk.to_shapely(flatten=1e-6).area - disk.area) < 1e-4
    spline = coface.YinSet.from_shapely(shapely.Point(0, 0).buffer(1), order=4)
    assert spline.order == 4 and abs(spline.area - np.pi) < 1e-3


def test_volumes_are_meshes(tmp_path) -> None:
    voxels = np.zeros((3, 4, 5), bool)
    voxels[1, 1:3, 2] = True
    volume = coface.volume(voxels)
    assert volume.vertices.shape == (volume.f_vector[0], 3)
    assert volume.vertices.min(axis=0).tolist() == [1, 1, 2]
    surface = volume.to_model(surface=True, spacing=(2.0, 1.0, 0.5), origin=(10.0, 0.0, 0.0))
    report = surface.report()
    assert (report.name, report.signed_volume) == ("sphere", 2.0)
    assert surface.vertices.min(axis=0).tolist() == [12.0, 1.0, 1.0]
    cells = volume.to_model(spacing=(2.0, 1.0, 0.5))
    assert list(cells.cells) == ["hexahedron"] and cells.f_vector == volume.f_vector
    assert cells.report().mass is None or cells.to_bytes("vtk")
    assert abs(cells.surface(boundary=True).model().report().signed_volume) == 2.0
    image = coface.volume(voxels[1]).to_model()
    assert image.report().area == 2.0 and image.f_vector == coface.volume(voxels[1]).f_vector
    volume.write(tmp_path / "volume.obj")
    assert coface.read(tmp_path / "volume.obj").report().name == "sphere"
    volume.write(tmp_path / "volume.npy")
    assert np.array_equal(np.load(tmp_path / "volume.npy").astype(bool), voxels)
    assert volume.to_bytes("stl")


def test_faces_are_cut_into_triangles() -> None:
    points = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [1, 0.5, 0], [0, 2, 0], [0, 0, 1]]
    model = coface.Model(points, [[0, 1, 2, 3, 4], [0, 1, 5]])
    model = model.with_data("number", [7, 8], "faces").with_group("first", [0], "faces")
    cut = model.triangulated()
    assert np.asarray(cut.faces).shape == (4, 3)
    assert abs(cut.report().area - model.report().area) < 1e-12
    assert cut.data[0][2].tolist() == [7, 7, 7, 8] and cut.groups[0][2].tolist() == [0, 1, 2]
    # Neighbors still agree, whichever way the faces run.
    for reverse in (1, -1):
        face = [0, 1, 2, 3, 4][::reverse]
        normal = coface.Model(points, [face]).triangulated()
        corners = np.asarray(normal.vertices)[np.asarray(normal.faces)]
        turns = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]
        assert (turns * reverse > 0).all()
    with pytest.raises(coface.InvalidInputError, match="face 0 crosses itself"):
        coface.Model([[0, 0], [2, 2], [2, 0], [0, 2]], [[0, 1, 2, 3]]).triangulated()


@pytest.mark.filterwarnings("ignore")
def test_diagrams_of_what_is_no_complex_are_shown(tmp_path: Any) -> None:
    points = np.random.default_rng(1).random((8, 2))
    answers = [coface.rips(points), coface.alpha(points), coface.cech(points), coface.witness(points, 4), coface.flag([[0, 1, 1.0]]), coface.cubical(points)]
    for answer in answers:
        text = coface.view(answer, tmp_path / "answer.html").read_text()
        assert "data:image/svg+xml" in text
        assert coface.render(answer).startswith(b"<svg")


def test_vertices_with_other_numbers_are_shown(tmp_path: Any) -> None:
    star = coface.as_complex(coface.generate("torus")).star([[0]])
    assert "simplices" in coface.view(star, tmp_path / "star.html").read_text()
    assert coface.render(star).startswith(b"<svg")
    far = coface.homology([[5, 6], [6, 7], [5, 7]], generators=True)
    assert "H1 generator 1" in coface.page(far)
