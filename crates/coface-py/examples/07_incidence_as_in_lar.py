"""Incidence operators by sparse products, as in LAR: cells are rows of vertices, and products of those matrices say which cells touch."""

# %% A grid of 4 x 3 x 2 cubes
import sys
from pathlib import Path

import numpy as np
from scipy.sparse import csr_array

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

grid = coface.generate("cuboids", shape=[4, 3, 2])
counts = grid.f_vector
print(grid, counts)
assert counts == (60, 133, 98, 24)

# %% Characteristic matrices: a row for each cell, a one for each of its vertices


def characteristic(model: coface.Model, degree: int) -> csr_array:
    """The matrix of the cells of this degree."""
    cells = np.asarray(model.simplices(degree))
    rows = np.repeat(np.arange(len(cells)), cells.shape[1])
    return csr_array((np.ones(cells.size, np.int64), (rows, cells.reshape(-1))), shape=(len(cells), model.vertex_count))


V, E, F, C = (characteristic(grid, degree) for degree in range(4))
assert V.shape == (60, 60) and C.shape == (24, 60)

# %% A product counts the vertices that two cells share
shared = F @ E.T
# A face bounds where both ends of an edge are its vertices: four edges a face.
bounding = (shared == 2).astype(np.int64)
assert (bounding.sum(axis=1) == 4).all()
# %% That is the boundary without signs, and the operator FE of the library, which also counts if it is asked to
# %% That is the boundary without signs, and the operator FE of the library, which also counts
assert (coface.incidence(grid, "FE", "counts") != shared).nnz == 0
complex = coface.as_chain_complex(grid)
assert (bounding.T != abs(complex.boundary(2))).nnz == 0
assert (coface.incidence(grid, "FE", "incident") != bounding).nnz == 0

# %% Faces of cubes by the same rule; each inner face lies in two
of_cubes = ((C @ F.T) == 4).astype(np.int64)
assert (of_cubes.sum(axis=1) == 6).all()
inner = (of_cubes.sum(axis=0) == 2).sum()
assert 2 * inner + (of_cubes.sum(axis=0) == 1).sum() == 6 * 24

# %% Signs make the boundary of the boundary vanish
assert abs(complex.boundary(1) @ complex.boundary(2)).sum() == 0
assert abs(complex.boundary(2) @ complex.boundary(3)).sum() == 0

# %% Where the entries are
panels = coface.plot(complex, title="4 x 3 x 2 cubes")
panels[0].figure.savefig(pictures / "incidence.png", dpi=120)
