"""Work on a cluster, or on the cores of one machine, by Ray.

``ray`` is imported here alone: ``import coface.ray`` needs ``pip install "ray[data]" fsspec``. Ray schedules, retries tasks of workers that died
and moves results; what each task does is what the program does on one machine, so the results are the same bytes.

Call ``ray.init(address=...)`` first to use a cluster. Otherwise Ray is started on this machine, without its dashboard and usage report.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any, overload

import ray

from coface import _coface
from coface._batch import MEMORY, BatchSummary, _Path, find_files, worker_options, write_lines

__all__ = ["batch", "start"]


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
    recursive: bool = ...,
    timeout: float | None = ...,
    memory: int | None = ...,
    format: str | None = ...,
    flatten: float | None = ...,
    all_places: bool = ...,
    timings: bool = ...,
    files_per_task: int = ...,
    progress: bool = ...,
) -> list[dict[str, Any]]: ...
@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path,
    *,
    recursive: bool = ...,
    timeout: float | None = ...,
    memory: int | None = ...,
    format: str | None = ...,
    flatten: float | None = ...,
    all_places: bool = ...,
    timings: bool = ...,
    files_per_task: int = ...,
    progress: bool = ...,
) -> BatchSummary: ...
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path | None = None,
    *,
    recursive: bool = False,
    timeout: float | None = 60.0,
    memory: int | None = MEMORY,
    format: str | None = None,
    flatten: float | None = None,
    all_places: bool = False,
    timings: bool = True,
    files_per_task: int = 64,
    progress: bool = False,
) -> list[dict[str, Any]] | BatchSummary:
    """Report on many files as :func:`coface.batch` does, over Ray Data.

    Paths of files are read where tasks run, so they are on a folder that all machines share, or URLs of fsspec. Each task has a worker process
    of its own for its files, with the limits of one file.

    Parameters
    ----------
    paths, recursive, timeout, memory, format, flatten, all_places, timings
        As those of :func:`coface.batch`; folders and patterns are looked up here.
    out
        A file to write the rows to instead: ``.jsonl``, ``.csv`` or ``.parquet``. It appears whole at the end.
    files_per_task
        How many files one task reads.
    progress
        Whether Ray shows its bars.

    Returns
    -------
    list of dict, or BatchSummary
        As :func:`coface.batch`: the same rows in the same order.
    """
    import ray.data

    start()
    files = find_files(paths, recursive)
    options = {
        "timeout": timeout, "memory": memory, "format": format, "flatten": flatten,
        "all_places": all_places, "timings": timings,
    }  # fmt: skip
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
    lines = (row["line"] for row in rows.iter_rows())
    if out is not None:
        return write_lines(lines, out, timings)
    return [json.loads(line) for line in lines]


def _examine(files: dict[str, Any], options: dict[str, Any]) -> dict[str, list[str]]:
    """The rows of files: one task."""
    paths = [str(path) for path in files["path"]]
    told = worker_options(jobs=1, restart=False, **options)
    return {"line": _coface._batch_lines(paths, told)}
