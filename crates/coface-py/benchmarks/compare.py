"""coface beside gudhi, ripser, cripser, gmsh, trimesh, shapely and manifold3d on the same inputs.

Each tool answers each question in a process of its own; processes of both sides take turns, so that a busy minute hits both. Reported are the
least time of each, their ratio, and the peak of resident memory over that of the process before the question. From arrays to arrays: making the input
of a tool from arrays, and arrays from its result, counts as part of its work, for all of them, since that is what a user waits for. Answers are compared by
the same code, outside of the time; questions are not always the same, and the column "beside" says where they differ.

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
#: Question -> what it is, tool -> function of the input that gives the answer, what makes the input, and what is compared of an answer.
CASES: dict[str, tuple[str, dict[str, Callable[[Any], Any]], Callable[[float], Any], Callable[[Any], Any]]] = {}


def case(
    name: str, words: str, make: Callable[[float], Any], compared: Callable[[Any], Any] = lambda answer: answer, **tools: Callable[[Any], Any]
) -> None:
    CASES[name] = (words, tools, make, compared)


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
    return [np.asarray(found.diagram(degree)) for degree in range(3)]


def lengths(tables: Any) -> Any:
    """How many classes diagrams have, and how long they live together."""
    found = []
    for table in tables:
        lives = abs(np.diff(np.asarray(table, float).reshape(-1, 2), axis=1).ravel())
        found += [int((lives > 0).sum()), round(float(lives[np.isfinite(lives)].sum()), 3)]
    return found


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
    return [tree.persistence_intervals_in_dimension(degree) for degree in range(3)]


case("persistence", "persistence of a function on a torus, 180,000 triangles", torus, lengths, coface=persistence_coface, gudhi=persistence_gudhi)


# Volumes.


def field(size: float) -> np.ndarray:
    """A sum of waves with noise, n^3 voxels."""
    n = int(64 * size ** (1 / 3))
    x, y, z = np.meshgrid(*[np.linspace(0, 4 * np.pi, n)] * 3, indexing="ij")
    noise = np.random.default_rng(11).normal(scale=0.05, size=(n, n, n))
    return np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x) + noise


def volume_coface(values: Any) -> Any:
    import coface

    found = coface.cubical(values, construction="v")
    return [np.asarray(found.diagram(degree)) for degree in range(3)]


def volume_cripser(values: Any) -> Any:
    import cripser

    rows = cripser.computePH(values, maxdim=2)
    tables = [rows[rows[:, 0] == degree][:, 1:3] for degree in range(3)]
    return [np.where(table > 1e300, np.inf, table) for table in tables]


def volume_gudhi(values: Any) -> Any:
    import gudhi

    complex = gudhi.CubicalComplex(vertices=values)
    complex.compute_persistence(homology_coeff_field=2)
    return [complex.persistence_intervals_in_dimension(degree) for degree in range(3)]


case("volume", "persistence of an image of 64^3 voxels", field, lengths, coface=volume_coface, cripser=volume_cripser, gudhi=volume_gudhi)


def mask(size: float) -> np.ndarray:
    """What lies above a level of such an image."""
    return field(8 * size) > 0.3


def voxels_coface(values: Any) -> Any:
    import coface

    return list(coface.homology(coface.volume(values)).betti_numbers)[:3]


def voxels_gudhi(values: Any) -> Any:
    import gudhi

    complex = gudhi.CubicalComplex(top_dimensional_cells=np.where(values, 0.0, np.inf))
    complex.compute_persistence(homology_coeff_field=2)
    return complex.persistent_betti_numbers(0.0, 1.0)[:3]


case("voxels", "Betti numbers of a mask of 128^3 voxels", mask, coface=voxels_coface, gudhi=voxels_gudhi)


# Points.


def rotations(size: float) -> np.ndarray:
    """Orthogonal matrices of three rows, drawn evenly, as points with nine coordinates."""
    random = np.random.default_rng(5)
    q, r = np.linalg.qr(random.normal(size=(int(1024 * size), 3, 3)))
    return (q * np.sign(np.einsum("nii->ni", r))[:, None, :]).reshape(-1, 9)


#: The diameter at which simplices of the rotations end, and the highest degree.
DIAMETER, DEGREE = 1.8, 3


def rips_coface(points: Any) -> Any:
    import coface

    found = coface.rips(points, dimension=DEGREE, threshold=DIAMETER)
    return [np.asarray(found.diagram(degree)) for degree in range(DEGREE + 1)]


def rips_ripser(points: Any) -> Any:
    import ripser

    return ripser.ripser(points, maxdim=DEGREE, thresh=DIAMETER)["dgms"]


def rips_gudhi(points: Any) -> Any:
    import gudhi

    tree = gudhi.RipsComplex(points=points, max_edge_length=DIAMETER).create_simplex_tree(max_dimension=1)
    tree.collapse_edges()
    tree.expansion(DEGREE + 1)
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0)
    return [tree.persistence_intervals_in_dimension(degree) for degree in range(DEGREE + 1)]


def totals(diagrams: Any) -> Any:
    """Of each degree how many classes live longer than rounding to single precision, and how long those live in all that die."""
    found = []
    for diagram in diagrams:
        lives = np.diff(np.asarray(diagram, float).reshape(-1, 2), axis=1)
        found += [int((lives > 1e-5).sum()), round(float(lives[np.isfinite(lives) & (lives > 1e-5)].sum()), 2)]
    return found


case("points", "Vietoris-Rips persistence of 1,024 rotations, degrees 0 to 3", rotations, totals, coface=rips_coface, ripser=rips_ripser, gudhi=rips_gudhi)


# Regions of the plane.


def stars(size: float, usual: int = 200) -> list[np.ndarray]:
    """So many rings of 60 corners in a square of side 10."""
    random = np.random.default_rng(3)
    count = int(usual * size)
    found = []
    for center in random.uniform(0, 10, size=(count, 2)):
        angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
        radii = random.uniform(0.3, 1.2, size=60)
        found.append(center + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)]))
    return found


def dense(size: float) -> list[np.ndarray]:
    """Ten times as many stars in the same square."""
    return stars(size, 2000)


def union_coface(rings: Any) -> Any:
    import coface

    found = coface.boolean("union", *[coface.polygon(ring) for ring in rings])
    points = found.vertices
    return [points[ring] for polygon in found.polygons for ring in polygon]


def union_shapely(rings: Any) -> Any:
    import shapely

    found = shapely.union_all([shapely.Polygon(ring) for ring in rings])
    parts = getattr(found, "geoms", [found])
    return [shapely.get_coordinates(ring)[:-1] for part in parts for ring in (part.exterior, *part.interiors)]


def area(rings: Any) -> Any:
    """How many rings there are, and the area within them without their holes."""
    found = []
    for ring in rings:
        x, y = np.asarray(ring, float).T
        found.append((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)
    # Outer rings and holes run in opposite directions in both tools.
    return [len(found), round(float(abs(np.sum(found))), 6)]


case("regions", "the union of 200 stars of 60 corners", stars, area, coface=union_coface, shapely=union_shapely)
case("dense", "the union of 2,000 stars of 60 corners in the same square", dense, area, coface=union_coface, shapely=union_shapely)


# Solids in space.


def sphere(levels: int) -> tuple[np.ndarray, np.ndarray]:
    """A sphere of 20 * 4^levels triangles, from an icosahedron."""
    golden = (1 + 5**0.5) / 2
    points = np.array([[s, t * golden, 0.0] for s in (-1, 1) for t in (-1, 1)])
    points = np.concatenate([points, points[:, [2, 0, 1]], points[:, [1, 2, 0]]])
    points /= np.linalg.norm(points, axis=1)[:, None]
    near = ((points[:, None] - points[None]) ** 2).sum(axis=2) < 1.2
    faces = np.array([[a, b, c] for a in range(12) for b in range(a) for c in range(b) if near[a, b] and near[b, c] and near[a, c]])
    inward = np.einsum("ij,ij->i", points[faces[:, 0]], np.cross(points[faces[:, 1]], points[faces[:, 2]])) < 0
    faces[inward] = faces[inward][:, ::-1]
    for _ in range(levels):
        sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        edges, number = np.unique(sides, axis=0, return_inverse=True)
        middle = points[edges].sum(axis=1)
        middle /= np.linalg.norm(middle, axis=1)[:, None]
        ab, bc, ca = (number.reshape(3, -1) + len(points))
        a, b, c = faces.T
        points = np.concatenate([points, middle])
        faces = np.concatenate([np.column_stack(rows) for rows in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return points, faces


def two_spheres(levels: int) -> list[tuple[np.ndarray, np.ndarray]]:
    points, faces = sphere(levels)
    return [(points, faces), (points + [0.37, 0.2997, 0.148], faces)]


def solids_coface(meshes: Any) -> Any:
    import coface

    found = coface.boolean("difference", *[coface.Model.from_arrays(*mesh) for mesh in meshes], triangles=True).model
    return found.vertices, found.faces


def solids_manifold3d(meshes: Any) -> Any:
    import manifold3d

    has_doubles = hasattr(manifold3d, "Mesh64")
    a, b = (
        manifold3d.Manifold(manifold3d.Mesh64(points, faces.astype(np.uint64)))
        if has_doubles
        else manifold3d.Manifold(manifold3d.Mesh(points.astype(np.float32), faces.astype(np.uint32)))
        for points, faces in meshes
    )
    found = (a - b).to_mesh64() if has_doubles else (a - b).to_mesh()
    return found.vert_properties[:, :3], found.tri_verts


def enclosed(mesh: Any) -> Any:
    """The volume of a closed mesh, and whether each edge has two triangles."""
    points, faces = np.asarray(mesh[0], float), np.asarray(mesh[1], np.int64)
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    counts = np.unique(sides, axis=0, return_counts=True)[1]
    return [round(float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6), 6), bool((counts % 2 == 0).all())]


case("solids", "the difference of two spheres, 82,000 triangles each", lambda size: two_spheres(6), enclosed, coface=solids_coface, manifold3d=solids_manifold3d)
case("large", "the difference of two spheres, 1.3 million triangles each", lambda size: two_spheres(8), enclosed, coface=solids_coface, manifold3d=solids_manifold3d)

BESIDE = {
    ("surface", "gudhi"): "over the field with 2 elements; coface over the integers",
    ("solid", "gudhi"): "over the field with 2 elements; coface over the integers",
    ("surface", "gmsh"): "over the integers, with generators",
    ("solid", "gmsh"): "over the integers, with generators",
    ("report", "trimesh"): "Euler characteristic, components, closed, volume; coface also manifold, orientable, name, homology",
    ("regions", "shapely"): "floating point with snapping; coface exact",
    ("dense", "shapely"): "floating point with snapping; coface exact",
    ("solids", "manifold3d"): "floating point with perturbation; coface exact",
    ("large", "manifold3d"): "floating point with perturbation; coface exact",
    ("voxels", "gudhi"): "over the field with 2 elements; coface over the integers",
}


def child(name: str, tool: str, size: float) -> None:
    _, tools, make, compared = CASES[name]
    data = make(size)
    importlib.import_module(tool)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begin = time.perf_counter()
    answer = tools[tool](data)
    taken = time.perf_counter() - begin
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    print(json.dumps({"seconds": taken, "answer": compared(answer), "megabytes": peak / 1024}))


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
    tools = sorted({tool for _, tools, _, _ in CASES.values() for tool in tools})
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
        words, tools_of_case, _, _ = CASES[name]
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
