"""Random input, answered by other libraries too."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import coface

SEEDS = range(25)


def random_facets(seed: int) -> list[list[int]]:
    """Simplices of dimension 1 to 3 on a few vertices."""
    random = np.random.default_rng(seed)
    count = int(random.integers(4, 10))
    sizes = random.integers(2, 5, size=int(random.integers(3, 30)))
    return [sorted(random.choice(count, size=min(int(size), count), replace=False).tolist()) for size in sizes]


def simplex_tree(facets):
    gudhi = pytest.importorskip("gudhi")
    tree = gudhi.SimplexTree()
    for facet in facets:
        tree.insert(facet, 0.0)
    return tree


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("prime", [2, 3, 11])
def test_betti_numbers_are_those_of_gudhi(seed, prime) -> None:
    facets = random_facets(seed)
    tree = simplex_tree(facets)
    tree.compute_persistence(homology_coeff_field=prime, min_persistence=-1, persistence_dim_max=True)
    expected = tree.betti_numbers()
    found = list(coface.homology(facets, f"f{prime}").betti_numbers)
    length = max(len(expected), len(found))
    assert found + [0] * (length - len(found)) == expected + [0] * (length - len(expected))
    assert coface.as_complex(tree) == coface.as_complex(facets)
    counts = [len(list(group)) for _, group in itertools.groupby(sorted(len(s) for s, _ in tree.get_simplices()))]
    assert list(coface.as_complex(facets).f_vector) == counts


@pytest.mark.parametrize("seed", SEEDS)
def test_stars_and_links_are_those_of_gudhi(seed) -> None:
    facets = random_facets(seed)
    tree = simplex_tree(facets)
    complex = coface.Complex(facets)
    simplex = facets[seed % len(facets)][:2]
    star = {tuple(s) for s, _ in tree.get_star(simplex)}
    assert {tuple(s) for s in complex.star([simplex])} == star
    closed = {tuple(part) for s in star for size in range(1, len(s) + 1) for part in itertools.combinations(s, size)}
    # The closure of the star minus the star of the closure; of a simplex that is what has no vertex of it.
    link = {s for s in closed if not set(s) & set(simplex)}
    assert {tuple(s) for s in complex.link([simplex])} == link


@pytest.mark.parametrize("seed", SEEDS)
def test_persistence_is_that_of_gudhi(seed) -> None:
    random = np.random.default_rng(1000 + seed)
    tree = simplex_tree(random_facets(seed))
    values = random.integers(0, 6, size=64).astype(float)
    for simplex, _ in list(tree.get_simplices()):
        tree.assign_filtration(simplex, max(values[v] for v in simplex))
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0, persistence_dim_max=True)
    found = coface.persistence(tree)
    for degree in range(tree.dimension() + 1):
        expected = tree.persistence_intervals_in_dimension(degree)
        expected = expected[expected[:, 0] < expected[:, 1]] if len(expected) else expected.reshape(0, 2)
        diagram = np.asarray(found.diagram(degree)).reshape(-1, 2)
        assert np.array_equal(diagram[np.lexsort(diagram.T)], expected[np.lexsort(expected.T)]), degree


@pytest.mark.parametrize("seed", SEEDS)
def test_surfaces_are_those_of_trimesh(seed) -> None:
    trimesh = pytest.importorskip("trimesh")
    random = np.random.default_rng(seed)
    mesh = trimesh.convex.convex_hull(random.normal(size=(int(random.integers(5, 60)), 3)))
    kept = random.random(len(mesh.faces)) < (1.0 if seed % 3 == 0 else 0.8)
    part = trimesh.Trimesh(mesh.vertices, mesh.faces[kept], process=False)
    report = coface.as_model(part).report()
    assert report.closed == part.is_watertight or report.manifold != "yes"
    assert report.area == pytest.approx(part.area, rel=1e-12)
    used = len(np.unique(part.faces))
    edges = len(part.edges_unique)
    assert report.euler_characteristic == len(part.vertices) - edges + len(part.faces)
    assert len(part.vertices) - used + part.body_count == report.components or part.body_count == 0
    if kept.all():
        assert report.signed_volume == pytest.approx(part.volume, rel=1e-9)
        assert report.name == "sphere"


@pytest.mark.parametrize("seed", SEEDS)
def test_regions_are_those_of_shapely(seed) -> None:
    shapely = pytest.importorskip("shapely")
    random = np.random.default_rng(seed)

    def star_shape(center):
        angles = np.sort(random.random(int(random.integers(3, 20)))) * 2 * np.pi
        radii = random.uniform(0.4, 1.5, size=len(angles))
        return shapely.Polygon(center + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)]))

    a, b = star_shape(np.zeros(2)), star_shape(random.normal(size=2) * 0.5)
    if not (a.is_valid and b.is_valid):
        pytest.skip("a random polygon crosses itself")
    for operation, peer in [
        ("union", shapely.union),
        ("intersection", shapely.intersection),
        ("difference", shapely.difference),
        ("xor", shapely.symmetric_difference),
    ]:
        result = coface.boolean(operation, a, b)
        assert result.measure == pytest.approx(peer(a, b).area, rel=1e-9, abs=1e-12), operation
        assert coface.to_shapely(result).area == pytest.approx(result.measure, rel=1e-9, abs=1e-12)
