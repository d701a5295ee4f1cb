"""Every cure that a message names is run: the call that fails, and what the message says to do.

The first table has the calls. A test walks the sources for messages that name options or commands of the program, and says them in the words of
Python; another looks up every parameter, method and function that a cure names.
"""

from __future__ import annotations

import inspect
import re
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import coface
from coface import shards

CRATES = Path(__file__).resolve().parents[2]


class Case(NamedTuple):
    """A call that fails, a piece of what it says, and the calls that the cure names."""

    fails: str
    says: str
    cures: tuple[str, ...]


CASES = [
    # Volumes where surfaces are meant.
    *(
        Case(f"coface.{name}(box)", "give boundary=True", (f"coface.{name}(box, boundary=True)",))
        for name in ("as_surface", "cocycles", "harmonic", "classify", "cut")
    ),
    Case("coface.cover(box, radius=1)", "give boundary=True", ("coface.cover(box, boundary=True, radius=1)",)),
    Case("coface.Surface(box)", "boundary=True", ("coface.Surface(box, boundary=True)",)),
    Case("box.surface()", "boundary=True", ("box.surface(boundary=True)",)),
    # Surfaces that are none.
    Case(
        "coface.as_surface(book)",
        'model.repaired(split_edges="pairs", split_vertices=True)',
        ('coface.as_surface(book.repaired(split_edges="pairs", split_vertices=True))',),
    ),
    Case("coface.as_surface(loose)", "model.repaired_surface()", ("coface.as_surface(loose.repaired_surface())",)),
    # Arrays that could be two things.
    Case(
        "coface.homology(image)",
        "coface.volume(x, threshold=...)",
        ("coface.homology(coface.volume(image, threshold=0.5))", "coface.homology(coface.Model(points, [[0, 1, 2]]))"),
    ),
    Case("coface.as_model(small)", "coface.Model.from_facets(x)", ("coface.Model.from_facets(small)",)),
    Case("coface.volume(image, threshold='otsu')", "threshold=0.5", ("coface.volume(image, threshold=0.5)",)),
    Case("coface.volume(image, between=0.2)", "between=(0.2, 0.8)", ("coface.volume(image, between=(0.2, 0.8))",)),
    Case("coface.volume(image, periodic=True)", "periodic=[0, 1]", ("coface.volume(image, periodic=[0, 1])",)),
    Case("coface.volume(image, threshold=1, below=2)", "give one rule", ("coface.volume(image, threshold=1)",)),
    # Questions with arguments that are no such thing.
    Case("coface.homology(ring, relative='rim')", 'relative="boundary"', ("coface.homology(path, relative='boundary')",)),
    Case("coface.homology(square, relative='rim')", "'left'", ("coface.homology(square, relative='left')",)),
    Case("coface.boolean(cube, 'union', cube)", 'coface.boolean("union", a, b)', ("coface.boolean('union', cube, cube)",)),
    Case("coface.boolean('cube', cube, 'union')", "the operation first", ("coface.boolean('union', cube, cube)",)),
    Case("coface.boolean(cube, cube)", 'coface.boolean("union", a, b)', ("coface.boolean('union', cube, cube)",)),
    Case("coface.homology(ring, 'f4')", "say z, q, f2", ("coface.homology(ring, 'z4')", "coface.homology(ring, 'f2')")),
    Case("coface.boolean('union', cube, inputs='rooms')", "components", ("coface.boolean('union', cube, inputs='components')",)),
    Case("coface.boolean('union', cube, rule='odd')", "evenodd", ("coface.boolean('union', cube, rule='evenodd')",)),
    Case("coface.boolean('union', turned)", 'rule="evenodd"', ("coface.boolean('union', turned, rule='evenodd')",)),
    Case(
        "coface.boolean('union', turned)",
        "model.repaired(orient=True)",
        ("coface.boolean('union', turned.repaired(orient=True))",),
    ),
    Case("coface.boolean('union', lid)", 'open="close"', ("coface.boolean('union', lid, open='close')",)),
    Case("coface.arrange(bent, split=False)", "split=True", ("coface.arrange(bent, split=True)",)),
    Case("coface.arrange(cube, prune=True)", "leave it out in space", ("coface.arrange(cube)",)),
    Case("coface.arrange(cube, dimension=2)", "in space", ("coface.arrange(cube)",)),
    Case("coface.persistence(ring)", "vertex_values or cell_values", ("coface.persistence(ring, [0, 1, 2])",)),
    Case("coface.persistence(ring, points)", "(3,)", ("coface.persistence(ring, [0, 1, 2])",)),
    Case("coface.is_exact(ring, [0.5, 1.0, 0.5])", "tolerance=", ("coface.is_exact(ring, [0.5, 1.0, 0.5], tolerance=1e-9)",)),
    Case("coface.as_chain_complex(ring).chain([1, 0, 0])", "pairs (coefficient", ("coface.as_chain_complex(ring).chain([(1, [0, 1])])",)),
    Case("coface.as_chain_complex(ring).chain(np.array([1, -1, 1]))", "degree=k", ("coface.as_chain_complex(ring).chain(np.array([1, -1, 1]), degree=1)",)),
    Case("square.subdivided()", "model.subdivided()", ("coface.generate('torus').report()",)),
    Case("flat_square.write(folder / 'x.what')", "format", ("flat_square.write(folder / 'x.what', format='obj')",)),
    Case("coface.arrange(flat_square).write(folder / 'x.what')", "format=", ("coface.arrange(flat_square).write(folder / 'x.what', format='svg')",)),
    # Files.
    Case("coface.read(cut)", "partial=True", ("coface.read(cut, partial=True)",)),
    Case("coface.Model.from_bytes(REPEATED, strict=True)", "leave out strict", ("coface.Model.from_bytes(REPEATED)",)),
    Case("coface.read(outside)", "allow_outside=True", ("coface.read(outside, allow_outside=True)",)),
    # Sets of the plane.
    Case("disk.to_bytes('wkt')", "flatten=LENGTH", ("disk.to_bytes('wkt', flatten=0.01)",)),
    Case("coface.YinSet.from_rings([bow_tie])", 'rule="nonzero", "evenodd" or "positive"', ("coface.YinSet.from_rings([bow_tie], rule='evenodd')",)),
    # Volumes as meshes.
    Case("coface.volume(solid, periodic=[0]).to_model(surface=True)", "leave out periodic", ("coface.volume(solid).to_model(surface=True)",)),
    Case("coface.Model(points).to_model()", "coface.volume(..)", ("coface.volume(solid).to_model()",)),
    Case("coface.volume(solid).to_model(spacing=(1, 2))", "a number for each axis", ("coface.volume(solid).to_model(spacing=(1, 2, 3))",)),
    # Numbers that are out of range.
    Case("coface.as_chain_complex(ring).boundary(-1)", "an integer from 0", ("coface.as_chain_complex(ring).boundary(1)",)),
    Case("coface.as_chain_complex(ring).boundary(1.5)", "an integer from 0", ("coface.as_chain_complex(ring).boundary(1)",)),
    Case("coface.homology(ring)[7]", "degrees below 2", ("coface.homology(ring)[1]",)),
]

