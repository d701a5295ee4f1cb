"""torch: operators of a complex as sparse tensors, and graphs for torch_geometric."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import Complex, Model
from coface._faults import in_words
from coface._models import as_drawn
from coface.interop import needed
from coface.interop.sparse import coo, csr


@in_words
def tensor(x: Any, name: str, degree: int, *, layout: str = "coo") -> Any:
    """An operator of a complex as a sparse tensor of 32-bit floats.

    Parameters
    ----------
    x, name, degree
        As for :func:`coface.interop.sparse.operator`.
    layout
        ``"coo"`` or ``"csr"``.

    Returns
    -------
    torch.Tensor
        Sparse, on the CPU.
    """
    library = needed("torch", "coface.interop.torch")
    if layout == "coo":
        indices, values, shape = coo(x, name, degree)
        indices, values = library.from_numpy(indices), library.from_numpy(values)
        return library.sparse_coo_tensor(indices, values, shape, check_invariants=False).coalesce()
    if layout == "csr":
        parts = csr(x, name, degree)
        return library.sparse_csr_tensor(*map(library.from_numpy, parts[:3]), size=parts[3], check_invariants=False)
    raise_invalid(f"layout is {layout!r}", 'give "coo" or "csr"')


@in_words
def data(x: Any) -> Any:
    """A model as ``torch_geometric.data.Data``: vertices with ``pos``, each edge in both directions as ``edge_index``, triangles as ``face``.

    Parameters
    ----------
    x
        Anything that :func:`coface.as_model` understands.
    """
    library, geometric = needed("torch", "coface.interop.torch"), needed("torch_geometric.data", "coface.interop.torch")
    model: Model = x.model() if isinstance(x, Complex) else as_drawn(x)
    pairs = np.asarray(model.edges, np.int64).reshape(-1, 2)
    both = np.concatenate([pairs, pairs[:, ::-1]]).T
    made = geometric.Data(edge_index=library.from_numpy(np.ascontiguousarray(both)), num_nodes=max(model.vertex_count, int(pairs.max(initial=-1)) + 1))
    if model.vertices is not None:
        made.pos = library.from_numpy(np.array(model.vertices, np.float32))
    faces = model.faces
    if isinstance(faces, np.ndarray) and faces.shape[1] == 3 and len(faces):
        made.face = library.from_numpy(np.ascontiguousarray(np.asarray(faces, np.int64).T))
    return made
