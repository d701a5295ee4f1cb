"""Steps of pipelines of scikit-learn, beside the same diagrams by gudhi."""

from __future__ import annotations

import numpy as np
import pytest

import coface

pytest.importorskip("sklearn")
from coface.interop.sklearn import BettiCurves, Diagrams, Landscapes, PersistenceImages, PointDiagrams  # noqa: E402

RING = np.array([[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 0.0]])


def images() -> list[np.ndarray]:
    random = np.random.default_rng(3)
    return [random.integers(0, 30, (5, 6)).astype(float) for _ in range(12)]


def test_diagrams_of_images_are_those_of_gudhi() -> None:
    gudhi = pytest.importorskip("gudhi")
    for image, found in zip(images(), Diagrams().fit_transform(images()), strict=True):
        cubes = gudhi.CubicalComplex(top_dimensional_cells=image)
        cubes.persistence(homology_coeff_field=2)
        for degree, diagram in enumerate(found):
            expected = cubes.persistence_intervals_in_dimension(degree)
            assert sorted(map(tuple, diagram)) == sorted(map(tuple, expected))


def test_falling_values_are_rising_ones_of_the_negative() -> None:
    rising = Diagrams().fit_transform([-image for image in images()])
    falling = Diagrams(upper=True).fit_transform(images())
    for first, second in zip(rising, falling, strict=True):
        for up, down in zip(first, second, strict=True):
            assert np.array_equal(down[:, 0], -up[:, 0])
            assert np.array_equal(down[:, 1], -up[:, 1])
    path = [[0, 1], [1, 2]]
    of_image, of_space = Diagrams(degrees=(0,), upper=True).fit_transform([[[1.0, 0.0, 3.0]], (path, [1.0, 0.0, 3.0])])
    assert sorted(map(tuple, of_image[0])) == sorted(map(tuple, of_space[0])) == [(1.0, 0.0), (3.0, -np.inf)]
    (deep,) = Diagrams(degrees=(0,), upper=True).fit_transform([np.array([1.0, 0.0, 3.0]).reshape(1, 1, 1, 1, 3)])
    assert sorted(map(tuple, deep[0])) == [(1.0, 0.0), (3.0, -np.inf)]


def test_curves_count_what_lives() -> None:
    spaces = [([[0, 1], [1, 2], [0, 2]], [0.0, 1.0, 2.0]), RING]
    diagrams = Diagrams().fit_transform(spaces)
    curves = BettiCurves(bins=10, limits=(0, 9)).fit_transform(diagrams)
    assert curves.shape == (2, 20)
    assert curves[0, 10:].tolist() == [0, 0, 1, 1, 1, 1, 1, 1, 1, 1]
    assert curves[1, 10:].tolist() == [1] * 9 + [0]
    falling = Diagrams(upper=True).fit_transform([-RING])
    found = BettiCurves(bins=10, limits=(-9, 0), upper=True).fit_transform(falling)[0]
    assert found[:10].tolist() == [1] * 10
    assert found[10:].tolist() == [0] + [1] * 9


def test_steps_are_cloned_and_joined() -> None:
    from sklearn.base import clone
    from sklearn.linear_model import LogisticRegression
    from sklearn.pipeline import make_pipeline

    steps = make_pipeline(Diagrams(degrees=(1,), coefficients="f3"), BettiCurves(bins=4), LogisticRegression())
    assert clone(steps).get_params()["diagrams__coefficients"] == "f3"
    flat = np.arange(9.0).reshape(3, 3)
    samples = [RING, flat, RING + 1, flat + 1]
    assert steps.fit(samples, [1, 0, 1, 0]).predict(samples).tolist() == [1, 0, 1, 0]


