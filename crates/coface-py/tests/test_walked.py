"""What people met who tried the package: each test is one of their programs."""

from __future__ import annotations

import copy
import json
import pickle
import warnings
from pathlib import Path

import numpy as np
import pytest
from conftest import NO_DATA, manifest

import coface

FOUND = manifest()
SQUARE = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]


def test_sets_take_over_the_kinks_of_their_curves(tmp_path: Path) -> None:
    curve = coface.Curve.closed(SQUARE, kinks=[0, 1, 2, 3], order=4)
    assert curve.kinks.tolist() == [0, 1, 2, 3]
    region = coface.YinSet([curve])
    assert region.kinks.knots.tolist() == [[0, 0], [0, 1], [0, 2], [0, 3]]
    region.write(tmp_path / "square.json")
    again = coface.YinSet.read(tmp_path / "square.json")
    assert again == region and len(again.kinks) == 4
    assert pickle.loads(pickle.dumps(region)) == region
    moved, _ = region.advected("rotation", 0.5, step=0.05, spacing=0.25)
    assert abs(moved.area - 4.0) < 1e-5 and len(moved.kinks) == 4
    # Curves of sets have theirs, and so do those that are turned or moved.
    for made in (region.curves[0], curve.reversed(), curve.translated([1, 0]), curve.rotated(30.0), pickle.loads(pickle.dumps(curve))):
        assert made.kinks.tolist() == [0, 1, 2, 3]
    one = coface.Curve.closed([*SQUARE, [-1.0, 1.0]], kinks=[1], order=4)
    assert one.reversed().kinks.tolist() == [4]
    turned = coface.YinSet([one.reversed()], orient=True)
    assert turned.kinks.points.tolist() == [[2.0, 0.0]]


def test_corners_of_splines_are_kinks_with_a_warning() -> None:
    lines = [np.linspace(SQUARE[i], SQUARE[(i + 1) % 4], 4)[:3] for i in range(4)]
    bare = coface.Curve.closed(SQUARE, kinks=[0, 1, 2, 3], order=4)
    text = {"order": 4, "curves": [{"points": SQUARE, "controls": np.concatenate(lines).tolist()}]}
    model = json.dumps(text).encode()
    assert coface.Model.from_bytes(model, "json") is not None
    with pytest.warns(coface.AssumptionWarning, match="4 knots where the boundary has a corner"):
        found = coface.YinSet([coface._coface._curve(4, bare.controls, bare.knots)])
    assert len(found.kinks) == 4


def test_volumes_go_to_other_libraries_as_what_they_are() -> None:
    trimesh = pytest.importorskip("trimesh")
    block = coface.volume(np.ones((2, 3, 4), bool))
    mesh = coface.to_trimesh(block)
    assert mesh.is_watertight and mesh.volume == pytest.approx(24.0)
    assert isinstance(mesh, trimesh.Trimesh)
    square = coface.to_trimesh(([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]]))
    assert len(square.faces) == 2
    meshio = pytest.importorskip("meshio")
    assert isinstance(coface.to_meshio(block), meshio.Mesh)
    assert [(part.type, len(part.data)) for part in coface.to_meshio(block).cells] == [("hexahedron", 24)]


def test_volumes_are_solids() -> None:
    block = coface.volume(np.ones((2, 2, 2), bool))
    assert coface.boolean("union", block, block).measure == 8.0
    assert coface.arrange(block).measures == [8.0]


@pytest.mark.parametrize("name", ["ESRI:54009", "OGC:CRS84", "EPSG:25832"])
def test_reference_systems_are_kept(name: str) -> None:
    geopandas, shapely = pytest.importorskip("geopandas"), pytest.importorskip("shapely")
    frame = geopandas.GeoDataFrame({"n": [1], "geometry": [shapely.box(0, 0, 2, 2)]}, crs=name)
    model = coface.as_model(frame)
    assert coface.to_geopandas(model).crs == frame.crs
    assert pickle.loads(pickle.dumps(model)).crs == model.crs
    assert coface.to_geopandas(coface.boolean("union", frame).model()).crs == frame.crs
    other = geopandas.GeoDataFrame({"geometry": [shapely.box(1, 1, 3, 3)]}, crs="ESRI:54030")
    with pytest.raises(coface.InvalidInputError, match="54030"):
        coface.boolean("union", frame, other)


