"""Long calls let other threads work, say how far they are, and end when they are asked to."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import coface

#: A grid whose homology takes a while, in its sides.
SIDES = 48

# A program that was started in the background may ignore the signal, and so do those that it starts.
WORK = f"""
import coface, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
model = coface.generate("cuboids", shape=[{SIDES}, {SIDES}, {SIDES}])
print("ready", flush=True)
try:
    for _ in range(10_000):
        coface.homology(coface.generate("cuboids", shape=[{SIDES}, {SIDES}, {SIDES}]))
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(7)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_ends_a_long_call() -> None:
    with subprocess.Popen([sys.executable, "-c", WORK], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline().strip() == "ready"
        time.sleep(0.5)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        try:
            process.wait(timeout=60)
        finally:
            process.kill()
        taken = time.monotonic() - begin
        assert process.stdout.read().strip() == "interrupted"
    assert process.returncode == 7
    assert taken < 2.0


def grid():
    return coface.generate("cuboids", shape=[SIDES, SIDES, SIDES])


def test_progress_is_told() -> None:
    seen: list[tuple[str, int, int]] = []
    found = coface.homology(grid(), progress=lambda stage, done, total: seen.append((stage, done, total)))
    assert list(found.betti_numbers) == [1, 0, 0, 0]
    assert seen, "the call took less than the period between two looks"
    for stage, done, total in seen:
        assert stage and isinstance(stage, str)
        assert 0 <= done and (total == 0 or done <= total)


def test_a_fault_in_progress_ends_the_call() -> None:
    def refuse(stage: str, done: int, total: int) -> None:
        raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        coface.homology(grid(), progress=refuse)


def test_a_bar_is_shown(capsys) -> None:
    found = coface.homology(grid(), progress=True)
    assert list(found.betti_numbers) == [1, 0, 0, 0]


def test_other_threads_work_meanwhile() -> None:
    counted = 0
    is_done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not is_done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    begin = time.monotonic()
    coface.homology(grid())
    taken = time.monotonic() - begin
    seen = counted
    is_done.set()
    other.join()
    # A thread that had to wait for the call would have counted once or twice.
    assert seen > 5, f"{seen} steps in {taken:.2f} s"


def test_eight_threads_have_one_answer(spot) -> None:
    model = coface.read(spot)

    def ask(_: int) -> tuple[object, ...]:
        complex = coface.as_chain_complex(model)
        found = coface.homology(complex, generators=True)
        report = model.report()
        return (
            str(found),
            complex.boundary(2).indices.tobytes(),
            report.signed_volume,
            report.name,
            str(report.to_dict()),
        )

    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(ask, range(16)))
    assert all(answer == answers[0] for answer in answers)
    assert answers[0][3] == "sphere"
    assert np.isclose(float(answers[0][2]), 0.718258788)


def test_small_calls_start_no_threads() -> None:
    disc = coface.YinSet.from_rings([[(0, 0), (1, 0), (1, 1), (0, 1)]])
    seen = set()

    def flow(points, time):
        seen.add(threading.get_native_id())
        return np.zeros_like(points)

    for _ in range(3 * (os.cpu_count() or 1)):
        disc.advected(flow, 0.1, spacing=0.5)
    # A flow is tried here first.
    others = seen - {threading.get_native_id()}
    assert 1 <= len(others) <= (os.cpu_count() or 1), "each call had a thread of its own"


def test_a_call_within_a_call_has_threads(torus) -> None:
    disc = coface.YinSet.from_rings([[(0, 0), (1, 0), (1, 1), (0, 1)]])
    complex = coface.as_complex(torus)
    seen = set()

    def flow(points, time):
        seen.add(str(coface.homology(complex)[1]))
        return np.zeros_like(points)

    disc.advected(flow, 0.1, spacing=0.5)
    assert seen == {"Z^2"}


def test_processes_have_one_answer(torus) -> None:
    import multiprocessing

    for way in ["fork", "spawn"]:
        if way not in multiprocessing.get_all_start_methods():
            continue
        with multiprocessing.get_context(way).Pool(2) as pool:
            answers = pool.map(names, [coface.as_complex(torus)] * 4, chunksize=1)
        assert answers == ["Z^2"] * 4, way


def names(complex: coface.Complex) -> str:
    return str(coface.homology(complex)[1])
