"""Alpha complexes of points, and the cycles of their diagrams."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import coface

SQUARE = np.array([[0, 0], [6, 0], [6, 8], [0, 8]])


def test_a_rectangle() -> None:
    found = coface.alpha(SQUARE)
    np.testing.assert_array_equal(found.diagram(1), [[16, 25]])
    np.testing.assert_array_equal(coface.alpha(SQUARE, radii=True).diagram(1), [[4, 5]])
    assert coface.alpha(SQUARE, bound=20).betti_numbers == (1, 1)
    assert coface.alpha(SQUARE, bound=20, coefficients=3).prime == 3
    again = pickle.loads(pickle.dumps(found))
    np.testing.assert_array_equal(again.diagram(0), found.diagram(0))
    ((edge, triangle),) = found.simplices(1)
    assert len(edge) == 2 and triangle is not None and len(triangle) == 3


def test_a_model_at_a_value() -> None:
    model = coface.alpha_complex(SQUARE, bound=16)
    assert coface.homology(model).betti_numbers == (1, 1)
    assert coface.alpha_complex(SQUARE).faces.shape == (2, 3)
    corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, -1).T
    assert coface.homology(coface.alpha_complex(corners)).betti_numbers[0] == 1
    with pytest.warns(UserWarning, match="1 point is in no simplex"):
        twice = coface.alpha_complex(np.vstack([SQUARE, SQUARE[:1]]))
    assert twice.vertex_count == 4


def test_weights() -> None:
    found = coface.alpha([[0.0], [4.0]], weights=[4, 0])
    np.testing.assert_array_equal(found.diagram(0), [[-4, np.inf], [0, 2.25]])
    with pytest.raises(coface.InvalidInputError, match="leave out radii, or weights"):
        coface.alpha([[0.0]], weights=[1], radii=True)
    with pytest.raises(coface.InvalidInputError, match="one weight for each point"):
        coface.alpha([[0.0]], weights=[1, 2])


def test_wrong_points() -> None:
    with pytest.raises(coface.InvalidInputError, match=r"coface.rips\(points\)"):
        coface.alpha(np.zeros((2, 4)))
    with pytest.raises(coface.InvalidInputError, match="two axes"):
        coface.alpha(np.zeros(3))
    assert sum(coface.alpha(np.zeros((0, 3))).betti_numbers) == 0


@pytest.mark.parametrize("prime", [2, 3, 7])
def test_cycles_are_proofs(prime: int) -> None:
    points = np.random.default_rng(7).random((40, 3))
    found = coface.alpha(points, coefficients=prime, least=1e-3)
    complex = coface.as_chain_complex(coface.Complex(coface.alpha_complex(points).cells["tetra"]))
    for degree in range(3):
        proved = found.cycles(degree)
        assert len(proved) == len(found.diagram(degree))
        for (_, death), (cycle, bounding_chain, cocycle) in zip(found.diagram(degree), proved, strict=True):
            assert (cycle.degree, cocycle.degree, cocycle.is_cochain) == (degree, degree, True)
            assert np.isinf(death) == (bounding_chain is None)
            # Cells are numbered alike: simplices in lexicographic order.
            if degree:
                boundary = complex.boundary(degree) @ cycle.as_vector()
                assert not (boundary.toarray() % prime).any()
            if bounding_chain is not None:
                rim = complex.boundary(degree + 1) @ bounding_chain.as_vector()
                assert not ((rim - cycle.as_vector()).toarray() % prime).any()
            value = (cocycle.as_vector().T @ cycle.as_vector()).toarray()[0, 0]
            assert value % prime == 1
    assert found.torsion_primes() == []
    assert len(found.longer_than(0.05).cycles(1)) == len(found.longer_than(0.05).diagram(1))


def test_cycles_of_functions() -> None:
    circle = coface.persistence([[0, 1], [1, 2], [0, 2]], [0.0, 1.0, 2.0])
    ((cycle, bounding_chain, cocycle),) = circle.cycles(1)
    assert bounding_chain is None and cycle.coefficients.tolist() == [1, 1, 1]
    assert cocycle.cells.tolist() == [2] or len(cocycle) == 1
    with pytest.raises(coface.InvalidInputError, match="the cubes of the image were not kept"):
        coface.cubical(np.zeros((2, 2))).cycles(0)


def test_cycles_of_rips_and_flag() -> None:
    square = np.array([[0, 0], [3, 0], [3, 4], [0, 4]])
    found = coface.rips(square, coefficients=3)
    ((cycle, bounding_chain, cocycle),) = found.cycles(1)
    assert cycle.simplices.tolist() == [[0, 1], [0, 3], [1, 2], [2, 3]]
    assert bounding_chain is not None and len(bounding_chain) == 2
    assert cocycle.degree == 1 and found.torsion_primes() == []
    assert found.longer_than(2).cycles(1) == []
    assert [bounding is None for _, bounding, _ in coface.rips(square, threshold=3.5).cycles(0)].count(True) == 2
    graph = coface.flag([[10, 30, 1], [30, 20, 2], [20, 40, 3], [40, 10, 4], [10, 20, 6]])
    ((cycle, bounding_chain, _),) = graph.cycles(1)
    assert cycle.simplices.tolist() == [[10, 30], [10, 40], [20, 30], [20, 40]]
    assert len(coface.cech(square).cycles(1)) == 1


def test_points_that_repeat() -> None:
    crystal = [[0, 0, 0], [1, 1, 1]]
    found = coface.alpha(crystal, periods=[2, 2, 2])
    assert found.betti_numbers == (1, 3, 3, 1)
    np.testing.assert_array_equal(found.diagram(0), [[0, np.inf], [0, 0.75]])
    # The same of eight copies in a box of twice the size, where each class is there eight times at least.
    copies = [[x + 2 * i, y + 2 * j, z + 2 * k] for x, y, z in crystal for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    twice = coface.alpha(copies, periods=(4, 4, 4))
    assert twice.betti_numbers == (1, 3, 3, 1)
    assert sorted(set(twice.diagram(2)[:, 0])) == sorted(set(found.diagram(2)[:, 0]))
    points = np.random.default_rng(3).random((500, 3))
    model = coface.alpha_complex(points, periods=np.ones(3))
    assert (model.f_vector[0], coface.homology(model).betti_numbers) == (500, (1, 3, 3, 1))
    moved = coface.alpha(points + [0.25, -3, 7.5], periods=[1, 1, 1], radii=True)
    for degree in range(3):
        np.testing.assert_allclose(
            np.sort(moved.diagram(degree), axis=0),
            np.sort(coface.alpha(points, periods=[1, 1, 1], radii=True).diagram(degree), axis=0),
            atol=1e-12,
        )
    with pytest.raises(coface.Error, match="2 sides"):
        coface.alpha(points, periods=[1, 1])
    with pytest.raises(coface.Error, match="a side of a periodic box is 0"):
        coface.alpha(points, periods=[1, 1, 0])


def test_mapper() -> None:
    t = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    circle = np.column_stack([np.cos(t), np.sin(t)])
    model, clusters = coface.mapper(circle, 1, intervals=4, threshold=0.2)
    assert coface.homology(model).betti_numbers == (1, 1)
    assert sum(len(points) for points in clusters) > 60
    sizes = next(values for name, _, values in model.data if name == "points")
    np.testing.assert_array_equal(np.ravel(sizes), [len(points) for points in clusters])
    for vertex, points in zip(model.vertices, clusters, strict=True):
        np.testing.assert_allclose(vertex[:2], circle[points].mean(axis=0), atol=1e-12)
    _, same = coface.mapper(circle, lambda points: points[:, 1], intervals=4, threshold=0.2)
    assert [list(points) for points in same] == [list(points) for points in clusters]
    with pytest.warns(UserWarning, match="least distance at which all are connected"):
        assert coface.homology(coface.mapper(circle, circle[:, 1], intervals=4)[0]).betti_numbers == (1, 1)
    with pytest.warns(UserWarning):
        assert len(coface.mapper(circle, "eccentricity", intervals=1)[1]) == 1
    # Points of many dimensions have no positions to draw.
    model, clusters = coface.mapper(np.eye(5), np.arange(5), intervals=2, overlap=0.5, threshold=2.0)
    assert len(clusters) == model.f_vector[0] == 2
    for wrong, match in (
        (lambda: coface.mapper(circle, 2), "no coordinate 2"),
        (lambda: coface.mapper(circle, "height"), "eccentricity"),
        (lambda: coface.mapper(circle, [1.0]), "1 values for 60 points"),
        (lambda: coface.mapper(circle, 0, overlap=1), "from 0 to 0.9"),
        (lambda: coface.mapper(circle, 0, intervals=0), "0 intervals"),
        (lambda: coface.mapper(circle, 0, threshold=-1), "the threshold is -1"),
    ):
        with pytest.raises(coface.Error, match=match):
            wrong()
