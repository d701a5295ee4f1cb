"""scikit-image: arrays of labels. Nothing of it is imported: labels are arrays of integers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import Model
from coface._faults import in_words
from coface._volumes import volume


@in_words
def from_labels(
    labels: Any,
    *,
    only: Iterable[int] | None = None,
    background: int = 0,
    spacing: Sequence[float] | None = None,
    surface: bool = False,
    periodic: Sequence[int] = (),
) -> dict[int, Model]:
    """A model for each label of an image, as ``skimage.measure.label`` and segmentations make them.

    Parameters
    ----------
    labels
        An array of integers, of 1 to 8 axes.
    only
        The labels that are wanted; all but the background if left out.
    background
        The label that is none.
    spacing
        How long a voxel is along each axis; models are meshes then.
    surface
        Whether models are the squares around the voxels of a label, turned outward.
    periodic
        The axes whose last voxel meets their first.

    Returns
    -------
    dict of int to Model
        Labels in rising order: volumes, or meshes with `spacing` or `surface`. Names of inputs where they go to :func:`coface.arrange`.

    Examples
    --------
    >>> import coface, numpy as np
    >>> image = np.zeros((5, 5), int); image[1:4, 1:4] = 7; image[2, 2] = 3
    >>> {label: str(coface.homology(part)) for label, part in coface.from_labels(image).items()}
    {3: 'Homology(Z)', 7: 'Homology(Z, Z)'}
    """
    image = np.asarray(labels)
    if image.dtype.kind not in "iub":
        raise_invalid(f"an array of {image.dtype} has no labels", "give integers, such as skimage.measure.label(mask)")
    found = np.unique(image)
    wanted = [int(label) for label in found if label != background] if only is None else sorted({int(label) for label in only})
    missing = [label for label in wanted if label not in found]
    if missing:
        raise_invalid(f"the image has no voxel of label {missing[0]}", "leave only out, or give labels that are there")
    models = {label: volume(image == label, periodic=periodic) for label in wanted}
    if spacing is None and not surface:
        return models
    return {label: model.to_model(surface=surface, spacing=spacing) for label, model in models.items()}
