"""Certificates: what is proved of files, and what is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coface


@pytest.fixture
def plane(tmp_path: Path) -> Path:
    path = tmp_path / "plane.json"
    coface.generate("rp2").write(path)
    return path


def test_groups_of_files_are_proved(plane: Path) -> None:
    for coefficients, groups in [("z", ["Z", "Z/2", "0"]), ("f2", ["Z/2", "Z/2", "Z/2"]), ("q", ["Q", "0", "0"])]:
        proof = coface.certificate(plane, coefficients=coefficients)
        verified = coface.check(proof, plane)
        assert verified["files"] == [str(plane)]
        assert [claim.split(" = ")[1] for claim in verified["proved"]] == groups


def test_generators_cohomology_and_pairs_are_proved(plane: Path, tmp_path: Path) -> None:
    claims = coface.check(coface.certificate(plane, generators=True))["proved"]
    assert any("generate these groups" in claim for claim in claims)
    claims = coface.check(coface.certificate(plane, cohomology=True))["proved"]
    assert "H^2 = Z/2" in claims
    disk, edge = tmp_path / "disk.json", tmp_path / "edge.json"
    disk.write_text("[[0,1,2],[0,2,3]]")
    edge.write_text("[[0,1]]")
    claims = coface.check(coface.certificate(disk, relative="boundary"))["proved"]
    assert "relative H_2 = Z" in claims
    claims = coface.check(coface.certificate(disk, relative=edge), disk, edge)["proved"]
    assert "relative H_0 = 0" in claims


def test_reports_are_proved_from_files_of_certificates(tmp_path: Path) -> None:
    torus, proof = tmp_path / "torus.off", tmp_path / "torus.cert"
    coface.generate("torus").write(torus)
    proof.write_text(coface.certificate(torus, "info"))
    verified = coface.check(proof)
    assert "genus = 1" in verified["proved"] and "area" in verified["unchecked"]
    assert verified == coface.check(proof.read_bytes(), torus)


def test_drawings_are_proved(tmp_path: Path) -> None:
    a, b = tmp_path / "a.wkt", tmp_path / "b.geojson"
    a.write_text("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))")
    b.write_text('{"type": "Polygon", "coordinates": [[[4, 1], [6, 2], [4, 3], [1.5, 1.5], [4, 1]]]}')
    claims = coface.check(coface.certificate(a, "arrange"), a)["proved"]
    assert "inside = [[0],[]]" in claims and "f_vector = [8,8,2]" in claims
    for operation in ["union", "a - b", "xor"]:
        proof = coface.certificate([a, b], "boolean", operation=operation)
        said = json.loads(proof)["answer"]
        found = coface.boolean(operation, a, b)
        assert said["measure"] == pytest.approx(found.measure)
        assert any(claim.startswith("measure = ") for claim in coface.check(proof, a, b)["proved"])
    with pytest.raises(coface.InvalidInputError, match="operation"):
        coface.certificate([a, b], "boolean")
    with pytest.raises(coface.Error, match="one file"):
        coface.certificate([a, b], "homology")
    c = tmp_path / "c.wkt"
    c.write_text("POINT (1 2)")
    with pytest.raises(coface.Error, match="no certificate"):
        coface.certificate(c, "arrange")


def test_what_is_not_so_is_refused(plane: Path, tmp_path: Path) -> None:
    proof = json.loads(coface.certificate(plane))
    proof["answer"]["homology"][1]["torsion"] = [3]
    with pytest.raises(coface.InvalidInputError, match="not verified"):
        coface.check(json.dumps(proof), plane)
    other = tmp_path / "other.json"
    other.write_text("[[0,1]]")
    with pytest.raises(coface.InvalidInputError, match="not verified"):
        coface.check(coface.certificate(plane), other)
    with pytest.raises(coface.Error, match="no such regular file"):
        coface.check(coface.certificate(plane), tmp_path / "missing.json")
    with pytest.raises(coface.Error, match="homology"):
        coface.certificate(plane, "loops")  # type: ignore[arg-type]
    with pytest.raises(coface.Error, match="no such"):
        coface.certificate(tmp_path / "missing.json")
    for junk in ["{}", '{"a":1}', plane]:
        with pytest.raises(coface.InvalidInputError, match="not verified: certificate"):
            coface.check(junk)


def test_diagrams_are_proved(tmp_path: Path) -> None:
    torus = tmp_path / "torus.off"
    coface.generate("torus", columns=8, rows=6).write(torus)
    count = coface.read(torus).vertex_count
    for options, of in [
        ({}, ["the values of the vertices are z"]),
        ({"function": "x", "upper_star": True, "coefficients": "f3"}, ["the values of the vertices are x"]),
        # The checker does not see these values.
        ({"function": [float(vertex % 7) for vertex in range(count)]}, []),
    ]:
        proof = coface.certificate(torus, "persistence", **options)
        verified = coface.check(proof, torus)
        assert verified["proved"][: len(of)] == of
        assert verified["proved"][len(of)].endswith("= [1, 2, 1]")
        assert verified["unchecked"] == ([] if of else ["function"])
    lie = json.loads(proof)
    lie["answer"]["diagram"].pop()
    with pytest.raises(coface.InvalidInputError, match="not verified"):
        coface.check(json.dumps(lie), torus)
    with pytest.raises(coface.InvalidInputError, match="function="):
        coface.certificate(torus, "persistence", function="w")


def test_cuts_covers_cocycles_and_groups_are_proved(plane: Path, tmp_path: Path) -> None:
    torus = tmp_path / "torus.off"
    coface.generate("torus", columns=4, rows=3).write(torus)
    for of, options, expected in [
        ("cut", {"simplify": True}, "a component, torus, cut along"),
        ("cover", {"radius": 1}, "copies = 5"),
        ("cover", {"orientation": True}, "surfaces, in some order: torus, torus"),
        ("cocycles", {}, "rank = 2"),
        ("pi1", {}, "this group is Z^2"),
    ]:
        proof = coface.certificate(torus, of, **options)
        assert any(claim.startswith(expected) for claim in coface.check(proof, torus)["proved"]), of
    claims = coface.check(coface.certificate(plane, "cover", copies=2), plane)["proved"]
    assert "it is the universal cover: a covering of degree 2 that is simply connected" in claims
    with pytest.raises(coface.InvalidInputError, match="radius=2"):
        coface.certificate(plane, "cover")


def test_diagrams_of_points_are_proved(tmp_path: Path) -> None:
    square = tmp_path / "square.csv"
    square.write_text("0,0\n2,0\n2,2\n0,2\n")
    for kind, of in [("rips", "the rows of the file are 4 points with 2 coordinates"), ("alpha", "the simplices are a Delaunay triangulation of 4 points"), ("cech", "the filtration has")]:
        proof = coface.certificate(square, "persistence", points=kind)  # type: ignore[arg-type]
        verified = coface.check(proof, square)
        assert verified["proved"][0].startswith(of)
        assert verified["unchecked"] == (["function", "that these are the simplices of the input"] if kind == "cech" else [])
        hole = json.loads(proof)["answer"]["diagram"][-1]
        assert (hole["degree"], hole["birth"]) == (1, {"rips": 2.0, "alpha": 1.0, "cech": 1.0}[kind])
    image = tmp_path / "image.pgm"
    image.write_text("P2\n3 1\n9\n0 5 1\n")
    verified = coface.check(coface.certificate(image, "persistence", points="image"), image)
    assert verified["proved"][1] == "Betti numbers over F_2 = [1, 0, 0]" and not verified["unchecked"]
    with pytest.raises(coface.InvalidInputError, match='points="rips"'):
        coface.certificate(square, "persistence", points="flag")  # type: ignore[arg-type]


def test_walks_are_proved(plane: Path) -> None:
    # The rim of a triangle, and a walk around it along edges of others.
    facets = json.loads(plane.read_text())
    facets = facets if isinstance(facets, list) else facets["facets"]
    a, b, c = facets[0]
    sides = {frozenset(pair) for facet in facets for pair in [facet[:2], facet[1:], facet[::2]]}
    walk = next(
        [x, y, z, x]
        for x in range(6)
        for y in range(x)
        for z in range(y)
        if sorted([x, y, z]) not in [sorted(facet) for facet in facets] and all(frozenset(pair) in sides for pair in [(x, y), (y, z), (x, z)])
    )
    proof = coface.certificate(plane, "homotopic", walks=[[a, b, c, a], walk])
    verified = coface.check(proof, plane)
    answer = json.loads(proof)["answer"]
    contracted = [i for i, walk in enumerate(answer["walks"]) if walk["contractible"]]
    assert contracted[0] == 0
    assert f"of 2 walks, numbered from 0, those that can be contracted are {contracted}" in verified["proved"]
    assert verified["unchecked"] == ["components.base"]
    lie = json.loads(proof)
    lie["answer"]["walks"][0]["contractible"] = False
    with pytest.raises(coface.InvalidInputError, match="not verified"):
        coface.check(json.dumps(lie), plane)
    with pytest.raises(coface.InvalidInputError, match="walks="):
        coface.certificate(plane, "homotopic")
    with pytest.raises(coface.Error, match="ends at"):
        coface.certificate(plane, "homotopic", walks=[[a, b, c]])


def test_congruences_are_proved(tmp_path: Path) -> None:
    left, right = tmp_path / "left.off", tmp_path / "right.off"
    left.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    right.write_text("OFF\n3 1 0\n1 0 0\n1 1 0\n0 1 0.001\n3 0 1 2\n")
    proof = coface.certificate([left, right], "congruence", tolerance=0.01)
    verified = coface.check(proof, left, right)
    assert "cells become those of a complex with the f-vector [4, 5, 2] by a chain map onto it" in verified["proved"]
    assert "tolerance" not in verified["unchecked"]
    assert verified["files"] == [str(left), str(right)]
    assert "in order" in coface.check(coface.certificate(left, "congruence", tolerance=0.5, greedy=True))["proved"][0]
    with pytest.raises(coface.InvalidInputError, match="a congruence has a tolerance"):
        coface.certificate(left, "congruence")
    with pytest.raises(coface.InvalidInputError, match="the tolerance is -1"):
        coface.certificate(left, "congruence", tolerance=-1)


SQUARE = [[0, 0], [2, 0], [2, 2], [0, 2]]
CUBE = coface.generate("box", boundary=True)
TORUS = coface.generate("torus")
RING = np.array([[1.0, 2, 1], [2, 9, 2], [1, 2, 1]])
DRAWN = coface.Model.from_arrays([[0, 0], [2, 2], [0, 2], [2, 0]], cells={"line": [[0, 1], [2, 3], [1, 3]]})
MOVED = coface.Model(CUBE.vertices + 0.5, CUBE.faces)


@pytest.mark.parametrize(
    ("answer", "names", "claim"),
    [
        (lambda: coface.homology(coface.generate("rp2")), ["x.json"], "H_1 = Z/2"),
        (lambda: coface.homology([[0, 1], [1, 2], [0, 2]], "f2"), ["x.json"], "H_1 = Z/2"),
        (lambda: coface.cohomology(coface.generate("rp2"), generators=True), ["x.json"], "H^2 = Z/2"),
        (lambda: coface.homology(CUBE, relative="boundary"), ["x.off"], "H_2 = Z"),
        (lambda: coface.homology(coface.volume(np.ones((2, 2, 2)))), ["x.json"], "H_0 = Z"),
        (lambda: coface.homology([[0, 1, 2]], relative=[[0, 1], [1, 2], [0, 2]]), ["x.json"], "H_2 = Z"),
        (lambda: TORUS.report(), ["x.off"], "genus = 1"),
        (lambda: coface.pi1(TORUS)[0], ["x.off"], "the presentation of the answer"),
        (lambda: coface.cut(TORUS), ["x.off"], "disk"),
        (lambda: coface.cover(TORUS, radius=1), ["x.json"], "copies"),
        (lambda: coface.cocycles(TORUS), ["x.off"], "cocycle"),
        (lambda: coface.persistence(TORUS, "z"), ["x.off"], "Betti numbers over F_2 = [1, 2, 1]"),
        (lambda: coface.persistence([[0, 1], [1, 2]], [0.0, 2.0, 1.0]).longer_than(0.5), ["x.json"], "Betti numbers over F_2 = [1, 0]"),
        (lambda: coface.rips(SQUARE), ["x.txt"], "the rows of the file are 4 points"),
        (lambda: coface.alpha(SQUARE, radii=True), ["x.txt"], "Delaunay"),
        (lambda: coface.cubical(RING), ["x.npy"], "Betti numbers over F_2 = [1, 0, 0]"),
        (lambda: coface.arrange(DRAWN), ["x.wkt"], "f_vector = [5,5,1]"),
        (lambda: coface.boolean("union", coface.polygon(SQUARE), coface.polygon([[1, 1], [3, 1], [3, 3], [1, 3]])), ["x.wkt", "y.wkt"], "measure = 7"),
        (lambda: coface.boolean("intersection", CUBE, MOVED), ["x.off", "y.off"], "measure = 0.125"),
        (lambda: coface.congruence(CUBE, MOVED, tolerance=0.01), ["x.off", "y.off"], "chain map onto it"),
    ],
)
def test_answers_have_certificates(answer: Callable[[], Any], names: list[str], claim: str, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in names]
    found = answer()
    proof = found.certificate(paths if len(paths) > 1 else paths[0])
    proved = coface.check(proof, *paths)["proved"]
    assert any(claim in one for one in proved), proved
    # Again: the files are there, and hold the input. Other things are not replaced.
    assert found.certificate(paths if len(paths) > 1 else paths[0]) == proof
    paths[0].write_text("something else")
    with pytest.raises(coface.InvalidInputError, match="does not hold the input"):
        found.certificate(paths if len(paths) > 1 else paths[0])
    assert paths[0].read_text() == "something else"


def test_what_no_certificate_proves_is_said(tmp_path: Path) -> None:
    here = tmp_path / "x.json"
    for found, told in [
        (coface.rips([[0.0, 1], [1, 0]], distances="square"), "persistence of distances"),
        (coface.alpha(SQUARE), "radii=True"),
        (coface.cubical(RING, periodic=[0]), "periodic"),
        (coface.persistence([[0, 1]], cell_values=[[0, 0], [1]]), "no certificate"),
        (coface.Homology.from_dict(coface.homology(CUBE).to_dict()), "coface.certificate"),
    ]:
        with pytest.raises(coface.InvalidInputError, match=told):
            found.certificate(here)
    with pytest.raises(coface.InvalidInputError, match="1 path is given"):
        coface.boolean("union", CUBE, MOVED).certificate(here)
    with pytest.raises(coface.InvalidInputError, match="ends with .json"):
        coface.homology(CUBE).certificate(tmp_path / "x.stl")
    with pytest.raises(coface.FileError, match="folder that is there"):
        coface.homology(CUBE).certificate(tmp_path / "nowhere" / "x.json")
    assert not list(tmp_path.iterdir())


def test_parts_are_proved(tmp_path: Path) -> None:
    """The boundary, a file of cells, and a group of the mesh."""
    whole, part = tmp_path / "fan.obj", tmp_path / "part.json"
    whole.write_text("v 0 0 0\nv 2 0 1\nv 2 2 2\nv 0 2 3\nv 1 1 4\ng lid\nf 1 2 5\nf 2 3 5\ng rim\nf 3 4 5\nf 4 1 5\n")
    part.write_text("[[0,1,4],[1,2,4]]")
    for word, files in (("boundary", [whole]), (part, [whole, part]), ("lid", [whole])):
        for proof in (coface.certificate(whole, "persistence", relative=word), coface.certificate(whole, "persistence", image_of=word)):
            verdict = coface.check(proof, *files)
            assert verdict["unchecked"] == [] and any("a part" in line for line in verdict["proved"])
    with pytest.raises(coface.Error, match="give one of both"):
        coface.certificate(whole, "persistence", relative="lid", image_of="rim")
    with pytest.raises(coface.Error, match="of a whole complex"):
        coface.certificate(whole, "persistence", relative="lid", extended=True)
