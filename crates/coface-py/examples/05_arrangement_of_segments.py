"""What segments cut the plane into, and polygons space: exactly, with the inputs that contain each cell."""

# %% Unstructured segments
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

random = np.random.default_rng(2)
ends = random.random((40, 2, 2))
segments = coface.Model.from_arrays(ends.reshape(-1, 2), cells={"line": np.arange(80).reshape(-1, 2)})
plane = coface.arrange(segments)
print(plane)

# %% Euler: V - E + F is one more than the number of components
v, e, f = plane.f_vector
# With all faces filled nothing is left but the parts that no face lies around.
betti = coface.homology(plane.chain_complex()).betti_numbers
assert v - e + f == plane.components
assert 1 <= betti[0] <= plane.components and list(betti[1:]) == [0, 0]
# The measures of the bounded faces are areas.
areas = np.asarray(plane.measures)
assert len(areas) == f and (areas > 0).all() and areas.sum() < 1.0

# %% The picture
axes = coface.plot(plane, title=f"{f} faces of 40 segments")
axes.figure.savefig(pictures / "arrangement.png", dpi=120)

# %% Two cubes that overlap: three cells in space, and which cube contains each
cube = coface.generate("box", boundary=True)
moved = coface.Model.from_arrays(cube.vertices + 0.5, cube.faces)
space = coface.arrange(cube, moved)
print(space)
assert space.f_vector[3] == 3
by_inputs = {tuple(inside): measure for inside, measure in zip(space.inside, space.measures)}
assert np.isclose(by_inputs[(0, 1)], 0.125)
assert np.isclose(by_inputs[(0,)], 0.875) and np.isclose(by_inputs[(1,)], 0.875)

# %% The same by formulas
assert np.isclose(coface.boolean("intersection", cube, moved).measure, 0.125)
assert np.isclose(coface.boolean("(a | b) - (a & b)", cube, moved).measure, 1.75)
