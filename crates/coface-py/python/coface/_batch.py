"""The report over many files."""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, TypedDict, overload

from coface import _coface
from coface._coface import InvalidInputError
from coface._faults import in_words
from coface._volumes import voxel_rule

_Path = str | os.PathLike[str]
_Progress = bool | Callable[[str, int, int], object] | None

#: The memory that a file may take unless it is said.
MEMORY = 2 << 30


class BatchSummary(TypedDict):
    """What came of a batch that was written to a file."""

    #: The number of files, which is that of rows.
    files: int
    #: The number of rows that are errors, by kind.
    errors: dict[str, int]
    #: The number of rows taken from an earlier run that was cut short.
    resumed: int


class BatchRow(dict[str, Any]):
    """A row of a batch with one value a column, as tables have it; the keys of the whole report are found too.

    ``pandas.DataFrame(rows)`` makes a table of rows. ``row["error"]``, ``row["f_vector"]`` and the other keys that are lists or dictionaries are
    not columns, and are looked up in :attr:`report`.

    Examples
    --------
    >>> import coface
    >>> row = coface.BatchRow({"path": "a.off", "betti_1": 2}, {"path": "a.off", "f_vector": [7, 21, 14]})
    >>> row["betti_1"], row["f_vector"], list(row)
    (2, [7, 21, 14], ['path', 'betti_1'])
    """

    def __init__(self, columns: Mapping[str, Any], report: dict[str, Any]) -> None:
        super().__init__(columns)
        #: Everything that ``coface info --json`` says, with lists and dictionaries in it.
        self.report = report

    def __missing__(self, key: str) -> Any:
        return self.report[key]

    def __reduce__(self) -> tuple[type[BatchRow], tuple[dict[str, Any], dict[str, Any]]]:
        return BatchRow, (dict(self), self.report)


def row_of(line: str, flat: bool, timings: bool) -> dict[str, Any]:
    """A row from its line of JSON."""
    report: dict[str, Any] = json.loads(line)
    return BatchRow(dict(json.loads(_coface._flat_line(line, timings))), report) if flat else report


@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: None = None,
    *,
    flat: Literal[True] = ...,
    recursive: bool = ...,
    jobs: int | None = ...,
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
    progress: _Progress = ...,
) -> list[BatchRow]: ...
@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: None = None,
    *,
    flat: bool,
    recursive: bool = ...,
    jobs: int | None = ...,
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
    progress: _Progress = ...,
) -> list[dict[str, Any]]: ...
@overload
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path,
    *,
    flat: bool = ...,
    recursive: bool = ...,
    jobs: int | None = ...,
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
    progress: _Progress = ...,
) -> BatchSummary: ...
@in_words
def batch(
    paths: _Path | Iterable[_Path],
    out: _Path | None = None,
    *,
    flat: bool = True,
    recursive: bool = False,
    jobs: int | None = None,
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
    progress: _Progress = False,
) -> list[BatchRow] | list[dict[str, Any]] | BatchSummary:
    """Report on many files: one row a file, errors as rows; of a file of several models a row for each.

    Files are read by worker processes, so one that crashes, never ends or needs too much memory costs its row alone. A row is a
    dictionary with one value a column: ``path``, ``bytes`` (``None`` of a URL), ``seconds``, ``error_kind`` and ``error_message``, ``betti_1`` and so
    on, so that ``pandas.DataFrame(rows)`` is a table. ``row["error"]`` (``None``, or ``kind``, ``message`` and ``cure``) and everything else that
    ``coface info --json`` says is found in it too.

    Parameters
    ----------
    paths
        Files, folders (their files of known formats), patterns with ``*``, ``?``, ``[``, ``@list.txt`` with one path a line; URLs of
        files and patterns that fsspec understands. One of them or many.
    out
        A file to write the rows to instead: ``.jsonl``, ``.csv`` or ``.parquet``. It appears whole at the end; a call that was cut
        short goes on where it was. Tables have one value a column, as those of ``coface batch``.
    flat
        Whether rows have one value a column; they are the reports with their lists and dictionaries otherwise.
    recursive
        Whether files of folders in folders are taken too.
    jobs
        How many files are read at once; one a core by default.
    timeout, memory
        The seconds and bytes that one file may take; ``None`` is any.
    format, flatten, strict, partial, allow_outside
        As those of :func:`read`.
    threshold, below, between, value, periodic
        Which voxels of files of volumes are set, and which axes close up, as in :func:`volume`. Other files are not concerned.
    voxels
        The same as a dictionary: ``{"threshold": 0.5, "periodic": [0]}``.
    all_places
        Whether every place of every problem is listed, not the first hundred alone.
    timings
        Whether rows have ``seconds``; without them, equal files give equal bytes.
    restart
        Whether rows that an earlier call finished are done again.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    list of BatchRow, list of dict, or BatchSummary
        The rows, in the order of the paths; dictionaries with ``flat=False``; with `out` the numbers of files, errors and rows from an earlier call.

    Examples
    --------
    >>> import coface, pathlib, tempfile
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> _ = (folder / "a.off").write_text("OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n")
    >>> _ = (folder / "b.off").write_text("OFF\\n1 0 0\\n0 0 oops\\n")
    >>> [(row.get("name"), row["error"] and row["error"]["kind"]) for row in coface.batch(folder)]
    [('disk', None), (None, 'parse')]
    """
    options = worker_options(
        jobs=jobs, timeout=timeout, memory=memory, format=format, flatten=flatten, strict=strict,
        partial=partial, allow_outside=allow_outside,
        voxels=words_of_voxels(voxels, threshold=threshold, below=below, between=between, value=value, periodic=periodic),
        all_places=all_places, timings=timings, restart=restart,
    )  # fmt: skip
    files = find_files(paths, recursive)
    if out is None:
        return [row_of(line, flat, timings) for line in _coface._batch_lines(files, options, progress)]
    target = Path(out)
    # Not the rows of an earlier run, in a folder of the files.
    files = [file for file in files if Path(file.split("#")[0]).resolve() != target.resolve()]
    return _summary(_coface._batch_write(files, target, options, progress))


