"""The widget of notebooks: what is clicked in its page goes to the kernel."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys

import pytest

import coface
from coface._widget import FRONT


def test_without_anywidget_its_name_is_told() -> None:
    words = "import sys; sys.modules['anywidget'] = None\nimport coface\ncoface.widget(coface.generate('csaszar'))"
    done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
    assert done.returncode != 0 and "coface.widget needs anywidget" in done.stderr
    assert "pip install anywidget" in done.stderr


def test_the_kernel_knows_what_is_clicked() -> None:
    pytest.importorskip("anywidget")
    torus = coface.generate("csaszar")
    shown = coface.widget([torus, coface.homology(torus, generators=True)], height=200)
    assert "H1 generator 1" in shown.page and shown.height == 200 and shown.cells == []
    told: list[list[tuple[str | None, list[int]]]] = []
    shown.on_select(told.append)
    # What the browser sends.
    shown.set_state({"cells": [[0, 1], [4]]})
    assert told == [[(None, [0, 1]), (None, [4])]]
    assert coface.Complex(torus.faces.tolist()).link([shown.cells[0]]).f_vector == (2,)


def test_cells_of_several_models_have_their_numbers() -> None:
    pytest.importorskip("anywidget")
    torus, sphere = coface.generate("csaszar"), coface.generate("sphere", subdivisions=1)
    shown = coface.widget({"torus": torus, "sphere": sphere})
    shown.cells = [[7, 8], [6]]
    assert shown.selected == [("sphere", [0, 1]), ("torus", [6])]


NODE = """
const listeners = [];
globalThis.window = { addEventListener: (_, f) => listeners.push(f), removeEventListener: (_, f) => listeners.splice(listeners.indexOf(f), 1) };
const frame = { style: {}, attributes: {}, contentWindow: {}, setAttribute(name, value) { this.attributes[name] = value; } };
globalThis.document = { createElement: () => frame };
const state = { page: "<p>page</p>", height: 300, cells: [] };
let saved = 0;
const model = { get: (name) => state[name], set: (name, value) => { state[name] = value; }, save_changes: () => { saved += 1; }, on: () => {} };
const children = [];
const { default: widget } = await import(process.argv[1]);
const stop = widget.render({ model, el: { append: (child) => children.push(child) } });
const cells = [{ dimension: 1, vertices: [3, 5] }];
// From a page that stands elsewhere, and of another kind: not listened to.
listeners.forEach((f) => f({ source: {}, data: { coface: "selection", cells } }));
listeners.forEach((f) => f({ source: frame.contentWindow, data: { other: 1 } }));
const before = saved;
listeners.forEach((f) => f({ source: frame.contentWindow, data: { coface: "selection", cells } }));
stop();
console.log(JSON.stringify({ before, saved, cells: state.cells, page: frame.srcdoc, height: frame.style.height, left: listeners.length, sandbox: frame.attributes.sandbox, count: children.length }));
"""


def test_the_browser_sends_what_the_page_says(tmp_path) -> None:
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    (tmp_path / "front.mjs").write_text(FRONT)
    run = subprocess.run([node, "--input-type=module", "-e", NODE, (tmp_path / "front.mjs").as_uri()], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    said = json.loads(run.stdout)
    assert (said["before"], said["saved"], said["cells"]) == (0, 1, [[3, 5]])
    assert (said["page"], said["height"], said["left"], said["count"]) == ("<p>page</p>", "300px", 0, 1)
    # The page may run its script, and not reach what stands around it.
    assert "allow-same-origin" not in said["sandbox"]
    # The page finds cells by a form.
    assert {"allow-scripts", "allow-forms"} <= set(said["sandbox"].split())


def test_the_page_sends_what_the_browser_reads() -> None:
    assert 'coface:"selection"' in coface.page(coface.generate("csaszar"), report=False).replace("'", '"').replace("`", '"')
