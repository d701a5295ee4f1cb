"""What long calls show while they wait."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any, Protocol


class Progress(Protocol):
    """What ``progress=`` may be beside ``True`` and ``False``: called with the stage, the steps done and all steps (0 if unknown)."""

    def __call__(self, stage: str, done: int, total: int, /) -> object: ...


class Bar:
    """One bar a stage: of tqdm where that is installed, else a line that is written over.

    Parameters
    ----------
    delay
        Seconds to wait before anything is shown, so that short calls show nothing.

    Examples
    --------
    >>> import io
    >>> from contextlib import redirect_stderr
    >>> with redirect_stderr(io.StringIO()) as shown:
    ...     bar = Bar(delay=0.0)
    ...     bar("matching cells", 5, 10)
    ...     bar.close()
    >>> "matching cells" in shown.getvalue()
    True
    """

    def __init__(self, delay: float = 0.2) -> None:
        self._begin = time.monotonic() + delay
        self._stage: str | None = None
        self._bar: Any = None
        self._is_shown = False
        self._make: Callable[..., Any] | None
        try:
            from tqdm.auto import tqdm
        except ImportError:
            self._make = None
        else:
            self._make = tqdm

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Show that so many steps of a stage are done."""
        if time.monotonic() < self._begin:
            return
        if self._make is None:
            share = f"{100 * done // total} %" if total else (str(done) if done else "")
            sys.stderr.write(f"\r\x1b[K{stage} {share}".rstrip(" "))
            sys.stderr.flush()
            self._is_shown = True
            return
        if stage != self._stage:
            if self._bar is not None:
                self._bar.close()
            self._bar = self._make(desc=stage, total=total or None, leave=False, file=sys.stderr)
            self._stage = stage
        self._bar.n = done
        self._bar.refresh()

    def close(self) -> None:
        """Take the bar away."""
        if self._bar is not None:
            self._bar.close()
            self._bar = None
        if self._is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
            self._is_shown = False