@overload
def signatures(
    paths: _Path | Iterable[_Path],
    out: None = None,
    *,
    groups: bool = ...,
    pseudomanifold: bool = ...,
    jobs: int | None = ...,
    progress: _Progress = ...,
) -> Iterator[dict[str, Any]]: ...
@overload
def signatures(
    paths: _Path | Iterable[_Path],
    out: _Path,
    *,
    groups: bool = ...,
    pseudomanifold: bool = ...,
    jobs: int | None = ...,
    progress: _Progress = ...,
) -> BatchSummary: ...
@in_words
def signatures(
    paths: _Path | Iterable[_Path],
    out: _Path | None = None,
    *,
    groups: bool = False,
    pseudomanifold: bool = False,
    jobs: int | None = None,
    progress: _Progress = False,
) -> Iterator[dict[str, Any]] | BatchSummary:
    """Homology and verdicts of the 3-manifolds in lists of isomorphism signatures: one row a line, as the lines come.

    A line has a signature and perhaps a name, in either order, with tabs or blanks between them; empty lines and those that begin with ``#`` are
    passed over. What is wrong with a line is in its row. Memory does not grow with the files.

    Parameters
    ----------
    paths
        Text files, compressed or not. One of them or many.
    out
        A file to write the rows to instead: ``.jsonl``, ``.csv`` or ``.parquet``. It appears whole at the end.
    groups
        Whether rows have the fundamental groups with their names.
    pseudomanifold
        Whether ideal vertices are points, and are not cut off.
    jobs
        How many lines are looked at at once; one a core by default.
    progress
        ``True`` shows a bar; a function is called with (stage, done, total). With `out` only.

    Returns
    -------
    iterator of dict, or BatchSummary
        Rows with the keys ``path``, ``line``, ``name``, ``signature``, ``error`` (``None``, or ``kind``, ``message`` and ``cure``) and, without an error,
        ``f_vector``, ``components``, ``closed``, ``ideal_vertices``, ``euler_characteristic``, ``manifold``, ``witness``, ``orientable``, ``homology`` and,
        if asked for, ``groups``; with `out` the numbers of rows and errors.

    Examples
    --------
    >>> import coface, pathlib, tempfile
    >>> census = pathlib.Path(tempfile.mkdtemp()) / "census.sig"
    >>> _ = census.write_text("cMcabbjak L(3,1)\\nL(8,3)\\tcMcabbjqs\\nxyz\\n")
    >>> [(row["name"], row["error"] is None and row["homology"][1]["torsion"]) for row in coface.signatures(census)]
    [('L(3,1)', [3]), ('L(8,3)', [8]), (None, False)]
    """
    files = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    if out is not None:
        return _summary(_coface._signatures_write(files, out, groups, pseudomanifold, jobs, progress))
    return map(json.loads, _coface._SignatureRows(files, groups, pseudomanifold, jobs))


