"""Peers of the tasks `solid-union` and `solid-intersection`: two closed meshes of triangles.

Usage: solids.py manifold|libigl union|intersection FILE.raw3

The file holds both meshes, the first half of the vertices and triangles being the first one. manifold: the manifold3d
Boolean in floating point; importing the meshes is left out of the clock, as it costs more than the Boolean. libigl:
mesh_boolean with exact arithmetic, from arrays.

Prints one JSON line with the seconds of the work alone, as `coface-bench compare` reads it:

    coface-bench compare solid-union spheres6 --runs 5 \
        --peer 'manifold=python3 crates/coface-bench/peers/solids.py manifold union {}'
"""

import json
import resource
import sys
import time

import numpy


def read(path):
    """The two meshes of a raw3 file of triangles: vertices and triangles of each."""
    data = numpy.fromfile(path, dtype="<u4")
    arity, vertex_count, count = (int(number) for number in data[:3])
    triangles = data[3 : 3 + arity * count].reshape(count, arity)
    points = data[3 + arity * count :].view("<f8").reshape(vertex_count, 3)
    half = vertex_count // 2
    first, second = triangles[: count // 2], triangles[count // 2 :] - half
    return [(points[:half], first), (points[half:], second)]


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return float(numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6)


def manifold_work(meshes, operation):
    import manifold3d

    solids = [
        manifold3d.Manifold(
            manifold3d.Mesh64(numpy.ascontiguousarray(points), numpy.ascontiguousarray(triangles, dtype=numpy.uint64))
        )
        for points, triangles in meshes
    ]
    for solid in solids:
        solid.volume()

    def work():
        result = solids[0] + solids[1] if operation == "union" else solids[0] ^ solids[1]
        return result.volume(), result.num_tri()

    return work


def libigl_work(meshes, operation):
    from igl.copyleft import cgal

    arrays = [array for points, triangles in meshes for array in (points.copy(), triangles.astype(numpy.int64))]
    name = "union" if operation == "union" else "intersect"

    def work():
        points, triangles = cgal.mesh_boolean(*arrays, name)[:2]
        return volume_of(points, triangles), len(triangles)

    return work


def main():
    program, operation, path = sys.argv[1:]
    meshes = read(path)
    work = {"manifold": manifold_work, "libigl": libigl_work}[program](meshes, operation)
    begin, begin_cpu = time.perf_counter(), time.process_time()
    volume, count = work()
    seconds, cpu_seconds = time.perf_counter() - begin, time.process_time() - begin_cpu
    print(
        json.dumps(
            {
                "seconds": seconds,
                "cpu_seconds": cpu_seconds,
                "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
                "size": sum(len(triangles) for _, triangles in meshes),
                "result": f"volume {volume:.12g} F {count}",
            }
        )
    )


main()
