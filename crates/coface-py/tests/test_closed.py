"""What one call gives, another one takes, and it means the same."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest

import coface


def box(low, high) -> coface.Model:
    """A box as a model of quadrangles, fronts outward."""
    corners = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return coface.Model(np.array(corners, dtype=float), squares)


def test_a_drilled_cube_is_a_solid_torus() -> None:
    cube, rod = box((0, 0, 0), (4, 4, 4)), box((1, 1, -1), (2, 2, 5))
    drilled = coface.boolean("difference", [cube, rod])
    assert list(drilled.cells.chain_complex().homology().betti_numbers[:2]) == [1, 1]
    again = coface.boolean("union", drilled.cells)
    assert again.measure == drilled.measure
    assert again.f_vector == drilled.f_vector


def test_an_arrangement_has_the_homology_of_its_union() -> None:
    cube, void = box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (2, 2, 2))
    nested = coface.arrange([cube, void])
    assert nested.f_vector == [16, 24, 12, 2]
    betti = nested.chain_complex().homology().betti_numbers
    assert (betti[0], sum(betti[1:])) == (1, 0)


def test_two_sets_are_compared() -> None:
    square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    shifted = coface.YinSet.from_rings([[[1, 0], [3, 0], [3, 2], [1, 2]]])
    far = square.compare(shifted)
    assert far["area_xor"] == pytest.approx(4.0)
    assert far["hausdorff"] == pytest.approx(1.0)
    same = square.compare(square)
    assert same["area_xor"] == 0.0


def test_a_gap_within_the_tolerance_closes() -> None:
    cube, beside = box((0, 0, 0), (1, 1, 1)), box((1.001, 0, 0), (2, 1, 1))
    apart = coface.arrange([cube, beside])
    assert (apart.f_vector, apart.joined) == ([16, 24, 12, 2], None)
    joined = coface.arrange([cube, beside], tolerance=0.01)
    assert joined.f_vector == [12, 20, 11, 2]
    assert joined.joined["largest_movement"] == pytest.approx(0.0005)
    union = coface.boolean("union", [cube, beside], tolerance=0.01)
    assert (union.solids, union.rounding["valid"]) == (1, True)


def test_results_are_valid_with_the_bits_of_an_stl_file(tmp_path) -> None:
    sphere = coface.generate("sphere")
    turned = sphere.vertices @ np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    moved = coface.Model(turned / 3 + 0.7, sphere.faces)
    for found in (
        coface.boolean("union", sphere, moved, precision="single"),
        coface.arrange(sphere, moved, precision="single"),
    ):
        vertices = coface.as_model(found).vertices
        np.testing.assert_array_equal(vertices, vertices.astype(np.float32))
    found = coface.boolean("union", sphere, moved, precision="single")
    path = tmp_path / "union.stl"
    coface.as_model(found).write(path)
    again = coface.boolean("union", path)
    assert again.measure == pytest.approx(found.measure, rel=1e-12)
    assert len(coface.as_model(again).faces) == len(coface.as_model(found).faces)
    with pytest.raises(coface.Error, match="give one of double, single"):
        coface.boolean("union", sphere, moved, precision="half")
    square = coface.polygon([[0, 0], [1, 0], [1, 1]])
    with pytest.raises(coface.Error, match="leave it out in the plane"):
        coface.boolean("union", square, square, precision="single")


def drawn(tmp_path, name: str, segments) -> coface.Model:
    """Segments as a model."""
    path = tmp_path / f"{name}.lines"
    path.write_text("".join(",".join(repr(float(x)) for x in segment) + "\n" for segment in segments))
    return coface.read(path)


def test_results_in_the_plane_keep_exact_points(tmp_path) -> None:
    """Three lines that nearly meet: the triangle between them has one place for all its corners."""
    three = drawn(tmp_path, "three", [(0, 0, 2, 2), (0, 2, 2, 0), (0, 1, 4, 1 + 2**-52)])
    cut = drawn(tmp_path, "cut", [(1, 0, 1 + 2**-52, 2)])
    once = coface.arrange([three, cut], exact=True)
    found = coface.arrange(three, exact=True)
    assert found.f_vector == [9, 9, 1]
    path = tmp_path / "found.json"
    found.write(path)
    model = found.model()
    again = pickle.loads(pickle.dumps(model))
    assert again == model
    remade = coface.PlanarArrangement.from_dict(json.loads(json.dumps(found.to_dict())))
    for step in (path, model, again, pickle.loads(pickle.dumps(found)).model(), remade.model()):
        assert coface.arrange([step, cut], exact=True).f_vector == once.f_vector
    assert coface.arrange(path, exact=True).to_bytes("json") == found.to_bytes("json")
    assert coface.arrange(found.model()).f_vector == [7, 6, 0]
    plain = coface.arrange(three)
    assert coface.arrange([plain.model(), cut], exact=True).f_vector != once.f_vector


def test_parts_in_the_plane_are_the_whole(tmp_path) -> None:
    path = tmp_path / "whole.wkt"
    path.write_text("POLYGON ((0.1 0.2, 3.3 1.1, 2.7 4.4, -1.3 3.1, 0.1 0.2))\n")
    whole = coface.read(path)
    path.write_text("POLYGON ((1 -1, 1.7 5.1, 7 5, 7 -1, 1 -1))\n")
    knife = coface.read(path)
    parts = [coface.boolean(operation, [whole, knife], exact=True).model() for operation in ("intersection", "difference")]
    assert all(pickle.loads(pickle.dumps(part)) == part for part in parts)
    joined = coface.boolean("union", parts, exact=True)
    assert joined.f_vector == [4, 4, 1]
    assert coface.boolean("xor", [joined.model(), whole]).f_vector == [0, 0, 0]
    # The faces of an arrangement are inside, their common sides bound nothing.
    faces = coface.arrange([whole, knife], exact=True).model()
    assert coface.boolean("xor", [faces, coface.boolean("union", [whole, knife], exact=True).model()]).f_vector == [0, 0, 0]


def test_pickles_keep_exact_solids() -> None:
    cube = box((0, 0, 0), (1, 1, 1))
    turned = coface.Model(cube.vertices @ np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.1, 0.0, 1.0]]) + 0.3, cube.faces)
    part = coface.boolean("difference", [cube, turned], exact=True).model
    again = pickle.loads(pickle.dumps(part))
    assert again == part
    rest = coface.boolean("intersection", [cube, turned], exact=True).model
    assert coface.boolean("xor", [coface.boolean("union", [again, rest], exact=True).model, cube], exact=True).measure == 0
