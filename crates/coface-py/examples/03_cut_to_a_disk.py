"""A kitten cut open to a disk along a short cut graph: what texture mapping begins with."""

# %% A closed surface with a handle
import os
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

folder = Path(os.environ.get("COFACE_DATA", "nowhere")) / "surfaces"
names = [name for name in ["kitten.off", "kitten.obj", "kitten.ply"] if (folder / name).is_file()]
if names:
    model = coface.read(folder / names[0])
else:
    print("COFACE_DATA has no surfaces/kitten: a bent torus stands in")
    torus = coface.generate("torus", columns=60, rows=24)
    x, y, z = np.asarray(torus.vertices).T
    model = coface.Model.from_arrays(np.column_stack([x, y, z + 0.3 * x * np.abs(x)]), torus.faces)
report = model.report()
print(report)
assert report.genus == 1 and report.closed

# %% Cut
cut = coface.cut(model)
(domain,) = cut.components
print(cut)
assert domain["euler_characteristic"] == 1
assert domain["boundary_edges"] == 2 * domain["cut_edges"]

# %% The cut surface is a disk: one component, one boundary loop, no homology but of a point
disk = cut.model
assert disk.report().name == "disk"
assert coface.homology(disk).betti_numbers == (1, 0, 0)
# Its faces are the faces there were, and each of its vertices lies on one of the surface.
assert len(disk) == len(model)
sources = {(name, on): values for name, on, values in disk.data}
assert np.array_equal(disk.vertices, model.vertices[sources["source", "vertices"]])

# %% The cut graph carries the loops: its first Betti number is twice the genus
graph = coface.Model.from_arrays(cells={"line": sources["source", "lines"]}, vertices=model.vertices)
used = np.unique(graph.lines)
assert 1 - (len(used) - len(graph.edges)) == 2 * report.genus

# %% The picture
axes = coface.plot(model, alpha=0.9, edges=False, title=f"{domain['cut_edges']} edges cut")
coface.plot(graph, ax=axes)
axes.figure.savefig(pictures / "cut.png", dpi=120)
