"""What is finished of a batch over a cluster that is not: rows in a file beside the output.

The first line says what the rows depend on; each further line is a checksum and a row with the state of its file. A line whose checksum is wrong is no line:
whatever was being written when the run was cut short.
"""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from types import TracebackType
from typing import IO, Any

from coface._coface import FileError, __version__


class Journal:
    """The rows of a batch that are finished.

    Parameters
    ----------
    out
        The output: the journal stands beside it.
    options
        What rows depend on, as JSON; rows of a run with others, or of another version, are not taken.
    restart
        Whether no row of an earlier run is taken.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> _ = (folder / "a.off").write_text("OFF")
    >>> name = str(folder / "a.off")
    >>> with Journal(folder / "rows.csv", {}, False) as journal:
    ...     journal.add(name, '{"error":null}')
    >>> with Journal(folder / "rows.csv", {}, False) as journal:
    ...     journal.rows([name])[name]
    '{"error":null}'
    """

    def __init__(self, out: Path, options: dict[str, Any], restart: bool) -> None:
        self.path = out.with_name(f".{out.name}.ray-journal")
        self._head = json.dumps({"version": __version__, "options": options}, sort_keys=True, default=str)
        self._restart = restart
        self._file: IO[bytes] | None = None
        self._lines: list[str] = []

    def __enter__(self) -> Journal:
        if not self.path.parent.is_dir():
            message, cure = "the folder to write to does not exist", "make the folder first, or name another"
            raise FileError(f"{self.path.parent}: {message}; {cure}", fault=message, cure=cure, file=str(self.path.parent))
        self._file = open(self.path, "a+b")
        self._lock()
        self._file.seek(0)
        lines = [text for text in map(_unsealed, self._file.read().split(b"\n")) if text is not None]
        if self._restart or not lines or lines[0] != self._head:
            self._file.truncate(0)
            self._write(self._head)
        else:
            self._lines = lines[1:]
            # A line that was cut short is ended, so that the next one begins anew.
            self._file.write(b"\n")
        return self

    def _lock(self) -> None:
        try:
            import fcntl
        except ImportError:
            return
        assert self._file is not None
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self._file.close()
            message, cure = "another run is writing this output", "wait for it, or name another output"
            raise FileError(f"{self.path}: {message}; {cure}", fault=message, cure=cure, file=str(self.path)) from error

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, place: TracebackType | None) -> None:
        if self._file is not None:
            self._file.close()

    def rows(self, files: list[str]) -> dict[str, str]:
        """The finished rows of files that have not changed since."""
        wanted = set(files)
        found: dict[str, str] = {}
        for text in self._lines:
            file, state, row = json.loads(text)
            if file in wanted and state is not None and state == state_of(file):
                found[file] = row
        return found

    def add(self, file: str, row: str) -> None:
        """Keeps the row of a file."""
        error = json.loads(row)["error"]
        # Whoever killed a worker may not do so next time.
        is_lasting = error is None or error["kind"] != "killed"
        self._write(json.dumps([file, state_of(file) if is_lasting else None, row]))

    def _write(self, text: str) -> None:
        assert self._file is not None, "rows are added within the block"
        data = text.encode()
        self._file.write(hashlib.blake2b(data, digest_size=8).hexdigest().encode() + b"\t" + data + b"\n")
        self._file.flush()

    def remove(self) -> None:
        """Removes it: the output is there."""
        self.path.unlink(missing_ok=True)


def state_of(file: str) -> str | None:
    """What changes when a file does: its size and time and what else its system says of it; ``None`` where there is no such file."""
    import fsspec

    name = file if "://" in file or os.path.exists(file) else file.rpartition("#")[0] or file
    system, path = fsspec.core.url_to_fs(name)
    try:
        return str(system.ukey(path))
    except (OSError, NotImplementedError):
        return None


def _unsealed(line: bytes) -> str | None:
    """The text of a line, if its checksum is right."""
    sealed, _, data = line.partition(b"\t")
    if hashlib.blake2b(data, digest_size=8).hexdigest().encode() != sealed:
        return None
    return data.decode()
