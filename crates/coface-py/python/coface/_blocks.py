"""Persistence of images by blocks: how an image is cut, and what is left of a block."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from coface import _coface
from coface._arrays import numbers, raise_invalid
from coface._questions import image_of
from coface._volumes import voxel_rule

__all__ = ["ImageCut", "image_to_cut"]


@dataclass(frozen=True)
class ImageCut:
    """How an image is cut into blocks, and what is asked about it."""

    #: The voxels of the image along each axis.
    shape: tuple[int, ...]
    #: The voxels of a block along each axis.
    block: tuple[int, ...]
    construction: str
    superlevel: bool
    #: For each axis whether it is periodic.
    periodic: tuple[bool, ...]
    coefficients: str | int

    @classmethod
    def of(
        cls,
        shape: Sequence[int],
        block: int | Sequence[int],
        construction: str,
        superlevel: bool,
        periodic: Sequence[int],
        coefficients: str | int,
    ) -> ImageCut:
        """The cut with blocks of this shape, or of so many voxels along each axis."""
        _, _, axes = voxel_rule(periodic=periodic)
        for axis in axes:
            if axis >= len(shape):
                raise_invalid(f"axis {axis} of an image with {len(shape)} axes", "number axes from 0")
        sides = [block] * len(shape) if isinstance(block, int) else list(block)
        if len(sides) != len(shape) or any(int(side) < 1 for side in sides):
            raise_invalid(
                f"blocks of shape {tuple(sides)} for an image of shape {tuple(shape)}",
                "give the voxels of a block along each axis, one or more, or one number for all axes",
            )
        return cls(
            tuple(int(length) for length in shape),
            tuple(int(side) for side in sides),
            construction,
            superlevel,
            tuple(axis in axes for axis in range(len(shape))),
            coefficients,
        )

    @property
    def words(self) -> tuple[Any, ...]:
        """It in the words of the compiled part."""
        return (list(self.shape), list(self.block), self.construction, self.superlevel, list(self.periodic), self.coefficients)

    @property
    def count(self) -> int:
        """The number of blocks."""
        return _coface._image_block_count(self.words)

    def window(self, x: Any, number: int) -> np.ndarray[Any, np.dtype[np.float64]]:
        """The numbers of a block and of the layer around it: of an array, or of an ``.npy`` file, of which no more is read."""
        if isinstance(x, str):
            x = np.load(x, mmap_mode="r", allow_pickle=False)
        taken = x[np.ix_(*_coface._image_window(self.words, number))]
        taken = taken if taken.dtype == np.float32 else numbers(taken, "x")
        return np.ascontiguousarray(taken, dtype=np.float64)

    def source(self, number: int, window: Any) -> int:
        """The checksum that the part of a block names as its source."""
        return _coface._image_window_checksum(self.words, number, window)

    def part(self, number: int, window: Any) -> bytes:
        """What is left of a block."""
        return _coface._image_part(self.words, number, window)

    def diagram(self, root: bytes, least: float, progress: Any) -> _coface.Persistence:
        """The diagram, from the part of all blocks."""
        return _coface._image_part_diagram(root, self.construction, any(self.periodic), least, progress)


def image_to_cut(x: Any) -> tuple[Any, tuple[int, ...]]:
    """An image of which windows are taken, and its shape: an array, or the path of an ``.npy`` file with real numbers, which is not read."""
    if isinstance(x, (str, os.PathLike)) and os.fspath(x).endswith(".npy"):
        path = os.path.abspath(os.fspath(x))
        try:
            shape = np.load(path, mmap_mode="r", allow_pickle=False).shape
        except FileNotFoundError:
            raise_invalid(f"there is no file {path!r}", "check the path")
        except ValueError as fault:
            raise_invalid(f"{path!r} is no array of numbers: {fault}", "write it by numpy.save")
        if not shape:
            raise_invalid("an array without axes has no voxels", "give an array with one to four axes")
        return path, shape
    values, mask = image_of(x, None)
    if mask is not None:
        if mask.shape != values.shape:
            raise_invalid(f"the mask has the shape {mask.shape}, and the image {values.shape}", "give a mask of the shape of the image")
        values = np.where(mask, values, np.float32("nan") if values.dtype == np.float32 else np.nan)
    return values, values.shape
