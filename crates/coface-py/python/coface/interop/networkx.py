"""networkx: graphs, whose nodes are vertices and whose edges are lines."""

from __future__ import annotations

import operator
from typing import Any, NoReturn

import numpy as np

from coface._coface import ChainComplex, Model, _named_chains
from coface._arrays import raise_invalid
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A graph as a model of lines. Vertex i is the i-th node in the order of ``graph.nodes``.

    Where each node has the attribute ``pos``, that is where it is.

    Raises
    ------
    coface.InvalidInputError
        If there are parallel edges or loops, which no lines are: :func:`to_chain_complex` takes them.
    """
    number, pairs = _pairs(value)
    if len(pairs):
        ordered = np.sort(pairs, axis=1)
        loop = np.flatnonzero(ordered[:, 0] == ordered[:, 1])
        distinct, first = np.unique(ordered, axis=0, return_index=True)
        if value.is_multigraph() and len(distinct) < len(ordered):
            parallel = np.setdiff1d(np.arange(len(ordered)), first)[0]
            _refuse(f"edge {parallel} is parallel to another", ordered[parallel])
        if len(loop):
            _refuse(f"edge {loop[0]} is a loop", ordered[loop[0]])
        if value.is_directed():
            pairs = pairs[np.sort(first)]
    spots = [data.get("pos") for _, data in value.nodes(data=True)]
    has_places = len(spots) > 0 and all(spot is not None for spot in spots)
    places = np.array([np.asarray(spot, np.float64) for spot in spots]) if has_places else None
    if places is None:
        return Model.from_arrays(cells={"line": pairs}, vertex_count=len(number))
    return Model.from_arrays(places, cells={"line": pairs})


def to_chain_complex(value: Any) -> ChainComplex:
    """A graph as a chain complex: nodes in degree 0, edges in degree 1, each from its first node to its second.

    Parallel edges and loops are cells of their own; so the first Betti number is that of the multigraph. Vertex i is the i-th node in the order of ``graph.nodes``.
    """
    from scipy.sparse import csc_array

    number, pairs = _pairs(value)
    columns = np.repeat(np.arange(len(pairs)), 2)
    entries = np.tile(np.array([-1, 1], np.int64), len(pairs))
    matrix = csc_array((entries, (pairs.reshape(-1), columns)), shape=(len(number), len(pairs)))
    matrix.sum_duplicates()
    matrix.eliminate_zeros()
    names = [[[vertex] for vertex in range(len(number))], pairs.tolist()]
    return _named_chains([matrix], names)


def named(graph: Any, walks: Any) -> Any:
    """The nodes of a graph where an answer has numbers of vertices: of one walk, or of lists of walks.

    Parameters
    ----------
    graph
        The graph that was asked about.
    walks
        Numbers of vertices in lists or arrays, such as :attr:`Generator.loop`.

    Returns
    -------
    list
        The same with nodes instead of numbers.

    Examples
    --------
    >>> import coface, pytest
    >>> networkx = pytest.importorskip("networkx")
    >>> graph = networkx.Graph(["ab", "bc", "ca", "cd"])
    >>> loops = [generator.loop for generator in coface.homology(graph, generators=True)[1].generators]
    >>> [sorted(loop[:-1]) for loop in coface.interop.networkx.named(graph, loops)]
    [['a', 'b', 'c']]
    """
    nodes = list(graph.nodes)

    def node(number: Any) -> Any:
        at = operator.index(number)
        if not 0 <= at < len(nodes):
            raise_invalid(f"the graph has {len(nodes)} nodes, and none with the number {at}", "give the graph that the answer is about")
        return nodes[at]

    def of(walk: Any) -> Any:
        return [of(one) for one in walk] if isinstance(walk, (list, tuple, np.ndarray)) else node(walk)

    return of(walks)


def _pairs(value: Any) -> tuple[dict[Any, int], Any]:
    number = {node: place for place, node in enumerate(value.nodes)}
    pairs = [(number[start], number[end]) for start, end in value.edges()]
    return number, np.array(pairs, np.int64).reshape(-1, 2)


def _refuse(what: str, pair: Any) -> NoReturn:
    raise_invalid(
        f"{what}, from vertex {pair[0]} to vertex {pair[1]}, and a line has no such",
        "ask the chain complex of the graph: coface.as_chain_complex(graph)",
        [pair.tolist()],
    )


def from_model(model: Model) -> Any:
    """The vertices and edges of a model, those of its faces and cells included, as :class:`networkx.Graph`.

    Nodes are the numbers of the vertices; ``pos`` is where they are, if the model knows.
    """
    library = needed("networkx", "to_networkx")
    graph = library.Graph()
    places = model.vertices
    if places is None:
        graph.add_nodes_from(np.asarray(model.simplices(0)).reshape(-1).tolist())
    else:
        graph.add_nodes_from((vertex, {"pos": tuple(place)}) for vertex, place in enumerate(places.tolist()))
    graph.add_edges_from(np.asarray(model.edges).tolist())
    return graph
