"""Operators as plain arrays, labels of images, and the engine of trimesh."""

from __future__ import annotations

import numpy as np
import pytest

import coface
from coface.interop import skimage, sparse


def _dense(x, name, degree):
    return sparse.operator(x, name, degree).toarray()


SPACES = {
    "csaszar": coface.generate("csaszar"),
    "klein": coface.generate("klein", columns=5, rows=4),
    "rp2": coface.generate("rp2"),
    "box": coface.generate("box"),
    "drawing": [[0, 1], [1, 2], [3, 4, 5]],
}


@pytest.mark.parametrize("name", SPACES)
def test_operators_are_those_of_their_definitions(name: str) -> None:
    x = SPACES[name]
    complex = coface.as_chain_complex(x)
    for degree in range(complex.dimension + 1):
        below = complex.boundary(degree).toarray() if degree else np.zeros((0, complex.cell_count(0)), np.int64)
        above = complex.boundary(degree + 1).toarray()
        down, up = below.T @ below, above @ above.T
        assert np.array_equal(_dense(x, "up_laplacian", degree), up)
        assert np.array_equal(_dense(x, "down_laplacian", degree), down)
        assert np.array_equal(_dense(x, "laplacian", degree), up + down)
        assert (sparse.operator(x, "laplacian", degree) != coface.laplacian(x, degree)).nnz == 0
        assert np.array_equal(_dense(x, "coboundary", degree), above.T)
        off = 1 - np.eye(len(up), dtype=np.int64)
        assert np.array_equal(_dense(x, "adjacency", degree), (abs(above) @ abs(above).T > 0) * off)
        assert np.array_equal(_dense(x, "coadjacency", degree), (abs(below).T @ abs(below) > 0) * off)


def test_operators_are_plain_arrays() -> None:
    from scipy.sparse import coo_array, csr_array

    x = coface.generate("torus", columns=6, rows=5)
    for name in sparse.OPERATORS:
        indices, values, shape = sparse.coo(x, name, 1)
        starts, columns, data, same = sparse.csr(x, name, 1)
        assert (indices.dtype, values.dtype, starts.dtype, columns.dtype) == (np.int64, np.float32, np.int64, np.int64)
        assert shape == same and indices.shape == (2, len(values))
        first = coo_array((values, tuple(indices)), shape=shape).toarray()
        assert np.array_equal(first, csr_array((data, columns, starts), shape=shape).toarray())
        assert np.array_equal(first, _dense(x, name, 1))
    torch = pytest.importorskip("torch")
    tensor = torch.sparse_coo_tensor(*sparse.coo(x, "boundary", 1))
    assert tuple(tensor.shape) == (30, 90)


def test_operators_without_cells_are_empty() -> None:
    points = coface.Model.from_facets([[0], [1]])
    for name in ("laplacian", "adjacency", "coadjacency"):
        assert sparse.operator(points, name, 0).shape == (2, 2) and sparse.operator(points, name, 0).nnz == 0
    with pytest.raises(coface.InvalidInputError, match="no operator"):
        sparse.operator(points, "hodge", 0)


def test_labels_are_models() -> None:
    image = np.zeros((6, 6, 6), np.int32)
    image[1:5, 1:5, 1:5] = 2
    image[2:4, 2:4, 2:4] = 9
    found = skimage.from_labels(image)
    assert {label: coface.homology(part).betti_numbers for label, part in found.items()} == {2: (1, 0, 1, 0), 9: (1, 0, 0, 0)}
    shells = coface.from_labels(image, surface=True, spacing=(1.0, 1.0, 2.0))
    assert [shells[label].report().signed_volume for label in (2, 9)] == [112.0, 16.0]
    assert list(coface.from_labels(image, only=[9])) == [9]
    with pytest.raises(coface.InvalidInputError, match="no voxel of label 5"):
        coface.from_labels(image, only=[5])
    with pytest.raises(coface.InvalidInputError, match="no labels"):
        coface.from_labels(image.astype(float))


def test_trimesh_has_the_engine() -> None:
    trimesh = pytest.importorskip("trimesh")
    from coface.interop import trimesh as door

    door.register()
    cubes = [trimesh.creation.box(), trimesh.creation.box().apply_translation([0.5, 0.25, 0.125])]
    expected = {"union": 2 - 0.5 * 0.75 * 0.875, "intersection": 0.5 * 0.75 * 0.875, "difference": 1 - 0.5 * 0.75 * 0.875}
    for operation, volume in expected.items():
        made = getattr(trimesh.boolean, operation)(cubes, engine="coface")
        assert made.is_watertight and abs(made.volume - volume) < 1e-12
    assert abs(cubes[0].union(cubes[1], engine="coface").volume - expected["union"]) < 1e-12


class Tensors:
    """What the conversions ask of torch."""

    @staticmethod
    def from_numpy(array):
        return array

    @staticmethod
    def sparse_coo_tensor(indices, values, shape, check_invariants):
        from scipy.sparse import coo_array

        found = coo_array((values, tuple(indices)), shape=shape)
        found.coalesce = lambda: found
        return found

    @staticmethod
    def sparse_csr_tensor(starts, columns, values, size, check_invariants):
        from scipy.sparse import csr_array

        return csr_array((values, columns, starts), shape=size)


def test_tensors_are_made_of_operators(monkeypatch) -> None:
    import sys
    import types

    from coface.interop import torch as door

    monkeypatch.setitem(sys.modules, "torch", Tensors())
    monkeypatch.setitem(sys.modules, "torch_geometric", types.ModuleType("torch_geometric"))
    monkeypatch.setitem(sys.modules, "torch_geometric.data", types.SimpleNamespace(Data=types.SimpleNamespace))
    x = coface.generate("csaszar")
    for layout in ("coo", "csr"):
        assert np.array_equal(door.tensor(x, "laplacian", 1, layout=layout).toarray(), _dense(x, "laplacian", 1))
    with pytest.raises(coface.InvalidInputError, match="layout"):
        door.tensor(x, "laplacian", 1, layout="bsr")
    graph = door.data(x)
    assert (graph.num_nodes, graph.edge_index.shape, graph.pos.shape, graph.face.shape) == (7, (2, 42), (7, 3), (3, 14))
    assert {tuple(pair) for pair in graph.edge_index.T.tolist()} == {(a, b) for a in range(7) for b in range(7) if a != b}
