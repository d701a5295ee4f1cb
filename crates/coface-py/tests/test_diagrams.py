"""Persistence diagrams as data: distances, curves, images; beside gudhi where it is installed."""

from __future__ import annotations

import numpy as np
import pytest

import coface

INF = float("inf")


def diagram(seed: int, count: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    births = rng.normal(size=count)
    return np.column_stack([births, births + rng.exponential(size=count)])


@pytest.mark.parametrize("seed", range(4))
def test_distances_are_those_of_gudhi(seed: int) -> None:
    gudhi = pytest.importorskip("gudhi")
    a, b = diagram(seed, 60), diagram(seed + 50, 70)
    assert coface.bottleneck(a, b) == pytest.approx(gudhi.bottleneck_distance(a, b, 0), rel=1e-12)
    hera = pytest.importorskip("gudhi.hera")
    for order, p in ((1.0, INF), (2.0, 2.0), (3.0, 1.0)):
        expected = hera.wasserstein_distance(a, b, order=order, internal_p=p, delta=1e-4)
        assert coface.wasserstein(a, b, order=order, internal_p=p) == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize("seed", range(2))
def test_distances_are_those_of_persim(seed: int) -> None:
    persim = pytest.importorskip("persim")
    a, b = diagram(seed, 40), diagram(seed + 50, 30)
    assert coface.bottleneck(a, b) == pytest.approx(persim.bottleneck(a, b))
    assert coface.wasserstein(a, b, internal_p=2) == pytest.approx(persim.wasserstein(a, b))


def test_wasserstein_is_an_assignment_of_scipy() -> None:
    optimize = pytest.importorskip("scipy.optimize")
    a, b = diagram(1, 40), diagram(2, 50)
    sizes = [np.abs(np.subtract(*x.T)) / 2 for x in (a, b)]
    costs = np.zeros((90, 90))
    costs[:40, :50] = np.abs(a[:, None] - b[None]).max(axis=2)
    costs[:40, 50:] = sizes[0][:, None]
    costs[40:, :50] = sizes[1][None]
    for order in (1.0, 2.0):
        rows, columns = optimize.linear_sum_assignment(costs**order)
        expected = (costs[rows, columns] ** order).sum() ** (1 / order)
        distance, (pairs,) = coface.wasserstein(a, b, order=order, matching=True)
        assert distance == pytest.approx(expected, rel=1e-12)
        assert sorted(pairs[pairs[:, 0] >= 0, 0]) == list(range(40))


def test_all_shapes_of_diagrams() -> None:
    first = [np.array([[0.0, INF], [0.0, 2.0]]), np.array([[1.0, 5.0]])]
    gudhi = [(0, (0.0, INF)), (0, (0.0, 2.0)), (1, (1.0, 5.0))]
    points = coface.rips([[0, 0], [3, 0], [3, 4], [0, 4]])
    for same in (first, gudhi, tuple(gudhi)):
        assert coface.bottleneck(first, same) == 0
        assert coface.bottleneck(first, same, degree=1) == 0
    assert coface.bottleneck(first, first[0]) == 2
    assert coface.bottleneck(first[1], np.zeros((0, 2))) == 2
    assert coface.bottleneck([], []) == 0
    assert coface.bottleneck(points, points.to_gudhi()) == 0
    assert coface.bottleneck(points, points.diagrams) == 0
    assert coface.bottleneck(first, first[1]) == INF
    assert coface.wasserstein(first, [np.zeros((0, 2)), first[1]]) == INF
    distance, pairs = coface.bottleneck(first, first, matching=True)
    assert distance == 0 and [part.tolist() for part in pairs] == [[[0, 0], [1, 1]], [[0, 0]]]


def test_wrong_diagrams_are_refused() -> None:
    for wrong in (np.zeros((2, 3)), [[0.0, float("nan")]], [(-1, (0.0, 1.0))]):
        with pytest.raises(coface.Error):
            coface.bottleneck(wrong, wrong)
    for options in ({"order": 0.5}, {"order": INF}, {"internal_p": 0.0}):
        with pytest.raises(coface.Error):
            coface.wasserstein([[0, 1]], [[0, 1]], **options)


def test_curves() -> None:
    found = coface.persistence([[0, 1], [1, 2], [2, 3]], [0.0, 5.0, 1.0, 2.0])
    at, numbers = found.betti_curve(0)
    assert at.tolist() == [0, 1, 5] and numbers.tolist() == [1, 2, 1]
    assert found.betti_curve(0, at=[-1, 0.5, 3])[1].tolist() == [0, 1, 2]
    assert found.betti_curve(0, at=3, end=9)[0].tolist() == [0, 4.5, 9]
    falling = coface.persistence([[0, 1], [1, 2], [2, 3]], [0.0, 5.0, 1.0, 2.0], upper=True)
    assert falling.betti_curve(0, at=[-9, 0, 1, 2, 5, 6])[1].tolist() == [1, 1, 1, 2, 1, 0]
    at, rows = found.landscapes(0, 2, at=[1, 3, 4], end=6)
    assert rows.tolist() == [[1, 3, 2], [0, 2, 1]]
    with pytest.warns(UserWarning, match="end="):
        assert found.silhouette(0, at=[3])[1].tolist() == [2]
    assert found.euler_curve(at=[0.5, 1])[1].tolist() == [1, 2]
    with pytest.warns(UserWarning, match="Euler"):
        coface.rips([[0, 0], [1, 0]]).euler_curve()


def test_landscapes_and_images_are_those_of_gudhi() -> None:
    representations = pytest.importorskip("gudhi.representations")
    image = np.random.default_rng(3).normal(size=(12, 12))
    found = coface.cubical(image)
    pairs = found.diagram(1)
    # Values of gudhi's grid; its landscapes are multiplied by the root of 2.
    gudhi = representations.Landscape(num_landscapes=3, resolution=50, sample_range=[-2.0, 3.0])
    expected = gudhi.fit_transform([pairs])[0].reshape(3, 50) / np.sqrt(2)
    at, rows = found.landscapes(1, 3, at=np.linspace(-2.0, 3.0, 50))
    np.testing.assert_allclose(rows, expected, atol=1e-9)
    betti = representations.BettiCurve(resolution=50, sample_range=[-2.0, 3.0]).fit_transform([pairs])[0]
    assert found.betti_curve(1, at=at)[1].tolist() == betti.tolist()
    silhouette = representations.Silhouette(resolution=50, sample_range=[-2.0, 3.0], weight=lambda pair: pair[1] - pair[0])
    expected = silhouette.fit_transform([pairs])[0] / np.sqrt(2)
    np.testing.assert_allclose(found.silhouette(1, at=at)[1], expected, atol=1e-9)


def test_images_have_the_weight_of_their_classes() -> None:
    found = coface.cubical([[1, 2, 1], [2, 9, 2], [1, 2, 1]])
    image = found.persistence_image(1, resolution=(8, 4), bandwidth=0.5, births=(-10, 10), persistences=(0, 20))
    assert image.shape == (4, 8)
    assert image.sum() == pytest.approx(7)
    assert np.unravel_index(image.argmax(), image.shape)[0] == 1
    with pytest.raises(coface.Error, match="births="):
        coface.cubical([1.0, 2.0]).persistence_image(0)
