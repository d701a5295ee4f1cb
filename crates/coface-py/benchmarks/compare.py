"""coface beside gudhi, gmsh, trimesh, shapely and manifold3d on the same inputs.

Each tool answers each question in a process of its own; processes of both sides take turns, so that a busy minute hits both. Reported are the
least time of each, their ratio, and the peak of resident memory over that of the process before the question. Making the input of a tool from
arrays counts as part of its work: that is what a user waits for. Answers are compared; questions are not always the same, and the column
"beside" says where they differ.

    python compare.py                 all that is installed
    python compare.py --case solids   one question
    python compare.py --rounds 5 --size 2
"""

from __future__ import annotations

import argparse
import datetime
import importlib.util
import json
import os
import platform
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

#: Seconds after which a tool has one run.
SLOW = 30.0
#: Question -> what it is, and tool -> function of the input that gives the answer.
CASES: dict[str, tuple[str, dict[str, Callable[[Any], Any]], Callable[[float], Any]]] = {}


def case(name: str, words: str, make: Callable[[float], Any], **tools: Callable[[Any], Any]) -> None:
    CASES[name] = (words, tools, make)


# Betti numbers of triangulated surfaces.


def torus(size: float) -> tuple[np.ndarray, np.ndarray]:
    """A torus of 2 n^2 triangles."""
    n = int(300 * size**0.5)
    i, j = (axis.reshape(-1) for axis in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / n
    points = np.column_stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)])
    a, b, c, d = i * n + j, (i + 1) % n * n + j, (i + 1) % n * n + (j + 1) % n, i * n + (j + 1) % n
    return points, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def betti_coface(mesh: Any) -> Any:
    import coface

    return list(coface.homology(coface.Model.from_arrays(mesh[0], mesh[1])).betti_numbers)


def betti_gudhi(mesh: Any) -> Any:
    import gudhi

    tree = gudhi.SimplexTree()
    tree.insert_batch(np.ascontiguousarray(mesh[1].T).astype(np.int32), np.zeros(len(mesh[1])))
    tree.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return tree.betti_numbers()


def betti_gmsh(mesh: Any) -> Any:
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    points, faces = mesh
    surface = gmsh.model.addDiscreteEntity(2)
    gmsh.model.mesh.addNodes(2, surface, np.arange(1, len(points) + 1), points.reshape(-1))
    gmsh.model.mesh.addElementsByType(surface, 2, [], (faces + 1).reshape(-1))
    gmsh.model.mesh.addHomologyRequest("Homology", dims=[0, 1, 2])
    gmsh.model.mesh.computeHomology()
    groups = [0, 0, 0]
    for dimension, tag in gmsh.model.getPhysicalGroups():
        groups[dimension] += 1
    gmsh.finalize()
    return groups


case("surface", "Betti numbers of a torus, 180,000 triangles", torus, coface=betti_coface, gudhi=betti_gudhi, gmsh=betti_gmsh)


# Betti numbers of solids.


def cube(size: float) -> tuple[np.ndarray, np.ndarray]:
    """A cube of 5 n^3 tetrahedra with a chain of cavities left out, in alternating cells."""
    n = int(24 * size ** (1 / 3))
    axis = np.arange(n + 1)
    points = np.array(np.meshgrid(axis, axis, axis, indexing="ij"), float).reshape(3, -1).T
    corner = lambda p: (p[..., 0] * (n + 1) + p[..., 1]) * (n + 1) + p[..., 2]  # noqa: E731
    cells = np.array(np.meshgrid(*[np.arange(n)] * 3, indexing="ij")).reshape(3, -1).T
    keep = ~((cells % 4 == 1).all(axis=1))
    cells = cells[keep]
    even = np.array([[0, 3, 5, 6], [0, 1, 3, 5], [0, 2, 3, 6], [0, 4, 5, 6], [3, 5, 6, 7]])
    odd = np.array([[1, 2, 4, 7], [0, 1, 2, 4], [1, 2, 3, 7], [1, 4, 5, 7], [2, 4, 6, 7]])
    offsets = np.array([[(k >> 2) & 1, (k >> 1) & 1, k & 1] for k in range(8)])
    corners = corner(cells[:, None, :] + offsets)
    parity = cells.sum(axis=1) % 2
    tetrahedra = np.concatenate([corners[parity == 0][:, even].reshape(-1, 4), corners[parity == 1][:, odd].reshape(-1, 4)])
    return points, tetrahedra


def betti_of_solid_coface(mesh: Any) -> Any:
    import coface

    return list(coface.homology(coface.Model.from_arrays(mesh[0], cells={"tetra": mesh[1]})).betti_numbers)[:3]


