"""A region with a curved boundary and kinks: edited, combined, drawn."""

# %% A drop: a smooth curve with one kink
import sys
from pathlib import Path

import numpy as np

import coface

pictures = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures.mkdir(parents=True, exist_ok=True)

angle = np.linspace(0, 2 * np.pi, 48, endpoint=False)
points = np.column_stack([np.cos(angle), np.sin(angle) * np.sin(angle / 2) ** 2])
drop = coface.YinSet.from_rings([points], order=4, kinks=[(0, 0)])
print(drop)
assert drop.is_bounded and drop.betti_open == [1, 0]
assert drop.kinks.knots.tolist() == [[0, 0]]

# %% A disk, smooth all around: its area is that of the circle to the fourth order
circle = np.column_stack([np.cos(angle), np.sin(angle)]) * 0.6 + [0.1, 0.25]
disk = coface.YinSet.from_rings([circle], order=4)
assert abs(disk.area - np.pi * 0.36) < 1e-5

# %% Boolean algebra: areas add up
meet, join = drop & disk, drop | disk
assert abs(meet.area + join.area - drop.area - disk.area) < 1e-9
# Where the boundaries cross, the results have kinks.
assert len(meet.kinks) >= 2

# %% The complement is unbounded, and its complement is the set
outside = ~drop
assert not outside.is_bounded
assert (~outside).area == drop.area

# %% The picture
from matplotlib import pyplot  # noqa: E402

figure, panels = pyplot.subplots(2, 2, figsize=(10, 8))
for axes, (name, region) in zip(panels.flat, {"a drop": drop, "a disk": disk, "meet": meet, "join": join}.items()):
    coface.plot(region, ax=axes, title=name)
figure.savefig(pictures / "yin_set.png", dpi=120)
