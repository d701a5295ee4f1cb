"""Answers go to dictionaries and pickles, and come back whole."""

from __future__ import annotations

import json
import pickle
from typing import Any

import numpy as np
import pytest

import coface


def _square(corner: float) -> coface.Model:
    return coface.polygon([[corner, corner], [corner + 2, corner], [corner + 2, corner + 2], [corner, corner + 2]])


def _answers() -> dict[str, Any]:
    squares, cube = [_square(0), _square(1)], coface.generate("box", boundary=True)
    torus = coface.generate("torus", columns=5, rows=4)
    plane = coface.generate("rp2")
    found = coface.homology(plane, generators=True)
    sets = [coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]]), coface.YinSet([coface.Curve.circle([1, 1], 0.5)])]
    odd = coface.Model.from_arrays(np.arange(12.0).reshape(4, 3), [[0, 1, 2]], {"line": [[2, 3]]})
    odd = odd.with_data("half", [0.5, 1.5, 2.5, 3.5]).with_group("rim", [0], "lines")
    return {
        "Homology": found,
        "Homology over F2": coface.homology(torus, "f2", generators=True),
        "Homology of no cells": coface.homology([]),
        "Cohomology": coface.cohomology(torus, generators=True),
        "reduced": coface.homology(torus, reduced=True, generators=True),
        "HomologyGroup": found[1],
        "Generator": found[1].generators[0],
        "Chain": found[1].generators[0].certificate,
        "FundamentalGroup": coface.pi1(torus)[0],
        "group of words": coface.FundamentalGroup(2, [[1, 2, -1, -2]]),
        "Domain": coface.cut(torus),
        "path": coface.cut(torus, along=coface.cocycles(torus).loops[0]),
        "Cover": coface.cover(torus, radius=1),
        "Cocycles": torus.surface().cocycles(harmonic=True),
        "Persistence": coface.persistence(torus, np.asarray(torus.vertices)[:, 2]),
        "PlanarArrangement": coface.arrange(squares),
        "PlanarBoolean": coface.boolean("difference", *squares),
        "SpatialArrangement": coface.arrange({"a": cube, "b": coface.Model(cube.vertices + 0.5, cube.faces)}),
        "SolidBoolean": coface.boolean("union", cube, coface.Model(cube.vertices + 0.5, cube.faces)),
        "Congruence": coface.congruence(cube, cube, tolerance=0.1),
        "YinSet": sets[0] - sets[1],
        "CutCells": sets[0].cut_cells((3, 4), spacing=(1.0, 0.5)),
        "Interface": coface.interface(np.array([[1, 2, 2], [3, 3, 2]])),
        "fitted interface": coface.interface(np.array([[1, 2, 2], [3, 3, 2]])).fit(4, kinks=45.0),
        "moved interface": coface.interface(np.array([[1, 1, 2], [1, 1, 2]])).advected("translation", 1.0, spacing=3.0)[0],
        "Curve": coface.Curve.circle([0, 0], 1),
        "Model": odd,
        "volume": coface.volume(np.arange(8).reshape(2, 2, 2), periodic=[1]),
        "gluings": coface.Model.from_signature("cMcabbgqw", 3),
        "halfedges": coface.Model.from_halfedges([2, 3, 1, 0]),
        "chains": coface.arrange(squares).chain_complex().model(),
        "cells": coface.boolean("union", cube, coface.Model(cube.vertices * 0.5 + 0.25, cube.faces)).cells,
        "Surface": torus.surface(),
        "Simplices": coface.Complex([[0, 1, 2], [2, 9]]).star([2]),
        "Verdict": coface.Complex([[0, 1, 2], [0, 1, 3], [0, 1, 4]]).is_manifold(),
        "Verdict yes": coface.Complex([[0, 1, 2]]).is_manifold(),
        "Kinks": (sets[0] - sets[1]).kinks,
        "LarModel": coface.LarModel([[[0, 1], [1, 2], [0, 2]], [[0, 1, 2]]]),
        "SimplicialGrid": coface.SimplicialGrid((2, 1)),
        "CuboidGrid": coface.CuboidGrid((2, 1)),
        "CuboidGrid of lengths": coface.CuboidGrid(lengths=[[0.5, 0.25], [2.0]]),
        "CuboidGrid with a gap": coface.CuboidGrid(lengths=[[1.0, -0.5, 2.0], [1.0]]),
        "CellGraph": coface.arrange({"a": cube, "b": coface.Model(cube.vertices + 0.5, cube.faces)}).graph(),
        "Report": None,
        "Complex": coface.Complex([[0, 1, 2], [2, 9]]),
        "ChainComplex": torus.chain_complex(),
        "pair": torus.chain_complex(coface.Model.from_facets([[0, 1]])),
    }


