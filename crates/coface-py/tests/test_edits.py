"""Surfaces that are edited, and halfedges with a boundary."""

import coface
import numpy as np
import pytest


def test_edits_have_inverses_and_are_undone():
    grid = coface.generate("torus", columns=5, rows=4).surface()
    flipped = grid.flip_edge(7)
    assert flipped.f_vector == grid.f_vector and flipped.edits[0]["op"] == "flip_edge"
    edge = flipped.edits[0]["inverse"][0]
    assert edge["op"] == "flip_edge_back"
    poked = flipped.poke_face(3).split_edge(2)
    assert poked.f_vector == (22, 64, 42) and poked.genus == 1
    assert [edit["op"] for edit in poked.edits] == ["flip_edge", "poke_face", "split_edge"]
    back = poked.undo(3)
    assert back.f_vector == grid.f_vector and np.array_equal(back.edge_ends, grid.edge_ends)
    with pytest.raises(coface.Error, match="4 edits are to be undone"):
        poked.undo(4)


def test_collapse_keeps_the_surface():
    grid = coface.generate("torus", columns=6, rows=5).surface()
    smaller = grid.collapse_edge(0)
    assert smaller.f_vector == (29, 87, 58) and smaller.genus == 1


def test_halfedges_without_twins_are_boundaries():
    triangle = coface.Model.from_halfedges([1, 2, 0], [None, -1, 2], vertices=[[0, 0], [1, 0], [0, 1]])
    report = triangle.report()
    assert report.name == "disk" and report.f_vector == (3, 3, 1)
    disk = coface.Model.from_halfedges([0, 1], outer=[1])
    assert disk.report().name == "disk"
    roles = coface.generate("torus", columns=5, rows=4).surface().cut(roles=True).roles
    assert [len(roles[key]) for key in ("tree", "cotree", "generators")] == [19, 39, 2]
