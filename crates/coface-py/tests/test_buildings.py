"""Buildings: objects as inputs, graphs of cells, and stand-ins for the shapes of IfcOpenShell and topologicpy."""

from __future__ import annotations

import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import coface

SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def corners(low, high):
    return np.array([[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)], float)


def box(low, high):
    return coface.Model(corners(low, high), SIDES)


def obj(boxes):
    """Boxes as one OBJ, each an object."""
    lines = []
    for number, (name, (low, high)) in enumerate(boxes.items()):
        lines.append(f"o {name}")
        lines += ["v {} {} {}".format(*point) for point in corners(low, high)]
        lines += ["f " + " ".join(str(8 * number + corner + 1) for corner in side) for side in SIDES]
    return "\n".join(lines) + "\n"


PAIR = {"a": ((0, 0, 0), (2, 2, 2)), "b": ((1, 1, 1), (3, 3, 3))}


def test_objects_of_a_file_are_inputs(tmp_path):
    path = tmp_path / "pair.obj"
    path.write_text(obj(PAIR))
    model = coface.read(path)
    arranged = coface.arrange(model, inputs="objects")
    assert arranged.regions == ["a", "b"]
    assert sorted(zip(arranged.measures, arranged.inside)) == [(1.0, [0, 1]), (7.0, [0]), (7.0, [1])]
    assert len(arranged.inputs_of_faces) == arranged.f_vector[2]
    # A formula that names more inputs than there are models takes the objects.
    assert coface.boolean("a & b", model).measure == 1.0
    assert coface.boolean("difference", model, inputs="objects").measure == 7.0
    assert coface.arrange(model).inputs_of_faces is None
    with pytest.raises(coface.InvalidInputError, match="inputs=\"objects\""):
        coface.arrange(model, inputs="groups")
    with pytest.raises(coface.InvalidInputError, match="components"):
        coface.arrange(model, inputs="rooms")


def test_a_graph_of_cells_is_typed_and_goes_to_other_forms():
    graph = coface.arrange({"left <1>": box((0, 0, 0), (4, 3, 2.5)), "right": box((4, 0, 0), (8, 3, 2.5))}).graph()
    assert isinstance(graph, coface.CellGraph)
    assert [node.volume for node in graph.nodes] == [30.0, 30.0]
    edge = graph.edges[0]
    assert (edge.cells, edge.area, edge.faces, graph.names(edge.inputs)) == ((0, 1), 7.5, 1, ("left <1>", "right"))
    node = next(node for node in graph.nodes if node.centroid[0] < 4)
    assert node.centroid == (2.0, 1.5, 1.25)
    assert node.bounds == ((0.0, 0.0, 0.0), (4.0, 3.0, 2.5))
    assert (node.exterior, node.exterior_area, node.exterior_faces) == (True, 2 * 12 + 2 * 10 + 7.5, 5)
    assert coface.CellGraph.from_dict(json.loads(json.dumps(graph.to_dict()))) == graph
    root = ElementTree.fromstring(graph.to_graphml())
    texts = [data.text for data in root.iter("{http://graphml.graphdrawing.org/xmlns}data")]
    assert "left <1>" in texts and "left <1>; right" in texts
    networkx = pytest.importorskip("networkx")
    found = graph.to_networkx()
    assert dict(found.edges[0, 1])["area"] == 7.5
    assert networkx.parse_graphml(graph.to_graphml()).number_of_edges() == 1


def test_networkx_is_asked_for_by_name(monkeypatch):
    monkeypatch.setitem(sys.modules, "networkx", None)
    graph = coface.CellGraph((), (), ())
    with pytest.raises(ImportError, match="pip install networkx"):
        graph.to_networkx()


def shape(name, guid, low, high, matrix=None):
    """What ``ifcopenshell.geom.create_shape`` gives, with the attributes of version 0.8."""
    faces = [corner for a, b, c, d in SIDES for corner in (a, b, c, a, c, d)]
    geometry = SimpleNamespace(verts=tuple(corners(low, high).reshape(-1)), faces=tuple(faces))
    matrix = tuple(np.eye(4).reshape(-1, order="F")) if matrix is None else matrix
    return SimpleNamespace(geometry=geometry, name=name, guid=guid, transformation=SimpleNamespace(matrix=matrix))


