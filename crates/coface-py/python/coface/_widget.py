"""The page of a model in a notebook, which says to the kernel which cells are clicked."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from coface._arrays import raise_invalid
from coface._faults import in_words
from coface._shown import shown
from coface._view import page
from coface.interop import needed

#: The browser's part: the page stands in a frame of its own, and what is selected there goes to the kernel.
FRONT = """
function render({ model: kernel, el }) {
  const frame = document.createElement("iframe");
  frame.setAttribute("sandbox", "allow-scripts allow-forms allow-downloads");
  frame.setAttribute("title", "coface");
  frame.style.width = "100%";
  frame.style.border = "0";
  const fill = () => { frame.srcdoc = kernel.get("page"); };
  const size = () => { frame.style.height = `${kernel.get("height")}px`; };
  const listen = (event) => {
    if (event.source !== frame.contentWindow || !event.data || event.data.coface !== "selection") return;
    kernel.set("cells", event.data.cells.map((cell) => cell.vertices));
    kernel.save_changes();
  };
  fill();
  size();
  window.addEventListener("message", listen);
  kernel.on("change:page", fill);
  kernel.on("change:height", size);
  el.append(frame);
  return () => window.removeEventListener("message", listen);
}
export default { render };
"""


@lru_cache(maxsize=None)
def _class() -> Any:
    """The class of widgets, made where anywidget is there."""
    anywidget, traitlets = needed("anywidget", "coface.widget"), needed("traitlets", "coface.widget")

    class Widget(anywidget.AnyWidget):  # type: ignore[misc, name-defined]
        """A model to turn and click in a notebook.

        Attributes
        ----------
        cells : list of list of int
            The cells that are selected, each by its vertices. It changes with each click in the page.
        height : int
            The height in pixels.
        """

        _esm = FRONT
        page = traitlets.Unicode().tag(sync=True)
        height = traitlets.Int(480).tag(sync=True)
        cells = traitlets.List(traitlets.List(traitlets.Int())).tag(sync=True)
        #: Of several models the name of each, its first vertex and the one behind its last.
        members: list[tuple[str, int, int]] = []

        @property
        def selected(self) -> list[tuple[str | None, list[int]]]:
            """The selected cells, each with the name of its model, and vertices by their numbers in that model; ``None`` for one model alone."""
            return [self._owned(list(cell)) for cell in self.cells]

        def _owned(self, cell: list[int]) -> tuple[str | None, list[int]]:
            for name, start, end in self.members:
                if cell and start <= cell[0] < end:
                    return name, [vertex - start for vertex in cell]
            return None, cell

        def on_select(self, function: Callable[[list[tuple[str | None, list[int]]]], object]) -> None:
            """Calls a function with :attr:`selected` each time another selection is made."""
            self.observe(lambda change: function(self.selected), "cells")

    return Widget


@in_words
def widget(
    x: Any, results: Any = None, *, title: str | None = None, report: bool = False, colors: Any = None, height: int = 480, progress: Any = False
) -> Any:
    """The page of a model and answers as a widget of a notebook, which says to the kernel which cells are clicked.

    Parameters
    ----------
    x, results, title, report, colors, progress
        As in :func:`page`.
    height
        The height in pixels.

    Returns
    -------
    anywidget.AnyWidget
        ``.cells`` lists the selected cells by their vertices; ``.selected`` says of several models which one each lies in; ``.on_select(function)`` calls a
        function at each click.

    Raises
    ------
    ImportError
        If anywidget is not installed, with the command that installs it.

    Examples
    --------
    >>> import coface, pytest
    >>> _ = pytest.importorskip("anywidget")
    >>> shown = coface.widget(coface.generate("csaszar"), height=300)
    >>> shown.cells, shown.height
    ([], 300)
    """
    made = _class()
    if isinstance(height, bool) or not isinstance(height, int) or not 1 <= height <= 100_000:
        raise_invalid(f"height is {height!r}", "give a number of pixels: height=480")
    text = page(x, results, title=title, report=report, colors=colors, progress=progress)
    found = made(page=text, height=height)
    found.members = shown(x, results).members
    return found
