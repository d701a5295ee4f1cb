"""Buildings: the graph of the cells of an arrangement, and walls from IfcOpenShell and Topologic."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from coface import _coface
from coface._coface import Model
from coface.interop import ifcopenshell, needed, topologic
from coface._faults import in_words


@dataclass(frozen=True)
class CellNode:
    """A bounded cell of an arrangement in space.

    Attributes
    ----------
    cell
        The number of the cell, from 0.
    volume
        Its volume without its voids.
    centroid
        The center of its mass.
    bounds
        The least and the largest coordinates.
    inputs
        The numbers of the inputs that contain it: none for a room between walls.
    exterior
        Whether it has a face in common with the exterior.
    exterior_area, exterior_faces, exterior_inputs
        The area and the number of these faces, and the inputs that they are of.
    """

    cell: int
    volume: float
    centroid: tuple[float, float, float]
    bounds: tuple[tuple[float, float, float], tuple[float, float, float]]
    inputs: tuple[int, ...]
    exterior: bool
    exterior_area: float
    exterior_faces: int
    exterior_inputs: tuple[int, ...]


@dataclass(frozen=True)
class CellEdge:
    """Two bounded cells that have faces in common.

    Attributes
    ----------
    cells
        The two cells, rising.
    area
        The area of the faces between them.
    faces
        The number of these faces.
    inputs
        The numbers of the inputs that the faces are of.
    """

    cells: tuple[int, int]
    area: float
    faces: int
    inputs: tuple[int, ...]


@dataclass(frozen=True)
class CellGraph:
    """Which cells of an arrangement are adjacent, and across how much area.

    Made by :meth:`SpatialArrangement.graph`.

    Attributes
    ----------
    inputs
        The names of the inputs.
    nodes
        The bounded cells.
    edges
        The pairs of cells that have a face in common.

    Examples
    --------
    Two boxes of volume 1 on a common side:

    >>> import coface
    >>> box = coface.generate("box", boundary=True)
    >>> graph = coface.arrange({"left": box, "right": coface.Model(box.vertices + [1, 0, 0], box.faces)}).graph()
    >>> [(edge.cells, edge.area, graph.names(edge.inputs)) for edge in graph.edges]
    [((0, 1), 1.0, ('left', 'right'))]
    >>> [node.exterior_area for node in graph.nodes]
    [5.0, 5.0]
    """

    inputs: tuple[str, ...]
    nodes: tuple[CellNode, ...]
    edges: tuple[CellEdge, ...]

    @classmethod
    def from_dict(cls, value: Mapping[str, Any]) -> CellGraph:
        """The graph of the words of the program's JSON.

        Examples
        --------
        >>> import coface
        >>> coface.CellGraph.from_dict({"inputs": ["a"], "nodes": [], "edges": []}).inputs
        ('a',)
        """
        nodes = (CellNode(**{name: _frozen(part) for name, part in node.items()}) for node in value["nodes"])
        edges = (CellEdge(**{name: _frozen(part) for name, part in edge.items()}) for edge in value["edges"])
        return cls(tuple(value["inputs"]), tuple(nodes), tuple(edges))

    def to_dict(self) -> dict[str, Any]:
        """The graph in the words of the program's JSON."""
        return asdict(self)

    def names(self, inputs: tuple[int, ...]) -> tuple[str, ...]:
        """The names of inputs by their numbers."""
        return tuple(self.inputs[number] for number in inputs)

    def to_graphml(self) -> str:
        """The graph as GraphML: the text that ``coface arrange --graph rooms.graphml`` writes."""
        return _coface.graphml(json.dumps(self.to_dict()))

    def to_networkx(self) -> Any:
        """The graph as ``networkx.Graph``: nodes are numbers of cells, and inputs are names.

        Raises
        ------
        ImportError
            If networkx is not installed, with the command that installs it.

        Examples
        --------
        >>> import coface, pytest
        >>> _ = pytest.importorskip("networkx")
        >>> box = coface.generate("box", boundary=True)
        >>> graph = coface.arrange({"left": box, "right": coface.Model(box.vertices + [1, 0, 0], box.faces)}).graph()
        >>> graph.to_networkx().edges[0, 1]["inputs"]
        ('left', 'right')
        """
        networkx = needed("networkx", "a graph of cells as networkx.Graph")
        graph = networkx.Graph()
        for node in self.nodes:
            values = {name: part for name, part in vars(node).items() if name != "cell"}
            values["inputs"] = self.names(node.inputs)
            values["exterior_inputs"] = self.names(node.exterior_inputs)
            graph.add_node(node.cell, **values)
        for edge in self.edges:
            graph.add_edge(*edge.cells, area=edge.area, faces=edge.faces, inputs=self.names(edge.inputs))
        return graph


