"""The table "Booleans" of BENCHMARKS.md: unions in the plane and in space by coface and other programs, in one run.

Inputs are of three kinds, in the plane and in space: two smooth curves or surfaces of many edges or triangles (smooth), two regions of many small squares or
cubes (small), and many polygons or solids that lie over each other some twenty times (overlap). Each is made with n, 2n and 4n vertices or
triangles. Each tool unites each input in a process of its own; the tools take turns, and the median of the rounds counts. Reported are wall time, processor
time of all threads, how much memory grows at most, and the exponent of the growth from n to 4n. From arrays to arrays: making the input of a tool from arrays,
and arrays from its result, counts for all of them. Two programs in C++ and Rust are measured by their own word, from their own types to their own types:

    python booleans.py                                      all that is installed
    python booleans.py --clipper2 PROGRAM --i-overlay PROGRAM
    python booleans.py --kind plane-overlap --tool coface --tool shapely --rounds 3
    python booleans.py --size 0.01 --rounds 1               to see that it works

How those two are built is said in `crates/coface-bench/peers`. In the plane all coordinates are integers below 2^28, which all tools read alike.
"""

from __future__ import annotations

import argparse
import datetime
import importlib
import importlib.util
import json
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import compare  # noqa: E402

#: Seconds after which a tool has one run, and is not asked for larger inputs.
SLOW = 60.0
#: Coordinates in the plane are integers below this.
EXTENT = 2**28 - 1
#: A row: what is measured of one tool on one input.
Row = dict[str, Any]


# Inputs in the plane: for each operand its rings, counterclockwise.


def on_the_grid(operands: list[list[np.ndarray]]) -> list[list[np.ndarray]]:
    """The same with integer coordinates from 0 to 2^28."""
    points = np.concatenate([ring for rings in operands for ring in rings])
    low = points.min(axis=0)
    scale = EXTENT / (points.max(axis=0) - low).max()
    return [[np.rint((ring - low) * scale) for ring in rings] for rings in operands]


def two_curves(count: int) -> list[list[np.ndarray]]:
    """Two smooth closed curves of `count` vertices each."""
    angles = 2 * np.pi * np.arange(count) / count
    radii = 1 + 0.2 * np.sin(5 * angles) + 0.05 * np.sin(31 * angles) + 0.002 * np.sin(211 * angles)
    curve = radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    return on_the_grid([[curve], [curve @ turn(0.3) + [0.37, 0.13]]])


def two_grids(count: int) -> list[list[np.ndarray]]:
    """Two grids of squares of `count` vertices each, that cover half of the plane; the second is turned by half a radian."""
    side = max(round((count / 4) ** 0.5), 1)
    x, y = (axis.reshape(-1, 1, 1) for axis in np.meshgrid(np.arange(side), np.arange(side)))
    square = 0.7 * np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    squares = square + np.concatenate([x, y], axis=2) - side / 2
    return on_the_grid([list(squares), list(squares @ turn(0.5))])


def stars(count: int) -> list[list[np.ndarray]]:
    """Stars of 60 corners with `count` in all, an operand each, about twenty over each point."""
    random = np.random.default_rng(3)
    angles = 2 * np.pi * np.arange(60) / 60
    number = max(round(count / 60), 2)
    found = []
    for center in random.uniform(0, 0.32 * number**0.5, size=(number, 2)):
        radii = random.uniform(0.3, 1.2, size=60)
        found.append([center + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])])
    return on_the_grid(found)


def turn(angle: float) -> np.ndarray:
    return np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])


# Inputs in space: for each operand its vertices and triangles, oriented outward.