REPEATED = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 2\n"


@pytest.fixture(scope="module")
def names(tmp_path_factory) -> dict[str, Any]:
    """What the calls of the table name."""
    folder = tmp_path_factory.mktemp("cures")
    (folder / "cut.off").write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    (folder / "inner").mkdir()
    (folder / "points.bin").write_bytes(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes())
    buffers = '"buffers": [{"uri": "../points.bin", "byteLength": 36}]'
    views = '"bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}]'
    mesh = '"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0'
    (folder / "inner" / "outside.gltf").write_text('{"asset": {"version": "2.0"}, %s, %s, %s}' % (buffers, views, mesh))
    cube = coface.generate("box", boundary=True)
    corners = np.asarray(cube.vertices)
    faces = np.asarray(cube.faces).copy()
    turned = faces.copy()
    turned[0] = turned[0][::-1]
    square = coface.Model([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]])
    return {
        "coface": coface,
        "np": np,
        "folder": folder,
        "REPEATED": REPEATED,
        "box": coface.generate("box"),
        "cube": cube,
        "turned": coface.Model(corners, turned),
        "lid": coface.Model(corners, faces[1:]),
        "bent": coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]], [[0, 1, 2, 3]]),
        "book": coface.Model(np.random.default_rng(3).random((5, 3)), [[0, 1, 2], [0, 1, 3], [0, 1, 4]]),
        "loose": coface.Model.from_facets([[0, 1, 2], [2, 3]]),
        "ring": [[0, 1], [1, 2], [0, 2]],
        "path": [[0, 1], [1, 2]],
        "square": square.with_group("left", [0, 3], "vertices"),
        "flat_square": coface.polygon([[0, 0], [1, 0], [1, 1], [0, 1]]),
        "squares": coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]]),
        "points": np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
        "image": np.linspace(0, 1, 36).reshape(6, 6),
        "small": np.array([[0, 1, 2]], np.uint8),
        "solid": np.ones((2, 2, 2), bool),
        "cut": folder / "cut.off",
        "outside": folder / "inner" / "outside.gltf",
        "disk": coface.YinSet([coface.Curve.circle([0, 0], 1)]),
        "bow_tie": [[0, 0], [2, 2], [2, 0], [0, 2]],
    }


@pytest.mark.parametrize("case", CASES, ids=[case.fails for case in CASES])
def test_cures_cure(case: Case, names) -> None:
    with pytest.raises(coface.Error) as caught:
        eval(case.fails, dict(names))
    assert case.says in str(caught.value), str(caught.value)
    assert not re.search(r"--[a-z]|\bcoface [a-z]+ ", str(caught.value))
    for cure in case.cures:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            eval(cure, dict(names))


