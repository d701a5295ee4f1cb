"""Torsion: the projective plane has a loop that bounds nothing, and twice bounds a disk. The certificate is that disk."""

# %% The projective plane with six vertices
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

plane = coface.Complex([
    [0, 1, 2], [0, 1, 5], [0, 2, 4], [0, 3, 4], [0, 3, 5],
    [1, 2, 3], [1, 3, 4], [1, 4, 5], [2, 3, 5], [2, 4, 5],
])  # fmt: skip
assert plane.f_vector == (6, 15, 10)
assert coface.classify(plane)[0]["name"] == "projective plane"

# %% It cannot be oriented: a closed strip of triangles shows why
verdict = plane.is_orientable()
assert not verdict
print(verdict.message)

# %% Over the integers, over the rationals, modulo 2
integral = coface.homology(plane, generators=True)
assert [str(group) for group in integral] == ["Z", "Z/2", "0"]
assert coface.homology(plane, "q").betti_numbers == (1, 0, 0)
assert coface.homology(plane, "f2").betti_numbers == (1, 1, 1)
# Torsion moves up by one degree in cohomology.
assert [str(group) for group in coface.cohomology(plane)] == ["Z", "0", "Z/2"]

# %% The loop, and the chain of triangles whose boundary is twice the loop
complex = plane.chain_complex()
(loop,) = integral[1].generators
certificate = loop.certificate
assert loop.order == 2
print("the loop", [(int(c), edge) for c, edge in loop.chain.terms()])
print("bounds, taken twice,", [(int(c), triangle) for c, triangle in certificate.terms()])

boundary = complex.boundary(2) @ certificate.as_vector()
assert abs(boundary - 2 * loop.as_vector()).sum() == 0
assert abs(complex.boundary(1) @ loop.as_vector()).sum() == 0

# %% No chain has the loop itself as boundary: modulo 2 that would be a solution of a linear system, and there is none
matrix = np.asarray(complex.boundary(2).todense()) % 2
target = np.asarray(loop.as_vector().todense()).reshape(-1) % 2


def rank(rows: np.ndarray) -> int:
    """The rank over the field with two elements."""
    rows, found = rows.copy() % 2, 0
    for column in range(rows.shape[1]):
        below = np.flatnonzero(rows[found:, column])
        if len(below):
            pivot = found + below[0]
            rows[[found, pivot]] = rows[[pivot, found]]
            others = np.flatnonzero(rows[:, column])
            rows[others[others != found]] ^= rows[found]
            found += 1
            if found == len(rows):
                break
    return found


assert rank(np.column_stack([matrix, target])) == rank(matrix) + 1

# %% The boundary matrices
panels = coface.plot(complex, title="the projective plane")
panels[0].figure.savefig(pictures / "projective_plane.png", dpi=120)