def words_of_voxels(voxels: Mapping[str, Any] | None, **given: Any) -> dict[str, Any]:
    """Which voxels are set, in the words of :func:`volume`, from a dictionary or from parameters.

    Examples
    --------
    >>> words_of_voxels(None, threshold=0.5, below=None, periodic=())
    {'threshold': 0.5}
    """
    named = {name: value for name, value in given.items() if value is not None and not (name == "periodic" and len(value) == 0)}
    if voxels is not None and named:
        message, cure = f"voxels and {next(iter(named))} are given together", f"write it in voxels: {{{next(iter(named))!r}: ...}}"
        raise InvalidInputError(f"{message}; {cure}", fault=message, cure=cure)
    return named if voxels is None else dict(voxels)


def worker_options(*, voxels: Mapping[str, Any] | None, **options: Any) -> dict[str, Any]:
    """What the compiled part needs to know about a batch: how workers are started, beside these options."""
    if not sys.executable:
        raise InvalidInputError("this Python has no executable, so no worker can be started")
    worker = Path(__file__).with_name("_worker.py")
    environment = {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path), "RAYON_NUM_THREADS": "1"}
    return {
        "command": [sys.executable, str(worker), str(_coface.__file__)],
        "environment": environment,
        "voxels": voxel_rule(**(voxels or {})),
        **options,
    }


def find_files(paths: _Path | Iterable[_Path], recursive: bool) -> list[str]:
    """The files that words name, in their order, none twice; URLs stay as they are, patterns in them are looked up."""
    words = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    files: dict[str, None] = {}
    for word in [os.fspath(word) for word in words]:
        if "://" not in word:
            files.update(dict.fromkeys(map(os.fspath, _coface._find_files([word], recursive))))
        elif any(sign in word for sign in "*?["):
            import fsspec

            system, pattern = fsspec.core.url_to_fs(word)
            found = sorted(system.glob(pattern))
            files.update(dict.fromkeys(system.unstrip_protocol(path) for path in found))
        else:
            files[word] = None
    if not files:
        raise InvalidInputError("no files are named here", cure="name files, folders or patterns")
    return list(files)


def write_lines(lines: Iterable[str], out: _Path, timings: bool) -> BatchSummary:
    """Write rows that come as lines of JSON, in their order, to a file that appears whole at the end."""
    target = Path(out)
    suffix = target.suffix.lower()
    if suffix not in {".jsonl", ".ndjson", ".csv", ".parquet"}:
        message = f"{target}: the extension {suffix!r} is no table known here"
        raise InvalidInputError(message, cure="end it in .jsonl, .csv or .parquet")
    errors: dict[str, int] = {}
    count = 0
    handle, name = tempfile.mkstemp(prefix=f".{target.name[:100]}.", suffix=".jsonl", dir=target.parent)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            for line in lines:
                file.write(line + "\n")
                count += 1
                error = json.loads(line)["error"]
                if error is not None:
                    errors[error["kind"]] = errors.get(error["kind"], 0) + 1
        if suffix in {".csv", ".parquet"}:
            _coface._table_of_lines(name, target, timings)
        else:
            _coface._copy_file(name, target)
    finally:
        Path(name).unlink(missing_ok=True)
    return {"files": count, "errors": dict(sorted(errors.items())), "resumed": 0}


def _summary(counts: tuple[int, dict[str, int], int]) -> BatchSummary:
    files, errors, resumed = counts
    return {"files": files, "errors": errors, "resumed": resumed}
