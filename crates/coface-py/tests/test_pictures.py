"""Pictures and pages: that they show something, and what they are asked to show."""

from __future__ import annotations

import io
import json
import re

import numpy as np
import pytest

import coface


@pytest.fixture
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot
    pyplot.close("all")


def ink(axes) -> int:
    """Pixels that are not white."""
    figure = axes.figure
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[..., :3]
    return int((pixels < 250).any(axis=2).sum())


def test_surfaces_are_drawn(pyplot, spot) -> None:
    model = coface.read(spot)
    assert ink(coface.plot(model)) > 5000
    assert ink(model.plot(values=np.asarray(model.vertices)[:, 1], edges=False)) > 5000
    assert ink(coface.plot(coface.generate("ring"))) > 5000
    assert ink(coface.plot(coface.Model.from_arrays(np.random.default_rng(0).random((50, 3))))) > 100
    assert ink(coface.plot(coface.generate("ball"))) > 1000


def test_generators_are_drawn_in_their_colors(pyplot) -> None:
    model = coface.generate("torus", columns=12, rows=8)
    found = coface.homology(model, generators=True)
    axes = coface.plot(model, generators=found[1])
    from matplotlib.colors import to_rgba

    shown = [tuple(collection.get_edgecolor()[0]) for collection in axes.collections]
    for number in range(2):
        assert to_rgba(coface._plot.color(number)) in shown
    with_all = coface.plot(model, generators=found)
    assert len(with_all.collections) > len(axes.collections)


def test_matrices_are_drawn(pyplot, torus) -> None:
    complex = coface.as_chain_complex(torus)
    panels = complex.plot()
    assert len(panels) == 2
    assert all(ink(axes) > 100 for axes in panels)
    assert ink(coface.plot(complex.boundary(1))) > 100


def test_diagrams_are_drawn(pyplot) -> None:
    axes = coface.plot(np.array([[0.0, 1.0], [0.5, np.inf]]))
    assert "never dies" in "".join(text.get_text() for text in axes.texts)
    assert ink(axes) > 100


def test_what_cannot_be_drawn_is_refused(pyplot, torus) -> None:
    with pytest.raises(coface.InvalidInputError, match="coordinates"):
        coface.plot(torus)
    with pytest.raises(coface.InvalidInputError, match="values"):
        coface.plot(coface.generate("csaszar"), values=[1.0, 2.0])
    with pytest.raises(coface.InvalidInputError, match="4 coordinates"):
        coface.plot(coface.Model.from_arrays(np.zeros((3, 4)), [[0, 1, 2]]))


def scene(page: str) -> dict:
    found = re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.S)
    assert found is not None
    return json.loads(found.group(1))


def test_a_page_holds_the_model(tmp_path, spot) -> None:
    path = coface.view(spot, tmp_path / "cow.html")
    found = scene(path.read_text(encoding="utf-8"))
    assert found["title"] == "cow"
    assert "sphere" in json.dumps(found)
    without = scene(coface.page(spot, report=False))
    assert len(json.dumps(without)) < len(json.dumps(found))


def test_no_title_ends_the_page() -> None:
    page = coface.page(coface.generate("csaszar"), title="</script><b>")
    assert scene(page)["title"] == "</script><b>"


def test_small_models_show_themselves_in_notebooks(spot) -> None:
    shown = coface.generate("csaszar")._repr_html_()
    assert "<img" in shown and "coface.view" in shown and len(shown) <= 60_000
    large = coface.generate("torus", columns=400, rows=200)._repr_html_()
    assert "<img" not in large and "coface.view" in large and len(large) <= 60_000
    assert len(coface.read(spot)._repr_html_()) <= 60_000


def test_a_notebook_runs(tmp_path) -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    notebook = nbformat.v4.new_notebook()
    notebook.cells = [nbformat.v4.new_code_cell("import coface\ncoface.generate('csaszar')")]
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    data = notebook.cells[0].outputs[0].data
    assert "<img" in data["text/html"]
    assert io.StringIO(data["text/plain"]).read().startswith("Model(")


