"""What is taken where arrays and lists are: tables, sets, generators, features; and models where complexes are."""

from __future__ import annotations

import inspect
import json
import pickle
import types
from pathlib import Path

import numpy as np
import pytest

import coface

CORNERS = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]


class Table:
    """What pandas and its kin have: rows as an array."""

    def __init__(self, rows):
        self.rows = rows

    def to_numpy(self):
        return np.asarray(self.rows)


class Features:
    """What geopandas has: rows with geometries and properties."""

    iloc = None

    def __init__(self, collection):
        self.collection = collection

    @property
    def __geo_interface__(self):
        return self.collection


def test_tables_are_arrays() -> None:
    model = coface.Model(Table(CORNERS), Table([[0, 1, 2]]))
    assert model == coface.Model(CORNERS, [[0, 1, 2]])
    assert coface.as_model(Table([[0, 1, 2]])).structure == "facets"
    assert coface.homology((Table(CORNERS), Table([[0, 1, 2]]))).betti_numbers == (1, 0, 0)
    assert coface.persistence([[0, 1], [1, 2]], Table([0.0, 2.0, 1.0])).diagram(0).shape == (2, 2)
    assert coface.Complex(Table([[0, 1, 2]])).f_vector == (3, 3, 1)
    pandas = pytest.importorskip("pandas")
    points = pandas.DataFrame(CORNERS, columns=["x", "y"])
    assert coface.Model(points, pandas.DataFrame([[0, 1, 2]])) == model
    assert coface.persistence([[0, 1], [1, 2]], pandas.Series([0.0, 2.0, 1.0])).betti_numbers == (1, 0)


def test_sets_are_facets() -> None:
    expected = coface.Model.from_facets([[0, 1, 2], [1, 2, 3]])
    assert coface.as_model({(0, 1, 2), (1, 2, 3)}) == expected
    assert coface.as_model({frozenset([2, 1, 0]), frozenset([3, 2, 1])}) == expected
    assert coface.as_model([{0, 1, 2}, {1, 2, 3}]) == expected
    assert coface.Complex({(0, 1), (1, 2)}).f_vector == (3, 2)
    # The corners of a polygon have an order.
    with pytest.raises(coface.InvalidInputError, match="no order"):
        coface.Model(CORNERS, [{0, 1, 2}])


def test_generators_are_lists() -> None:
    assert coface.as_model(facet for facet in [[0, 1, 2], [2, 3]]).f_vector == (4, 4, 1)
    assert coface.Model((point for point in CORNERS), iter([[0, 1, 2]])).f_vector == (3, 3, 1)
    assert coface.Model.from_facets({"a": [0, 1]}.values()).f_vector == (2, 1)
    assert coface.boolean("union", (coface.polygon(CORNERS) for _ in range(2))).measure == 0.5
    assert coface.boolean("union", (coface.polygon(CORNERS), coface.polygon(CORNERS))).measure == 0.5


def test_polygons_without_area_are_told() -> None:
    with pytest.raises(coface.InvalidInputError, match="ring 1 of the polygon has 2 points"):
        coface.polygon(CORNERS, [[0, 0], [1, 1]])
    flat = coface.boolean("union", coface.polygon([[0, 0], [1, 1], [2, 2]]))
    assert flat.measure == 0.0
    assert "has no area in the plane" in flat.to_dict()["remarks"][0]["message"]
    assert "has no area in the plane" in coface.arrange(coface.polygon([[0, 0], [1, 1], [2, 2]])).to_dict()["remarks"][0]["message"]


def test_features_bring_their_attributes() -> None:
    ring = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]
    feature = {"type": "Feature", "properties": {"kind": "field"}, "geometry": {"type": "Polygon", "coordinates": (tuple(map(tuple, ring)),)}}
    found = coface.arrange(Features({"type": "FeatureCollection", "features": [feature]}))
    assert found.measures == [4.0] and found.properties(0) == {"kind": "field"}
    shapely = pytest.importorskip("shapely")
    assert coface.boolean("union", shapely.box(0, 0, 1, 1)).measure == 1.0


def test_questions_about_chains_take_models() -> None:
    ring = [[0, 1], [1, 2], [0, 2]]
    complex = coface.as_chain_complex(ring)
    for x in (ring, coface.Model.from_facets(ring), coface.Complex(ring), complex):
        assert (coface.laplacian(x, 0) != coface.laplacian(complex, 0)).nnz == 0
        critical, pairs = coface.matching(x, 0)
        assert (len(critical), len(pairs)) == (1, 2)
        [found] = coface.classes(x, [[(1, [0, 1]), (1, [1, 2]), (-1, [0, 2])]])
        assert found["class"] in ([1], [-1]) and not found["bounds"]
        parts = coface.decompose(x, 1, [1.0, 0.0, 0.0])
        assert np.allclose(sum(parts), [1.0, 0.0, 0.0])
        assert coface.harmonic(x, degree=1).shape == (1, 3)


