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
    with pytest.raises(coface.InvalidInputError, match="diagrams of complexes and of points"):
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
