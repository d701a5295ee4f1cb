"""Peer of the tasks `overlay-intersection` and `overlay-union`: GEOS by shapely.

Usage: overlay.py intersection|union FILE.raw3

The polygons are made and checked before the clock.

    coface-bench compare overlay-union coast_100000 --peer 'geos=python3 crates/coface-bench/peers/overlay.py union {}'
"""

import json
import resource
import sys
import time

import numpy
import shapely

operation, path = sys.argv[1:]
data = numpy.fromfile(path, dtype="<u4")
arity, vertex_count, count = (int(number) for number in data[:3])
if arity > 0:
    starts, first = numpy.arange(0, arity * count + 1, arity), 3
else:
    starts, first = data[3 : 4 + count].astype(numpy.int64), 4 + count
members = data[first : first + starts[count]]
points = data[first + starts[count] :].view("<f8").reshape(vertex_count, 3)
regions = [[], []]
for ring in range(count):
    corners = points[members[starts[ring] : starts[ring + 1]]]
    regions[int(corners[0, 2])].append(shapely.Polygon(corners[:, :2]))
a, b = (shapely.MultiPolygon(polygons) if len(polygons) > 1 else polygons[0] for polygons in regions)

begin, begin_cpu = time.perf_counter(), time.process_time()
found = shapely.union(a, b) if operation == "union" else shapely.intersection(a, b)
seconds, cpu_seconds = time.perf_counter() - begin, time.process_time() - begin_cpu
parts = shapely.get_num_geometries(found)
print(
    json.dumps(
        {
            "seconds": seconds,
            "cpu_seconds": cpu_seconds,
            "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
            "size": vertex_count,
            "result": f"polygons {parts} vertices {shapely.get_num_coordinates(found)} area {found.area / 2**54:.5f}",
        }
    )
)
