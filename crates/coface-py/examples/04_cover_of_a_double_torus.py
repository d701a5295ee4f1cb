"""The universal cover of a double torus: copies of its fundamental domain, laid out in the Poincare disk."""

# %% A double torus cut to an octagon
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

surface = coface.generate("genus", genus=2)
report = surface.report()
print(report.name)
assert report.genus == 2

# %% Its fundamental group
(group,) = coface.pi1(surface)
print(group)
assert group.name == "orientable surface group of genus 2"

# %% Copies up to two letters away: 8 neighbors across the 8 sides, 56 behind them
cover = coface.cover(surface, radius=2)
print(cover)
assert tuple(cover.spheres) == (1, 8, 56)
assert cover.copies == 65
assert cover.euler_characteristic == 1

# %% What is built of it is a disk, and lies over the surface face by face
model = cover.model
assert coface.homology(model).betti_numbers == (1, 0, 0)
assert len(model) == 65 * len(surface)
below = {(name, on): values for name, on, values in model.data}
assert np.array_equal(np.bincount(below["face", "faces"]), np.full(len(surface), 65))

# %% The picture: each copy in a shade of its own
copies = below["copy", "faces"]
axes = coface.plot(model, values=copies % 9, edges=False, title="65 copies in the Poincare disk")
axes.figure.savefig(pictures / "cover.png", dpi=120)