def two_surfaces(count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Two smooth tori of `count` triangles each."""
    points, faces = compare.torus(count / 180_000)
    ripple = 1 + 0.02 * np.sin(9 * points[:, :1]) * np.cos(7 * points[:, 1:2])
    points = points * ripple
    turned = points @ spatial_turn(0.4, 0.7) + [0.37, 0.2997, 0.148]
    return [(points, faces), (turned, faces)]


def two_blocks(count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Two blocks of cubes of `count` triangles each; cubes of one block do not touch, and the second block is turned."""
    side = max(round((count / 12) ** (1 / 3)), 1)
    cells = np.array(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), float).reshape(3, -1).T
    cube = 0.8 * np.array([[(i >> 2) & 1, (i >> 1) & 1, i & 1] for i in range(8)], float)
    points = (cells[:, None] + cube - side / 2).reshape(-1, 3)
    sides = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    triangles = np.concatenate([sides[:, [0, 1, 2]], sides[:, [0, 2, 3]]])
    faces = (triangles + 8 * np.arange(len(cells))[:, None, None]).reshape(-1, 3)
    return [(points, faces), (points @ spatial_turn(0.5, 0.3) + [0.21, 0.13, 0.34], faces)]


def balls(count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Balls of 80 triangles with `count` in all, an operand each, about twenty over each point."""
    random = np.random.default_rng(5)
    points, faces = compare.sphere(1)
    number = max(round(count / 80), 2)
    places = random.uniform(0, (0.21 * number) ** (1 / 3), size=(number, 3))
    radii = random.uniform(0.7, 1.3, size=number)
    return [(radius * points @ spatial_turn(*random.uniform(0, 3, size=2)) + place, faces) for place, radius in zip(places, radii)]


def spatial_turn(about_z: float, about_x: float) -> np.ndarray:
    first, second = np.eye(3), np.eye(3)
    first[:2, :2], second[1:, 1:] = turn(about_z), turn(about_x)
    return first @ second


# What the tools do.


def plane_coface(operands: Any) -> Any:
    import coface

    found = coface.boolean("union", *[region(rings) for rings in operands])
    points = found.vertices
    return [points[ring] for polygon in found.polygons for ring in polygon]


def region(rings: list[np.ndarray]) -> Any:
    import coface

    if len(rings) == 1:
        return coface.polygon(rings[0])
    points = np.concatenate(rings)
    return coface.Model.from_arrays(points, np.arange(len(points)).reshape(len(rings), -1))


def plane_shapely(operands: Any) -> Any:
    import shapely

    regions = [shapely.MultiPolygon([shapely.Polygon(ring) for ring in rings]) for rings in operands]
    found = shapely.union_all(regions) if len(regions) > 2 else shapely.union(*regions)
    parts = getattr(found, "geoms", [found])
    return [shapely.get_coordinates(ring)[:-1] for part in parts for ring in (part.exterior, *part.interiors)]


def plane_pyclipper(operands: Any) -> Any:
    import pyclipper

    clipper = pyclipper.Pyclipper()
    clipper.AddPaths([ring.astype(np.int64) for rings in operands for ring in rings], pyclipper.PT_SUBJECT, True)
    found = clipper.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    return [np.asarray(ring, float) for ring in found]


def space_coface(operands: Any) -> Any:
    import coface

    found = coface.boolean("union", *[coface.Model.from_arrays(*mesh) for mesh in operands], triangles=True).model
    return found.vertices, found.faces


def space_manifold3d(operands: Any) -> Any:
    import manifold3d

    solids = [manifold3d.Manifold(manifold3d.Mesh64(points, faces.astype(np.uint64))) for points, faces in operands]
    found = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add).to_mesh64()
    return found.vert_properties[:, :3], found.tri_verts


def space_trueform(operands: Any) -> Any:
    import trueform

    meshes = [trueform.Mesh(faces.astype(np.int32), points) for points, faces in operands]
    # It unites two at a time: neighbors, then what they became.
    while len(meshes) > 1:
        pairs = [trueform.boolean_union(a, b)[0] for a, b in zip(meshes[::2], meshes[1::2])]
        if len(meshes) == 2:
            return pairs[0][1], pairs[0][0]
        meshes = [trueform.Mesh(faces, points) for faces, points in pairs] + meshes[len(meshes) // 2 * 2 :]
    return operands[0]


def space_libigl(operands: Any) -> Any:
    from igl.copyleft import cgal

    none = np.empty((0, 3)), np.empty((0, 3), np.int64)
    meshes = [(points, faces.astype(np.int64)) for points, faces in operands]
    if len(meshes) > 2:
        # The union of a mesh that lies on itself with nothing.
        starts = np.cumsum([0] + [len(points) for points, _ in meshes])
        points = np.concatenate([points for points, _ in meshes])
        meshes = [(points, np.concatenate([faces + start for (_, faces), start in zip(meshes, starts)])), none]
    return cgal.mesh_boolean(*meshes[0], *meshes[1], type_str="union")[:2]


#: Tool -> the module that it needs, and what is to be said of it.
TOOLS: dict[str, tuple[str, str]] = {
    "coface": ("coface", "exact"),
    "shapely": ("shapely", "GEOS; floating point, cascaded"),
    "pyclipper": ("pyclipper", "Clipper 6; integers, crossings rounded"),
    "manifold3d": ("manifold3d", "floating point with perturbation"),
    "trueform": ("trueform", "rounded to a grid; many operands two at a time"),
    "libigl": ("igl", "exact, of CGAL"),
}
#: Programs that read the file and say themselves what they took.
PROGRAMS = {
    "clipper2": "C++; integers, crossings rounded; conversion not counted",
    "i_overlay": "Rust; integers, crossings rounded; conversion not counted",
}

#: Kind -> what it is, the usual n, what makes it, tool -> function, and what is compared of an answer.
KINDS: dict[str, tuple[str, int, Callable[[int], Any], dict[str, Callable[[Any], Any]], Callable[[Any], Any]]] = {}
PLANE = {"coface": plane_coface, "shapely": plane_shapely, "pyclipper": plane_pyclipper}
SPACE = {"coface": space_coface, "manifold3d": space_manifold3d, "trueform": space_trueform, "libigl": space_libigl}


def area_of(rings: Any) -> float:
    """The area within rings without their holes, which run the other way, in the unit of the extent."""
    return float(compare.area([np.asarray(ring) / EXTENT for ring in rings])[1])


def volume_of(mesh: Any) -> float:
    points, faces = np.asarray(mesh[0], float), np.asarray(mesh[1], np.int64)
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


KINDS["plane-smooth"] = ("two smooth curves, n vertices each", 100_000, two_curves, PLANE, area_of)
KINDS["plane-small"] = ("two grids of squares, n vertices each", 100_000, two_grids, PLANE, area_of)
KINDS["plane-overlap"] = ("stars of 60 corners, 20 over each point, n vertices in all", 60_000, stars, PLANE, area_of)
KINDS["space-smooth"] = ("two smooth tori, n triangles each", 82_000, two_surfaces, SPACE, volume_of)
KINDS["space-small"] = ("two blocks of cubes, n triangles each", 48_000, two_blocks, SPACE, volume_of)
KINDS["space-overlap"] = ("balls of 80 triangles, 20 over each point, n triangles in all", 8_000, balls, SPACE, volume_of)


# Measuring.


def memory(key: str) -> float:
    """What /proc says of the memory of this process (VmRSS, VmHWM), in MB; the most there was where there is no /proc."""
    try:
        with open("/proc/self/status", encoding="ascii") as file:
            return next(int(line.split()[1]) for line in file if line.startswith(key)) / 1024
    except (OSError, StopIteration):
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def child(kind: str, tool: str, count: int) -> None:
    _, _, make, tools, compared = KINDS[kind]
    operands = make(count)
    module = TOOLS[tool][0]
    importlib.import_module("igl.copyleft" if module == "igl" else module)
    try:
        # From here on the most memory is that of the work.
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
    except OSError:
        pass
    before, begin, begin_processor = memory("VmRSS"), time.perf_counter(), time.process_time()
    answer = tools[tool](operands)
    seconds, processor = time.perf_counter() - begin, time.process_time() - begin_processor
    grown = memory("VmHWM") - before
    print(json.dumps({"seconds": seconds, "processor": processor, "megabytes": grown, "measure": compared(answer)}))


def measure(words: list[str], limit: float) -> Row | str:
    """What a process says of its work, or why it says nothing."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return f"not done within {limit:g} s"
    except OSError as fault:
        return str(fault)
    if done.returncode:
        return (done.stderr.strip().splitlines() or [f"exit status {done.returncode}"])[-1]
    found = json.loads(done.stdout.strip().splitlines()[-1])
    if "processor" in found:
        return dict(found)
    # A program of crates/coface-bench/peers: its area is over 2^54, and memory that of the whole process.
    result = str(found.get("result", "")).split()
    area = float(result[result.index("area") + 1]) * 2.0**54 / EXTENT**2 if "area" in result else math.nan
    megabytes = found.get("peak_mb", math.nan)
    return {"seconds": found["seconds"], "processor": found["cpu_seconds"], "megabytes": megabytes, "measure": area}


def write_raw(operands: list[list[np.ndarray]], path: Path) -> None:
    """Rings as `coface-bench write` writes them: the third coordinate says whether a ring is of the first region or of the second.
    More operands than two are one region."""
    regions = [number if len(operands) == 2 else 0 for number, rings in enumerate(operands) for _ in rings]
    rings = [ring for own in operands for ring in own]
    starts = np.cumsum([0] + [len(ring) for ring in rings])
    points = np.concatenate([np.column_stack([ring, np.full(len(ring), float(of))]) for ring, of in zip(rings, regions)])
    with path.open("wb") as file:
        file.write(np.array([0, starts[-1], len(rings)], "<u4").tobytes())
        file.write(starts.astype("<u4").tobytes() + np.arange(starts[-1], dtype="<u4").tobytes())
        file.write(points.astype("<f8").tobytes())


def growth(points: list[tuple[float, float]]) -> float:
    """The exponent e of the power law value = c n^e that fits best, by least squares of logarithms; not a number for fewer than two."""
    logs = np.log([point for point in points if min(point) > 0 and not math.isnan(point[1])])
    if len(logs) < 2:
        return math.nan
    return float(np.polyfit(logs[:, 0], logs[:, 1], 1)[0])


def median(runs: list[Row]) -> Row:
    """The medians of times, the most memory, and the first measure."""
    found: Row = {key: statistics.median(run[key] for run in runs) for key in ("seconds", "processor")}
    return found | {"megabytes": max(run["megabytes"] for run in runs), "measure": runs[0]["measure"], "rounds": len(runs)}


def agree(tool: str, a: float, b: float) -> bool:
    """Whether measures are the same but for rounding; programs print five digits, or nothing."""
    if tool in PROGRAMS:
        return math.isnan(a) or abs(a - b) <= 2e-5
    return abs(a - b) <= 1e-5 * max(abs(a), abs(b))


def rows_of(kind: str, tools: dict[str, str], options: argparse.Namespace) -> list[Row]:
    """The rows of a kind: for n, 2n and 4n those of all tools, each printed when it is known."""
    words, usual, make, known, _ = KINDS[kind]
    own = [tool for tool in tools if tool in known or (tool in PROGRAMS and kind.startswith("plane"))]
    out: set[str] = set()
    found: list[Row] = []
    for times in (1, 2, 4):
        count = max(int(usual * options.size), 60) * times
        runs: dict[str, list[Row]] = {tool: [] for tool in own}
        faults: dict[str, str] = {}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "input.raw3"
            if any(tool in PROGRAMS for tool in own):
                write_raw(make(count), path)
            for _ in range(options.rounds):
                for tool in own:
                    if tool in out:
                        continue
                    program = [tools[tool], "union", str(path)]
                    python = [sys.executable, __file__, "--child", kind, tool, str(count)]
                    run = measure(program if tool in PROGRAMS else python, options.limit)
                    if isinstance(run, str):
                        faults[tool] = run
                        out.add(tool)
                        continue
                    runs[tool].append(run)
                    if run["seconds"] > SLOW:
                        out.add(tool)
        first: Row | None = None
        for tool in own:
            row: Row = {"kind": kind, "words": words, "tool": tool, "n": count}
            if runs[tool]:
                row |= median(runs[tool])
            elif tool in faults:
                row["fault"] = faults[tool]
            else:
                continue
            if tool == "coface":
                first = row
            print(line_of(row, first), flush=True)
            found.append(row)
    for tool in own:
        mine = [row for row in found if row["tool"] == tool and "seconds" in row]
        if len(mine) > 1:
            by = {key: growth([(row["n"], row[key]) for row in mine]) for key in ("seconds", "processor", "megabytes")}
            cells = " | ".join(f"n^{by[key]:.2f}" if not math.isnan(by[key]) else "-" for key in by)
            wall, processor, megabytes = cells.split(" | ")
            print(f"| {kind} | growth | {tool} | {wall} | | {processor} | | {megabytes} | | |", flush=True)
            found.append({"kind": kind, "tool": tool, "growth": by})
    return found


def line_of(row: Row, first: Row | None) -> str:
    """A line of the table; times over those of coface if it has some."""
    start = f"| {row['kind']} | {row['n']} | {row['tool']} |"
    if "fault" in row:
        return f"{start} failed: {row['fault']} | | | | | | |"
    ratios = ["", ""]
    beside = TOOLS[row["tool"]][1] if row["tool"] in TOOLS else PROGRAMS[row["tool"]]
    if first is not None and "seconds" in first:
        ratios = [f"{row[key] / first[key]:.2f}" for key in ("seconds", "processor")]
        if not agree(row["tool"], row["measure"], first["measure"]):
            beside += f"; **measure {row['measure']:.9g}, coface {first['measure']:.9g}**"
    if row["rounds"] == 1:
        beside += " (one run)"
    megabytes = "-" if math.isnan(row["megabytes"]) else f"{row['megabytes']:.0f}"
    measure = "-" if math.isnan(row["measure"]) else f"{row['measure']:.6g}"
    return (
        f"{start} {row['seconds']:.4f} | {ratios[0]} | {row['processor']:.4f} | {ratios[1]} | {megabytes} | {measure} | {beside} |"
    )


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kind", choices=sorted(KINDS), action="append", help="one kind of input; may be repeated")
    parser.add_argument("--tool", choices=[*TOOLS, *PROGRAMS], action="append", help="one tool; may be repeated")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--size", type=float, default=1.0, help="how many times the usual n")
    parser.add_argument("--limit", type=float, default=600.0, help="the most seconds of a process")
    parser.add_argument("--clipper2", metavar="PROGRAM", help="the program of crates/coface-bench/peers/clipper2.cpp")
    parser.add_argument("--i-overlay", metavar="PROGRAM", help="the program of crates/coface-bench/peers/i_overlay")
    parser.add_argument("--json", metavar="FILE", help="add each row to a file, one JSON object a line")
    parser.add_argument("--child", nargs=3, help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.child:
        child(options.child[0], options.child[1], int(options.child[2]))
        return 0
    programs = {"clipper2": options.clipper2, "i_overlay": options.i_overlay}
    tools: dict[str, str] = {}
    for tool in options.tool or [*TOOLS, *PROGRAMS]:
        if tool in PROGRAMS:
            if programs[tool]:
                tools[tool] = programs[tool]
            elif options.tool:
                print(f"{tool} needs --{tool.replace('_', '-')} PROGRAM: left out")
        elif importlib.util.find_spec(TOOLS[tool][0]) is not None:
            tools[tool] = TOOLS[tool][0]
        else:
            print(f"{tool} is not installed: left out")
    versions = ", ".join(f"{tool} {compare.version(tool)}" for tool in tools if tool in TOOLS)
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    print(f"{datetime.date.today()}, {compare.machine()}{load}; {options.rounds} rounds, size {options.size:g}; {versions}\n")
    kinds = options.kind or list(KINDS)
    for kind in kinds:
        print(f"* {kind}: {KINDS[kind][0]}")
    print("\n| input | n | tool | s | times coface | cpu s | times coface | MB | measure | beside |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    status = 0
    for kind in kinds:
        rows = rows_of(kind, tools, options)
        if any(row["tool"] == "coface" and "fault" in row for row in rows):
            status = 1
        if options.json:
            with open(options.json, "a", encoding="utf-8") as file:
                file.writelines(json.dumps(row) + "\n" for row in rows)
    return status


if __name__ == "__main__":
    sys.exit(main())
