"""Vietoris-Rips persistence of Ripser's example files: coface on one thread and on two, beside Ripser and ripser.py.

    git clone https://github.com/Ripser/ripser && (cd ripser && git checkout 01add51)   # MIT License, examples too
    c++ -std=c++11 -O3 -D NDEBUG ripser/ripser.cpp -o ripser/ripser
    pip install ripser                                                                   # MIT License
    python crates/coface-bench/peers/rips.py ripser target/release/coface

Each run is a process of its own, one after the other; the numbers of classes must be the same. Times are seconds by the clock and of processor time, memory is the peak in MB.
"""

import json
import os
import subprocess
import sys
import tempfile
import time

# File, how it is read, highest degree, threshold: those of the paper of Ripser (U. Bauer, 2021), table 2; without one it is the enclosing radius.
CASES = [
    ("random16.lower_distance_matrix", "lower", 7, None),
    ("sphere_3_192.lower_distance_matrix", "lower", 2, None),
    ("rp2_600.lower_distance_matrix.csv", "lower", 2, None),
    ("o3_1024.txt", "points", 3, 1.8),
    ("o3_4096.txt", "points", 3, 1.4),
]

RIPSER_PY = """
import sys, numpy as np, ripser
path, kind, degree, threshold = sys.argv[1], sys.argv[2], int(sys.argv[3]), float(sys.argv[4])
numbers = np.array(open(path).read().replace(",", " ").split(), dtype=float)
if kind == "points":
    given = np.loadtxt(path)
else:
    count = int(round((1 + (1 + 8 * len(numbers)) ** 0.5) / 2))
    given = np.zeros((count, count))
    given[np.tril_indices(count, -1)] = numbers
    given += given.T
found = ripser.ripser(given, maxdim=degree, distance_matrix=kind != "points", thresh=threshold)
print([len(one) for one in found["dgms"]])
"""


def run(command: list[str]) -> tuple[str, float, float, float]:
    """What a command prints, its seconds by the clock and of the processor, and its peak memory in MB."""
    with tempfile.TemporaryFile("w+") as out:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        if status != 0:
            raise SystemExit(f"{' '.join(command)} ended with status {status}")
        out.seek(0)
        return out.read(), seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def of_coface(text: str, degrees: int) -> list[int]:
    """The number of classes of each degree."""
    degree = [pair["degree"] for pair in json.loads(text)["diagram"]]
    return [degree.count(k) for k in range(degrees)]


def of_ripser(text: str, degrees: int) -> list[int]:
    """The number of classes of each degree."""
    counts: list[int] = []
    for line in text.splitlines():
        if line.startswith("persistence intervals"):
            counts.append(0)
        elif line.startswith(" ["):
            counts[-1] += 1
    return counts[:degrees]


def main() -> None:
    """Prints a row for each file and program."""
    folder, coface = sys.argv[1], os.path.abspath(sys.argv[2])
    print("| file | degree | threshold | program | seconds | cpu s | peak MB | classes |\n|---|---|---|---|---|---|---|---|")
    for name, kind, degree, threshold in CASES:
        path = os.path.join(folder, "examples", name)
        bound = [] if threshold is None else ["--threshold", str(threshold)]
        words = [coface, "persistence", path, "--rips", "--distances", kind, "--dimension", str(degree), "--json", "-q", *bound]
        form = "point-cloud" if kind == "points" else "lower-distance"
        theirs = [os.path.join(folder, "ripser"), path, "--dim", str(degree), "--format", form, *bound]
        of_python = [sys.executable, "-c", RIPSER_PY, path, kind, str(degree), str(threshold or "inf")]
        programs = [
            ("coface, 1 thread", [*words, "--threads", "1"], of_coface),
            ("ripser", theirs, of_ripser),
            ("coface, 2 threads", [*words, "--threads", "2"], of_coface),
            ("ripser.py", of_python, lambda text, _: json.loads(text)),
        ]
        expected = None
        for program, command, counts in programs:
            text, seconds, cpu, memory = run(command)
            found = counts(text, degree + 1)
            if expected not in (None, found):
                raise SystemExit(f"{name}: {program} finds {found}, and {expected} was found before")
            expected = found
            shown = ", ".join(str(count) for count in found)
            print(f"| {name} | {degree} | {threshold or 'radius'} | {program} | {seconds:.2f} | {cpu:.2f} | {memory:.0f} | {shown} |", flush=True)


main()
