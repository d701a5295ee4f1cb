"""Several models in one view: names, colors, and answers about each."""

from __future__ import annotations

import json
import re
from typing import Any

import numpy as np
import pytest

import coface
from coface._scenes import rgb


def scene(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.S)
    assert found is not None
    made: dict[str, Any] = json.loads(found.group(1))
    return made


def layers(page: str) -> dict[str, dict[str, Any]]:
    return {layer["name"]: layer for layer in scene(page)["layers"]}


def placed(shift: float) -> coface.Model:
    torus = coface.generate("torus", columns=6, rows=5)
    return coface.Model(torus.vertices + [shift, 0, 0], torus.faces)


def test_each_model_is_a_layer_with_its_name_and_color(tmp_path) -> None:
    sphere = coface.generate("sphere", subdivisions=1)
    found = layers(coface.page({"ring": placed(0), "ball": sphere}, colors={"ring": "#ff8000"}, report=False))
    assert list(found) == ["ring", "ball"]
    assert found["ring"]["color"] == 0x1FF8000 and found["ball"]["color"] == 0x10072B2
    # What has no color gets one that the others have not.
    blue = layers(coface.page({"ring": placed(0), "ball": sphere}, colors={"ring": "blue"}, report=False))
    assert (blue["ring"]["color"], blue["ball"]["color"]) == (0x10072B2, 0x1D55E00)
    plain = layers(coface.page([placed(0), sphere], report=False))
    assert [layer.get("color") for layer in plain.values()] == [None, None]
    assert found["ring"]["detail"] == "30 vertices" and all(layer["group"] == "models" for layer in found.values())
    assert list(layers(coface.page([placed(0), sphere], report=False))) == ["model 1", "model 2"]
    path = coface.view([placed(0), placed(9)], tmp_path / "two.html", colors=["red", None])
    assert "homology" in path.read_text(encoding="utf-8")


def test_stills_have_the_colors() -> None:
    picture = coface.render([placed(0), placed(9)], colors=[(1.0, 0.0, 0.0), "blue"], size=(200, 120)).decode()
    fills = {tuple(int(text[i : i + 2], 16) for i in (0, 2, 4)) for text in re.findall(r'fill="#([0-9a-f]{6})"', picture)}
    reds = [fill for fill in fills if fill[0] > 60 and fill[1] == fill[2] == 0]
    blues = [fill for fill in fills if fill[2] > 1.4 * fill[1] > 0 == fill[0]]
    assert reds and blues


def test_answers_follow_their_model() -> None:
    first, second = placed(0), placed(9)
    groups = [coface.homology(model, generators=True) for model in (first, second)]
    both = layers(coface.page([first, groups[0], second, groups[1]], report=False))
    again = layers(coface.page({"a": [first, groups[0]], "b": [second, groups[1]]}, report=False))
    assert len(scene(coface.page([first, *groups, second], report=False))["layers"]) == 2 + 2 * 4
    for found in (both, again):
        assert {"H1 generator 1", "H1 generator 2"} <= set(found)
    # The lines of the second one run through vertices of the second model.
    named = [layer for layer in scene(coface.page([first, second, groups[1]], report=False))["layers"] if layer["name"] == "H1 generator 1"]
    alone = [layer for layer in scene(coface.page([second, groups[1]], report=False))["layers"] if layer["name"] == "H1 generator 1"]
    assert len(named) == 1 and named[0]["detail"] == alone[0]["detail"]
    assert coface.render([first, second, groups[1]]) != coface.render([first, groups[0], second])


@pytest.mark.parametrize("ask", [coface.pi1, coface.cocycles, coface.cut, coface.harmonic, lambda model: coface.homology(model, generators=True)])
def test_all_answers_over_the_second_model(ask) -> None:
    first, second = placed(0), placed(9)
    assert len(coface.render([first, second, ask(second)])) > len(coface.render([first, second]))


def test_models_of_all_kinds_stand_together() -> None:
    flat = coface.polygon([[0, 0], [1, 0], [1, 1]])
    solid = coface.generate("box")
    voxels = coface.volume(np.ones((2, 2, 2), bool))
    abstract = coface.generate("rp2")
    found = layers(coface.page({"flat": flat, "solid": solid, "voxels": voxels, "abstract": abstract, "points": np.zeros((1, 3)).tolist() and coface.Model(np.ones((2, 3)))}, report=False))
    assert list(found) == ["flat", "solid", "voxels", "abstract", "points"]
    # Two drawings are a drawing.
    assert scene(coface.page([flat, flat], report=False))["dimension"] == 2


def test_models_of_other_libraries_stand_together() -> None:
    trimesh = pytest.importorskip("trimesh")
    boxes = [trimesh.creation.box(), trimesh.creation.box().apply_translation([3, 0, 0])]
    assert list(layers(coface.page(boxes, report=False))) == ["model 1", "model 2"]
    assert list(layers(coface.page(dict(zip("ab", boxes)), report=False))) == ["a", "b"]


def test_what_cannot_be_is_refused() -> None:
    first, second = placed(0), placed(9)
    with pytest.raises(coface.InvalidInputError, match="about none of the models"):
        coface.page([first, second], coface.homology(coface.generate("klein"), generators=True))
    with pytest.raises(coface.InvalidInputError, match="no model is called so"):
        coface.page({"a": first, "b": second}, colors={"c": "red"})
    with pytest.raises(coface.InvalidInputError, match="there are 2 models"):
        coface.page([first, second], colors=["red"])
    with pytest.raises(coface.InvalidInputError, match="there is one"):
        coface.page(first, colors=["red"])
    with pytest.raises(coface.InvalidInputError, match="one model alone"):
        coface.page([first, second, {"measures": [1.0], "inside": [[0]], "model": 1}], report=False)
    for color in ("crimson!", (2, 0, 0), 3, "#12"):
        with pytest.raises(coface.InvalidInputError, match="is no color"):
            rgb(color)


def test_scenes_are_plotted_and_in_widgets() -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    axes = coface.plot([placed(0), placed(9)])
    low, high = axes.get_xlim()
    assert low < 0 < 9 < high
    pyplot.close("all")
