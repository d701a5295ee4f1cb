"""GUDHI's cubical complex on a volume of `coface-bench`, Betti numbers over Z/11 of the voxels that are not 0.

pip install gudhi numpy; then
coface-bench compare volume gyroid_128 --peer 'GUDHI=python crates/coface-bench/peers/gudhi_cubical/volume.py {}'
coface-bench compare parts-torus torus_128x64 --peer 'GUDHI=python crates/coface-bench/peers/gudhi_cubical/volume.py {}'
"""

import json
import resource
import sys
import time

import gudhi
import numpy

path = sys.argv[1]
periodic = None
if path.endswith(".npy"):
    voxels = numpy.load(path)
else:
    side = int(open(path).read().removeprefix("torus_").split("x")[0])
    voxels = numpy.ones((side, side, side), dtype=numpy.uint8)
    periodic = [True] * 3
values = numpy.where(voxels != 0, 0.0, numpy.inf)
before = time.perf_counter()
cpu_before = time.process_time()
if periodic is None:
    cells = gudhi.CubicalComplex(top_dimensional_cells=values)
else:
    cells = gudhi.PeriodicCubicalComplex(top_dimensional_cells=values, periodic_dimensions=periodic)
cells.compute_persistence(homology_coeff_field=11, min_persistence=0)
betti = cells.persistent_betti_numbers(0.0, 1.0)
seconds = time.perf_counter() - before
print(
    json.dumps(
        {
            "seconds": seconds,
            "cpu_seconds": time.process_time() - cpu_before,
            "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
            "result": "betti " + " ".join(str(number) for number in betti),
        }
    )
)
