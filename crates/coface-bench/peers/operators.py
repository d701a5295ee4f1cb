"""Peer of the tasks `operator-ff` and `operator-vv`: sparse products of SciPy.

Usage: operators.py FF|VV FILE.raw

The characteristic matrix is made before the clock. FF keeps entries from 2 on; the diagonal does not count as a pair.

    coface-bench compare operator-ff cuboid_faces_100 --peer 'scipy=python3 crates/coface-bench/peers/operators.py FF {}'
"""

import json
import resource
import sys
import time

import numpy
from scipy.sparse import csr_matrix

operator, path = sys.argv[1:]
data = numpy.fromfile(path, dtype="<u4")
arity, vertex_count, count = (int(number) for number in data[:3])
columns = data[3 : 3 + arity * count].astype(numpy.int32)
starts = numpy.arange(0, arity * count + 1, arity, dtype=numpy.int32)
cells = csr_matrix((numpy.ones(arity * count, dtype=numpy.int32), columns, starts), shape=(count, vertex_count))
transposed = cells.T.tocsr()

begin, begin_cpu = time.perf_counter(), time.process_time()
if operator == "FF":
    product = cells @ transposed
    product.data[product.data < 2] = 0
    product.eliminate_zeros()
else:
    product = transposed @ cells
seconds, cpu_seconds = time.perf_counter() - begin, time.process_time() - begin_cpu
pairs = product.nnz - numpy.count_nonzero(product.diagonal())
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(
    json.dumps(
        {
            "seconds": seconds,
            "cpu_seconds": cpu_seconds,
            "peak_mb": peak,
            "size": count,
            "result": f"pairs {pairs}",
        }
    )
)