def test_what_is_no_sample_is_refused() -> None:
    with pytest.raises(coface.InvalidInputError, match="NaN"):
        Diagrams().transform([np.array([[np.nan, 1.0]])])
    with pytest.raises(coface.InvalidInputError, match="numpy.inf"):
        Diagrams().transform([np.array([[np.nan, 1.0]])])
    with pytest.raises(coface.InvalidInputError, match="a sample has the type"):
        Diagrams().transform([np.array(["a"])])
    with pytest.raises(coface.InvalidInputError, match="bins is 0"):
        BettiCurves(bins=0).fit([])
    with pytest.raises(coface.InvalidInputError, match="2 were fitted"):
        BettiCurves(limits=(0, 1)).fit([[np.zeros((0, 2))] * 2]).transform([[np.zeros((0, 2))]])
    with pytest.raises(coface.InvalidInputError, match="upper=True"):
        BettiCurves(limits=(0, 1)).fit_transform([[np.array([[1.0, 0.0]])]])
    with pytest.raises(coface.InvalidInputError, match="limits"):
        BettiCurves(limits=(2, 1)).fit([])


def _clouds() -> list[np.ndarray]:
    rng = np.random.default_rng(3)
    angles = rng.random((3, 15)) * 2 * np.pi
    return [np.column_stack([np.cos(each), np.sin(each)]) for each in angles]


def test_points_landscapes_and_images_are_those_of_persistence() -> None:
    clouds = _clouds()
    diagrams = PointDiagrams(degrees=(1,)).fit_transform(clouds)
    answers = [coface.rips(cloud) for cloud in clouds]
    for (diagram,), answer in zip(diagrams, answers, strict=True):
        assert np.array_equal(diagram, answer.diagram(1))
    landscapes = Landscapes(count=3, bins=11, limits=(0, 2)).fit_transform(diagrams)
    images = PersistenceImages((4, 3), births=(0, 2), persistences=(0, 2), bandwidth=0.2, power=2.0).fit_transform(diagrams)
    for row, image, answer in zip(landscapes, images, answers, strict=True):
        _, expected = answer.landscapes(1, 3, at=np.linspace(0, 2, 11))
        assert row == pytest.approx(expected.reshape(-1), abs=1e-12)
        expected = answer.persistence_image(1, resolution=(4, 3), births=(0, 2), persistences=(0, 2), bandwidth=0.2, power=2.0)
        assert image == pytest.approx(expected.reshape(-1), abs=1e-12)


def test_columns_have_names_and_become_tables() -> None:
    pandas, pipeline = pytest.importorskip("pandas"), pytest.importorskip("sklearn.pipeline")
    diagrams = PointDiagrams().fit_transform(_clouds())
    for step in (BettiCurves(bins=4), Landscapes(count=2, bins=3), PersistenceImages((2, 3))):
        table = step.set_output(transform="pandas").fit_transform(diagrams)
        assert isinstance(table, pandas.DataFrame)
        assert list(table.columns) == step.get_feature_names_out().tolist()
        assert len(set(table.columns)) == len(table.columns) == len(table.iloc[0])
    steps = pipeline.make_pipeline(PointDiagrams(), BettiCurves(bins=4)).set_output(transform="pandas")
    assert isinstance(steps.fit_transform(_clouds()), pandas.DataFrame)


def test_masked_voxels_are_outside() -> None:
    """The ring of ones around a masked voxel, whatever stands behind the mask."""
    middle = np.arange(9).reshape(3, 3) == 4
    for behind in (0.0, np.nan, 7.0):
        values = np.where(middle, behind, 1.0)
        (found,) = Diagrams().fit_transform([np.ma.array(values, mask=middle)])
        assert found[1].tolist() == [[1.0, np.inf]]
    with pytest.raises(coface.InvalidInputError, match="masked entries"):
        PointDiagrams().fit_transform([np.ma.array([[0.0, 0], [1, 1]], mask=[[0, 0], [1, 1]])])
    with pytest.raises(coface.InvalidInputError, match="masked entries"):
        Diagrams().fit_transform([([[0, 1]], np.ma.array([0.0, 1.0], mask=[0, 1]))])