def test_a_part_is_named_by_its_group() -> None:
    points = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]]
    strip = coface.Model(points, [[0, 1, 4, 3], [1, 2, 5, 4]])
    ends = strip.with_group("ends", [0, 3, 2, 5], "vertices").with_group("left", [0], "faces")
    assert coface.homology(ends, relative="ends").betti_numbers == (0, 3, 0)
    assert coface.homology(ends, relative="left").betti_numbers == (0, 0, 0)
    assert coface.homology(ends, relative="boundary").betti_numbers == (0, 0, 1)
    assert coface.cohomology(ends, relative="ends").betti_numbers == (0, 3, 0)
    assert coface.long_exact_sequence(ends, "ends")["pair"].betti_numbers == (0, 3, 0)
    tetrahedra = coface.Model.from_arrays(np.vstack([np.zeros(3), np.eye(3), -np.eye(3)[:1]]), cells={"tetra": [[0, 1, 2, 3], [0, 2, 3, 4]]})
    marked = tetrahedra.with_group("one", [1], "cells")
    assert coface.homology(marked, relative="one").betti_numbers == (0, 0, 0, 0)
    assert coface.homology(ends, relative=["ends", "left"]).betti_numbers == (0, 2, 0)
    assert coface.homology(ends, domain="left", relative="ends").betti_numbers == (0, 1, 0)
    assert coface.homology(ends, domain="left", relative="boundary").betti_numbers == (0, 0, 1)
    with pytest.raises(coface.InvalidInputError, match='no group "right": it has "ends"'):
        coface.homology(ends, domain="right")
    with pytest.raises(coface.InvalidInputError, match="it has 'ends', 'left'"):
        coface.homology(ends, relative="right")


def test_generators_are_written_as_physical_groups(tmp_path: Path) -> None:
    ring = coface.generate("ring").with_group("all", [0], "faces")
    cut = coface.cohomology(ring, generators=True)[1].generators[0]
    ring.with_chain("H^1{0}1", cut).write(tmp_path / "out.msh")
    again = coface.read(tmp_path / "out.msh")
    assert [name for name, _, _ in again.groups] == ["H^1{0}1", "all"]
    chains = again.chain_complex()
    cochain = chains.cochain("H^1{0}1")
    loop = chains.homology(generators=True)[1].generators[0]
    assert abs(sum(x * dict((tuple(c), y) for y, c in cochain.terms()).get(tuple(c), 0) for x, c in loop.chain.terms())) == 1
    with pytest.raises(coface.InvalidInputError, match="not one of this model"):
        again.with_chain("cut", cut)


def test_faults_in_arguments_are_faults_of_this_package() -> None:
    ring = [[0, 1], [1, 2], [0, 2]]
    for call, also in [
        (lambda: coface.homology(ring, "z", "q"), TypeError),
        (lambda: coface.homology(), TypeError),
        (lambda: coface.homology(ring, colour="z"), TypeError),
        (lambda: coface.cover([[0, 1, 2]], radius="far"), TypeError),
        (lambda: coface.cover([[0, 1, 2]], radius=-1), OverflowError),
        (lambda: coface.volume(np.ones((2, 2)), threshold="otsu"), ValueError),
        (lambda: coface.volume(np.ones((2, 2)), periodic=True), TypeError),
        (lambda: coface.as_chain_complex(ring).boundary(-1), OverflowError),
        (lambda: coface.as_chain_complex(ring).boundary("one"), TypeError),
        (lambda: coface.as_model(ring).simplices(-1), OverflowError),
        (lambda: coface.homology(ring)[9], IndexError),
        (lambda: coface.polygon([[0, 0], [1]]), ValueError),
        (lambda: coface.decompose(ring, 1, "values"), ValueError),
        (lambda: coface.read(3), TypeError),
        (lambda: coface.YinSet([[0, 0], [1, 0], [1, 1]]), TypeError),
        (lambda: coface.YinSet.combine([], "meet"), TypeError),
        (lambda: coface.YinSet.combine("meet", [1]), TypeError),
        (lambda: coface.YinSet.from_rings([[[0, 0], [1, 0], [1, 1]]], kinks=[(0,)]), ValueError),
        (lambda: coface.Model.from_gluings([[1]]), ValueError),
        (lambda: coface.generate(3), TypeError),
        (lambda: coface.as_model(ring).report(check=3), TypeError),
        (lambda: coface.as_model(ring).to_bytes(3), TypeError),
        (lambda: coface.Complex(ring).wedge(-1, coface.Complex(ring), 0), OverflowError),
        (lambda: coface.Complex(ring).skeleton(), TypeError),
    ]:
        with pytest.raises(coface.Error) as caught:
            call()
        assert isinstance(caught.value, also)
        assert caught.value.kind in ("InvalidInput", "NotInComplex") and caught.value.cure


def test_functions_and_methods_can_be_sent_to_processes() -> None:
    for thing in (coface.read, coface.homology, coface.generate, coface.as_model, coface.boolean):
        assert pickle.loads(pickle.dumps(thing)) is thing
    report = pickle.loads(pickle.dumps(coface.as_model([[0, 1]]).report))
    assert report().f_vector == (2, 1)
    assert str(inspect.signature(coface.Model.report)).startswith("(self, ") and coface.Model.report.__doc__


def test_faults_of_the_user_stay_as_they_are() -> None:
    def progress(stage: str, done: int, total: int) -> None:
        raise ValueError("mine")

    big = coface.generate("torus", columns=400, rows=400)
    with pytest.raises(ValueError, match="mine") as caught:
        coface.homology(big, generators=True, progress=progress)
    assert not isinstance(caught.value, coface.Error)
    broken = types.SimpleNamespace(is_multigraph=None)
    with pytest.raises(coface.Error):
        coface.as_model(broken)


def test_dictionaries_are_json_files() -> None:
    assert coface.as_model({"facets": [[0, 1, 2]]}).f_vector == (3, 3, 1)
    assert coface.as_model(json.loads(json.dumps(coface.generate("csaszar").to_dict()))) == coface.generate("csaszar")
