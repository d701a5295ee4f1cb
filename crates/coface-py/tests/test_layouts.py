"""Canonical polygons drawn in the plane, and covers in the disk of Klein."""

import numpy as np
import pytest

import coface


def test_domains_are_regular_polygons():
    double = coface.generate("genus", genus=2)
    domain = coface.cut(double, layout="polygon")
    assert domain.layout["turned"] == 0 and domain.layout["plane"] == "polygon"
    points = domain.model.vertices
    assert np.hypot(points[:, 0], points[:, 1]).max() == pytest.approx(1)
    assert np.isclose(domain.model.report().area, 4 * np.sin(np.pi / 4))


def test_texture_coordinates_leave_the_mesh_where_it_is():
    double = coface.generate("genus", genus=2)
    domain = coface.cut(double, uv=True, weights="cotangent")
    data = {name: values for name, kind, values in domain.model.data if kind == "vertices"}
    texture = np.column_stack([data["s"], data["t"]])
    assert texture.min() >= 0 and texture.max() <= 1
    assert np.isclose(domain.model.report().area, double.report().area)
    assert domain.layout == {**domain.layout, "texture": True, "weights": "cotangent"}


def test_klein_is_hyperbolic():
    double = coface.generate("genus", genus=2)
    assert coface.cut(double, layout="klein").layout["turned"] == 0
    disk, klein = (coface.cover(double, radius=1, layout=layout).model.vertices for layout in ("disk", "klein"))
    near, far = (np.hypot(points[:, 0], points[:, 1]) for points in (disk, klein))
    assert np.allclose(2 * near / (1 + near**2), far)


@pytest.mark.parametrize(
    ("wrong", "cure"),
    [
        ({"layout": "circle"}, 'give "polygon" or "klein"'),
        ({"layout": "polygon", "weights": "mean"}, 'give "uniform" or "cotangent"'),
        ({"layout": "klein"}, "take the layout polygon"),
    ],
)
def test_wrong_layouts_are_refused(wrong, cure):
    with pytest.raises(coface.Error, match=cure):
        coface.cut(coface.generate("torus"), **wrong)
