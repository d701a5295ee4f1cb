"""Objects of other libraries go in and come out with the same vertices and cells."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import pytest

import coface

SQUARE = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
SURFACE = coface.Model.from_arrays(SQUARE, [[0, 1, 2], [0, 2, 3]])
TETRAHEDRON = coface.Model.from_arrays(np.eye(4)[:, :3], cells={"tetra": [[3, 0, 1, 2]]})
MIXED = coface.Model.from_arrays(
    np.concatenate([SQUARE, SQUARE + [0.0, 0.0, 1.0], [[0.5, 0.5, 2.0]]]),
    cells={"hexahedron": [list(range(8))], "pyramid": [[4, 5, 6, 7, 8]]},
)
POLYGONS = coface.Model.from_arrays(np.concatenate([SQUARE, [[0.5, 2.0, 0.0]]]), [[0, 1, 2, 3], [3, 2, 4]])
LINES = coface.Model.from_arrays(SQUARE, cells={"line": [[0, 1], [1, 2], [2, 3]]})


def same(first: coface.Model, second: coface.Model) -> None:
    assert np.array_equal(first.vertices, second.vertices)
    assert [face.tolist() for face in rows(first.faces)] == [face.tolist() for face in rows(second.faces)]
    assert set(first.cells) == set(second.cells)
    for kind in first.cells:
        assert np.array_equal(first.cells[kind], second.cells[kind])
    assert coface.homology(first) == coface.homology(second)


def rows(lists):
    if isinstance(lists, tuple):
        return np.split(np.asarray(lists[0]), lists[1][1:-1])
    return np.asarray(lists)


def test_nothing_is_imported_before_it_is_needed() -> None:
    words = "import sys, coface; print([n for n in %r if n in sys.modules])" % (
        ["trimesh", "meshio", "pymeshlab", "pyvista", "vtk", "geopandas", "sklearn", "open3d", "networkx", "gudhi", "shapely", "matplotlib", "tqdm"],
    )
    done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_library_that_is_not_there_is_named() -> None:
    words = "import sys; sys.modules['trimesh'] = None\nimport coface\ncoface.to_trimesh(coface.generate('csaszar'))"
    done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "to_trimesh needs trimesh" in done.stderr
    assert "pip install trimesh" in done.stderr


def test_trimesh_goes_both_ways() -> None:
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.creation.icosphere(subdivisions=2)
    model = coface.as_model(mesh)
    assert np.array_equal(model.vertices, mesh.vertices)
    assert np.array_equal(model.faces, mesh.faces)
    again = coface.to_trimesh(model)
    assert np.array_equal(again.faces, mesh.faces) and np.array_equal(again.vertices, mesh.vertices)
    scene = trimesh.Scene([mesh, trimesh.creation.box(transform=trimesh.transformations.translation_matrix([9, 0, 0]))])
    assert coface.homology(scene).betti_numbers == (2, 0, 2)
    assert coface.as_model(trimesh.PointCloud(SQUARE)).vertex_count == 4
    path = coface.to_trimesh(LINES)
    assert coface.homology(path).betti_numbers[0] == 1
    # Arrays go over without being copied on the way out: the class of trimesh may keep its own.
    cut = coface.to_trimesh(POLYGONS)
    assert len(cut.faces) == len(POLYGONS.triangulated().faces) and len(cut.vertices) == POLYGONS.vertex_count


@pytest.mark.parametrize("model", [SURFACE, POLYGONS, TETRAHEDRON, MIXED, LINES])
def test_meshio_goes_both_ways(model) -> None:
    meshio = pytest.importorskip("meshio")
    mesh = coface.to_meshio(model)
    assert isinstance(mesh, meshio.Mesh)
    same(coface.as_model(mesh), model)


def test_cells_of_second_order_are_refused() -> None:
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(np.zeros((6, 3)), [("triangle6", [[0, 1, 2, 3, 4, 5]])])
    with pytest.raises(coface.InvalidInputError, match="triangle6"):
        coface.as_model(mesh)


@pytest.mark.parametrize("model", [SURFACE, POLYGONS, TETRAHEDRON, MIXED, LINES])
def test_pyvista_goes_both_ways(model) -> None:
    pytest.importorskip("pyvista")
    same(coface.as_model(coface.to_pyvista(model)), model)


def test_grids_of_pyvista_are_taken() -> None:
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.ImageData(dimensions=(3, 3, 3))
    assert coface.homology(grid).betti_numbers[:2] == (1, 0)
    assert coface.as_model(pyvista.Sphere()).report().name == "sphere"


@pytest.mark.parametrize("model", [SURFACE, TETRAHEDRON, LINES])
def test_open3d_goes_both_ways(model) -> None:
    pytest.importorskip("open3d")
    same(coface.as_model(coface.to_open3d(model)), model)


def test_graphs_go_both_ways() -> None:
    networkx = pytest.importorskip("networkx")
    graph = networkx.petersen_graph()
    found = coface.homology(graph)
    assert found.betti_numbers == (1, 15 - 10 + 1)
    assert networkx.is_isomorphic(coface.to_networkx(graph), graph)
    torus = coface.to_networkx(coface.generate("csaszar"))
    assert networkx.is_isomorphic(torus, networkx.complete_graph(7))
    assert len(torus.nodes[0]["pos"]) == 3
    # Isolated nodes are vertices.
    lonely = networkx.empty_graph(3)
    lonely.add_edge(0, 1)
    assert coface.homology(lonely).betti_numbers[0] == 2
    names = networkx.Graph([("a", "b"), ("b", "c"), ("c", "a")])
    assert coface.homology(names).betti_numbers == (1, 1)


def test_multigraphs_are_chain_complexes() -> None:
    networkx = pytest.importorskip("networkx")
    graph = networkx.MultiGraph([(0, 1), (0, 1), (1, 1)])
    assert coface.homology(graph).betti_numbers == (1, 2)
    with pytest.raises(coface.InvalidInputError) as caught:
        coface.as_model(graph)
    assert caught.value.cells


def test_simplex_trees_go_both_ways(torus) -> None:
    gudhi = pytest.importorskip("gudhi")
    tree = coface.to_gudhi(torus)
    assert isinstance(tree, gudhi.SimplexTree)
    assert tree.num_simplices() == 7 + 21 + 14
    assert coface.from_gudhi(tree) == coface.as_complex(torus)
    rising = coface.to_gudhi(torus, values=np.arange(7.0))
    assert rising.filtration([0, 1, 3]) == 3.0


def test_geometries_go_both_ways() -> None:
    shapely = pytest.importorskip("shapely")
    random = np.random.default_rng(5)
    ring = shapely.Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (1, 2), (2, 2), (2, 1)]])
    back = coface.to_shapely(coface.as_model(ring))
    assert back.equals(ring)
    for scale in [1e-12, 1.0, 1e12]:
        points = random.normal(size=(50, 2)) * scale
        line = shapely.LineString(points)
        model = coface.from_shapely(line)
        found = shapely.get_coordinates(coface.to_shapely(model))
        assert np.array_equal(found, points), scale
    several = [ring, shapely.Point(9, 9), shapely.LineString([(5, 5), (6, 6)])]
    assert coface.as_model(several).vertex_count == 8 + 1 + 2
    assert len(coface.to_shapely(coface.as_model(several)).geoms) == 3


def test_paths_files_and_words_are_models(spot) -> None:
    expected = coface.read(spot)
    assert coface.as_model(spot) == expected
    assert coface.as_model(str(spot)) == expected
    with open(spot, "rb") as file:
        assert coface.as_model(file) == expected
    with open(spot, encoding="utf-8") as file:
        assert coface.as_model(file) == expected
    assert coface.as_model((expected.vertices, expected.faces)).report().name == "sphere"
    assert coface.as_model({"facets": np.array([[0, 1, 2]])}).f_vector == (3, 3, 1)
    assert coface.as_model(np.array([[0, 1], [1, 2]])).f_vector == (3, 2)
    assert coface.as_model(np.zeros((3, 3))).vertex_count == 3
    assert coface.as_model(((0, 1, 2), (1, 2, 3))).f_vector == (4, 5, 2)


def test_maps_keep_the_number_of_their_reference_system():
    model = coface.Model.from_bytes(b"SRID=25832;POLYGON Z ((0 0 1, 4 0 1, 4 4 3, 0 0 1))", "wkt")
    assert model.srid == 25832
    again = coface.Model.from_bytes(model.to_bytes("wkb"))
    assert (again.srid, again.vertices.tolist()) == (25832, model.vertices.tolist())
    united = coface.boolean("union", model)
    assert united.to_bytes("wkt") == b"SRID=25832;POLYGON Z ((0 0 1, 4 0 1, 4 4 3, 0 0 1))\n"
    assert coface.boolean("union", model, dimension=2).to_bytes("wkt") == b"SRID=25832;POLYGON ((0 0, 4 0, 4 4, 0 0))\n"
    assert coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]).srid is None


def test_geometries_of_shapely_in_one_list_are_in_one_reference_system():
    shapely = pytest.importorskip("shapely")
    points = [shapely.set_srid(shapely.Point(place, 1), srid) for place, srid in [(1, 25832), (2, 0), (3, 25832), (4, 4326)]]
    assert coface.as_model(points[:3]).srid == 25832
    with pytest.raises(ValueError, match="SRID 25832 and in SRID 4326.*transform"):
        coface.as_model(points)


def test_closed_lines_are_rings_where_asked():
    line = coface.Model.from_bytes(b"LINESTRING (0 0, 2 0, 2 2, 0 0)", "wkt")
    assert coface.arrange(line).inside == [[]]
    assert coface.boolean("union", line, close=True).measure == 2.0


def _lot(x, width=1, **properties):
    ring = [[x, 0], [x + width, 0], [x + width, 1], [x, 1], [x, 0]]
    return {"type": "Feature", "properties": properties, "geometry": {"type": "Polygon", "coordinates": [ring]}}


def _map(*features):
    return coface.Model.from_bytes(json.dumps({"type": "FeatureCollection", "features": features}).encode(), "geojson")


def test_features_are_dissolved_by_a_property():
    lots = _map(_lot(0, owner="A", use="wood"), _lot(1, owner="A", use="wood"), _lot(2, owner="B"), _lot(5))
    found = coface.dissolve(lots, by="owner")
    rows = [feature["properties"] for feature in found.__geo_interface__["features"]]
    assert rows == [
        {"owner": "A", "features": 2, "area": 2, "use": "wood"},
        {"owner": "B", "features": 1, "area": 1},
        {"owner": None, "features": 1, "area": 1},
    ]
    assert any("no value" in warning for warning in found.warnings)
    assert len(coface.dissolve([lots, _map(_lot(9, owner="A"))], by=["owner"], dimension=2).__geo_interface__["features"]) == 3
    with pytest.raises(coface.InvalidInputError, match="dimension is 3"):
        coface.dissolve(lots, by="owner", dimension=3)
    with pytest.raises(coface.InvalidInputError, match="lot"):
        coface.dissolve(lots, by="lot")
    shapely = pytest.importorskip("shapely")
    shapes = [shapely.geometry.shape(feature["geometry"]) for feature in found.__geo_interface__["features"]]
    assert [shape.area for shape in shapes] == [2, 1, 1] and all(shape.is_valid for shape in shapes)


def test_faces_have_the_attributes_of_all_inputs():
    arranged = coface.arrange(_map(_lot(0, 3, use="soil")), _map(_lot(1, use="road", lanes=2)))
    table = arranged.attributes()
    rows = sorted((feature["properties"] for feature in table.__geo_interface__["features"]), key=str)
    alone = {"use_1": "soil", "use_2": None, "lanes": None}
    assert rows == sorted([alone, alone, {"use_1": "soil", "use_2": "road", "lanes": 2}], key=str)
    geopandas = pytest.importorskip("geopandas")
    frame = geopandas.GeoDataFrame.from_features(table)
    assert sorted(frame.area) == [1, 1, 1] and set(frame.columns) == {"geometry", "use_1", "use_2", "lanes"}


@pytest.mark.parametrize("model", [SURFACE, POLYGONS, LINES, TETRAHEDRON, MIXED])
def test_unstructured_grids_go_both_ways(model) -> None:
    pyvista = pytest.importorskip("pyvista")
    grid = coface.to_pyvista(model, grid=True)
    assert isinstance(grid, pyvista.UnstructuredGrid)
    same(coface.as_model(grid), model)


def test_grids_of_pyvista_keep_faces_beside_cells() -> None:
    pytest.importorskip("pyvista")
    both = coface.Model.from_arrays(
        np.concatenate([np.eye(4)[:, :3], [[2.0, 2.0, 2.0]]]),
        cells={"tetra": [[3, 0, 1, 2]], "triangle": [[0, 1, 4]], "line": [[2, 4]]},
    )
    grid = coface.to_pyvista(both)
    assert grid.celltypes.tolist() == [3, 5, 10]
    same(coface.as_model(grid), both)


def test_pymeshlab_goes_both_ways() -> None:
    pymeshlab = pytest.importorskip("pymeshlab")
    same(coface.as_model(coface.to_pymeshlab(SURFACE)), SURFACE)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(coface.to_pymeshlab(coface.generate("csaszar")))
    assert coface.from_pymeshlab(meshes).report().name == "torus"
    with pytest.raises(coface.InvalidInputError, match="needs triangles, and face 0 has 4 corners"):
        coface.to_pymeshlab(POLYGONS)
    with pytest.raises(coface.InvalidInputError, match="3-cells"):
        coface.to_pymeshlab(TETRAHEDRON)


class Meshlab:
    """What a mesh of PyMeshLab offers, where that is not installed."""

    __module__ = "pymeshlab.pmeshlab"

    def vertex_matrix(self):
        return SQUARE

    def face_matrix(self):
        return np.array([[0, 1, 2], [0, 2, 3]], np.int32)

    def edge_matrix(self):
        return np.zeros((0, 2), np.int32)

    def face_number(self):
        return 2

    def edge_number(self):
        return 0


def test_meshes_of_pymeshlab_are_taken() -> None:
    same(coface.as_model(Meshlab()), SURFACE)


def test_tables_of_geopandas_go_both_ways() -> None:
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    ring = shapely.Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (2, 1), (2, 2)]])
    frame = geopandas.GeoDataFrame({"name": ["a", "b"], "count": [1, 2]}, geometry=[ring, shapely.box(5, 0, 6, 1)], crs="EPSG:3857")
    again = coface.to_geopandas(frame)
    assert again.crs == frame.crs
    assert again["name"].tolist() == ["a", "b"]
    assert again["count"].tolist() == [1, 2]
    assert again.geometry.geom_equals(frame.geometry).all()


def test_labelled_arrays_of_xarray_are_taken() -> None:
    xarray = pytest.importorskip("xarray")
    ring = np.ones((3, 3), bool)
    ring[1, 1] = False
    assert str(coface.homology(xarray.DataArray(ring, dims=("y", "x")))) == "Homology(Z, Z)"
    heights = xarray.DataArray(np.where(ring, 2.0, 0.0), dims=("y", "x"))
    assert coface.volume(heights, threshold=1.0) == coface.volume(ring)
    assert coface.volume(xarray.Dataset({"height": heights}), threshold=1.0) == coface.volume(ring)
    with pytest.raises(coface.InvalidInputError, match="'a', 'b'"):
        coface.volume(xarray.Dataset({"a": heights, "b": heights}))


WITH_DATA = POLYGONS.with_data("heat", [1.5, 2.0, 3.0, 4.0, 5.0]).with_data("part", [7, 8], "faces").with_data("flow", np.arange(15.0).reshape(5, 3))


def data_of(model: coface.Model) -> dict[tuple[str, str], list]:
    return {(name, on): np.asarray(values).tolist() for name, on, values in model.data}


def test_what_is_no_data_is_named() -> None:
    meshio = pytest.importorskip("meshio")
    given = {
        "height": [0.0, np.nan, np.inf],
        "stress": np.arange(12.0).reshape(3, 2, 2),
        "name": ["a", "b", "c"],
        "huge": np.array([1, 2, 2**63], np.uint64),
    }
    mesh = meshio.Mesh(np.eye(3), [("triangle", [[0, 1, 2]])], point_data=given)
    with pytest.warns(coface.AssumptionWarning, match="left out of the data of the vertices: 'name', 'huge'"):
        data = {name: values for name, _, values in coface.as_model(mesh).data}
    np.testing.assert_array_equal(data["height"], given["height"])
    np.testing.assert_array_equal(data["stress"], given["stress"].reshape(3, 4))
    assert set(data) == {"height", "stress"}


def test_meshio_and_pyvista_take_data_with_them() -> None:
    meshio = pytest.importorskip("meshio")
    again = coface.as_model(coface.to_meshio(WITH_DATA))
    assert data_of(again) == data_of(WITH_DATA) and len(again.data) == 3
    mixed = meshio.Mesh(SQUARE, [("line", [[0, 1]]), ("triangle", [[0, 1, 2]])], point_data={"a": np.arange(4), "text": np.array(list("abcd"))}, cell_data={"b": [[1], [2]]})
    with pytest.warns(coface.AssumptionWarning) as told:
        assert data_of(coface.as_model(mixed)) == {("a", "vertices"): [0, 1, 2, 3]}
    assert [str(one.message).split(",")[0] for one in told] == ["left out of the data of the vertices: 'text'", "left out of the data of the cells: 'b'"]
    pyvista = pytest.importorskip("pyvista")
    for grid in (False, True):
        made = coface.to_pyvista(WITH_DATA, grid=grid)
        assert made.cell_data["part"].tolist() == [7, 8]
        assert data_of(coface.as_model(made)) == data_of(WITH_DATA)
    blocks = pyvista.MultiBlock([pyvista.Sphere(), pyvista.Cube().translate((5, 0, 0))])
    assert coface.homology(blocks).betti_numbers == (2, 0, 2)


def test_overlays_are_tables_with_the_attributes_of_all_layers() -> None:
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    land = geopandas.GeoDataFrame({"name": ["wood", "field"], "n": [1, 2]}, geometry=[shapely.box(0, 0, 4, 6), shapely.box(4, 0, 10, 6)], crs="EPSG:25832")
    zones = geopandas.GeoDataFrame({"zone": ["wet"]}, geometry=[shapely.box(2, 2, 8, 4)], crs="EPSG:25832")
    rain = geopandas.GeoDataFrame({"mm": [3.5, 4.5]}, geometry=[shapely.box(0, 0, 10, 3), shapely.box(0, 3, 10, 6)], crs="EPSG:25832")
    frame = coface.to_geopandas(coface.arrange(land, zones, rain))
    assert frame.crs == land.crs and len(frame) == 8
    frame["zone"] = frame["zone"].fillna("")
    found = {(row["name"], row["zone"], row["mm"]): area for (_, row), area in zip(frame.iterrows(), frame.area)}
    expected = land.overlay(zones, how="union").overlay(rain, how="union")
    for (_, row), area in zip(expected.iterrows(), expected.area):
        zone = row["zone"] if isinstance(row["zone"], str) else ""
        assert found[(row["name"], zone, row["mm"])] == pytest.approx(area)
    # One layer goes through whole.
    again = coface.to_geopandas(coface.as_model(land))
    assert again["name"].tolist() == ["wood", "field"] and again["n"].tolist() == [1, 2]
    assert all(a.equals(b) for a, b in zip(again.geometry, land.geometry)) and again.crs == land.crs


def test_cells_of_topologicpy_look_outward() -> None:
    cells = pytest.importorskip("topologicpy.Cell").Cell
    for cell, volume in ((cells.Prism(), 1.0), (cells.Dodecahedron(), None), (cells.Torus(), None)):
        report = coface.as_model(cell).report()
        assert report.coherently_oriented and report.signed_volume > 0
        assert volume is None or report.signed_volume == pytest.approx(volume)
    complexes = pytest.importorskip("topologicpy.CellComplex").CellComplex
    parts = coface.from_topologic(complexes.Prism(uSides=2, vSides=1, wSides=2))
    assert [coface.boolean("union", part).measure for part in parts.values()] == pytest.approx([0.25] * 4)


def test_walls_of_ifcopenshell_stand_where_they_do() -> None:
    api = pytest.importorskip("ifcopenshell.api")
    geom = pytest.importorskip("ifcopenshell.geom")
    for part in ("root", "unit", "context", "project", "geometry"):
        pytest.importorskip(f"ifcopenshell.api.{part}")
    file = api.project.create_file()
    api.root.create_entity(file, ifc_class="IfcProject", name="house")
    api.unit.assign_unit(file, length={"is_metric": True, "raw": "METERS"})
    whole = api.context.add_context(file, context_type="Model")
    body = api.context.add_context(file, context_type="Model", context_identifier="Body", target_view="MODEL_VIEW", parent=whole)
    walls = []
    for number in range(2):
        wall = api.root.create_entity(file, ifc_class="IfcWall", name=f"wall {number}")
        shape = api.geometry.add_wall_representation(file, context=body, length=5, height=3, thickness=0.2)
        api.geometry.assign_representation(file, product=wall, representation=shape)
        place = np.eye(4)
        place[:2, 3] = 10 * number, 3
        api.geometry.edit_object_placement(file, product=wall, matrix=place)
        walls.append(wall)
    settings = geom.settings()
    models = coface.from_ifcopenshell([geom.create_shape(settings, wall) for wall in walls])
    assert list(models) == ["wall 0", "wall 1"]
    assert [model.report().signed_volume for model in models.values()] == pytest.approx([3.0, 3.0])
    assert models["wall 1"].vertices.min(axis=0) == pytest.approx([10.0, 3.0, 0.0])
    iterated = coface.from_ifcopenshell(geom.iterator(settings, file, 1))
    assert {name: len(model) for name, model in iterated.items()} == {"wall 0": 12, "wall 1": 12}


def test_solids_become_their_boundary_in_trimesh() -> None:
    pytest.importorskip("trimesh")
    # A box of tetrahedra, some of them mirrored.
    box = coface.generate("box")
    assert set(box.cells) == {"tetra"}
    mixed = np.asarray(box.cells["tetra"]).copy()
    mixed[::2] = mixed[::2, [1, 0, 2, 3]]
    volume = abs(np.linalg.det(np.asarray(box.vertices)[mixed[:, 1:]] - np.asarray(box.vertices)[mixed[:, :1]])).sum() / 6
    for solid in (box, coface.Model.from_arrays(box.vertices, cells={"tetra": mixed})):
        mesh = coface.to_trimesh(solid)
        assert mesh.is_watertight and mesh.is_winding_consistent
        assert mesh.volume == pytest.approx(volume)
        assert np.array_equal(mesh.vertices, box.vertices)
    both = coface.Model.from_arrays(box.vertices, [[0, 1, 2]], {"tetra": mixed})
    with pytest.warns(coface.AssumptionWarning, match="left out of the mesh: the 3-cells"):
        assert len(coface.to_trimesh(both).faces) == 1


def test_faces_of_trimesh_are_arrays() -> None:
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.creation.box()
    assert coface.homology(mesh.faces).betti_numbers == (1, 0, 1)
    assert coface.as_model((mesh.vertices, mesh.faces)).f_vector == (8, 18, 12)


def test_loops_of_graphs_are_walks_along_their_nodes() -> None:
    networkx = pytest.importorskip("networkx")
    graph = networkx.cycle_graph(["a", "b", "c", "d"])
    (generator,) = coface.homology(graph, generators=True)[1].generators
    walk = generator.loop.tolist()
    assert walk[0] == walk[-1] and sorted(walk[1:]) == [0, 1, 2, 3]
    parallel = networkx.MultiGraph([(0, 1), (0, 1)])
    assert coface.homology(parallel, generators=True)[1].generators[0].loop.tolist() in ([0, 1, 0], [1, 0, 1])
    chains = coface.as_chain_complex(parallel)
    again = coface.ChainComplex.from_dict(chains.to_dict())
    assert again.homology(generators=True)[1].generators[0].simplices.tolist() == [[0, 1], [0, 1]]


def test_other_classes_of_gudhi_are_named_with_what_helps() -> None:
    gudhi = pytest.importorskip("gudhi")
    image = gudhi.CubicalComplex(top_dimensional_cells=[[1.0, 2.0]])
    with pytest.raises(coface.InvalidInputError, match=r"ask coface.cubical\(x\)"):
        coface.persistence(image)
    with pytest.raises(coface.InvalidInputError, match=r"call its create_simplex_tree\(\)"):
        coface.persistence(gudhi.RipsComplex(points=[[0.0], [1.0]]))