def literals(path: Path) -> list[str]:
    """The texts in a source, without tests at its end and without comments."""
    source = path.read_text(encoding="utf-8").partition("#[cfg(test)]")[0]
    source = re.sub(r"(?m)^\s*//.*$|^\s*#.*$", "", source)
    return [re.sub(r"\\\n\s*", "", text) for text in re.findall(r'"((?:[^"\\]|\\.)*)"', source, re.S)]


#: What no message of Python says: the program's own words, pages and schemas.
OF_THE_PROGRAM = (
    "--json.",  # the schema of answers
    "cover --orientation",
    "cocycles --test",
    "--function FILE",  # the library reads values from a file for the program alone
    "(--json lists all)",  # lists of simplices as text are printed by the program
    "--paper",  # the style of a page
)


def test_no_message_names_an_option_of_the_program() -> None:
    """Each message of the library that names an option or a command is said in the words of Python."""
    to_python = coface._coface._in_python
    found = 0
    for crate in ("algebra", "geometry", "complexes", "topology", "arrange", "yin", "io", "answers", "pictures", "scale"):
        for path in sorted((CRATES / f"coface-{crate}" / "src").rglob("*.rs")):
            if path.name in ("tests.rs", "mesh_tests.rs", "samples.rs") or "tests" in path.parts:
                continue
            for text in literals(path):
                if not re.search(r"(?<![-\w])--[a-z]|\bcoface (convert|homology|shard|reduce|yin|info|batch|arrange|boolean)\b", text):
                    continue
                if any(word in text for word in OF_THE_PROGRAM):
                    continue
                said = to_python(text)
                found += 1
                assert not re.search(r"(?<![-\w])--[a-z]|\bcoface (convert|homology|shard|reduce|yin|info|batch|arrange|boolean)\b", said), (path, said)
    assert found > 25


@pytest.mark.parametrize(
    ("program", "python"),
    [
        ("say what is inside of it: --rule evenodd or --rule nonzero", 'say what is inside of it: rule="evenodd" or rule="nonzero"'),
        ("a fill rule: --rule nonzero, evenodd or positive", 'a fill rule: rule="nonzero", "evenodd" or "positive"'),
        ("unless --rule says otherwise", "unless rule says otherwise"),
        ("--snap makes them so", "snap=True makes them so"),
        ("use --snap, or write GeoJSON", "use snap=True, or write GeoJSON"),
        ("leave out --strict, or correct the file", "leave out strict, or correct the file"),
        ("read what is there with --partial", "read what is there with partial=True"),
        ("allow it by --allow-outside if you trust the file", "allow it by allow_outside=True if you trust the file"),
        ("--tolerance 1e-9 puts together", "tolerance=1e-9 puts together"),
        ("; --tolerance says how near is one", "; tolerance says how near is one"),
        ("(--open close)", '(open="close")'),
        ("leave --dimension 2 out", "leave dimension=2 out"),
        ("--flatten LENGTH; or write .json", "flatten=LENGTH; or write .json"),
        ("say what it is with --format, one of obj", "say what it is with format, one of obj"),
        ("say what it is with --format off", 'say what it is with format="off"'),
        ("leave --lod out: the geometries say no level", "leave lod out: the geometries say no level"),
        ("chords, which are exact: --order 2 --flatten LENGTH", "chords, which are exact: order=2, flatten=LENGTH"),
        ("take it in parts: coface homology --parts N", "take it in parts: coface.shards.shard(model, folder, parts), then coface.shards.homology(folder)"),
    ],
)
def test_options_are_parameters(program: str, python: str) -> None:
    assert coface._coface._in_python(program) == python


def parameters() -> set[str]:
    """The parameters of everything public."""
    found: set[str] = set()
    things = [getattr(coface, name) for name in coface.__all__]
    things += [getattr(shards, name) for name in shards.__all__]
    for thing in things:
        members = [thing, *(vars(thing).values() if inspect.isclass(thing) else ())]
        for member in members:
            member = getattr(member, "__func__", member)
            try:
                found |= set(inspect.signature(member).parameters)
            except (TypeError, ValueError):
                continue
    return found


def test_what_cures_name_is_there() -> None:
    """Functions, methods and parameters in the cures of the sources of this package."""
    known, seen = parameters(), 0
    sources = [*(CRATES / "coface-py" / "src").rglob("*.rs"), *(CRATES / "coface-py" / "python").rglob("*.py")]
    for path in sources:
        for text in literals(path) + re.findall(r"'((?:[^'\\\n]|\\.)*)'", path.read_text(encoding="utf-8")):
            text = text.replace('\\"', '"')
            for name in re.findall(r"\bcoface\.([a-z]\w*)\(", text):
                assert hasattr(coface, name) or name == "shards", (path.name, text)
                seen += 1
            for name in re.findall(r"\bmodel\.([a-z]\w*)\(", text):
                assert hasattr(coface.Model, name), (path.name, text)
                seen += 1
            if path.suffix == ".rs" and re.match(r"(give|leave|say|use|model\.|coface\.)", text):
                for name in re.findall(r"\b([a-z_]+)=", text):
                    assert name in known, (path.name, text)
                    seen += 1
    assert seen > 15
