"""scikit-learn: persistence as steps of a pipeline. Only this file imports scikit-learn, so it is asked for by its name.

Examples
--------
>>> import numpy as np, pytest
>>> _ = pytest.importorskip("sklearn")
>>> from coface.interop.sklearn import BettiCurves, Diagrams
>>> from sklearn.pipeline import make_pipeline
>>> ring = np.array([[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 0.0]])
>>> make_pipeline(Diagrams(), BettiCurves(bins=3, limits=(0, 9))).fit_transform([ring])
array([[1., 1., 1., 1., 1., 0.]])
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coface._arrays import raise_invalid
from coface._faults import in_words
from coface._models import as_chain_complex
from coface._questions import cubical, persistence
from coface._volumes import volume
from coface.interop import needed

needed("sklearn.base", "coface.interop.sklearn")
from sklearn.base import BaseEstimator, TransformerMixin  # noqa: E402

__all__ = ["BettiCurves", "Diagrams"]


class Diagrams(TransformerMixin, BaseEstimator):  # type: ignore[misc]
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

    def fit(self, X: Iterable[Any], y: Any = None) -> Diagrams:
        """Nothing is learned."""
        return self

    def __sklearn_is_fitted__(self) -> bool:
        return True

    @in_words
    def transform(self, X: Iterable[Any]) -> list[list[NDArray[np.float64]]]:
        """For each sample, for each degree, an array ``(n, 2)`` of births and deaths."""
        return [self._diagrams(sample) for sample in X]

    def _diagrams(self, sample: Any) -> list[NDArray[np.float64]]:
        options: dict[str, Any] = {"coefficients": self.coefficients, "least": self.least}
        if isinstance(sample, tuple) and len(sample) == 2:
            answer = persistence(sample[0], sample[1], upper=self.upper, **options)
            return [answer.diagram(degree) for degree in self.degrees]
        image = np.asarray(sample)
        if image.dtype.kind not in "biuf" or not 1 <= image.ndim <= 8 or not image.size:
            raise_invalid(
                f"a sample has the type {image.dtype} and the shape {image.shape}",
                "give images, arrays of numbers with 1 to 8 axes, or pairs (space, values)",
            )
        values = image.reshape(-1).astype(np.float64)
        if np.isnan(values).any():
            raise_invalid("an image has voxels that are NaN", "give them a number, such as numpy.inf for the last to come")
        if image.ndim <= 4 and self.least >= 0.0:
            answer = cubical(image, superlevel=self.upper, **options)
            return [answer.diagram(degree) for degree in self.degrees]
        complex = as_chain_complex(volume(np.ones(image.shape, bool)))
        later = [np.full(count, np.nan) for count in complex.f_vector[:-1]]
        answer = persistence(complex, cell_values=[*later, -values if self.upper else values], **options)
        found = [answer.diagram(degree) for degree in self.degrees]
        return [_falling(diagram) for diagram in found] if self.upper else found


def _falling(diagram: NDArray[np.float64]) -> NDArray[np.float64]:
    """The diagram of values whose negative this one is about; what never dies dies at infinity here too."""
    # Taken from 0, since the negative of 0.0 is -0.0.
    found: NDArray[np.float64] = 0.0 - diagram
    found[np.isneginf(found[:, 1]), 1] = np.inf
    return found


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