def betti_of_solid_gmsh(mesh: Any) -> Any:
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    points, cells = mesh
    volume = gmsh.model.addDiscreteEntity(3)
    gmsh.model.mesh.addNodes(3, volume, np.arange(1, len(points) + 1), points.reshape(-1))
    gmsh.model.mesh.addElementsByType(volume, 4, [], (cells + 1).reshape(-1))
    gmsh.model.mesh.addHomologyRequest("Homology", dims=[0, 1, 2])
    gmsh.model.mesh.computeHomology()
    groups = [0, 0, 0]
    for dimension, tag in gmsh.model.getPhysicalGroups():
        if dimension < 3:
            groups[dimension] += 1
    gmsh.finalize()
    return groups


def betti_of_solid_gudhi(mesh: Any) -> Any:
    return betti_gudhi(mesh)[:3]


case(
    "solid",
    "Betti numbers of a cube with cavities, 68,000 tetrahedra",
    cube,
    coface=betti_of_solid_coface,
    gudhi=betti_of_solid_gudhi,
    gmsh=betti_of_solid_gmsh,
)


# What a mesh is.


def report_coface(mesh: Any) -> Any:
    import coface

    report = coface.Model.from_arrays(*mesh).report()
    return [report.euler_characteristic, report.closed, report.components, round(report.signed_volume, 6)]


def report_trimesh(mesh: Any) -> Any:
    import trimesh

    found = trimesh.Trimesh(*mesh, process=False)
    return [int(found.euler_number), bool(found.is_watertight), int(found.body_count), round(float(found.volume), 6)]


case("report", "what a torus of 180,000 triangles is", torus, coface=report_coface, trimesh=report_trimesh)


# Lower star persistence.


def persistence_coface(mesh: Any) -> Any:
    import coface

    values = heights(mesh)
    found = coface.persistence(coface.Model.from_arrays(*mesh), values)
    return [len(np.asarray(found.diagram(degree))) for degree in range(3)]


def heights(mesh: Any) -> np.ndarray:
    return np.sin(3 * mesh[0][:, 0]) + np.cos(5 * mesh[0][:, 1]) + mesh[0][:, 2]


def persistence_gudhi(mesh: Any) -> Any:
    import gudhi

    values = heights(mesh)
    tree = gudhi.SimplexTree()
    # A row as the transpose of a column: of other layouts gudhi 3.13 reads other values.
    tree.insert_batch(np.ascontiguousarray(np.arange(len(values), dtype=np.int32).reshape(-1, 1).T), values)
    faces = np.sort(mesh[1], axis=1)
    edges = np.unique(np.concatenate([faces[:, [0, 1]], faces[:, [0, 2]], faces[:, [1, 2]]]), axis=0)
    tree.insert_batch(np.ascontiguousarray(edges.T).astype(np.int32), values[edges].max(axis=1))
    tree.insert_batch(np.ascontiguousarray(faces.T).astype(np.int32), values[faces].max(axis=1))
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0, persistence_dim_max=True)
    return [len(tree.persistence_intervals_in_dimension(degree)) for degree in range(3)]


case("persistence", "persistence of a function on a torus, 180,000 triangles", torus, coface=persistence_coface, gudhi=persistence_gudhi)


# Regions of the plane.


def stars(size: float) -> list[np.ndarray]:
    random = np.random.default_rng(3)
    found = []
    for center in random.uniform(0, 10, size=(int(200 * size), 2)):
        angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
        radii = random.uniform(0.3, 1.2, size=60)
        found.append(center + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)]))
    return found


def union_coface(rings: Any) -> Any:
    import coface

    return round(coface.boolean("union", *[coface.polygon(ring) for ring in rings]).measure, 6)


def union_shapely(rings: Any) -> Any:
    import shapely

    return round(float(shapely.union_all([shapely.Polygon(ring) for ring in rings]).area), 6)


case("regions", "the union of 200 stars of 60 corners", stars, coface=union_coface, shapely=union_shapely)


# Solids in space.


def spheres(size: float) -> list[tuple[np.ndarray, np.ndarray]]:
    n = int(60 * size**0.5)
    found = []
    for shift in [0.0, 0.37]:
        theta, phi = np.linspace(0, np.pi, n + 1)[1:-1], np.linspace(0, 2 * np.pi, 2 * n, endpoint=False)
        t, p = (axis.reshape(-1) for axis in np.meshgrid(theta, phi, indexing="ij"))
        points = np.column_stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)])
        points = np.concatenate([points, [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]]) + [shift, 0.81 * shift, 0.4 * shift]
        m, top, bottom = 2 * n, len(points) - 2, len(points) - 1
        faces = []
        for j in range(m):
            k = (j + 1) % m
            faces.append([top, j, k])
            faces.append([bottom, (n - 2) * m + k, (n - 2) * m + j])
            for i in range(n - 2):
                a, b, c, d = i * m + j, (i + 1) * m + j, (i + 1) * m + k, i * m + k
                faces += [[a, b, c], [a, c, d]]
        found.append((points, np.array(faces)))
    return found


