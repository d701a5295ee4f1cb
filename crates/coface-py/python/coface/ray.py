"""Work on a cluster, or on the cores of one machine, by Ray.

``ray`` is imported here alone: ``import coface.ray`` needs ``pip install "ray[data]" fsspec``. Ray schedules, retries tasks of workers that died
and moves results; what each task does is what the program does on one machine, so the results are the same bytes.

Call ``ray.init(address=...)`` first to use a cluster. Otherwise Ray is started on this machine, without its dashboard and usage report.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, overload

import ray

import coface
from coface import _coface
from coface._batch import (
    MEMORY,
    BatchRow,
    BatchSummary,
    _Path,
    _Progress,
    find_files,
    row_of,
    words_of_voxels,
    worker_options,
    write_lines,
)
from coface._blocks import ImageCut, image_to_cut
from coface._faults import in_words
from coface._journal import Journal
from coface._progress import Bar
from coface.shards import Level, ShardHomology, Tree, checksum, image_tree, merge, reduce, root_homology, summary

__all__ = ["batch", "homology", "persistence", "start"]


def start(**options: Any) -> None:
    """Start Ray on this machine unless it runs, without dashboard and usage report.

    `options` go to ``ray.init``.
    """
    if ray.is_initialized():
        return
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    ray.init(**{"include_dashboard": False, "log_to_driver": False, **options})


@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: None = None,
    *,
    flat: Literal[True] = ...,
    recursive: bool = ...,
    timeout: float | None = ...,
    memory: int | None = ...,
    format: str | None = ...,
    flatten: float | None = ...,
    strict: bool = ...,
    partial: bool = ...,
    allow_outside: bool = ...,
    threshold: float | None = ...,
    below: float | None = ...,
    between: tuple[float, float] | None = ...,
    value: float | None = ...,
    periodic: Sequence[int] = ...,
    voxels: Mapping[str, Any] | None = ...,
    all_places: bool = ...,
    timings: bool = ...,
    restart: bool = ...,
    files_per_task: int = ...,
    progress: bool = ...,
) -> list[BatchRow]: ...
@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: None = None,
    *,
    flat: bool,
    recursive: bool = ...,
    timeout: float | None = ...,
    memory: int | None = ...,
    format: str | None = ...,
    flatten: float | None = ...,
    strict: bool = ...,
    partial: bool = ...,
    allow_outside: bool = ...,
    threshold: float | None = ...,
    below: float | None = ...,
    between: tuple[float, float] | None = ...,
    value: float | None = ...,
    periodic: Sequence[int] = ...,
    voxels: Mapping[str, Any] | None = ...,
    all_places: bool = ...,
    timings: bool = ...,
    restart: bool = ...,
    files_per_task: int = ...,
    progress: bool = ...,
) -> list[dict[str, Any]]: ...
@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path,
    *,
    flat: bool = ...,
    recursive: bool = ...,
    timeout: float | None = ...,
    memory: int | None = ...,
    format: str | None = ...,
    flatten: float | None = ...,
    strict: bool = ...,
    partial: bool = ...,
    allow_outside: bool = ...,
    threshold: float | None = ...,
    below: float | None = ...,
    between: tuple[float, float] | None = ...,
    value: float | None = ...,
    periodic: Sequence[int] = ...,
    voxels: Mapping[str, Any] | None = ...,
    all_places: bool = ...,
    timings: bool = ...,
    restart: bool = ...,
    files_per_task: int = ...,
    progress: bool = ...,
) -> BatchSummary: ...
@in_words
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path | None = None,
    *,
    flat: bool = True,
    recursive: bool = False,
    timeout: float | None = 60.0,
    memory: int | None = MEMORY,
    format: str | None = None,
    flatten: float | None = None,
    strict: bool = False,
    partial: bool = False,
    allow_outside: bool = False,
    threshold: float | None = None,
    below: float | None = None,
    between: tuple[float, float] | None = None,
    value: float | None = None,
    periodic: Sequence[int] = (),
    voxels: Mapping[str, Any] | None = None,
    all_places: bool = False,
    timings: bool = True,
    restart: bool = False,
    files_per_task: int = 64,
    progress: bool = False,
) -> list[BatchRow] | list[dict[str, Any]] | BatchSummary:
    """Report on many files as :func:`coface.batch` does, over Ray Data.

    Paths of files are read where tasks run, so they are on a folder that all machines share, or URLs of fsspec. Each task has a worker process
    of its own for its files, with the limits of one file.

    Parameters
    ----------
    paths, flat, recursive, timeout, memory, format, flatten, strict, partial, allow_outside, threshold, below, between, value, periodic, voxels,
    all_places, timings
        As those of :func:`coface.batch`; folders and patterns are looked up here.
    out
        A file to write the rows to instead: ``.jsonl``, ``.csv`` or ``.parquet``. It appears whole at the end. Until then finished rows stand in a journal
        beside it, ``.NAME.ray-journal``: a call that was cut short goes on where it was, and rows whose files have changed are made again.
    restart
        Whether rows that an earlier call finished are done again.
    files_per_task
        How many files one task reads.
    progress
        Whether Ray shows its bars.

    Returns
    -------
    list of dict, or BatchSummary
        As :func:`coface.batch`: the same rows in the same order.
    """
    start()
    files = find_files(paths, recursive)
    options: dict[str, Any] = {
        "timeout": timeout, "memory": memory, "format": format, "flatten": flatten,
        "strict": strict, "partial": partial, "allow_outside": allow_outside,
        "voxels": words_of_voxels(voxels, threshold=threshold, below=below, between=between, value=value, periodic=periodic),
        "all_places": all_places, "timings": timings,
    }  # fmt: skip
    # A fault in the options is one of this call, not of each task.
    worker_options(jobs=1, restart=False, **options)
    if out is None:
        return [row_of(line, flat, timings) for line in _lines(files, options, files_per_task, progress)]
    target = Path(out)
    with Journal(target, options, restart) as journal:
        finished = journal.rows(files)
        left = [file for file in files if file not in finished]
        made = iter(_lines(left, options, files_per_task, progress))

        def lines() -> Iterator[str]:
            for file in files:
                if file in finished:
                    yield finished[file]
                else:
                    line = next(made)
                    journal.add(file, line)
                    yield line

        said = write_lines(lines(), target, timings)
        journal.remove()
    return {**said, "resumed": len(finished)}


def _lines(files: list[str], options: dict[str, Any], files_per_task: int, progress: bool) -> Iterator[str]:
    """The rows of files as lines of JSON, in their order, as they come."""
    import ray.data

    if not files:
        return
    # A data set keeps the context it was made in.
    context = ray.data.DataContext.get_current()
    before = context.execution_options.preserve_order, context.enable_progress_bars
    context.execution_options.preserve_order, context.enable_progress_bars = True, progress
    try:
        blocks = -(-len(files) // files_per_task)
        rows = ray.data.from_items([{"path": path} for path in files], override_num_blocks=max(1, blocks))
        rows = rows.map_batches(_examine, batch_size=files_per_task, fn_kwargs={"options": options}, num_cpus=1)
    finally:
        context.execution_options.preserve_order, context.enable_progress_bars = before
    for row in rows.iter_rows():
        yield row["line"]


def _examine(files: dict[str, Any], options: dict[str, Any]) -> dict[str, list[str]]:
    """The rows of files: one task."""
    paths = [str(path) for path in files["path"]]
    options_of_workers = worker_options(jobs=1, restart=False, **options)
    return {"line": _coface._batch_lines(paths, options_of_workers)}


@in_words
def homology(
    folder: _Path,
    *,
    write: bool = True,
    replace: bool = False,
    retries: int = 3,
    progress: _Progress = False,
) -> ShardHomology:
    """The integral homology of shards in a folder: a task of Ray for each shard, and one for each merge of the tree.

    What is left of shards goes from task to task as objects of Ray. A task whose worker died is done again by Ray; the bytes are the same. A reduced shard
    that stands in the folder, whole and made of the shards that are there, is read and not made again, so that a call that was cut short goes on where it was.

    Parameters
    ----------
    folder
        A folder that all machines share, or a URL of fsspec, with the shards that ``coface shard`` or :func:`coface.shards.shard` made.
    write
        Whether reduced shards are written to the folder too, with the names and bytes that ``coface merge`` gives them.
    replace
        Whether finished reduced shards are made again.
    retries
        How often Ray does a task again whose worker died.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    ShardHomology
        Homology, cells, and for each level its strata, critical cells and bytes; ``made`` counts the reduced shards that were made now.
    """
    import fsspec

    start()
    root = os.fspath(folder)
    with fsspec.open(f"{root}/shards.json", "rb") as file:
        tree = Tree.of_manifest(json.load(file))
    options = {"num_returns": 2, "max_retries": retries}
    reduce_task = ray.remote(_reduce_task).options(**options)
    merge_task = ray.remote(_merge_task).options(**options)
    with _Told(progress) as told:
        found = [reduce_task.remote(root, number, write, replace) for number in range(tree.parts)]
        told("reducing parts", [said for _, said in found])
        levels = [[said for _, said in found]]
        while len(found) > 1 or not ray.get(found[0][1])["is_root"]:
            level = len(levels)
            found = [
                merge_task.remote(root, tree, level, number, write, replace, *(found[child][0] for child in tree.children(level, number)))
                for number in range(tree.width(level))
            ]
            told(f"merging parts to level {level}", [said for _, said in found])
            levels.append([said for _, said in found])
    said = [ray.get(level) for level in levels]
    made = sum(part["is_new"] for level in said for part in level)
    return ShardHomology(root_homology(ray.get(found[0][0])), ray.get(found[0][1])["cells"], [_level(level) for level in said], made)


def _reduce_task(folder: str, number: int, write: bool, replace: bool) -> tuple[bytes, dict[str, Any]]:
    """What is left of a shard, and its counts."""
    import fsspec

    source, target = f"{folder}/part-{number:06}.shard", f"{folder}/part-{number:06}.reduced"
    system, path = fsspec.core.url_to_fs(source)
    if not replace:
        found = _finished(target, [checksum(system.cat_file(path, end=64), system.size(path))])
        if found is not None:
            return found
    reduced = reduce(system.cat_file(path))
    if write:
        _put(target, reduced)
    return reduced, {**summary(reduced), "is_new": True}


def _merge_task(folder: str, tree: Tree, level: int, number: int, write: bool, replace: bool, *children: bytes) -> tuple[bytes, dict[str, Any]]:
    """What is left of some neighbors together, and its counts."""
    target = f"{folder}/level-{level}-{number:06}.reduced"
    if not replace:
        found = _finished(target, [summary(child)["checksum"] for child in children])
        if found is not None:
            return found
    reduced = merge(children, tree, level, number)
    if write:
        _put(target, reduced)
    return reduced, {**summary(reduced), "is_new": True}


def _finished(url: str, sources: list[int]) -> tuple[bytes, dict[str, Any]] | None:
    """A reduced shard that is there, whole and made of these sources, and its counts."""
    import fsspec

    system, path = fsspec.core.url_to_fs(url)
    try:
        reduced = system.cat_file(path)
    except FileNotFoundError:
        return None
    try:
        counts = summary(reduced)
    except coface.Error:
        # Damaged, or of another version: it is made again.
        return None
    return (reduced, {**counts, "is_new": False}) if list(counts["sources"]) == sources else None


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
    folder: _Path | None = None,
    replace: bool = False,
    retries: int = 3,
    progress: _Progress = False,
) -> coface.Persistence:
    """Persistent homology of an image: a task of Ray for each block, and one for each merge of neighbors.

    The diagram is that of :func:`coface.cubical`, bit for bit. A task whose worker died is done again by Ray; the bytes are the same.

    Parameters
    ----------
    x, block, construction, superlevel, periodic, coefficients, least, fan_in
        As those of :func:`coface.shards.persistence`. The path of an ``.npy`` file is opened where tasks run, so it is in a folder that all machines share; an
        array is an object of Ray.
    folder
        A folder that all machines share, or a URL of fsspec, that what is left of blocks is written to. What stands there, whole and made of the same numbers
        and options, is read and not made again, so that a call that was cut short goes on where it was.
    replace
        Whether what stands in the folder is made again.
    retries
        How often Ray does a task again whose worker died.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        As of :func:`coface.cubical`, without cycles.
    """
    image, shape = image_to_cut(x)
    cut = ImageCut.of(shape, block, construction, superlevel, periodic, coefficients)
    tree = image_tree(cut, fan_in)
    start()
    root = None if folder is None else os.fspath(folder)
    if root is not None:
        import fsspec

        system, path = fsspec.core.url_to_fs(root)
        system.makedirs(path, exist_ok=True)
    block_task = ray.remote(_block_task).options(max_retries=retries)
    merge_task = ray.remote(_merge_blocks_task).options(max_retries=retries)
    given = image if isinstance(image, str) else ray.put(image)
    with _Told(progress) as told:
        found = [block_task.remote(given, cut, number, root, replace) for number in range(tree.parts)]
        told("reducing blocks", found)
        level = 0
        while len(found) > 1:
            level += 1
            found = [
                merge_task.remote(level, number, root, replace, *(found[child] for child in tree.children(level, number)))
                for number in range(tree.width(level))
            ]
            told(f"merging blocks to level {level}", found)
    return cut.diagram(ray.get(found[0]), least, None)


def _block_task(x: Any, cut: ImageCut, number: int, folder: str | None, replace: bool) -> bytes:
    """What is left of a block."""
    window = cut.window(x, number)
    target = f"{folder}/block-{number:06}.part"
    if folder is not None and not replace:
        found = _finished_part(target, [cut.source(number, window)])
        if found is not None:
            return found
    part = cut.part(number, window)
    if folder is not None:
        _put(target, part)
    return part


def _merge_blocks_task(level: int, number: int, folder: str | None, replace: bool, *children: bytes) -> bytes:
    """What is left of some blocks together."""
    target = f"{folder}/blocks-{level}-{number:06}.part"
    if folder is not None and not replace:
        found = _finished_part(target, [_coface._image_part_summary(child)["checksum"] for child in children])
        if found is not None:
            return found
    part = _coface._merge_image_parts(list(children))
    if folder is not None:
        _put(target, part)
    return part


def _finished_part(url: str, sources: list[int]) -> bytes | None:
    """A part of an image that is there, whole and made of these sources."""
    import fsspec

    system, path = fsspec.core.url_to_fs(url)
    try:
        part: bytes = system.cat_file(path)
    except FileNotFoundError:
        return None
    try:
        counts = _coface._image_part_summary(part)
    except coface.Error:
        # Damaged, or of another version: it is made again.
        return None
    return part if list(counts["sources"]) == sources else None


def _put(url: str, content: bytes) -> None:
    """Write a file that appears whole: where files are not objects, by way of a temporary one."""
    import fsspec

    system, path = fsspec.core.url_to_fs(url)
    if "file" not in (system.protocol if isinstance(system.protocol, tuple) else (system.protocol,)):
        system.pipe_file(path, content)
        return
    hidden = f"{path}.{os.getpid()}.part"
    system.pipe_file(hidden, content)
    os.replace(hidden, path)


def _level(parts: list[dict[str, Any]]) -> Level:
    """The counts of a level from those of its parts."""
    degrees = max(len(part["critical"]) for part in parts)
    critical = [sum(part["critical"][k] for part in parts if k < len(part["critical"])) for k in range(degrees)]
    return Level(len(parts), sum(part["strata"] for part in parts), critical, sum(part["bytes"] for part in parts))


class _Told:
    """Waits for the tasks of a stage, and reports how many are done."""

    def __init__(self, progress: _Progress) -> None:
        self._bar = Bar() if progress is True else None
        self._tell = self._bar if self._bar is not None else (progress if callable(progress) else None)

    def __enter__(self) -> _Told:
        return self

    def __exit__(self, *fault: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def __call__(self, stage: str, tasks: list[Any]) -> None:
        left = list(tasks)
        while left:
            done, left = ray.wait(left)
            # Raises what a task raised.
            ray.get(done)
            if self._tell is not None:
                self._tell(stage, len(tasks) - len(left), len(tasks))
