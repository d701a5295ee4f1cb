"""Operators of a complex as sparse arrays of plain numbers: what torch, torch_geometric, jax and cupy take, without importing them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from coface._arrays import raise_invalid
from coface._faults import in_words
from coface._models import as_chain_complex

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: What is asked for by name.
OPERATORS = ("boundary", "coboundary", "laplacian", "up_laplacian", "down_laplacian", "adjacency", "coadjacency")


@in_words
def operator(x: Any, name: str, degree: int) -> csr_array:
    """An operator of a complex by rows.

    Parameters
    ----------
    x
        Anything that :func:`coface.as_chain_complex` understands.
    name
        ``"boundary"`` (rows: cells of degree k - 1), ``"coboundary"`` (rows: cells of degree k + 1), ``"laplacian"``, ``"up_laplacian"``,
        ``"down_laplacian"``; ``"adjacency"`` (1 for cells of degree k in one cell of degree k + 1) and ``"coadjacency"`` (1 for cells of
        degree k with a face in common).
    degree
        The degree k.

    Returns
    -------
    scipy.sparse.csr_array
        Integers.

    Examples
    --------
    >>> operator([[0, 1, 2]], "adjacency", 0).toarray()
    array([[0, 1, 1],
           [1, 0, 1],
           [1, 1, 0]], dtype=int32)
    >>> operator([[0, 1, 2], [1, 2, 3]], "coadjacency", 2).toarray()
    array([[0, 1],
           [1, 0]], dtype=int32)
    """
    if name not in OPERATORS:
        raise_invalid(f"{name!r} is no operator", "give one of " + ", ".join(OPERATORS))
    complex = as_chain_complex(x)
    if name == "boundary":
        return complex.boundary(degree).tocsr()
    if name == "coboundary":
        return complex.coboundary(degree).tocsr()
    count = complex.cell_count(degree)
    up, down = complex.boundary(degree + 1), complex.boundary(degree) if degree else None
    parts = []
    if name in ("laplacian", "up_laplacian", "adjacency") and up.shape[1]:
        parts.append(_product(abs(up) if name == "adjacency" else up))
    if name in ("laplacian", "down_laplacian", "coadjacency") and down is not None and down.shape[0]:
        parts.append(_product((abs(down) if name == "coadjacency" else down).T))
    from scipy.sparse import csr_array

    found = sum(parts[1:], parts[0]) if parts else csr_array((count, count), dtype=np.int32)
    if name in ("adjacency", "coadjacency"):
        found = found.tolil() if found.nnz == 0 else found
        found = csr_array(found)
        found.setdiag(0)
        found.eliminate_zeros()
        found.data[:] = 1
    found = csr_array(found)
    found.sort_indices()
    return found


def _product(matrix: Any) -> Any:
    return (matrix @ matrix.T).tocsr()


@in_words
def coo(x: Any, name: str, degree: int) -> tuple[NDArray[np.int64], NDArray[np.float32], tuple[int, int]]:
    """An operator as ``(indices, values, shape)``: ``torch.sparse_coo_tensor(*coo(x, "boundary", 1))`` is its tensor.

    Parameters
    ----------
    x, name, degree
        As for :func:`operator`.

    Returns
    -------
    indices : numpy.ndarray
        ``int64``, shape (2, entries): rows and columns. It is the ``edge_index`` of torch_geometric for an adjacency.
    values : numpy.ndarray
        ``float32``.
    shape : tuple of int
        Rows and columns.

    Examples
    --------
    >>> indices, values, shape = coo([[0, 1], [1, 2]], "boundary", 1)
    >>> indices.tolist(), values.tolist(), shape
    ([[0, 1, 1, 2], [0, 0, 1, 1]], [-1.0, 1.0, -1.0, 1.0], (3, 2))
    """
    found = operator(x, name, degree).tocoo()
    return np.stack([found.row, found.col]).astype(np.int64), found.data.astype(np.float32), _shape(found)


@in_words
def csr(x: Any, name: str, degree: int) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32], tuple[int, int]]:
    """An operator as ``(row_starts, columns, values, shape)``: ``torch.sparse_csr_tensor(*csr(x, "laplacian", 1))`` is its tensor.

    Parameters
    ----------
    x, name, degree
        As for :func:`operator`.

    Examples
    --------
    >>> csr([[0, 1]], "boundary", 1)[:2]
    (array([0, 1, 2]), array([0, 0]))
    """
    found = operator(x, name, degree)
    return found.indptr.astype(np.int64), found.indices.astype(np.int64), found.data.astype(np.float32), _shape(found)


def _shape(matrix: Any) -> tuple[int, int]:
    return int(matrix.shape[0]), int(matrix.shape[1])
