"""Complexes larger than memory: cut into shards, reduced one by one, merged up a tree.

A **shard** is a part of a complex as bytes. A **reduced shard** is what is left of it, critical cells with their exact boundaries; reduced shards of
neighbors are merged level after level to the **root**, which has the integral homology of the whole. The same bytes in give the same bytes out, so
shards may be reduced anywhere: by :func:`homology` here, by the program, or over Ray (:func:`coface.ray.homology`).

Examples
--------
>>> import coface.shards, tempfile
>>> folder = tempfile.mkdtemp()
>>> coface.shards.shard(coface.generate("torus"), folder, 4)
4
>>> found = coface.shards.homology(folder)
>>> found.homology
Homology(Z, Z^2, Z)
>>> found.levels[0].parts, found.levels[-1].parts
(4, 1)
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from coface import _coface
from coface._arrays import raise_invalid
from coface._blocks import ImageCut, image_to_cut
from coface._coface import Homology, Persistence
from coface._faults import in_words
from coface._models import as_model

__all__ = ["Level", "ShardHomology", "Tree", "checksum", "homology", "merge", "persistence", "reduce", "root_homology", "shard", "summary"]

_Path = str | os.PathLike[str]
_Progress = bool | Callable[[str, int, int], object] | None


@dataclass(frozen=True)
class Tree:
    """How the shards of a complex are merged, as ``shards.json`` says it."""

    #: A number that shards of this complex, cut in this way, have.
    complex: int
    #: The number of shards.
    parts: int
    #: How many neighbors are merged at once.
    fan_in: int

    @classmethod
    def of_manifest(cls, manifest: dict[str, Any]) -> Tree:
        """The tree in a ``shards.json``."""
        return cls(int(manifest["complex"], 16), int(manifest["parts"]), int(manifest["fan_in"]))

    def width(self, level: int) -> int:
        """How many reduced shards a level has.

        Examples
        --------
        >>> [Tree(7, 10, 4).width(level) for level in range(4)]
        [10, 3, 1, 1]
        """
        width = self.parts
        for _ in range(level):
            width = -(-width // self.fan_in)
        return width

    def children(self, level: int, number: int) -> range:
        """The numbers of those of the level below that are merged to one.

        Examples
        --------
        >>> Tree(7, 10, 4).children(1, 2)
        range(8, 10)
        """
        below = self.width(level - 1)
        return range(min(number * self.fan_in, below), min((number + 1) * self.fan_in, below))


@dataclass(frozen=True)
class Level:
    """The reduced shards of one level together."""

    #: How many there are.
    parts: int
    #: The strata before the level was reduced.
    strata: int
    #: The critical cells in each degree.
    critical: list[int]
    #: The bytes of all: what is sent to the next level.
    bytes: int

    @property
    def critical_per_stratum(self) -> float:
        """Critical cells for each stratum: 1 where all strata are balls."""
        return sum(self.critical) / max(self.strata, 1)


@dataclass(frozen=True)
class ShardHomology:
    """What shards say together."""

    #: The integral homology of the whole.
    homology: Homology
    #: The number of cells of the whole in each degree.
    cells: list[int]
    #: The levels, from the shards on.
    levels: list[Level]
    #: How many reduced shards this call made; the others were finished before.
    made: int = 0

    @property
    def bytes_sent(self) -> int:
        """The bytes of all reduced shards but the root."""
        return sum(level.bytes for level in self.levels[:-1])


@in_words
def shard(
    model: Any,
    folder: _Path,
    parts: int = 0,
    *,
    memory: int | None = None,
    fan_in: int = 8,
    name: str = "model",
    replace: bool = False,
    progress: _Progress = False,
) -> int:
    """Cut a model into shards in a folder.

    Parameters
    ----------
    model
        Anything that :func:`coface.as_model` understands.
    folder
        Where the shards go, with ``shards.json``.
    parts
        The number of shards; 0 for as many as `memory` asks for.
    memory
        The bytes that reducing a shard may take, as far as that can be estimated.
    fan_in
        How many neighbors are merged at once.
    name
        What the model is called in reports.
    replace
        Whether shards of another complex in the folder are replaced.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    int
        The number of shards.
    """
    return _coface._shard(as_model(model), folder, parts, memory, fan_in, name, replace, progress)


@in_words
def reduce(shard: bytes, *, progress: _Progress = False) -> bytes:
    """What is left of a shard."""
    return _coface._reduce(shard, progress)


@in_words
def merge(children: Iterable[bytes], tree: Tree, level: int, number: int, *, progress: _Progress = False) -> bytes:
    """The reduced shard of a place, from those of ``tree.children(level, number)`` in their order."""
    return _coface._merge(list(children), tree.complex, tree.parts, tree.fan_in, level, number, progress)


@in_words
def summary(reduced: bytes) -> dict[str, Any]:
    """The counts of a reduced shard: ``level``, ``number``, ``cells``, ``strata``, ``critical``, ``bytes``, ``is_root``, ``checksum``, ``sources``."""
    return _coface._summary(reduced)


@in_words
def checksum(start: bytes, length: int) -> int:
    """The checksum that a shard, or a reduced one, says it has.

    Parameters
    ----------
    start
        Its first 64 bytes at least.
    length
        The bytes of all of it.
    """
    return _coface._shard_checksum(start, length)


@in_words
def root_homology(root: bytes) -> Homology:
    """The homology of the whole, from the reduced shard that is the root."""
    return _coface._root_homology(root)


@in_words
def homology(folder: _Path, *, replace: bool = False, progress: _Progress = False) -> ShardHomology:
    """Reduce the shards of a folder one by one and merge them.

    What is finished, and made from what is there, is not made again unless `replace` is set, so that a call that was cut short goes on where it
    was. The reduced shards in the folder are its journal: each says of which shards it was made, and files appear whole or not at all.

    Parameters
    ----------
    folder
        The folder that :func:`shard` or ``coface shard`` made.
    replace
        Whether finished reduced shards are made again.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    ShardHomology
        Homology, cells and levels; ``made`` counts what was made by this call.
    """
    found, cells, levels, made = _coface._folder_homology(folder, replace, progress)
    return ShardHomology(found, cells, [Level(**level) for level in levels], made)


@in_words
def persistence(
    x: Any,
    block: int | Sequence[int] = 128,
    *,
    construction: Literal["t", "v"] = "t",
    superlevel: bool = False,
    periodic: Sequence[int] = (),
    coefficients: str | int = "f2",
    least: float = 0.0,
    fan_in: int = 8,
    progress: _Progress = False,
) -> Persistence:
    """Persistent homology of an image, block by block: the diagram of :func:`coface.cubical`, bit for bit.

    Of each block the pairs are listed that no other block can change, and its other critical cells are kept, with what their boundaries flow down to; neighbors
    are merged level after level. At no time is more than a block held, beside pairs and what is left of the others, which lies near the sides of blocks.

    Parameters
    ----------
    x
        An array of numbers with one to four axes, or the path of an ``.npy`` file, of which a block at a time is read. Other files of volumes are read whole.
        A voxel that is NaN, or that a masked array masks, never enters.
    block
        The voxels of a block along each axis, or one number for all axes.
    construction, superlevel, periodic, coefficients, least
        As those of :func:`coface.cubical`.
    fan_in
        How many neighbors are merged at once, 2 at least.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        As of :func:`coface.cubical`, without cycles.

    Examples
    --------
    Two valleys with a pass between them, two voxels at a time:

    >>> import coface.shards
    >>> coface.shards.persistence([0, 5, 1, 2], 2).diagram(0)
    array([[ 0., inf],
           [ 1.,  5.]])
    """
    image, shape = image_to_cut(x)
    cut = ImageCut.of(shape, block, construction, superlevel, periodic, coefficients)
    tree = image_tree(cut, fan_in)
    tell = progress if callable(progress) else None
    parts = []
    for number in range(tree.parts):
        parts.append(cut.part(number, cut.window(image, number)))
        if tell is not None:
            tell("reducing blocks", number + 1, tree.parts)
    level = 0
    while len(parts) > 1:
        level += 1
        children = [tree.children(level, number) for number in range(tree.width(level))]
        parts = [_coface._merge_image_parts([parts[child] for child in group]) for group in children]
        if tell is not None:
            tell(f"merging blocks to level {level}", len(parts), len(parts))
    return cut.diagram(parts[0], least, progress)


def image_tree(cut: ImageCut, fan_in: int) -> Tree:
    """How the parts of an image are merged."""
    if fan_in < 2:
        raise_invalid(f"parts cannot be merged by groups of {fan_in}", "take a fan_in of 2 or more")
    return Tree(0, cut.count, fan_in)