ANSWERS = {name: answer for name, answer in _answers().items() if answer is not None}

#: Rows of tables and the parts of a graph are dictionaries and tuples themselves.
RECORDS = {"BatchRow", "BatchSummary", "CellEdge", "CellNode", "Verified"}


def test_every_class_is_asked() -> None:
    classes = {name: getattr(coface, name) for name in coface.__all__ if isinstance(getattr(coface, name), type)}
    classes = {name: found for name, found in classes.items() if not issubclass(found, Exception) and name not in RECORDS}
    # The report has its model on request: a test of its own.
    assert set(classes) - {type(answer).__name__ for answer in ANSWERS.values()} == {"Report"}
    missing = [
        f"{name}.{member}"
        for name, found in classes.items()
        for member in ("to_dict", "from_dict", "_repr_html_", "__eq__", "__hash__", "__repr__", "__reduce__")
        if getattr(found, member, None) in (None, getattr(object, member, None)) and (name, member) != ("CellGraph", "__reduce__")
    ]
    assert missing == []


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_answers_are_compared_with_anything(name: str) -> None:
    answer = ANSWERS[name]
    for other in (None, 0, "x", [], object(), np.zeros(3), float("nan"), *ANSWERS.values()):
        is_equal = answer == other
        assert isinstance(is_equal, (bool, np.ndarray))
        if isinstance(is_equal, bool):
            assert (answer != other) is not is_equal
            if is_equal:
                assert hash(answer) == hash(other) and type(other) is type(answer)


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_answers_show_and_name_themselves(name: str) -> None:
    text = ANSWERS[name]._repr_html_()
    assert text.startswith("<div>") and len(text) <= 60_000 and "<script" not in text
    assert type(ANSWERS[name]).__name__ in repr(ANSWERS[name]) or repr(ANSWERS[name]).startswith(("H_", "H^", "Cohomology", "Z", "F"))


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_dictionaries_lose_nothing(name: str) -> None:
    answer = ANSWERS[name]
    facts = json.loads(json.dumps(answer.to_dict(), allow_nan=False))
    again = type(answer).from_dict(facts)
    assert type(again) is type(answer) and again == answer and hash(again) == hash(answer)
    assert again.to_dict() == answer.to_dict() and repr(again) == repr(answer)


@pytest.mark.parametrize("name", sorted(ANSWERS))
def test_pickles_lose_nothing(name: str) -> None:
    answer = ANSWERS[name]
    again = pickle.loads(pickle.dumps(answer))
    assert again == answer and again.to_dict() == answer.to_dict()


def test_reports_keep_their_model_on_request() -> None:
    report = coface.generate("rp2").report()
    assert "recipe" not in report.to_dict()
    assert coface.Report.from_dict(json.loads(json.dumps(report.to_dict(model=True)))) == report
    assert pickle.loads(pickle.dumps(report)) == report
    with pytest.raises(coface.InvalidInputError, match=r"write it with report.to_dict\(model=True\)"):
        coface.Report.from_dict(report.to_dict())


