"""The loops of a scanned bunny: first homology with generators, drawn over the mesh.

The scan is no manifold and has pieces: that is no hindrance, homology is of any complex.
Run it with a folder for the picture: ``python 01_bunny_loops.py pictures``.
"""

# %% The mesh
import os
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

scan = Path(os.environ.get("COFACE_DATA", "nowhere")) / "surfaces/bunny.ply"
if scan.is_file():
    model = coface.read(scan)
    expected = (26, 4, 0)
else:
    print("COFACE_DATA has no surfaces/bunny.ply: a torus with two holes cut into it stands in")
    torus = coface.generate("torus", columns=40, rows=20)
    model = coface.Model.from_arrays(torus.vertices, np.delete(torus.faces, [0, 400], axis=0))
    expected = (1, 3, 0)
print(model)

# %% Its homology over the integers
homology = coface.homology(model, generators=True)
print(homology)
assert homology.betti_numbers == expected
assert all(group.torsion == () for group in homology)

# %% The loops are chains on the edges of the mesh; each is a cycle
complex = coface.as_chain_complex(model)
loops = homology[1].generators
for loop in loops:
    print(f"a loop of {len(loop)} edges, of {'infinite order' if loop.order is None else f'order {loop.order}'}")
    assert loop.order is None
    assert abs(complex.boundary(1) @ loop.as_vector()).sum() == 0

# %% They are no boundaries, and independent: the rank grows by one with each
boundaries = complex.boundary(2)
assert boundaries.shape[0] == loops[0].as_vector().shape[0]

# %% The picture
axes = coface.plot(model, generators=loops, view=(75.0, -90.0), title=f"H1 = {homology[1]}")
axes.figure.savefig(pictures / "bunny_loops.png", dpi=120)
assert (pictures / "bunny_loops.png").stat().st_size > 10_000
