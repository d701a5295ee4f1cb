"""scikit-learn: persistence as steps of a pipeline. Only this file imports scikit-learn, so it is asked for by its name.

Examples
--------
>>> import numpy as np, pytest
>>> _ = pytest.importorskip("sklearn")
>>> from coface.interop.sklearn import BettiCurves, Diagrams
>>> from sklearn.pipeline import make_pipeline
>>> ring = np.array([[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 0.0]])
>>> steps = make_pipeline(Diagrams(), BettiCurves(bins=3, limits=(0, 9)))
>>> steps.fit_transform([ring])
array([[1., 1., 1., 1., 1., 0.]])
>>> steps[-1].get_feature_names_out().tolist()[:2]
['degree0_at_0.0', 'degree0_at_4.5']
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from coface._arrays import plain, raise_invalid
from coface._faults import in_words
from coface._models import as_chain_complex
from coface._questions import cubical, persistence, rips
from coface._volumes import volume
from coface.interop import needed

needed("sklearn.base", "coface.interop.sklearn")
from sklearn.base import BaseEstimator, TransformerMixin  # noqa: E402

__all__ = ["BettiCurves", "Diagrams", "Landscapes", "PersistenceImages", "PointDiagrams"]


_Step = TypeVar("_Step", bound="_ListsOfDiagrams")


class _ListsOfDiagrams(TransformerMixin, BaseEstimator):  # type: ignore[misc]
    """A step that learns nothing and gives lists of diagrams."""

    def fit(self: _Step, X: Iterable[Any], y: Any = None) -> _Step:
        """Nothing is learned."""
        return self

    def __sklearn_is_fitted__(self) -> bool:
        return True

    def set_output(self: _Step, *, transform: str | None = None) -> _Step:
        """Nothing: diagrams are lists of arrays in any case. A pipeline asks all of its steps."""
        return self


class Diagrams(_ListsOfDiagrams):
    """Persistence diagrams of many images, or of many spaces with values at their vertices.

    A sample is an array of numbers with 1 to 8 axes, whose voxels come at their values, or a pair ``(space, values)``: anything that
    :func:`coface.as_chain_complex` understands, with a number for each vertex.

    Parameters
    ----------
    degrees
        The degrees that are wanted.
    coefficients
        A prime field, as in :func:`coface.persistence`.
    upper
        Whether values fall: what is bright comes first.
    least
        Classes that live no longer than this are left out.

    Examples
    --------
    >>> Diagrams(degrees=(0,)).fit_transform([[[1.0, 5.0, 3.0]], ([[0, 1], [1, 2]], [0.0, 2.0, 1.0])])[1]
    [array([[ 0., inf],
           [ 1.,  2.]])]
    """

    def __init__(self, degrees: Sequence[int] = (0, 1), *, coefficients: str | int = "f2", upper: bool = False, least: float = 0.0) -> None:
        self.degrees = degrees
        self.coefficients = coefficients
        self.upper = upper
        self.least = least

    @in_words
    def transform(self, X: Iterable[Any]) -> list[list[NDArray[np.float64]]]:
        """For each sample, for each degree, an array ``(n, 2)`` of births and deaths."""
        return [self._diagrams(sample) for sample in X]

    def _diagrams(self, sample: Any) -> list[NDArray[np.float64]]:
        options: dict[str, Any] = {"coefficients": self.coefficients, "least": self.least}
        if isinstance(sample, tuple) and len(sample) == 2:
            answer = persistence(sample[0], plain(sample[1]), upper=self.upper, **options)
            return [answer.diagram(degree) for degree in self.degrees]
        is_masked = np.ma.is_masked(sample)
        image = np.asarray(np.ma.filled(sample, 0) if is_masked else plain(sample))
        if image.dtype.kind not in "biuf" or not 1 <= image.ndim <= 8 or not image.size:
            raise_invalid(
                f"a sample has the type {image.dtype} and the shape {image.shape}",
                "give images, arrays of numbers with 1 to 8 axes, or pairs (space, values)",
            )
        values = image.reshape(-1).astype(np.float64)
        if np.isnan(values).any():
            raise_invalid("an image has voxels that are NaN", "give them a number, such as numpy.inf for the last to come")
        if image.ndim <= 4 and self.least >= 0.0:
            answer = cubical(sample if is_masked else image, superlevel=self.upper, **options)
            return [answer.diagram(degree) for degree in self.degrees]
        plain(sample)  # Masks are taken above only.
        complex = as_chain_complex(volume(np.ones(image.shape, bool)))
        later = [np.full(count, np.nan) for count in complex.f_vector[:-1]]
        answer = persistence(complex, cell_values=[*later, -values if self.upper else values], **options)
        found = [answer.diagram(degree) for degree in self.degrees]
        return [_falling(diagram) for diagram in found] if self.upper else found


class PointDiagrams(_ListsOfDiagrams):
    """Persistence diagrams of the Vietoris-Rips filtrations of many clouds of points.

    Parameters
    ----------
    degrees
        The degrees that are wanted.
    threshold, coefficients, least
        As of :func:`coface.rips`.
    distances
        What a sample has, as in :func:`coface.rips`: ``"points"``, ``"square"``, ..

    Examples
    --------
    >>> PointDiagrams().fit_transform([[[0, 0], [3, 0], [3, 4], [0, 4]]])[0][1]
    array([[4., 5.]])
    """

    def __init__(
        self,
        degrees: Sequence[int] = (0, 1),
        *,
        threshold: float | None = None,
        distances: str = "points",
        coefficients: str | int = "f2",
        least: float = 0.0,
    ) -> None:
        self.degrees = degrees
        self.threshold = threshold
        self.distances = distances
        self.coefficients = coefficients
        self.least = least

    @in_words
    def transform(self, X: Iterable[Any]) -> list[list[NDArray[np.float64]]]:
        """For each cloud, for each degree, an array ``(n, 2)`` of births and deaths."""
        options: dict[str, Any] = {"distances": self.distances, "threshold": self.threshold, "coefficients": self.coefficients, "least": self.least}
        top = max(self.degrees, default=0)
        samples = X if isinstance(X, np.ndarray) else list(X)
        if self.distances == "points" and any(_is_row(sample) for sample in samples):
            raise_invalid(
                "a sample is a row of numbers, and no cloud of points",
                "give a list of clouds, each an array of shape (points, coordinates); one cloud is [points]",
            )
        answers = (rips(plain(sample), dimension=top, **options) for sample in samples)
        return [[answer.diagram(degree) for degree in self.degrees] for answer in answers]


def _is_row(sample: Any) -> bool:
    """Whether a sample is one list of numbers."""
    if isinstance(sample, np.ndarray):
        return sample.ndim == 1 and sample.dtype.kind in "biuf" and sample.size > 0
    return isinstance(sample, (list, tuple)) and len(sample) > 0 and all(isinstance(one, (int, float, np.number)) for one in sample)


def _falling(diagram: NDArray[np.float64]) -> NDArray[np.float64]:
    """The diagram of values whose negative this one is about; what never dies dies at minus infinity, as everywhere where values fall."""
    # Taken from 0, since the negative of 0.0 is -0.0.
    found: NDArray[np.float64] = 0.0 - diagram
    return found


def _as_samples(X: Any) -> list[list[NDArray[np.float64]]]:
    """Diagrams as arrays of pairs, those that never end included."""
    return [[np.asarray(diagram, float).reshape(-1, 2) for diagram in sample] for sample in X]


def _require_degrees(sample: Sequence[Any], place: int, count: int) -> None:
    if len(sample) != count:
        raise_invalid(f"sample {place} has {len(sample)} diagrams, and {count} were fitted", "give diagrams of the same degrees as to fit")


def _require_count(value: Any, name: str) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 1:
        raise_invalid(f"{name} is {value!r}", "give an integer from 1")


def _range_of(given: tuple[float, float] | None, numbers: NDArray[np.float64], name: str) -> tuple[float, float]:
    """What is given, or the least and the greatest finite number."""
    finite = numbers[np.isfinite(numbers)]
    low, high = map(float, given) if given is not None else (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    if not low <= high or not np.isfinite([low, high]).all():
        raise_invalid(f"{name} are {low} and {high}", "give two finite numbers, the lesser one first")
    return low, high


class Landscapes(TransformerMixin, BaseEstimator):  # type: ignore[misc]
    """Diagrams as rows of one length: the first persistence landscapes (Bubenik, 2015) of each degree at some values.

    Classes that never die are left out. GUDHI multiplies landscapes by the root of 2.

    Parameters
    ----------
    count
        How many landscapes of each degree.
    bins
        The number of values, evenly spaced.
    limits
        The first and the last value; the least and the greatest finite number of what is fitted if left out.

    Examples
    --------
    >>> Landscapes(count=2, bins=3, limits=(0, 4)).fit_transform([[np.array([[0.0, 4.0], [1.0, 3.0]])]])
    array([[0., 2., 0., 0., 1., 0.]])
    """

    def __init__(self, count: int = 5, bins: int = 32, *, limits: tuple[float, float] | None = None) -> None:
        self.count = count
        self.bins = bins
        self.limits = limits

    @in_words
    def fit(self, X: Sequence[Sequence[Any]], y: Any = None) -> Landscapes:
        """Finds the limits, unless they are given."""
        _require_count(self.count, "count")
        _require_count(self.bins, "bins")
        samples = _as_samples(X)
        numbers = np.concatenate([np.zeros(0), *(diagram.reshape(-1) for sample in samples for diagram in sample)])
        self.values_ = np.linspace(*_range_of(self.limits, numbers, "limits"), int(self.bins))
        self.degree_count_ = len(samples[0]) if samples else 0
        return self

    @in_words
    def transform(self, X: Sequence[Sequence[Any]]) -> NDArray[np.float64]:
        """An array with a row for each sample: of each degree the landscapes, from the largest one on, one behind the other."""
        needed("sklearn.utils.validation", "coface.interop.sklearn").check_is_fitted(self)
        rows = []
        for place, sample in enumerate(_as_samples(X)):
            _require_degrees(sample, place, self.degree_count_)
            rows.append(np.concatenate([np.zeros(0), *(self._landscapes(diagram).reshape(-1) for diagram in sample)]))
        return np.array(rows).reshape(len(rows), self.degree_count_ * int(self.count) * len(self.values_))

    def _landscapes(self, diagram: NDArray[np.float64]) -> NDArray[np.float64]:
        low, high = np.sort(diagram[np.isfinite(diagram).all(axis=1)], axis=1).T[:, :, None]
        tents = np.maximum(np.minimum(self.values_ - low, high - self.values_), 0.0)
        found = np.zeros((int(self.count), len(self.values_)))
        largest = -np.sort(-tents, axis=0)[: int(self.count)]
        found[: len(largest)] = largest
        return found

    def get_feature_names_out(self, input_features: Any = None) -> NDArray[Any]:
        """The names of the columns: ``degree1_landscape0_at_2.5``, with the place of the degree among those that were fitted."""
        places, levels = range(self.degree_count_), range(int(self.count))
        names = [f"degree{place}_landscape{level}_at_{value!r}" for place in places for level in levels for value in self.values_.tolist()]
        return np.array(names, dtype=object)


class PersistenceImages(TransformerMixin, BaseEstimator):  # type: ignore[misc]
    """Diagrams as rows of one length: a persistence image (Adams et al., 2017) of each degree. A pixel is the volume over it.

    Classes that never die are left out.

    Parameters
    ----------
    resolution
        The numbers of pixels in the direction of births and of persistences.
    births, persistences
        The first and the last; those of what is fitted if left out, persistences from 0 on.
    bandwidth
        The standard deviation of the normal distribution around a class; the longer side of a pixel if left out.
    power
        The power of the persistence that is the weight of a class.

    Examples
    --------
    >>> image = PersistenceImages((2, 2), births=(0, 2), persistences=(0, 2), bandwidth=0.1)
    >>> image.fit_transform([[np.array([[0.5, 2.0]])]]).round(3)
    array([[0. , 0. , 1.5, 0. ]])
    """

    def __init__(
        self,
        resolution: tuple[int, int] = (20, 20),
        *,
        births: tuple[float, float] | None = None,
        persistences: tuple[float, float] | None = None,
        bandwidth: float | None = None,
        power: float = 1.0,
    ) -> None:
        self.resolution = resolution
        self.births = births
        self.persistences = persistences
        self.bandwidth = bandwidth
        self.power = power

    @in_words
    def fit(self, X: Sequence[Sequence[Any]], y: Any = None) -> PersistenceImages:
        """Finds the ranges, unless they are given."""
        for count in self.resolution:
            _require_count(count, "resolution")
        samples = _as_samples(X)
        pairs = np.concatenate([np.zeros((0, 2)), *(diagram for sample in samples for diagram in sample)])
        pairs = pairs[np.isfinite(pairs).all(axis=1)]
        lengths = np.abs(pairs[:, 1] - pairs[:, 0])
        low, high = _range_of(self.births, pairs[:, 0], "births")
        least, greatest = _range_of(self.persistences, np.concatenate([[0.0], lengths]), "persistences")
        if low == high:
            # All classes may be born at once, as the components of points are.
            low, high = low - (greatest - least) / 2, high + (greatest - least) / 2
        self.births_ = np.linspace(low, high, int(self.resolution[0]) + 1)
        self.persistences_ = np.linspace(least, greatest, int(self.resolution[1]) + 1)
        sides = self.births_[1] - self.births_[0], self.persistences_[1] - self.persistences_[0]
        self.bandwidth_ = float(max(sides) if self.bandwidth is None else self.bandwidth)
        if not self.bandwidth_ > 0 or not np.isfinite(self.bandwidth_):
            raise_invalid(f"the bandwidth is {self.bandwidth_}", "give a positive number: bandwidth=, or ranges of a length: births=, persistences=")
        self.degree_count_ = len(samples[0]) if samples else 0
        return self

    @in_words
    def transform(self, X: Sequence[Sequence[Any]]) -> NDArray[np.float64]:
        """An array with a row for each sample: of each degree the rows of pixels, from the shortest persistences on, one behind the other."""
        needed("sklearn.utils.validation", "coface.interop.sklearn").check_is_fitted(self)
        rows = []
        for place, sample in enumerate(_as_samples(X)):
            _require_degrees(sample, place, self.degree_count_)
            rows.append(np.concatenate([np.zeros(0), *(self._image(diagram).reshape(-1) for diagram in sample)]))
        return np.array(rows).reshape(len(rows), self.degree_count_ * int(self.resolution[0]) * int(self.resolution[1]))

    def _image(self, diagram: NDArray[np.float64]) -> NDArray[np.float64]:
        from scipy.special import ndtr

        births, deaths = diagram[np.isfinite(diagram).all(axis=1)].T
        lengths = np.abs(deaths - births)

        def parts(edges: NDArray[np.float64], centers: NDArray[np.float64]) -> Any:
            return np.diff(ndtr((edges[:, None] - centers) / self.bandwidth_), axis=0)

        found: NDArray[np.float64] = (parts(self.persistences_, lengths) * lengths**self.power) @ parts(self.births_, births).T
        return found

    def get_feature_names_out(self, input_features: Any = None) -> NDArray[Any]:
        """The names of the columns: ``degree1_row0_column2``, with the place of the degree among those that were fitted."""
        columns, rows = (range(int(count)) for count in self.resolution)
        names = [f"degree{place}_row{row}_column{column}" for place in range(self.degree_count_) for row in rows for column in columns]
        return np.array(names, dtype=object)


class BettiCurves(TransformerMixin, BaseEstimator):  # type: ignore[misc]
    """Diagrams as rows of one length: how many classes live at each of some values.

    A class that is born at b and dies at d lives at v if b <= v < d; where values fall, if d < v <= b, or v <= b if it never dies.

    Parameters
    ----------
    bins
        The number of values, evenly spaced.
    limits
        The first and the last value; the least and the greatest finite number of what is fitted if left out.
    upper
        Whether the diagrams are of values that fall, as :class:`Diagrams` makes them.

    Examples
    --------
    >>> BettiCurves(bins=3, limits=(0, 2)).fit_transform([[np.array([[0.0, np.inf], [1.0, 2.0]])]])
    array([[1., 2., 1.]])
    """

    def __init__(self, bins: int = 32, *, limits: tuple[float, float] | None = None, upper: bool = False) -> None:
        self.bins = bins
        self.limits = limits
        self.upper = upper

    @in_words
    def fit(self, X: Sequence[Sequence[Any]], y: Any = None) -> BettiCurves:
        """Finds the limits, unless they are given."""
        if isinstance(self.bins, bool) or not isinstance(self.bins, (int, np.integer)) or self.bins < 1:
            raise_invalid(f"bins is {self.bins!r}", "give an integer from 1")
        if self.limits is None:
            numbers = np.concatenate([np.zeros(0), *(np.asarray(diagram, float).reshape(-1) for sample in X for diagram in sample)])
            finite = numbers[np.isfinite(numbers)]
            low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
        else:
            low, high = map(float, self.limits)
        if not low <= high or not np.isfinite([low, high]).all():
            raise_invalid(f"limits are {low} and {high}", "give two finite numbers, the lesser one first")
        self.values_ = np.linspace(low, high, int(self.bins))
        self.degree_count_ = len(X[0]) if len(X) else 0
        return self

    @in_words
    def transform(self, X: Sequence[Sequence[Any]]) -> NDArray[np.float64]:
        """An array with a row for each sample: the curves of its degrees, one behind the other."""
        needed("sklearn.utils.validation", "coface.interop.sklearn").check_is_fitted(self)
        rows = []
        for place, sample in enumerate(X):
            if len(sample) != self.degree_count_:
                raise_invalid(
                    f"sample {place} has {len(sample)} diagrams, and {self.degree_count_} were fitted",
                    "give diagrams of the same degrees as to fit",
                )
            rows.append(np.concatenate([np.zeros(0), *(self._curve(np.asarray(diagram, float).reshape(-1, 2)) for diagram in sample)]))
        return np.array(rows).reshape(len(rows), self.degree_count_ * len(self.values_))

    def _curve(self, diagram: NDArray[np.float64]) -> NDArray[np.float64]:
        births, deaths, values = diagram[:, :1], diagram[:, 1:], self.values_
        dies = np.isfinite(deaths)
        wrong = dies & ((births < deaths) if self.upper else (deaths < births))
        if wrong.any():
            pair = diagram[np.flatnonzero(wrong)[0]].tolist()
            cure = "make BettiCurves without upper" if self.upper else "make BettiCurves with upper=True"
            raise_invalid(f"the class {pair} of a diagram dies on the wrong side of its birth", cure)
        lives = (values <= births) & (~dies | (deaths < values)) if self.upper else (births <= values) & (~dies | (values < deaths))
        counts: NDArray[np.float64] = lives.sum(axis=0).astype(np.float64)
        return counts

    def get_feature_names_out(self, input_features: Any = None) -> NDArray[Any]:
        """The names of the columns: ``degree1_at_2.5``, with the place of the degree among those that were fitted."""
        names = [f"degree{place}_at_{value!r}" for place in range(self.degree_count_) for value in self.values_.tolist()]
        return np.array(names, dtype=object)