def _frozen(value: Any) -> Any:
    return tuple(_frozen(part) for part in value) if isinstance(value, (list, tuple)) else value


@in_words
def from_ifcopenshell(shapes: Any) -> dict[str, Model]:
    """The shapes that IfcOpenShell makes of elements of an IFC file, as models with names: inputs of :func:`arrange`.

    Parameters
    ----------
    shapes
        A shape of ``ifcopenshell.geom.create_shape``, several of them, or an ``ifcopenshell.geom.iterator``.

    Returns
    -------
    dict of str to Model
        Triangles in the coordinates of the world, in the order of the shapes. Their names are those of the elements; a
        name that several have is
        followed by the identifier (``guid``), which stands alone where there is no name.

    Notes
    -----
    What is read of a shape are ``geometry.verts``, ``geometry.faces``, ``transformation.matrix``, ``name`` and
    ``guid``, as IfcOpenShell 0.7
    and 0.8 have them. Coordinates are moved in floating point; where walls must touch exactly, let IfcOpenShell use
    the coordinates of the
    world (the setting ``use-world-coords``).

    Examples
    --------
    >>> import coface
    >>> from types import SimpleNamespace as Shape
    >>> geometry = Shape(verts=(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 6), faces=(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3))
    >>> wall = Shape(geometry=geometry, name="wall", guid="2O2Fr$t4X7Zf8NOew3FLKI")
    >>> coface.from_ifcopenshell([wall])
    {'wall': Model(4 vertices, 4 faces)}
    """
    return ifcopenshell.to_models(shapes)


@in_words
def from_topologic(topology: Any) -> dict[str, Model]:
    """The cells of a topology of topologicpy as models with names: inputs of :func:`arrange`.

    Parameters
    ----------
    topology
        A ``Cell``, ``CellComplex`` or ``Cluster``; of one without cells, all faces are one model.

    Returns
    -------
    dict of str to Model
        The names are the values of the key ``name`` of the dictionaries, or ``cell 0`` and so on.

    Notes
    -----
    Functions of topologicpy 0.9 are called: ``Topology.Cells``, ``Topology.Geometry``, ``Topology.Dictionary`` and
    ``Dictionary.ValueAtKey``.
    """
    return topologic.to_models(topology)


@in_words
def to_topologic(x: Any, *, tolerance: float = 0.0001) -> Any:
    """An arrangement as a ``CellComplex`` of topologicpy, or a closed model as a ``Cell``.

    Parameters
    ----------
    x
        A :class:`SpatialArrangement`, or anything that :func:`as_model` understands.
    tolerance
        The length that topologicpy takes for zero.

    Returns
    -------
    topologic_core.CellComplex or topologic_core.Cell
        Each cell of an arrangement has a dictionary with the keys ``cell``, ``volume`` and ``inputs`` (names, with a
        semicolon between two).

    Raises
    ------
    ImportError
        If topologicpy is not installed, with the command that installs it.

    Notes
    -----
    Functions of topologicpy 0.9 are called: ``Vertex.ByCoordinates``, ``Face.ByVertices``, ``Cell.ByFaces``,
    ``CellComplex.ByCells``,
    ``Dictionary.ByKeysValues`` and ``Topology.SetDictionary``.
    """
    return topologic.from_arrangement_or_model(x, tolerance)
