"""Arrays look at the memory of the library; nothing is copied where the layout allows."""

from __future__ import annotations

import gc

import numpy as np
import pytest

import coface


def test_arrays_of_a_model_share_memory(spot) -> None:
    model = coface.read(spot)
    for name in ["vertices", "faces"]:
        first, second = getattr(model, name), getattr(model, name)
        assert np.shares_memory(first, second), name
        assert not first.flags.writeable, name
        with pytest.raises(ValueError):
            first[0] = 0


def test_boundary_matrices_share_memory(spot) -> None:
    complex = coface.as_chain_complex(spot)
    for degree in [1, 2]:
        first, second = complex.boundary(degree), complex.boundary(degree)
        for part in ["data", "indices", "indptr"]:
            assert np.shares_memory(getattr(first, part), getattr(second, part)), part
        assert first.indices.dtype == first.indptr.dtype == np.int32
        assert first.data.dtype.kind == "i"
        assert first.has_canonical_format
    product = complex.boundary(1) @ complex.boundary(2)
    assert product.shape == (2930, 5856)
    assert abs(product).sum() == 0


def test_arrays_outlive_what_they_came_from(spot) -> None:
    model = coface.read(spot)
    vertices, copied = model.vertices, model.vertices.copy()
    matrix = coface.as_chain_complex(model).boundary(2)
    entries = matrix.toarray() if matrix.shape[1] < 100 else matrix.data.copy()
    del model
    gc.collect()
    # Something else may take the memory if it was given back.
    other = [np.full(1 << 16, float(i)) for i in range(50)]
    assert np.array_equal(vertices, copied)
    assert np.array_equal(matrix.data, entries)
    assert len(other) == 50


def test_calls_on_shared_arrays_do_not_need_their_size(spot) -> None:
    # An array of the model is a view: it takes no memory that grows with the model.
    import tracemalloc

    model = coface.as_model(spot)
    model.vertices
    tracemalloc.start()
    views = [model.vertices for _ in range(100)] + [model.faces for _ in range(100)]
    current, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert len(views) == 200
    assert current < 200 * 1000, "200 views of 140 kB"


def test_any_layout_goes_in() -> None:
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    expected = coface.Model.from_arrays(vertices, faces)
    for kind in ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"]:
        assert coface.Model.from_arrays(vertices, faces.astype(kind)) == expected, kind
    assert coface.Model.from_arrays(np.asfortranarray(vertices), np.asfortranarray(faces)) == expected
    assert coface.Model.from_arrays(np.repeat(vertices, 2, axis=0)[::2], np.repeat(faces, 3, axis=0)[::3]) == expected
    assert coface.Model.from_arrays(vertices[:, ::-1][:, ::-1], faces.tolist()) == expected
    assert coface.Model.from_arrays(vertices, tuple(map(tuple, faces.tolist()))) == expected
    assert coface.Model.from_arrays(vertices, faces.astype(">i4")) == expected
    masked = coface.Model.from_arrays(vertices, (faces.reshape(-1), np.arange(5) * 3))
    assert masked == expected
    assert expected.report().signed_volume == pytest.approx(1 / 6)