def test_reference_systems_without_names_are_kept_as_wkt() -> None:
    geopandas, shapely, pyproj = (pytest.importorskip(name) for name in ("geopandas", "shapely", "pyproj"))
    own = pyproj.CRS.from_proj4("+proj=tmerc +lat_0=1 +lon_0=7 +ellps=bessel")
    frame = geopandas.GeoSeries([shapely.box(0, 0, 2, 2)], crs=own)
    assert coface.to_geopandas(coface.as_model(frame)).crs == own


@pytest.mark.skipif(FOUND is None, reason=NO_DATA)
def test_models_of_all_files_come_back_from_pickles() -> None:
    assert FOUND is not None
    lost = []
    for record in FOUND[1]["files"]:
        path = FOUND[0] / record["file"]
        if not path.is_file() or path.stat().st_size > 3_000_000:
            continue
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                model = coface.read(path)
            except coface.Error:
                continue
        again = pickle.loads(pickle.dumps(model))
        if again != model or again.warnings != model.warnings or copy.deepcopy(model) != model:
            lost.append(record["file"])
    assert lost == []


def test_groups_stay_what_they_are() -> None:
    text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no wall\nusemtl brick\nf 1 2 3 4\n"
    model = coface.Model.from_bytes(text, "obj")
    for same in (pickle.loads(pickle.dumps(model)), copy.deepcopy(model), coface.Model.from_dict(json.loads(json.dumps(model.to_dict())))):
        assert same == model
    for made in (model.triangulated(), model.repaired().model, model.repaired_surface().model):
        written = made.to_bytes("obj").decode()
        assert "o wall" in written and "usemtl brick" in written


def test_features_keep_their_ids() -> None:
    line = {"type": "LineString", "coordinates": [[0, 0], [1, 0]]}
    text = {"type": "FeatureCollection", "features": [{"type": "Feature", "id": "n7", "properties": {"a": 1}, "geometry": line}]}
    model = coface.as_model(text)
    again = pickle.loads(pickle.dumps(model))
    assert again == model and again.__geo_interface__["features"][0]["id"] == "n7"
    assert model.triangulated().__geo_interface__ == model.__geo_interface__


def test_remarks_are_warnings() -> None:
    square = coface.Model.from_bytes(b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "wkt")
    line = coface.Model.from_bytes(b"LINESTRING (0 0, 5 5)", "wkt")
    with pytest.warns(coface.AssumptionWarning):
        found = coface.boolean("union", square, line)
    assert "unbounded-segments" in [remark["code"] for remark in found.remarks]
    bow = coface.Model.from_bytes(b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", "wkt")
    with pytest.warns(coface.AssumptionWarning):
        coface.maps.repair(bow)


def test_incidence_is_that_of_the_program() -> None:
    two = coface.Complex([[0, 1, 2], [1, 2, 3]])
    assert (coface.incidence(two, "FE") != coface.incidence(two, "FE", "incident")).nnz == 0
    assert (coface.incidence(two, "FF") != coface.incidence(two, "FF", "counts")).nnz == 0
    with pytest.raises(coface.InvalidInputError, match="radius=1"):
        coface.cover(coface.generate("torus"))


def test_large_entries_have_a_cure_that_keeps_the_homology() -> None:
    with pytest.raises(coface.InvalidInputError, match="2\\^20 b = 0"):
        coface.ChainComplex.from_boundaries([[[2**40]]])
    # What the cure says.
    chains = coface.ChainComplex.from_boundaries([[[2**20, 0], [-1, 2**20]]])
    assert str(coface.homology(chains)[0]) == f"Z/{2**40}"
    with pytest.raises(coface.ShapeError, match="coface.ChainComplex.of_points"):
        coface.ChainComplex.from_boundaries([])


def test_geometries_come_in_any_container() -> None:
    shapely = pytest.importorskip("shapely")
    geopandas, pandas = pytest.importorskip("geopandas"), pytest.importorskip("pandas")
    boxes = [shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3, 1)]
    column = geopandas.GeoSeries(boxes)
    for given in (boxes, tuple(boxes), set(boxes), np.array(boxes), column, column.values, pandas.Series(boxes), iter(boxes)):
        assert coface.as_model(given).vertex_count == 8
    for given in (column, geopandas.GeoDataFrame(geometry=boxes), boxes):
        assert coface.from_shapely(given).vertex_count == 8
    assert coface.as_model(geopandas.GeoSeries([])).vertex_count == 0
    assert coface.as_model(geopandas.GeoDataFrame({"geometry": []})).vertex_count == 0
    days = geopandas.GeoDataFrame({"day": pandas.to_datetime(["2020-01-01", None]), "geometry": boxes})
    assert [feature["properties"]["day"] for feature in coface.as_model(days).__geo_interface__["features"]] == ["2020-01-01T00:00:00", None]
    assert coface.as_model(boxes[0].__geo_interface__).vertex_count == 4