def test_what_is_behind_an_answer_comes_back() -> None:
    arranged = coface.PlanarArrangement.from_dict(ANSWERS["PlanarArrangement"].to_dict())
    assert np.array_equal(arranged.vertices, ANSWERS["PlanarArrangement"].vertices)
    assert arranged.chain_complex() == ANSWERS["PlanarArrangement"].chain_complex()
    union = pickle.loads(pickle.dumps(ANSWERS["SolidBoolean"]))
    assert union.model == ANSWERS["SolidBoolean"].model and union.cells == ANSWERS["SolidBoolean"].cells
    generator = coface.Homology.from_dict(ANSWERS["Homology"].to_dict())[1].generators[0]
    first = ANSWERS["Homology"][1].generators[0]
    assert np.array_equal(generator.simplices, first.simplices) and np.array_equal(generator.as_vector().toarray(), first.as_vector().toarray())
    assert generator.certificate == first.certificate and generator.order == 2
    assert np.array_equal(generator.loop, first.loop)
    difference = pickle.loads(pickle.dumps(ANSWERS["YinSet"]))
    assert difference.provenance == ANSWERS["YinSet"].provenance is not None


def test_pickles_of_refined_cells_keep_what_they_are_pieces_of(tmp_path) -> None:
    outer = coface.generate("box", boundary=True)
    inner = coface.Model(outer.vertices * 0.5 + 0.25, outer.faces)
    refined = coface.boolean("difference", outer, inner).cells
    before, after = tmp_path / "before.json", tmp_path / "after.json"
    refined.write(before)
    pickle.loads(pickle.dumps(refined)).write(after)
    assert "pieces_of" in before.read_text() and before.read_text() == after.read_text()


def test_other_dictionaries_are_refused() -> None:
    with pytest.raises(coface.InvalidInputError, match="Cover, not a Domain"):
        coface.Domain.from_dict(ANSWERS["Cover"].to_dict())
    with pytest.raises(coface.InvalidInputError, match="made by 'os.system'"):
        coface.Model.from_dict({"recipe": {"made_by": "os.system", "arguments": ["true"], "options": {}}})
    for wrong in ({}, {"degree": 0}, {"degree": 0, "betti": 1, "torsion": [0]}, [1], 3):
        with pytest.raises(coface.Error):
            coface.HomologyGroup.from_dict(wrong)


def test_different_answers_differ() -> None:
    torus = coface.generate("torus", columns=5, rows=4)
    assert coface.cover(torus, radius=1) != coface.cover(torus, radius=2)
    assert coface.pi1(torus) == coface.pi1(torus) and coface.pi1(torus) != coface.pi1(coface.generate("klein"))
    assert torus.surface() == torus.surface() != coface.generate("klein").surface()
    assert torus.report() == torus.report() != coface.generate("klein").report()


def test_loops_are_walks_along_the_cells() -> None:
    torus = coface.generate("torus", columns=6, rows=5)
    edges = {tuple(sorted(edge)) for edge in np.asarray(torus.edges).tolist()}
    for ring in ("z", "f2", "f3"):
        for generator in coface.homology(torus, ring, generators=True)[1].generators:
            walk = generator.loop
            assert walk is not None and walk[0] == walk[-1] and len(walk) == generator.length + 1
            assert all(tuple(sorted(pair)) in edges for pair in zip(walk[:-1].tolist(), walk[1:].tolist()))
            assert generator.order is None
    whole = coface.homology(torus, generators=True)
    assert whole[2].generators[0].loop is None and whole[0].generators[0].loop is None
    assert coface.cohomology(torus, generators=True)[1].generators[0].loop is None
    # A chain of two loops apart is no single walk; one that is passed twice is.
    two = coface.as_chain_complex([[0, 1], [1, 2], [0, 2], [3, 4], [4, 5], [3, 5]])
    apart = two.chain([(1, [0, 1]), (1, [1, 2]), (1, [2, 0]), (1, [3, 4]), (1, [4, 5]), (1, [5, 3])])
    wrapped = {"bounding": None, **apart.to_dict(), "order": 0, "length": 6}
    assert coface.Generator.from_dict(wrapped).loop is None
    double = two.chain([(2, [0, 1]), (2, [1, 2]), (2, [2, 0])])
    assert coface.Generator.from_dict({**double.to_dict(), "order": 0, "length": 6}).loop.tolist() == [0, 1, 2, 0, 1, 2, 0]
