"""Peer of the tasks `spatial-row`, `spatial-block`, `spatial-dolls`, `spatial-rooms` and `spatial-chain`: manifold3d.

Usage: boxes.py union|chain FILE.raw3

The file holds boxes of eight vertices and twelve triangles. union: the union of all, in floating point; chain: the next box
united with what is there and cut away from it in turns, as the task has it. Importing the boxes is left out of the clock.

Prints one JSON line with the seconds of the work alone, as `coface-bench compare` reads it:

    coface-bench compare spatial-row boxrow_100000 --runs 3 \
        --peer 'manifold=python3 crates/coface-bench/peers/boxes.py union {}'
"""

import json
import resource
import sys
import time

import manifold3d
import numpy


def read(path):
    """The boxes of a raw3 file of triangles as manifolds."""
    data = numpy.fromfile(path, dtype="<u4")
    arity, vertex_count, count = (int(number) for number in data[:3])
    triangles = data[3 : 3 + arity * count].reshape(-1, 12, arity)
    points = data[3 + arity * count :].view("<f8").reshape(-1, 8, 3)
    first = triangles[0].astype(numpy.uint64)
    return [manifold3d.Manifold(manifold3d.Mesh64(numpy.ascontiguousarray(own), first)) for own in points]


def union(boxes):
    return manifold3d.Manifold.batch_boolean(boxes, manifold3d.OpType.Add)


def chain(boxes):
    solid = boxes[0]
    for i, box in enumerate(boxes[1:], 1):
        solid = solid + box if i % 2 == 1 else solid - box
        # Results are made when they are asked for.
        solid.num_tri()
    return solid


def main():
    operation, path = sys.argv[1:]
    boxes = read(path)
    for box in boxes:
        box.volume()
    begin, begin_cpu = time.perf_counter(), time.process_time()
    result = {"union": union, "chain": chain}[operation](boxes)
    volume, count = result.volume(), result.num_tri()
    seconds, cpu_seconds = time.perf_counter() - begin, time.process_time() - begin_cpu
    print(
        json.dumps(
            {
                "seconds": seconds,
                "cpu_seconds": cpu_seconds,
                "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
                "size": 12 * len(boxes),
                "result": f"volume {volume:.9f} F {count}",
            }
        )
    )


main()
