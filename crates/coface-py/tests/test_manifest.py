"""Real files, and what others found out about them: each record says by which tools."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import NO_DATA, manifest

import coface

FOUND = manifest()
pytestmark = pytest.mark.skipif(FOUND is None, reason=NO_DATA)
FOLDER: Path = FOUND[0] if FOUND else Path()
RECORDS: list[dict[str, Any]] = FOUND[1]["files"] if FOUND else []
#: Records whose numbers are not what they seem.
FOUR_COORDINATES = "surfaces/tetraplex.off"


def records(*folders: str):
    chosen = [record for record in RECORDS if record["file"].partition("/")[0] in folders]
    return pytest.mark.parametrize("record", chosen, ids=[record["file"] for record in chosen])


def listed(name: str):
    entries = json.loads((FOLDER / "complexes" / name).read_text(encoding="utf-8")) if FOUND else []
    return pytest.mark.parametrize("entry", entries, ids=[entry["name"] for entry in entries])


def test_every_file_has_a_test() -> None:
    assert FOUND is not None
    assert len(RECORDS) == FOUND[1]["count"]
    known = {"surfaces", "volumes", "planar", "complexes", "tricky"}
    assert {record["file"].partition("/")[0] for record in RECORDS} <= known


def check_homology(record: dict[str, Any], complex: coface.ChainComplex, groups: Any) -> None:
    assert [group.betti for group in groups] == record["betti"]
    for prime, key in [(2, "betti_F2"), (3, "betti_F3")]:
        assert list(coface.homology(complex, f"f{prime}").betti_numbers) == record[key], key
    if record["torsion"].startswith("none"):
        assert all(group.torsion == () for group in groups)
    for degree in range(1, complex.dimension):
        product = complex.boundary(degree).astype(np.int64) @ complex.boundary(degree + 1).astype(np.int64)
        assert abs(product).sum() == 0


@records("surfaces")
def test_surfaces_are_what_the_records_say(record) -> None:
    model = coface.read(FOLDER / record["file"])
    report = model.report()
    assert report.kind == "surface"
    assert report.f_vector == (record["vertices"], record["edges"], record["faces"])
    assert report.components == record["components"]
    assert report.euler_characteristic == record["euler"]
    assert report.orientable == record.get("orientable")
    assert report.coherently_oriented == record.get("coherently_oriented")
    assert report.manifold == ("yes" if record["manifold"] else "no")
    assert (report.witness is None) == record["manifold"]
    assert len(report.boundary_loops or ()) == record["boundary_loops"] or not record["manifold"]
    if record["file"] != FOUR_COORDINATES and record.get("area") is not None:
        assert report.area == pytest.approx(record["area"], rel=1e-7)
    if record.get("signed_volume") is not None:
        assert report.signed_volume == pytest.approx(record["signed_volume"], rel=1e-7)
    check_homology(record, coface.as_chain_complex(model), report.homology)


@records("volumes")
def test_volumes_are_what_the_records_say(record) -> None:
    model = coface.read(FOLDER / record["file"])
    report = model.report()
    assert report.kind == "volume"
    assert report.f_vector == (record["vertices"], record["edges"], record["faces"], record["cells"])
    assert report.components == record["components"]
    assert report.euler_characteristic == record["euler"]
    check_homology(record, coface.as_chain_complex(model), report.homology)


@records("planar")
def test_regions_are_what_the_records_say(record) -> None:
    path = FOLDER / record["file"]
    if path.name == "earcut-dude.json":
        rings = [np.array(ring, float) for ring in json.loads(path.read_text(encoding="utf-8"))]
        shapely = pytest.importorskip("shapely")
        region = coface.boolean("union", shapely.Polygon(rings[0], rings[1:]))
        assert region.measure == pytest.approx(record["area_shoelace"], rel=1e-12)
        return
    if record.get("invalid_features"):
        # Rings that cross themselves are read by structure, as GEOS does when it is asked for that.
        shapely = pytest.importorskip("shapely")
        collection = json.loads(path.read_text(encoding="utf-8"))
        shapes = [shapely.geometry.shape(feature["geometry"]) for feature in collection["features"]]
        valid = [shapely.make_valid(one, method="structure", keep_collapsed=False) for one in shapes]
        assert coface.boolean("union", path).measure == pytest.approx(shapely.union_all(valid).area, rel=1e-9)
        return
    expected = record["union"]["area"] if "union" in record else record["area_sum"]
    assert coface.boolean("union", path).measure == pytest.approx(expected, rel=1e-9)


@listed("facet_lists.json")
def test_facet_lists_have_their_homology(entry) -> None:
    complex = coface.Complex(entry["facets"])
    assert list(complex.f_vector) == entry["f_vector"]
    groups = coface.homology(complex)
    if entry["integral_homology"] is not None:
        assert [(group.betti, list(group.torsion)) for group in groups] == [
            (group["rank"], group["torsion"]) for group in entry["integral_homology"]
        ]
    for prime, betti in entry["betti_by_prime"].items():
        assert list(coface.homology(complex, f"f{prime}").betti_numbers) == betti
    assert bool(complex.is_pure()) == entry["pure"]
    assert coface.as_model(f"{FOLDER / 'complexes/facet_lists.json'}#{entry['name']}").f_vector == complex.f_vector


@listed("three_manifolds.json")
def test_three_manifolds_have_their_homology(entry) -> None:
    model = coface.as_model({"gluings": entry["gluings"]})
    assert list(model.f_vector) == entry["f_vector"]
    first = coface.homology(model)[1]
    assert (first.betti, list(first.torsion)) == (entry["H1"]["rank"], entry["H1"]["torsion"])
    assert coface.homology(model, "f2").betti_numbers[2] == entry["betti2_F2"]
    assert coface.homology(model)[3].betti == int(entry["orientable"])


#: Wrong files, with the class of the fault.
FAULTS = {
    "tricky/invalidvertex.stl": coface.ParseError,
    "tricky/unparseable.stl": coface.ParseError,
}


@records("tricky")
def test_tricky_files(record) -> None:
    path = FOLDER / record["file"]
    fault = FAULTS.get(record["file"])
    if fault is not None:
        with pytest.raises(fault) as caught:
            coface.read(path)
        assert caught.value.file == str(path)
        assert caught.value.line is not None
        return
    model = coface.read(path)
    if path.name == "notenoughindices.obj":
        assert model.f_vector == (3, 3, 1)
        assert "line 9" in model.warnings[0]
    elif "vertices" in record:
        assert model.f_vector == (record["vertices"], record["edges"], record["faces"])
        assert model.report().euler_characteristic == record["euler"]
    else:
        assert model.vertex_count == 0