def test_segments_are_arrays() -> None:
    cross = np.array([[[0, 0], [2, 2]], [[0, 2], [2, 0]]], float)
    assert coface.arrange(cross).f_vector == [5, 4, 0]
    assert coface.arrange([cross, cross[:1]]).f_vector == [5, 4, 0]


def test_data_by_name_are_values() -> None:
    torus = coface.generate("torus")
    named = torus.with_data("w", np.arange(torus.vertex_count), "vertices")
    assert coface.persistence(named, "w") == coface.persistence(torus, np.arange(torus.vertex_count))
    with pytest.raises(coface.InvalidInputError, match="'w'"):
        coface.persistence(named, "v")


def test_operations_have_the_names_that_others_give_them() -> None:
    a, b = (coface.polygon([[x, 0], [x + 2, 0], [x + 2, 2], [x, 2]]) for x in (0, 1))
    for name, area in [("Union", 6.0), ("or", 6.0), ("AND", 2.0), ("symmetric_difference", 4.0), ("minus", 2.0)]:
        assert coface.boolean(name, a, b).measure == area
    with pytest.raises(coface.InvalidInputError, match='"intersection"'):
        coface.boolean("onion", a, b)


def test_what_is_of_something_else_is_refused() -> None:
    pytest.importorskip("matplotlib")
    csaszar = coface.generate("csaszar")
    torus = coface.generate("torus")
    with pytest.raises(coface.InvalidInputError, match="another model"):
        coface.plot(csaszar, generators=coface.homology(torus, generators=True)[1])
    with pytest.raises(coface.InvalidInputError, match="array of shape \\(3, 2\\)"):
        coface.witness(np.zeros((9, 2)), np.zeros((3, 2)))
    pytest.importorskip("sklearn")
    from coface.interop.sklearn import PointDiagrams

    with pytest.raises(coface.InvalidInputError, match="row of numbers"):
        PointDiagrams().fit_transform(np.random.default_rng(0).random((5, 3)))


def test_answers_that_are_facts_go_everywhere(tmp_path: Path) -> None:
    torus = coface.generate("torus")
    answers = [
        coface.long_exact_sequence(coface.generate("moebius"), "boundary"),
        coface.cup_products(torus, 1, 1),
        coface.intersection_form(torus),
        coface.classify(torus),
        coface.zigzag([[0], [1], [0, 1]], [[0], [1, 8], [2, 5]]),
        coface.vineyard([[0, 1], [1, 2]], [[0.0, 4.0, 2.0], [0.0, 4.0, 6.0]]),
        coface.extended_persistence([[0, 1], [1, 2]], [0.0, 2.0, 1.0]),
    ]
    for answer in answers:
        assert "<table" in answer._repr_html_()
        assert coface.view(answer, tmp_path / "answer.html").stat().st_size > 100
        assert type(answer).from_dict(json.loads(json.dumps(answer.to_dict()))) == answer
        assert pickle.loads(pickle.dumps(answer)) == answer
        with pytest.warns(coface.AssumptionWarning, match="no cells to draw"):
            coface.view([torus, answer], tmp_path / "both.html")
    repaired = torus.repaired()
    assert repaired == torus.repaired() and "<" in repaired._repr_html_()
    coface.view([torus, repaired], tmp_path / "repaired.html")


def test_cells_of_pyvista_that_are_not_linear_are_read() -> None:
    cells = pytest.importorskip("pyvista").examples.cells
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert len(coface.as_model(cells.QuadraticTriangle()).faces) == 1
        assert len(coface.as_model(cells.TriangleStrip()).faces) > 1
        assert coface.as_model(cells.PolyVertex()).vertex_count > 1


def test_nodes_of_graphs_have_their_names() -> None:
    networkx = pytest.importorskip("networkx")
    graph = networkx.Graph(["ab", "bc", "ca", "cd"])
    loop = coface.homology(graph, generators=True)[1].generators[0].loop
    assert set(coface.interop.networkx.named(graph, loop)) == {"a", "b", "c"}
