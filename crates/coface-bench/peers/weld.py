"""Peers of the task `weld`: classes of points within a tolerance.

Usage: weld.py scipy|open3d FILE.raw3

scipy: all pairs within the tolerance by cKDTree, then connected components. open3d: merge_close_vertices. Both go by
true distance.

Prints one JSON line with the seconds of the work alone, as `coface-bench compare` reads it:

    coface-bench compare weld soup7 --runs 5 --peer 'scipy=python3 crates/coface-bench/peers/weld.py scipy {}'
"""

import json
import resource
import sys
import time

import numpy

TOLERANCE = 1e-6


def read(path):
    """The coordinates and the polygons of a raw3 file whose polygons have one size."""
    data = numpy.fromfile(path, dtype="<u4")
    arity, vertex_count, count = (int(number) for number in data[:3])
    polygons = data[3 : 3 + arity * count].reshape(count, arity)
    coordinates = data[3 + arity * count :].tobytes()
    return numpy.frombuffer(coordinates, dtype="<f8").reshape(vertex_count, 3), polygons


def scipy_classes(points, _polygons):
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    def work():
        pairs = cKDTree(points).query_pairs(TOLERANCE, output_type="ndarray")
        ones = numpy.ones(len(pairs), dtype=numpy.int8)
        graph = coo_matrix((ones, (pairs[:, 0], pairs[:, 1])), shape=(len(points), len(points)))
        return connected_components(graph, directed=False)[0]

    return work


def open3d_classes(points, polygons):
    import open3d

    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(points.copy()), open3d.utility.Vector3iVector(polygons.astype(numpy.int32))
    )
    return lambda: len(mesh.merge_close_vertices(TOLERANCE).vertices)


def main():
    program, path = sys.argv[1:]
    points, polygons = read(path)
    work = {"scipy": scipy_classes, "open3d": open3d_classes}[program](points, polygons)
    begin, begin_cpu = time.perf_counter(), time.process_time()
    classes = work()
    seconds, cpu_seconds = time.perf_counter() - begin, time.process_time() - begin_cpu
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        json.dumps(
            {
                "seconds": seconds,
                "cpu_seconds": cpu_seconds,
                "peak_mb": peak,
                "size": len(points),
                "result": f"points {len(points)} classes {classes}",
            }
        )
    )


main()