def test_flat_answers_are_files_of_every_format() -> None:
    row = coface.cubical(np.array([0.0, 5.0, 1.0]))
    square = coface.YinSet.from_model(coface.polygon([[0, 0], [1, 0], [1, 1], [0, 1]]))
    for answer in [row, square]:
        assert coface.render(answer).startswith(b"<svg")
        assert coface.render(answer, "pdf").startswith(b"%PDF-1.4")
        assert coface.render(answer, "png", size=(60, 40)).startswith(b"\x89PNG")
    assert b"M0 0H" in coface.render(square) and b"M0 0H" not in coface.render(square, transparent=True)
    with pytest.raises(coface.InvalidInputError, match="gif"):
        coface.render(row, "gif")


def test_models_have_numbers_widths_and_animations() -> None:
    torus = coface.generate("csaszar")
    assert b">v6</text>" in coface.render(torus, label=["vertices"])
    assert b'stroke-width="2"' in coface.render(torus, edge_width=1.5)
    assert coface.render(torus, "pdf", transparent=True).startswith(b"%PDF-1.4")
    spin = coface.render(torus, "png", spin=3, size=(40, 30))
    assert spin.count(b"fcTL") == 3
    with pytest.raises(coface.InvalidInputError, match="cells"):
        coface.render(torus, label="cells")
    with pytest.raises(coface.InvalidInputError, match="animation"):
        coface.render(torus, spin=3)


def test_stars_closures_and_links_are_drawn() -> None:
    octahedron = coface.Complex([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 1, 4], [5, 1, 2], [5, 2, 3], [5, 3, 4], [5, 1, 4]])
    picture = coface.render(octahedron, star=[0], closure=[[5, 1]], link=[0]).decode()
    for name in ("open star of {0}", "closure of {1, 5}", "link of {0}"):
        assert picture.count(f">{name}<") == 2
    assert coface.render(octahedron, "png", star=[0]).startswith(b"\x89PNG")
    with pytest.raises(coface.Error, match="not in the complex"):
        coface.render(octahedron, star=[[0, 5]])
    square = coface.Model([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2, 3]])
    with pytest.raises(coface.Error, match="4 sides"):
        coface.render(square, star=[0])


def test_figures_are_drawn_in_every_format() -> None:
    torus = coface.generate("csaszar")
    made = {
        "schema": lambda **options: coface.schema_picture(torus, **options),
        "word": lambda **options: coface.schema_picture("a b a^-1 b^-1", **options),
        "sequence": lambda **options: coface.sequence_picture(coface.generate("moebius"), **options),
        "matrix": lambda **options: coface.matrix_picture(torus, 2, "matching", **options),
    }
    for draw in made.values():
        assert draw().startswith(b"<svg")
        assert draw(format="png", size=(200, 200)).startswith(b"\x89PNG")
        assert draw(format="pdf").startswith(b"%PDF")
    assert made["schema"]().count(b"<title>side ") == 4
    with pytest.raises(ValueError, match="place 5"):
        coface.schema_picture("a b 3")
    with pytest.raises(ValueError, match="matching"):
        coface.matrix_picture(torus, 2, "colors")
    with pytest.raises(ValueError, match="from 1 to 2"):
        coface.matrix_picture(torus, 3)


def test_interfaces_and_animations_are_drawn() -> None:
    rooms = coface.interface(np.array([[1, 1, 2], [3, 3, 2]]))
    picture = coface.render(rooms).decode()
    assert picture.count("<title>phase ") == 3 and picture.count("<circle") == len(rooms.junctions)
    spin = coface.render(coface.generate("csaszar"), "gif", size=(60, 40), spin=3)
    assert spin.startswith(b"GIF89a")
    for transparent in (False, True):
        spin = coface.render(coface.generate("csaszar"), "webp", size=(60, 40), spin=3, transparent=transparent)
        assert spin[:4] == b"RIFF" and spin[8:12] == b"WEBP" and spin.count(b"ANMF") == 3
    with pytest.raises(ValueError, match="a PNG or a WebP"):
        coface.render(coface.generate("csaszar"), "svg", spin=3)