def test_shapes_of_ifcopenshell_are_named_inputs():
    shift = np.eye(4)
    shift[:3, 3] = [4, 0, 0]
    shapes = [
        shape("wall", "g1", (0, 0, 0), (1, 1, 1)),
        shape("wall", "g2", (0, 0, 0), (1, 1, 1), tuple(shift.reshape(-1, order="F"))),
        shape("", "g3", (2, 0, 0), (3, 1, 1)),
    ]
    models = coface.from_ifcopenshell(shapes)
    assert list(models) == ["wall (g1)", "wall (g2)", "g3"]
    assert models["wall (g2)"].vertices[:, 0].tolist() == [4, 5] * 4
    assert coface.arrange(models).measures == [1.0, 1.0, 1.0]
    # Version 0.7: an object with twelve numbers.
    turn = np.array([[0, -1, 0, 10], [1, 0, 0, 0], [0, 0, 1, 0]], float)
    old = shape("slab", "g4", (0, 0, 0), (2, 1, 1), SimpleNamespace(data=tuple(turn.reshape(-1, order="F"))))
    vertices = coface.from_ifcopenshell(old)["slab"].vertices
    assert (vertices.min(axis=0).tolist(), vertices.max(axis=0).tolist()) == ([9, 0, 0], [10, 2, 1])

    class Iterator:
        """What ``ifcopenshell.geom.iterator`` is."""

        def __init__(self):
            self.left = list(shapes)

        def initialize(self):
            return bool(self.left)

        def get(self):
            return self.left[0]

        def next(self):
            self.left.pop(0)
            return bool(self.left)

    assert list(coface.from_ifcopenshell(Iterator())) == list(models)
    with pytest.raises(coface.InvalidInputError, match="no shapes"):
        coface.from_ifcopenshell([])
    with pytest.raises(coface.InvalidInputError, match="not 12 or 16"):
        coface.from_ifcopenshell(shape("w", "g", (0, 0, 0), (1, 1, 1), (1.0, 2.0)))


@pytest.fixture
def topologicpy(monkeypatch):
    """The functions of topologicpy that are called, on stand-ins: a cell lists its faces, a face its points."""
    parts = {
        "Vertex": {"ByCoordinates": lambda x, y, z: (x, y, z)},
        "Face": {"ByVertices": lambda points: SimpleNamespace(points=tuple(points))},
        "Cell": {"ByFaces": lambda faces, tolerance: SimpleNamespace(faces=list(faces), dictionary=None)},
        "CellComplex": {
            "ByCells": lambda cells, transferDictionaries, tolerance: SimpleNamespace(cells=cells, dictionary=None)
        },
        "Dictionary": {
            "ByKeysValues": lambda keys, values: dict(zip(keys, values, strict=True)),
            "ValueAtKey": lambda dictionary, key: dictionary.get(key),
        },
        "Topology": {
            "Cells": lambda topology: getattr(topology, "cells", None),
            "Dictionary": lambda topology: topology.dictionary,
            "SetDictionary": lambda topology, dictionary: vars(topology).update(dictionary=dictionary) or topology,
            "Geometry": geometry_of,
        },
    }
    monkeypatch.setitem(sys.modules, "topologicpy", ModuleType("topologicpy"))
    for name, functions in parts.items():
        module = ModuleType(f"topologicpy.{name}")
        setattr(module, name, SimpleNamespace(**functions))
        monkeypatch.setitem(sys.modules, f"topologicpy.{name}", module)


def geometry_of(cell, mantissa):
    assert mantissa >= 15, "six decimals would move vertices"
    points = sorted({point for face in cell.faces for point in face.points})
    return {
        "vertices": [list(point) for point in points],
        "edges": [],
        "faces": [[points.index(point) for point in face.points] for face in cell.faces],
    }


@pytest.mark.usefixtures("topologicpy")
def test_cells_go_to_topologicpy_and_come_back():
    arranged = coface.arrange({name: box(*sides) for name, sides in PAIR.items()})
    complex = coface.to_topologic(arranged)
    assert len(complex.cells) == 3
    found = sorted((cell.dictionary["volume"], cell.dictionary["inputs"]) for cell in complex.cells)
    assert found == [(1.0, "a; b"), (7.0, "a"), (7.0, "b")]
    models = coface.from_topologic(complex)
    assert list(models) == ["cell 0", "cell 1", "cell 2"]
    assert sorted(coface.arrange(models, rule="evenodd").measures) == [1.0, 7.0, 7.0]
    for cell in complex.cells:
        cell.dictionary["name"] = "room"
    assert list(coface.from_topologic(complex)) == ["room", "room (1)", "room (2)"]
    single = coface.to_topologic(box((0, 0, 0), (1, 1, 1)))
    assert len(single.faces) == 6
    assert list(coface.from_topologic(single)) == ["topology"]


def test_topologicpy_is_asked_for_by_name(monkeypatch):
    for name in [name for name in sys.modules if name.startswith("topologicpy.")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "topologicpy", None)
    with pytest.raises(ImportError, match="pip install topologicpy"):
        coface.to_topologic(coface.generate("box", boundary=True))


def test_the_page_of_buildings_says_which_door_leads_where(monkeypatch, capsys):
    root = pathlib.Path(__file__).resolve().parents[3]
    page = (root / "docs" / "buildings.md").read_text()
    code = page.split("```python\n")[1].split("```")[0]
    expected = page.split("```text\n")[1].split("```")[0]
    monkeypatch.chdir(root)
    exec(compile(code, "docs/buildings.md", "exec"), {})
    assert capsys.readouterr().out == expected