def solids_coface(meshes: Any) -> Any:
    import coface

    return round(coface.boolean("difference", *[coface.Model.from_arrays(*mesh) for mesh in meshes]).measure, 6)


def solids_manifold3d(meshes: Any) -> Any:
    import manifold3d

    a, b = (
        manifold3d.Manifold(manifold3d.Mesh64(points, faces.astype(np.uint64)))
        if hasattr(manifold3d, "Mesh64")
        else manifold3d.Manifold(manifold3d.Mesh(points.astype(np.float32), faces.astype(np.uint32)))
        for points, faces in meshes
    )
    return round((a - b).volume(), 6)


case("solids", "the difference of two spheres, 14,000 triangles each", spheres, coface=solids_coface, manifold3d=solids_manifold3d)

BESIDE = {
    ("surface", "gudhi"): "over the field with 2 elements; coface over the integers",
    ("solid", "gudhi"): "over the field with 2 elements; coface over the integers",
    ("surface", "gmsh"): "over the integers, with generators",
    ("solid", "gmsh"): "over the integers, with generators",
    ("report", "trimesh"): "Euler characteristic, components, closed, volume; coface also manifold, orientable, name, homology",
    ("regions", "shapely"): "floating point with snapping; coface exact",
    ("solids", "manifold3d"): "floating point with perturbation; coface exact",
}


def child(name: str, tool: str, size: float) -> None:
    _, tools, make = CASES[name]
    data = make(size)
    importlib.import_module(tool)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begin = time.perf_counter()
    answer = tools[tool](data)
    taken = time.perf_counter() - begin
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    print(json.dumps({"seconds": taken, "answer": answer, "megabytes": peak / 1024}))


def measure(name: str, tool: str, size: float) -> dict[str, Any] | str:
    words = [sys.executable, __file__, "--child", name, tool, "--size", str(size)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode:
        return (done.stderr.strip().splitlines() or ["no word"])[-1]
    found: dict[str, Any] = json.loads(done.stdout.strip().splitlines()[-1])
    return found


def machine() -> str:
    model = platform.processor() or platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="ascii") as file:
            model = next(line.partition(":")[2].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return f"{model}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def version(tool: str) -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(tool)
    except PackageNotFoundError:
        return "?"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", choices=sorted(CASES), action="append")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--size", type=float, default=1.0, help="how many times the usual number of cells")
    parser.add_argument("--child", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        child(*options.child, options.size)
        return 0
    tools = sorted({tool for _, tools, _ in CASES.values() for tool in tools})
    found = {tool: importlib.util.find_spec(tool) is not None for tool in tools}
    print(f"{datetime.date.today()}, {machine()}; {options.rounds} rounds, size {options.size:g}; "
          + ", ".join(f"{tool} {version(tool)}" for tool in tools if found[tool]))  # fmt: skip
    for tool in tools:
        if not found[tool]:
            print(f"{tool} is not installed: left out")
    print()
    print("| question | tool | seconds | times coface | peak MB | beside |")
    print("|---|---|---|---|---|---|")
    status = 0
    for name in options.case or CASES:
        words, tools_of_case, _ = CASES[name]
        present = [tool for tool in tools_of_case if found[tool]]
        runs: dict[str, list[Any]] = {tool: [] for tool in present}
        for _ in range(options.rounds):
            for tool in present:
                # What takes minutes is not asked again.
                if not any(isinstance(run, str) or run["seconds"] > SLOW for run in runs[tool]):
                    runs[tool].append(measure(name, tool, options.size))
        least: dict[str, float] = {}
        answers: dict[str, Any] = {}
        for tool in present:
            right = [run for run in runs[tool] if not isinstance(run, str)]
            if not right:
                print(f"| {words} | {tool} | failed: {runs[tool][0]} | | | |")
                status = 1 if tool == "coface" else status
                continue
            least[tool] = min(run["seconds"] for run in right)
            answers[tool] = right[0]["answer"]
            memory = min(run["megabytes"] for run in right)
            ratio = f"{least[tool] / least['coface']:.2f}" if "coface" in least else ""
            beside = BESIDE.get((name, tool), "") + (" (one run)" if len(right) == 1 < options.rounds else "")
            if tool != "coface" and "coface" in answers and not agree(answers[tool], answers["coface"]):
                beside += f"; **answers {answers[tool]}, coface {answers['coface']}**"
            print(f"| {words} | {tool} | {least[tool]:.3f} | {ratio} | {memory:.0f} | {beside} |", flush=True)
    return status


def agree(a: Any, b: Any) -> bool:
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(agree(x, y) for x, y in zip(a, b))
    if isinstance(a, float) or isinstance(b, float):
        return abs(a - b) <= 1e-5 * max(abs(a), abs(b), 1)
    return bool(a == b)


if __name__ == "__main__":
    sys.exit(main())
