"""What was answered wrongly without a word: groups over fields, arrays that could be two things, curves that run clockwise."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import coface

SQUARE = [[0, 0], [2, 0], [2, 2], [0, 2]]


@pytest.mark.parametrize(
    ("ring", "shown"),
    [
        ("z", "Homology(Z, Z/2)"),
        ("q", "Homology(Q)"),
        ("f2", "Homology(Z/2, Z/2, Z/2)"),
        ("f3", "Homology(Z/3)"),
        ("z/4", "Homology(Z/4, Z/2, Z/2)"),
        (4, "Homology(Z/4, Z/2, Z/2)"),
    ],
)
def test_groups_are_printed_over_their_ring(projective_plane, ring, shown) -> None:
    found = coface.homology(projective_plane, ring)
    assert repr(found) == shown
    assert [str(group) for group in found][0] == found.coefficients == found[0].coefficients


def test_groups_over_other_rings_are_other_groups(torus) -> None:
    assert repr(coface.homology(torus, "f2")[1]) == "H_1 = (Z/2)^2"
    assert repr(coface.cohomology(torus, "q")[1]) == "H^1 = Q^2"
    assert coface.homology(torus, "q") != coface.homology(torus)
    assert coface.homology(torus, "q")[1] != coface.homology(torus)[1]
    assert coface.homology(torus, "f2") == coface.homology(torus, "z/2")


def test_no_groups_are_printed_as_zero() -> None:
    assert repr(coface.Complex([]).chain_complex().homology()) == "Homology(0)"
    disk = coface.homology([[0, 1, 2]], reduced=True)
    assert repr(disk) == "Homology(0)" and str(disk[1]) == "0"


def test_persistence_has_one_value_a_vertex(torus) -> None:
    with pytest.raises(coface.InvalidInputError, match=r"shape \(7, 3\)") as caught:
        coface.persistence(torus, np.zeros((7, 3)))
    assert "(7,)" in caught.value.cure
    for count in (0, 6, 8, 14):
        with pytest.raises(coface.InvalidInputError, match=rf"shape \({count},\).* below 7"):
            coface.persistence(torus, np.zeros(count))
    assert coface.persistence(torus, np.zeros(7)).betti_numbers == (1, 2, 1)
    model = coface.generate("torus", columns=5, rows=4)
    with pytest.raises(coface.InvalidInputError):
        coface.persistence(model, model.vertices)
    with pytest.raises(coface.InvalidInputError, match="no array of numbers"):
        coface.persistence(torus, ["a"] * 7)


def test_persistence_counts_vertices_that_nothing_uses() -> None:
    model = coface.Model(np.zeros((5, 2)), [[0, 1, 2]])
    assert len(coface.persistence(model, np.arange(5.0)).diagram(0)) >= 1
    with pytest.raises(coface.InvalidInputError):
        coface.persistence(model, np.arange(6.0))


def test_persistence_has_one_value_a_cell(torus) -> None:
    values = [np.zeros(7), np.zeros(21), np.zeros(14)]
    assert coface.persistence(torus, cell_values=values).betti_numbers == (1, 2, 1)
    with pytest.raises(coface.InvalidInputError, match=r"cell_values\[1\] have the shape \(22,\), and there are 21 cells"):
        coface.persistence(torus, cell_values=[np.zeros(7), np.zeros(22), np.zeros(14)])
    with pytest.raises(coface.InvalidInputError, match=r"shape \(7, 3\)"):
        coface.persistence(torus, cell_values=[np.zeros((7, 3)), values[1], values[2]])


@pytest.mark.parametrize(
    "image",
    [
        np.linspace(0, 1, 900).reshape(30, 30),
        np.zeros((30, 3), np.uint8),
        np.arange(90, dtype=np.uint8).reshape(30, 3),
        np.zeros((4, 4, 4)),
        np.zeros((4, 4, 4), np.int64),
        np.zeros((30, 30), np.int64),
        np.arange(5),
        [[0.5, 1.0, 2.0, 3.0]],
    ],
)
def test_arrays_that_could_be_two_things_are_refused(image) -> None:
    with pytest.raises(coface.InvalidInputError) as caught:
        coface.homology(image)
    for name in ("coface.volume", "coface.Model(vertices, faces)", "from_facets"):
        assert name in caught.value.cure


def test_arrays_that_can_be_one_thing_are_taken() -> None:
    assert coface.as_model(np.zeros((4, 3))).vertex_count == 4
    assert coface.as_model([[0.0, 0.5], [1.0, 0.5]]).vertex_count == 2
    assert coface.as_model(np.array([[0, 1, 2]])).structure == "facets"
    assert coface.as_model(np.array([[0, 1, 2]], np.int32)).structure == "facets"
    for mask in (np.ones((3, 3), bool), np.ones((3, 3, 3), bool), [[True, False], [True, True]]):
        assert coface.as_model(mask).structure == "volume"
    assert coface.as_model(np.zeros((0, 3), np.int64)).f_vector == ()


def test_values_are_not_flattened() -> None:
    ring = [[0, 1], [1, 2], [0, 2]]
    with pytest.raises(coface.InvalidInputError, match=r"shape \(1, 3\)"):
        coface.is_exact(ring, np.zeros((1, 3), np.int64))
    with pytest.raises(coface.InvalidInputError, match=r"shape \(2, 3\)"):
        coface.as_surface([[0, 1, 2]]).cut([[0, 1, 2], [0, 1, 2]])
    # A column is a list too.
    assert coface.is_exact(ring, np.zeros((3, 1), np.int64))["exact"]


def test_clockwise_curves_are_told() -> None:
    clockwise = SQUARE[::-1]
    with pytest.warns(coface.AssumptionWarning, match="clockwise.*rule=\"evenodd\""):
        outside = coface.YinSet.from_rings([clockwise])
    assert outside.area == np.inf
    with pytest.warns(coface.AssumptionWarning, match="clockwise.*orient=True"):
        coface.YinSet(outside.curves)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # The cures, and sets that mean their outside.
        assert coface.YinSet.from_rings([clockwise], rule="evenodd").area == 4.0
        assert coface.YinSet([curve.reversed() for curve in outside.curves]).area == 4.0
        assert coface.YinSet(outside.curves, orient=True).area == 4.0
        inside = coface.YinSet.from_rings([SQUARE])
        assert (~inside).area == np.inf and ((~inside) ^ outside).is_empty
        hole = [[0.5, 0.5], [0.5, 1.5], [1.5, 1.5], [1.5, 0.5]]
        assert coface.YinSet.from_rings([SQUARE, hole]).area == 3.0


def test_repair_leaves_out_repeated_faces() -> None:
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    model = coface.Model(points, [[0, 1, 2], [2, 0, 1], [1, 3, 2], [1, 0, 2]])
    model = model.with_data("number", [0, 1, 2, 3], "faces").with_group("late", [1, 2], "faces")
    assert [problem["kind"] for problem in model.report().problems] == ["duplicate_cell", "faces_overlap"]
    repaired, sources = model.repaired()
    assert repaired.faces.tolist() == [[0, 1, 2], [1, 3, 2]] and sources.tolist() == [0, 1, 2, 3]
    assert repaired.report().problems == []
    [(_, _, numbers)] = repaired.data
    [(_, _, members)] = repaired.groups
    assert numbers.tolist() == [0, 2] and members.tolist() == [1]
    kept, _ = model.repaired(keep_repeated=True)
    assert len(kept.faces) == 4


def test_the_diagonal_of_shared_vertices_is_said() -> None:
    for text in (coface.incidence.__doc__, coface.LarModel.incidence.__doc__):
        assert "diagonal" in text
    triangle = [[0, 1, 2]]
    assert coface.incidence(triangle, "VV").diagonal().tolist() == [2, 2, 2]
    assert coface.incidence(triangle, "FF").diagonal().tolist() == [3]
    assert coface.incidence(triangle, "VV", "incident").diagonal().tolist() == [0, 0, 0]


def test_values_of_cells_do_not_fall() -> None:
    path = [[0, 1], [1, 2]]
    with pytest.raises(coface.InvalidInputError, match="upper=True is for vertex_values"):
        coface.persistence(path, cell_values=[[0.0, 2.0, 1.0], [2.0, 2.0]], upper=True)
    # What the cure says is the same as values that fall.
    falling = coface.persistence(path, [0.0, -2.0, -1.0], upper=True).diagram(0)
    negative = coface.persistence(path, cell_values=[[0.0, 2.0, 1.0], [2.0, 2.0]]).diagram(0)
    assert (-negative).tolist() == falling.tolist()


POINTS = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]]


@pytest.mark.parametrize(
    "asked",
    [
        lambda points, _: coface.rips(points),
        lambda points, _: coface.alpha(points),
        lambda points, _: coface.Model(points, [[0, 1, 2]]),
        lambda points, _: coface.homology((points, [[0, 1, 2]])),
        lambda points, _: coface.arrange(coface.Model.from_arrays(points[:, :2], cells={"line": [[0, 1], [1, 3]]})),
        lambda _, values: coface.persistence([[0, 1], [1, 2]], values),
        lambda _, values: coface.Model(POINTS[:3], [[0, 1, 2]]).with_data("height", values),
        lambda _, values: coface.is_exact([[0, 1], [1, 2], [0, 2]], values, tolerance=1e-9),
    ],
)
def test_masked_entries_are_not_read(asked) -> None:
    """What stands behind a mask is no number of its owner's; without masked entries such an array is an array."""
    mask = np.zeros((4, 3), bool)
    values = np.ma.array([1.0, 2.0, 3.0])
    asked(np.ma.array(POINTS, mask=mask), values)
    mask[3] = True
    with pytest.raises(coface.InvalidInputError, match="masked entries; leave them out"):
        asked(np.ma.array(POINTS, mask=mask), np.ma.array(values, mask=[False, False, True]))
