"""Diagrams of flag complexes of graphs."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import coo_array

import coface

CYCLE = [[10, 20, 1.0], [20, 30, 2.0], [30, 40, 3.0], [40, 10, 4.0], [10, 30, 6.0]]


def test_a_cycle_with_a_diagonal() -> None:
    found = coface.flag(CYCLE, {7: 0.25, 20: 0.5})
    np.testing.assert_array_equal(found.diagram(1), [[4, 6]])
    assert found.betti_numbers == (2, 0)
    ((edge, triangle),) = found.simplices(1)
    assert edge == [10, 40] and triangle in ([10, 20, 30], [10, 30, 40])
    assert coface.flag(CYCLE, threshold=5).betti_numbers == (1, 1)
    again = pickle.loads(pickle.dumps(found))
    np.testing.assert_array_equal(again.diagram(1), found.diagram(1))


def test_matrices_and_points() -> None:
    points = np.random.default_rng(3).random((12, 2))
    distances = np.sqrt(((points[:, None] - points[None]) ** 2).sum(axis=2))
    lower = coo_array(np.tril(distances))
    found, rips = coface.flag(lower, dimension=2), coface.rips(distances, distances="square", dimension=2)
    for degree in (0, 1, 2):
        np.testing.assert_array_equal(found.diagram(degree), rips.diagram(degree))
    assert coface.flag([[0, 1], [1, 2], [2, 0]], dimension=2).betti_numbers == (1, 0, 0)
    assert coface.flag([], [0.0, 1.0]).betti_numbers == (2, 0)


def test_files_and_graphs_of_networkx(tmp_path: Path) -> None:
    (tmp_path / "roads.csv").write_text("source,target,weight\nBern,Thun,3\nThun,Chur,5\n")
    roads = coface.flag(tmp_path / "roads.csv")
    assert roads.vertex_names == ("Bern", "Thun", "Chur")
    assert roads.simplices(0)[1] == ([1], [0, 1])
    networkx = pytest.importorskip("networkx")
    graph = networkx.Graph()
    graph.add_node("alone")
    graph.add_weighted_edges_from([("a", "b", 1), ("b", "c", 2), ("c", "d", 3), ("d", "a", 4), ("a", "c", 6)])
    np.testing.assert_array_equal(coface.flag(graph).diagram(1), [[4, 6]])
    networkx.write_graphml(graph, tmp_path / "graph.graphml")
    of_file = coface.flag(str(tmp_path / "graph.graphml"))
    np.testing.assert_array_equal(of_file.diagram(1), [[4, 6]])
    assert of_file.betti_numbers == (2, 0)


def test_directions() -> None:
    loop = coface.flag([[5, 7, 1], [7, 5, 2]], directed=True)
    np.testing.assert_array_equal(loop.diagram(1), [[2, np.inf]])
    assert loop.simplices(1) == [([7, 5], None)]
    both = [[i, j] for i in range(3) for j in range(3) if i != j]
    assert coface.flag(both, directed=True, dimension=2).betti_numbers == (1, 0, 2)
    assert coface.homology(coface.flag_complex(both, directed=True, dimension=3)).betti_numbers == (1, 0, 2)
    again = pickle.loads(pickle.dumps(loop))
    np.testing.assert_array_equal(again.diagram(1), loop.diagram(1))


def test_complexes_at_a_scale() -> None:
    model = coface.flag_complex(CYCLE, threshold=5)
    assert coface.homology(model).betti_numbers == (1, 1)
    square = np.array([[0, 0], [3, 0], [3, 4], [0, 4.0]])
    assert coface.homology(coface.rips_complex(square, threshold=4)).betti_numbers == (1, 1)
    assert coface.rips_complex(square, dimension=3).cells["tetra"].shape == (1, 4)
    with pytest.warns(UserWarning, match="dimension"):
        assert len(coface.rips_complex(square).faces) == 4
    lower = coface.rips_complex([[3], [5, 4]], 4, distances="lower")
    assert coface.homology(lower).betti_numbers == (1, 0)


def test_balls() -> None:
    rectangle = [[0, 0], [6, 0], [6, 8], [0, 8]]
    np.testing.assert_array_equal(coface.cech(rectangle).diagram(1), [[4, 5]])
    assert coface.cech(rectangle, threshold=4.5).betti_numbers == (1, 1)
    assert coface.homology(coface.cech_complex(rectangle, 4)).betti_numbers == (1, 1)
    points = np.random.default_rng(5).random((9, 3))
    one, other = coface.cech(points, dimension=2), coface.alpha(points, radii=True)
    for degree in (0, 1, 2):
        np.testing.assert_allclose(sorted(one.diagram(degree).tolist()), sorted(other.diagram(degree).tolist()), rtol=1e-9)
    assert coface.cech(np.zeros((0, 3))).betti_numbers in ((), (0,), (0, 0))
    with pytest.raises(coface.InvalidInputError, match="radius is -1"):
        coface.cech(rectangle, threshold=-1)


def test_witnesses() -> None:
    angles = np.arange(60) * 2 * np.pi / 60
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    found = coface.witness(circle, 8, threshold=0.1)
    assert found.betti_numbers == (1, 1)
    assert coface.homology(coface.witness_complex(circle, 8, 0.0)).betti_numbers == (1, 1)
    strong = coface.witness([[0.0], [1.0], [4.0]], 2, strong=True, dimension=0)
    np.testing.assert_array_equal(strong.diagram(0), [[0, np.inf], [0, 8]])
    with pytest.warns(UserWarning, match="2 different points"):
        coface.witness_complex([[0.0], [1.0]], 3)


def test_smaller_values_are_taken() -> None:
    with pytest.warns(UserWarning, match="smaller value"):
        found = coface.flag([[0, 1, 2], [1, 0, 1]])
    np.testing.assert_array_equal(found.diagram(0), [[0, np.inf], [0, 1]])


def test_wrong_graphs() -> None:
    with pytest.raises(coface.InvalidInputError, match="no vertex"):
        coface.flag([[0, 0.5, 1]])
    with pytest.raises(coface.InvalidInputError, match="before vertex 0"):
        coface.flag([[0, 1, 1]], [2.0])
    with pytest.raises(coface.InvalidInputError, match="shape"):
        coface.flag(np.zeros((2, 4)))


def test_matrices_have_a_vertex_for_each_row() -> None:
    matrix = coo_array(([2.0], ([1], [3])), shape=(5, 5))
    assert coface.flag(matrix, dimension=0).diagram(0).tolist() == [[0, np.inf], [0, np.inf], [0, np.inf], [0, 2], [0, np.inf]]
    assert coface.flag_complex(matrix).f_vector == (5, 1)
    assert coface.flag_complex(coo_array((3, 3))).f_vector == (3,)
    assert coface.flag(matrix, directed=True, dimension=0).betti_numbers == (4,)
    with pytest.raises(coface.InvalidInputError, match=r"the matrix of edges has the shape \(2, 3\)"):
        coface.flag(coo_array((2, 3)))


def test_arrays_that_could_be_matrices_are_refused() -> None:
    triangle = np.array([[0, 1, 2], [1, 0, 3], [2, 3, 0]])
    for given in (triangle, [[0, 1], [1, 0]]):
        with pytest.raises(coface.InvalidInputError, match=r"they could be a matrix of values; give scipy.sparse.coo_array\(x\)"):
            coface.flag(given)
    assert coface.flag(coo_array(triangle)).diagram(0).tolist() == [[0, np.inf], [0, 1], [0, 2]]
    with pytest.raises(coface.InvalidInputError, match=r"or scipy.sparse.coo_array\(x\) for a matrix of values"):
        coface.flag(np.ones((4, 4)))


def test_rows_of_cycles_are_those_of_a_graph_whose_values_tie() -> None:
    edges = [[1, 0, 4], [2, 1, 3], [3, 0, 4], [3, 1, 1], [4, 0, 1], [4, 2, 2], [4, 3, 3], [5, 0, 2], [5, 2, 2], [5, 3, 4]]
    edges += [[5, 4, 4], [6, 0, 3], [6, 2, 2], [6, 5, 1], [7, 0, 4], [7, 1, 1], [7, 3, 3], [7, 4, 3], [7, 5, 1], [7, 6, 4]]
    found = coface.flag(edges, dict.fromkeys(range(8), 0.0))
    for (_, death), (maker, ender), (cycle, bounding, _) in zip(found.diagram(1), found.simplices(1), found.cycles(1), strict=True):
        assert maker in cycle.simplices.tolist()
        assert (bounding is None) == np.isinf(death)
        assert bounding is None or ender in bounding.simplices.tolist()
