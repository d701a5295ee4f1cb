"""What one call gives, another one takes, and it means the same."""

from __future__ import annotations

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
